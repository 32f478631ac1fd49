"""The rules: serving, scoring, losing, clearing, nudging."""

import itertools
import math

import pytest

from game.autopilot import Autopilot
from game.levels import classic, parse
from game.rules import (
    LIVES,
    POINTER_STEPS,
    TICK,
    Controls,
    EventKind,
    Phase,
    aim,
    layers_left,
    new_game,
    paddle_ring,
    tick,
)
from physics import Ball, direction, length, min_difference, normalize_angle
from tests.support.games.arcade import after
from tests.support.level_text import GOOD, changed

LEVEL = parse(GOOD, "good")
IDLE = Controls()
SERVE = Controls(serve=True)


def with_ball(game, position, velocity):
    """The game in play, its ball placed and sent by hand."""
    ball = Ball(position, velocity * (game.level.ball.speed / length(velocity)), game.level.ball.radius)
    return game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(ball,)))


def kinds(events):
    """The events' kinds, in order."""
    return [event.kind for event in events]


def test_the_ball_rests_on_its_paddle_until_it_is_served():
    """Before the serve, the ball keeps its distance from the centre and the bearing of paddle 0, however the paddles turn."""
    game, _ = after(new_game((LEVEL,), 1), 100, Controls(turn=1))
    paddles, ball = paddle_ring(game), game.arena.balls[0]
    assert game.phase == Phase.SERVING
    assert length(ball.position) == pytest.approx(paddles.inner_radius - ball.radius, rel=1e-6)
    assert length(ball.position - direction(paddles.angle(0)) * length(ball.position)) < 1e-12


def test_a_serve_flies_where_it_is_aimed():
    """The served ball leaves at the level's speed, off the line to the centre by the aim."""
    for wait in (1, 100, 240, 700):
        game, _ = after(new_game((LEVEL,), 1), wait)
        game, events = after(game, 1, SERVE)
        velocity = game.arena.balls[0].velocity
        inward = paddle_ring(game).angle(0) + math.pi
        off = min_difference(normalize_angle(math.atan2(velocity.imag, velocity.real)), normalize_angle(inward))
        assert kinds(events) == [EventKind.SERVED]
        assert length(velocity) == pytest.approx(LEVEL.ball.speed, rel=1e-14)
        assert off == pytest.approx(abs(aim(game._replace(phase_tick=wait + 1))), abs=1e-9)


def test_the_aim_swings_to_both_sides():
    """In a period the aim covers 55 degrees to each side, without a jump."""
    game = new_game((LEVEL,), 1)
    aims = [math.degrees(aim(game._replace(phase_tick=t))) for t in range(481)]
    assert min(aims) == pytest.approx(-55)
    assert max(aims) == pytest.approx(55)
    assert max(abs(a - b) for a, b in itertools.pairwise(aims)) < 1


def test_keys_accelerate_the_paddles_to_their_top_speed():
    """A held key brings the spin up at the level's acceleration to its top speed; released, it comes to rest."""
    game = new_game((LEVEL,), 1)
    faster, _ = after(game, 10, Controls(turn=-1))
    assert paddle_ring(faster).spin == pytest.approx(-math.radians(400.0) * 10 * TICK)
    fastest, _ = after(game, 200, Controls(turn=-1))
    assert paddle_ring(fastest).spin == -math.radians(50.0)
    resting, _ = after(fastest, 200)
    assert paddle_ring(resting).spin == 0.0


@pytest.mark.parametrize("wanted", range(0, POINTER_STEPS, POINTER_STEPS // 16))
def test_the_nearest_paddle_follows_the_pointer(wanted):
    """The paddle nearest to the pointer goes there, never faster than the top speed, and stays."""
    game = new_game((LEVEL,), 1)
    fastest = 0.0
    for _ in range(400):
        game = tick(game, Controls(pointer=wanted)).game
        fastest = max(fastest, abs(paddle_ring(game).spin))
    paddles = paddle_ring(game)
    away = min(min_difference(wanted / POINTER_STEPS * math.tau, paddles.angle(slot)) for slot in range(3))
    assert away < 1e-9
    assert fastest <= math.radians(50.0)


def test_a_key_goes_before_the_pointer():
    """While a key is held, the pointer is not followed."""
    game, _ = after(new_game((LEVEL,), 1), 200, Controls(turn=1, pointer=0))
    assert paddle_ring(game).spin == math.radians(50.0)


def test_a_ball_off_the_ground_costs_one_life_once():
    """A ball that leaves costs one life and is served again, and the third loss ends the game."""
    game = new_game((LEVEL,), 1)
    for lost in range(1, LIVES + 1):
        game = with_ball(game, direction(math.radians(30)) * 9.5, direction(math.radians(30)))
        game, events = after(game, 100)
        assert kinds(events)[0] == EventKind.BALL_LOST
        assert game.lives == LIVES - lost
    assert game.phase == Phase.OVER
    assert EventKind.GAME_OVER in kinds(events)
    assert after(game, 500, SERVE)[0].phase == Phase.OVER


def test_a_ball_is_lost_when_it_is_wholly_outside_the_ground():
    """At |p| - r = r_g the ball is still in play; a hair beyond, it is lost."""
    outward = direction(0.5)
    ground, radius = LEVEL.ground_radius, LEVEL.ball.radius
    step = LEVEL.ball.speed * TICK
    inside = with_ball(new_game((LEVEL,), 1), outward * (ground + radius - step * 1.001), outward)
    beyond = with_ball(new_game((LEVEL,), 1), outward * (ground + radius - step * 0.999), outward)
    assert kinds(tick(inside, IDLE).events) == []
    assert kinds(tick(beyond, IDLE).events) == [EventKind.BALL_LOST]


def test_a_brick_hit_takes_the_lowest_layer_and_scores():
    """A hit takes one layer; the second brick in a row counts double."""
    level = parse(changed("count = 12", "count = 12\nlayers = 2"), "two layers")
    game = with_ball(new_game((level,), 1), 5.0 + 0j, -1.0 + 0j)
    game, events = after(game, 80)
    assert kinds(events) == [EventKind.BRICK_HIT]
    assert events[0].hit.layers == 1
    assert (game.score, game.combo) == (10, 1)
    assert game.arena.layers[1][0] == 1
    game, events = after(with_ball(game, 5.0 + 0j, -1.0 + 0j), 80)
    assert game.arena.layers[1][0] == 0
    assert (game.score, game.combo) == (30, 2)


def test_a_paddle_ends_the_combo():
    """After a paddle hit, the next brick counts single again."""
    game = with_ball(new_game((LEVEL,), 1)._replace(combo=5), -8.0j, -1.0j)
    game, events = after(game, 40)
    assert kinds(events) == [EventKind.PADDLE_HIT]
    assert game.combo == 0


def one_brick(levels):
    """A game with one brick left, at bearing 0, and a ball on its way to it."""
    game = new_game(levels, 1)
    layers = (game.arena.layers[0], (1, *[0] * 11))
    return with_ball(game._replace(arena=game.arena._replace(layers=layers)), 5.0 + 0j, -1.0 + 0j)


def test_the_last_brick_clears_the_level_and_the_next_begins():
    """After the last brick the level is cleared, and a serve or two seconds later the next level waits for its serve."""
    game, events = after(one_brick((LEVEL, classic()[1])), 60)
    assert EventKind.LEVEL_CLEARED in kinds(events)
    assert game.phase == Phase.CLEARED
    assert game.score == 10 + 100 * LIVES
    for controls, least, most in ((SERVE, 20, 70), (IDLE, 400, 500)):
        assert after(game, least, controls)[0].phase == Phase.CLEARED
        later, events = after(game, most, controls)
        assert later.number == 1
        assert EventKind.LEVEL_STARTED in kinds(events)
        assert layers_left(later) == layers_left(new_game(classic()[1:], 1))


def test_the_last_level_wins_the_game():
    """After the last brick of the last level the game is won, and stays so."""
    game, events = after(one_brick((LEVEL,)), 60)
    assert kinds(events)[-1] == EventKind.GAME_WON
    assert after(game, 1000, SERVE)[0].phase == Phase.WON


def test_a_ball_in_a_loop_is_nudged_by_the_seed():
    """A ball that goes to and fro without a brick is turned, at the same speed, by an angle that the seed decides."""
    level = parse(changed("acceleration = 400.0", "acceleration = 400.0\ncount = 2"), "two")
    turns = []
    for seed in (1, 1, 2):
        game = new_game((level,), seed)
        layers = (game.arena.layers[0], (1,) + (0,) * 11)
        game = with_ball(game._replace(arena=game.arena._replace(layers=layers)), 0j, 1j)
        for _ in range(240 * 60):
            done = tick(game, IDLE)
            game = done.game
            if EventKind.NUDGED in kinds(done.events):
                break
        velocity = game.arena.balls[0].velocity
        assert game.draws == 1
        assert length(velocity) == pytest.approx(level.ball.speed, rel=1e-12)
        turns.append(velocity)
    assert turns[0] == turns[1] != turns[2]
    assert math.radians(4.9) < min(
        min_difference(normalize_angle(math.atan2(turns[0].imag, turns[0].real)), a) for a in (math.pi / 2, 3 * math.pi / 2)
    )


def test_the_speed_never_drifts():
    """Over a whole game of the autopilot, every ball's speed stays within 1e-12 of the level's."""
    game, pilot = new_game(classic()[3:4], 5), Autopilot()
    worst = 0.0
    for _ in range(10_000):
        game = tick(game, pilot.controls(game)).game
        for ball in game.arena.balls:
            worst = max(worst, abs(length(ball.velocity) / game.level.ball.speed - 1.0))
    assert worst < 1e-12


@pytest.mark.parametrize("block", [range(1, 11), range(11, 21)])
def test_the_autopilot_clears_the_first_level(block):
    """Over seeds 1-20, the autopilot clears level 1 at least 18 times: at most one failure in each ten."""
    cleared = 0
    for seed in block:
        game, pilot = new_game(classic()[:1], seed), Autopilot()
        while game.phase not in {Phase.WON, Phase.OVER} and game.tick < 40_000:
            game = tick(game, pilot.controls(game)).game
        cleared += game.phase == Phase.WON
    assert cleared >= 9
