"""Power-ups on their way outward: chips that float over the ground."""

import math

from game.drawing.arcade.icons import PowerIcons
from game.drawing.arcade.signs import power_colour
from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_dot
from game.rules.drops import DROP_RADIUS
from game.scene import Scene

_LEAST_RADIUS = 0.55
"""In units of text: smaller chips could not be told apart."""
_HOVER, _BOB, _BOB_RATE = 1.1, 0.25, 5.0
"""Height of a chip's middle over the ground and how much it rises and sinks, in its radii, and radians per second of that."""
_TAIL, _TAIL_DOTS = 0.9, 4
"""Where a drop has been: world units, and dots."""


def draw(canvas: Canvas, scene: Scene, icons: PowerIcons) -> None:
    """All drops, from back to front, each with a shadow on the ground and dots where it came from."""
    camera, theme = canvas.camera, canvas.theme
    for drop in sorted(scene.drops, key=lambda drop: -(drop.position * camera.turning).imag):
        own = DROP_RADIUS * scene.ground_radius
        radius = max(own * camera.scale_at(drop.position), _LEAST_RADIUS * canvas.unit)
        colour = power_colour(drop.kind, theme)
        outward = drop.velocity / max(abs(drop.velocity), 1e-9)
        for dot in range(1, _TAIL_DOTS + 1):
            share = dot / (_TAIL_DOTS + 1.0)
            pixel = camera.project(drop.position - outward * _TAIL * (0.4 + share))
            draw_dot(
                canvas.surface, pixel, max(radius * 0.22 * (1.0 - share), 1.0), mixed(colour, theme.ground, 0.3 + 0.6 * share)
            )
        height = 0.0
        if not camera.flat:
            draw_dot(canvas.surface, camera.project(drop.position), radius * 0.6, mixed(theme.ground, (0, 0, 0), theme.shadow))
            height = own * (_HOVER + _BOB * math.sin(_BOB_RATE * scene.clock))
        icons.draw(canvas.surface, drop.kind, camera.project(drop.position, height), radius, theme)
