"""The words about what a key has changed, on a plate at the left edge; for pygame and for a browser."""

from game.drawing.camera import Layout
from game.drawing.letter_sizes import width
from game.drawing.palette import Theme
from game.overlay.toast import Toast
from game.picture.display_list import DisplayList

# Lengths are in units of text.
_TEXT = 1.1
"""Size of letters."""
_HEIGHT, _MARGIN = 2.2, 1.0
"""Height of the plate, and from the words to its ends."""
_LEFT, _BOTTOM, _NARROW_TOP = 0.8, 4.4, 3.7
"""From the surface's left and lower edges to the plate; and from its upper edge where the figures are above the arena."""
_BAR = complex(9.0, 0.5)
"""Width and height of the bar."""
_CORNER, _EDGE_LINE = 0.6, 0.06
"""Radius of the plate's corners, and width of its edge."""


def add_toast(out: DisplayList, toast: Toast, layout: Layout, theme: Theme, unit: float) -> None:
    """Add the plate in the lower left corner, above the level's name: no ball and no paddle ever comes there."""
    wide, margin, bar, plate = unit * _TEXT * width(toast.text), unit * _MARGIN, unit * _BAR, unit * _HEIGHT
    top = layout.size[1] - unit * _BOTTOM - plate if layout.beside else unit * _NARROW_TOP
    corner, middle = complex(unit * _LEFT, top), top + plate / 2.0
    size = complex(wide + 2.0 * margin + (0.0 if toast.level is None else bar.real + margin), plate)
    out.box(corner, size, unit * _CORNER, theme.panel, (max(unit * _EDGE_LINE, 1.0), theme.panel_edge))
    out.text(toast.text, unit * _TEXT, complex(corner.real + margin, middle), theme.text, 0.0, room=wide)
    if toast.level is not None:
        track = complex(corner.real + size.real - margin - bar.real, middle - bar.imag / 2.0)
        out.box(track, bar, bar.imag / 2.0, theme.panel_edge)
        out.box(track, complex(max(bar.real * toast.level, bar.imag), bar.imag), bar.imag / 2.0, theme.accent)
