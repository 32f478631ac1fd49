"""Can this machine run the proofs?"""

import importlib.util

from game.system.errors import EnvironmentMissingError


def check_environment() -> None:
    """Raise EnvironmentMissingError, with what to do, unless python-flint is here."""
    if importlib.util.find_spec("flint") is None:
        raise EnvironmentMissingError(
            "python-flint is not installed; install the extra [proof]: python -m pip install 'polar-breakout[proof]'"
        )
