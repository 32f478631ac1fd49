"""More facets, smaller difference; and what that proof can find."""

import math

import pytest

import game.rules
from physics import advance
from tools.crosscheck.comparisons import convergence
from tools.crosscheck.comparisons.convergence import FACETS, Curve, converged
from tools.crosscheck.comparisons.free_run import free_run
from tools.crosscheck.games.sources import Source
from tools.crosscheck.run import Job, check_game

SOURCES = [Source(None, level, seed, 20_000) for seed in range(4) for level in ("2", "3", "1")]


def curve(errors, expected):
    return Curve("an error", "rad", expected, FACETS, tuple(errors), 100)


@pytest.mark.parametrize("power", [-1.0, -2.0])
def test_a_curve_has_the_slope_it_was_made_with(power):
    """Least squares on a pure power, and a curve of another power does not hold."""
    made = curve([n**power for n in FACETS], power)
    assert made.slope == pytest.approx(power, abs=1e-12)
    assert made.holds
    assert not curve(made.errors, power - 1.0).holds


def test_rounding_is_no_part_of_a_slope():
    """Errors at floating point's floor are left out; with nothing left there is no slope and no proof."""
    assert curve([max(n**-2.0 * 1e-8, 3e-14) for n in FACETS], -2.0).slope == pytest.approx(-2.0, abs=1e-12)
    nothing = curve([1e-15] * len(FACETS), -1.0)
    assert math.isnan(nothing.slope)
    assert not nothing.holds


def few(monkeypatch):
    """25 contacts instead of 40: slopes scatter by 0.02, a fifth of what is allowed."""
    monkeypatch.setattr(convergence, "_CONTACTS", 25)
    monkeypatch.setattr(convergence, "_FEWEST", 25)


def test_errors_fall_as_geometry_demands(monkeypatch):
    """Normals as 1/N, times as 1/N^2, on both faces, from 8 to 1024 facets."""
    few(monkeypatch)
    curves = converged(SOURCES)
    assert [found.name for found in curves] == [
        "normal, outer face",
        "time, outer face",
        "normal, inner face",
        "time, inner face",
    ]
    assert [found.name for found in curves if not found.holds] == []


def test_a_normal_turned_by_a_tenth_of_a_degree_stops_the_fall(monkeypatch):
    """The facets of 64 hide such an error on an inner face; those of 1024 do not: the curve levels off at 0.1 degrees."""
    few(monkeypatch)
    normals = {found.name: found for found in converged(SOURCES, "rotated-normal") if found.unit == "rad"}
    for name in ("normal, outer face", "normal, inner face"):
        assert not normals[name].holds
        assert normals[name].errors[-1] == pytest.approx(math.radians(0.1), rel=0.05)


def test_left_alone_both_engines_begin_alike():
    """The first bounces are the same; the difference begins at the size of pymunk's step and grows."""
    run = free_run("1", 2, 64)
    assert run.together >= 2
    assert 0.0 < run.differences[0] < 8.0 / 240.0  # a ball's way in a tick: pymunk's delay is 1/64 of that, amplified once
    assert run.seconds > 1.0


def test_the_sabotage_of_the_source_leaves_the_physics_alone():
    """A sabotaged game puts the game's own physics back when it is done."""
    check_game(Job(Source(None, "1", 1, 300), 8, None, "rotated-normal"))
    assert game.rules.advance is advance
