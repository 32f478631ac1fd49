"""A game of one level with unlimited lives, by a simulated human or by the autopilot."""

import math
from collections.abc import Iterator
from statistics import mean, median, stdev
from typing import NamedTuple

from game.autopilot import Autopilot
from game.levels import Level
from game.rules import TICK, Controls, EventKind, Game, Phase, Ruleset, Ticked, new_game, tick
from tools.balance.human import Human, Skill

NORMAL_RULES = Ruleset()
_MANY_LIVES = 10**6
_LONGEST = 600.0
"""Seconds after which a level is given up."""
_GIVE_UP = 30.0
"""Seconds without a paddle's touch after which the player gives up a ball."""


class Trial(NamedTuple):
    """The result of a player in a level.

    level: its name. skill: of the human, None for the autopilot. seed: of the game and of the human.
    cleared: whether within the time limit. seconds: of the whole game.
    lost: number of lives lost. given_up: how many of these were balls out of reach that the player gave up.
    longest_gap: longest time between two hit bricks with a ball in play, seconds.
    score: without the bonus for a cleared level, which would count the unlimited lives.
    """

    level: str
    skill: Skill | None
    seed: int
    cleared: bool
    seconds: float
    lost: int
    given_up: int
    longest_gap: float
    score: int


class TrialJob(NamedTuple):
    """A game to be played; `skill` as in `Trial`."""

    level: Level
    skill: Skill | None
    seed: int
    ruleset: Ruleset = NORMAL_RULES


class TrialSummary(NamedTuple):
    """Means over the games of one player in one level; the gap and the score are medians.

    games: how many. cleared: share of them. error: the standard error of `lost`, 0 for a single game. The rest as in `Trial`.
    """

    games: int
    cleared: float
    lost: float
    error: float
    seconds: float
    longest_gap: float
    given_up: float
    score: float


def played(job: TrialJob) -> Trial:
    """The game that a job asks for."""
    return trial(*job)


def summary(trials: list[Trial]) -> TrialSummary:
    """What games have in common. trials: one at least."""
    return TrialSummary(
        len(trials),
        mean([trial.cleared for trial in trials]),
        mean([trial.lost for trial in trials]),
        standard_error([trial.lost for trial in trials]),
        mean([trial.seconds for trial in trials]),
        median([trial.longest_gap for trial in trials]),
        mean([trial.given_up for trial in trials]),
        median([trial.score for trial in trials]),
    )


def standard_error(numbers: list[int]) -> float:
    """The standard error of the mean of numbers; 0 for a single one."""
    return stdev(numbers) / math.sqrt(len(numbers)) if len(numbers) > 1 else 0.0


def trial(level: Level, skill: Skill | None, seed: int, ruleset: Ruleset = NORMAL_RULES) -> Trial:
    """The level played by a simulated human of some skill, or by the autopilot."""
    lost = given_up = gap = longest = bonus = 0
    last: Game | None = None
    for controls, done in _ticks(level, skill, seed, ruleset):
        last = done.game
        given_up += controls.give_up
        bonus += sum([event.points for event in done.events if event.kind == EventKind.LEVEL_CLEARED])
        kinds = [event.kind for event in done.events]
        broken = {EventKind.BRICK_HIT, EventKind.BRICK_CRUMBLED}.intersection(kinds)
        waits = last.phase == Phase.PLAYING and not broken and not last.held
        gap = gap + 1 if waits else 0
        longest = max(longest, gap)
        lost += last.phase == Phase.SERVING and last.phase_tick == 0 and EventKind.BALL_LOST in kinds
    assert last is not None
    cleared = last.phase in {Phase.CLEARED, Phase.WON}
    return Trial(level.name, skill, seed, cleared, last.tick * TICK, lost, given_up, longest * TICK, last.score - bonus)


def _ticks(level: Level, skill: Skill | None, seed: int, ruleset: Ruleset) -> Iterator[tuple[Controls, Ticked]]:
    """The player's controls and what they led to, until the level is cleared or given up."""
    game = new_game((level,), seed, ruleset)._replace(lives=_MANY_LIVES)
    player = Autopilot() if skill is None else Human(skill, seed)
    untouched = 0
    while game.phase in {Phase.SERVING, Phase.PLAYING} and game.tick * TICK < _LONGEST:
        controls = player.controls(game)._replace(give_up=untouched * TICK >= _GIVE_UP)
        done = tick(game, controls)
        touched = any([event.kind == EventKind.PADDLE_HIT for event in done.events])
        untouched = 0 if touched or done.game.phase != Phase.PLAYING else untouched + 1
        game = done.game
        yield controls, done
