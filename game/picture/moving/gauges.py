"""What lasts and for how long yet: arcs beyond the rim, one for each power-up and one for the heart of a growing wall."""

import cmath
import math

from game.drawing.arcade.signs import power_colour
from game.drawing.palette import Colour, mixed
from game.picture.display_list import DisplayList
from game.picture.moving.drops import add_chip
from game.picture.view import ArenaView
from game.rules.power_up import OF_PADDLES
from game.scene import Scene

RADIUS, _WIDTH = 1.042, 0.011
"""Of the arcs' middles and their width, in ground radii; they are a pixel wider."""
_CHIP, _LEAST_CHIP = 0.030, 0.5
"""Radius of an icon: in ground radii, and at least so many units of text."""
ICONS = tuple([math.radians(degrees) for degrees in (150.0, 182.0, 214.0, 302.0, 334.0, 6.0, 118.0)])
"""Angles of the icons on the screen, counter-clockwise from the right: none where a tipped arena fills the surface."""
_OF_PLAYERS = tuple([tuple([math.radians(angle) for angle in half]) for half in ((214.0, 302.0, 334.0), (150.0, 118.0, 88.0))])
_OF_BOTH = math.radians(182.0), math.radians(6.0)
"""The same where two play against each other: what acts on one of them is beside the own half."""
SPAN = math.radians(23.0)
"""Angle of a full arc, counter-clockwise from its icon."""
CHIP_ROOM = math.radians(4.5)
"""From an icon's middle to the beginning of its arc."""
_ENDING = 0.25
"""From this share of its time on an arc has the colour of warnings."""
_CORE_MIDDLE, _CORE_SPAN = math.radians(57.0), math.radians(36.0)
"""Where the heart's arc is on the screen."""
_EMPTY = 0.55
"""What is over is drawn in this share of the way from the rim's colour to the background's."""
_STEPS = 12
"""Points of an arc."""


def add_gauges(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add an icon and an arc for every power-up that lasts: the arc is as long as the time left. The heart has a target."""
    theme, ground = view.theme, scene.ground_radius
    radius = max(_CHIP * ground * view.camera.scale, _LEAST_CHIP * view.unit)
    for angle, power in zip(_icon_angles(scene), scene.powers, strict=False):
        begin, left = angle + CHIP_ROOM, power.share_left
        _add_gauge(out, view, ground, begin, SPAN, left, theme.danger if left < _ENDING else power_colour(power.kind, theme))
        add_chip(out, power.kind, _beside(view, ground, angle, radius), radius, theme)
    if scene.core is not None:
        begin = _CORE_MIDDLE + _CORE_SPAN / 2.0
        _add_gauge(out, view, ground, begin, -_CORE_SPAN, scene.core, theme.danger)
        pixel = _beside(view, ground, begin + CHIP_ROOM, radius)
        for share, colour in ((1.0, theme.danger), (0.72, theme.background), (0.42, theme.danger)):
            out.disc(pixel, radius * share, colour)


def _icon_angles(scene: Scene) -> tuple[float, ...]:
    """Angles of the icons of the power-ups, in their order."""
    if scene.second_paddle is None:
        return ICONS
    free = [iter(_OF_PLAYERS[0]), iter(_OF_PLAYERS[1]), iter(_OF_BOTH)]
    return tuple([next(free[power.player if power.kind in OF_PADDLES else 2]) for power in scene.powers])


def _beside(view: ArenaView, ground: float, angle: float, radius: float) -> complex:
    """The pixel beyond the rim at an angle on the screen, moved so that an icon around it is on the surface as a whole."""
    pixel = view.camera.project(cmath.rect(ground * RADIUS, angle) / view.camera.turning)
    (width, height), room = view.size, radius + 1.0
    return complex(min(max(pixel.real, room), width - room), min(max(pixel.imag, room), height - room))


def _add_gauge(
    out: DisplayList, view: ArenaView, ground: float, begin: float, span: float, left: float, colour: Colour
) -> None:
    """Add an arc: what is left in a colour, over what is over. begin, span: angles on the screen; left: share of the span."""
    _add_arc(out, view, ground, begin, span, mixed(view.theme.rim, view.theme.background, _EMPTY))
    _add_arc(out, view, ground, begin, span * left, colour)


def _add_arc(out: DisplayList, view: ArenaView, ground: float, begin: float, span: float, colour: Colour) -> None:
    """Add an arc beyond the rim."""
    if abs(span) < 1e-3:
        return
    camera = view.camera
    half = max(_WIDTH / 2.0 * ground, 1.0 / camera.scale) + 0.5 / camera.scale
    first, step = cmath.rect(1.0, begin) / camera.turning, cmath.rect(1.0, span / (_STEPS - 1.0))
    around = [first * step**k for k in range(_STEPS)]
    outer, inner = (
        camera.pixels([point * radius for point in around]) for radius in (RADIUS * ground + half, RADIUS * ground - half)
    )
    out.strip(outer, inner, colour)
