"""For how long a ball touches nothing: never longer than it is so, and a tick that is spared the search is the same tick."""

import cmath
import math
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics import PERMANENT, Arena, Ball, Ring, advance
from physics.free_flight import clear_time, may_be_steered
from tests.support.oracles.impact_oracle import gap
from tests.support.strategies import balls, rings
from tools.fuzz.arenas import TICK, random_case, steered, with_lost_balls_back

SPEED = 8.0
PADDLES = Ring(10.0, 0.5, 0.3, 3, 0.0, 0.5)
BRICKS = Ring(4.0, 0.5, 0.2, 8)


def arena(position, velocity=SPEED + 0j, rings=(PADDLES, BRICKS)):
    """One ball among whole rings."""
    return Arena((Ball(position, velocity, 0.25),), rings, tuple((PERMANENT,) * ring.count for ring in rings))


def slots_of(alive):
    """The slots that are not empty."""
    return [slot for slot, layers in enumerate(alive) if layers]


@settings(max_examples=300)
@given(balls(), rings(), st.floats(0.001, 3.0), st.data())
def test_nothing_is_touched_while_it_is_clear(ball, ring, horizon, data):
    """However a ring that turns is turned meanwhile, as long as its rim is no faster than it or the ball was."""
    alive = data.draw(st.lists(st.integers(0, 1), min_size=ring.count, max_size=ring.count))
    clear = clear_time(ball, [ring], [alive], horizon)
    assert 0.0 <= clear <= horizon
    top = max(abs(ring.spin), abs(ball.velocity) / ring.outer_radius) if ring.spin else 0.0
    phase, time = ring.phase, 0.0
    for share in data.draw(st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=4)):
        turning = ring._replace(phase=phase, spin=share * top)
        for k in range(30):
            later = k / 30.0 * clear / 4.0
            if clear > 0.0 and any(alive):
                moved = ball._replace(position=ball.position + ball.velocity * time)
                assert gap(moved, turning, later, slots_of(alive)) > 0.0
        time += clear / 4.0
        phase += turning.spin * clear / 4.0


@pytest.mark.parametrize("index", range(150))
def test_no_end_can_catch_up_with_a_ball_while_it_is_clear(index):
    """In a gap of a wide ring, at every moment and at every phase that the ring can have reached by then."""
    chance = Random(f"clear {index}")
    ring = Ring(10.0, chance.choice((0.5, 5.0, 8.0)), chance.uniform(0.1, 0.6), 3, chance.uniform(0.0, math.tau), 0.1)
    away = chance.uniform(0.0, 0.2) if index % 2 else chance.uniform(0.0, math.tau / 3.0 - 2.0 * ring.half_angle)
    bearing = ring.phase + chance.choice((-1, 1)) * (ring.half_angle + away)
    distance = chance.uniform(ring.inner_radius, ring.outer_radius)
    ball = Ball(cmath.rect(distance, bearing), cmath.rect(SPEED, chance.uniform(0.0, math.tau)), 0.05)
    clear, top = clear_time(ball, [ring], [(1, 1, 1)], 2.0), SPEED / ring.outer_radius
    for k in range(1, 17) if clear > 0.0 else ():
        time = clear * k / 16.0 * (1.0 - 1e-9)
        for turn in range(-6, 7):
            turned = ring._replace(phase=ring.phase + top * time * turn / 6.0, spin=0.0)
            assert gap(ball, turned, time, range(3)) > 0.0


@pytest.mark.parametrize("side", [-1, 1])
def test_a_ball_that_flies_away_from_an_end_is_clear_of_it(side):
    """It moves around the centre almost as fast as the ring may turn, and leaves the band before the end can reach it."""
    bearing = side * (PADDLES.half_angle + 0.075)
    ball = Ball(cmath.rect(10.0, bearing), cmath.rect(SPEED, bearing + side * math.pi / 2.0), 0.25)
    assert clear_time(ball, [PADDLES], [(1, 1, 1)], 3.0) == 3.0
    towards = ball._replace(velocity=-ball.velocity)
    assert clear_time(towards, [PADDLES], [(1, 1, 1)], 3.0) == pytest.approx(0.05 / (SPEED / 10.5 + SPEED / 10.0), rel=0.05)


@pytest.mark.parametrize("bearing", [0.0, 1.0, 2.6, 3.0])
def test_the_order_in_which_rings_are_asked_decides_nothing(bearing):
    """The free flight is the same to within rounding, whichever ring is touched first."""
    ball = Ball(6 + 0j, cmath.rect(SPEED, bearing), 0.25)
    one, other = [clear_time(ball, (PADDLES, BRICKS), ((1,) * 3, (1,) * 8), 3.0, [0, 0], order) for order in ((0, 1), (1, 0))]
    assert one == pytest.approx(other, rel=1e-12)
    assert 0.0 < one < 3.0


@settings(max_examples=300)
@given(balls(), rings(), st.floats(0.001, 3.0), st.data())
def test_a_ring_that_keeps_its_spin_is_clear_until_the_very_touch(ball, ring, horizon, data):
    """Nothing is touched before; and where the time ends early, something is touched then, to within the margin."""
    alive = data.draw(st.lists(st.integers(0, 1), min_size=ring.count, max_size=ring.count))
    clear = clear_time(ball, [ring], [alive], horizon, [0])
    assert 0.0 <= clear <= horizon
    if not any(alive):
        assert clear == horizon
        return
    for k in range(60):
        if clear > 0.0:
            assert gap(ball, ring, k / 60.0 * clear, slots_of(alive)) > 0.0
    if clear < horizon and abs(ring.spin) * horizon <= 1000.0:
        assert gap(ball, ring, clear, slots_of(alive)) < 1e-6 * (ring.outer_radius + abs(ball.velocity) * horizon)


@given(balls(), rings(), st.floats(0.001, 3.0))
def test_a_ball_that_touches_has_no_time(ball, ring, horizon):
    """Nor has one that overlaps, anywhere in the material."""
    if gap(ball, ring, 0.0, range(ring.count)) <= 0.0:
        assert clear_time(ball, [ring], [(1,) * ring.count], horizon) == 0.0
        assert clear_time(ball, [ring], [(1,) * ring.count], horizon, [0]) == 0.0


@pytest.mark.parametrize("spin", [0.0, 0.5, -0.5])
def test_a_ball_in_free_flight_is_clear_until_it_enters_a_band(spin):
    """To within the margin: of a sector that it flies straight at, as long as the way takes."""
    ball = Ball(6 + 0j, SPEED + 0j, 0.25)
    clear = clear_time(ball, [PADDLES._replace(spin=spin)], [(1, 1, 1)], 3.0)
    assert clear == pytest.approx((9.25 - 6.0) / SPEED, abs=1e-7)
    assert clear < (9.25 - 6.0) / SPEED


def test_a_ball_that_crosses_a_wide_gap_is_clear_all_the_way():
    """Between two paddles, out of the arena: no end can come near it in the time."""
    ball = Ball(cmath.rect(6.0, math.pi / 3.0), cmath.rect(SPEED, math.pi / 3.0), 0.25)
    assert clear_time(ball, [PADDLES], [(1, 1, 1)], 3.0) == 3.0


def test_a_ball_between_two_ends_is_clear_until_the_nearer_may_come():
    """Flying straight out: only the ring's own turning brings an end to it, taken as fast as the ball is at the rim."""
    away = 1.0
    ball = Ball(cmath.rect(10.0, 0.3 + away), cmath.rect(SPEED, 0.3 + away), 0.25)
    clear = clear_time(ball, [PADDLES._replace(half_width=9.0, spin=0.1)], [(1, 1, 1)], 3.0)
    seen = math.asin(0.025)
    assert clear == pytest.approx((min(away, math.tau / 3.0 - 0.6 - away) - seen) * 19.0 / SPEED, rel=0.01)


def test_what_is_not_there_is_not_in_the_way():
    """Empty slots, and rings that are out of reach."""
    ball = Ball(6 + 0j, SPEED + 0j, 0.25)
    assert clear_time(ball, [PADDLES], [(0, 0, 0)], 1.0) == 1.0
    assert clear_time(ball, [], [], 1.0) == 1.0
    assert clear_time(Ball(100j, SPEED * 1j, 0.25), [PADDLES, BRICKS], [(1,) * 3, (1,) * 8], 1.0) == 1.0


@pytest.mark.parametrize("position", [0.1 + 0j, 0j, 5e-324 + 0j])
def test_a_ball_over_the_centre_of_its_ring_is_not_clear(position):
    """It may cover every angle."""
    ring = Ring(1.0, 0.9, 0.1, 2)
    assert clear_time(Ball(position, 1j, 0.5), [ring], [(1, 1)], 1.0) == 0.0


def test_a_flight_too_far_to_reckon_is_not_known():
    """Squares of its way would overflow."""
    assert clear_time(Ball(9 + 0j, 1e30 + 0j, 0.25), [PADDLES], [(1, 1, 1)], 1e10) == 0.0
    assert advance(arena(6 + 0j), 1e300, SPEED).arena.rings[1] is BRICKS


@pytest.mark.parametrize(
    ("change", "may"),
    [
        ({"spin": 0.0}, True),
        ({"spin": -0.7}, True),
        ({"spin": SPEED / 10.5}, True),
        ({"spin": 1.01 * SPEED / 10.5}, False),
        ({"spin": -0.5, "phase": 0.1}, False),
        ({"count": 2}, False),
        ({"half_angle": 0.31}, False),
        ({"half_width": 0.4}, False),
        ({"radius": 9.9}, False),
        ({"friction": 0.5}, True),
    ],
)
def test_a_turning_ring_may_be_steered_and_nothing_else(change, may):
    """Up to the speed of the slowest ball at its rim, or as fast as it was."""
    both = (Ball(6 + 0j, SPEED + 0j, 0.25), Ball(6j, 2.0 * SPEED + 0j, 0.25))
    assert may_be_steered(PADDLES, PADDLES._replace(**change), both) is may
    assert not may_be_steered(PADDLES._replace(spin=0.0), PADDLES, both)
    fast = PADDLES._replace(spin=9.0)
    assert may_be_steered(fast, fast._replace(spin=-9.0), both)


def seconds_of(flight):
    """How long a free flight lasts; 0 where none is known."""
    return 0.0 if flight is None else flight[1]


def same(step, other):
    """Whether two steps did the same."""
    return step[:4] == other[:4]


@pytest.mark.parametrize("index", range(60))
def test_a_spared_tick_is_the_same_tick(index):
    """To the bit, in random arenas whose turning rings are steered: with the last step and without it."""
    state, speed, chance = random_case(4, index)
    flight, spared = None, 0
    for _ in range(100):
        step = advance(state, TICK, speed, flight)
        assert same(step, advance(state, TICK, speed))
        spared += seconds_of(flight) >= TICK
        state, flight = steered(with_lost_balls_back(step.arena, speed, chance), speed, chance), step.flight
    assert spared > 0 or speed * TICK > 0.1 or len(state.balls) > 1


def test_most_ticks_of_a_game_are_spared():
    """A ball that flies from one side to the other is looked after a few times."""
    state, flight, looked_after = arena(6 + 0j, cmath.rect(SPEED, 2.0)), None, 0
    for _ in range(400):
        looked_after += seconds_of(flight) < TICK
        step = advance(state, TICK, SPEED, flight)
        state, flight = step.arena, step.flight
    assert looked_after < 40


def seen_ahead(before):
    """The second of two steps: the first was told of no step before it, and looked no farther than its own end."""
    first = advance(before, TICK, SPEED)
    return advance(first.arena, TICK, SPEED, first.flight)


HERE = Ball(cmath.rect(8.0, 1.0), cmath.rect(SPEED, 2.5), 0.25)
ELSEWHERE = {
    "another ball": lambda state: state._replace(balls=(Ball(9.23 + 0j, SPEED + 0j, 0.25),)),
    "another velocity": lambda state: state._replace(balls=(Ball(HERE.position, 900j * HERE.position, 0.25),)),
    "a ring more": lambda state: Arena(state.balls, (*state.rings, Ring(8.0, 0.1, math.pi, 1)), (*state.layers, (1,))),
    "a ring at another place": lambda state: state._replace(rings=(state.rings[0]._replace(radius=8.2), state.rings[1])),
    "a brick in its way": lambda state: state._replace(layers=(state.layers[0], (1,))),
}


@pytest.mark.parametrize("change", ELSEWHERE.values(), ids=ELSEWHERE)
def test_what_was_said_of_another_arena_does_not_count(change):
    """Whatever was changed since the last step but the spin of a turning ring is looked at anew."""
    before = Arena((HERE,), (PADDLES._replace(half_angle=1.0), Ring(8.0, 0.9, math.pi, 1)), ((1, 1, 1), (0,)))
    last = seen_ahead(before)
    assert seconds_of(last.flight) > TICK
    changed = change(last.arena)
    step = advance(changed, TICK, SPEED, last.flight)
    assert step.hits or step.freed
    assert same(step, advance(changed, TICK, SPEED))


def test_a_spin_beyond_all_measure_is_looked_at_anew():
    """The ball between two paddles is caught by an end that comes from afar."""
    before = arena(cmath.rect(10.0, 1.0), cmath.rect(SPEED, 1.0))
    last = seen_ahead(before)
    assert seconds_of(last.flight) > 10.0 * TICK
    changed = last.arena._replace(rings=(last.arena.rings[0]._replace(spin=240.0), BRICKS))
    assert advance(changed, TICK, SPEED, last.flight).hits


def test_no_time_changes_nothing_however_clear_it_is():
    """The very same arena."""
    last = seen_ahead(arena(6 + 0j))
    assert advance(last.arena, 0.0, SPEED, last.flight).arena is last.arena


def test_a_flight_that_claims_too_much_would_be_seen():
    """A flight that claims too much leads a ball through a wall: what the tests above compare does differ."""
    state = arena(9.23 + 0j)
    wrong = (state, 1.0, (0,))
    assert not same(advance(state, TICK, SPEED, wrong), advance(state, TICK, SPEED))
    assert not same(advance(state, TICK, SPEED, (state, 1.0, ())), advance(state, TICK, SPEED, wrong))


@pytest.mark.parametrize("position", [10.2 + 0j, 9.5 + 0j])
def test_a_tick_of_no_time_hides_no_ball_inside_material(position):
    """A ball that overlaps a paddle is freed by the first tick that lasts, also where one of no time went before."""
    still = advance(arena(position), 0.0, SPEED)
    assert advance(still.arena, TICK, SPEED, still.flight).freed == 1
