"""The lines below the arena: what is under the cursor, what is wrong with the level, and what can be done."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour
from game.editor.document import stacks
from game.editor.fields import PanelPart
from game.editor.session import EditorSession
from game.language import ntr, tr
from game.screens.toolkit.plate import write_fitting
from physics import PERMANENT

_SIZES = (1.0, 0.92, 0.84, 0.76, 0.68, 0.6)
"""Sizes of the letters, in units of text; the largest one in which all lines fit is used."""
_LINE = 1.2
"""From line to line, in sizes of the letters."""

Line = tuple[str, Colour]


def cursor_words(session: EditorSession, part: PanelPart, at: tuple[int, int] | None) -> str:
    """A line about the slot under the cursor or the mouse. at: ring and slot; None for none."""
    level = session.document.level
    if part is PanelPart.WELLS:
        if not level.wells:
            return ""
        well = level.wells[session.well]
        words = tr("Well {number} of {count}: distance {distance:g}, angle {angle:g}°")
        return words.format(number=session.well + 1, count=len(level.wells), distance=well.distance, angle=well.angle)
    if at is None:
        return ""
    ring, slot = at
    stack = stacks(level.rings[ring])[slot]
    words = tr("{ring}, slot {slot} of {count}: {what}")
    return words.format(
        ring=f"rings[{ring}]", slot=slot, count=level.rings[ring].count, what=_stack_words(stack.layers or 0, stack.tint or 0)
    )


def draw_foot(canvas: Canvas, box: pygame.Rect, lines: list[Line]) -> None:
    """Draw lines below each other in a box, wrapped; in smaller letters if they would not fit."""
    wrapped: list[Line] = []
    for size in _SIZES:
        wrapped = [
            (part, colour)
            for text, colour in lines
            if text
            for part in canvas.type.wrapped(text, canvas.unit * size, box.width)
        ]
        if len(wrapped) * _LINE * size * canvas.unit <= box.height:
            break
    for number, (text, colour) in enumerate(wrapped):
        pixel = complex(box.centerx, box.top + canvas.unit * size * _LINE * number)
        write_fitting(canvas, text, size, colour, pixel, "midtop", box.width)


def _stack_words(layers: int, tint: int) -> str:
    """The content of a slot in words."""
    if layers == 0:
        return tr("gap")
    if layers == PERMANENT:
        return tr("never breaks")
    return ntr("{count} layer, colour {tint}", "{count} layers, colour {tint}", layers).format(count=layers, tint=tint)
