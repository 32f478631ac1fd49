"""Friction through a whole tick, on every feature of a sector, at rest and turning: the tangential change is the source's."""

import math

import pytest

from physics import PERMANENT, Arena, Ball, Feature, Ring, advance, collision_response, cross, dot, response_steps
from tests.support.oracles import source_oracle

TICK = 1.0 / 240.0
R, SPEED = 0.25, 8.0
END, CORNER = complex(math.cos(0.3), math.sin(0.3)), 10.5 * complex(math.cos(0.3), math.sin(0.3))
INTO_THE_GAP = 1j * END

SURFACES = {
    Feature.OUTER_FACE: (10.5 + 0j, 1 + 0j),
    Feature.INNER_FACE: (9.5 + 0j, -1 + 0j),
    Feature.END: (10.0 * END, INTO_THE_GAP),
    Feature.CORNER: (CORNER, END * complex(math.cos(0.9), math.sin(0.9))),
}
"""A point of each feature, and the normal there."""


def hit_on(feature, incoming, friction, spin):
    """The one hit of a ball that flies at a feature, in a direction seen from its normal."""
    ring = Ring(10.0, 0.5, 0.3, 1, 0.0, spin, friction)
    point, normal = SURFACES[feature]
    velocity = normal * incoming * SPEED
    moment = TICK / 2.0
    by = complex(math.cos(spin * moment), math.sin(spin * moment))
    ball = Ball((point + normal * R) * by - velocity * by * moment, velocity * by, R)
    step = advance(Arena((ball,), (ring,), ((PERMANENT,),)), TICK, SPEED)
    (hit,) = step.hits
    assert hit.contact.feature == feature
    return hit, ring


@pytest.mark.parametrize("spin", [0.0, 0.4, -0.4])
@pytest.mark.parametrize("friction", [0.0, 0.3, 0.5, 1.0])
@pytest.mark.parametrize("slant", [-1.0, -0.5, 0.2, 0.8])
@pytest.mark.parametrize("feature", SURFACES)
def test_a_bounce_takes_the_source_s_share_of_the_slip(feature, slant, friction, spin):
    """By the slides' formula, worked out by an oracle that knows nothing of the engine."""
    incoming = -complex(math.cos(slant), math.sin(slant))
    hit, ring = hit_on(feature, incoming, friction, spin)
    surface = ring.surface_velocity(hit.contact.point)
    before_reset = source_oracle.response_before_reset(hit.before, hit.contact.normal, surface, friction)
    expected = before_reset / abs(before_reset) * SPEED
    if dot(expected - surface, hit.contact.normal) > 0.01 * SPEED:  # it is not carried
        assert abs(hit.after - expected) < 1e-11
    steps = response_steps(hit.before, hit.contact.normal, surface, friction, SPEED)
    taken, slip, fall = (abs(part) for part in (steps.tangential_change, steps.tangential_part, steps.normal_part))
    assert taken == pytest.approx(friction * min(fall, slip), abs=1e-12)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_ball_pressed_by_a_surface_of_full_friction_keeps_its_sense(sign):
    """Friction 1 takes the whole slip, the ball is carried, and it leaves to the side from which it came: not by rounding."""
    v = complex(-0.95, sign * 0.31225)
    after = collision_response(v, 1 + 0j, -0.6 + 0j, 1.0, 1.0)
    assert after == pytest.approx(complex(-0.6, sign * 0.8), abs=1e-12)
    assert cross(1 + 0j, after) * cross(1 + 0j, v) > 0.0


def test_the_steps_of_a_response_add_up():
    """dv = v - v_p = dv_n + dv_t, v_res = v + dv_n' + dv_t', v = v_0 v_res / |v_res|; the changes are 0 while it separates."""
    v, n, u = 3 - 4j, 0.6 + 0.8j, 0.5 + 1j
    steps = response_steps(v, n, u, 0.5, 5.0)
    assert steps.relative == v - u
    assert abs(steps.normal_part + steps.tangential_part - steps.relative) < 1e-15
    assert abs(cross(steps.normal_part, n)) < 1e-15
    assert abs(dot(steps.tangential_part, n)) < 1e-15
    assert steps.normal_change == pytest.approx(-2.0 * steps.normal_part, abs=1e-15)
    assert steps.result == v + steps.normal_change + steps.tangential_change
    assert steps.velocity == pytest.approx(steps.result / abs(steps.result) * 5.0, abs=1e-14)
    apart = response_steps(3 + 4j, n, 0j, 0.5, 5.0)
    assert (apart.normal_change, apart.tangential_change, apart.velocity) == (0j, 0j, 3 + 4j)
