"""The engine is the source's algorithm: equal to its transcription wherever the source is right.

The oracle's faces and ends are compared in `test_broad_phase`, `test_narrow_phase` and `test_contact`, its response in
`test_response`; where the source is not right, `test_beyond_the_source` shows the difference.
"""

import ast
import math
from pathlib import Path

from hypothesis import assume, given

import physics
from physics import (
    Ball,
    collision_response,
    contact,
    min_difference,
    nearest_slot,
    normalize_angle,
    on_left,
    to_cartesian,
    to_polar,
)
from tests.support.oracles import source_oracle
from tests.support.strategies import angles, balls_beside_an_end, points, reals, rings

SPEED = 20.0


def test_the_oracle_knows_nothing_of_the_engine():
    """It imports the standard library's `math` and nothing else, so the two cannot share a fault."""
    tree = ast.parse(Path(source_oracle.__file__).read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]
    assert [ast.unparse(node) for node in imports] == ["import math"]


def test_every_function_of_the_source_exists_under_its_name():
    """In the public interface, as in the oracle."""
    words = "normalize_angle min_difference on_left to_polar to_cartesian closest_point_on_line broad_phase narrow_phase_case_1"
    for word in [*words.split(), "narrow_phase_case_2", "collision_response"]:
        assert callable(getattr(physics, word))
        assert word in physics.__all__
        assert callable(getattr(source_oracle, word))


@given(reals(-1e6, 1e6))
def test_angles_are_normalised_alike(angle):
    """But for a negative angle so small that the source's answer is 2 pi."""
    assume(not -1e-15 < angle < 0.0)
    assert normalize_angle(angle) == source_oracle.normalize_angle(angle)


@given(angles(), angles())
def test_angles_are_compared_alike(a, b):
    """The difference to a rounding; "on the left" everywhere but on its two borders."""
    difference = min_difference(a, b)
    assert abs(difference - source_oracle.min_difference(a, b)) < 1e-15
    if 1e-14 < difference < math.pi - 1e-14 or a == b:
        assert on_left(a, b) == source_oracle.on_left(a, b)


@given(points())
def test_points_have_the_same_polar_coordinates(p):
    """The radius to a rounding, the angle to 2e-15 round the circle; the origin has none, and 0 by convention."""
    assume(p != 0.0)
    radius, angle = to_polar(p)
    expected_radius, expected_angle = source_oracle.to_polar(p)
    assert math.isclose(radius, expected_radius, rel_tol=1e-15, abs_tol=1e-160)
    assert min_difference(angle, normalize_angle(expected_angle)) < 2e-15


@given(reals(0.0, 100.0), reals(-100.0, 100.0))
def test_polar_coordinates_give_the_same_point(radius, angle):
    """To a rounding of the radius."""
    assert abs(to_cartesian(radius, angle) - source_oracle.to_cartesian(radius, angle)) <= 1e-15 * radius


def source_bounce(ball, ring):
    """What the source makes of a ball that overlaps a sector: the search, the case, the response to the surface's velocity."""
    theta = source_oracle.to_polar(ball.position)[1]
    positions = [(ring.radius, ring.angle(slot)) for slot in range(ring.count)]
    normal = source_oracle.broad_phase(ball.position, ball.radius, theta, positions, ring.half_width, ring.half_angle)
    surface = 1j * ring.spin * (ball.position - normal * ball.radius)
    return normal, source_oracle.collision_response(ball.velocity, normal, surface, ring.friction, SPEED)


def engine_bounce(ball, ring, slot):
    """The same through `contact`."""
    found = contact(ball, ring, slot)
    surface = ring.surface_velocity(found.point)
    return found.normal, collision_response(ball.velocity, found.normal, surface, ring.friction, SPEED)


def assert_same_bounce(ball, ring, slot):
    """The same normal, and the same velocity for a ball that approaches and gets away at its speed."""
    normal, after = engine_bounce(ball, ring, slot)
    expected_normal, expected_after = source_bounce(ball, ring)
    assert abs(normal - expected_normal) < 1e-9
    surface = ring.surface_velocity(contact(ball, ring, slot).point)
    rate = ((ball.velocity - surface) * normal.conjugate()).real
    assume(abs(rate) > 1e-3)
    assume(((expected_after - surface) * normal.conjugate()).real > 1e-3)
    before_reset = source_oracle.response_before_reset(ball.velocity, normal, surface, ring.friction)
    assume(abs(before_reset) > 1e-2)
    assert abs(after - expected_after) < 1e-5


@given(balls_beside_an_end(), angles())
def test_a_touch_of_a_paddles_end_bounces_as_in_the_source(beside, heading):
    """From the position of ball and paddles to the velocity after, all stages together, at the moment of touch."""
    ball = Ball(beside.ball.position, to_cartesian(SPEED, heading), beside.across * (1.0 + 1e-9))
    assert_same_bounce(ball, beside.ring, beside.slot)


@given(rings(), angles(), reals(-0.99, 0.99), reals(0.05, 0.5), angles())
def test_a_touch_of_a_paddles_face_bounces_as_in_the_source(ring, turn, share, ball_radius, heading):
    """Outer face and inner face, by the sign of the share."""
    slot = nearest_slot(ring, turn)
    distance = ring.outer_radius + ball_radius if share > 0.0 else ring.inner_radius - ball_radius
    assume(distance > 0.01)
    theta = normalize_angle(ring.angle(slot) + share * ring.half_angle)
    ball = Ball(to_cartesian(distance, theta), to_cartesian(SPEED, heading), ball_radius)
    assert_same_bounce(ball, ring, slot)
