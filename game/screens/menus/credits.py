"""Who made the game, and after whose notes."""

from game import VERSION
from game.language import tr
from game.screens.toolkit.items.basic import Heading, TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.panel import Panel


class Credits(Panel):
    """A page of text."""

    def content(self) -> Content:
        """What the game owes to whom."""
        body = (
            (TextItem(tr("A circular Breakout whose collision detection is written by hand, in polar coordinates."), 1.2),),
            (Heading(tr("The idea")),),
            (TextItem(tr("Lecture notes on collision detection for a polar breakout; their functions run in every game.")),),
            (Heading(tr("Made with")),),
            (TextItem("Python, pygame-ce, SDL, NumPy, msgspec, platformdirs, Typer, Rich, Pymunk"),),
            (Heading(tr("Everything you see and hear")),),
            (TextItem(tr("is computed while you play: no picture and no sound comes from a file.")),),
            (TextItem(tr("Version {version}").format(version=VERSION), faint=True),),
        )
        return Content(tr("Credits"), body, width=36.0)
