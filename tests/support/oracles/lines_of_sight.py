"""What a line of sight or of light meets, found by marching along it: no order, no projection, no polygons."""

import math

import numpy as np

from game.drawing.light import LIGHT, SHADOW_SLANT
from game.picture.slots.contents import resting_contents
from game.picture.slots.parts import LAYER_HEIGHT, height

HIGHEST = 0.45 * 8
"""World units: as high as the highest stack."""
STEP = 7.5e-5
"""Of a line of sight, as a part of its length: how finely it is marched along."""


def first_met(scene, eye, ray, reach):
    """What a line of sight meets first: a ring's number, "ball", or None for the ground."""
    steps = np.arange(*reach, STEP * reach[1])
    x, y, z = (eye[k] + ray[k] * steps for k in range(3))
    radius, angle = np.hypot(x, y), np.arctan2(y, x)
    best, found, standing = math.inf, None, standing_heights(scene)
    for k, ring in enumerate(scene.rings):
        near = np.flatnonzero(np.abs(radius - ring.radius) < ring.half_width)
        slot, off = slots_at(ring, angle[near])
        top = standing[k][slot]
        inside = near[(np.abs(off) < ring.half_angle) & (z[near] < top) & (top > 0.0)]
        if len(inside) and steps[inside[0]] < best:
            best, found = steps[inside[0]], k
    for ball in scene.balls:
        inside = np.sqrt((x - ball.position.real) ** 2 + (y - ball.position.imag) ** 2 + (z - ball.radius) ** 2) < ball.radius
        if inside.any() and steps[inside.argmax()] < best:
            best, found = steps[inside.argmax()], "ball"
    return found


def slots_at(ring, angle):
    """The nearest slots to some angles, and how far from their middles these are."""
    pitch = math.tau / ring.count
    slot = np.rint((angle - ring.phase) / pitch).astype(int) % ring.count
    return slot, (angle - ring.phase - slot * pitch + math.pi) % math.tau - math.pi


def standing_heights(scene):
    """Heights of what stands in the slots of each ring, world units."""
    unit = LAYER_HEIGHT * scene.ground_radius
    return [np.array([height(content) * unit for content in ring]) for ring in resting_contents(scene.layers)]


def sight(camera, pixel):
    """The line of sight through a pixel: the eye, its unit direction, and the part of it low enough for things to be there."""
    ground = camera.unproject(pixel)
    bearing = camera.azimuth - math.pi / 2.0
    towards = np.array(
        [math.cos(bearing) * math.sin(camera.tilt), math.sin(bearing) * math.sin(camera.tilt), math.cos(camera.tilt)]
    )
    eye = towards / camera.closeness
    ray = np.array([ground.real, ground.imag, 0.0]) - eye
    length = float(np.linalg.norm(ray))
    return eye, ray / length, ((1.0 - HIGHEST / eye[2]) * length, length)


def in_shadow(scene, spot, tilt):
    """Whether something is between a point of the ground and the light."""
    standing = standing_heights(scene)
    z, lifted = np.linspace(0.0, 3.0, 3000), {(drop.ring, drop.slot): 0.45 * drop.height for drop in scene.falling}
    ray = spot + LIGHT * SHADOW_SLANT * math.sin(tilt) * z
    radius, angle = np.abs(ray), np.angle(ray)
    for k, ring in enumerate(scene.rings):
        near = np.flatnonzero(np.abs(radius - ring.radius) < ring.half_width)
        slot, off = slots_at(ring, angle[near])
        top = standing[k][slot]
        foot = np.array([lifted.get((k, number), 0.0) for number in range(ring.count)])[slot]
        if ((np.abs(off) < ring.half_angle) & (z[near] > foot) & (z[near] < foot + top)).any():
            return True
    return False
