"""Levels made from a seed."""

import datetime as dt
import hashlib
import math
from itertools import pairwise

import pytest

from game.generated import SEQUENCE, daily_seed, generated, sequence
from game.levels import checked, warnings
from game.replays.file import load
from game.replays.verify import verified
from physics import PERMANENT
from tests.support.paths import TESTS
from tools.balance.trial import trial

SEEDS = (0, 7, 20261126, 2**63 - 1)
_STEP = 0.12
"""World units between neighbouring positions of the ball that are tested."""


@pytest.mark.parametrize("seed", SEEDS)
def test_every_level_of_a_sequence_is_a_possible_arena_with_wide_gates(seed):
    levels = sequence(seed)
    assert len(levels) == SEQUENCE
    assert all([checked(level, level.name) == level and not warnings(level) for level in levels])


def reached(level):
    """Grid points (radius, angle) that a ball from the paddles can reach without bricks, and the number of angles."""
    track = level.paddles.radius - level.paddles.half_width - level.ball.radius
    radii, angles = int(track / _STEP), 180
    steel = [ring for ring in level.rings if PERMANENT in ring.slots()]

    def is_free(row, column):
        radius, angle = (row + 1) * _STEP, column * 360.0 / angles
        for ring in steel:
            pitch = 360.0 / ring.count
            beside = abs((angle - ring.phase + 0.5 * pitch) % pitch - 0.5 * pitch)
            margin = math.degrees(level.ball.radius / radius)
            if abs(radius - ring.radius) < ring.half_width + level.ball.radius and beside < ring.half_angle + margin:
                return False
        return True

    found = {(radii - 1, column) for column in range(angles)}
    edge = list(found)
    while edge:
        row, column = edge.pop()
        for near in ((row + 1, column), (row - 1, column), (row, (column + 1) % angles), (row, (column - 1) % angles)):
            if near not in found and 0 <= near[0] < radii and is_free(*near):
                found.add(near)
                edge.append(near)
    return found, angles


@pytest.mark.parametrize("number", range(2, 32))
def test_a_ball_reaches_every_brick(number):
    """With steel and bumpers at their first angles, a ball can reach a face of every brick."""
    level = generated(3, number)
    if not any([PERMANENT in ring.slots() for ring in level.rings]):
        return
    positions, angles = reached(level)
    for ring in level.rings:
        reach = ring.half_width + level.ball.radius + _STEP
        near = {column for row, column in positions if abs((row + 1) * _STEP - ring.radius) <= reach}
        for slot, layers in enumerate(ring.slots()):
            column = round((ring.phase + slot * 360.0 / ring.count) / 360.0 * angles) % angles
            assert layers <= 0 or column in near, (ring.radius, slot)


def test_a_level_depends_on_its_seed_and_its_number_alone():
    assert generated(7, 5) == sequence(7, 6)[5]
    assert len({level.content_hash() for level in (*sequence(7, 20), *sequence(8, 20))}) == 40


def test_every_ring_repeats_itself_around_the_centre():
    """At least twice, in layers and in colours."""
    for level in sequence(11, 40):
        for ring in level.rings:
            cells = [(layers, ring.tint_at(slot)) for slot, layers in enumerate(ring.slots())]
            folds = [fold for fold in range(2, 9) if ring.count % fold == 0]
            assert any([cells == cells[ring.count // fold :] + cells[: ring.count // fold] for fold in folds]), level.name


def test_levels_that_follow_each_other_look_different():
    """Neighbouring levels differ in the palette; a sequence contains every kind of ring that a wall can have."""
    levels = sequence(20261126, 40)
    assert all([one.look.palette != other.look.palette for one, other in pairwise(levels)])
    rings = [ring for level in levels for ring in level.rings]
    assert {math.copysign(1.0, ring.spin) for ring in rings if ring.spin} == {1.0, -1.0}
    for has in (
        [ring.reverse for ring in rings],
        [ring.bumper for ring in rings],
        [ring.regrow for ring in rings],
        [PERMANENT in ring.slots() and not ring.bumper for ring in rings],
        [level.wells for level in levels],
    ):
        assert any(has)


def test_the_first_levels_are_at_rest_and_later_ones_are_faster_with_narrower_paddles():
    first, last = generated(3, 0), generated(3, 60)
    assert all([ring.spin == 0.0 and PERMANENT not in ring.slots() for ring in first.rings])
    assert last.ball.speed > first.ball.speed + 0.8
    assert last.paddles.half_angle * last.paddles.count < first.paddles.half_angle * first.paddles.count - 20.0


def test_a_day_has_a_seed_of_its_own():
    assert daily_seed(dt.date(2026, 11, 26)) == 20261126


def test_the_levels_of_a_seed_stay_what_they_are():
    """A shared seed gives the same level in later versions and on every machine; the changelog names exceptions."""
    hashes = [level.content_hash() for seed in SEEDS for level in sequence(seed, 30)]
    assert hashlib.sha256("".join(hashes).encode()).hexdigest()[:16] == "7a3b26533d89993c"


def test_a_recorded_game_on_levels_of_an_earlier_version_still_verifies():
    """A replay contains its levels: this one has a daily sequence that the generator no longer makes."""
    recording = load(TESTS / "golden" / "endless" / "20261126.polar")
    assert recording.levels[0] != generated(20261126, 0)
    verdict = verified(recording)
    assert verdict.divergence is None
    assert verdict.game.score > 0


@pytest.mark.deep
@pytest.mark.parametrize("number", range(0, 40, 4))
def test_the_autopilot_clears_levels_of_a_seed(number):
    """It takes less than the ten minutes of a measured game; `python -m tools.balance --endless` plays more of them."""
    done = trial(generated(20261126, number), None, 0)
    assert done.cleared
    assert done.lost <= 3
