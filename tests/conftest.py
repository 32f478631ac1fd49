"""Settings that every test shares."""

import os

from hypothesis import HealthCheck, settings

# The same examples on every run of a build, and no deadline: a busy machine is not a wrong answer.
settings.register_profile(
    "ci", derandomize=True, deadline=None, max_examples=200, print_blob=True, suppress_health_check=[HealthCheck.too_slow]
)
# At the desk: other examples every time.
settings.register_profile("desk", deadline=None, max_examples=100)
# Before a release: pytest --hypothesis-profile=long
settings.register_profile("long", deadline=None, max_examples=20_000, suppress_health_check=[HealthCheck.too_slow])

settings.load_profile("ci" if os.environ.get("CI") else "desk")


def pytest_addoption(parser):
    """`--regen` records the golden games anew."""
    parser.addoption("--regen", action="store_true", help="record the golden games anew; the changelog must say why")
