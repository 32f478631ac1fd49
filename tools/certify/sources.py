"""Where flights come from: recorded games, games the autopilot plays, and the fuzzer's arenas."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple, overload

from game.autopilot import Autopilot
from game.levels import chosen, classic
from game.replays.file import load, played
from game.rules import TICK, Phase, Ticked, new_game, tick
from game.system.errors import BadInputError
from physics import Arena, Hit, Step, advance, time_of_impact
from tools.certify.flights import ClaimedTick
from tools.fuzz import arenas
from tools.fuzz.impacts import random_impact

GAME_TICKS = 14_400
"""The longest game of the autopilot: a minute."""

BATCH = 500
"""Questions to `time_of_impact` in one source."""

_ARENA, _GAME, _IMPACTS = "arena:", "game:", "impacts:"


class ClaimSource(NamedTuple):
    """One game, arena or batch of questions to `time_of_impact`, by its name on the command line.

    name: a file, game:LEVEL:SEED, arena:SEED:INDEX or impacts:SEED:BATCH.
    """

    name: str

    def checked(self) -> "ClaimSource":
        """Itself; BadInputError, in one line, where there is no such thing."""
        if self.name.startswith((_ARENA, _IMPACTS)):
            self._two_numbers()
        elif self.name.startswith(_GAME):
            level, _, seed = self.name.removeprefix(_GAME).rpartition(":")
            _numbers(self.name, [seed], 1)
            chosen(level)
        else:
            load(Path(self.name))
        return self

    def ticks(self) -> Iterator[ClaimedTick]:
        """Its ticks, played now."""
        if self.name.startswith(_ARENA):
            return _in_arena(*self._two_numbers())
        if self.name.startswith(_IMPACTS):
            return _questions(*self._two_numbers())
        if self.name.startswith(_GAME):
            level, _, seed = self.name.removeprefix(_GAME).rpartition(":")
            return _of_game(_autopiloted(level, *_numbers(self.name, [seed], 1)))
        return _of_game(played(load(Path(self.name))))

    def _two_numbers(self) -> list[int]:
        """The numbers after the kind."""
        return _numbers(self.name, self.name.split(":")[1:], 2)


class SourcePlan(Sequence[ClaimSource]):
    """The sources of a run without files: a game of the autopilot on every level, then arena after arena."""

    def __init__(self, seed: int, arena_count: int) -> None:
        """Take the seed of all of them."""
        self._seed = seed
        self._games = len(classic())
        self._count = self._games + arena_count

    def __len__(self) -> int:
        """How many there are."""
        return self._count

    @overload
    def __getitem__(self, index: int) -> ClaimSource: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[ClaimSource]: ...

    def __getitem__(self, index: int | slice) -> ClaimSource | Sequence[ClaimSource]:
        """The source of a number."""
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(self._count))]
        if not 0 <= index < self._count:
            raise IndexError(index)
        if index < self._games:
            return ClaimSource(f"{_GAME}{classic()[index].name}:{self._seed}")
        return ClaimSource(f"{_ARENA}{self._seed}:{index - self._games}")


def _numbers(name: str, words: list[str], count: int) -> list[int]:
    """Whole numbers of a source's name."""
    if len(words) != count or not all([word.isascii() and word.isdecimal() and len(word) < 19 for word in words]):
        raise BadInputError(f"{name}: expected a file, game:LEVEL:SEED, arena:SEED:INDEX or impacts:SEED:BATCH")
    return [int(word) for word in words]


def _in_arena(seed: int, index: int) -> Iterator[ClaimedTick]:
    """A case of the fuzzer, played as it plays it."""
    arena, speed, chance = arenas.random_case(seed, index)
    for number in range(arenas.TICKS):
        step = advance(arena, arenas.TICK, speed)
        yield ClaimedTick(number, arena, arenas.TICK, speed, step)
        arena = arenas.steered(arenas.with_lost_balls_back(step.arena, speed, chance), speed, chance)


def _questions(seed: int, batch: int) -> Iterator[ClaimedTick]:
    """Flights of one ball beside one ring, a third of them built to graze, each as a tick that ends with its impact."""
    for number in range(BATCH):
        ball, ring, dt, alive = random_impact(seed, batch * BATCH + number)
        arena = Arena((ball,), (ring,), (alive,))
        found = time_of_impact(ball, ring, dt, alive)
        end = Arena((ball.moved(dt),), (ring.turned(dt),), (alive,))
        if found is None:
            step = Step(end, (), 0, 0)
        else:
            hit = Hit(found.time, 0, 0, found.slot, found.contact, ball.velocity, ball.velocity, alive[found.slot])
            step = Step(end, (hit,), 1, 0)  # as if the ball rested from there on: there is no flight after it
        yield ClaimedTick(number, arena, dt, abs(ball.velocity), step)


def _autopiloted(level: str, seed: int) -> Iterator[Ticked]:
    """A game played by the autopilot until it is won, over, or long enough."""
    current, pilot = new_game(chosen(level), seed), Autopilot()
    for _ in range(GAME_TICKS):
        if current.phase in {Phase.WON, Phase.OVER}:
            return
        done = tick(current, pilot.controls(current))
        current = done.game
        yield done


def _of_game(game: Iterator[Ticked]) -> Iterator[ClaimedTick]:
    """A game's ticks. Before a serve the ball rests on its paddle, and the physics knows of none."""
    for number, done in enumerate(game):
        moving = done.moving
        if len(done.step.arena.balls) != len(moving.balls):
            moving = moving._replace(balls=())
        yield ClaimedTick(number, moving, TICK, done.speed, done.step)
