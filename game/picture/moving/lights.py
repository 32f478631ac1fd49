"""Light on the arena: what was struck shines on what is around it, and so do balls.

On dark grounds light is added. On light ones, where nothing can be added, its colour takes the others away.
"""

import math

from game.drawing.light_colour import light_colour
from game.drawing.palette import Colour, luminance, mixed
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_BRIGHTNESS, _TINT = 0.45, 0.5
"""Share of its colour that a full light adds on dark grounds, and takes of the others on light ones."""
_BALL_REACH, _BALL_STRENGTH, _BALL_HEAT = 4.2, 0.22, 0.28
"""A ball's light: its reach in radii of the ball, its strength, and what the longest row of bricks adds to it."""
_LEAST = 0.04
"""Lights weaker than this are not drawn."""


def add_lights(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the lights of a scene and those of its balls."""
    theme = view.theme
    if theme.glow == 0.0:
        return
    for light in scene.lights:
        _add_light(out, view, light.position, light.reach * scene.ground_radius, light_colour(light, theme), light.now)
    if scene.shining:
        warm = mixed(theme.trail, theme.accent, scene.heat)
        for ball in scene.balls:
            _add_light(out, view, ball.position, _BALL_REACH * ball.radius, warm, _BALL_STRENGTH + _BALL_HEAT * scene.heat)


def _add_light(out: DisplayList, view: ArenaView, position: complex, reach: float, colour: Colour, strength: float) -> None:
    """Add one light on the ground. reach: world units; strength: 0 to 1."""
    if strength < _LEAST:
        return
    camera, dark = view.camera, luminance(view.theme.ground) < 0.5
    wide = reach * camera.scale_at(position)
    full = _BRIGHTNESS if dark else _TINT
    out.glow(camera.project(position), (wide, wide * math.cos(camera.tilt)), colour, full * strength, multiplies=not dark)
