"""The physics that a game can be flown on: the engine's swept one, the slides' own algorithm, a player's own functions."""

from typing import NamedTuple, Protocol

import physics
from game.rules import Advance
from physics import source_mode


class ChosenPhysics(Protocol):
    """A physics for `game.rules.tick`."""

    @property
    def advance(self) -> Advance:
        """Its step."""

    @property
    def note(self) -> str:
        """A line that is on the screen during play; empty where the game is as it is meant to be."""

    def news(self) -> str:
        """What has happened to it since the last call, in a few words to be shown for a moment; empty for nothing."""


class _FixedPhysics(NamedTuple):
    """A physics to which nothing ever happens."""

    advance: Advance
    note: str = ""

    def news(self) -> str:
        """Nothing."""
        return ""


SWEPT: ChosenPhysics = _FixedPhysics(physics.advance)
SOURCE: ChosenPhysics = _FixedPhysics(
    source_mode.advance, "The slides' own algorithm: one test a frame, errors included (--physics source)"
)
