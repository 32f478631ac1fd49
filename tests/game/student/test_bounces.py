"""Balls that bounce on own functions: with none of them, they are the source mode's; each that is there is asked."""

import random
import types

from game.levels import classic
from game.student.flight import bounces
from game.student.own_functions import OwnFunctions
from physics import Arena, Ball, Ring, source_mode, to_cartesian

SPEED = 8.0
PADDLES, BRICKS = Ring(9.0, 0.3, 0.3, 3, 0.5), Ring(5.0, 0.5, 0.3, 8)
DOWN_ON_BRICK_0 = Ball(5.7 + 0j, -8 + 0j, 0.25)


def own_bounces(arena, **functions):
    """The bounces by some functions, as the source mode has them."""
    module = types.ModuleType("mine")
    vars(module).update(functions)
    balls = [
        (ball.position.real, ball.position.imag, ball.velocity.real, ball.velocity.imag, ball.radius) for ball in arena.balls
    ]
    found = bounces(OwnFunctions(module), balls, arena.rings, arena.layers, SPEED)
    return [source_mode.SlidesBounce(*row[:3], complex(*row[3:5]), complex(*row[5:])) for row in found]


def among(*balls, layers=1):
    """An arena of balls among paddles and bricks."""
    return Arena(balls, (PADDLES, BRICKS), ((-1,) * 3, (layers,) * 8))


def test_without_functions_they_are_the_source_modes():
    """Random balls in every level: the same balls, rings and slots; normals and velocities but for rounding."""
    chance, count = random.Random(5), 0
    for level in classic():
        arena = level.arena()
        reach = arena.rings[0].outer_radius + 0.5
        balls = [
            Ball(
                to_cartesian(reach * chance.random(), 6.28 * chance.random()), to_cartesian(SPEED, 6.28 * chance.random()), 0.3
            )
            for _ in range(150)
        ]
        arena = arena._replace(balls=tuple(balls))
        ours, slides = own_bounces(arena), source_mode.bounces(arena, SPEED)
        assert [one[:3] for one in ours] == [one[:3] for one in slides]
        assert all(abs(a.normal - b.normal) + abs(a.after - b.after) < 1e-9 for a, b in zip(ours, slides, strict=True))
        count += len(ours)
    assert count > 100


def test_a_brick_that_breaks_leaves_the_next_ball_a_gap():
    """Of two balls in one position the first takes the layer; two layers are enough for both."""
    twice = among(DOWN_ON_BRICK_0, DOWN_ON_BRICK_0)
    for found in (own_bounces(twice), source_mode.bounces(twice, SPEED)):
        assert [one[:3] for one in found] == [(0, 1, 0)]
    assert len(own_bounces(among(DOWN_ON_BRICK_0, DOWN_ON_BRICK_0, layers=2))) == 2


def test_a_velocity_that_stays_is_no_hit():
    """A ball that leaves, and one whose response is the velocity before."""
    assert own_bounces(among(Ball(5.7 + 0j, 8 + 0j, 0.25))) == []
    assert own_bounces(among(DOWN_ON_BRICK_0), collision_response=lambda v, *_: v) == []


def test_the_outcome_chooses_the_ring():
    """Also where a level has paddles alone."""
    for outcome, rings in {"paddles": [0], "bricks": [1], "game over": [], "no collision": []}.items():
        found = own_bounces(
            among(DOWN_ON_BRICK_0),
            broad_phase_outcome=lambda *_, outcome=outcome: outcome,
            narrow_phase_case_1=lambda *_: 1.0 + 0j,
            narrow_phase_case_2=lambda *_: 1.0 + 0j,
        )
        assert [one.ring for one in found] == rings
    outward = Ball(to_cartesian(8.5, 0.5), to_cartesian(SPEED, 0.5), 0.4)
    alone = Arena((outward,), (PADDLES,), ((-1,) * 3,))
    assert [one[:3] for one in own_bounces(alone)] == [(0, 0, 0)]
    assert [one[:3] for one in own_bounces(alone, broad_phase_outcome=lambda *_: "bricks")] == [(0, 0, 0)]


def test_points_may_be_of_ones_own_kind():
    """A function gets what make_point makes, and answers with a pair."""
    (found,) = own_bounces(
        among(DOWN_ON_BRICK_0),
        make_point=lambda x, y: {"x": x, "y": y},
        narrow_phase_case_1=lambda p, _: (p["x"] / 5.7, p["y"]),
    )
    assert found.normal == 1.0
