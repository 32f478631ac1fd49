"""Can this machine compute with 50 digits?"""

from game.system.errors import EnvironmentMissingError


def check_environment() -> None:
    """Raise EnvironmentMissingError, with what to do, unless mpmath can be imported."""
    try:
        import mpmath  # noqa: F401, PLC0415  # only whether it can be
    except ImportError as error:
        wanted = "install the extra [grade]: python -m pip install 'polar-breakout[grade]'"
        raise EnvironmentMissingError(f"mpmath cannot be imported ({error}); {wanted}") from None
