"""Which points of the air are hidden from the eye by what stands in the arena.

From a point the line of sight is followed upwards until it is above everything. Whether a position on it lies within a brick
is the arena's own arithmetic: its radius says in which ring, its angle in which slot.
"""

import math
from functools import lru_cache

import numpy as np

from game.drawing.camera import Camera
from game.drawing.raster.arrays import Points, Reals
from game.drawing.solid.blocks import Flags
from game.picture.slots.contents import resting_contents
from game.picture.slots.parts import LAYER_HEIGHT, height
from game.scene import Scene

_STEPS = 12
"""Positions looked at on each line of sight."""


def occluded(points: Points, heights: Reals, scene: Scene, camera: Camera) -> Flags:
    """Whether each point, at its height, world units, is behind something for a tipped camera."""
    walls = LAYER_HEIGHT * scene.ground_radius * _layers(scene.layers)
    sine, cosine = math.sin(camera.tilt), math.cos(camera.tilt)
    # Towards the eye, per unit of height: from q at z it is at (-i sin t - k q) / (cos t - k z), turned to the screen.
    lean = (-1j * sine / camera.turning - camera.closeness * points) / (cosine - camera.closeness * heights)
    rise = np.maximum(walls.max() - heights, 0.0) * np.linspace(0.0, 1.0, _STEPS, endpoint=False)[:, None]
    hidden = _within(points + lean * rise, heights + rise, scene, walls)
    return np.asarray(hidden.any(axis=0))


def _within(points: Points, heights: Reals, scene: Scene, walls: Reals) -> Flags:
    """Whether each point is within what stands there. Rings lie one around the other, so that a radius tells the ring.

    walls: heights of all slots, world units, ring after ring.
    """
    order = sorted(range(len(scene.rings)), key=lambda k: scene.rings[k].radius)
    rings = [scene.rings[k] for k in order]
    counts = [ring.count for ring in scene.rings]
    faces = np.array([(ring.inner_radius, ring.outer_radius) for ring in rings]).ravel()
    phase, half_angle, pitch = np.array([(ring.phase, ring.half_angle, math.tau / ring.count) for ring in rings]).T
    count, first = np.array([(counts[k], sum(counts[:k])) for k in order]).T
    faces_passed = np.searchsorted(faces, np.abs(points))
    inside = faces_passed % 2 == 1
    ring = faces_passed[inside] // 2
    turns = (np.angle(points[inside]) - phase[ring]) / pitch[ring]
    slot = np.rint(turns)
    wall = walls[first[ring] + slot.astype(np.int64) % count[ring]]
    inside[inside] = (np.abs(turns - slot) * pitch[ring] < half_angle[ring]) & (wall > heights[inside])
    return np.asarray(inside, dtype=np.bool_)


@lru_cache(maxsize=4)
def _layers(layers: tuple[tuple[int, ...], ...]) -> Reals:
    """Height of what stands in every slot, in layers, ring after ring."""
    return np.array([height(content) for ring in resting_contents(layers) for content in ring])
