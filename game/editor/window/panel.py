"""The editor's panel: numbers, brushes, symmetry, commands; and the lines below the arena."""

from typing import NamedTuple

import pygame

from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, layer_colour
from game.drawing.raster.primitives import draw_box
from game.editor.document import value_at
from game.editor.session import EditorSession
from game.editor.window.layout import (
    BUTTON_TEXT,
    CHIP_TEXT,
    HEADING,
    MESSAGE,
    ROW_TEXT,
    TITLE,
    EditorLayout,
)
from game.editor.window.targets import Target, TargetKind, box_of
from game.language import tr

# Lengths are in units of text.
_CORNER, _EDGE, _INSET = 0.35, 0.08, 0.4
_STEPPER = 1.3
"""Width of the signs that a click on steps a number by."""


def stepper_at(box: pygame.Rect, pixel: complex, unit: float) -> int:
    """-1 or +1 where a pixel of a row's box is on one of its two signs, else 0."""
    width = round(unit * _STEPPER)
    if pixel.real >= box.right - width:
        return 1
    return -1 if pixel.real >= box.right - 2 * width else 0


class PanelState(NamedTuple):
    """What the player does with the panel.

    target: that keys and gamepad have chosen. has_keys: whether they act on it, not on the arena. typed: what is being entered
    into the number that is chosen; None for nothing. hint: how to go on, for who uses keys, mouse or gamepad.
    """

    target: Target
    has_keys: bool
    typed: str | None
    hint: str


def draw_panel(canvas: Canvas, seen: EditorLayout, session: EditorSession, state: PanelState, name: str) -> None:
    """Everything beside the arena. name: of the file."""
    level, theme = session.document.level, canvas.theme
    title = f"{level.name} *" if session.changed else level.name
    _write_fitted(canvas, title, TITLE, theme.accent if session.changed else theme.text, seen.title)
    heading = tr("rings[{index}]    Page up: next of {count}").format(index=session.ring, count=len(level.rings))
    _write(canvas, heading, HEADING, theme.faint, seen.ring_heading)
    _write(canvas, tr("Ball and paddles"), HEADING, theme.faint, seen.arena_heading)
    if state.has_keys or state.target.kind is TargetKind.NUMBER:
        edge = theme.accent if state.has_keys else theme.panel_edge
        draw_box(canvas.surface, box_of(state.target, seen), canvas.unit * _CORNER, theme.panel, edge, canvas.unit * _EDGE)
    for index, (row, box) in enumerate(seen.rows):
        chosen = state.target == Target(TargetKind.NUMBER, index) and (state.has_keys or state.typed is not None)
        colour = theme.accent if chosen else theme.text
        left = complex(box.left + canvas.unit * _INSET, box.centery)
        canvas.write(row.name, ROW_TEXT, colour, left, "midleft")
        shown = f"{state.typed}_" if chosen and state.typed is not None else f"{value_at(session.document, row.path):g}"
        width = canvas.unit * _STEPPER
        canvas.write(shown, ROW_TEXT, colour, complex(box.right - 2.0 * width - canvas.unit * 0.2, box.centery), "midright")
        canvas.write("-", ROW_TEXT, theme.faint, complex(box.right - 1.5 * width, box.centery), "center")
        canvas.write("+", ROW_TEXT, theme.faint, complex(box.right - 0.5 * width, box.centery), "center")
    _write(canvas, tr("Brush: layers; 0 is a gap, - never breaks"), HEADING, theme.faint, seen.brush_heading)
    for layers, box in seen.chips:
        _draw_chip(
            canvas, box, "-" if layers < 0 else str(layers), _brush_colour(canvas, layers), chosen=layers == session.brush
        )
    _write(canvas, tr("Repeat a stroke around the ring (key R)"), HEADING, theme.faint, seen.fold_heading)
    for fold, box in seen.folds:
        _draw_chip(canvas, box, f"x{fold}", theme.panel, chosen=fold == session.symmetry.fold)
    for index, (button, box) in enumerate(seen.buttons):
        on = button.name == "mirror" and session.symmetry.mirrored
        chosen = state.has_keys and state.target == Target(TargetKind.COMMAND, index)
        draw_box(
            canvas.surface,
            box,
            canvas.unit * _CORNER,
            theme.panel,
            theme.accent if on or chosen else theme.panel_edge,
            canvas.unit * _EDGE * (2.5 if chosen else 1.0),
        )
        colour = theme.accent if chosen else theme.text
        canvas.write(tr(button.label), BUTTON_TEXT, colour, complex(box.left + canvas.unit * _INSET, box.centery), "midleft")
        right = complex(box.right - canvas.unit * _INSET, box.centery)
        canvas.write(button.key, BUTTON_TEXT * 0.85, theme.faint, right, "midright")
    _draw_foot(canvas, seen, session, name, state.hint)


def _draw_foot(canvas: Canvas, seen: EditorLayout, session: EditorSession, name: str, hint: str) -> None:
    """The file, and below it what is wrong, if anything, or how to go on."""
    theme, box = canvas.theme, seen.foot
    wrong = session.message or session.document.problem
    lines = canvas.type.wrapped(wrong or hint, canvas.unit * MESSAGE, float(box.width))[:2]
    for number, line in enumerate([name, *lines][: 3 if len(lines) > 1 else 2]):
        colour = theme.faint if number == 0 else theme.danger if wrong else theme.text
        y = box.top + canvas.unit * (0.95 * number)
        canvas.write(line, MESSAGE * 0.9, colour, complex(box.centerx, y), "midtop")


def _draw_chip(canvas: Canvas, box: pygame.Rect, label: str, colour: Colour, *, chosen: bool) -> None:
    """One choice of several beside each other."""
    theme = canvas.theme
    edge, width = (theme.accent, 2.5 * _EDGE) if chosen else (theme.panel_edge, _EDGE)
    draw_box(canvas.surface, box, canvas.unit * _CORNER, colour, edge, canvas.unit * width)
    dark = sum(colour) < 3 * 128
    canvas.write(label, CHIP_TEXT, (255, 255, 255) if dark else (0, 0, 0), complex(*box.center), "center")


def _brush_colour(canvas: Canvas, layers: int) -> Colour:
    """The colour of what a brush puts."""
    if layers > 0:
        return layer_colour(canvas.theme, layers)
    return canvas.theme.ground if layers == 0 else canvas.theme.steel


def _write(canvas: Canvas, text: str, size: float, colour: Colour, box: pygame.Rect) -> None:
    """A line at the lower left of its box."""
    canvas.write(text, size, colour, complex(box.left, box.bottom - canvas.unit * 0.1), "bottomleft")


def _write_fitted(canvas: Canvas, text: str, size: float, colour: Colour, box: pygame.Rect) -> None:
    """A line in the middle of its box's height, smaller where it would not fit into the width."""
    width = canvas.type.rendered(text, canvas.unit * size, colour).get_width()
    canvas.write(text, size * min(box.width / max(width, 1), 1.0), colour, complex(box.left, box.centery), "midleft")
