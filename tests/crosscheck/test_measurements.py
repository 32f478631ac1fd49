"""The numbers of a row: what they count, and that nothing hides in them."""

import math
import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tools.crosscheck.results.measurements import Samples

ERRORS = st.lists(st.floats(1e-18, 10.0), min_size=1, max_size=60)


def row(errors, bounds=None, zeros=0):
    samples = Samples()
    for error, bound in zip(errors, bounds or [1.0] * len(errors), strict=True):
        samples.add(error, bound)
    samples.zeros = zeros
    return samples


@given(ERRORS, st.integers(0, 60))
def test_unlisted_zeros_count_like_listed_ones(errors, zeros):
    """A row that only counts its zeros gives the numbers of one that lists them."""
    counted, listed = row(errors, zeros=zeros).summary(), row([*errors, *[0.0] * zeros]).summary()
    assert counted[:4] == listed[:4]


@given(ERRORS)
def test_quantiles_are_errors_of_the_row(errors):
    """The median is the lower of the two middle ones, 99 in 100 are at most p99, none is above the maximum."""
    summary = row(errors).summary()
    assert summary.median == statistics.median_low(errors)
    assert summary.maximum == max(errors)
    assert sum(error <= summary.p99 for error in errors) >= 0.99 * len(errors)
    assert summary.p99 in errors


def test_the_share_is_the_worst_of_all_not_that_of_the_largest_error():
    """A small error over its own small bound is not hidden by a large one within a large bound."""
    summary = row([0.5, 0.02], [1.0, 0.01]).summary()
    assert (summary.maximum, summary.bound, summary.share) == (0.5, 1.0, 2.0)


def test_an_error_without_a_bound_is_over_it():
    """What must be exactly right has the bound 0: any error is more than all of it, and none is none of it."""
    assert row([1.0], [0.0]).summary().share == math.inf
    assert row([0.0], [0.0]).summary().share == 0.0


@given(ERRORS, ERRORS)
def test_rows_of_two_games_merge_to_the_row_of_both(one, two):
    """Its numbers are those of one row with the errors of both."""
    merged = row(one, zeros=3)
    merged.merge(row(two, zeros=4))
    assert merged.summary() == pytest.approx(row([*one, *two], zeros=7).summary())


def test_an_empty_row_has_no_summary():
    """A row of zeros only has numbers, but no bound to be held to."""
    assert row([]).summary() is None
    summary = row([], zeros=5).summary()
    assert summary[:4] == (5, 0.0, 0.0, 0.0)
    assert math.isnan(summary.bound)
