"""Compares games that the compiled autopilot plays with the same games of the game's own: controls and state, every tick."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from game.autopilot.source_pilot import SourcePilot
from game.rules import Controls, Game, Ticked, tick
from tools.environments.many import EnvironmentOptions, ManyEnvironments, base_seed

DECIDING = slice(Game._fields.index("seed"), Game._fields.index("flight"))
"""The fields of `Game` that decide how it goes on under the source's rules."""


class ComparedTick(NamedTuple):
    """A tick in which both were equal.

    before: the game. controls: of the game's autopilot. done: the tick, by the rules.
    """

    before: Game
    controls: Controls
    done: Ticked


def played_environments(level: str, seed: int, count: int) -> ManyEnvironments:
    """So many environments of a level that the autopilot plays, at their first episode; a step is one tick."""
    many, every = (
        ManyEnvironments(count, EnvironmentOptions(level, "state", "autopilot", 1), resets=True),
        np.ones(count, np.bool_),
    )
    many.seed([base_seed(seed, index) for index in range(count)], every)
    many.begin(every)
    return many


def compared_ticks(many: ManyEnvironments, games: Sequence[Game], steps: int) -> Iterator[ComparedTick]:
    """Some steps of environments, of which every tick of every game is compared with `game.rules` and `SourcePilot`.

    games: the environments' games as they stand, which no autopilot has seen. A new episode is taken over as it begins.
    Raises AssertionError, naming what differs.
    """
    now, pilots, nothing = [*games], [SourcePilot() for _ in games], np.zeros(len(many), np.int64)
    for _ in range(steps):
        begins = many.episodes["ended"] != 0
        many.step(nothing)
        for index, before in enumerate(now):
            mine = many.game(index)
            if begins[index]:
                now[index], pilots[index] = mine, SourcePilot()
                continue
            controls = pilots[index].controls(before)
            done = tick(before, controls)
            now[index] = done.game
            pointer = int(many.episodes["pointer"][index])
            if controls.pointer != (None if pointer < 0 else pointer):
                raise AssertionError(f"{_where(before)}: pointer {pointer}, not {controls.pointer}")
            if mine[DECIDING] != done.game[DECIDING]:
                raise AssertionError(f"{_where(before)}: {mine[DECIDING]}, not {done.game[DECIDING]}")
            yield ComparedTick(before, controls, done)


def _where(game: Game) -> str:
    """Which game, and when."""
    return f"level {game.level.name!r}, seed {game.seed}, tick {game.tick}"
