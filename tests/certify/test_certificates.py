"""True claims are certified, false ones refuted, grazes left open by name."""

import cmath
from itertools import islice

import pytest

pytest.importorskip("flint", reason="the proofs need python-flint, the extra [proof]")

from physics import Arena, Ball, Feature, Ring
from tests.support.claims import (
    SPEED,
    TICK,
    above_a_wall,
    along_a_turning_end,
    claiming,
    first_impact,
    flown_through,
    flying_at,
    past_a_corner,
    played,
    towards_feature,
    verdicts,
    with_hit,
)
from tools.certify.certificate import Decision, certificates
from tools.certify.exact_geometry import use_precision
from tools.certify.sources import ClaimSource

TRUE = ("CERTIFIED", "NONE")
SPINS = [0.0, 0.9, -0.9]


@pytest.fixture(autouse=True)
def _precision():
    use_precision()


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("feature", list(Feature))
def test_every_feature_is_certified(feature, spin):
    """The impact, and the flight after it; the time within 1e-12 s, the normal within 1e-12."""
    tick = played(towards_feature(feature, spin))
    assert [hit.contact.feature for hit in tick.step.hits] == [feature]
    assert verdicts(tick) == [TRUE, TRUE]
    impact = first_impact(tick)
    assert 0.0 < impact.time_bound < 1e-12
    assert impact.time_off <= impact.time_bound
    assert impact.normal_off <= impact.normal_bound < 1e-12


@pytest.mark.parametrize("late", [1e-9, -1e-9])
@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("feature", list(Feature))
def test_a_time_that_is_off_by_a_nanosecond_is_refuted(feature, spin, late):
    """Too early there is no touch, too late an overlap."""
    tick = played(towards_feature(feature, spin))
    wrong = claiming(tick, time=tick.step.hits[0].time + late)
    assert verdicts(wrong)[0] == ("REFUTED", "OVERLAP" if late > 0.0 else "NO_TOUCH")


@pytest.mark.parametrize("turned", [1e-12, -1e-12, 3.14])
@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("feature", list(Feature))
def test_a_normal_that_is_off_by_1e_12_is_refuted(feature, spin, turned):
    """To either side; and one that points into the material."""
    wrong = claiming(played(towards_feature(feature, spin)), turned=turned)
    assert verdicts(wrong)[0] == ("REFUTED", "NORMAL")


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("feature", list(Feature))
def test_a_point_that_is_off_by_1e_12_is_refuted(feature, spin):
    """The normal is right, the point is not where ball and sector meet."""
    for off in (1e-12, -1e-12j):
        wrong = claiming(played(towards_feature(feature, spin)), moved=off)
        assert verdicts(wrong)[0] == ("REFUTED", "POINT")


@pytest.mark.parametrize("spin", SPINS)
@pytest.mark.parametrize("feature", list(Feature))
def test_a_missed_touch_is_refuted(feature, spin):
    """A ball that flies through a sector as if it were not there."""
    assert verdicts(flown_through(towards_feature(feature, spin))) == [("REFUTED", "EARLIER")]


@pytest.mark.parametrize("spin", [0.0, 0.1, -0.1])
@pytest.mark.parametrize("outer", [True, False])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_clipped_corner_is_refuted(sign, outer, spin):
    """Each corner alone, deep or by a millionth, with nothing else of its sector near; passed beyond its reach, it is free."""
    for miss in (0.17, 0.2 - 1e-6):
        assert verdicts(flown_through(*past_a_corner(sign, outer, spin, miss))) == [("REFUTED", "EARLIER")]
    assert verdicts(flown_through(*past_a_corner(sign, outer, spin, 0.23))) == [TRUE]


@pytest.mark.parametrize("sign", [1, -1])
def test_a_touched_end_is_refuted(sign):
    """Between its corners, by two thousandths or by a millionth; a thousandth above it, the flight is free."""
    for miss in (0.198, 0.2 - 1e-6):
        assert verdicts(flown_through(*along_a_turning_end(sign, miss))) == [("REFUTED", "EARLIER")]
    assert verdicts(flown_through(*along_a_turning_end(sign, 0.201))) == [TRUE]


def test_a_missed_earlier_touch_is_refuted():
    """The second hit of a tick is true, the first is left out."""
    n = cmath.rect(1.0, 0.3)
    through = played(flying_at(n * 5.6, -n, before=0.9))
    assert verdicts(through) == [TRUE, TRUE]
    hidden = Ring(5.41, 0.005, 0.001, 3, 0.3)
    before = through.arena._replace(rings=(*through.arena.rings, hidden), layers=(*through.arena.layers, (1, 1, 1)))
    after = through.step.arena._replace(rings=(*through.step.arena.rings, hidden), layers=before.layers)
    tick = through._replace(arena=before, step=through.step._replace(arena=after))
    assert verdicts(tick)[0] == ("REFUTED", "EARLIER")


def test_the_neighbour_sector_is_refuted():
    """The other sector that bounds the gap, and one whose brick is gone."""
    tick = played(towards_feature(Feature.CORNER))
    assert verdicts(claiming(tick, slot=1))[0] == ("REFUTED", "NO_TOUCH")
    empty = tick._replace(arena=tick.arena._replace(layers=((0, -1, -1),)))
    assert verdicts(empty)[0] == ("REFUTED", "NO_SECTOR")


def test_a_hit_of_a_ball_that_leaves_is_refuted():
    """It touches at the start of the tick, and flies away."""
    arena = flying_at(5.6, 1.0, before=0.0)
    assert verdicts(with_hit(flown_through(arena), 0.0, 1 + 0j)) == [("REFUTED", "LEAVING")]


def test_a_bounce_that_starts_in_a_touch_is_certified():
    """A ball that overlaps by a rounding and leaves; and one that arrives in a tick's last moment."""
    for depth in (0.0, 1e-15, 1e-14):
        assert verdicts(flown_through(flying_at(5.6 - depth, 1.0, before=0.0))) == [TRUE]
        assert verdicts(flown_through(flying_at(5.6 - depth, -1.0, before=1.0))) == [TRUE]
    assert verdicts(flown_through(flying_at(5.6 - 1e-9, 1.0, before=0.0))) == [("UNDECIDED", "SQUEEZED")]
    assert verdicts(flown_through(flying_at(5.6 - 1e-9, -1.0, before=1.0))) == [("REFUTED", "EARLIER")]


def test_a_graze_is_undecided_and_named():
    """A ball that touches a wall in one point of its flight: reported or not, neither is proved or refuted."""
    tick = flown_through(above_a_wall(0.0))
    assert verdicts(tick) == [("UNDECIDED", "EARLIER_GRAZE")]
    assert verdicts(with_hit(tick, TICK / 2.0, 1j)) == [("UNDECIDED", "GRAZE")]


def test_what_is_nearly_a_graze_is_decided():
    """1e-14 apart is no touch; a millionth into the wall is one."""
    assert verdicts(flown_through(above_a_wall(1e-14))) == [TRUE]
    assert verdicts(flown_through(above_a_wall(-1e-6))) == [("REFUTED", "EARLIER")]
    assert verdicts(played(above_a_wall(-1e-6))) == [TRUE, TRUE]


def test_a_ball_that_is_not_where_it_flew_is_refuted():
    """By 1e-9; likewise a ring that did not turn by its spin, and a hit of a ball that came from elsewhere."""
    tick = played(towards_feature(Feature.OUTER_FACE, 0.9))
    ball, ring = tick.step.arena.balls[0], tick.step.arena.rings[0]
    moved = tick.step.arena._replace(balls=(ball._replace(position=ball.position + 1e-9),))
    turned = tick.step.arena._replace(rings=(ring._replace(phase=ring.phase + 1e-9),))
    for arena in (moved, turned):
        assert verdicts(tick._replace(step=tick.step._replace(arena=arena)))[-1] == ("REFUTED", "PATH")
    assert verdicts(claiming(tick, before=-tick.arena.balls[0].velocity))[0] == ("REFUTED", "PATH")


def test_a_sector_that_vanishes_is_there_until_then():
    """Two balls, one brick: the second flies on through it; had it come first, its flight would be refuted."""
    ring = Ring(5.0, 0.4, 0.3, 3, 0.2)
    first = Ball(5.6 + SPEED * TICK * 0.3 + 0j, -SPEED + 0j, 0.2)
    second = Ball((5.6 + SPEED * TICK * 0.6) * cmath.rect(1.0, 0.2), -SPEED * cmath.rect(1.0, 0.2), 0.2)
    tick = played(Arena((first, second), (ring,), ((1, 1, 1),)))
    assert [hit.ball for hit in tick.step.hits] == [0]
    assert verdicts(tick) == [TRUE, TRUE, TRUE]
    stays = claiming(tick, layers=1)
    assert ("REFUTED", "EARLIER") in verdicts(stays)


def test_a_freed_ball_flies_from_where_it_was_put():
    """The physics puts a ball outside that overlaps at the start; its flights begin there."""
    arena = flying_at(5.6 - 0.01, -1.0, before=0.0)
    tick = played(arena)
    assert (tick.step.freed, len(tick.step.hits)) == (1, 1)
    assert verdicts(tick) == [TRUE, TRUE]


@pytest.mark.parametrize("name", ["arena:1:2", "arena:1:12", "game:6:2", "impacts:3:0"])
def test_games_and_arenas_have_no_false_claim(name):
    """Some ticks of each kind of source; `python -m tools.certify` is the same at length."""
    found = [one.verdict for tick in islice(ClaimSource(name).ticks(), 1500) for one in certificates(tick)]
    assert Decision.REFUTED not in found
    assert found.count(Decision.CERTIFIED) > 90
    assert found.count(Decision.UNDECIDED) <= (0 if name[0] in "ag" else 20)
