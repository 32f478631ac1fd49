"""One game of a sweep, and what is written down of it."""

from typing import NamedTuple, Protocol

from game.autopilot import Autopilot
from game.rules import TICK, Controls, EventKind, Game, Phase, new_game, tick
from tools.balance.human import Human
from tools.balance.players import parsed_skills
from tools.sweep.plan import SweepJob


class SweepPlayer(Protocol):
    """Whoever sees the game and answers with controls."""

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""


class Row(NamedTuple):
    """One game.

    level to ball_speed: as in `SweepJob`, the level by its name. cleared: whether within the lives and the time.
    seconds: played. lost: lives. impacts: bounces off anything. impacts_per_tick: in ticks with a ball in play.
    loops: times that a ball was nudged because it met no brick.
    longest_gap: seconds between two bricks with a ball in play, the longest.
    """

    level: str
    player: str
    seed: int
    top_speed: float
    friction: float
    ball_speed: float
    cleared: bool
    seconds: float
    lost: int
    score: int
    impacts: int
    impacts_per_tick: float
    loops: int
    longest_gap: float


def played(job: SweepJob) -> Row:
    """The row of a game."""
    game, hands = new_game((job.level,), job.seed, job.ruleset), player(job.player, job.seed)
    impacts = in_play = loops = gap = longest = lost = 0
    while game.phase in {Phase.SERVING, Phase.PLAYING} and game.tick < job.ticks:
        in_play += game.phase == Phase.PLAYING
        before = game.lives
        done = tick(game, hands.controls(game))
        game = done.game
        kinds = [event.kind for event in done.events]
        impacts += len(done.step.hits)
        loops += kinds.count(EventKind.NUDGED)
        lost += max(before - game.lives, 0)
        gap = 0 if EventKind.BRICK_HIT in kinds or game.phase != Phase.PLAYING else gap + 1
        longest = max(longest, gap)
    return Row(
        job.level.name,
        job.player,
        job.seed,
        job.top_speed,
        job.friction,
        job.ball_speed,
        game.phase == Phase.WON,
        game.tick * TICK,
        lost,
        game.score,
        impacts,
        impacts / max(in_play, 1),
        loops,
        longest * TICK,
    )


def player(name: str, seed: int) -> SweepPlayer:
    """The player of a name."""
    skill = parsed_skills(name)[0]
    return Autopilot() if skill is None else Human(skill, seed)
