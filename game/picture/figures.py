"""The figures in the corners: score, combo, lives, level, and how many layers are left; for pygame and for a browser.

If two play against each other, each has a left corner, the one beside their half of the arena; the level is in the upper right.
"""

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera, Layout
from game.drawing.letter_sizes import LINE, stepped, width
from game.drawing.palette import Colour, Theme, mixed
from game.drawing.palettes import themed
from game.effects import Streak
from game.effects.streaks import BUMP_TICKS, ENDED_TICKS
from game.language import grouped, ntr, tr
from game.overlay.readings import PlayerReadings, Readings
from game.picture.display_list import DisplayList
from game.rules import BEST_COMBO, LIVES

# Lengths are in units of text.
_EDGE = 0.8
"""From the figures to the surface's edges."""
_CAPTION, _FIGURE, _LEVEL_NAME = 0.9, 2.0, 1.3
"""Sizes of letters."""
_BELOW_CAPTION, _ABOVE_NAME, _LINE_GAP = 0.1, 0.2, 0.25
"""Between lines of text: below a caption, above or below the level's name, and in the lower right corner."""
_COMBO, _COMBO_PER_BRICK = 1.2, 0.12
"""Size of the combo's letters for no brick, and how much larger with every brick up to the best combo."""
_BUMP = 0.45
"""Share by which the combo is enlarged just after it has risen."""
_COMBO_BELOW, _COMBO_HEIGHT, _COMBO_DOTS = 0.3, 1.1, 2.6
"""From the score to the top of the combo's box, and from there to the middle of its words, and to its dots."""
_COMBO_WIDTH = 6.0
"""Of words and dots, which are drawn smaller if they would overlap the arena."""
_COMBO_DOT, _COMBO_DOT_PITCH, _COMBO_DOT_LINE = 0.24, 0.72, 0.07
"""Radius of a dot, from one to the next, and the line of an empty one."""
_LIFE, _LIFE_PITCH, _LIFE_LINE = 0.42, 1.134, 0.08
"""Radius of a ball that stands for a life, from one to the next, and the line of one that is lost."""
_LIVES_BELOW_CAPTION = 0.75
_WITH_GAUGES = 1.08
"""Radius of the arena with the gauges outside of its rim, in ground radii."""
_BESIDE, _RIM_PIXELS = 1.2, 160
"""What is at most so far above or below a line is beside it; and pixels of the rim that are looked at in 3D."""
_SWATCH, _SWATCH_GAP = complex(1.5, 0.42), 0.5
"""The sign in the colour of a player's paddle, and from it to the player's name."""
_PLAYER_SCORE, _PLAYER_LIVES, _PLAYER_HEIGHT = 1.1, 3.9, 4.4
"""From the top of a player's figures to the score and to the middle of the lives, and height of them all."""
_PLAYER_NAME = 0.54
"""From the top of a player's figures to the middle of the name."""
_PLAYER_COMBO, _AHEAD = 4.0, 1.1
"""Heights of the combo and of the line that says who is ahead; both are on the side of a player's figures that is nearer to the
middle."""


class Corners(NamedTuple):
    """Layout and look of the figures.

    layout: of the surface. theme: the colours. unit: size of text, pixels. keys: names of the keys that open the help and turn
    the sound on; "" if they are not shown.
    """

    layout: Layout
    theme: Theme
    unit: float
    keys: tuple[str, str] = ("", "")


def add_figures(out: DisplayList, shown: Readings, corners: Corners) -> None:
    """Add the figures in the four corners of a layout."""
    if shown.players:
        for player, colour in zip(shown.players, paddle_colours(corners.theme, shown.palette), strict=True):
            _add_player(out, shown, player, colour, corners)
    else:
        _add_score(out, shown, corners)
    _add_level(out, shown, corners)
    _add_foot(out, shown, corners)


def paddle_colours(theme: Theme, palette: str) -> tuple[Colour, Colour]:
    """The colours of the paddles of two opponents. palette: name of the arena's colours."""
    theme = themed(theme, palette)
    return theme.paddle_top, theme.text


def _add_score(out: DisplayList, shown: Readings, corners: Corners) -> None:
    """Add the score with the combo in the upper left corner, the lives in the upper right one."""
    layout, theme, unit, _ = corners
    corner, score = complex(1.0, 1.0) * unit * _EDGE, grouped(shown.score)
    below = unit * (_CAPTION * LINE + _BELOW_CAPTION)
    out.text(tr("SCORE"), unit * _CAPTION, corner + 0.5j * unit * _CAPTION * LINE, theme.faint, 0.0)
    out.text(score, unit * _FIGURE, corner + 1j * (below + unit * _FIGURE * LINE / 2.0), theme.text, 0.0)
    right_of_score = unit * (max(_FIGURE * width(score), _CAPTION * width(tr("SCORE"))) + 1.0)
    combo = corner + complex(right_of_score, below)
    if layout.beside:
        under, aside = corner + 1j * (below + unit * (_FIGURE * LINE + _COMBO_BELOW)), corner + right_of_score - 0.4j * unit
        wanted = min(_COMBO_WIDTH * unit, _combo_room(layout, aside, unit))
        combo = under if _combo_room(layout, under, unit) >= wanted else aside
    _add_combo(out, shown, combo, corners)
    right = complex(layout.size[0] - corner.real, corner.imag)
    out.text(tr("LIVES"), unit * _CAPTION, right + 0.5j * unit * _CAPTION * LINE, theme.faint, 1.0)
    _add_lives(out, right + 1j * unit * (_CAPTION * LINE + _LIVES_BELOW_CAPTION), shown.lives, -1.0, corners)


def _add_player(out: DisplayList, shown: Readings, player: PlayerReadings, colour: Colour, corners: Corners) -> None:
    """Add a player's mark, name, score and lives; whether the player is ahead; and the combo if it is the player's.

    colour: of the player's paddle.
    """
    layout, theme, unit, _ = corners
    upper, corner, score = player is shown.players[-1], complex(1.0, 1.0) * layout.unit * _EDGE, grouped(player.score)
    if not upper:
        corner = complex(corner.real, layout.size[1] - corner.imag - unit * _PLAYER_HEIGHT)
    middle, sign = corner + 1j * unit * _PLAYER_NAME, unit * _SWATCH
    out.box(middle - 0.5j * sign.imag, sign, sign.imag / 2.0, colour)
    name, begin = player.name.upper(), middle + sign.real + unit * _SWATCH_GAP
    room = (_room(layout, middle) if layout.beside else layout.size[0] / 2.0) - (begin - corner).real
    out.text(name, unit * _CAPTION, begin, theme.accent if player.leads else theme.faint, 0.0, room=room)
    out.text(score, unit * _FIGURE, corner + 1j * unit * (_PLAYER_SCORE + _FIGURE * LINE / 2.0), theme.text, 0.0)
    _add_lives(out, corner + 1j * unit * _PLAYER_LIVES, player.lives, 1.0, corners)
    if player.leads:
        beyond = corner + 1j * unit * (_PLAYER_HEIGHT + 0.7 if upper else -0.7)
        pixel = beyond if layout.beside else begin + unit * (_CAPTION * width(name) + 1.0)
        out.text(tr("AHEAD"), unit * _CAPTION, pixel, theme.accent, 0.0)
    if player.scores:
        right = max(_FIGURE * width(score), _LIFE_PITCH * max(LIVES, player.lives)) + 1.0
        across = corner + unit * complex(right, _PLAYER_SCORE)
        offset = _PLAYER_HEIGHT + _AHEAD if upper else -_PLAYER_COMBO - _AHEAD
        _add_combo(out, shown, corner + 1j * unit * offset if layout.beside else across, corners)


def _add_level(out: DisplayList, shown: Readings, corners: Corners) -> None:
    """Add number and name of the level in the lower left corner; in the upper right one if two opponents have the left ones."""
    layout, theme, unit, _ = corners
    number = tr("LEVEL {number} of {count}").format(number=shown.level_number, count=shown.level_count)
    caption, name, gap = unit * _CAPTION * LINE, unit * _LEVEL_NAME * LINE, unit * _ABOVE_NAME
    if shown.players:
        corner, across, down = (
            complex(layout.size[0] - unit * _EDGE, unit * _EDGE),
            1.0,
            (caption / 2.0, caption + gap + name / 2.0),
        )
    else:
        corner, across = complex(unit * _EDGE, layout.size[1] - unit * _EDGE), 0.0
        down = (-name - gap - caption / 2.0, -name / 2.0)
    room = _room(layout, corner + 1j * down[1]) if layout.beside else layout.size[0]
    out.text(number, unit * _CAPTION, corner + 1j * down[0], theme.faint, across)
    out.text(shown.level_name, unit * _LEVEL_NAME, corner + 1j * down[1], theme.text, across, room=room)


def _add_foot(out: DisplayList, shown: Readings, corners: Corners) -> None:
    """Add the key for help, the remaining layers, and other information, in the lower right corner."""
    layout, _, unit, _ = corners
    pixel = complex(*layout.size) - complex(1.0, 1.0) * unit * _EDGE - 0.5j * unit * _CAPTION * LINE
    for words, colour in _foot_lines(shown, corners):
        out.text(words, unit * _CAPTION, pixel, colour, 1.0)
        pixel -= 1j * unit * (_CAPTION * LINE + _LINE_GAP)


def foot_height(shown: Readings, corners: Corners) -> float:
    """Height of what is in the lower right corner, pixels."""
    return corners.unit * (_EDGE + (_CAPTION * LINE + _LINE_GAP) * len(_foot_lines(shown, corners)))


def _foot_lines(shown: Readings, corners: Corners) -> list[tuple[str, Colour]]:
    """The words of the lower right corner with their colours, from below."""
    _, theme, _, (help_key, sound_key) = corners
    muted = tr("sound off ({key})").format(key=sound_key) if shown.muted and sound_key else ""
    lines = (
        (tr("{key}  help").format(key=help_key) if help_key else "", theme.faint),
        (ntr("{count} layer left", "{count} layers left", shown.layers).format(count=shown.layers), theme.text),
        *[(line, theme.accent) for line in (muted, *shown.badge.split(", "))],
    )
    return [line for line in lines if line[0]]


def _room(layout: Layout, pixel: complex) -> float:
    """Length of a horizontal line from a pixel to the arena, pixels; at least a sixth of the surface."""
    return max(_free(layout, pixel), layout.size[0] / 6.0)


def _free(layout: Layout, pixel: complex) -> float:
    """Length of a horizontal line from a pixel to the arena, pixels; negative inside of it."""
    camera, radius = layout.camera, layout.ground_radius * _WITH_GAUGES
    if camera.flat:
        half = math.sqrt(max((radius * camera.scale) ** 2 - (pixel.imag - camera.centre.imag) ** 2, 0.0))
        return abs(camera.centre.real - pixel.real) - half
    return _free_aslant(camera._replace(azimuth=0.0), radius, pixel, _BESIDE * layout.unit)


@lru_cache(maxsize=64)
def _free_aslant(camera: Camera, radius: float, pixel: complex, beside: float) -> float:
    """As `_free`, in 3D. radius: of the arena, world units; beside: half the height of the line, pixels."""
    x, y, middle = pixel.real, pixel.imag, camera.centre.real
    near = [
        abs(rim.real - x)
        for rim in _rim(camera, radius)
        if abs(rim.imag - y) < beside and (rim.real - middle) * (x - middle) >= 0.0
    ]
    return min(near, default=abs(middle - x))


@lru_cache(maxsize=8)
def _rim(camera: Camera, radius: float) -> list[complex]:
    """Pixels around the arena. radius: world units."""
    return camera.pixels([cmath.rect(radius, math.tau * k / _RIM_PIXELS) for k in range(_RIM_PIXELS)])


def _combo_room(layout: Layout, corner: complex, unit: float) -> float:
    """Greatest width of the combo, pixels, at which neither words nor dots overlap the arena. corner: upper left, pixels."""
    return min([_free(layout, corner + 1j * unit * down) for down in (_COMBO_HEIGHT, _COMBO_DOTS)])


def _add_combo(out: DisplayList, shown: Readings, corner: complex, corners: Corners) -> None:
    """Add the combo, with a dot for each brick that raises the points; nothing for less than two bricks. corner: upper left."""
    streak = shown.streak if shown.streak.bricks else Streak(shown.combo, BUMP_TICKS)
    if streak.bricks <= 1:
        return
    layout, theme, unit, _ = corners
    room = _room(layout, corner + 1j * unit * _COMBO_DOTS) if layout.beside else layout.size[0]
    unit, best = min(unit, room / _COMBO_WIDTH), min(streak.bricks, BEST_COMBO)
    fade = streak.age / ENDED_TICKS if streak.ended else 0.0
    colour = mixed(theme.faint if streak.ended else theme.accent, theme.background, fade)
    bump = 0.0 if streak.ended else _BUMP * max(1.0 - streak.age / BUMP_TICKS, 0.0) ** 2
    size = stepped((_COMBO + _COMBO_PER_BRICK * best) * (1.0 + bump))
    words = tr("combo ×{count}").format(count=streak.bricks)
    out.text(words, unit * size, corner + 1j * unit * _COMBO_HEIGHT, colour, 0.0)
    for index in range(BEST_COMBO):
        pixel = corner + unit * complex(_COMBO_DOT + index * _COMBO_DOT_PITCH, _COMBO_DOTS)
        if index < best:
            out.disc(pixel, unit * _COMBO_DOT, colour)
        else:
            _add_hollow(out, pixel, unit * _COMBO_DOT, unit * _COMBO_DOT_LINE, theme.panel_edge)


def _add_lives(out: DisplayList, end: complex, lives: int, side: float, corners: Corners) -> None:
    """Add a disc for each life, a circle for each lost one. end: start of the row; side: 1.0 if it goes right, -1.0 if left."""
    theme, unit = corners.theme, corners.unit
    for index in range(max(LIVES, lives)):
        pixel = end + side * unit * (_LIFE + index * _LIFE_PITCH)
        if index < lives:
            out.disc(pixel, unit * _LIFE, theme.ball)
        else:
            _add_hollow(out, pixel, unit * _LIFE, unit * _LIFE_LINE, theme.faint)


def _add_hollow(out: DisplayList, pixel: complex, radius: float, line: float, colour: Colour) -> None:
    """Add a circle whose line lies inside of a radius and is at least a pixel wide."""
    line = max(line, 1.0)
    out.circle(pixel, radius - line / 2.0, line, colour)
