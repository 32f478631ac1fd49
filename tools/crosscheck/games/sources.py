"""Where trajectories come from: recorded games, games that somebody plays, arenas drawn at random, and aimed contacts."""

import shlex
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import physics
from game.levels import Level, chosen
from game.replays.file import load, played
from game.rules import SOURCE_RULES, TICK, Difficulty, Phase, Ruleset, Ticked, new_game, tick
from physics import Arena, Step
from tools.crosscheck.games.aimed import aimed_ticks
from tools.crosscheck.games.arcade import arcade_ticks
from tools.crosscheck.games.level_numbers import LevelNumbers, numbers_of_level
from tools.crosscheck.games.players import player
from tools.crosscheck.games.random_arena import random_ticks
from tools.crosscheck.games.trajectory import Tick

RANDOM = "random"
"""As a level: arenas drawn from the seed, wilder than any level of the game."""
AIMED = "aimed"
"""As a level: one ball or several, aimed at every kind of contact in turn."""
AUTOPILOT = "autopilot"
PLAYERS = (AUTOPILOT, "mouse", "keys")
DIFFICULTIES = ("easy", "normal", "hard")


class Source(NamedTuple):
    """One game to check. Small enough to hand to another process.

    replay: a file, or None. level: a number, name or TOML file, RANDOM or AIMED. ticks: the longest game. player: of PLAYERS.
    arcade: the difficulty of a game under the arcade rules, of DIFFICULTIES; None for the source's rules.
    """

    replay: str | None
    level: str
    seed: int
    ticks: int
    player: str = AUTOPILOT
    arcade: str | None = None

    @property
    def name(self) -> str:
        """What to call it."""
        if self.replay is not None:
            return self.replay
        by = "" if self.player == AUTOPILOT else f", {self.player}"
        rules = "" if self.arcade is None else f", arcade {self.arcade}"
        return f"level {self.level}, seed {self.seed}{by}{rules}"

    def options(self) -> str:
        """The options of the command that checks this game alone."""
        if self.replay is not None:
            return shlex.quote(self.replay)
        by = "" if self.player == AUTOPILOT else f" --player {self.player}"
        by += "" if self.arcade is None else f" --arcade {self.arcade}"
        return f"--level {shlex.quote(self.level)} --seed {self.seed} --games 1 --ticks {self.ticks}{by}"

    def checked(self) -> "Source":
        """Itself; BadInputError, in one line, where the file or the level cannot be used."""
        if self.replay is not None:
            load(Path(self.replay))
        elif self.level not in {RANDOM, AIMED}:
            chosen(self.level)
        return self


def ticks_of(source: Source) -> Iterator[Tick]:
    """The ticks of a game, by the physics as it is now: `sabotage` may have changed it."""
    if source.replay is None and source.level == RANDOM:
        return random_ticks(source.seed, source.ticks, _physics)
    if source.replay is None and source.level == AIMED:
        return aimed_ticks(source.seed, source.ticks, _physics)
    return _as_ticks(_replayed(source.replay) if source.replay is not None else _played(source))


def _physics(arena: Arena, dt: float, speed: float) -> Step:
    """`physics.advance` as it is at this moment."""
    return physics.advance(arena, dt, speed)


def _replayed(path: str) -> Iterator[Ticked]:
    return played(load(Path(path)))


def _played(source: Source) -> Iterator[Ticked]:
    """A game played until it is won, over, or long enough."""
    ruleset = SOURCE_RULES if source.arcade is None else Ruleset(Difficulty[source.arcade.upper()])
    current, hands = new_game(chosen(source.level), source.seed, ruleset), player(source.player, source.seed)
    for _ in range(source.ticks):
        if current.phase in {Phase.WON, Phase.OVER}:
            return
        done = tick(current, hands.controls(current))
        current = done.game
        yield done


def _as_ticks(game_ticks: Iterator[Ticked]) -> Iterator[Tick]:
    """A game's ticks; before a serve the ball rests on its paddle, and the physics knows of none."""
    first = next(game_ticks, None)
    if first is None:
        return iter(())
    whole = chain([first], game_ticks)
    return arcade_ticks(whole, TICK) if first.game.ruleset.arcade else _source_ticks(whole)


def _source_ticks(game_ticks: Iterator[Ticked]) -> Iterator[Tick]:
    """The ticks of a game under the source's rules."""
    level: Level | None = None  # that the tick was played on: the next one begins with the tick after it
    numbers: LevelNumbers | None = None
    for number, done in enumerate(game_ticks):
        if level is None:
            level = done.game.levels[0]
        if numbers is None:
            numbers = numbers_of_level(level)
        moving, step = done.moving, done.step
        if len(step.arena.balls) != len(moving.balls):
            moving = moving._replace(balls=())
        yield Tick(number, moving, TICK, step, numbers)
        if done.game.level is not level:
            level, numbers = done.game.level, None
