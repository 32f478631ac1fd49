"""Layout of a scene's panes on the page's canvas. The words around them are elements of the page."""

from collections.abc import Sequence
from typing import NamedTuple

from game.drawing.camera import unit_of
from game.lab.kit.handles import Handle
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Picture
from game.lab.session.presenting import TEXT_SCALES
from game.lab.session.reveal import Reveal, step_words
from game.lab.typeset.mathml import escaped, mathml_line
from game.lab.typeset.tex import has_symbols
from game.web.client.messages import PageWords

_BODY, _SMALLEST = 0.8, 13.0
"""Size of text in the game's; CSS pixels that it has at least."""
_EM = 0.6875
"""The em square of the game's own font: text sizes for presenting are multiples of it."""
_LETTER = 0.52
"""Width of a letter, in shares of its size."""
_LEAST_LETTERS = 40
"""Letters that a line of a lecture room has at least: on a phone the text is smaller for them."""
_FLATTEST = 0.75
"""Least ratio of height to width by which the text size is computed: a canvas above words may be flatter."""
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


class LabLayout(NamedTuple):
    """Positions of everything. unit: size of text, pixels. pen: unit for the width of lines and points, pixels."""

    unit: float
    pen: float
    panes: tuple[PaneArea, ...]


def layout_of(size: tuple[int, int], density: float, panes: int, scale: int | None = None) -> LabLayout:
    """The layout of a canvas with some panes. density: pixels per CSS pixel.

    scale: index into TEXT_SCALES while presenting; None beside the controls.
    """
    width, height = size
    body = max(unit_of((width, max(height, round(_FLATTEST * width)))) * _BODY, _SMALLEST * density)
    if scale is None:
        return LabLayout(body, body, _panes(size, panes))
    unit = max(min(body * TEXT_SCALES[scale] * _EM, width / (_LEAST_LETTERS * _LETTER)), body)
    return LabLayout(unit, min(unit, body * _MOST_PEN), _panes(size, panes))


def words_of(title: str, picture: Picture, reveal: Reveal, whole: Picture, scale: int | None) -> PageWords:
    """The words around a picture. reveal: the steps shown so far; whole: the picture with all; scale: as in `layout_of`."""
    formula = tuple([mathml_line(line) for line in picture.formula])
    note = _html(picture.note)
    if scale is not None:
        return PageWords(title, _html(step_words(reveal, whole) or title), formula, "", note, TEXT_SCALES[scale] * _EM)
    cited = "" if picture.cited is None else f"{picture.cited.where}:  {picture.cited.text}"
    return PageWords(title, "", formula, cited, note)


def _html(words: str) -> str:
    """A sentence as HTML; variables in it become formulas."""
    return mathml_line(words) if has_symbols(words) else escaped(words)


def handle_at(handles: Sequence[Handle], given: Given, point: complex, reach: float) -> Handle | None:
    """The handle that a press takes hold of: the nearest within reach, else one within whose ball it is; world units."""
    near = [(abs(handle.position(given) - point), k) for k, handle in enumerate(handles)]
    found = [one for one in near if one[0] <= reach]
    found = found or [(far, k) for far, k in near if (own := handles[k].reach) is not None and far <= own(given)]
    return handles[min(found)[1]] if found else None


def _panes(size: tuple[int, int], count: int) -> tuple[PaneArea, ...]:
    """The areas of the panes: side by side; on a narrow canvas one above the other."""
    room = complex(*size)
    beside = room.real >= room.imag
    extent = complex(room.real / count, room.imag) if beside else complex(room.real, room.imag / count)
    step = complex(extent.real, 0.0) if beside else complex(0.0, extent.imag)
    return tuple([PaneArea(k * step, extent) for k in range(count)])
