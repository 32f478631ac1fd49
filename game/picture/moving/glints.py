"""The light on a paddle where a ball has just hit it: brightest at the hit, fading out to both sides."""

import cmath

from game.drawing.palette import mixed
from game.effects import Flash
from game.picture.display_list import DisplayList
from game.picture.slots.contents import pushed_out
from game.picture.slots.parts import LAYER_HEIGHT, PADDLE_HEIGHT
from game.picture.view import ArenaView
from game.rules import PADDLES
from game.scene import Scene

_REACH = 0.17
"""Length of a new light along the paddle to either side of the hit, in ground radii."""
_WIDTH = 0.8
"""Width of the light in shares of the paddle's."""
_SHRINKING = 0.45
"""Share of its length that a light loses until it ends."""
_STEPS = 8
"""Pieces on either side."""
_WHITE = (255, 255, 255)
"""The colour of the light in every theme: a paddle's colour mixed half with it is a lighter one of the same hue."""


def add_glints(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the lights on all paddles. They are painted over the paddles and below the balls."""
    for flash in scene.flashes:
        if flash.lit and flash.ring in (PADDLES, scene.second_paddle):
            _add_glint(out, flash, scene, view)


def _add_glint(out: DisplayList, flash: Flash, scene: Scene, view: ArenaView) -> None:
    """Add one light: a thin band with the paddle's own colour at its ends."""
    ring, theme, camera = scene.rings[flash.ring], view.theme, view.camera
    if flash.ring == PADDLES:
        paddle, light = theme.paddle_top, _WHITE
    else:  # the second player's paddle itself has the brightness of a flash
        paddle, light = theme.text, theme.accent
    pushed = pushed_out(scene, flash.ring).get(flash.slot, 0.0)
    radius, left = ring.radius + pushed, (1.0 - flash.age) ** 2
    height = 0.0 if camera.flat else PADDLE_HEIGHT * LAYER_HEIGHT * scene.ground_radius
    reach = _REACH * scene.ground_radius * (1.0 - _SHRINKING * flash.age) / radius
    end = ring.half_angle - _WIDTH * ring.half_width / radius
    middle, points = ring.angle(flash.slot), []
    widest = _WIDTH * ring.half_width * camera.scale_at(cmath.rect(radius, middle + flash.offset), height)
    for step in range(-_STEPS, _STEPS + 1):
        share = step / _STEPS
        offset = min(max(flash.offset + share * reach, -end), end)
        point, near = cmath.rect(radius, middle + offset), 1.0 - share * share
        points.append((camera.project(point, height), max(widest * near, 0.5), mixed(paddle, light, left * near)))
    out.band(points)
