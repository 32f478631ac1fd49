"""Which points of the air are hidden from the eye by what stands in the arena.

From a point the line of sight is followed upwards until it is above everything; whether a place on it lies within a brick is
the arena's own arithmetic: its radius says in which ring, its angle in which slot.
"""

import math
from typing import NamedTuple

import numpy as np

from game.blocks import Flags, Reals
from game.camera import Camera, Points
from game.scene import Scene
from game.slabs import LAYER
from physics import PERMANENT, Ring

_STEPS = 12
"""Places looked at on each line of sight."""
_PERMANENT_LAYERS = 1.0
"""Height of what never breaks, or a little more."""


class _Wall(NamedTuple):
    """A ring and how high it is, world units."""

    ring: Ring
    heights: Reals  # per slot


def covered(points: Points, heights: Reals, scene: Scene, camera: Camera) -> Flags:
    """Whether each point, at its height, world units, is behind something for a tipped camera."""
    walls = _walls(scene)
    tallest = max([float(wall.heights.max()) for wall in walls], default=0.0)
    sine, cosine = math.sin(camera.tilt), math.cos(camera.tilt)
    # Towards the eye, per unit of height: from q at z it is at (-i sin t - k q) / (cos t - k z), turned to the screen.
    lean = (-1j * sine / camera.turning - camera.closeness * points) / (cosine - camera.closeness * heights)
    rise = np.maximum(tallest - heights, 0.0) * np.linspace(0.0, 1.0, _STEPS, endpoint=False)[:, None]
    seen = (points + lean * rise).ravel()
    level = (heights + rise).ravel()
    radius = np.abs(seen)
    hidden = np.zeros(len(seen), dtype=bool)
    for ring, high in walls:
        near = np.flatnonzero(np.abs(radius - ring.radius) < ring.half_width)
        if len(near):
            pitch = math.tau / ring.count
            turns = (np.angle(seen[near]) - ring.phase) / pitch
            slot = np.rint(turns)
            within = np.abs(turns - slot) * pitch < ring.half_angle
            hidden[near] |= within & (high[slot.astype(np.int64) % ring.count] > level[near])
    return np.asarray(hidden.reshape(_STEPS, len(points)).any(axis=0))


def _walls(scene: Scene) -> list[_Wall]:
    """The rings in which anything stands."""
    layer = LAYER * scene.ground_radius
    found = []
    for ring, layers in zip(scene.rings, scene.layers, strict=True):
        if any(layers):
            heights = [_PERMANENT_LAYERS if count == PERMANENT else float(count) for count in layers]
            found.append(_Wall(ring, np.array(heights) * layer))
    return found
