"""Where the words of a pane stand: beside their marks, and nowhere two on top of each other."""

import itertools
import math
from collections.abc import Sequence

import pygame

from game.drawing.palette import Colour
from game.lab.drawing.canvas import PaneCanvas
from game.lab.drawing.shapes import PlacedLabel
from game.lab.drawing.strokes import rounded
from game.lab.drawing.wanted_labels import WantedLabel, wanted_label
from game.lab.kit.picture import Mark

_ASIDE = (0.0, -0.55, 0.55, -1.1, 1.1, -1.7, 1.7)
_UP = (0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0)
"""How far a label may be moved from where it would stand, in its widths and heights."""
_EDGE = 4
"""Pixels between a label and the border of its pane."""


def placed_labels(
    canvas: PaneCanvas, marks: Sequence[Mark], title: str = "", handles: Sequence[complex] = ()
) -> list[PlacedLabel]:
    """The title of a pane and the labels of its marks. handles: pixels that are left free if there is room elsewhere.

    Earlier marks choose first, so that a label stays while more appear. A label without room near its mark is left out.
    """
    reach = round(canvas.unit)
    rings = [pygame.Rect(round(one.real) - reach // 2, round(one.imag) - reach // 2, reach, reach) for one in handles]
    done = _title(canvas, title)
    for mark in marks:
        wanted = wanted_label(canvas, mark) if mark.toggle is None or mark.toggle in canvas.shown else None
        if wanted is not None:
            done += _placed(canvas, wanted, [one.box for one in done], rings)
    return done


def _title(canvas: PaneCanvas, title: str) -> list[PlacedLabel]:
    """A pane's title at its top, in as many lines as it needs."""
    lines = canvas.type.wrapped(title, canvas.size, canvas.free.width - 2.0 * canvas.unit)
    middle, top, done = canvas.free.centerx, canvas.free.top + canvas.unit * 0.4, list[PlacedLabel]()
    for line in lines:
        done += _placed(canvas, WantedLabel(complex(middle, top), line, canvas.theme.text, "midtop"), (), ())
        top = max([top, *[float(one.box.bottom) for one in done]])
    return done


def label_at(canvas: PaneCanvas, pixel: complex, text: str, colour: Colour, anchor: str = "center") -> list[PlacedLabel]:
    """Words at a pixel, moved into the pane where they stand out of it; none far outside of it. anchor: as in pygame.Rect."""
    return _placed(canvas, WantedLabel(pixel, text, colour, anchor), (), ())


def _placed(
    canvas: PaneCanvas, wanted: WantedLabel, taken: Sequence[pygame.Rect], rings: Sequence[pygame.Rect]
) -> list[PlacedLabel]:
    """A label where it covers no other; at most one."""
    size = canvas.size
    if not canvas.area.inflate(4 * size, 4 * size).collidepoint(wanted.pixel.real, wanted.pixel.imag):
        return []
    line = canvas.type.rendered(wanted.text, size, wanted.colour)
    box = _free_box(line.get_rect(**{wanted.anchor: rounded(wanted.pixel)}), canvas.free.inflate(-_EDGE, -_EDGE), taken, rings)
    return [] if box is None else [PlacedLabel(box, wanted.text, size, wanted.colour, canvas.theme.ground, canvas.plates)]


def _free_box(
    box: pygame.Rect, area: pygame.Rect, taken: Sequence[pygame.Rect], rings: Sequence[pygame.Rect]
) -> pygame.Rect | None:
    """The box inside the area, moved to the nearest position where it covers no other; None if there is none near."""
    wide, high = box.width + 2, box.height
    moves = sorted(itertools.product(_ASIDE, _UP), key=lambda move: math.hypot(move[0] * wide, move[1] * high))
    boxes = [box.move(dx * wide, dy * high).clamp(area) for dx, dy in moves]
    free = [one for one in boxes if one.collidelist(list(taken)) == -1]
    return next((one for one in free if one.collidelist(list(rings)) == -1), free[0] if free else None)
