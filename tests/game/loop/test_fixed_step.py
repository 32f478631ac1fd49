"""Ticks out of time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.loop.fixed_step import Due, due
from game.rules import TICK


@given(st.lists(st.floats(0.0, 0.25), max_size=50))
def test_no_time_is_lost_or_won(frames):
    """However time comes in frames, the ticks and the rest add up to it."""
    ticks, rest = 0, 0.0
    for seconds in frames:
        now = due(rest, seconds)
        ticks, rest = ticks + now.ticks, now.rest
        assert 0.0 <= rest < TICK * (1.0 + 1e-9)
    assert ticks * TICK + rest == pytest.approx(sum(frames), abs=1e-9)


@given(st.floats(0.0, TICK, exclude_max=True), st.floats(0.0, 1e9))
def test_a_stall_never_owes_more_than_60_ticks(rest, seconds):
    """What a frame takes beyond a quarter of a second is forgotten."""
    assert due(rest, seconds).ticks <= 60


def test_a_clock_that_jumps_back_stops_the_game_for_a_frame():
    """Negative time runs no tick."""
    assert due(0.001, -5.0) == Due(0, 0.001)


@given(st.floats(0.0, TICK), st.floats(0.0, 1.0))
def test_alpha_is_a_share_of_a_tick(rest, seconds):
    """The moment to draw lies in the last tick."""
    assert 0.0 <= due(rest, seconds).alpha <= 1.0
