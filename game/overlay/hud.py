"""What the player reads while playing: score, combo, lives, level, and how many layers are left."""

import math

from game.drawing.camera import Layout
from game.drawing.canvas import Canvas
from game.drawing.letter_sizes import stepped
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_circle, draw_dot
from game.effects import Streak
from game.effects.streaks import BUMP_TICKS, ENDED_TICKS
from game.input.key_names import key_name
from game.input.keys import Action
from game.language import ntr, tr
from game.overlay.readings import Readings
from game.rules import BEST_COMBO, LIVES

# Lengths are in units of text.
_EDGE = 0.8
"""From the figures to the surface's edges."""
_CAPTION, _FIGURE, _LEVEL_NAME = 0.9, 2.0, 1.3
"""Sizes of letters."""
_LINE_GAP = 0.25
"""Between lines of text in the lower corners."""
_COMBO, _COMBO_PER_BRICK = 1.2, 0.12
"""Size of the combo's letters for no brick, and how much larger with every brick up to the best combo."""
_BUMP = 0.45
"""Share by which the combo is larger when it has just risen."""
_COMBO_HEIGHT, _COMBO_DOTS = 1.1, 2.6
"""From the top of the combo's box to the middle of its words, and to its dots."""
_COMBO_WIDTH = 6.0
"""Of words and dots: these are drawn smaller where they would reach into the arena."""
_COMBO_DOT, _COMBO_DOT_PITCH, _COMBO_DOT_LINE = 0.24, 0.72, 0.07
"""Radius of a dot, from one to the next, and the line of an empty one."""
_LIFE, _LIFE_PITCH, _LIFE_LINE = 0.42, 1.134, 0.08
"""Radius of a ball that stands for a life, from one to the next, and the line of one that is lost."""
_LIVES_BELOW_CAPTION = 0.75


def draw(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """The figures in the four corners of a layout."""
    theme, unit, (width, height) = canvas.theme, canvas.unit, layout.size
    left, right, top, bottom = unit * _EDGE, width - unit * _EDGE, unit * _EDGE, height - unit * _EDGE
    box = canvas.write(tr("SCORE"), _CAPTION, theme.faint, complex(left, top))
    box = canvas.write(f"{shown.score:,}", _FIGURE, theme.text, complex(left, box.bottom + unit * 0.1))
    streak = shown.streak if shown.streak.bricks else Streak(shown.combo, BUMP_TICKS)
    if streak.bricks > 1:
        corner = complex(box.left, box.bottom + unit * 0.3) if layout.beside else complex(box.right + unit, box.top)
        room = _room(layout, corner + 1j * unit * _COMBO_DOTS) if layout.beside else width
        _draw_combo(canvas._replace(unit=min(unit, room / _COMBO_WIDTH)), streak, corner)
    box = canvas.write(tr("LIVES"), _CAPTION, theme.faint, complex(right, top), "topright")
    _draw_lives(canvas, complex(right, box.bottom + unit * _LIVES_BELOW_CAPTION), shown.lives)
    room = _room(layout, complex(left, bottom - unit * _LEVEL_NAME)) if layout.beside else width
    wide = canvas.type.rendered(shown.level_name, unit * _LEVEL_NAME, theme.text).get_width()
    size = _LEVEL_NAME * min(room / max(wide, 1), 1.0)
    box = canvas.write(shown.level_name, size, theme.text, complex(left, bottom), "bottomleft")
    number = tr("LEVEL {number} of {count}").format(number=shown.level_number, count=shown.level_count)
    canvas.write(number, _CAPTION, theme.faint, complex(left, box.top - unit * 0.2), "bottomleft")
    muted = tr("sound off ({key})").format(key=key_name(Action.MUTE)) if shown.muted else ""
    lines = (
        (tr("{key}  help").format(key=key_name(Action.HELP)), theme.faint),
        (ntr("{count} layer left", "{count} layers left", shown.layers).format(count=shown.layers), theme.text),
        *[(line, theme.accent) for line in (muted, *shown.badge.split(", ")) if line],
    )
    for text, colour in lines:
        box = canvas.write(text, _CAPTION, colour, complex(right, bottom), "bottomright")
        bottom = box.top - unit * _LINE_GAP


def _room(layout: Layout, pixel: complex) -> float:
    """How far a line may go to the right of a pixel until it meets the arena, pixels; at least a sixth of the surface."""
    middle, radius = layout.camera.centre, layout.ground_radius * layout.camera.scale
    half = math.sqrt(max(radius**2 - (pixel.imag - middle.imag) ** 2, 0.0))
    return max(middle.real - half - pixel.real, layout.size[0] / 6.0)


def _draw_combo(canvas: Canvas, streak: Streak, corner: complex) -> None:
    """The bricks in a row, and a dot for each that raises the points. corner: upper left, pixels."""
    theme, unit, best = canvas.theme, canvas.unit, min(streak.bricks, BEST_COMBO)
    fade = streak.age / ENDED_TICKS if streak.ended else 0.0
    colour = mixed(theme.faint if streak.ended else theme.accent, theme.background, fade)
    bump = 0.0 if streak.ended else _BUMP * max(1.0 - streak.age / BUMP_TICKS, 0.0) ** 2
    size = stepped((_COMBO + _COMBO_PER_BRICK * best) * (1.0 + bump))
    canvas.write(tr("combo x{count}").format(count=streak.bricks), size, colour, corner + 1j * unit * _COMBO_HEIGHT, "midleft")
    radius = unit * _COMBO_DOT
    for index in range(BEST_COMBO):
        pixel = corner + complex(radius + index * unit * _COMBO_DOT_PITCH, unit * _COMBO_DOTS)
        if index < best:
            draw_dot(canvas.surface, pixel, radius, colour)
        else:
            draw_circle(canvas.surface, pixel, radius, unit * _COMBO_DOT_LINE, theme.panel_edge)


def _draw_lives(canvas: Canvas, right: complex, lives: int) -> None:
    """A ball per life, from right to left; those lost are hollow. right: pixel at the right end of their row."""
    theme, unit, radius = canvas.theme, canvas.unit, canvas.unit * _LIFE
    for index in range(max(LIVES, lives)):
        pixel = right - complex(radius + index * unit * _LIFE_PITCH, 0.0)
        if index < lives:
            draw_dot(canvas.surface, pixel, radius, theme.ball)
        else:
            draw_circle(canvas.surface, pixel, radius, unit * _LIFE_LINE, theme.faint)
