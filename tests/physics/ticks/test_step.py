"""One tick of the arena: order, bounds, and every case of the edge list that a single touch cannot show."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from physics import PERMANENT, Arena, Ball, Feature, Ring, Step, advance
from physics.tolerances import LEAST_SEPARATION, MAX_IMPACTS
from tests.support.games.ticks import PADDLE, SPEED, TICK, WALL, R, arena, at, penetration, played, ticked
from tests.support.oracles.impact_oracle import SPINS, gap
from tests.support.strategies import angles, reals


@pytest.mark.parametrize("dt", [-1.0, -5e-324, math.nan, math.inf, -math.inf])
def test_a_time_that_is_none_is_refused(dt):
    """And nothing has happened to the arena, which is a value."""
    with pytest.raises(ValueError, match=r"dt must be finite and at least 0, not "):
        advance(arena([Ball(5 + 0j, 8 + 0j, R)], PADDLE), dt, SPEED)


@pytest.mark.parametrize("p", [5 + 0j, 10.75 + 0j, 10.2 + 0j, 9.25 + 0j])
def test_no_time_changes_nothing(p):
    """dt = 0 gives the very same arena, whatever touches or overlaps."""
    before = arena([Ball(p, -8 + 0j, R)], PADDLE)
    assert advance(before, 0.0, SPEED) == Step(before, (), 0, 0)
    assert advance(before, 0.0, SPEED).arena is before


@pytest.mark.parametrize("dt", [5e-324, 1e-300, 1e-12])
def test_the_shortest_times_are_no_trouble(dt):
    """Nothing divides by dt."""
    for p in (5 + 0j, 10.75 + 0j, 9.25 + 0j, at(10.0, 0.4)):
        step = ticked(arena([Ball(p, -8 + 0j, R)], PADDLE._replace(spin=1.0)), dt)
        assert abs(step.arena.balls[0].position - p) <= 9.0 * dt + 1e-15


def test_a_ball_far_from_everything_flies_straight():
    """And rings turn meanwhile; those at rest are the same object."""
    before = arena([Ball(5 + 0j, 8j, R)], PADDLE._replace(spin=1.0), WALL)
    step = ticked(before)
    assert step.arena.balls[0].position == 5 + 8j * TICK
    assert step.arena.rings[0].phase == pytest.approx(TICK)
    assert step.arena.rings[1] is WALL
    assert step.hits == ()


def test_an_arena_without_balls_or_rings_is_no_trouble():
    """Ticks of nothing."""
    assert advance(Arena((), (), ()), TICK, SPEED)[:4] == (Arena((), (), ()), (), 0, 0)
    assert advance(arena([], PADDLE._replace(spin=1.0)), TICK, SPEED).arena.rings[0].phase == pytest.approx(TICK)
    assert advance(arena([Ball(0j, 1 + 0j, R)]), TICK, SPEED).arena.balls[0].position == TICK


def test_a_bounce_happens_where_and_when_the_ball_touches():
    """Halfway through the tick, and the rest of the tick is flown with the new velocity."""
    before = arena([Ball(10.75 + SPEED * TICK / 2.0 + 0j, -8 + 0j, R)], PADDLE)
    step = ticked(before)
    (hit,) = step.hits
    assert hit.time == pytest.approx(TICK / 2.0)
    assert hit.before == -8
    assert hit.after == 8
    assert hit.contact.feature == Feature.OUTER_FACE
    assert step.arena.balls[0].position == pytest.approx(10.75 + SPEED * TICK / 2.0)


def test_just_bounced_is_not_hit_again():
    """The ball touches the face it comes from, in this tick and at the start of the next."""
    _, hits, *_ = played(arena([Ball(10.75 + SPEED * TICK + 0j, -8 + 0j, R)], PADDLE), 5)
    assert len(hits) == 1


@pytest.mark.parametrize("layers", [1, 2, 3, PERMANENT])
def test_a_hit_takes_a_layer(layers):
    """Until none is left; a permanent sector keeps its -1."""
    before = arena([Ball(10.76 + 0j, -8 + 0j, R)], PADDLE, layers=[(layers,)])
    step = ticked(before)
    left = layers - 1 if layers > 0 else PERMANENT
    assert step.hits[0].layers == left
    assert step.arena.layers == ((left,),)


def test_a_brick_meets_one_ball_only():
    """Two balls on their way to it: the earlier breaks it, the later flies on; equally early, the lower number."""
    brick = Ring(10.0, 0.5, 0.3, 1)
    near, far = Ball(at(10.76, 0.1), at(-8.0, 0.1), R), Ball(at(10.765, -0.1), at(-8.0, -0.1), R)
    for balls, first in (((near, far), 0), ((far, near), 1)):
        step = ticked(arena(balls, brick, layers=[(1,)]))
        assert [hit.ball for hit in step.hits] == [first]
        assert step.arena.balls[1 - first].velocity == balls[1 - first].velocity
    twins = (Ball(10.76 + 0.5j, -8 + 0j, R), Ball(10.76 - 0.5j, -8 + 0j, R))
    assert [hit.ball for hit in ticked(arena(twins, brick, layers=[(1,)])).hits] == [0]
    assert [hit.ball for hit in ticked(arena(twins, brick, layers=[(2,)])).hits] == [0, 1]


def test_hits_come_in_the_order_of_time():
    """Of all balls together."""
    balls = [Ball(at(10.78 - 0.002 * k, k), at(-8.0, k), R) for k in range(6)]
    step = ticked(arena(balls, Ring(10.0, 0.5, math.pi, 1)))
    assert [hit.ball for hit in step.hits] == [5, 4, 3, 2, 1, 0]


@pytest.mark.parametrize("spin", SPINS)
def test_a_ball_at_the_very_centre_flies_off(spin):
    """0 has no bearing and needs none."""
    core = Ring(1.0, 0.5, 0.4, 3, 0.0, spin)
    for v in (8 + 0j, -8j, 8 * at(1.0, 1.0)):
        state, hits, dropped, freed = played(arena([Ball(0j, v, R)], core, WALL), 240)
        assert (dropped, freed) == (0, 0)
        assert math.isfinite(abs(state.balls[0].position))
        assert hits or abs(state.balls[0].position) > 5.0


@pytest.mark.parametrize("offset", [0j, 5e-324 + 0j, 1e-300j, 1e-17 + 1e-17j])
def test_a_flight_through_the_centre_touches_nothing_there(offset):
    """The bearing jumps by half a turn, the ball does not."""
    core = Ring(3.0, 0.5, 0.4, 3, 0.3)
    state, hits, *_ = played(arena([Ball(-1 + offset, 8 + 0j, R)], core), 30)
    assert hits == []
    assert state.balls[0].position == pytest.approx(offset + 0.0 + 0j, abs=1e-12)


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("surface", [0.5, 0.9, 0.99, 1.0, 1.5])
def test_the_fast_end_of_a_paddle_drives_the_ball_ahead(surface, sense):
    """Up to the ball's own speed and beyond: it is never passed through; below its speed, it gets away."""
    spin = sense * surface * SPEED / 10.5
    paddle = Ring(10.0, 0.5, 0.3, 1, 0.0, spin)
    ball = Ball(at(10.0, sense * 0.4), at(SPEED, sense * (0.4 - math.pi / 2.0)), R)
    state, hits, dropped, freed = played(arena([ball], paddle, WALL), 200)
    assert hits[0].contact.feature == Feature.END
    assert penetration(state) <= 1e-9
    if surface < 1.0:
        assert (dropped, freed) == (0, 0)
        away = hits[0].after.real * hits[0].contact.normal.real + hits[0].after.imag * hits[0].contact.normal.imag
        assert away > surface * SPEED * 10.0 / 10.5 * 0.9


def test_a_carried_ball_leaves_as_fast_as_the_surface():
    """Design, row 5: after the speed is reset the ball would still approach; it keeps its tangential sense instead."""
    spin = 0.95 * SPEED / 10.5
    paddle = Ring(10.0, 0.5, 0.3, 1, 0.0, spin)
    ball = Ball(at(10.0, 0.3) + 1j * at(1.0, 0.3) * (R + 0.001), at(SPEED, 0.3 + math.pi / 2.0 - 0.7), R)
    hit = ticked(arena([ball], paddle)).hits[0]
    n = hit.contact.normal
    pace = spin * abs(hit.contact.point)
    leaving = hit.after.real * n.real + hit.after.imag * n.imag
    assert abs(hit.after) == pytest.approx(SPEED, rel=1e-12)
    assert leaving == pytest.approx(pace + LEAST_SEPARATION * SPEED, rel=1e-6)
    assert (hit.after / at(1.0, 0.3)).real > 0.0


def test_a_ball_stopped_dead_by_a_retreating_end_leaves_along_the_normal():
    """Design, row 4: an end that retreats at half the ball's speed takes all of it."""
    paddle = Ring(10.0, 0.5, 0.3, 1, 0.0, -SPEED / 2.0 / 10.0)
    ball = Ball(at(10.0, 0.3) + 1j * at(1.0, 0.3) * R, -1j * at(SPEED, 0.3), R)
    (hit,) = ticked(arena([ball], paddle)).hits
    assert hit.after == SPEED * hit.contact.normal


@pytest.mark.parametrize("spin", [0.5, 5.0])
def test_a_ball_squeezed_between_closing_ends_is_put_outward_and_counted(spin):
    """Two rings turn against each other and their ends close on the ball: no motion at its speed can free it."""
    left, right = Ring(10.0, 0.5, 0.3, 1, 0.345, -spin), Ring(10.0, 0.5, 0.3, 1, -0.345, spin)
    before = arena([Ball(9.9 + 0j, 8j, R)], left, right)
    state, _, dropped, freed = played(before, 15)
    assert dropped >= 1
    assert freed >= 1
    assert penetration(state) <= 1e-9
    assert not 9.2 < abs(state.balls[0].position) < 10.5


def test_the_squeezed_ball_lands_at_the_nearest_free_place_on_its_bearing():
    """Not farther out than it must be: it touches what closed on it."""
    left, right = Ring(10.0, 0.5, 0.3, 1, 0.33, -2.0), Ring(10.0, 0.5, 0.3, 1, -0.33, 2.0)
    step = ticked(arena([Ball(9.9 + 0j, 8j, R)], left, right))
    assert (step.dropped, step.freed) == (1, 1)
    (ball,) = step.arena.balls
    assert abs(ball.position) > 10.5
    assert min(gap(ball, ring, 0.0, [0]) for ring in step.arena.rings) == pytest.approx(0.0, abs=1e-9)


def test_no_ball_bounces_more_often_in_a_tick_than_the_bound_says():
    """Two faces a hair more than two radii apart at 50 radii a tick: the bound ends it, the ball stays free, it is counted."""
    inner, outer = Ring(10.0, 0.5, math.pi, 1), Ring(11.5 + 1e-6, 0.5, math.pi, 1)
    before = arena([Ball(10.75 + 5e-7 + 0j, 12.5 / TICK + 0j, R)], inner, outer)
    step = ticked(before, speed=12.5 / TICK)
    assert len(step.hits) == MAX_IMPACTS
    assert step.dropped == 1
    assert penetration(step.arena) <= 1e-9


def test_only_the_ball_that_is_stuck_loses_its_time():
    """The others finish their tick."""
    inner, outer = Ring(10.0, 0.5, math.pi, 1), Ring(11.5 + 1e-6, 0.5, math.pi, 1)
    free = Ball(0j, 12.5 / TICK + 0j, R)
    step = ticked(arena([Ball(10.75 + 5e-7 + 0j, 12.5 / TICK + 0j, R), free], inner, outer), speed=12.5 / TICK)
    assert step.dropped == 1
    assert step.arena.balls[1].position != free.position
    assert [hit.ball for hit in step.hits].count(1) == 1


@pytest.mark.parametrize("before_centre", [10.2, 10.6, 9.4, 9.8])
def test_a_ball_that_starts_inside_is_freed_once_and_no_brick_is_credited_for_it(before_centre):
    """A spawn or a resize: out by the least depth, velocity kept, counted; then it flies on."""
    before = arena([Ball(complex(before_centre, 0.0), 8 * (0.6 + 0.8j), R)], PADDLE, layers=[(1,)])
    step = ticked(before)
    assert step.freed == 1
    state, hits, _, freed = played(step.arena, 10)
    assert freed == 0
    assert penetration(state) == 0.0
    assert len(step.hits) + len(hits) <= 1


@pytest.mark.parametrize("spin", SPINS)
def test_rolling_along_an_inner_wall_stays_inside_and_is_bounded(spin):
    """A ball set flying along the wall it touches: some thousand ticks, none with more than a few bounces."""
    state = arena([Ball(9.25 + 0j, 8j, R)], Ring(10.0, 0.5, math.pi, 1, 0.0, spin, 0.0))
    for _ in range(1000):
        step = ticked(state)
        assert len(step.hits) <= 3
        assert (step.dropped, step.freed) == (0, 0)
        state = step.arena
        assert 9.2 < abs(state.balls[0].position) < 9.25 + 1e-9


def test_grazing_an_outer_face_or_a_resting_corner_changes_next_to_nothing():
    """Whether a tangent is a hit or a miss is rounding's choice: the path must not depend on it."""
    corner = at(10.5, 0.3)
    for miss in (0.0, 1e-16, -1e-16, 1e-14, -1e-14):
        face = Ball(complex(10.75 + miss, -0.02), 8j, R)
        edge = Ball(corner + (R + miss - 0.02j) * at(1.0, 0.3), 8j * at(1.0, 0.3), R)
        for ball in (face, edge):
            after = ticked(arena([ball], PADDLE)).arena.balls[0]
            assert abs(after.velocity - ball.velocity) < 1e-6


def test_surfaces_at_rest_that_were_grazed_are_left():
    """Not met again in the same tick for rounding's sake."""
    for miss in (-1e-16, -1e-14, -1e-13, -1e-12, -1e-10):
        step = ticked(arena([Ball(complex(10.75 + miss, -0.02), 8j, R)], PADDLE))
        assert len(step.hits) <= 1


def test_a_huge_tick_is_bounded_too():
    """A thousand seconds at once: 32 bounces, the rest dropped and counted, never a leap through a wall."""
    step = advance(arena([Ball(1 + 0.3j, 8 + 0j, R)], WALL), 1e3, SPEED)
    assert len(step.hits) == MAX_IMPACTS
    assert step.dropped == 1
    assert abs(step.arena.balls[0].position) <= 12.25 + 1e-9


def test_thousands_of_bounces_leave_the_speed_alone():
    """There is no drift, for the speed is set anew at every bounce; `tools.bench --bounces` does a million."""
    speed = 50.0 * R / TICK
    state = arena([Ball(0.3j, complex(speed, 0.0), R)], WALL, Ring(3.0, 0.5, 0.2, 7, 0.1))
    bounces = 0
    while bounces < 5_000:
        step = advance(state, TICK * 10.0, speed)
        bounces += len(step.hits)
        state = step.arena
        assert abs(abs(state.balls[0].velocity) / speed - 1.0) < 1e-12
    assert penetration(state) <= 1e-9


@st.composite
def small_arenas(draw):
    """Up to three rings, none touching another, and up to three balls in free places."""
    edge, found, layers = draw(reals(0.2, 2.0)), [], []
    speed = draw(reals(0.5, 60.0))
    for _ in range(draw(st.integers(1, 3))):
        edge += draw(reals(0.0, 2.0))
        half_width = draw(reals(0.05, 0.6))
        count = draw(st.integers(1, 8))
        half_angle = draw(reals(0.05, 1.0)) * math.pi / count
        edge += 2.0 * half_width
        spin = draw(st.just(0.0) | reals(-0.99, 0.99)) * speed / edge
        found.append(Ring(edge - half_width, half_width, half_angle, count, draw(angles()), spin, draw(reals(0.0, 1.0))))
        layers.append(tuple(draw(st.lists(st.integers(-1, 2), min_size=count, max_size=count))))
    balls = []
    for _ in range(draw(st.integers(1, 3))):
        radius = draw(reals(0.1, 0.5))
        ball = Ball(at(draw(reals(0.0, edge + 1.0)), draw(angles())), at(speed, draw(angles())), radius)
        gaps = [
            gap(ball, ring, 0.0, [k for k in range(ring.count) if alive[k]]) for ring, alive in zip(found, layers, strict=True)
        ]
        if min(gaps) > 1e-6:
            balls.append(ball)
    return Arena(tuple(balls), tuple(found), tuple(layers)), speed


@given(small_arenas(), reals(1e-3, 0.2))
def test_any_tick_keeps_every_promise(scene, dt):
    """No tunnelling, no overlap, no hit without contact, the speed kept: asked of the fuzzer's oracle."""
    before, speed = scene
    ticked(before, dt, speed)


@given(small_arenas(), st.randoms(use_true_random=False))
def test_the_order_of_the_rings_does_not_matter(scene, chance):
    """The same balls come out, but for ties."""
    before, speed = scene
    order = list(range(len(before.rings)))
    chance.shuffle(order)
    shuffled = before._replace(rings=tuple(before.rings[k] for k in order), layers=tuple(before.layers[k] for k in order))
    plain, other = advance(before, TICK, speed), advance(shuffled, TICK, speed)
    if len({hit.time for hit in plain.hits}) == len(plain.hits) and not plain.dropped:
        assert plain.arena.balls == other.arena.balls
