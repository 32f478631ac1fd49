"""The physics that a game can be flown on: the engine's swept one, the slides' own algorithm, a player's own functions."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple, Protocol

import physics
from game.language import tr_noop
from game.rules import Advance
from game.student.functions_file import FunctionsFile
from game.student.own_physics import OwnPhysics
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
    source_mode.advance, tr_noop("The slides' own algorithm: one test a frame, errors included (--physics source)")
)
NAMED: dict[str, ChosenPhysics] = {"swept": SWEPT, "source": SOURCE}
"""Those that `--physics` takes."""


@contextmanager
def functions_of(path: Path | None, *, checked: bool = False) -> Iterator[FunctionsFile | None]:
    """A player's file of functions, ended afterwards; None for no path. Errors are those of `FunctionsFile`.

    checked: whether CheckFailedError is raised in the end where anything has been wrong with the file.
    """
    if path is None:
        yield None
        return
    with FunctionsFile(path) as file:
        yield file
        if checked:
            file.check()


def flown_on(name: str, functions: FunctionsFile | None) -> ChosenPhysics:
    """The physics of a player's functions, or without them the one of a name."""
    return NAMED[name] if functions is None else OwnPhysics(functions)
