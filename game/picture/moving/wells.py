"""Gravity wells: rings that shrink into what pulls, and grow out of what pushes."""

import cmath
import math

from game.drawing.palette import mixed
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene, Well

_RINGS = 4
_RATE = 0.28
"""Rings per second that reach the middle."""
_ARMS, _SWEEP = 3, 2.0
"""Arcs of each ring, and how far they are turned from the edge to the middle, radians."""
_GAP = 0.35
"""Share of a ring that is left out between its arcs."""
_STRENGTH, _EDGE_STRENGTH = 0.75, 0.3
"""Share of the way from the ground's colour to the rings', in the middle and at the edge of the well's reach."""
_EYE = 0.07
"""Radius of the dot in the middle, in shares of the reach."""
_WIDTH = 0.022
"""Width of a line, in shares of the reach, at least a pixel; and a pixel more."""
_ARC = tuple([cmath.rect(1.0, math.tau / _ARMS * (1.0 - _GAP) * k / 19.0) for k in range(20)])


def add_wells(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add all wells of a level."""
    for well in scene.wells:
        _add_well(out, scene, view, well)


def _add_well(out: DisplayList, scene: Scene, view: ArenaView, well: Well) -> None:
    """Add one well: arcs on their way, and a dot in its middle."""
    theme, camera = view.theme, view.camera
    colour = theme.trail if well.strength > 0.0 else theme.danger
    moved = scene.clock * _RATE % 1.0
    half = (max(_WIDTH * well.reach, 1.0 / camera.scale) + 1.0 / camera.scale) / 2.0
    for number in range(_RINGS):
        share = (number + (1.0 - moved if well.strength > 0.0 else moved)) / _RINGS
        shade = mixed(theme.ground, colour, _STRENGTH + (_EDGE_STRENGTH - _STRENGTH) * share)
        radius = max(share * well.reach, half)
        for arm in range(_ARMS):
            start = cmath.rect(1.0, math.tau * arm / _ARMS + _SWEEP * (1.0 - share))
            around = [start * point for point in _ARC]
            outer, inner = (
                camera.pixels([well.position + point * edge for point in around]) for edge in (radius + half, radius - half)
            )
            out.strip(outer, inner, shade)
    radius = _EYE * well.reach * camera.scale_at(well.position)
    out.disc(camera.project(well.position), max(radius, 2.0), colour)
