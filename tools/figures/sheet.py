"""A sheet to draw a figure of plane geometry on, and the SVG file it becomes: the same bytes each time.

Words are text of the file, so that they can be searched and read aloud. Mathematics is set by matplotlib, as outlines.
"""

import cmath
import math
from html import escape
from pathlib import Path

import matplotlib as mpl
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

INK, FAINT, PAPER = "#14162b", "#5d678c", "#ffffff"
SECTOR, SECTOR_EDGE, BALL = "#9fd6d0", "#00716e", "#d9dbe6"
NORMAL, VELOCITY, CHANGE = "#a84300", "#2f49c8", "#8a2be2"

_FONT = FontProperties(family="DejaVu Sans", math_fontfamily="stix")
_LEADING, _MIDDLE = 1.35, 0.36
"""From one line of words to the next, and from the base line up to the middle of a letter, in sizes of the type."""
_HEAD = (3.0, 9.0, 0.36)
"""An arrow's head: points long with a line of no width, points more for each of it, and half as wide as long less this."""
_WORDS = 'font-family="DejaVu Sans, Verdana, sans-serif"'
_ANCHORS = {"middle": "middle", "left": "start"}
_DASHES = ' stroke-dasharray="6 5"'
_PATH_LETTERS = {1: ("M", 1), 2: ("L", 1), 3: ("Q", 2), 4: ("C", 3)}
"""Of matplotlib's codes for the parts of an outline: the SVG letter, and how many points belong to one part."""


class Sheet:
    """Part of the plane, drawn to scale, what is drawn later above. Points are complex numbers with y up, angles radians.

    Lengths and radii are in the plane's unit; sizes of type, widths of lines and radii of dots are points on the sheet.
    """

    def __init__(self, low: complex, high: complex, width: int) -> None:
        """Show the rectangle from its lower left to its upper right corner, `width` points wide."""
        self._low, self._high = low, high
        self._scale = width / (high - low).real
        self._size = (width, round(self._scale * (high - low).imag))
        self._parts: list[str] = []

    def save(self, path: Path) -> None:
        """Write the sheet as an SVG file."""
        width, height = self._size
        size = f'width="{width}" height="{height}"'
        head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {width} {height}" {_WORDS}>'
        made = f"<!-- the outlines of mathematics are those of matplotlib {mpl.__version__} -->"
        paper = f'<rect {size} fill="{PAPER}"/>'
        path.write_text("\n".join([head, made, paper, *self._parts, "</svg>", ""]), encoding="utf-8", newline="\n")

    def text(self, at: complex, words: str, *, colour: str = INK, size: float = 17, align: str = "middle") -> None:
        """Lines of words, with mathematics between dollars, centred about a point; align: middle, or left of them all."""
        lines = words.split("\n")
        for k, line in enumerate(lines):
            down = (k - (len(lines) - 1) / 2) * _LEADING * size + _MIDDLE * size
            foot = self._on_sheet(at) + complex(0.0, down)
            if "$" in line:
                self._mathematics(foot, line, colour, size, align)
            else:
                words_at = f'x="{_number(foot.real)}" y="{_number(foot.imag)}" text-anchor="{_ANCHORS[align]}"'
                self._parts.append(f'<text {words_at} font-size="{_number(size)}" fill="{colour}">{escape(line)}</text>')

    def dot(self, at: complex, *, colour: str = INK, radius: float = 3.6) -> None:
        """A point."""
        self._parts.append(f'<circle {_centre(self._on_sheet(at))} r="{_number(radius)}" fill="{colour}"/>')

    def line(self, *points: complex, colour: str = INK, width: float = 1.4, dashed: bool = False) -> None:
        """A line through points."""
        corners = " ".join([_pair(self._on_sheet(p)) for p in points])
        self._parts.append(
            f'<polyline points="{corners}" fill="none" stroke="{colour}" stroke-width="{_number(width)}"'
            f' stroke-linejoin="round"{_DASHES if dashed else ""}/>'
        )

    def arrow(self, start: complex, end: complex, *, colour: str = INK, width: float = 2.6) -> None:
        """An arrow whose head points to where it ends."""
        tip = self._on_sheet(end)
        along = tip - self._on_sheet(start)
        along /= abs(along)
        base, more, slender = _HEAD
        length = base + more * math.sqrt(width)
        foot = tip - along * length
        side = along * 1j * length * slender
        neck = end - (end - start) / abs(end - start) * length / self._scale * 0.8
        self.line(start, neck, colour=colour, width=width)
        corners = " ".join([_pair(p) for p in (tip, foot + side, foot - side)])
        self._parts.append(f'<polygon points="{corners}" fill="{colour}"/>')

    def angle(self, radius: float, start: float, stop: float, *, colour: str = INK) -> None:
        """The arc of an angle about the origin, from `start` to `stop`, with an arrow's head there."""
        last = stop - math.copysign(0.35 / radius, stop - start)
        self.arc(radius, start, last, colour=colour, dashed=False)
        self.arrow(cmath.rect(radius, last), cmath.rect(radius, stop), colour=colour, width=1.4)

    def arc(self, radius: float, start: float, stop: float, *, colour: str = FAINT, dashed: bool = True) -> None:
        """Part of a circle about the origin, less than half of it."""
        self._parts.append(
            f'<path d="M{_pair(self._on_sheet(cmath.rect(radius, start)))} {self._arc_to(radius, start, stop)}" fill="none"'
            f' stroke="{colour}" stroke-width="1.4"{_DASHES if dashed else ""}/>'
        )

    def circle(self, centre: complex, radius: float, *, colour: str = INK, fill: str = "none", dashed: bool = False) -> None:
        """A circle."""
        self._parts.append(
            f'<circle {_centre(self._on_sheet(centre))} r="{_number(radius * self._scale)}" fill="{fill}" stroke="{colour}"'
            f' stroke-width="1.6"{_DASHES if dashed else ""}/>'
        )

    def sector(self, inner: float, outer: float, start: float, stop: float) -> None:
        """An annular sector about the origin, from angle `start` counter-clockwise to `stop`, less than half a ring."""
        out = f"M{_pair(self._on_sheet(cmath.rect(outer, start)))} {self._arc_to(outer, start, stop)}"
        back = f"L{_pair(self._on_sheet(cmath.rect(inner, stop)))} {self._arc_to(inner, stop, start)}"
        self._parts.append(f'<path d="{out} {back} Z" fill="{SECTOR}" stroke="{SECTOR_EDGE}" stroke-width="1.8"/>')

    def box(self, low: complex, high: complex, words: str, *, fill: str = PAPER, size: float = 13) -> None:
        """A box with rounded corners and words in its middle."""
        corner = self._on_sheet(complex(low.real, high.imag))
        edge = (high - low) * self._scale
        self._parts.append(
            f'<rect x="{_number(corner.real)}" y="{_number(corner.imag)}" width="{_number(edge.real)}"'
            f' height="{_number(edge.imag)}" rx="8" fill="{fill}" stroke="{INK}" stroke-width="1.3"/>'
        )
        if words:
            self.text((low + high) / 2, words, size=size)

    def _mathematics(self, foot: complex, line: str, colour: str, size: float, align: str) -> None:
        """A line with mathematics in it, on a base line at a point of the sheet."""
        outline = TextPath((0.0, 0.0), line, size=size, prop=_FONT)
        box = outline.get_extents()
        left = 0.0 if align == "left" else (box.x0 + box.x1) / 2
        self._parts.append(f'<path class="mathematics" fill="{colour}" d="{_outline(outline, foot - left)}"/>')

    def _on_sheet(self, p: complex) -> complex:
        """A point of the plane on the sheet, whose y points down."""
        return complex(p.real - self._low.real, self._high.imag - p.imag) * self._scale

    def _arc_to(self, radius: float, start: float, stop: float) -> str:
        """The part of an outline that is an arc about the origin to the angle `stop`."""
        r = _number(radius * self._scale)
        return f"A{r} {r} 0 0 {int(stop < start)} {_pair(self._on_sheet(cmath.rect(radius, stop)))}"


def _number(value: float) -> str:
    """A number as it is written into the file, to a hundredth of a point: rounding of the last bits shows nowhere."""
    return f"{round(value, 2) + 0.0:g}" if abs(value) < 1e4 else f"{value:.2f}"


def _pair(p: complex) -> str:
    """A point as it is written into the file."""
    return f"{_number(p.real)},{_number(p.imag)}"


def _centre(p: complex) -> str:
    """A circle's centre as it is written into the file."""
    return f'cx="{_number(p.real)}" cy="{_number(p.imag)}"'


def _outline(outline: TextPath, at: complex) -> str:
    """The outline of letters as it is written into the file, its origin at a point."""
    words = []
    for vertices, code in outline.iter_segments(simplify=False, curves=True):
        if int(code) not in _PATH_LETTERS:
            words.append("Z")
            continue
        letter, count = _PATH_LETTERS[int(code)]
        points = [at + complex(vertices[2 * k], -vertices[2 * k + 1]) for k in range(count)]
        words.append(letter + " ".join([_pair(p) for p in points]))
    return "".join(words)
