"""Settings that every test shares."""

import gc
import os

import pytest
from hypothesis import HealthCheck, settings

from tests.support.children import Children

# No profile has a deadline or a check by the clock: a busy machine is not a wrong answer.
TIMELESS = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
# The same examples on every run of a build.
settings.register_profile("ci", TIMELESS, derandomize=True, max_examples=200, print_blob=True)
# At the desk: other examples every time.
settings.register_profile("desk", TIMELESS, max_examples=100)
# Before a release: pytest --hypothesis-profile=long
settings.register_profile("long", TIMELESS, max_examples=20_000)

settings.load_profile("ci" if os.environ.get("CI") else "desk")


def pytest_addoption(parser):
    """`--regen` records the golden games anew."""
    parser.addoption("--regen", action="store_true", help="record the golden games anew; the changelog must say why")


@pytest.hookimpl(trylast=True)
def pytest_collection_finish():
    """What there is before the first test stays until the last, and the garbage collector need not look at it again."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def children():
    """Starts child processes that end with the test, whatever happens in it."""
    started = Children()
    yield started
    started.end()
