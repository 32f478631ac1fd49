"""Who made the game, and after whose notes: the words."""

from game import VERSION
from game.language import tr

DESKTOP = "Python, pygame-ce, SDL, NumPy, msgspec, platformdirs, Typer, Rich, Pymunk"
PAGE = "Python, Pyodide, msgspec, Pymunk, CodeMirror"
"""What the game is made with in a window, and in a browser."""


def about() -> str:
    """What the game is."""
    return tr("A circular Breakout whose collision detection is written by hand, in polar coordinates.")


def credit_parts(made_with: str, seen_and_heard: str) -> tuple[tuple[str, str], ...]:
    """Headings, each with what is below it. seen_and_heard: where pictures and sounds come from."""
    return (
        (tr("The idea"), tr("Lecture notes on collision detection for a polar breakout; their functions run in every game.")),
        (tr("Made with"), made_with),
        (tr("Everything you see and hear"), seen_and_heard),
    )


def version() -> str:
    """Which version this is."""
    return tr("Version {version}").format(version=VERSION)
