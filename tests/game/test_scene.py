"""What is to be seen between two ticks."""

import cmath
from itertools import pairwise

import pytest

from game.autopilot import Autopilot
from game.effects import Effects
from game.levels import classic
from game.rules import PADDLES, TICK, Controls, EventKind, Phase, new_game, tick
from game.scene import scene_at, still
from physics import contact, normalize_angle, signed_difference

NONE = Effects()


def ticks_of(level, count, seed=3):
    """The ticks of an autopilot's game."""
    game, pilot = new_game(classic()[level:], seed), Autopilot()
    for _ in range(count):
        done = tick(game, pilot.controls(game))
        yield done
        game = done.game


@pytest.mark.parametrize("level", range(7))
def test_the_picture_moves_without_jumps(level):
    """The end of a tick shows rings, and balls in play, where the beginning of the next one shows them."""
    before = None
    for done in ticks_of(level, 1500):
        if before is not None and not any(event.kind == EventKind.LEVEL_STARTED for event in done.events):
            old, new = scene_at(before, 1.0, NONE), scene_at(done, 0.0, NONE)
            for one, other in zip(old.rings, new.rings, strict=True):
                assert abs(signed_difference(one.phase, other.phase)) < 1e-9
            if before.game.phase == done.game.phase == Phase.PLAYING:
                assert old.balls[0].position == pytest.approx(new.balls[0].position, abs=1e-9)
        before = done


def test_a_tick_ends_where_the_rules_say():
    """At alpha 1 balls and rings are those of the game after the tick."""
    for done in ticks_of(3, 800):
        scene = scene_at(done, 1.0, NONE)
        if done.game.phase == Phase.PLAYING:
            assert scene.balls[0].position == pytest.approx(done.game.arena.balls[0].position, abs=1e-9)
        for drawn, ring in zip(scene.rings, done.game.arena.rings, strict=True):
            assert abs(signed_difference(drawn.phase, ring.phase)) < 1e-9


def test_a_bounce_is_drawn_where_it_happened():
    """At the moment of a hit the ball touches what it hits."""
    seen = 0
    for done in ticks_of(0, 4000):
        for hit in done.step.hits[:1]:
            scene = scene_at(done, hit.time / TICK, NONE)
            touch = contact(scene.balls[hit.ball], scene.rings[hit.ring], hit.slot)
            assert abs(touch.gap) < 1e-6
            seen += 1
    assert seen > 10


def test_the_ball_never_flies_faster_than_its_speed():
    """Between any two moments of a tick the ball moves no further than its speed allows."""
    for done in ticks_of(4, 1500):
        if done.game.phase != Phase.PLAYING or not done.moving.balls:
            continue
        speed = done.game.level.ball.speed
        positions = [scene_at(done, alpha / 8.0, NONE).balls[0].position for alpha in range(9)]
        for one, other in pairwise(positions):
            assert abs(other - one) <= speed * TICK / 8.0 + 1e-9


def test_a_ball_waiting_for_its_serve_stays_on_its_paddle():
    """While the paddles turn, ball and arrow turn with them at every moment."""
    game = new_game(classic(), 1)
    for _ in range(60):
        done = tick(game, Controls(turn=1))
        game = done.game
    assert game.arena.rings[PADDLES].spin > 0.1
    for alpha in (0.0, 0.3, 1.0):
        scene = scene_at(done, alpha, NONE)
        paddle = scene.rings[PADDLES].angle(0)
        assert signed_difference(normalize_angle(cmath.phase(scene.balls[0].position)), paddle) == pytest.approx(0.0, abs=1e-9)
        assert scene.aim.origin == scene.balls[0].position
        assert abs(scene.aim.direction) == pytest.approx(1.0)


def test_a_served_ball_leaves_from_its_paddle():
    """The tick of the serve shows the ball on its paddle; the next one shows it leaving."""
    game = tick(new_game(classic(), 1), Controls()).game
    served = tick(game, Controls(serve=True))
    assert served.events[0].kind == EventKind.SERVED
    flying = tick(served.game, Controls())
    assert scene_at(served, 1.0, NONE).balls[0].position == pytest.approx(scene_at(flying, 0.0, NONE).balls[0].position)
    assert scene_at(served, 1.0, NONE).aim is None


def test_a_new_level_is_shown_as_it_starts():
    """At every moment of the tick that leads to another level the new level is shown."""
    for done in ticks_of(0, 60_000):
        if any(event.kind == EventKind.LEVEL_STARTED for event in done.events):
            scene = scene_at(done, 0.5, NONE)
            assert scene.rings == done.game.arena.rings
            assert scene.layers == done.game.arena.layers
            return
    pytest.fail("the autopilot cleared no level")


def test_before_the_first_tick_there_is_a_scene():
    """There is a scene of a game that has not begun."""
    game = new_game(classic(), 1)
    scene = scene_at(still(game), 0.0, NONE)
    assert scene.balls == game.arena.balls
    assert scene.tallest == (0, 2)
