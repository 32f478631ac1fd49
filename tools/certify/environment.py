"""Can this machine run the proofs?"""

from game.system.errors import EnvironmentMissingError


def check_environment() -> None:
    """Raise EnvironmentMissingError, with what to do, unless python-flint can be imported."""
    try:
        import flint  # noqa: F401, PLC0415  # only whether it can be
    except (ImportError, OSError) as error:
        wanted = "install the extra [proof]: python -m pip install 'polar-breakout[proof]'"
        raise EnvironmentMissingError(f"python-flint cannot be imported ({error}); {wanted}") from None
