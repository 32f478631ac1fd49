"""The first touch of a ball with a ring: every case of the edge list, against dense sampling and 50 digits."""

import cmath
import math

import pytest

from physics import Ball, Feature, Ring, direction, time_of_impact
from tests.support.oracles.impact_oracle import SPINS, TURNS, checked_impact, gap, mirrored_scene, turned_scene

TICK = 1.0 / 240.0
R = 0.25
PADDLE = (10.0, 0.5, 0.3)  # inner radius 9.5, outer 10.5, from -0.3 to 0.3


def paddle(spin=0.0, count=1, phase=0.0):
    """A ring of paddles, the first around the x axis."""
    return Ring(*PADDLE, count, phase, spin)


def wide(spin=0.0):
    """One sector that leaves a gap of 0.4 rad around the negative x axis."""
    return Ring(10.0, 0.5, math.pi - 0.2, 1, 0.0, spin)


def at(radius, angle):
    """A point in polar coordinates."""
    return cmath.rect(radius, angle)


CORNER = at(10.5, 0.3)
ALONG = cmath.rect(1.0, 0.3)
INTO_THE_GAP = 1j * ALONG
SCENES = {
    "outer face, head on": (Ball(12 + 0j, -8 + 0j, R), paddle(), 1.0),
    "outer face, slanting": (Ball(12 + 1j, -8 - 3j, R), paddle(), 1.0),
    "inner face, from the hole": (Ball(5 + 0j, 8 + 0j, R), paddle(), 1.0),
    "inner face, across the hole": (Ball(-12 + 0.5j, 9 + 0j, R), paddle(), 3.0),
    "inner face, through the very centre": (Ball(-12 + 0j, 9 + 0j, R), paddle(), 3.0),
    "inner face, from the very centre": (Ball(0j, 8 + 1j, R), paddle(), 2.0),
    "counter-clockwise end": (Ball(at(10.0, 0.6), at(8.0, 0.6 - math.pi / 2.0), R), paddle(), 1.0),
    "clockwise end": (Ball(at(10.0, -0.6), at(8.0, -0.6 + math.pi / 2.0), R), paddle(), 1.0),
    "outer corner, from outside": (Ball(CORNER + (2 + 1.5j) * ALONG, (-2 - 1.5j) * ALONG * 3, R), paddle(), 1.0),
    "outer corner, off centre": (Ball(CORNER + (2 + 1.7j) * ALONG, (-2 - 1.5j) * ALONG * 3, R), paddle(), 1.0),
    "inner corner": (Ball(at(9.5, 0.3) + (-1 + 0.8j) * ALONG, (1 - 0.8j) * ALONG * 5, R), paddle(), 1.0),
    "outer corner, clockwise": (Ball(at(10.5, -0.3) + (2 - 1.7j), (-2 + 1.5j) * 3, R), paddle(), 1.0),
    "inner corner, clockwise": (Ball(at(9.5, -0.3) + (-1 - 0.8j), (1 + 0.8j) * 5, R), paddle(), 1.0),
    "border of face and corner": (Ball(CORNER + 2 * ALONG, -8 * ALONG, R), paddle(), 1.0),
    "border of end and corner": (Ball(CORNER + 2 * INTO_THE_GAP, -8 * INTO_THE_GAP, R), paddle(), 1.0),
    "border of face and corner, an ulp inside": (Ball(at(12.5, math.nextafter(0.3, 0.0)), -8 * ALONG, R), paddle(), 1.0),
    "border of face and corner, an ulp outside": (Ball(at(12.5, math.nextafter(0.3, 1.0)), -8 * ALONG, R), paddle(), 1.0),
    "past everything": (Ball(12 + 11j, -8 + 0j, R), paddle(), 3.0),
    "through a gap": (Ball(at(13.0, 1.0), at(-8.0, 1.0), R), paddle(0.0, 3), 1.0),
    "second of two rows of paddles": (Ball(at(13.0, 1.0), at(-8.0, 1.02), R), paddle(0.0, 3), 4.0),
    "a ball at rest": (Ball(at(10.0, 0.8), 0j, R), paddle(), 3.0),
    "a ball at rest at the centre": (Ball(0j, 0j, R), paddle(), 3.0),
    "a slow ball in the band": (Ball(at(10.0, 0.5), at(0.05, 2.0), R), paddle(0.0, 3), 3.0),
    "a wide sector's gap, through": (Ball(-13 + 0j, 9 + 0j, R), wide(), 2.0),
    "a wide sector's gap, one end": (Ball(-13 + 1.6j, 9 + 0j, R), wide(), 2.0),
    "a wide sector's gap, from inside": (Ball(-8 + 0j, -5 + 2j, R), wide(), 1.0),
    "a wide sector from the centre": (Ball(0.1j, 3 - 5j, R), wide(), 3.0),
    "a full ring from outside": (Ball(13 + 2j, -9 - 1j, R), Ring(10.0, 0.5, math.pi, 1), 1.0),
    "a full ring from inside, at its seam": (Ball(-5 + 0j, -9 + 0j, R), Ring(10.0, 0.5, math.pi, 1), 1.0),
    "flush neighbours, at the joint": (
        Ball(at(13.0, math.pi / 8.0), at(-9.0, math.pi / 8.0), R),
        Ring(10, 0.5, math.pi / 8, 8),
        1,
    ),
    "a ball too large for the hole": (Ball(-4 + 0.3j, 3 + 0j, 0.8), Ring(1.0, 0.4, 0.7, 2), 3.0),
    "a ball too large for the hole, between": (Ball(0.1 - 4j, 3j, 0.8), Ring(1.0, 0.4, 0.7, 2), 3.0),
    "a ball wider than the sector": (Ball(-5 + 0.2j, 3 + 0j, 2.0), Ring(6.0, 0.1, 0.05, 3), 4.0),
    "half a turn of flight": (Ball(at(10.0, 2.5), at(4.0, 2.5 + math.pi / 2.0), R), paddle(), 10.0),
    "fifty radii in a tick": (Ball(14 + 0.3j, -12.5 / TICK + 0j, R), paddle(), TICK),
}


@pytest.mark.parametrize("turn", TURNS)
@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("name", SCENES)
def test_a_scene_is_right_from_every_side(name, spin, turn):
    """The gap is closed at the time found and open before it; turned or mirrored, it is the same touch."""
    ball, ring, dt = SCENES[name]
    ring = ring._replace(spin=spin)
    plain = time_of_impact(ball, ring, dt)
    turned = checked_impact(*turned_scene(ball, ring, turn), dt)
    mirrored = checked_impact(*mirrored_scene(*turned_scene(ball, ring, turn)), dt)
    if plain is None:
        assert turned is None
        assert mirrored is None
        return
    assert turned is not None
    assert mirrored is not None
    by = cmath.rect(1.0, turn)
    for seen, normal in ((turned, turned.contact.normal / by), (mirrored, mirrored.contact.normal.conjugate() / by)):
        assert seen.time == pytest.approx(plain.time, abs=1e-10)
        assert abs(normal - plain.contact.normal) < 1e-9


EXPECTED = {
    "outer face, head on": (1.25 / 8.0, Feature.OUTER_FACE),
    "inner face, from the hole": (4.25 / 8.0, Feature.INNER_FACE),
    "inner face, through the very centre": ((12.0 + 9.25) / 9.0, Feature.INNER_FACE),
    "inner face, from the very centre": (9.25 / math.sqrt(65.0), Feature.INNER_FACE),
    "counter-clockwise end": (10.0 * math.sin(0.3) / 8.0 / math.cos(0.3) - R / 8.0 / math.cos(0.3), Feature.END),
    "outer corner, from outside": ((2.5 - R) / 7.5, Feature.CORNER),
    "border of face and corner": ((2.0 - R) / 8.0, None),
    "border of end and corner": ((2.0 - R) / 8.0, None),
    "a full ring from inside, at its seam": (4.25 / 9.0, Feature.INNER_FACE),
    "flush neighbours, at the joint": (2.25 / 9.0, None),
    "fifty radii in a tick": (None, Feature.OUTER_FACE),
}


@pytest.mark.parametrize("name", EXPECTED)
def test_a_scene_at_rest_has_its_closed_form(name):
    """Worked out by hand."""
    found = time_of_impact(*SCENES[name])
    time, feature = EXPECTED[name]
    assert time is None or found.time == pytest.approx(time, abs=1e-13)
    assert feature is None or found.contact.feature == feature


@pytest.mark.parametrize("name", ["past everything", "through a gap", "a ball at rest", "a wide sector's gap, through"])
def test_a_scene_at_rest_without_a_touch(name):
    """Nothing is hit where nothing is in the way."""
    ball, ring, dt = SCENES[name]
    assert time_of_impact(ball, ring, min(dt, 0.8)) is None


@pytest.mark.parametrize("dt", [-1.0, -5e-324, math.nan, math.inf, -math.inf])
def test_a_time_that_is_none_is_refused(dt):
    """Negative, nan and infinite dt have no meaning."""
    with pytest.raises(ValueError, match="dt must be finite"):
        time_of_impact(Ball(12 + 0j, -8 + 0j, R), paddle(), dt)


def test_in_no_time_only_what_touches_and_approaches_is_met():
    """dt = 0 is a question about now."""
    for spin in SPINS:
        assert time_of_impact(Ball(12 + 0j, -8 + 0j, R), paddle(spin), 0.0) is None
        assert time_of_impact(Ball(10.75 + 0j, -8 + 0j, R), paddle(spin), 0.0).time == 0.0
        assert time_of_impact(Ball(10.75 + 0j, 8 + 0j, R), paddle(spin), 0.0) is None
        beside = at(10.0, 0.3) + INTO_THE_GAP * R
        assert time_of_impact(Ball(beside, -20 * INTO_THE_GAP, R), paddle(spin), 0.0).time == 0.0
        assert time_of_impact(Ball(beside, 20 * INTO_THE_GAP, R), paddle(spin), 0.0) is None


@pytest.mark.parametrize("spin", SPINS)
def test_touching_and_approaching_is_an_impact_now(spin):
    """On a face, an end and a corner."""
    places = [
        (10.75 + 0j, -1 + 0j),
        (9.25 + 0j, 1 + 0j),
        (at(10.0, 0.3) + INTO_THE_GAP * R, -20 * INTO_THE_GAP),
        (CORNER + (0.6 + 0.8j) * ALONG * R, -20 * (0.6 + 0.8j) * ALONG),
    ]
    for p, v in places:
        found = checked_impact(Ball(p, v, R), paddle(spin), TICK)
        assert found.time < 1e-12


@pytest.mark.parametrize("spin", SPINS)
def test_touching_and_separating_is_none(spin):
    """However the ball came to touch, it is not turned back."""
    places = [
        (10.75 + 0j, 1 + 0j),
        (9.25 + 0j, -1 + 0j),
        (at(10.0, 0.3) + INTO_THE_GAP * R, 20 * INTO_THE_GAP),
        (CORNER + (0.6 + 0.8j) * ALONG * R, 20 * (0.6 + 0.8j) * ALONG),
    ]
    for p, v in places:
        assert checked_impact(Ball(p, v, R), paddle(spin), TICK) is None


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize(
    ("p", "v"),
    [
        (10.2 + 0j, -1 + 0j),
        (10.6 + 0j, -1 + 0j),
        (9.4 + 0j, 1 + 0j),
        (at(10.0, 0.29), -INTO_THE_GAP * 20),
        (at(10.2, 0.1), -ALONG * 20),
    ],
)
def test_a_ball_inside_meets_the_sector_only_while_it_approaches(p, v, spin):
    """Inside or overlapping: an impact now if it goes deeper, none with this sector if it leaves."""
    ring = paddle(spin)
    deeper, leaving = time_of_impact(Ball(p, v, R), ring, TICK), time_of_impact(Ball(p, -v, R), ring, TICK)
    assert (deeper is None) != (leaving is None)
    assert (deeper or leaving).time == 0.0


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("overlap", [1e-11, 1e-6, 0.1, R])
def test_a_ball_that_overlaps_an_end_meets_it_only_while_it_approaches(overlap, spin):
    """Its centre beside the sector, between the corners or beyond one."""
    for p, normal in (
        (at(10.0, 0.3) + INTO_THE_GAP * (R - overlap * 0.999), INTO_THE_GAP),
        (CORNER + (0.6 + 0.8j) * ALONG * (R - overlap * 0.999), (0.6 + 0.8j) * ALONG),
    ):
        assert time_of_impact(Ball(p, -20 * normal, R), paddle(spin), TICK / 4.0).time == 0.0
        assert time_of_impact(Ball(p, 20 * normal, R), paddle(spin), TICK / 4.0) is None


@pytest.mark.parametrize("rate", [1e-6, 1e-3, 0.1, 0.4])
def test_a_ball_that_leaves_a_resting_end_slowly_does_not_meet_it(rate):
    """It touches, and separates at a small part of its speed: beside the straight end, and off a corner."""
    for p, normal in ((at(10.0, 0.3) + INTO_THE_GAP * R, INTO_THE_GAP), (CORNER + 1j * ALONG * R, 1j * ALONG)):
        along = -1j * normal
        ball = Ball(p, normal * rate + along * 5.0, R)
        assert time_of_impact(ball, paddle(), TICK) is None
        assert time_of_impact(ball._replace(velocity=along * 5.0 - normal * rate), paddle(), TICK).time == pytest.approx(
            0.0, abs=1e-9
        )


@pytest.mark.parametrize("spin", SPINS)
def test_a_ball_that_covers_the_whole_hole_meets_what_it_overlaps(spin):
    """Wherever it goes from the middle of a hole too small for it, it goes deeper into a sector."""
    ring = Ring(1.0, 0.4, 0.7, 2, 0.0, spin)
    for way in (0.0, 0.3, 2.9):
        assert time_of_impact(Ball(at(0.05, way), at(3.0, way), 0.8), ring, TICK).time == 0.0


def test_a_ball_inside_near_an_end_leaves_through_the_end():
    """The least depth decides, so flying along the band towards the end is leaving."""
    ball = Ball(at(10.0, 0.29), INTO_THE_GAP * 20, R)
    assert time_of_impact(ball, paddle(), TICK) is None
    assert time_of_impact(ball._replace(velocity=-ball.velocity), paddle(), TICK).contact.feature == Feature.END


@pytest.mark.parametrize("spin", [1.3, -1.3])
@pytest.mark.parametrize("run", [0.0, 1e-9, 1e-8, 1e-7])
def test_a_ball_left_overlapping_an_end_by_rounding_is_let_go(spin, run):
    """It leaves slowly, sliding from the corner over to the straight end: where the two meet it had been held."""
    ring = paddle(spin)
    for overlap in (0.0, 1e-14, 1e-12, 2.5e-11):
        p = CORNER + (run + 1j * (R - overlap)) * ALONG
        surface = 1j * spin * (p - 1j * ALONG * R)
        ball = Ball(p, surface + (-1.0 + 1e-4j) * ALONG, R)
        assert time_of_impact(ball, ring, 3e-7) is None


@pytest.mark.parametrize("spin", SPINS)
def test_flying_along_an_inner_face_is_touching_it(spin):
    """A tangent of a concave arc runs into the arc: the ball that touches and flies straight on would be inside.

    The rate of the gap is 0 here, and such a ball was let through.
    """
    full = Ring(10.0, 0.5, math.pi, 1, 0.0, spin)
    assert checked_impact(Ball(9.25 + 0j, 8j, R), full, TICK).time == 0.0
    assert checked_impact(Ball(9.25 + 0j, 8j, R), paddle(spin), TICK).time == 0.0


@pytest.mark.parametrize("inward", [0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3])
def test_a_ball_left_overlapping_by_rounding_does_not_roll_through_an_inner_face(inward):
    """It leaves so slowly that it never gets out of the overlap: it is met where it turns outward."""
    ball = Ball(9.25 + 1e-14 + 0j, complex(-inward, 8.0), R)
    full = Ring(10.0, 0.5, math.pi, 1)
    found = time_of_impact(ball, full, 1.0)
    assert found is not None
    there = ball.moved(found.time)
    assert abs(there.position) - 9.25 < 1e-12


@pytest.mark.parametrize("miss", [0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-9, -1e-9, 1e-4, -1e-4])
@pytest.mark.parametrize("spin", SPINS)
def test_a_graze_is_a_touch_or_a_miss_never_a_nan(spin, miss):
    """Tangents of an outer face and of corners at rest and turning: who touches deeper than the tolerance is found."""
    face = Ball(complex(10.75 + miss, -1.0), 8j, R)
    corner = Ball(CORNER + (R + miss) * ALONG - INTO_THE_GAP, 8 * INTO_THE_GAP, R)
    for ball in (face, corner):
        found = checked_impact(ball, paddle(spin), 0.4)
        assert found is None or math.isfinite(found.time)
    if spin == 0.0 and abs(miss) >= 1e-9:
        assert (time_of_impact(face, paddle(), 0.4) is not None) == (miss < 0.0)
        assert (time_of_impact(corner, paddle(), 0.4) is not None) == (miss < 0.0)


def test_a_ball_overtaken_by_a_fast_end_is_hit_by_it():
    """The end's 12 units a second beat the ball's 8: a search that held the ring still would see the ball get away."""
    ball = Ball(at(10.0, 0.35), at(8.0, 0.35 + math.pi / 2.0), R)
    found = checked_impact(ball, paddle(1.2), 1.0)
    assert found.contact.feature in {Feature.END, Feature.CORNER}
    assert time_of_impact(ball, paddle(0.0), 0.2) is None


def test_an_end_that_sweeps_more_than_its_sector_in_a_tick_meets_the_ball_once_and_in_time():
    """The sector is a tenth of what it sweeps: start and end of the tick show nothing."""
    ring = Ring(10.0, 0.5, 0.02, 1, -0.2, 0.4 / TICK)
    ball = Ball(10.0 + 0j, 0j, 0.1)
    assert gap(ball, ring, 0.0, [0]) > 0.0
    assert gap(ball, ring, TICK, [0]) > 0.0
    found = checked_impact(ball, ring, TICK)
    assert found.time == pytest.approx((0.18 - math.asin(0.1 / 10.0)) / ring.spin, rel=1e-2)


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("turn", [0.5, 1.0, 2.0 * math.pi])
def test_a_whole_turn_in_a_tick_hits_whatever_rests_in_the_band(turn, sense):
    """Wherever the ball rests, up to a full turn of the paddle."""
    ring = Ring(10.0, 0.5, 0.3, 1, 0.0, sense * turn / TICK)
    for angle in (0.5, 1.0, 2.0, math.pi, -2.0, -0.5):
        found = checked_impact(Ball(at(10.2, angle), 0j, R), ring, TICK)
        swept = (angle * sense) % math.tau - 0.3 < turn
        assert (found is not None) == swept


@pytest.mark.parametrize("slots", [(1, 1, 1, 1), (0, 1, 1, 1), (1, 0, 1, 0), (0, 0, 0, 1), (0, 0, 0, 0)])
@pytest.mark.parametrize("spin", SPINS)
def test_empty_slots_are_not_there(slots, spin):
    """Only living sectors are met, whichever way the ball goes."""
    ring, narrow = Ring(5.0, 0.5, 0.7, 4, 0.0, spin), Ring(5.0, 0.5, 0.1, 4, 0.0, spin)
    for k in range(12):
        checked_impact(Ball(at(0.1, k), at(6.0, 0.6 * k), R), ring, 2.0, slots)
        checked_impact(Ball(at(5.0, math.pi / 2.0 * k + 0.7), at(6.0, 1.9 * k), 0.1), narrow, 0.5, slots)


def test_of_twelve_hundred_slots_the_one_living_is_found():
    """From the centre no gap has a near end: the search looks at every slot, once."""
    alive = [0] * 1200
    alive[600] = 1
    ring = Ring(10.0, 0.5, math.pi / 1200, 1200)
    assert checked_impact(Ball(0j, -8 + 0j, R), ring, 2.0, alive).slot == 600
    assert checked_impact(Ball(0j, 8 + 0j, R), ring, 2.0, alive) is None


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("count", [1, 2, 3, 5, 7, 8, 12, 16])
def test_the_joints_of_a_closed_ring_have_no_corners(count, spin):
    """Flush neighbours leave no gap, however the joint's angle is rounded: in one of ten places it is in neither of them."""
    for k in range(200):
        ring = Ring(10.0, 0.5, math.pi / count, count, 0.1 * k, 0.0)
        joint = direction(ring.phase + math.pi / count * (2 * (k % count) + 1))
        found = time_of_impact(Ball(joint * 10.75, joint * -9.0, R), ring._replace(spin=spin), TICK)
        assert found.contact.feature == Feature.OUTER_FACE


def test_a_gap_of_exactly_two_radii():
    """The chord decides: an ulp more than the ball passes or touches; a thousandth less stops it."""
    half_gap = math.asin(R / 10.0)
    for spare, passes in ((1e-3, True), (1e-15, None), (0.0, None), (-1e-3, False)):
        ring = Ring(10.0, 1e-9, math.pi - half_gap * (1.0 + spare), 1)
        found = checked_impact(Ball(-12 + 0j, 8 + 0j, R), ring, 0.6)
        if passes is not None:
            assert (found is None) == passes


def test_both_ends_of_a_gap_at_once_are_answered_by_the_lower_slot():
    """A tie has one winner."""
    ring = Ring(10.0, 0.5, math.pi / 4.0 - 0.01, 4, math.pi / 4.0)
    found = checked_impact(Ball(12 + 0j, -8 + 0j, R), ring, 1.0)
    assert found.slot == 0
    assert found.contact.feature == Feature.CORNER


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("tiny", [1e-35, 1e-30, 1e-20])
def test_the_smallest_speeds_divide_by_nothing(tiny, spin):
    """The ball is at rest for all practical purposes; a paddle still comes and meets it."""
    for v in (complex(tiny, 0.0), complex(-tiny, tiny)):
        found = checked_impact(Ball(at(10.0, 0.5), v, R), paddle(spin), 0.5)
        assert (found is not None) == (spin > 0.0)
        checked_impact(Ball(complex(tiny, tiny), v, R), paddle(spin), 0.5)


@pytest.mark.parametrize("spin", [5e-324, 1e-300, 1e-12])
def test_the_smallest_spins_are_as_good_as_none(spin):
    """Nothing divides by them."""
    ball = Ball(at(10.0, 0.6), at(8.0, 0.6 - math.pi / 2.0), R)
    assert checked_impact(ball, paddle(spin), 1.0).time == pytest.approx(time_of_impact(ball, paddle(), 1.0).time, abs=1e-11)
