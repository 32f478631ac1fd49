"""Levels made from a seed."""

import datetime as dt
import hashlib

import pytest

from game.generated import SEQUENCE, daily_seed, generated, sequence
from game.levels import checked, warnings


@pytest.mark.parametrize("seed", [0, 7, 20261126, 2**63 - 1])
def test_every_level_of_a_sequence_is_a_possible_arena_with_wide_gates(seed):
    levels = sequence(seed)
    assert len(levels) == SEQUENCE
    assert all([checked(level, level.name) == level and not warnings(level) for level in levels])


def test_a_level_depends_on_its_seed_and_its_number_alone():
    assert generated(7, 5) == sequence(7, 6)[5]
    assert len({level.content_hash() for level in (*sequence(7, 20), *sequence(8, 20))}) == 40


def test_later_levels_are_faster_and_their_paddles_narrower():
    first, last = generated(3, 0), generated(3, 60)
    assert last.ball.speed > first.ball.speed + 1.5
    assert last.paddles.half_angle < first.paddles.half_angle


def test_a_day_has_a_seed_of_its_own():
    assert daily_seed(dt.date(2026, 11, 26)) == 20261126


def test_the_levels_of_a_seed_stay_what_they_are():
    """A shared seed must mean the same level in a later version: changed levels are a new format, not a fix."""
    levels = sequence(20261126, 40)
    numbers = [
        (ring.radius, ring.half_width, ring.half_angle, ring.count, ring.layers, ring.phase, ring.spin)
        for level in levels
        for ring in level.rings
    ]
    assert hashlib.sha256(repr(numbers).encode()).hexdigest()[:16] == "47016939bab5c5b4"
