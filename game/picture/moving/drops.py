"""Power-ups on their way outward: chips that float over the ground."""

import math
from functools import lru_cache

from game.drawing.arcade.signs import chip, power_colour
from game.drawing.palette import Theme, mixed
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import PowerUp
from game.rules.drops import DROP_RADIUS
from game.scene import Scene

_LEAST_RADIUS = 0.55
"""In units of text: smaller chips could not be told apart."""
_HOVER, _BOB, _BOB_RATE = 1.1, 0.25, 5.0
"""Height of a chip's middle over the ground and how much it rises and sinks, in its radii, and radians per second of that."""
_TAIL, _TAIL_DOTS = 0.9, 4
"""Where a drop has been: world units, and dots."""
_SMALLEST = 4
"""Pixels; least radius of a chip."""


def add_drops(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add all drops, from back to front, each with a shadow on the ground and dots where it came from."""
    camera, theme = view.camera, view.theme
    for drop in sorted(scene.drops, key=lambda drop: -(drop.position * camera.turning).imag):
        own = DROP_RADIUS * scene.ground_radius
        radius = max(own * camera.scale_at(drop.position), _LEAST_RADIUS * view.unit)
        colour = power_colour(drop.kind, theme)
        outward = drop.velocity / max(abs(drop.velocity), 1e-9)
        for dot in range(1, _TAIL_DOTS + 1):
            share = dot / (_TAIL_DOTS + 1.0)
            pixel = camera.project(drop.position - outward * _TAIL * (0.4 + share))
            out.disc(pixel, max(radius * 0.22 * (1.0 - share), 1.0), mixed(colour, theme.ground, 0.3 + 0.6 * share))
        height = 0.0
        if not camera.flat:
            out.disc(camera.project(drop.position), radius * 0.6, mixed(theme.ground, (0, 0, 0), theme.shadow))
            height = own * (_HOVER + _BOB * math.sin(_BOB_RATE * scene.clock))
        add_chip(out, drop.kind, camera.project(drop.position, height), radius, theme)


def add_chip(out: DisplayList, kind: PowerUp, pixel: complex, radius: float, theme: Theme) -> None:
    """Add a power-up's chip with its sign."""
    whole = max(round(radius), _SMALLEST)
    out.sprite(pixel, whole + 1.0, _chip(kind, whole, theme))


@lru_cache(maxsize=256)
def _chip(kind: PowerUp, radius: int, theme: Theme) -> DisplayList:
    """A chip about the origin."""
    out = DisplayList()
    for outline, colour in chip(kind, theme):
        out.polygon([point.conjugate() * radius for point in outline], colour)
    return out
