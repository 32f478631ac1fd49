"""What lasts and for how long yet: arcs beyond the rim, one for each power-up and one for the heart of a growing wall."""

import math

import numpy as np
import pygame

from game.drawing.arcade.icons import PowerIcons
from game.drawing.arcade.signs import power_colour
from game.drawing.canvas import Canvas
from game.drawing.palette import Colour, mixed
from game.drawing.raster.arrays import Points
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL, draw_dot
from game.rules.power_up import OF_PADDLES
from game.scene import Scene

_RADIUS, _WIDTH = 1.042, 0.011
"""Of the arcs' middles and their width, in ground radii."""
_CHIP, _LEAST_CHIP = 0.030, 0.5
"""Radius of an icon: in ground radii, and at least so many units of text."""
_ICONS = tuple([math.radians(degrees) for degrees in (150.0, 182.0, 214.0, 302.0, 334.0, 6.0, 118.0)])
"""Angles of the icons on the screen, counter-clockwise from the right: none where a tipped arena fills the surface."""
_OF_PLAYERS = tuple([tuple([math.radians(angle) for angle in half]) for half in ((214.0, 302.0, 334.0), (150.0, 118.0, 88.0))])
_OF_BOTH = math.radians(182.0), math.radians(6.0)
"""The same where two play against each other: what acts on one of them is beside the own half."""
_SPAN = math.radians(23.0)
"""Angle of a full arc, counter-clockwise from its icon."""
_CHIP_ROOM = math.radians(4.5)
"""From an icon's middle to the beginning of its arc."""
_ENDING = 0.25
"""From this share of its time on an arc has the colour of warnings."""
_CORE_MIDDLE, _CORE_SPAN = math.radians(57.0), math.radians(36.0)
"""Where the heart's arc is on the screen."""
_EMPTY = 0.55
"""What is over is drawn in this share of the way from the rim's colour to the background's."""
_STEPS = 24


def draw(canvas: Canvas, scene: Scene, icons: PowerIcons) -> None:
    """An icon and an arc for every power-up that lasts: the arc is as long as the time that is left. The heart has a target."""
    camera, theme, ground = canvas.camera, canvas.theme, scene.ground_radius
    radius = max(_CHIP * ground * camera.scale, _LEAST_CHIP * canvas.unit)
    for angle, power in zip(_icon_angles(scene), scene.powers, strict=False):
        colour = power_colour(power.kind, theme)
        begin, left = angle + _CHIP_ROOM, power.share_left
        _draw_arc(canvas, ground, begin, begin + _SPAN, mixed(theme.rim, theme.background, _EMPTY))
        _draw_arc(canvas, ground, begin, begin + _SPAN * left, theme.danger if left < _ENDING else colour)
        point = ground * _RADIUS * complex(math.cos(angle), math.sin(angle)) / camera.turning
        icons.draw(canvas.surface, power.kind, _within(camera.project(point), radius, canvas.size), radius, theme)
    if scene.core is not None:
        begin = _CORE_MIDDLE + _CORE_SPAN / 2.0
        _draw_arc(canvas, ground, begin, begin - _CORE_SPAN, mixed(theme.rim, theme.background, _EMPTY))
        _draw_arc(canvas, ground, begin, begin - _CORE_SPAN * scene.core, theme.danger)
        angle = begin + _CHIP_ROOM
        pixel = camera.project(ground * _RADIUS * complex(math.cos(angle), math.sin(angle)) / camera.turning)
        pixel = _within(pixel, radius, canvas.size)
        for share, colour in ((1.0, theme.danger), (0.72, theme.background), (0.42, theme.danger)):
            draw_dot(canvas.surface, pixel, radius * share, colour)


def _icon_angles(scene: Scene) -> tuple[float, ...]:
    """Angles of the icons of the power-ups, in their order."""
    if scene.second_paddle is None:
        return _ICONS
    free = [iter(_OF_PLAYERS[0]), iter(_OF_PLAYERS[1]), iter(_OF_BOTH)]
    return tuple([next(free[power.player if power.kind in OF_PADDLES else 2]) for power in scene.powers])


def _within(pixel: complex, radius: float, size: tuple[int, int]) -> complex:
    """The pixel, moved so that an icon around it is on the surface as a whole."""
    room = radius + 1.0
    return complex(min(max(pixel.real, room), size[0] - room), min(max(pixel.imag, room), size[1] - room))


def _draw_arc(canvas: Canvas, ground: float, start: float, end: float, colour: Colour) -> None:
    """An arc beyond the rim. start, end: angles on the screen, radians."""
    if abs(end - start) < 1e-3:
        return
    around = np.exp(1j * np.linspace(start, end, _STEPS))
    half = max(_WIDTH / 2.0 * ground, 1.0 / canvas.camera.scale)
    outline = np.concatenate(
        [_arc(canvas, around, _RADIUS * ground + half), _arc(canvas, around, _RADIUS * ground - half)[::-1]]
    )
    pygame.draw.polygon(canvas.surface, colour, pairs(outline))
    pygame.draw.aalines(canvas.surface, colour, True, pairs(outline - HALF_PIXEL))


def _arc(canvas: Canvas, around: Points, radius: float) -> Points:
    """Points at a radius, pixels."""
    return canvas.camera.projected(around * radius, 0.0)
