"""The compiled autopilot plays as the game's own: controls and every bit of the state are compared after every tick."""

import numpy as np
import pytest

from game.autopilot.source_pilot import SourcePilot
from game.levels import built_in, chosen
from game.replays.file import load
from game.replays.state_hash import state_hash
from game.replays.verify import verified
from game.rules import PADDLES, SOURCE_RULES, TICK, Phase, new_game, tick
from physics import PERMANENT, Ball
from physics.batch import Batch
from tools.autopilot import BatchAutopilot
from tools.environments import PolarBreakoutVectorEnv
from tools.environments.many import EnvironmentOptions, ManyEnvironments, base_seed

pytestmark = pytest.mark.deep

COUNT = 3
ALL = np.ones(COUNT, np.bool_)
LEVELS = [level.name for level in built_in()[::8]]


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


def environments(level, seed):
    """So many environments of a level that the autopilot plays, at their first episode."""
    many = ManyEnvironments(COUNT, EnvironmentOptions(level, "state", "autopilot", 1), resets=True)
    many.seed([base_seed(seed, index) for index in range(COUNT)], ALL)
    many.begin(ALL)
    return many


def compare(many, games, steps, seen):
    """Play environments and, by the rules and the game's autopilot, their games, one tick a step; compare everything."""
    pilots = [SourcePilot() for _ in games]
    for _ in range(steps):
        begins = many.episodes["ended"] != 0
        many.step(np.zeros(COUNT, np.int64))
        for index, before in enumerate(games):
            mine = many.game(index)
            if begins[index]:
                games[index] = mine
                continue
            controls = pilots[index].controls(before)
            done = tick(before, controls)
            games[index] = done.game
            pointer = int(many.episodes["pointer"][index])
            assert controls.pointer == (pointer if pointer >= 0 else None)
            assert mine[2:12] == done.game[2:12]
            seen.add(before, controls, done)
            seen.cut += many._plans["spin"][index] != 0.0
    assert [state_hash(many.game(index)) for index in range(COUNT)] == [state_hash(game) for game in games]


def meddle(many):
    """Leave one game one contact before a nudge, let one lose a ball, and one its last ball, a moment from now."""
    many._episodes["idle"] = 11
    many._episodes["lives"][1:] = 2, 1
    many._episodes["phase"] = Phase.PLAYING
    edge, speed = many.level.ground_radius, many.level.ball.speed
    many._games.positions[1:COUNT, 0], many._games.velocities[1:COUNT, 0] = edge - 0.1 * many.level.ball.radius, speed
    many._games.known[:COUNT], many._games.free[:COUNT] = 0, 0
    many._plans["state"] = 0
    return [many.game(index) for index in range(COUNT)]


def test_whole_games_are_those_of_the_games_autopilot():
    """On eight levels: serves, lost balls, nudges, games that end, stacks, unbreakable bricks, a ball that does not come."""
    seen = Seen()
    for seed, level in enumerate(LEVELS):
        many = environments(level, seed)
        games = [new_game((many.level,), many.game(index).seed, SOURCE_RULES) for index in range(COUNT)]
        compare(many, games, 900, seen)
        compare(many, meddle(many), 500, seen)
    assert min(vars(seen).values()) >= 5, vars(seen)


def test_a_game_of_the_autopilot_is_recorded():
    """Also where a step is many ticks: the replay is the game's autopilot playing the same game."""


def two_balls(level, seed):
    """A game of a level with two balls in play; in one of three games one of them is about to be lost."""
    game = new_game((level,), seed)
    ball = game.arena.balls[0]
    far = level.ground_radius - 0.1 * ball.radius
    other = Ball(complex(far, 0.0), complex(level.ball.speed, 0.0), ball.radius) if seed == 0 else ball._replace(velocity=-ball.velocity * 1j)
    return game._replace(arena=game.arena._replace(balls=(ball, other)), phase=Phase.PLAYING, idle=-1000)


@pytest.mark.parametrize("level", LEVELS[:2])
def test_a_batch_is_steered_as_a_game(level):
    """Of two balls the outermost that is not lost is met; after the last is lost, the paddles come to rest."""
    level = chosen(level)[0]
    games, pilots = [two_balls(level, seed) for seed in range(COUNT)], [SourcePilot() for _ in range(COUNT)]
    batch = Batch([game.arena for game in games], dt=TICK, speed=level.ball.speed, ground_radius=level.ground_radius)
    autopilot = BatchAutopilot(level, COUNT)
    alone = 0
    for _ in range(900):
        steps = batch.step(autopilot=autopilot)
        for g, before in enumerate(games):
            if before.phase != Phase.PLAYING:
                continue
            controls = pilots[g].controls(before)
            done = tick(before, controls)
            games[g], mine, pointer = done.game, batch.arena(g), int(autopilot.pointers[g])
            assert controls.pointer == (pointer if pointer >= 0 else None)
            assert mine.rings == done.step.arena.rings
            assert mine.layers == done.step.arena.layers
            if games[g].phase == Phase.PLAYING:
                assert tuple([ball for ball, lost in zip(mine.balls, steps.lost[g], strict=True) if not lost]) == games[g].arena.balls
            alone += len(games[g].arena.balls) == 1
    assert alone > 0
