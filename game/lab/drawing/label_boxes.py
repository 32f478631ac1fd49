"""Layout of a pane's labels, for every painter: each beside its mark, none on top of another.

Needs neither pygame nor numpy.
"""

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from game.drawing.palette import Colour
from game.lab.drawing.seen import SeenPane
from game.lab.drawing.wanted_labels import WantedLabel, wanted_label
from game.lab.kit.picture import Mark

_ASIDE = (0.0, -0.55, 0.55, -1.1, 1.1, -1.7, 1.7)
_UP = (0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0)
"""How far a label may be moved from the wanted position, in its widths and heights."""
_EDGE = 2
"""Pixels between a label and the border of its pane."""
_OUTSIDE = 2.0
"""A label wanted outside of its pane by up to this many sizes of letters stands at the edge; farther out it is left out."""
_TITLE_TOP = 0.4
"""From a pane's upper edge to its title, in units."""


class LabelBox(NamedTuple):
    """A rectangle of whole pixels; left, top: its upper left corner."""

    left: int
    top: int
    width: int
    height: int

    def moved(self, aside: float, down: float) -> "LabelBox":
        """The box moved to the right and down, pixels."""
        return self._replace(left=self.left + int(aside), top=self.top + int(down))

    def within(self, area: "LabelBox") -> "LabelBox":
        """The box moved into an area; centred on an area that is smaller."""
        left, top = (_clamped(*one) for one in zip(self[:2], self[2:], area[:2], area[2:], strict=True))
        return self._replace(left=left, top=top)

    def covers(self, other: "LabelBox") -> bool:
        """Whether the two have a pixel in common."""
        across = self.left < other.left + other.width and other.left < self.left + self.width
        return across and self.top < other.top + other.height and other.top < self.top + self.height


class BoxedLabel(NamedTuple):
    """A label and its box."""

    box: LabelBox
    text: str
    colour: Colour


class LabelledPane(SeenPane, Protocol):
    """A pane that labels are written in."""

    @property
    def words_area(self) -> LabelBox:
        """The part of the pane in which labels can be read."""

    def measured(self, text: str) -> tuple[int, int]:
        """Width and height of a line of text, pixels."""

    def wrapped(self, text: str, width: float) -> list[str]:
        """A text wrapped into lines of at most this width, pixels."""


def boxed_labels(
    pane: LabelledPane, marks: Sequence[Mark], title: str = "", handles: Sequence[complex] = ()
) -> list[BoxedLabel]:
    """The title of a pane and the labels of its marks. handles: pixels that labels leave free if there is room elsewhere.

    Labels are placed in the order of their marks, so that a label stays where it is when more marks appear. A label without
    room near its mark is left out.
    """
    reach = round(pane.unit)
    rings = [LabelBox(round(one.real) - reach // 2, round(one.imag) - reach // 2, reach, reach) for one in handles]
    done = _title(pane, title)
    for mark in marks:
        wanted = wanted_label(pane, mark) if mark.toggle is None or mark.toggle in pane.shown else None
        if wanted is not None:
            done += boxed_label(pane, wanted, [one.box for one in done], rings)
    return done


def boxed_label(
    pane: LabelledPane, wanted: WantedLabel, taken: Sequence[LabelBox] = (), rings: Sequence[LabelBox] = ()
) -> list[BoxedLabel]:
    """A label at a position in the pane where it covers no other; None if there is none, or if its mark is far outside."""
    inside, reach = wanted.pixel - pane.corner, _OUTSIDE * pane.size
    if not (-reach <= inside.real < pane.extent.real + reach and -reach <= inside.imag < pane.extent.imag + reach):
        return []
    left, top, width, height = pane.words_area
    area = LabelBox(left + _EDGE, top + _EDGE, width - 2 * _EDGE, height - 2 * _EDGE)
    box = _free_box(_anchored(wanted, *pane.measured(wanted.text)), area, taken, rings)
    return [] if box is None else [BoxedLabel(box, wanted.text, wanted.colour)]


def _title(pane: LabelledPane, title: str) -> list[BoxedLabel]:
    """A pane's title at its top, in as many lines as it needs."""
    left, top, width, _ = pane.words_area
    bottom, done = top + pane.unit * _TITLE_TOP, list[BoxedLabel]()
    for line in pane.wrapped(title, width - 2.0 * pane.unit) if title else ():
        done += boxed_label(pane, WantedLabel(complex(left + width // 2, bottom), line, pane.theme.text, "midtop"))
        bottom = max([bottom, *[float(one.box.top + one.box.height) for one in done]])
    return done


def _anchored(wanted: WantedLabel, width: int, height: int) -> LabelBox:
    """The box of a label whose anchor is at the wanted pixel."""
    x, y = round(wanted.pixel.real), round(wanted.pixel.imag)
    left = {"midleft": x, "bottomleft": x, "midright": x - width}.get(wanted.anchor, x - width // 2)
    top = {"midtop": y, "midbottom": y - height, "bottomleft": y - height}.get(wanted.anchor, y - height // 2)
    return LabelBox(left, top, width, height)


def _free_box(box: LabelBox, area: LabelBox, taken: Sequence[LabelBox], rings: Sequence[LabelBox]) -> LabelBox | None:
    """The box inside the area, moved to the nearest position where it covers no other; None if there is none near."""
    wide, high = box.width + 2, box.height
    moves = sorted(itertools.product(_ASIDE, _UP), key=lambda move: math.hypot(move[0] * wide, move[1] * high))
    second_best: LabelBox | None = None
    for dx, dy in moves:
        moved = box.moved(dx * wide, dy * high).within(area)
        if any([moved.covers(other) for other in taken]):
            continue
        if not any([moved.covers(ring) for ring in rings]):
            return moved
        second_best = second_best or moved
    return second_best


def _clamped(start: int, length: int, low: int, room: int) -> int:
    """The start of an interval moved into the interval of length `room` that starts at `low`."""
    if length >= room:
        return low + room // 2 - length // 2
    return min(max(start, low), low + room - length)
