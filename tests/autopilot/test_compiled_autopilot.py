"""The compiled autopilot plays as the game's own: controls and every bit of the state are compared after every tick."""

import re

import numpy as np
import pytest

from game.autopilot.source_pilot import SourcePilot
from game.levels import chosen
from game.replays.file import load
from game.replays.state_hash import state_hash
from game.replays.verify import verified
from game.rules import PADDLES, SOURCE_RULES, TICK, Phase, new_game, tick
from physics import PERMANENT, Arena, Ball
from physics.batch import Batch
from tests.support.paths import ROOT
from tools.autopilot import BatchAutopilot
from tools.autopilot.comparison import compared_ticks, played_environments
from tools.environments import PolarBreakoutVectorEnv

pytestmark = pytest.mark.deep

COUNT = 3
LEVELS = ["Sunrise", "Three Rings", "The Vault", "The Keep"]


class Seen:
    """Counts of what a comparison went through, so that it can be shown to go through everything."""

    def __init__(self):
        self.served = self.lost = self.nudged = self.over = self.nowhere = self.cut = self.stacks = self.permanent = 0

    def add(self, before, controls, done):
        """Count what one tick did."""
        after = done.game
        self.served += controls.serve and after.phase == Phase.PLAYING
        self.lost += after.lives < before.lives
        self.over += after.phase == Phase.OVER
        self.nudged += after.draws > before.draws
        self.nowhere += before.phase == Phase.PLAYING and controls.pointer is None
        self.stacks += sum(hit.layers > 0 for hit in done.step.hits)
        self.permanent += sum(hit.layers == PERMANENT and hit.ring > PADDLES for hit in done.step.hits)


def meddle(many):
    """Leave one game one contact before a nudge; let one lose a ball, and one its last ball, in a moment."""
    edge, speed = many.level.ground_radius, many.level.ball.speed
    many._episodes["idle"], many._episodes["lives"] = (11, 11, 0), (3, 2, 1)
    many._episodes["phase"] = Phase.PLAYING
    many._games.positions[1:COUNT, 0], many._games.velocities[1:COUNT, 0] = edge - 0.1 * many.level.ball.radius, speed
    many._games.known[:COUNT], many._games.free[:COUNT] = 0, 0
    many._plans["state"] = 0
    return [many.game(index) for index in range(COUNT)]


def test_whole_games_are_those_of_the_games_autopilot():
    """Serves, lost balls, nudges, games that end, stacks, unbreakable bricks, balls that do not come for a while."""
    seen = Seen()
    for seed, level in enumerate(LEVELS):
        many = played_environments(level, seed, COUNT)
        games = [new_game((many.level,), many.game(index).seed, SOURCE_RULES) for index in range(COUNT)]
        for steps in (600, 450):
            for compared in compared_ticks(many, games, steps):
                seen.add(*compared)
                seen.cut += int((many._plans["spin"] != 0.0).any())
            games = meddle(many)
    assert min(vars(seen).values()) >= 2, vars(seen)


def test_a_difference_is_named():
    """A game with another ball than the environment's: the level, the seed and the tick."""
    many = played_environments("Sunrise", 1, COUNT)
    games = [many.game(index)._replace(combo=1) for index in range(COUNT)]
    with pytest.raises(AssertionError, match=f"level 'Sunrise', seed {games[0].seed}, tick 0: "):
        list(compared_ticks(many, games, 1))


def test_a_game_of_the_autopilot_is_recorded(tmp_path):
    """Also where a step is many ticks: a replay that verifies, and ends as the environment stands."""
    env = PolarBreakoutVectorEnv(2, level="Three Rings", actions="autopilot", frame_skip=240, recorded=[1])
    env.reset(seed=5)
    for _ in range(6):
        env.step(env.action_space.sample())
    env.record(1, tmp_path / "game.polar")
    played = verified(load(tmp_path / "game.polar"))
    assert played.divergence is None
    assert state_hash(played.game) == state_hash(env.game(1))
    assert played.game.tick == 6 * 240


@pytest.mark.parametrize(
    ("options", "named"),
    [
        ({"repeat_action_probability": 0.1}, "repeat_action_probability must be 0 where the autopilot plays"),
        ({}, "actions must be 0 where the autopilot plays, not 0 to 1"),
    ],
)
def test_an_autopilot_takes_no_actions(options, named):
    """ValueError for what would have to be ignored."""
    with pytest.raises(ValueError, match=named):  # noqa: PT012  # either of the two refuses
        env = PolarBreakoutVectorEnv(2, actions="autopilot", **options)
        env.reset(seed=1)
        env.step(np.array([0, 1]))


def two_balls(level, seed):
    """A game of a level with two balls in play; in the first of the games one is about to be lost, the other later."""
    game = new_game((level,), seed)
    ball, speed = game.arena.balls[0], level.ball.speed
    far = complex(level.ground_radius - 0.1 * ball.radius, 0.0)
    other = Ball(far, complex(speed, 0.0), ball.radius) if seed == 0 else Ball(0j, complex(0.0, speed), ball.radius)
    first = Ball(far * 1j * 0.98, complex(0.0, speed), ball.radius) if seed == 0 else ball
    return game._replace(arena=game.arena._replace(balls=(first, other)), phase=Phase.PLAYING, idle=-1000)


def test_a_batch_is_steered_as_a_game():
    """Of two balls the outermost that is not lost is met; the spin that `spins` says of the paddles is not theirs."""
    level = chosen("Sunrise")[0]
    games, pilots = [two_balls(level, seed) for seed in range(COUNT)], [SourcePilot() for _ in range(COUNT)]
    batch = Batch([game.arena for game in games], dt=TICK, speed=level.ball.speed, ground_radius=level.ground_radius)
    autopilot, spins, alone = BatchAutopilot(level, COUNT), batch.spins.copy(), 0
    spins[:, PADDLES] = 99.0
    for _ in range(700):
        steps = batch.step(spins, autopilot=autopilot)
        for g, before in enumerate(games):
            if before.phase == Phase.PLAYING:
                controls = pilots[g].controls(before)
                done = tick(before, controls)
                games[g], mine, pointer = done.game, batch.arena(g), int(autopilot.pointers[g])
                assert controls.pointer == (None if pointer < 0 else pointer)
                assert mine[1:] == done.step.arena[1:]
                left = [ball for ball, lost in zip(mine.balls, steps.lost[g], strict=True) if not lost]
                assert games[g].phase != Phase.PLAYING or tuple(left) == games[g].arena.balls
                alone += len(games[g].arena.balls) == 1
    assert alone > 0
    assert [game.phase for game in games] == [Phase.SERVING, Phase.PLAYING, Phase.PLAYING]


@pytest.fixture
def served():
    """Many games of a level, each with its ball flying elsewhere."""
    level = chosen("Three Rings")[0]
    arena = new_game((level,), 1).arena
    (ball,) = arena.balls
    starts = [arena._replace(balls=(ball._replace(position=0.02j * n),)) for n in range(25)]
    return level, lambda: Batch(starts, dt=TICK, speed=level.ball.speed, ground_radius=level.ground_radius)


def test_many_ticks_in_one_call_are_the_same_ticks_on_any_number_of_threads(served, monkeypatch):
    """State, hits, and where the paddles are wanted, also where the hits need more rows than a step begins with."""
    level, new_batch = served
    one_by_one, autopilot = new_batch(), BatchAutopilot(level, 25)
    single = [one_by_one.step(autopilot=autopilot) for _ in range(1500)]
    hits = sorted((row[0], tick, *row[2:]) for tick, step in enumerate(single) for row in step.hits.tolist())
    monkeypatch.setattr("physics.batch.batch._ROWS", 0)
    for threads in (1, 3):
        batch, other = new_batch(), BatchAutopilot(level, 25)
        done = batch.step(ticks=1500, threads=threads, autopilot=other)
        assert done.hits.tolist() == hits
        assert [batch.arena(g) for g in range(25)] == [one_by_one.arena(g) for g in range(25)]
        assert (other.pointers == autopilot.pointers).all()
    assert len(hits) > 200


def test_a_ball_that_was_put_elsewhere_is_planned_for_after_forget(served):
    """Its velocity does not tell: it is the one for which there is a plan."""
    level, new_batch = served
    batch, autopilot = new_batch(), BatchAutopilot(level, 25)
    while autopilot.pointers[0] < 0:
        batch.step(autopilot=autopilot)
    before = int(autopilot.pointers[0])
    arena = batch.arena(0)
    (ball,) = arena.balls
    across = ball.velocity * 1j / abs(ball.velocity)
    batch.put(0, arena._replace(balls=(ball._replace(position=across * 7.0),)))
    batch.step(autopilot=autopilot)
    planned = int(autopilot.pointers[0])
    autopilot.forget([0])
    batch.step(autopilot=autopilot)
    assert abs(planned - before) < 1000
    assert abs(int(autopilot.pointers[0]) - before) > 1000


def test_a_batch_that_it_cannot_steer_is_refused(served):
    """Another number of games, other ticks, no paddles; nothing is changed."""
    level, new_batch = served
    empty = Batch([Arena((), (), ())], dt=TICK, speed=1.0)
    other_ticks = Batch([new_batch().arena(0)], dt=0.01, speed=1.0)
    for batch, named in (
        (new_batch(), "autopilot must be one of 25 games, not of 1"),
        (other_ticks, f"autopilot needs ticks of {TICK} s, not 0.01"),
        (empty, "autopilot needs paddles"),
    ):
        with pytest.raises(ValueError, match=re.escape(named)):
            batch.step(autopilot=BatchAutopilot(level, 1))


def test_the_example_of_the_page_runs():
    """As it stands; in its ten seconds bricks are hit, and hardly a ball is lost."""
    (example,) = re.findall(
        r"^```py\n(.*?)^```$", (ROOT / "docs" / "batch.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
    seen = {"Batch": Batch}
    exec(example, seen)  # noqa: S102  # the project's own page
    assert seen["steps"].hits["ring"].max() > PADDLES
    assert seen["steps"].lost.mean() < 0.1
