"""Where trajectories come from: recorded games, games the autopilot plays, and arenas drawn at random."""

import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import game.rules
from game.autopilot import Autopilot
from game.levels import chosen
from game.replays.file import load, played
from game.rules import Phase, Ticked, new_game, tick
from physics import advance
from tools.crosscheck.games.random_arena import random_ticks
from tools.crosscheck.games.trajectory import Advance, Tick

RANDOM = "random"
"""As a level: arenas drawn from the seed, wilder than any level of the game."""


class Source(NamedTuple):
    """One game to check: a replay file, or a level with a seed. Small enough to hand to another process."""

    replay: str | None
    level: str
    seed: int
    ticks: int

    @property
    def name(self) -> str:
        """What to call it."""
        return self.replay if self.replay is not None else f"level {self.level}, seed {self.seed}"

    def options(self) -> str:
        """The options of the command that checks this game alone."""
        if self.replay is not None:
            return shlex.quote(self.replay)
        return f"--level {shlex.quote(self.level)} --seed {self.seed} --games 1 --ticks {self.ticks}"

    def checked(self) -> "Source":
        """Itself; BadInputError, in one line, where the file or the level cannot be used."""
        if self.replay is not None:
            load(Path(self.replay))
        elif self.level != RANDOM:
            chosen(self.level)
        return self


def ticks_of(source: Source, physics: Advance = advance) -> Iterator[Tick]:
    """The ticks of a game. physics: what advances the arena; a sabotaged one shows that the harness notices."""
    if source.replay is None and source.level == RANDOM:
        yield from random_ticks(source.seed, source.ticks, physics)
        return
    vars(game.rules)["advance"] = (
        advance if physics is advance else lambda arena, dt, speed, _last=None: physics(arena, dt, speed)
    )
    try:
        done = _replayed(source.replay) if source.replay is not None else _autopiloted(source)
        for number, ticked in enumerate(done):
            yield _as_tick(number, ticked)
    finally:
        vars(game.rules)["advance"] = advance


def _replayed(path: str) -> Iterator[Ticked]:
    yield from played(load(Path(path)))


def _autopiloted(source: Source) -> Iterator[Ticked]:
    """A game played by the autopilot until it is won, over, or long enough."""
    current, pilot = new_game(chosen(source.level), source.seed), Autopilot()
    for _ in range(source.ticks):
        if current.phase in {Phase.WON, Phase.OVER}:
            return
        done = tick(current, pilot.controls(current))
        current = done.game
        yield done


def _as_tick(number: int, done: Ticked) -> Tick:
    """A game's tick; before a serve the ball rests on its paddle, and the physics knows of none."""
    moving, step = done.moving, done.step
    if len(step.arena.balls) != len(moving.balls):
        moving = moving._replace(balls=())
    return Tick(number, moving, game.rules.TICK, done.game.level.ball.speed, step)
