"""The physics that a game can be flown on: the engine's swept one, and the slides' own algorithm."""

from typing import NamedTuple

import physics
from game.language import tr_noop
from game.rules import Advance
from physics import source_mode


class ChosenPhysics(NamedTuple):
    """A physics for `game.rules.tick`.

    advance: its step. note: a line that is on the screen during play; empty where the game is as it is meant to be.
    """

    advance: Advance
    note: str = ""


SWEPT = ChosenPhysics(physics.advance)
SOURCE = ChosenPhysics(
    source_mode.advance, tr_noop("The slides' own algorithm: one test a frame, errors included (--physics source)")
)
