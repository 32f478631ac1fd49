"""The editor's panel: numbers, brushes, symmetry, commands; and the lines below the arena."""

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


def draw_panel(canvas: Canvas, seen: EditorLayout, session: EditorSession, selected: int, typed: str | None, name: str) -> None:
    """Everything beside the arena. selected: index of a row; typed: what is being entered into it; name: of the file."""
    level, theme = session.document.level, canvas.theme
    title = f"{level.name} *" if session.changed else level.name
    _write_fitted(canvas, title, TITLE, theme.accent if session.changed else theme.text, seen.title)
    heading = tr("rings[{index}]    Tab: next of {count}").format(index=session.ring, count=len(level.rings))
    _write(canvas, heading, HEADING, theme.faint, seen.ring_heading)
    _write(canvas, tr("Ball and paddles"), HEADING, theme.faint, seen.arena_heading)
    for index, (row, box) in enumerate(seen.rows):
        chosen = index == selected
        if chosen:
            draw_box(canvas.surface, box, canvas.unit * _CORNER, theme.panel, theme.accent, canvas.unit * _EDGE)
        colour = theme.accent if chosen else theme.text
        left = complex(box.left + canvas.unit * _INSET, box.centery)
        canvas.write(row.name, ROW_TEXT, colour, left, "midleft")
        shown = f"{typed}_" if chosen and typed is not None else f"{value_at(session.document, row.path):g}"
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
    for button, box in seen.buttons:
        on = button.name == "mirror" and session.symmetry.mirrored
        draw_box(
            canvas.surface,
            box,
            canvas.unit * _CORNER,
            theme.panel,
            theme.accent if on else theme.panel_edge,
            canvas.unit * _EDGE,
        )
        canvas.write(
            tr(button.label), BUTTON_TEXT, theme.text, complex(box.left + canvas.unit * _INSET, box.centery), "midleft"
        )
        right = complex(box.right - canvas.unit * _INSET, box.centery)
        canvas.write(button.key, BUTTON_TEXT * 0.85, theme.faint, right, "midright")
    _draw_foot(canvas, seen, session, name)


def _draw_foot(canvas: Canvas, seen: EditorLayout, session: EditorSession, name: str) -> None:
    """The file, and below it what is wrong, if anything, or how to paint."""
    theme, box = canvas.theme, seen.foot
    wrong = session.message or session.document.problem
    hint = tr("Left button: paint; right button: take away; wheel: brush. Click a number to type it.")
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
