"""Formulas set by matplotlib's mathtext: as a grey picture to blend, and as an outline. Everything set is cached.

matplotlib takes a third of a second to load and is no part of the frozen application. So it is loaded with the first formula,
and `can_typeset` says whether it is there.
"""

from functools import cache, lru_cache
from importlib.util import find_spec
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.lab.typeset.tex import Piece, pieces, tex_line

_FAMILY = "stix"
_DOTS = 72.0
"""Dots per inch at which a point is a pixel."""
_MOST_PIECES = 512
_CURVES = {1: "M", 2: "L", 3: "Q", 4: "C"}
_CLOSE, _CLOSED = 79, "Z"
"""matplotlib's codes of a path's parts, as SVG has them."""


class SetLine(NamedTuple):
    """A formula as a picture. shades: [row, column], 0 transparent to 255 opaque. baseline: rows from the top to it."""

    shades: NDArray[np.uint8]
    baseline: int


class Outline(NamedTuple):
    """A formula as an SVG path; its y grows upwards from the baseline. width, rise, depth: of its box, pixels."""

    path: str
    width: float
    rise: float
    depth: float


@cache
def can_typeset() -> bool:
    """Whether matplotlib is installed."""
    return find_spec("matplotlib") is not None


def set_line(line: str, size: float) -> SetLine:
    """A line of the lab, set. size: of its letters, their em square, pixels. ValueError where mathtext cannot set it."""
    parts: list[SetLine] = []
    gaps: list[tuple[int, int]] = []
    for piece in pieces(line):
        if piece.gap:
            gaps.append((len(parts), round(piece.gap * size)))
        else:
            parts += [_set(one, size) for one in _signs(piece)]
    rise = max([part.baseline for part in parts], default=round(size))
    depth = max([part.shades.shape[0] - part.baseline for part in parts], default=0)
    columns: list[NDArray[np.uint8]] = []
    for index, part in enumerate(parts):
        columns += [np.zeros((rise + depth, pixels), np.uint8) for before, pixels in gaps if before == index]
        above = rise - part.baseline
        below = rise + depth - above - part.shades.shape[0]
        columns.append(np.pad(part.shades, ((above, below), (0, 0))))
    return SetLine(np.hstack(columns) if columns else np.zeros((rise, 1), np.uint8), rise)


@lru_cache(maxsize=_MOST_PIECES)
def outline(line: str, size: float) -> Outline:
    """A line of the lab as an outline. size, errors: as of `set_line`."""
    from matplotlib.textpath import TextPath  # noqa: PLC0415  # see above

    prop, tex = _font(size), tex_line(line)
    found: Any = TextPath((0.0, 0.0), tex, size, prop)
    box = _parser("path").parse(tex, _DOTS, prop)
    segments = found.iter_segments(curves=True, simplify=False)
    parts = [_CLOSED if code == _CLOSE else f"{_CURVES[int(code)]}{_numbers(points)}" for points, code in segments]
    return Outline("".join(parts), float(box.width), float(box.height - box.depth), float(box.depth))


def _signs(piece: Piece) -> tuple[Piece, ...]:
    """A number as one piece for each of its signs, of which there are few; any other piece is one."""
    if not piece.number:
        return (piece,)
    return tuple([Piece(r"{}^\circ" if sign == "°" else sign) for sign in piece.number])


@lru_cache(maxsize=_MOST_PIECES)
def _set(piece: Piece, size: float) -> SetLine:
    """One piece."""
    found = _parser("agg").parse(f"${piece.tex}$", _DOTS, _font(size))
    shades = np.array(found.image, dtype=np.uint8)
    rows = round(shades.shape[0] - found.depth)
    if rows > shades.shape[0]:  # all of it is above the baseline
        shades = np.pad(shades, ((0, rows - shades.shape[0]), (0, 0)))
    return SetLine(shades, max(rows, 0))


@cache
def _parser(kind: Literal["agg", "path"]) -> Any:
    """mathtext's parser."""
    from matplotlib.mathtext import MathTextParser  # noqa: PLC0415  # see above

    return MathTextParser(kind)


def _font(size: float) -> Any:
    """The letters."""
    from matplotlib.font_manager import FontProperties  # noqa: PLC0415  # see above

    return FontProperties(size=size, math_fontfamily=_FAMILY)


def _numbers(points: NDArray[np.float64]) -> str:
    """Coordinates as SVG has them."""
    return " ".join([f"{number:.2f}".rstrip("0").rstrip(".") for number in points])
