"""Pieces that fly off what was struck.

The desktop's debris (`game.drawing.debris`) is computed in arrays; these pieces follow the same burst, in the same colours,
with less arithmetic.
"""

import cmath
import math

from game.drawing.palette import Colour, Theme, layer_colour
from game.effects import Burst
from game.effects.bursts import Matter, lifetime
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import TICK
from game.scene import Scene

_PIECES, _PIECE = 9, 0.016
"""Shards of a burst, and the size of one in ground radii."""
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))


def add_bursts(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the pieces of all bursts: squares that turn, slow down, come down, and shrink."""
    for burst in scene.bursts:
        _add_burst(out, burst, scene.ground_radius, view)


def _add_burst(out: DisplayList, burst: Burst, ground_radius: float, view: ArenaView) -> None:
    """Add the pieces of one burst."""
    share = burst.age / lifetime(burst.matter)
    if share >= 1.0:
        return
    colour = burst_colour(burst, view.theme)
    camera, begin = view.camera, cmath.rect(burst.origin.radius, burst.origin.angle)
    time, spread = burst.age * TICK, 0.16 * ground_radius
    for k in range(_PIECES):
        chance = (burst.seed * 0.618034 + k * 0.754878) % 1.0
        away = cmath.rect(1.0, _GOLDEN * k + burst.seed % 7) * (0.3 + chance) + burst.direction * 0.8
        point = begin + away * spread * (1.0 - math.exp(-3.0 * time))
        height = 0.0 if camera.flat else max(0.06 + (0.5 + chance) * time - 1.6 * time * time, 0.0) * ground_radius * 0.6
        half = _PIECE * ground_radius * (0.5 + 0.5 * chance) * min(1.0, 2.0 * (1.0 - share)) * camera.scale
        turn = cmath.rect(half, 9.0 * time * (chance - 0.4) + k)
        pixel = camera.project(point, height)
        out.polygon((pixel + turn, pixel + 1j * turn, pixel - turn, pixel - 1j * turn), colour, 0.95)


def burst_colour(burst: Burst, theme: Theme) -> Colour:
    """The colour of what a burst is made of."""
    if burst.matter is Matter.BRICK:
        return layer_colour(theme, burst.layer)
    return {Matter.BALL: theme.danger, Matter.STEEL: theme.accent, Matter.PADDLE: theme.paddle_top}[burst.matter]
