"""The credits: who made the game, and whose lecture it follows."""

from game.language import tr
from game.overlay.credits_words import DESKTOP, about, credit_parts, version
from game.screens.toolkit.items.basic import Heading, TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.panel import Panel


class Credits(Panel):
    """The panel of the credits."""

    def content(self) -> Content:
        """The text."""
        computed = tr("is computed while you play: no picture and no sound comes from a file.")
        parts = [((Heading(title),), (TextItem(words),)) for title, words in credit_parts(DESKTOP, computed)]
        body = ((TextItem(about(), 1.2),), *[row for part in parts for row in part], (TextItem(version(), faint=True),))
        return Content(tr("Credits"), body, width=36.0)
