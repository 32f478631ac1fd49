"""How a scene of the lab is laid out on the page: its panes, and the words below them; in a lecture room with large text."""

import textwrap
from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.camera import unit_of
from game.drawing.palette import Colour, Theme
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Picture
from game.lab.session.presenting import TEXT_SCALES
from game.picture.display_list import DisplayList

_BODY, _SMALLEST = 0.8, 13.0
"""Size of text in the game's; CSS pixels that it has at least."""
_LINE, _LETTER, _EDGE = 1.3, 0.52, 0.7
"""Height of a line and width of a letter, in shares of its size; from the words to the edges, in units."""
_LEAST_LETTERS = 40
"""Letters that a line of a lecture room has at least: on a phone the text is smaller for them."""
_MOST_WORDS = 0.4
"""Share of the canvas' height that the words below have at most; of more, those that were revealed last are shown."""
_MOST_PEN = 1.6
"""Lines and points grow with the text up to this."""


class PaneArea(NamedTuple):
    """A rectangle of the canvas, pixels. corner: the upper left one. extent: width and height, as one complex number."""

    corner: complex
    extent: complex

    @property
    def width(self) -> float:
        """Pixels."""
        return self.extent.real

    @property
    def height(self) -> float:
        """Pixels."""
        return self.extent.imag

    @property
    def center(self) -> tuple[float, float]:
        """Its middle, x and y."""
        middle = self.corner + self.extent / 2.0
        return middle.real, middle.imag

    def contains(self, pixel: complex) -> bool:
        """Whether a pixel is in it."""
        inside = pixel - self.corner
        return 0.0 <= inside.real < self.width and 0.0 <= inside.imag < self.height


class WordRow(NamedTuple):
    """A line of words. top: of its middle, pixels."""

    text: str
    colour: Colour
    middle: float


class LabLayout(NamedTuple):
    """Where everything is. unit: size of text, pixels. pen: the measure of lines and points, pixels. rows: of words."""

    unit: float
    pen: float
    panes: tuple[PaneArea, ...]
    rows: tuple[WordRow, ...]


class Heading(NamedTuple):
    """What stands above the picture in a lecture room: the step of the reveal, or where there is none the title.

    scale: an index of TEXT_SCALES.
    """

    scale: int
    title: str
    step: str


def layout_of(
    size: tuple[int, int], density: float, picture: Picture, theme: Theme, heading: Heading | None = None
) -> LabLayout:
    """The layout of a canvas. density: pixels per CSS pixel. heading: of a lecture room; None beside the controls."""
    body = max(unit_of(size) * _BODY, _SMALLEST * density)
    if heading is None:
        rows = _fitting(_wrapped(picture, size[0], body, theme), size[1], body)
        bottom = size[1] - (len(rows) + _EDGE) * _LINE * body
        return LabLayout(body, body, _panes(size, 0.0, bottom, picture), _placed(rows, bottom, body))
    unit = max(min(body * TEXT_SCALES[heading.scale], size[0] / (_LEAST_LETTERS * _LETTER)), body)
    colour = theme.accent if heading.step else theme.text
    head = [(line, colour) for line in _lines(heading.step or heading.title, size[0], unit)]
    rows = _fitting(_wrapped(picture._replace(cited=None), size[0], unit, theme), size[1], unit)
    top, below = ((len(lines) + _EDGE) * _LINE * unit for lines in (head, rows))
    bottom = size[1] - below
    placed = (*_placed(head, 0.0, unit), *_placed(rows, bottom, unit))
    return LabLayout(unit, min(unit, body * _MOST_PEN), _panes(size, top, bottom, picture), placed)


def add_rows(out: DisplayList, layout: LabLayout) -> None:
    """Add the words."""
    for row in layout.rows:
        out.text(row.text, layout.unit, complex(_EDGE * layout.unit, row.middle), row.colour, 0.0, bold=0.0)


def handle_at(handles: Sequence[Handle], given: Given, point: complex, reach: float) -> Handle | None:
    """The handle that a press takes hold of: the nearest within reach, else one within whose ball it is; world units."""
    near = [(abs(handle.position(given) - point), k) for k, handle in enumerate(handles)]
    found = [one for one in near if one[0] <= reach]
    found = found or [(far, k) for far, k in near if (own := handles[k].reach) is not None and far <= own(given)]
    return handles[min(found)[1]] if found else None


def _panes(size: tuple[int, int], top: float, bottom: float, picture: Picture) -> tuple[PaneArea, ...]:
    """The panes between two heights: side by side; on a narrow canvas one above the other."""
    room, count = complex(size[0], max(bottom - top, 0.2 * size[1])), len(picture.panes)
    beside = room.real >= room.imag
    extent = complex(room.real / count, room.imag) if beside else complex(room.real, room.imag / count)
    step = complex(extent.real, 0.0) if beside else complex(0.0, extent.imag)
    return tuple([PaneArea(1j * top + k * step, extent) for k in range(count)])


def _wrapped(picture: Picture, width: float, unit: float, theme: Theme) -> list[tuple[str, Colour]]:
    """The formula, the line that decides, and the note, in lines."""
    cited = "" if picture.cited is None else f"{picture.cited.where}:  {picture.cited.text}"
    texts = (*[(line, theme.text) for line in picture.formula], (cited, theme.faint), (picture.note, theme.accent))
    return [(line, colour) for text, colour in texts for line in _lines(text, width, unit)]


def _fitting(rows: list[tuple[str, Colour]], height: float, unit: float) -> list[tuple[str, Colour]]:
    """The last rows, as many as there is room for; at least one."""
    most = max(int(_MOST_WORDS * height / (_LINE * unit) - _EDGE), 1)
    return rows[-most:]


def _lines(text: str, width: float, unit: float) -> list[str]:
    """A text in lines as wide as the canvas."""
    return textwrap.wrap(text, max(int((width - 2.0 * _EDGE * unit) / (unit * _LETTER)), 16))


def _placed(lines: Sequence[tuple[str, Colour]], top: float, unit: float) -> tuple[WordRow, ...]:
    """Lines below each other, from a height on."""
    first = top + (_EDGE / 2.0 + 0.5) * _LINE * unit
    return tuple([WordRow(text, colour, first + number * _LINE * unit) for number, (text, colour) in enumerate(lines)])
