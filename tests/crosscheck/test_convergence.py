"""More facets, smaller difference; and what that proof can find."""

import math
import random
import statistics

import pytest

import physics
from physics import Feature, Impact, direction
from physics.time_of_impact import first_impact
from tools.crosscheck.comparisons import convergence
from tools.crosscheck.comparisons.convergence import FACETS, Curve, converged
from tools.crosscheck.comparisons.free_run import free_run
from tools.crosscheck.games.sources import Source
from tools.crosscheck.run import Job, check_game
from tools.crosscheck.sabotage.catalogue import MISTAKES
from tools.crosscheck.sabotage.replacing import replaced

pytestmark = pytest.mark.deep

SOURCES = [Source(None, level, seed, 20_000) for seed in range(4) for level in ("Three Rings", "Three Gates", "First Wall")]


def curve(errors, expected, off=0.0):
    """A curve whose derived errors differ from the measured ones by `off` of their bound, 1e-13."""
    derived = tuple(error + off * 1e-13 for error in errors)
    return Curve("an error", "rad", expected, FACETS, tuple(errors), derived, (1e-13,) * len(FACETS), 100)


@pytest.mark.parametrize("power", [-1.0, -2.0])
def test_a_curve_has_the_slope_it_was_made_with(power):
    """Least squares on a pure power, and a curve of another power does not hold."""
    made = curve([n**power for n in FACETS], power)
    assert made.slope == pytest.approx(power, abs=1e-12)
    assert made.holds
    assert not curve(made.errors, power - 1.0).holds


def test_an_error_that_is_not_the_derived_one_does_not_hold():
    """Whatever the slope: by 0.9 of the bound it is rounding, by 1.1 it is a difference; and what is no number is none."""
    errors = [n**-1.0 for n in FACETS]
    assert curve(errors, -1.0, 0.9).holds
    assert not curve(errors, -1.0, 1.1).holds
    assert not curve([*errors[:-1], math.nan], -1.0).holds


def test_the_slack_of_a_slope_is_six_times_its_scatter():
    """Slopes of curves made from random positions on facets stay within it, and use a good part of it."""
    chance = random.Random(5)
    slopes = []
    for _ in range(2000):
        positions = [[chance.uniform(-1.0, 1.0) for _ in range(100)] for _ in FACETS]
        errors = [math.sqrt(sum(x * x for x in xs) / 100.0) / n for n, xs in zip(FACETS, positions, strict=True)]
        slopes.append(curve(errors, -1.0).slope)
    slack = curve(errors, -1.0).slack
    assert statistics.stdev(slopes) == pytest.approx(slack / 6.0, rel=0.1)


def test_rounding_is_no_part_of_a_slope():
    """Errors at floating point's floor are left out; with nothing left there is no slope and no proof."""
    assert curve([max(n**-2.0 * 1e-8, 3e-14) for n in FACETS], -2.0).slope == pytest.approx(-2.0, abs=1e-12)
    nothing = curve([1e-15] * len(FACETS), -1.0)
    assert math.isnan(nothing.slope)
    assert not nothing.holds


def few(monkeypatch):
    """25 contacts instead of 40: slopes scatter more, and are allowed to."""
    monkeypatch.setattr(convergence, "_CONTACTS", 25)
    monkeypatch.setattr(convergence, "_FEWEST", 25)


def test_errors_fall_as_geometry_demands(monkeypatch):
    """Normals as 1/N, times as 1/N^2, on both faces, from 8 to 1024 facets; and all are the derived ones to rounding."""
    few(monkeypatch)
    curves = converged(SOURCES)
    assert [found.name for found in curves] == [
        "normal, outer face",
        "time, outer face",
        "normal, inner face",
        "time, inner face",
    ]
    assert [found.name for found in curves if not found.holds] == []
    assert [found.name for found in curves if found.unit == "rad" and found.residual > 0.5] == []


def test_a_hundredth_of_a_degree_on_inner_faces_is_left_over(monkeypatch):
    """It hides below the facets of 64, and would bend the slope by 0.02 only; the derived errors show it at every N."""
    few(monkeypatch)
    turn = direction(math.radians(0.01))

    def turned(ball, ring, dt, alive=None):
        found = first_impact(ball, ring, dt, alive)
        if found is None or found.contact.feature != Feature.INNER_FACE:
            return found
        return Impact(found.time, found.slot, found.contact._replace(normal=found.contact.normal * turn))

    with replaced(first_impact, turned):
        curves = {found.name: found for found in converged(SOURCES)}
    inner = curves["normal, inner face"]
    assert curves["normal, outer face"].holds
    assert not inner.holds
    assert abs(inner.slope - inner.expected) <= inner.slack
    assert inner.errors[-1] > 1.2 * inner.derived[-1]


def test_a_tenth_of_a_degree_stops_the_fall(monkeypatch):
    """With 1024 facets the curve has levelled off at 0.1 degrees."""
    few(monkeypatch)
    with MISTAKES["rotated-normal"].change():
        normals = {found.name: found for found in converged(SOURCES) if found.unit == "rad"}
    for name in ("normal, outer face", "normal, inner face"):
        assert not normals[name].holds
        assert normals[name].errors[-1] == pytest.approx(math.radians(0.1), rel=0.05)


def test_left_alone_both_engines_begin_alike():
    """The first bounces are the same; the difference begins at the size of pymunk's step and grows."""
    run = free_run("1", 2, 64)
    assert run.together >= 2
    assert 0.0 < run.differences[0] < 8.0 / 240.0  # a ball's flight in a tick: pymunk's delay is 1/64 of it, amplified once
    assert run.seconds > 1.0


def test_a_mistake_leaves_the_physics_as_it_was():
    """A sabotaged game puts the game's own functions back when it is done."""
    before = physics.step.first_impact
    check_game(Job(Source(None, "1", 1, 300), 8, None, "rotated-normal"))
    assert physics.step.first_impact is before is first_impact
