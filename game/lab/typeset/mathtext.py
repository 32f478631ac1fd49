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
_SIGNS = {"°": r"{}^\circ", ".": r"\text{.}"}
"""Signs of numbers that mathtext would set otherwise, such as a point with the space after a sentence."""
_CLOSE, _CLOSED = 79, "Z"
"""matplotlib's codes of a path's parts, as SVG has them."""


class SetLine(NamedTuple):
    """A formula as a picture. shades: [row, column], 0 transparent to 255 opaque. baseline: rows from the top to it."""

    shades: NDArray[np.uint8]
    baseline: int


class _SetPiece(NamedTuple):
    """A piece as a picture. shades, baseline: as of `SetLine`. advance: from its left edge to the next piece's, pixels."""

    shades: NDArray[np.uint8]
    baseline: int
    advance: float


@cache
def can_typeset() -> bool:
    """Whether matplotlib is installed."""
    return find_spec("matplotlib") is not None


def set_line(line: str, size: float) -> SetLine:
    """A line of the lab, set. size: of its letters, their em square, pixels. ValueError where mathtext cannot set it."""
    placed: list[tuple[int, _SetPiece]] = []
    end = 0.0
    for piece in pieces(line):
        end += piece.gap * size
        for part in [_set(one, size) for one in _signs(piece)] if not piece.gap else ():
            placed.append((round(end), part))
            end += part.advance
    rise = max([part.baseline for _, part in placed], default=round(size))
    depth = max([part.shades.shape[0] - part.baseline for _, part in placed], default=0)
    width = max([left + part.shades.shape[1] for left, part in placed] + [round(end), 1])
    shades = np.zeros((rise + depth, width), np.uint8)
    for left, part in placed:
        (rows, columns), top = part.shades.shape, rise - part.baseline
        box = shades[top : top + rows, left : left + columns]
        np.maximum(box, part.shades, out=box)
    return SetLine(shades, rise)


@lru_cache(maxsize=_MOST_PIECES)
def outline(line: str, size: float) -> str:
    """A line of the lab as an SVG path whose y grows upwards from the baseline. size, errors: as of `set_line`."""
    from matplotlib.textpath import TextPath  # noqa: PLC0415  # see above

    found: Any = TextPath((0.0, 0.0), tex_line(line), size, _font(size))
    segments = found.iter_segments(curves=True, simplify=False)
    parts = [_CLOSED if code == _CLOSE else f"{_CURVES[int(code)]}{_numbers(points)}" for points, code in segments]
    return "".join(parts)


def _signs(piece: Piece) -> tuple[Piece, ...]:
    """A number as one piece for each of its signs, of which there are few; any other piece is one."""
    if not piece.number:
        return (piece,)
    return tuple([Piece(_SIGNS.get(sign, sign)) for sign in piece.number])


@lru_cache(maxsize=_MOST_PIECES)
def _set(piece: Piece, size: float) -> _SetPiece:
    """One piece. A sign of a number takes as much room as every digit does, so that nothing moves while a number changes."""
    tex = f"${piece.tex}$"
    found = _parser("agg").parse(tex, _DOTS, _font(size))
    shades = np.array(found.image, dtype=np.uint8)
    rows = round(shades.shape[0] - found.depth)
    if rows > shades.shape[0]:  # all of it is above the baseline
        shades = np.pad(shades, ((0, rows - shades.shape[0]), (0, 0)))
    of_number = len(piece.tex) == 1 or piece.tex == _SIGNS["."]
    advance = float(_parser("path").parse(tex, _DOTS, _font(size)).width) if of_number else float(shades.shape[1])
    return _SetPiece(shades, max(rows, 0), advance)


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
