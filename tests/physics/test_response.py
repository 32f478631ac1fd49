"""The bounce: balls and paddles of different velocities, with friction, and the two cases the source leaves out."""

import itertools
import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from physics import collision_response, cross, direction, dot, length
from physics.response import leaving_at
from tests.support.oracles import source_oracle
from tests.support.strategies import angles, points, reals, units

SPEED = 5.0
MUS = [0.0, 0.5, 1.0]
NORMALS = [1 + 0j, 1j, -0.6 + 0.8j, -1j]
BALLS = [3 - 4j, -3 - 4j, -5j, 5 + 0j, -4 + 3j, 5j]
PADDLES = [0j, 2 + 0j, -2 + 0j, 1j, -1j, 1.5 - 2j, -3 + 2.5j]


def frictions():
    """0, 1/2, 1 and all between."""
    return st.sampled_from(MUS) | reals(0.0, 1.0)


def velocities(speed=SPEED):
    """Velocities of a fixed length."""
    return angles().map(lambda angle: direction(angle) * speed)


def approach(v, normal, surface):
    """Rate of the gap: < 0 for a ball that comes nearer to the surface."""
    return dot(v - surface, normal)


def respond(v, normal, surface, friction):
    """The response at the fixed speed."""
    return collision_response(v, normal, surface, friction, SPEED)


@pytest.mark.parametrize("friction", MUS)
@pytest.mark.parametrize("normal", NORMALS)
class TestDifferentVelocities:
    """Every ball with every paddle, from four sides, with friction 0, 1/2 and 1."""

    def pairs(self, normal, *, approaching):
        """The velocities of ball and surface that approach, or do not."""
        pairs = itertools.product(BALLS, PADDLES)
        return [(v, surface) for v, surface in pairs if (approach(v, normal, surface) < 0.0) == approaching]

    def test_a_separating_pair_is_left_alone(self, normal, friction):
        """Continue only if dv . n < 0: otherwise the very same velocity comes back."""
        pairs = self.pairs(normal, approaching=False)
        assert pairs
        assert all(respond(v, normal, surface, friction) is v for v, surface in pairs)

    def test_an_approaching_ball_keeps_its_speed_and_leaves(self, normal, friction):
        """|v| = v_0, and the gap does not shrink any more."""
        pairs = self.pairs(normal, approaching=True)
        assert pairs
        for v, surface in pairs:
            after = respond(v, normal, surface, friction)
            assert abs(length(after) - SPEED) < 1e-14
            assert approach(after, normal, surface) >= -1e-14

    def test_the_bounce_is_the_sources_where_the_source_is_right(self, normal, friction):
        """Where v_res is not 0 and the ball still leaves after the reset to v_0: nearly always."""
        right = 0
        pairs = self.pairs(normal, approaching=True)
        for v, surface in pairs:
            if abs(source_oracle.response_before_reset(v, normal, surface, friction)) > 1e-9:
                expected = source_oracle.collision_response(v, normal, surface, friction, SPEED)
                if approach(expected, normal, surface) >= 0.0:
                    assert abs(respond(v, normal, surface, friction) - expected) < 1e-13
                    right += 1
        assert right >= 0.9 * len(pairs)


@given(velocities(), units(), points(4.0), frictions())
def test_the_response_is_the_sources_wherever_the_source_is_right(v, normal, surface, friction):
    """Any ball, any paddle, any friction."""
    before_reset = source_oracle.response_before_reset(v, normal, surface, friction)
    assume(abs(before_reset) > 1e-3 * SPEED)
    assume(abs(approach(v, normal, surface)) > 1e-12)
    expected = source_oracle.collision_response(v, normal, surface, friction, SPEED)
    assume(approach(expected, normal, surface) >= 0.0)
    assert abs(respond(v, normal, surface, friction) - expected) < 1e-11


@given(velocities(), units(), points(10.0), frictions())
def test_the_speed_is_kept_to_the_last_bits(v, normal, surface, friction):
    """Also off a surface faster than the ball."""
    assert abs(length(respond(v, normal, surface, friction)) / SPEED - 1.0) < 1e-15


@given(velocities(), units(), points(4.9 / math.sqrt(2.0)), frictions())
def test_no_response_leaves_an_approaching_pair(v, normal, surface, friction):
    """Off any surface slower than the ball."""
    assert approach(respond(v, normal, surface, friction), normal, surface) >= -1e-13


@given(velocities(), units())
def test_without_friction_a_resting_wall_is_a_mirror(v, normal):
    """The angle out is the angle in: v - 2 (v . n) n."""
    assume(dot(v, normal) < 0.0)
    after = respond(v, normal, 0j, 0.0)
    assert abs(dot(after, normal) + dot(v, normal)) < 1e-14
    assert abs(cross(after, normal) - cross(v, normal)) < 1e-14


@given(velocities(), units())
def test_a_mirror_twice_is_the_way_back(v, normal):
    """Thrown back at the wall, the ball returns the way it came."""
    assume(dot(v, normal) < -1e-12)
    after = respond(v, normal, 0j, 0.0)
    assert abs(respond(-after, normal, 0j, 0.0) + v) < 2e-14


@pytest.mark.parametrize(("friction", "left"), [(0.0, 3.0), (0.5, 1.5), (1.0, 0.0)])
def test_friction_takes_its_share_of_the_slip(friction, left):
    """A ball that slips slower than it falls, on a paddle at rest: of 3 along the surface, all, half or nothing is left."""
    after = collision_response(3 - 4j, 1j, 0j, friction, 5.0)
    expected = complex(left, 4.0)
    assert abs(after - expected * (5.0 / abs(expected))) < 1e-15


@pytest.mark.parametrize(("friction", "left"), [(0.0, 4.0), (0.5, 2.5), (1.0, 1.0)])
def test_friction_takes_no_more_than_the_fall(friction, left):
    """min(|dv_n|, |dv_t|): of 4 along the surface, a fall of 3 can take 3 at most."""
    after = collision_response(-4 - 3j, 1j, 0j, friction, 5.0)
    expected = complex(-left, 3.0)
    assert abs(after - expected * (5.0 / abs(expected))) < 1e-15


@pytest.mark.parametrize("friction", MUS)
def test_friction_drags_the_ball_along_with_the_paddle(friction):
    """A ball that falls straight onto a paddle moving right leaves to the right, the more the rougher it is."""
    after = collision_response(-5j, 1j, 2 + 0j, friction, 5.0)
    expected = complex(2.0 * friction, 5.0)
    assert abs(after - expected * (5.0 / abs(expected))) < 1e-15


@given(velocities(), units(), reals(-1.0, 1.0), frictions(), frictions())
def test_more_friction_never_leaves_more_slip(v, normal, slide, one, other):
    """On a surface that slides along itself the ball leaves in the surface's frame the steeper, the rougher it is."""
    surface = normal * 1j * slide
    assume(approach(v, normal, surface) < -1e-6)
    less, more = sorted([one, other])
    slips = []
    for friction in (less, more):
        after = respond(v, normal, surface, friction)
        before_reset = after * (-dot(v, normal) / dot(after, normal))  # the fall is turned round, whatever the friction
        slips.append(cross(normal, before_reset - surface))
    assert abs(slips[1]) <= abs(slips[0]) + 1e-8
    assert slips[0] * slips[1] >= -1e-8


def test_a_paddle_that_advances_makes_the_return_steeper():
    """dv_n' = -2 dv_n takes up the paddle's own velocity, as the speed is then reset."""
    resting, advancing = (collision_response(3 - 4j, 1j, surface, 0.0, 5.0) for surface in (0j, 2j))
    assert advancing.imag > resting.imag
    assert abs(advancing - (3 + 8j) * (5.0 / abs(3 + 8j))) < 1e-15


@given(units(), reals(1e-3, 100.0))
def test_a_ball_stopped_dead_leaves_along_the_normal(normal, speed):
    """v_res = 0: a surface that retreats at half the ball's speed. The source promises that this does not happen."""
    after = collision_response(normal * -speed, normal, normal * (-0.5 * speed), 0.0, speed)
    assert abs(after - normal * speed) < 1e-14 * speed


@pytest.mark.parametrize("normal", NORMALS)
def test_a_ball_stopped_dead_to_the_bit_has_no_direction(normal):
    """Where v_res is exactly 0 the source divides by 0."""
    v, surface = normal * -4.0, normal * -2.0
    assert source_oracle.response_before_reset(v, normal, surface, 1.0) == 0.0
    assert collision_response(v, normal, surface, 1.0, 4.0) == normal * 4.0


@given(velocities(), units(), reals(-3.0, 4.99), reals(-4.0, 4.0), frictions())
def test_a_carried_ball_keeps_the_pace_of_the_surface(v, normal, pace, slide, friction):
    """Where v_0 is too little to get away, the normal speed is the surface's, and the rest of v_0 goes along it."""
    surface = normal * pace + normal * 1j * slide
    assume(approach(v, normal, surface) < 0.0)
    before_reset = source_oracle.response_before_reset(v, normal, surface, friction)
    assume(abs(before_reset) > 1e-3)
    reset = before_reset * (SPEED / abs(before_reset))
    after = respond(v, normal, surface, friction)
    if dot(reset, normal) < pace - 1e-9:
        assert abs(dot(after, normal) - pace) < 1e-13
        assert abs(abs(cross(normal, after)) - math.sqrt(SPEED**2 - pace**2)) < 1e-12
        assert cross(normal, after) * cross(normal, reset) >= -1e-12
    else:
        assert dot(after, normal) >= pace - 1e-9


def test_a_ball_overtaken_from_behind_is_carried():
    """The surface does 4.5 of the ball's 5 along the normal; the bounce, reset to 5, would fall back into it."""
    v, surface = 4 + 3j, 4.5j
    reset = source_oracle.collision_response(v, 1j, surface, 0.0, 5.0)
    assert reset.imag < 4.5
    after = collision_response(v, 1j, surface, 0.0, 5.0)
    assert abs(after - complex(math.sqrt(25.0 - 4.5**2), 4.5)) < 1e-14


@given(units(), reals(5.01, 100.0), velocities())
def test_off_a_surface_as_fast_as_the_ball_it_leaves_along_the_normal(normal, pace, v):
    """There is no velocity of that length that gets away; along the normal is the best there is."""
    assume(dot(v, normal) < pace)
    assert abs(respond(v, normal, normal * pace, 0.0) - normal * SPEED) < 1e-14


@given(velocities(), units(), reals(-4.99, 4.99))
def test_leaving_at_a_normal_speed_has_it(v, normal, normal_speed):
    """The length is the ball's speed, the component along the normal is the asked one, the tangential sense is kept."""
    after = leaving_at(v, v, normal, normal_speed, SPEED)
    assert abs(length(after) - SPEED) < 1e-14
    assert abs(dot(after, normal) - normal_speed) < 1e-13
    assert cross(normal, after) * cross(normal, v) >= 0.0


@given(velocities(), units(), reals(5.0, 100.0))
def test_leaving_faster_than_the_ball_can_is_along_the_normal(v, normal, normal_speed):
    """To either side."""
    assert abs(leaving_at(v, v, normal, normal_speed, SPEED) - normal * SPEED) < 1e-14
    assert abs(leaving_at(v, v, normal, -normal_speed, SPEED) + normal * SPEED) < 1e-14


@given(velocities(), units(), points(10.0), frictions())
def test_a_mirrored_bounce_is_the_mirror_image_to_the_bit(v, normal, surface, friction):
    """Everything reflected about the x axis. A carried ball that fell straight has no tangential sense to mirror."""
    here = respond(v, normal, surface, friction)
    assume(abs(cross(normal, source_oracle.response_before_reset(v, normal, surface, friction))) > 1e-9)
    assert respond(v.conjugate(), normal.conjugate(), surface.conjugate(), friction) == here.conjugate()


@given(velocities(), units(), points(4.0), frictions(), angles())
def test_a_turned_bounce_is_the_turned_result(v, normal, surface, friction, turn):
    """No direction is special."""
    assume(abs(approach(v, normal, surface)) > 1e-9)
    before_reset = source_oracle.response_before_reset(v, normal, surface, friction)
    assume(abs(before_reset) > 1e-3)
    assume(abs(cross(normal, before_reset)) > 1e-9)
    arrow = direction(turn)
    here = respond(v, normal, surface, friction) * arrow
    assert abs(respond(v * arrow, normal * arrow, surface * arrow, friction) - here) < 1e-6


@given(velocities(), units(), points(10.0), frictions(), st.integers(-400, 300))
def test_doubling_every_velocity_doubles_the_result(v, normal, surface, friction, exponent):
    """No speed is built in, from the least to the greatest; where squares underflow, the speed is still kept."""
    factor = 2.0**exponent
    after = collision_response(v * factor, normal, surface * factor, friction, SPEED * factor)
    assert abs(length(after / factor) / SPEED - 1.0) < 1e-15
    if exponent > -300 and min(abs(c) for w in (v, normal, surface) for c in (w.real, w.imag)) > 1e-9:
        assert abs(after / factor - respond(v, normal, surface, friction)) < 1e-13


@given(velocities(), units(), st.sampled_from([1e-305, 1e-200, 1e-160, 1e-100, 1e100]))
def test_the_slowest_ball_still_leaves_at_its_speed(v, normal, speed):
    """Squares of speeds below 1e-162 are 0: `leaving_at` once divided by their root."""
    assert math.isclose(abs(leaving_at(v, v, normal, 0.0, speed)), speed, rel_tol=1e-15)
    assert math.isclose(abs(collision_response(normal * -speed, normal, 0j, 0.0, speed)), speed, rel_tol=1e-14)
