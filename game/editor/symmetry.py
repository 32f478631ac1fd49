"""Which slots one stroke of the brush paints: the one under the pointer and its images."""

from typing import NamedTuple

from game.levels import RingSpec

FOLDS = (1, 2, 3, 4, 5, 6, 8, 12)
"""Rotations to choose from."""


class Symmetry(NamedTuple):
    """Images of a stroke.

    fold: it is repeated every 1/fold of a turn.
    mirrored: and at the other side of the picture's vertical middle.
    """

    fold: int = 1
    mirrored: bool = False


def images(ring: RingSpec, slot: int, symmetry: Symmetry) -> frozenset[int]:
    """The slots of a ring that a stroke on one of them paints. An image that falls between two slots takes the nearer one."""
    pitch = 360.0 / ring.count
    angles = [ring.phase + slot * pitch]
    if symmetry.mirrored:
        angles.append(180.0 - angles[0])
    turned = [angle + number * 360.0 / symmetry.fold for angle in angles for number in range(symmetry.fold)]
    return frozenset([round((angle - ring.phase) / pitch) % ring.count for angle in turned])
