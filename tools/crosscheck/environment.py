"""Can this machine run the harness?"""

import importlib
import importlib.util

from game.system.errors import EnvironmentMissingError

MAJOR = 7
"""The major version of pymunk whose behaviour the harness relies on."""


def check_environment() -> None:
    """Raise EnvironmentMissingError, with what to do, unless pymunk is here in the right version and asserts are on."""
    if not __debug__:
        raise EnvironmentMissingError("pymunk checks its own answers by assertions; run without -O and PYTHONOPTIMIZE")
    wanted = f'install it with: python -m pip install "pymunk>={MAJOR}.1,<{MAJOR + 1}"'
    if importlib.util.find_spec("pymunk") is None:
        raise EnvironmentMissingError(f"pymunk is not installed; {wanted}")
    try:
        version = str(importlib.import_module("pymunk").version)  # noqa: TID251  # may be missing
    except (ImportError, OSError) as error:
        raise EnvironmentMissingError(f"pymunk cannot be loaded ({error}); {wanted}") from None
    if version.partition(".")[0] != str(MAJOR):
        raise EnvironmentMissingError(f"pymunk {version} is installed, the harness is written for {MAJOR}.x; {wanted}")
