"""Balls and rings: what their constructors refuse, and where a ring's sectors are."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physics import Ball, Ring, min_difference, normalize_angle
from physics.tolerances import ANGLE_GRID
from physics.vectors import dot
from tests.support.strategies import angles, points, reals, rings, velocities

NAN, INF = math.nan, math.inf
BALL = {"position": 1 + 2j, "velocity": 3 - 4j, "radius": 0.5}
RING = {"radius": 10.0, "half_width": 0.5, "half_angle": 0.3, "count": 3, "phase": 1.0, "spin": -2.0, "friction": 0.5}

NOT_FINITE = [NAN, INF, -INF]
NOT_A_POINT = [complex(x, y) for x in (0.0, *NOT_FINITE) for y in (0.0, *NOT_FINITE) if (x, y) != (0.0, 0.0)]
TOO_LARGE = [1.01e35, 1e200, 1.7e308, 10**400]
WRONG_BALL = [
    *[("position", bad) for bad in [*NOT_FINITE, *NOT_A_POINT, 1.01e35, -1e200j, 1e35 + 1e35j]],
    *[("velocity", bad) for bad in [*NOT_FINITE, *NOT_A_POINT, 1.01e35, -1e200j, 1e35 + 1e35j]],
    *[("radius", bad) for bad in [*NOT_FINITE, *TOO_LARGE, 0.0, -0.0, 0, -5e-324, 5e-324, 0.99e-35, -0.5]],
]
WRONG_RING = [
    *[("radius", bad) for bad in [*NOT_FINITE, *TOO_LARGE, 0.0, -0.0, 0, -5e-324, 0.99e-35, -10.0]],
    *[("half_width", bad) for bad in [*NOT_FINITE, *TOO_LARGE, 0.0, -0.0, 0.99e-35, -0.5, 10.0, 10.5]],
    *[("half_angle", bad) for bad in [*NOT_FINITE, *TOO_LARGE, 0.0, -0.0, -0.3, 1.0472, 4.0]],
    *[("count", bad) for bad in [*NOT_FINITE, 0, -1, -3, 3.0, 2.5, True, False, None, "3", 10**400]],
    *[("phase", bad) for bad in NOT_FINITE],
    *[("spin", bad) for bad in [*NOT_FINITE, 1.01e35, -1.01e35, 10**400, -(10**400)]],
    *[("friction", bad) for bad in [*NOT_FINITE, -5e-324, -0.5, math.nextafter(1.0, 2.0), 2.0]],
]


@pytest.mark.parametrize(("field", "bad"), WRONG_BALL, ids=str)
def test_a_ball_names_the_field_it_refuses(field, bad):
    """Not a number, infinite, too large, or a radius that is none: ValueError, the field's name first."""
    with pytest.raises(ValueError, match=rf"^{field} must "):
        Ball(**BALL | {field: bad})


@pytest.mark.parametrize(("field", "bad"), WRONG_RING, ids=str)
def test_a_ring_names_the_field_it_refuses(field, bad):
    """As a ball does; also sectors that overlap, a hole of size 0, and a count that is no whole number."""
    with pytest.raises(ValueError, match=rf"^{field} must "):
        Ring(**RING | {field: bad})


@pytest.mark.parametrize(("field", "bad"), [case for case in [*WRONG_BALL, *WRONG_RING] if case[0] != "phase"], ids=str)
def test_a_replaced_field_is_checked_as_in_the_constructor(field, bad):
    """`_replace(radius=-1)` raises the same ValueError as `Ball(..., radius=-1)`."""
    value = Ball(**BALL) if field in BALL and (field, bad) in WRONG_BALL else Ring(**RING)
    with pytest.raises(ValueError, match=rf"^{field} must "):
        value._replace(**{field: bad})


def test_a_replaced_phase_is_normalised():
    """Onto [0, 2 pi) and the angle grid, as in the constructor."""
    assert Ring(**RING)._replace(phase=7.0) == Ring(**RING | {"phase": 7.0})


@pytest.mark.parametrize("bad", [NAN, INF, -INF, 1.01e35])
def test_a_ring_is_not_steered_to_a_spin_that_it_could_not_have(bad):
    """`steered` checks the spin as the constructor does, and keeps everything else."""
    ring = Ring(**RING)
    with pytest.raises(ValueError, match=r"^spin must "):
        ring.steered(bad)
    assert ring.steered(0.25) == ring._replace(spin=0.25)


@pytest.mark.parametrize("spin", [5e-324, -1e-300, 0.99e-35])
def test_a_spin_too_small_to_reckon_with_is_stored_as_none(spin):
    """Its third power would underflow."""
    assert Ring(**RING | {"spin": spin}).spin == 0.0


@pytest.mark.parametrize(("field", "bad"), [*WRONG_BALL, *WRONG_RING][::7], ids=str)
def test_the_message_shows_the_value(field, bad):
    """Whoever wrote it must be able to find it."""
    shape = Ball if field in {"position", "velocity"} else Ring
    with pytest.raises(ValueError, match=rf"^{field} must ") as caught:
        shape(**(BALL if shape is Ball else RING) | {field: bad})
    assert str(bad) in str(caught.value)


@pytest.mark.parametrize("field", BALL)
def test_text_is_no_part_of_a_ball(field):
    """Python's own refusal: never a ball with text in it."""
    with pytest.raises((TypeError, AttributeError)):
        Ball(**BALL | {field: "1"})


@pytest.mark.parametrize("field", [field for field in RING if field != "count"])
def test_text_is_no_part_of_a_ring(field):
    """Python's own refusal: never a ring with text in it."""
    with pytest.raises(TypeError):
        Ring(**RING | {field: "1"})


def test_the_borders_that_are_allowed():
    """A still ball at the origin, a friction of 0 and of 1, a closed ring, the largest sizes, the least radius."""
    assert Ball(0j, 0j, 1e-35).radius == 1e-35
    assert Ball(1e35, -1e35j, 1e35).position == 1e35
    assert Ball(1e-300 + 0j, 1e-35j, 1.0).velocity == 1e-35j
    assert Ring(10.0, 0.5, math.pi, 1).half_angle == math.pi
    assert Ring(10.0, math.nextafter(10.0, 0.0), 0.1, 1).inner_radius > 0.0
    assert [Ring(10.0, 0.5, 0.1, 3, friction=mu).friction for mu in (0.0, 1.0)] == [0.0, 1.0]
    assert Ring(1e35, 1e-35, 0.1, 1, spin=-1e35).spin == -1e35


@given(st.integers(1, 10**6))
def test_a_closed_ring_may_be_written_with_the_rounding_of_degrees(count):
    """180 / count degrees, converted, may exceed pi / count by a rounding; it is stored as pi / count, never as more."""
    ring = Ring(10.0, 0.5, math.radians(180.0 / count) * (1.0 + 4e-16), count)
    assert ring.half_angle <= math.pi / count
    assert math.isclose(ring.half_angle, math.pi / count, rel_tol=1e-15)


def test_whole_numbers_are_stored_as_floats():
    """An int or a float makes the same ball and the same ring, to the type: a hash of the state sees no difference."""
    ball, ring = Ball(1, 2, 3), Ring(10, 2, 1, 3, 1, 2, 1)
    assert [type(part) for part in ball] == [complex, complex, float]
    assert [type(part) for part in ring] == [float, float, float, int, float, float, float]
    assert ball == Ball(1 + 0j, 2 + 0j, 3.0)
    assert ring == Ring(10.0, 2.0, 1.0, 3, 1.0, 2.0, 1.0)


def test_balls_and_rings_cannot_be_changed():
    """They are values."""
    with pytest.raises(AttributeError):
        Ball(**BALL).radius = 1.0
    with pytest.raises(AttributeError):
        Ring(**RING).extra = 1.0


@given(points(), velocities(10.0), reals(0.0, 10.0))
def test_a_moved_ball_flew_straight(position, velocity, time):
    """Its velocity and its radius are what they were."""
    moved = Ball(position, velocity, 0.5).moved(time)
    assert moved == Ball(position + velocity * time, velocity, 0.5)
    assert type(moved) is Ball


@given(rings())
def test_a_ring_reaches_a_half_width_to_both_sides(ring):
    """The band is as wide as two half widths, the radius in its middle."""
    assert 0.0 < ring.inner_radius < ring.radius < ring.outer_radius
    assert math.isclose(ring.outer_radius - ring.inner_radius, 2.0 * ring.half_width, rel_tol=1e-12)
    assert math.isclose(ring.outer_radius + ring.inner_radius, 2.0 * ring.radius, rel_tol=1e-15)


@given(rings(), st.integers(0, 11))
def test_slots_are_evenly_spaced(ring, slot):
    """From each slot to the next it is a count-th of a turn counter-clockwise, also from the last to the first."""
    slot %= ring.count
    here, there = ring.angle(slot), ring.angle((slot + 1) % ring.count)
    assert 0.0 <= here < math.tau
    assert min_difference(there, normalize_angle(here + math.tau / ring.count)) < 4e-15
    assert min_difference(ring.angle(0), ring.phase) == 0.0


@given(rings(), st.integers(0, 11))
def test_a_mirrored_ring_has_mirrored_slots_to_the_bit(ring, slot):
    """Slot k of a ring and slot -k of its mirror image have angles that add up to 0 or to 2 pi exactly."""
    slot %= ring.count
    mirrored = Ring(*ring[:4], -ring.phase)
    assert ring.angle(slot) + mirrored.angle(-slot % ring.count) in {0.0, math.tau}


@given(angles())
def test_a_phase_lies_in_the_range_and_its_negation_is_exact(phase):
    """Mirroring a ring twice is exact: -phase loses nothing."""
    ring = Ring(10.0, 0.5, 0.3, 3, phase)
    assert 0.0 <= ring.phase < math.tau
    assert (ring.phase * ANGLE_GRID).is_integer()
    assert min_difference(ring.phase, phase) <= 0.5 / ANGLE_GRID
    mirrored = Ring(10.0, 0.5, 0.3, 3, -ring.phase)
    assert ring.phase + mirrored.phase in {0.0, math.tau}
    assert Ring(10.0, 0.5, 0.3, 3, -mirrored.phase) == ring


@pytest.mark.parametrize("phase", [-1e-17, -5e-324, math.tau, -math.tau, math.nextafter(math.tau, 0.0) + 1e-15])
def test_a_phase_a_hair_from_the_polar_axis_is_zero(phase):
    """Neither 2 pi nor a negative number is ever stored."""
    assert Ring(10.0, 0.5, 0.3, 3, phase).phase == 0.0


@given(rings(), reals(0.0, 10.0))
def test_a_turned_ring_turned_by_spin_times_time(ring, time):
    """And nothing else changed."""
    turned = ring.turned(time)
    assert min_difference(turned.phase, normalize_angle(ring.phase + ring.spin * time)) < 1e-14
    assert 0.0 <= turned.phase < math.tau
    assert turned._replace(phase=ring.phase) == ring
    assert type(turned) is Ring


@pytest.mark.parametrize(
    ("phase", "spin"), [(math.tau - 1.0, 1.0), (1.0, -1.0), (math.tau - 3.0, 3.0), (3.0, -3.0), (0.0, math.tau)]
)
def test_a_ring_that_turns_to_the_very_axis_has_phase_zero(phase, spin):
    """Not 2 pi, whichever way it came."""
    assert Ring(10.0, 0.5, 0.3, 3, phase, spin).turned(1.0).phase == 0.0


@given(rings(), st.lists(reals(0.0, 10.0), min_size=1, max_size=5))
def test_a_mirrored_ring_turns_as_the_mirror_image_to_the_bit(ring, times):
    """After any number of turns, however long: the phases still add up to 0 or to 2 pi exactly."""
    mirrored = Ring(*ring[:4], -ring.phase, -ring.spin, ring.friction)
    for time in times:
        ring, mirrored = ring.turned(time), mirrored.turned(time)
        assert 0.0 <= ring.phase < math.tau
        assert (ring.phase * ANGLE_GRID).is_integer()
        assert ring.phase + mirrored.phase in {0.0, math.tau}


@pytest.mark.parametrize("spin", [1.7, -1.7, 1e-9])
def test_a_hundred_thousand_ticks_turn_a_ring_by_their_sum(spin):
    """Each tick loses less than the grid's half line: what piles up is below a billionth of a radian."""
    ring = Ring(10.0, 0.5, 0.3, 3, 1.0, spin)
    for _ in range(100_000):
        ring = ring.turned(1.0 / 240.0)
    assert 0.0 <= ring.phase < math.tau
    assert min_difference(ring.phase, normalize_angle(1.0 + spin * (100_000 / 240.0))) < 1e-9


@given(rings(), points())
def test_the_surface_moves_across_the_radius_at_spin_times_distance(ring, point):
    """Counter-clockwise for a positive spin."""
    velocity = ring.surface_velocity(point)
    assert abs(dot(velocity, point)) <= 1e-15 * abs(velocity) * abs(point)
    assert math.isclose(abs(velocity), abs(ring.spin) * abs(point), rel_tol=1e-14, abs_tol=1e-150)
    assert ring.spin * (point.conjugate() * velocity).imag >= 0.0
