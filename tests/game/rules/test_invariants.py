"""What holds after every tick of every arcade game, whatever its players do."""

import itertools
import math
import random

from hypothesis import given, settings
from hypothesis import strategies as st

from game.autopilot import Autopilot
from game.levels import classic
from game.replays.state_hash import state_hash
from game.rules import (
    PADDLES,
    POINTER_STEPS,
    SOURCE_RULES,
    Controls,
    Difficulty,
    Drop,
    EventKind,
    Phase,
    PowerUp,
    Ruleset,
    held_balls,
    new_game,
    paddle_ring,
    tick,
)
from physics import PERMANENT, contact, direction, in_band, length
from physics.tolerances import OVERLAP
from tests.support.games.arcade import EVERYTHING, arcade, with_balls
from tests.support.games.players import MousePlayer

TICKS = 4000


class Fidgeter:
    """Catches as the mouse player does, and now and then presses anything at all."""

    def __init__(self, seed):
        self._mouse, self._chance = MousePlayer(seed), random.Random(seed)

    def controls(self, game):
        """What to do in this tick."""
        if self._chance.random() < 0.02:
            aim = int(self._chance.random() * POINTER_STEPS)
            return Controls(int(self._chance.random() * 3) - 1, None, True, self._chance.random() < 0.01, aim)
        return self._mouse.controls(game)


def in_material(game):
    """The balls that overlap a sector by more than a bounce leaves: index, ring and slot."""
    found = []
    for index, ball in enumerate(game.arena.balls):
        for k, ring in enumerate(game.arena.rings):
            if in_band(length(ball.position), ball.radius, ring):
                for slot, layers in enumerate(game.arena.layers[k]):
                    if layers and contact(ball, ring, slot).gap < -OVERLAP * ball.radius:
                        found.append((index, k, slot))
    return found


def check(before, done):
    """All that must hold after a tick."""
    game = done.game
    paddles = paddle_ring(game)
    if game.phase == Phase.PLAYING:
        assert max([abs(length(ball.velocity) / game.speed - 1.0) for ball in game.arena.balls], default=0.0) < 1e-12
        assert in_material(game) == []
        assert len(game.arena.balls) + len(game.held) > 0
    assert abs(paddles.spin) * paddles.outer_radius < game.speed
    assert paddles.half_angle * paddles.count < math.pi
    for ring in game.arena.rings[PADDLES + 1 :]:
        assert abs(ring.spin) * ring.outer_radius < game.speed
    assert game.score >= before.score
    assert 0 <= game.lives <= 9
    assert len(game.arena.layers) == len(game.arena.rings) == len(game.level.rings) + 2
    for spec, layers in zip(game.level.rings, game.arena.layers[PADDLES + 1 : -1], strict=True):
        assert all(0 <= now <= full or now == full == PERMANENT for now, full in zip(layers, spec.slots(), strict=True))


def test_every_tick_of_a_game_with_everything():
    """Balls have the game's speed and overlap nothing, paddles leave gaps and stay slower than the balls."""
    seen = set()
    for difficulty in Difficulty:
        game, player = new_game((EVERYTHING,) * 3, difficulty, Ruleset(difficulty)), Fidgeter(difficulty)
        for _ in range(TICKS):
            done = tick(game, player.controls(game))
            check(game, done)
            seen |= {event.kind for event in done.events}
            game = done.game
            if game.phase in {Phase.OVER, Phase.WON}:
                game = new_game((EVERYTHING,) * 3, game.draws, Ruleset(difficulty))
    assert {EventKind.DROP_CAUGHT, EventKind.BRICK_REGROWN, EventKind.BALLS_MET} <= seen


@settings(max_examples=60)
@given(
    kinds=st.lists(st.sampled_from(PowerUp), min_size=1, max_size=4),
    angles=st.lists(st.floats(0.0, 6.28), min_size=3, max_size=3),
    distance=st.sampled_from([7.0, 8.5, 8.9, 9.0, 9.25, 9.4, 9.7]),
    turn=st.floats(0.0, 6.28),
)
def test_no_power_up_puts_a_ball_into_material(kinds, angles, distance, turn):
    """Wherever balls are when power-ups are caught: none is put into a paddle, a brick or the shield."""
    game = arcade(seed=3)
    ring = paddle_ring(game)._replace(phase=turn)
    game = game._replace(arena=game.arena._replace(rings=(ring, *game.arena.rings[1:])))
    game = with_balls(game, *[(direction(a) * distance, direction(a + b)) for a, b in itertools.pairwise(angles)])
    if in_material(game):
        return
    caught = direction(ring.angle(0)) * ring.radius
    for kind in kinds:
        game = game._replace(drops=(*game.drops, Drop(kind, caught, caught * 1e-9)))
        for _ in range(6):
            done = tick(game, Controls())
            if done.game.phase != Phase.PLAYING:
                return
            assert done.step.freed == 0
            check(game, done)
            game = done.game


def test_the_autopilot_copes_with_everything():
    """It clears the level with all that the arcade rules know, on easy, without running out of lives."""
    game, player = arcade(EVERYTHING, 1, Ruleset(Difficulty.EASY)), Autopilot()
    while game.phase not in {Phase.WON, Phase.OVER} and game.tick < 60 * 240:
        game = tick(game, player.controls(game)).game
    assert game.phase == Phase.WON


def test_the_same_seed_is_the_same_game():
    """Tick for tick, in every bit; another seed is another game, and so is another difficulty."""
    hashes = []
    for seed, ruleset in ((4, Ruleset()), (4, Ruleset()), (5, Ruleset()), (4, Ruleset(Difficulty.HARD)), (4, SOURCE_RULES)):
        game, player = new_game(classic()[3:], seed, ruleset), Autopilot()
        for _ in range(3000):
            game = tick(game, player.controls(game)).game
        hashes.append(state_hash(game))
    assert hashes[0] == hashes[1]
    assert len(set(hashes)) == 4


def test_a_difficulty_changes_nothing_under_the_sources_rules():
    """The state stays the same in every bit."""
    games = [new_game(classic(), 1, SOURCE_RULES._replace(difficulty=difficulty)) for difficulty in Difficulty]
    for _ in range(1000):
        games = [tick(game, Controls(turn=1, serve=True)).game for game in games]
    assert len({state_hash(game) for game in games}) == 1


def test_balls_that_are_held_rest_on_their_paddles():
    """They touch nothing, at the distance of a served ball, however the paddle turns and shrinks."""
    game = arcade(seed=2)
    paddles = paddle_ring(game)
    start = direction(paddles.angle(1) + 0.2) * 6.0
    sticky = Drop(PowerUp.STICKY, direction(paddles.angle(0)) * 9.0, 0.01 + 0j)
    game = with_balls(game, (start, start), (start * 0.8, -start))._replace(drops=(sticky,))
    for number in range(200):
        if number == 150:
            there = direction(paddle_ring(game).angle(0)) * 9.0
            game = game._replace(drops=(Drop(PowerUp.NARROW, there, 0.01 + 0j),))
        done = tick(game, Controls(turn=1))
        check(game, done)
        game = done.game
        for ball in held_balls(game):
            gaps = [contact(ball, paddle_ring(game), slot).gap for slot in range(3)]
            assert 0.0 < min(gaps) < 1e-5
    assert game.held
    assert game.power(PowerUp.NARROW) is not None
