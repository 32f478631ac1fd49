"""Whether pygame is the library that the game is written for."""

from game.system.errors import EnvironmentMissingError

_WANTED = "pip uninstall --yes pygame, then pip install --force-reinstall pygame-ce"


def check_pygame() -> None:
    """Raise EnvironmentMissingError where there is no pygame-ce, or pygame was installed over it or uninstalled from it.

    The two share a folder: whichever is installed last overwrites the other, and uninstalling it leaves holes.
    """
    try:
        import pygame  # noqa: PLC0415  # only what opens a window or draws a picture needs it
    except ImportError as error:
        raise EnvironmentMissingError(f"pygame-ce cannot be loaded ({error}): {_WANTED}") from None
    if not getattr(pygame, "IS_CE", False):
        where = getattr(pygame, "__file__", None) or next(iter(pygame.__path__))
        raise EnvironmentMissingError(f"{where} is not pygame-ce, or not all of it: {_WANTED}")
