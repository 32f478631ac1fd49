"""What the player reads while playing: score, combo, lives, level, and how many layers are left.

Of two who play against each other, each has the left corner of the own half; the level is in the upper right corner then.
"""

import cmath
import math
from functools import lru_cache

import pygame

from game.drawing.camera import Camera, Layout
from game.drawing.canvas import Canvas
from game.drawing.letter_sizes import stepped
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.palettes import themed
from game.drawing.raster.primitives import draw_box, draw_circle, draw_dot
from game.effects import Streak
from game.effects.streaks import BUMP_TICKS, ENDED_TICKS
from game.input.key_names import key_name
from game.input.keys import Action
from game.language import grouped, ntr, tr
from game.overlay.readings import PlayerReadings, Readings
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
_WITH_GAUGES = 1.08
"""Radius of the arena with what lasts shown beyond its rim, in ground radii."""
_BESIDE, _RIM_PIXELS = 1.2, 160
"""What is at most so far above or below a line is beside it; and pixels of the rim that are looked at in 3D."""
_SWATCH, _SWATCH_GAP = (1.5, 0.42), 0.5
"""The sign in the colour of a player's paddle, and from it to the player's name."""
_PLAYER_SCORE, _PLAYER_LIVES, _PLAYER_HEIGHT = 1.1, 3.9, 4.4
"""From the top of a player's figures to the score and to the middle of the lives, and height of them all."""
_PLAYER_COMBO, _AHEAD = 4.0, 1.1
"""Heights of the combo and of the line that says who is ahead; both are on the side of a player's figures that is nearer to the
middle."""


def draw(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """The figures in the four corners of a layout."""
    if shown.players:
        _draw_players(canvas, shown, layout)
    else:
        _draw_score(canvas, shown, layout)
    _draw_level(canvas, shown, layout)
    _draw_foot(canvas, shown, complex(*layout.size) - complex(1, 1) * canvas.unit * _EDGE)


def paddle_colours(theme: Theme, palette: str) -> tuple[Colour, Colour]:
    """The colours of the paddles of two who play against each other. palette: name of the arena's colours."""
    theme = themed(theme, palette)
    return theme.paddle_top, theme.text


def _draw_score(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """The score with the combo in the upper left corner, the lives in the upper right one."""
    theme, unit, width = canvas.theme, canvas.unit, layout.size[0]
    left, right, top = unit * _EDGE, width - unit * _EDGE, unit * _EDGE
    box = canvas.write(tr("SCORE"), _CAPTION, theme.faint, complex(left, top))
    box = canvas.write(grouped(shown.score), _FIGURE, theme.text, complex(left, box.bottom + unit * 0.1))
    corner = complex(box.right + unit, box.top)
    if layout.beside:
        below, aside = complex(box.left, box.bottom + unit * 0.3), complex(box.right + unit, top - unit * 0.4)
        wanted = min(_COMBO_WIDTH * unit, _combo_room(canvas, layout, aside))
        corner = below if _combo_room(canvas, layout, below) >= wanted else aside
    _draw_combo(canvas, shown, corner, layout)
    box = canvas.write(tr("LIVES"), _CAPTION, theme.faint, complex(right, top), "topright")
    pixel = complex(right, box.bottom + unit * _LIVES_BELOW_CAPTION)
    _draw_lives(canvas, pixel, shown.lives, -1.0)


def _draw_players(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """The figures of two players, each in the left corner of the own half."""
    longest = max([player.name for player in shown.players], key=len).upper()
    canvas = _fitting_player(canvas, longest, layout)
    for player, colour in zip(shown.players, paddle_colours(canvas.theme, shown.palette), strict=True):
        _draw_player(canvas, shown, player, colour, layout)


def _fitting_player(canvas: Canvas, name: str, layout: Layout) -> Canvas:
    """A canvas with smaller letters where a player's name would reach the arena; they are not smaller than usual."""
    letters = canvas.type.rendered(name, canvas.unit * _CAPTION, canvas.theme.text).get_width()
    wide = letters + canvas.unit * (_SWATCH[0] + _SWATCH_GAP)
    corner = complex(layout.unit * _EDGE, layout.unit * _EDGE + canvas.unit * _PLAYER_HEIGHT)
    room = _room(layout, corner) if layout.beside else layout.size[0]
    return canvas._replace(unit=min(max(canvas.unit * room / wide, layout.unit), canvas.unit))


def _draw_player(canvas: Canvas, shown: Readings, player: PlayerReadings, colour: Colour, layout: Layout) -> None:
    """A player's sign, name, score and lives, who is ahead, and the combo of the one for whom it counts.

    colour: of the player's paddle.
    """
    theme, unit, upper = canvas.theme, canvas.unit, player is shown.players[-1]
    corner = complex(1.0, 1.0) * layout.unit * _EDGE
    if not upper:
        corner = complex(corner.real, layout.size[1] - corner.imag - unit * _PLAYER_HEIGHT)
    sign = pygame.Rect(0, 0, round(unit * _SWATCH[0]), max(round(unit * _SWATCH[1]), 2))
    sign.midleft = (round(corner.real), round(corner.imag + unit * _CAPTION * 0.6))
    draw_box(canvas.surface, sign, sign.height / 2.0, colour)
    pixel = complex(sign.right + unit * _SWATCH_GAP, sign.centery)
    name = canvas.write(player.name.upper(), _CAPTION, theme.accent if player.leads else theme.faint, pixel, "midleft")
    score = canvas.write(grouped(player.score), _FIGURE, theme.text, corner + 1j * unit * _PLAYER_SCORE)
    _draw_lives(canvas, corner + 1j * unit * _PLAYER_LIVES, player.lives, 1.0)
    if player.leads:
        beyond = corner + 1j * unit * (_PLAYER_HEIGHT + 0.7 if upper else -0.7)
        pixel = beyond if layout.beside else complex(name.right + unit, name.centery)
        canvas.write(tr("AHEAD"), _CAPTION, theme.accent, pixel, "midleft")
    if player.scores:
        across = complex(max(score.right, corner.real + unit * _LIFE_PITCH * max(LIVES, player.lives)) + unit, score.top)
        offset = _PLAYER_HEIGHT + _AHEAD if upper else -_PLAYER_COMBO - _AHEAD
        _draw_combo(canvas, shown, corner + 1j * unit * offset if layout.beside else across, layout)


def _draw_level(canvas: Canvas, shown: Readings, layout: Layout) -> None:
    """Number and name of the level in the lower left corner, or in the upper right one where players have the left ones."""
    theme, unit, (width, height) = canvas.theme, canvas.unit, layout.size
    number = tr("LEVEL {number} of {count}").format(number=shown.level_number, count=shown.level_count)
    if shown.players:
        corner = complex(width - unit * _EDGE, unit * _EDGE)
        box = canvas.write(number, _CAPTION, theme.faint, corner, "topright")
        below = complex(corner.real, box.bottom + unit * 0.2)
        canvas.write(shown.level_name, _fitting(canvas, shown.level_name, below, layout), theme.text, below, "topright")
        return
    corner = complex(unit * _EDGE, height - unit * _EDGE)
    size = _fitting(canvas, shown.level_name, corner - 1j * unit * _LEVEL_NAME, layout)
    box = canvas.write(shown.level_name, size, theme.text, corner, "bottomleft")
    canvas.write(number, _CAPTION, theme.faint, complex(corner.real, box.top - unit * 0.2), "bottomleft")


def _fitting(canvas: Canvas, name: str, pixel: complex, layout: Layout) -> float:
    """Size of a level's name that begins or ends at a pixel, smaller where it would reach into the arena."""
    room = _room(layout, pixel) if layout.beside else layout.size[0]
    wide = canvas.type.rendered(name, canvas.unit * _LEVEL_NAME, canvas.theme.text).get_width()
    return _LEVEL_NAME * min(room / max(wide, 1), 1.0)


def _draw_foot(canvas: Canvas, shown: Readings, corner: complex) -> None:
    """How to get help, the layers that are left, and what else is to be known. corner: lower right, pixels."""
    theme, unit, right, bottom = canvas.theme, canvas.unit, corner.real, corner.imag
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
    """How far a line may go from a pixel towards the arena until it meets it, pixels; at least a sixth of the surface."""
    return max(_free(layout, pixel), layout.size[0] / 6.0)


def _free(layout: Layout, pixel: complex) -> float:
    """How far a line may go from a pixel towards the arena until it meets it, pixels; less than 0 within it."""
    camera, radius = layout.camera, layout.ground_radius * _WITH_GAUGES
    middle = camera.centre
    if camera.flat:
        half = math.sqrt(max((radius * camera.scale) ** 2 - (pixel.imag - middle.imag) ** 2, 0.0))
        return abs(middle.real - pixel.real) - half
    near = [abs(rim.real - pixel.real) for rim in _rim(camera._replace(azimuth=0.0), radius) if _is_beside(rim, pixel, layout)]
    return min(near, default=abs(middle.real - pixel.real))


def _is_beside(rim: complex, pixel: complex, layout: Layout) -> bool:
    """Whether a pixel of the rim is about as high as another, on the same side of the arena's middle."""
    middle = layout.camera.centre.real
    return abs(rim.imag - pixel.imag) < _BESIDE * layout.unit and (rim.real - middle) * (pixel.real - middle) >= 0.0


@lru_cache(maxsize=8)
def _rim(camera: Camera, radius: float) -> list[complex]:
    """Pixels around the arena. radius: world units."""
    return camera.pixels([cmath.rect(radius, math.tau * k / _RIM_PIXELS) for k in range(_RIM_PIXELS)])


def _combo_room(canvas: Canvas, layout: Layout, corner: complex) -> float:
    """How wide the combo may be, pixels, so that neither words nor dots meet the arena. corner: upper left, pixels."""
    return min([_free(layout, corner + 1j * canvas.unit * down) for down in (_COMBO_HEIGHT, _COMBO_DOTS)])


def _draw_combo(canvas: Canvas, shown: Readings, corner: complex, layout: Layout) -> None:
    """The bricks in a row, and a dot for each that raises the points; nothing for less than two. corner: upper left, pixels."""
    streak = shown.streak if shown.streak.bricks else Streak(shown.combo, BUMP_TICKS)
    if streak.bricks <= 1:
        return
    room = _room(layout, corner + 1j * canvas.unit * _COMBO_DOTS) if layout.beside else layout.size[0]
    canvas = canvas._replace(unit=min(canvas.unit, room / _COMBO_WIDTH))
    theme, unit, best = canvas.theme, canvas.unit, min(streak.bricks, BEST_COMBO)
    fade = streak.age / ENDED_TICKS if streak.ended else 0.0
    colour = mixed(theme.faint if streak.ended else theme.accent, theme.background, fade)
    bump = 0.0 if streak.ended else _BUMP * max(1.0 - streak.age / BUMP_TICKS, 0.0) ** 2
    size = stepped((_COMBO + _COMBO_PER_BRICK * best) * (1.0 + bump))
    canvas.write(tr("combo ×{count}").format(count=streak.bricks), size, colour, corner + 1j * unit * _COMBO_HEIGHT, "midleft")
    radius = unit * _COMBO_DOT
    for index in range(BEST_COMBO):
        pixel = corner + complex(radius + index * unit * _COMBO_DOT_PITCH, unit * _COMBO_DOTS)
        if index < best:
            draw_dot(canvas.surface, pixel, radius, colour)
        else:
            draw_circle(canvas.surface, pixel, radius, unit * _COMBO_DOT_LINE, theme.panel_edge)


def _draw_lives(canvas: Canvas, end: complex, lives: int, side: float) -> None:
    """A ball per life; those lost are hollow. end: pixel where their row begins; side: 1.0 to the right of it, -1.0 left."""
    theme, unit, radius = canvas.theme, canvas.unit, canvas.unit * _LIFE
    for index in range(max(LIVES, lives)):
        pixel = end + side * (radius + index * unit * _LIFE_PITCH)
        if index < lives:
            draw_dot(canvas.surface, pixel, radius, theme.ball)
        else:
            draw_circle(canvas.surface, pixel, radius, unit * _LIFE_LINE, theme.faint)
