"""Which sounds the game can make: kinds, and for bricks a step of the scale and the layers left. No waveform, no array."""

from typing import NamedTuple

from game.sound.patches import Patch

STEPS = 13
"""Pitches a row of bricks climbs through; the last one stays."""
MOST_LAYERS = 3
"""From this many layers left on, stacks sound alike."""


class Note(NamedTuple):
    """One sound.

    patch: its kind.
    step: of the scale, 0 to STEPS - 1, for a brick; else 0.
    layers: left after the hit, 0 to MOST_LAYERS, for a brick; else 0.
    """

    patch: Patch
    step: int = 0
    layers: int = 0


def every_note() -> tuple[Note, ...]:
    """All sounds the game can make."""
    bricks = [Note(Patch.BRICK, step, layers) for layers in range(MOST_LAYERS + 1) for step in range(STEPS)]
    return (*[Note(patch) for patch in Patch if patch is not Patch.BRICK], *bricks)


def brick(combo: int, layers: int) -> Note:
    """The sound of a brick hit. combo: bricks in a row, this one included. layers: left after the hit."""
    return Note(Patch.BRICK, min(max(combo - 1, 0), STEPS - 1), min(max(layers, 0), MOST_LAYERS))
