"""What commands do to a session; and those for steps: more or less of the picture, and then to run it or to turn the page."""

from collections.abc import Callable
from enum import Enum
from typing import NamedTuple

from game.lab.kit.picture import Picture
from game.lab.session import session as sessions
from game.lab.session.commands import Command
from game.lab.session.reveal import Reveal, begun, next_step, previous_step, whole
from game.lab.session.session import Session

SESSION_CHANGES: dict[Command, Callable[[Session], Session]] = {
    Command.FORWARD: lambda session: sessions.moved(session, 1),
    Command.BACK: lambda session: sessions.moved(session, -1),
    Command.RESTART: sessions.restarted,
    Command.SLOWER: lambda session: sessions.paced(session, -1),
    Command.FASTER: lambda session: sessions.paced(session, 1),
    Command.DEFAULTS: sessions.reset,
}
"""Commands that only change the session."""
STEPS = frozenset(
    {Command.PLAY, Command.REVEAL, Command.UNDO_STEP, Command.PREDICT, Command.PAGE_DOWN, Command.PAGE_UP},
)
"""Commands that show more or less of the picture."""


class Following(Enum):
    """What a key for steps asks for besides: nothing, to run or pause, the next scene, or the one before."""

    NOTHING = 0
    PLAY = 1
    NEXT = 2
    PREVIOUS = 3


class Stepped(NamedTuple):
    """How much is shown after a key, and what else it asks for."""

    reveal: Reveal
    following: Following = Following.NOTHING


def stepped_by(command: Command, reveal: Reveal, picture: Picture, *, runs: bool) -> Stepped:
    """What one of STEPS does. runs: whether the scene can run."""
    if command is Command.PREDICT:
        return Stepped(begun(reveal._replace(predicts=not reveal.predicts)))
    if not picture.steps:
        return Stepped(reveal, _of_whole(command))
    if reveal.seen is None:
        return _from_whole(command, reveal, picture, runs=runs)
    if command is Command.PAGE_UP and reveal.shown(picture) <= 1:
        return Stepped(reveal, Following.PREVIOUS)
    if command in {Command.PLAY, Command.PAGE_DOWN}:
        return Stepped(next_step(reveal, picture))
    return Stepped(whole(reveal) if command is Command.REVEAL else previous_step(reveal, picture))


def _from_whole(command: Command, reveal: Reveal, picture: Picture, *, runs: bool) -> Stepped:
    """What a key does where all of a picture in steps is shown."""
    if command is Command.UNDO_STEP:
        return Stepped(previous_step(reveal, picture))
    begins = command is Command.REVEAL or (command is Command.PLAY and not runs)
    return Stepped(begun(reveal)) if begins else Stepped(reveal, _of_whole(command))


def _of_whole(command: Command) -> Following:
    """What a key does where there is no step more."""
    return {
        Command.PLAY: Following.PLAY,
        Command.PAGE_DOWN: Following.NEXT,
        Command.PAGE_UP: Following.PREVIOUS,
    }.get(command, Following.NOTHING)
