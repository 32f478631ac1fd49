"""Can this machine run the proofs?"""

import importlib

from game.system.errors import EnvironmentMissingError


def check_environment() -> None:
    """Raise EnvironmentMissingError, with what to do, unless python-flint can be imported."""
    try:
        importlib.import_module("flint")
    except (ImportError, OSError) as error:
        wanted = "install the extra [proof]: python -m pip install 'polar-breakout[proof]'"
        raise EnvironmentMissingError(f"python-flint cannot be imported ({error}); {wanted}") from None
