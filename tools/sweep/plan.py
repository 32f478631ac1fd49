"""Which games a sweep plays: a grid of all combinations, or points drawn at random between the ends of its axes."""

import hashlib
import itertools
import random
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import msgspec

from game.levels import Level, checked
from game.rules import Ruleset
from game.system.errors import BadInputError


class SweepJob(NamedTuple):
    """One game to play.

    level: as it is played, its numbers changed. player: "autopilot", or a simulated human as MS/DEG. top_speed, ball_speed:
    factors of the paddles' and the ball's speed in the level's file. friction: of the paddles. ticks: of the longest game.
    """

    level: Level
    player: str
    seed: int
    top_speed: float
    friction: float
    ball_speed: float
    ruleset: Ruleset
    ticks: int


class Axes(NamedTuple):
    """What a sweep varies. frictions: empty for each level's own."""

    levels: Sequence[Level]
    players: Sequence[str]
    top_speeds: Sequence[float]
    frictions: Sequence[float]
    ball_speeds: Sequence[float]


class Plan(NamedTuple):
    """The games of a sweep in their order, and what makes some points impossible."""

    jobs: tuple[SweepJob, ...]
    left_out: tuple[str, ...]

    def key(self) -> str:
        """A hash of all games: two sweeps with the same key are the same."""
        digest = hashlib.sha256()
        for job in self.jobs:
            digest.update(repr(job._replace(level=job.level.content_hash())).encode())  # type: ignore[arg-type]
        return digest.hexdigest()


def grid(axes: Axes, seeds: int, ruleset: Ruleset, ticks: int) -> Plan:
    """Every combination, with seeds from 0 to below `seeds`."""
    points = itertools.product(
        axes.levels, axes.players, axes.top_speeds, axes.frictions or (None,), axes.ball_speeds, range(seeds)
    )
    return _plan(points, ruleset, ticks)


def sample(axes: Axes, count: int, seed: int, ruleset: Ruleset, ticks: int) -> Plan:
    """So many points: levels and players in turn, the numbers drawn between the least and the greatest of their axis."""
    chance = random.Random(seed)

    def between(values: Sequence[float]) -> float:
        return min(values) + (max(values) - min(values)) * chance.random()

    def points() -> Iterator[tuple[Level, str, float, float | None, float, int]]:
        pairs = itertools.cycle(itertools.product(axes.levels, axes.players))
        for number, (level, player) in enumerate(itertools.islice(pairs, count)):
            friction = between(axes.frictions) if axes.frictions else None
            yield level, player, between(axes.top_speeds), friction, between(axes.ball_speeds), number

    return _plan(points(), ruleset, ticks)


def _plan(points: Iterator[tuple[Level, str, float, float | None, float, int]], ruleset: Ruleset, ticks: int) -> Plan:
    """The games at these points; those whose level could not be played are left out."""
    jobs, left_out = [], []
    for level, player, top_speed, friction, ball_speed, seed in points:
        friction = level.paddles.friction if friction is None else friction  # noqa: PLW2901  # the level's own
        try:
            played = _varied(level, top_speed, friction, ball_speed)
        except BadInputError as error:
            left_out.append(str(error))
            continue
        jobs.append(SweepJob(played, player, seed, top_speed, friction, ball_speed, ruleset, ticks))
    return Plan(tuple(jobs), tuple(dict.fromkeys(left_out)))


def _varied(level: Level, top_speed: float, friction: float, ball_speed: float) -> Level:
    """The level with other paddles and another ball; BadInputError where it cannot be played."""
    replace = msgspec.structs.replace
    ball = replace(level.ball, speed=level.ball.speed * ball_speed)
    if ball.top_speed is not None:
        ball = replace(ball, top_speed=ball.top_speed * ball_speed)
    paddles = replace(level.paddles, top_speed=level.paddles.top_speed * top_speed, friction=friction)
    where = f"{level.name!r} with top speed x {top_speed:g}, ball speed x {ball_speed:g}, friction {friction:g}"
    return checked(replace(level, ball=ball, paddles=paddles), where)
