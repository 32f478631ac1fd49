"""Whole games, cross-checked: the two engines agree; and what single ticks with a mistake in them are called."""

import math

import pytest

from game.levels import classic
from physics import PERMANENT, Arena, Ball, Ring, advance
from tests.support.crosscheck import what
from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.game import WantedChecks, checked_ticks
from tools.crosscheck.comparisons.hit_frame import CheckedTick, geometry_of, moment_of
from tools.crosscheck.comparisons.normals import compare_normals
from tools.crosscheck.comparisons.rules import MOST_BOUNCES
from tools.crosscheck.games.level_numbers import numbers_of_arena
from tools.crosscheck.games.sources import AIMED, RANDOM, Source, ticks_of
from tools.crosscheck.games.trajectory import Tick, flight_paths
from tools.crosscheck.pymunk_model.ring_model import RingModel
from tools.crosscheck.results.measurements import ANYWHERE, Comparison, ContactVerdict
from tools.crosscheck.results.rows import ContactRows
from tools.crosscheck.run import Job, check_game

FACETS = 64
WANTED = WantedChecks(FACETS, "")


def checked(level, seed, ticks, player="autopilot", arcade=None):
    return check_game(Job(Source(None, level, seed, ticks, player, arcade), FACETS)).rows


@pytest.fixture(scope="module")
def rows():
    """Ten seconds on every level, by three players; a game by the arcade rules; arenas drawn at random; some aimed contacts."""
    total = ContactRows()
    for number, level in enumerate(classic(), 1):
        total.merge(checked(level.name, number, 2400, ("autopilot", "mouse", "keys")[number % 3]))
    total.merge(checked("Revolving Door", 3, 9600, arcade="hard"))
    for seed in range(1, 6):
        total.merge(checked(RANDOM, seed, 3000))
    total.merge(checked(AIMED, 5, 400))
    return total


def test_the_two_engines_agree(rows):
    """Nothing is unexplained in hundreds of contacts; every contact has a verdict, every feature its rows."""
    assert [one for one in rows.measurements if one.compared.verdict == ContactVerdict.UNEXPLAINED] == []
    assert rows.unexplained == rows.elsewhere == 0
    assert rows.before_first is None
    assert rows.contacts == sum(rows.verdicts.values()) == sum(rows.cells.values()) > 900
    assert rows.freed > 5
    for comparison in Comparison:
        features = {feature for found, feature in rows.samples if found == comparison and len(rows.samples[found, feature])}
        away = comparison in {Comparison.PRESENCE_TICK, Comparison.PHASE, Comparison.SET_FREE, Comparison.TURN}
        assert features == ({ANYWHERE} if away else {"outer face", "inner face", "end", "corner"})


def test_every_error_is_within_its_bound(rows):
    """Error by error, not only the largest; and exact shapes agree to far better than 1e-12 radians, inner faces too."""
    for (comparison, feature), samples in rows.samples.items():
        over = [pair for pair in zip(samples.errors, samples.bounds, strict=True) if pair[0] > pair[1]]
        assert over == [], (comparison, feature)
    exact = [e for (c, _), samples in rows.samples.items() if c == Comparison.NORMAL_EXACT for e in samples.errors]
    assert max(exact) < 1e-12


def test_the_time_of_touch_is_compared_at_every_contact_with_a_flight(rows):
    """On turning rings as on resting ones: only a hit at the tick's very start, or in no time, has none."""
    timed = sum(len(samples) for (comparison, _), samples in rows.samples.items() if comparison == Comparison.TIME)
    assert timed >= 0.97 * rows.contacts


def test_presence_is_compared_at_every_tick_with_a_ball():
    """One comparison per ball and tick, whatever happens in it."""
    source = Source(None, RANDOM, 1, 500)
    balls = sum(len(tick.arena.balls) for tick in ticks_of(source))
    assert check_game(Job(source, FACETS)).rows.poses == balls


def one_tick(step_of=None):
    """One ball flying into one brick, by the physics or by something else."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.25),), (ring,), ((1, 1, 1, 1),))
    dt = 1.0 / 60.0
    return Tick(0, arena, dt, (step_of or advance)(arena, dt, 60.0), numbers_of_arena(arena, 60.0))


def flown(ball, hit, dt):
    """Where a ball is after one hit."""
    return Ball(ball.position + ball.velocity * hit.time + hit.after * (dt - hit.time), hit.after, ball.radius)


def test_one_clean_bounce_has_no_cases():
    """The tick that the next tests spoil, as it is."""
    rows = checked_ticks([one_tick()], WANTED).rows
    assert (rows.contacts, rows.unexplained, rows.measurements) == (1, 0, [])


def test_a_bounce_in_the_air_is_invented():
    """A hit recorded half a unit above the brick: pymunk has nothing there."""

    def early(arena, dt, speed):
        step = advance(arena, dt, speed)
        hit = step.hits[0]._replace(time=step.hits[0].time - 0.5 / 60.0)
        return step._replace(hits=(hit,), arena=step.arena._replace(balls=(flown(arena.balls[0], hit, dt),)))

    rows = checked_ticks([one_tick(early)], WANTED).rows
    assert what(rows) >= {
        "the game bounced where pymunk sees nothing (invented bounce)",
        "the game bounced before pymunk touches (invented bounce)",
    }
    assert rows.unexplained == 1


def test_a_bounce_too_late_is_missed_in_time():
    """A hit recorded a hundredth of a unit inside the brick: pymunk touched before."""

    def late(arena, dt, speed):
        step = advance(arena, dt, speed)
        hit = step.hits[0]._replace(time=step.hits[0].time + 0.01 / 60.0)
        return step._replace(hits=(hit,), arena=step.arena._replace(balls=(flown(arena.balls[0], hit, dt),)))

    rows = checked_ticks([one_tick(late)], WANTED).rows
    assert what(rows) >= {"pymunk touches earlier than the game bounces (missed bounce)"}
    assert "the game bounced after pymunk touches (-0.01 units from touch)" in what(rows)


def test_a_hit_without_a_record_is_missed():
    """The ball turns round and no hit says why."""
    rows = checked_ticks([one_tick(lambda *tick: advance(*tick)._replace(hits=()))], WANTED).rows
    assert what(rows) >= {"the ball's flight does not follow from the recorded bounces (missed bounce)"}


def test_a_ball_that_lost_speed_is_named():
    """A velocity that is not the fixed speed: said with its length."""

    def slower(arena, dt, speed):
        step = advance(arena, dt, speed)
        hit = step.hits[0]._replace(after=step.hits[0].after * 0.5)
        return step._replace(hits=(hit,), arena=step.arena._replace(balls=(flown(arena.balls[0], hit, dt),)))

    rows = checked_ticks([one_tick(slower)], WANTED).rows
    assert what(rows, Comparison.VELOCITY) == {"the game's velocity is of length 30, not 60"}


def test_two_corners_at_once_are_a_tie():
    """Straight into a gap too narrow for it, a ball meets two corners in one moment: each engine names one of them first."""
    ring = Ring(5.0, 0.5, math.pi / 4.0 - 0.02, 4, phase=math.pi / 4.0)
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.25),), (ring,), ((1, 1, 1, 1),))
    step = advance(arena, 1.0 / 60.0, 60.0)
    first = step.hits[0]
    assert (first.slot, round(first.contact.normal.real, 2), first.contact.normal.imag > 0.0) == (0, 0.9, False)
    other = first._replace(slot=3, contact=first.contact._replace(normal=first.contact.normal.conjugate()))
    verdicts = []
    tick = Tick(0, arena, 1.0 / 60.0, step, numbers_of_arena(arena, 60.0))
    for hit in (first, other):
        position = arena.balls[0].position + arena.balls[0].velocity * hit.time
        check = ContactCheck(moment_of(CheckedTick(tick, [RingModel(geometry_of(ring), FACETS)], ""), hit, position))
        compare_normals(check)
        verdicts.append(check.verdict)
    assert sorted(verdicts) == [ContactVerdict.EXACT, ContactVerdict.TIE]


def test_a_graze_is_called_a_graze():
    """Past an outer face with 1e-13 to spare or to touch: the game's hit is right, and so would be none."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    radius = 0.25
    height = 5.5 + radius - 1e-13
    arena = Arena((Ball(complex(height, -0.5), 60.0j, radius),), (ring,), ((1, 1, 1, 1),))
    step = advance(arena, 1.0 / 60.0, 60.0)
    assert len(step.hits) == 1
    rows = checked_ticks([Tick(0, arena, 1.0 / 60.0, step, numbers_of_arena(arena, 60.0))], WANTED).rows
    assert (rows.unexplained, rows.verdicts[ContactVerdict.GRAZING]) == (0, 1)
    assert [one.compared.comparison for one in rows.measurements if one.compared.verdict == ContactVerdict.GRAZING] == [
        Comparison.TIME
    ]


def test_paths_are_rebuilt_without_normals_or_points():
    """Garbage in every contact changes no leg: a hit's position follows from the flight alone."""
    tick = next(tick for tick in ticks_of(Source(None, RANDOM, 3, 3000)) if tick.step.hits)
    nonsense = tuple(hit._replace(contact=hit.contact._replace(normal=1j, point=7j, gap=math.nan)) for hit in tick.step.hits)
    spoiled = tick._replace(step=tick.step._replace(hits=nonsense))
    legs = [[leg[:5] for leg in path.legs] for path in flight_paths(tick, MOST_BOUNCES)]
    assert legs == [[leg[:5] for leg in path.legs] for path in flight_paths(spoiled, MOST_BOUNCES)]
    assert all(path.fits for path in flight_paths(tick, MOST_BOUNCES))


def test_the_same_game_gives_the_same_numbers():
    """Checked again, also after other games have used the same models."""
    first = checked("5", 2, 2000)
    checked("5", 9, 2000)
    again = checked("5", 2, 2000)
    assert {key: list(samples.errors) for key, samples in first.samples.items()} == {
        key: list(samples.errors) for key, samples in again.samples.items()
    }


def test_one_tick_can_be_looked_at_alone():
    """What --tick shows of a contact is what the whole game showed of it."""
    source = Source(None, "6", 3, 6000)
    worst = check_game(Job(source, FACETS)).rows.samples[Comparison.NORMAL_EXACT, "corner"].worst
    alone = check_game(Job(source, FACETS, worst.situation.tick))
    assert alone.ticks == 1
    assert alone.rows.unexplained == 0
    assert alone.rows.samples[Comparison.NORMAL_EXACT, "corner"].worst == worst


def two_balls_and_one_brick(step_of=advance):
    """Ball 0 breaks a brick; ball 1 comes through where it stood, within the same tick."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    balls = (Ball(6.0 + 0j, -60.0 + 0j, 0.2), Ball(5.0 + 2.5j, 0.0 - 60.0j, 0.2))
    arena = Arena(balls, (ring,), ((1, 1, 1, 1),))
    dt = 1.0 / 20.0
    return Tick(0, arena, dt, step_of(arena, dt, 60.0), numbers_of_arena(arena, 60.0))


def test_a_ball_flies_through_a_brick_that_another_has_broken():
    """Until it breaks, the brick can be hit by both; from then on by none. Both engines agree on that, too."""
    tick = two_balls_and_one_brick()
    assert [(hit.ball, hit.slot, hit.layers) for hit in tick.step.hits][:1] == [(0, 0, 0)]
    assert checked_ticks([tick], WANTED).rows.unexplained == 0


def test_a_ball_that_flies_through_a_brick_before_it_breaks_is_noticed():
    """The same two flights, but ball 0 comes a little later: ball 1 must have met the brick, and did not."""

    def late(arena, dt, speed):
        delay = 0.04
        first = Ball(arena.balls[0].position + 60.0 * delay, arena.balls[0].velocity, 0.2)
        through = advance(arena._replace(balls=(first,)), dt, speed)
        passed = arena.balls[1].moved(dt)
        return through._replace(arena=through.arena._replace(balls=(through.arena.balls[0], passed)))

    ring = Ring(5.0, 0.5, 0.3, 4)
    balls = (Ball(6.0 + 2.4 + 0j, -60.0 + 0j, 0.2), Ball(5.0 + 2.5j, 0.0 - 60.0j, 0.2))
    arena = Arena(balls, (ring,), ((1, 1, 1, 1),))
    dt = 1.0 / 20.0
    step = late(arena._replace(balls=(Ball(6.0 + 0j, -60.0 + 0j, 0.2), balls[1])), dt, 60.0)
    assert [hit.ball for hit in step.hits] == [0]
    rows = checked_ticks([Tick(0, arena, dt, step, numbers_of_arena(arena, 60.0))], WANTED).rows
    assert "pymunk touches earlier than the game bounces (missed bounce)" in what(rows, Comparison.TIME)


def test_a_ball_put_outside_material_is_confirmed():
    """It overlapped before, it is free after, and what it hits in the rest of the tick is compared like any hit."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    arena = Arena((Ball(5.6 + 0j, -60.0 + 0j, 0.25),), (ring,), ((PERMANENT,) * 4,))
    dt = 1.0 / 60.0
    tick = Tick(0, arena, dt, advance(arena, dt, 60.0), numbers_of_arena(arena, 60.0))
    assert (tick.step.freed, len(tick.step.hits)) == (1, 1)
    rows = checked_ticks([tick], WANTED).rows
    assert (rows.unexplained, rows.freed, rows.contacts) == (0, 1, 1)


@pytest.mark.parametrize(
    ("start", "end", "claimed", "said"),
    [
        (7.0, 7.001, 1, "the ball overlapped nothing before it was put elsewhere"),
        (5.6, 5.70, 1, "the ball still overlaps material where it was put"),
        (5.6, 5.75, 2, "the physics freed 2 and dropped 0 balls, their flights show 1 and 0"),
    ],
)
def test_a_ball_put_elsewhere_for_no_good_reason_is_noticed(start, end, claimed, said):
    """The physics' word that a ball was freed is not taken for it."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    arena = Arena((Ball(start + 0j, 60.0 + 0j, 0.25),), (ring,), ((PERMANENT,) * 4,))
    dt = 1.0 / 60.0
    moved = (Ball(end + 60.0 * dt, 60.0 + 0j, 0.25),)
    step = advance(arena._replace(balls=()), dt, 60.0)._replace(freed=claimed)
    step = step._replace(arena=step.arena._replace(balls=moved))
    rows = checked_ticks([Tick(0, arena, dt, step, numbers_of_arena(arena, 60.0))], WANTED).rows
    assert said in what(rows, Comparison.SET_FREE)


def test_a_squeezed_ball_that_used_up_its_bounces_is_confirmed():
    """Between two closing ends it bounces 32 times in a tick and rests: counted, and every bounce compared."""
    narrow = math.asin(0.1 / 5.0)
    rings = (Ring(5.0, 0.4, 1.0, 1, phase=1.0 + narrow, spin=-1.0), Ring(5.0, 0.4, 1.0, 1, phase=-1.0 - narrow, spin=1.0))
    arena = Arena((Ball(5.0 + 0j, 8.0j, 0.0999),), rings, ((PERMANENT,), (PERMANENT,)))
    dt = 1.0 / 240.0
    step = advance(arena, dt, 8.0)
    assert step.dropped == 1
    rows = checked_ticks([Tick(0, arena, dt, step, numbers_of_arena(arena, 8.0))], WANTED).rows
    assert rows.dropped == 1
    assert what(rows, Comparison.SET_FREE) == set()


@pytest.mark.parametrize(("facets", "ticks", "least"), [(3, 600, 1000), (8, 600, 1000), (1024, 200, 300), (4096, 40, 50)])
def test_the_bounds_hold_for_any_number_of_facets(facets, ticks, least):
    """Also where a chord is so coarse that it lies behind the ball's centre, and its normal says nothing.

    Fewer contacts with the most facets: making the 8,192 chords of a ring takes longer than comparing a hundred contacts.
    """
    rows = check_game(Job(Source(None, AIMED, 4, ticks), facets)).rows
    assert (rows.unexplained, rows.contacts > least) == (0, True)
    assert all(
        error <= bound for samples in rows.samples.values() for error, bound in zip(samples.errors, samples.bounds, strict=True)
    )


@pytest.mark.parametrize(("start", "velocity"), [(7.0 + 0j, -8.0 + 0j), (3.0 + 0j, 8.0 + 0j)])
def test_a_ball_between_two_bricks_bounces_off_both(start, velocity):
    """Two hits that are one bounce: pymunk, which answers both walls in one step, sends the ball straight back, too."""
    ring = Ring(5.0, 0.3, math.radians(20.0), 8, math.radians(22.5), friction=0.3)
    arena = Arena((Ball(start, velocity, 0.5),), (ring,), ((2,) * 8,))
    level = numbers_of_arena(arena, 8.0)
    ticks = []
    for number in range(100):
        step = advance(arena, 1.0 / 240.0, 8.0)
        ticks.append(Tick(number, arena, 1.0 / 240.0, step, level))
        arena = step.arena
    assert [len(tick.step.hits) for tick in ticks if tick.step.hits] == [2]
    rows = checked_ticks(ticks, WANTED).rows
    assert (rows.unexplained, rows.contacts) == (0, 2)
    velocities = rows.samples[Comparison.VELOCITY, "corner"]
    assert len(velocities) == 2
    assert max(velocities.errors) < 1e-12
    assert max(velocities.bounds) < 1e-9


def test_paddles_that_start_to_turn_are_looked_at_again():
    """Beside a paddle at rest a ball has room; the paddle then turns into it, no hit says so, and pymunk sees the overlap."""
    paddles = Ring(9.0, 0.2, 0.3, 3)
    position = 9.0 * complex(math.cos(0.45), math.sin(0.45))
    arena = Arena((Ball(position, 0.01 + 0j, 0.25),), (paddles,), ((PERMANENT,) * 3,))
    level = numbers_of_arena(arena, 0.01)
    ticks = []
    for number in range(40):
        spin = 0.0 if number < 5 else 2.0
        arena = arena._replace(rings=(arena.rings[0]._replace(spin=spin),))
        moved, turned = arena.balls[0].moved(1.0 / 240.0), arena.rings[0].turned(1.0 / 240.0)
        after = arena._replace(balls=(moved,), rings=(turned,))
        step = advance(arena._replace(balls=()), 1.0 / 240.0, 8.0)._replace(arena=after)
        ticks.append(Tick(number, arena, 1.0 / 240.0, step, level))
        arena = after
    rows = checked_ticks(ticks, WANTED).rows
    assert "the ball is in material: the game missed a bounce" in what(rows, Comparison.PRESENCE_TICK)
    assert "pymunk touches earlier than the game bounces (missed bounce)" in what(rows, Comparison.TIME)


def test_a_wrong_turn_is_unexplained(monkeypatch):
    """A game that turns a returned ball by more than the level says, or to the other side, is found out."""
    right = checked("4", 3, 4800, arcade="normal")
    assert right.unexplained == 0
    assert len(right.samples[Comparison.TURN, ANYWHERE]) > 5
    for wrong in (1.001, -1.0):
        monkeypatch.setattr(
            "game.rules.turn.most_turn", lambda game, factor=wrong: math.radians(game.level.paddles.turn) * factor
        )
        assert "the turn by the position of the hit" in what(checked("4", 3, 4800, arcade="normal"), Comparison.TURN)
