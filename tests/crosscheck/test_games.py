"""Whole games, cross-checked: the two engines agree, and each of five deliberate mistakes is found and named."""

import cmath
import math

import pytest

from physics import Arena, Ball, Ring, advance
from tools.crosscheck.comparisons.contact import checked_contact
from tools.crosscheck.comparisons.game import checked_ticks
from tools.crosscheck.comparisons.hit_frame import Scene, geometry_of, moment_of
from tools.crosscheck.games.sources import RANDOM, Source, ticks_of
from tools.crosscheck.games.trajectory import Tick, paths
from tools.crosscheck.pymunk_model.ring_model import RingModel
from tools.crosscheck.results.cases import ANYWHERE, Class, Comparison
from tools.crosscheck.results.rows import Rows
from tools.crosscheck.run import Job, check_game

FACETS = 64


def checked(level, seed, ticks, sabotage=None):
    return check_game(Job(Source(None, level, seed, ticks), FACETS, None, sabotage)).rows


@pytest.fixture(scope="module")
def rows():
    """A minute of the game on every level, and arenas drawn at random."""
    total = Rows()
    for level in range(1, 8):
        total.merge(checked(str(level), level, 2400))
    for seed in range(1, 6):
        total.merge(checked(RANDOM, seed, 3000))
    return total


def test_the_two_engines_agree(rows):
    """Nothing is unexplained in hundreds of contacts; every contact has a class, every feature its rows."""
    assert [case for case in rows.cases if case.kind == Class.UNEXPLAINED] == []
    assert rows.unexplained == rows.elsewhere == 0
    assert rows.contacts == sum(rows.classes.values()) > 300
    for comparison in Comparison:
        features = {feature for found, feature in rows.samples if found == comparison and rows.samples[found, feature]}
        everywhere = {"outer face", "inner face", "end", "corner"}
        without_arcs = everywhere - {"inner face"}
        expected = {Comparison.NORMAL_EXACT: without_arcs, Comparison.PRESENCE_TICK: {ANYWHERE}}
        assert features == expected.get(comparison, everywhere)


def test_every_error_is_within_its_bound(rows):
    """Error by error, not only the largest; and exact shapes agree to far better than 1e-9 radians."""
    for (comparison, feature), samples in rows.samples.items():
        over = [pair for pair in zip(samples.errors, samples.bounds, strict=True) if pair[0] > pair[1]]
        assert over == [], (comparison, feature)
    exact = [e for (c, _), samples in rows.samples.items() if c == Comparison.NORMAL_EXACT for e in samples.errors]
    assert max(exact) < 1e-9


def test_presence_is_compared_at_every_tick_with_a_ball():
    """One comparison per ball and tick, whatever happens in it."""
    source = Source(None, RANDOM, 1, 500)
    balls = sum(len(tick.arena.balls) for tick in ticks_of(source))
    assert len(check_game(Job(source, FACETS)).rows.samples[Comparison.PRESENCE_TICK, ANYWHERE]) == balls


def what(rows, **wanted):
    """The words for the unexplained cases that have these fields."""
    cases = [case for case in rows.cases if case.kind == Class.UNEXPLAINED]
    return {case.what for case in cases if all(getattr(case, name) == value for name, value in wanted.items())}


def test_a_normal_turned_by_a_tenth_of_a_degree_is_found():
    """On every feature with an exact shape, with the angle by name. A facet of 64 is coarser: convergence finds it there."""
    rows = checked(RANDOM, 1, 3000, "rotated-normal")
    for feature in ("outer face", "end", "corner"):
        assert what(rows, comparison=Comparison.NORMAL_EXACT, feature=feature) == {
            "the game's normal is turned by +0.1 degrees"
        }
    exact = sum(len(rows.samples[Comparison.NORMAL_EXACT, feature]) for feature in ("outer face", "end", "corner"))
    assert rows.classes[Class.UNEXPLAINED] >= exact > 20


def test_a_swapped_end_is_found():
    """Ends, and nothing but ends, disagree: the other end's normal is recognised."""
    rows = checked("6", 3, 6000, "swapped-end")
    ends = rows.samples[Comparison.NORMAL_EXACT, "end"]
    assert what(rows, comparison=Comparison.NORMAL_EXACT) == {"the game's normal is that of the sector's other end"}
    assert {case.feature for case in rows.cases if case.kind == Class.UNEXPLAINED} == {"end"}
    assert rows.classes[Class.UNEXPLAINED] == len(ends) > 5


def test_a_corner_treated_as_an_end_is_found():
    """Corners, and nothing but corners, disagree, with a name."""
    rows = checked("6", 3, 6000, "corner-as-end")
    named = what(rows, comparison=Comparison.NORMAL_EXACT, feature="corner")
    assert named == {"the game's normal is that of an end where pymunk has a corner"}
    assert {case.feature for case in rows.cases if case.kind == Class.UNEXPLAINED} == {"corner"}
    assert rows.classes[Class.UNEXPLAINED] == len(rows.samples[Comparison.NORMAL_EXACT, "corner"]) > 5


def test_a_forgotten_spin_is_found():
    """With omega left out of the surface's velocity, normals agree and velocities do not, and the reason is named."""
    rows = checked("4", 5, 6000, "still-surface")
    assert what(rows, comparison=Comparison.NORMAL_EXACT) == set()
    assert "the game's velocity is that off a ring at rest (its spin is ignored)" in what(rows, comparison=Comparison.VELOCITY)
    assert rows.classes[Class.UNEXPLAINED] > 10


def test_a_dropped_bounce_is_found():
    """Nothing is wrong at any contact: the ball is seen inside material, or too late in time."""
    rows = checked("6", 5, 6000, "dropped-bounce")
    assert what(rows, comparison=Comparison.PRESENCE_TICK) == {"the ball is in material: the game missed a bounce"}
    assert rows.elsewhere > 5


def one_tick(step_of=None):
    """One ball flying into one brick, by the physics or by something else."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.25),), (ring,), ((1, 1, 1, 1),))
    dt = 1.0 / 60.0
    return Tick(0, arena, dt, 60.0, (step_of or advance)(arena, dt, 60.0))


def flown(ball, hit, dt):
    """Where a ball is after one hit."""
    return Ball(ball.position + ball.velocity * hit.time + hit.after * (dt - hit.time), hit.after, ball.radius)


def test_one_clean_bounce_has_no_cases():
    """The case that the next tests spoil."""
    rows = checked_ticks([one_tick()], FACETS, "").rows
    assert (rows.contacts, rows.unexplained, rows.cases) == (1, 0, [])


def test_a_bounce_in_the_air_is_invented():
    """A hit recorded half a unit above the brick: pymunk has nothing there."""

    def early(arena, dt, speed):
        step = advance(arena, dt, speed)
        hit = step.hits[0]._replace(time=step.hits[0].time - 0.5 / 60.0)
        return step._replace(hits=(hit,), arena=step.arena._replace(balls=(flown(arena.balls[0], hit, dt),)))

    rows = checked_ticks([one_tick(early)], FACETS, "").rows
    assert what(rows) == {
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

    rows = checked_ticks([one_tick(late)], FACETS, "").rows
    assert what(rows) >= {"pymunk touches earlier than the game bounces (missed bounce)"}
    assert "the game bounced after pymunk touches (-0.01 units from touch)" in what(rows)


def test_a_hit_without_a_record_is_missed():
    """The ball turns round and no hit says why."""
    rows = checked_ticks([one_tick(lambda *tick: advance(*tick)._replace(hits=()))], FACETS, "").rows
    assert what(rows) >= {"the ball's flight does not follow from the recorded bounces (missed bounce)"}


def test_a_ball_that_lost_speed_is_named():
    """A velocity that is not the fixed speed: said with its length."""

    def slower(arena, dt, speed):
        step = advance(arena, dt, speed)
        hit = step.hits[0]._replace(after=step.hits[0].after * 0.5)
        return step._replace(hits=(hit,), arena=step.arena._replace(balls=(flown(arena.balls[0], hit, dt),)))

    rows = checked_ticks([one_tick(slower)], FACETS, "").rows
    assert what(rows, comparison=Comparison.VELOCITY) == {"the game's velocity is of length 30, not 60"}


def test_two_corners_at_once_are_a_tie():
    """Straight into a gap too narrow for it, a ball meets two corners in one moment: each engine names one of them first."""
    ring = Ring(5.0, 0.5, math.pi / 4.0 - 0.02, 4, phase=math.pi / 4.0)
    arena = Arena((Ball(6.5 + 0j, -60.0 + 0j, 0.25),), (ring,), ((1, 1, 1, 1),))
    step = advance(arena, 1.0 / 60.0, 60.0)
    first = step.hits[0]
    assert (first.slot, round(first.contact.normal.real, 2), first.contact.normal.imag > 0.0) == (0, 0.9, False)
    other = first._replace(slot=3, contact=first.contact._replace(normal=first.contact.normal.conjugate()))
    kinds = []
    for hit in (first, other):
        moment = moment_of(Scene(Tick(0, arena, 1.0 / 60.0, 60.0, step), [RingModel(geometry_of(ring), FACETS)], ""), hit, 0j)
        place = arena.balls[0].position + arena.balls[0].velocity * hit.time
        moment = moment._replace(position=place, local=place * cmath.rect(1.0, -moment.angle))
        kinds.append(checked_contact(moment, Rows()).kind)
    assert sorted(kinds) == [Class.EXACT, Class.TIE]


def test_a_graze_is_called_a_graze():
    """Past an outer face with 1e-13 to spare or to touch: the game's hit is right, and so would be none."""
    ring = Ring(5.0, 0.5, 0.3, 4)
    radius = 0.25
    height = 5.5 + radius - 1e-13
    arena = Arena((Ball(complex(height, -0.5), 60.0j, radius),), (ring,), ((1, 1, 1, 1),))
    step = advance(arena, 1.0 / 60.0, 60.0)
    assert len(step.hits) == 1
    rows = checked_ticks([Tick(0, arena, 1.0 / 60.0, 60.0, step)], FACETS, "").rows
    assert (rows.unexplained, rows.classes[Class.GRAZING]) == (0, 1)
    assert [case.comparison for case in rows.cases if case.kind == Class.GRAZING] == [Comparison.TIME]


def test_paths_are_rebuilt_without_normals_or_points():
    """Garbage in every contact changes no leg: a hit's place follows from the flight alone."""
    tick = next(tick for tick in ticks_of(Source(None, RANDOM, 3, 3000)) if tick.step.hits)
    nonsense = tuple(hit._replace(contact=hit.contact._replace(normal=1j, point=7j, gap=math.nan)) for hit in tick.step.hits)
    spoiled = tick._replace(step=tick.step._replace(hits=nonsense))
    legs = [[leg[:5] for leg in path.legs] for path in paths(tick)]
    assert legs == [[leg[:5] for leg in path.legs] for path in paths(spoiled)]
    assert all(path.fits for path in paths(tick))


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
    alone = check_game(Job(source, FACETS, worst.tick))
    assert alone.ticks == 1
    assert alone.rows.samples[Comparison.NORMAL_EXACT, "corner"].worst == worst
