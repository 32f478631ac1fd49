"""The captions on plates at the right edge, beside the arena; for pygame and for a browser."""

from game.drawing.camera import Layout
from game.drawing.letter_sizes import width
from game.drawing.palette import Theme
from game.overlay.captions import Caption
from game.picture.display_list import DisplayList

# Lengths are in units of text.
_SIZE, _PITCH, _MARGIN, _RIGHT, _TOP = 1.1, 1.9, 0.6, 0.8, 4.0
"""Size of letters, from line to line, from words to the plate's ends, from the plates to the surface's right edge, and from its
upper edge to the uppermost: the lives are above."""
_PLATE, _CORNER, _EDGE_LINE = 1.6, 0.4, 0.06
"""Height of a plate, radius of its corners and width of its edge."""
_SMALLEST, _LOWEST = 0.85, 0.42
"""A caption that would reach into the arena has smaller letters, at least this share of those without large text; and share of
the surface's height, from the edge where the captions are, beyond which only the newest may be."""


def add_captions(
    out: DisplayList, captions: tuple[Caption, ...], layout: Layout, theme: Theme, unit: float, foot: float | None = None
) -> None:
    """Add the captions below the lives in the upper right, the newest uppermost; or in the lower right, the newest lowermost.

    foot: height of what is below them in the lower right, pixels; None for the upper right.
    """
    surface, plate = layout.size, unit * _PLATE
    for index, caption in enumerate(reversed(captions)):
        top = unit * (_TOP + _PITCH * index) if foot is None else surface[1] - foot - unit * (_PLATE + _PITCH * index)
        far = top + plate if foot is None else surface[1] - top
        if index and far > surface[1] * _LOWEST:
            return
        words, edge = caption.text, max(layout.right_edge(top), layout.right_edge(top + plate))
        wide = unit * _SIZE * width(words)
        room = surface[0] - unit * (_RIGHT + 2.0 * _MARGIN) - edge
        share = min(max(room / wide, _SMALLEST * layout.unit / unit), 1.0)
        size = share * complex(wide + 2.0 * unit * _MARGIN, plate)
        corner = complex(surface[0] - unit * _RIGHT - size.real, top)
        out.box(corner, size, unit * _CORNER, theme.panel, (max(unit * _EDGE_LINE, 1.0), theme.panel_edge))
        out.text(words, share * unit * _SIZE, corner + size / 2.0, theme.text, room=share * wide)
