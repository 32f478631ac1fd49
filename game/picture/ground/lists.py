"""The ground and what is around it as primitives in world units: any camera may look at them, and every painter paints them."""

from functools import lru_cache

from game.drawing.camera import Camera
from game.drawing.light import LIGHT, shadow_offset, side_shares
from game.drawing.palette import Theme, mixed
from game.picture.display_list import DisplayList
from game.picture.ground.colours import FARTHEST, around_shade, ground_shade, mark_shade, rounded
from game.picture.ground.measures import EDGE_SHADE, THICKNESS, Ground, rim_width, track_width
from game.picture.ground.patterns import marks

_GROUND_STEPS, _AROUND_STEPS = 512, 256
"""Steps from one given colour to the next on the ground, and around it: those between are right to 0.01 of 255."""


@lru_cache(maxsize=8)
def ground_list(ground: Ground, theme: Theme, scale: float) -> DisplayList:
    """The ground without its pattern. scale: pixels per world unit, since some lines have a least width; not to be changed."""
    out, radius, rim = DisplayList(), ground.radius, rim_width(scale)
    out.fill(theme.background)
    shares = [1.0 + (FARTHEST - 1.0) * k / _AROUND_STEPS for k in range(_AROUND_STEPS + 1)]
    out.ground_disc(radius, radius * FARTHEST, [around_shade(theme, share) for share in shares])
    out.ground_side(radius + rim, THICKNESS * (radius + rim), mixed(theme.rim, theme.background, EDGE_SHADE))
    out.ground_disc(0.0, radius, [ground_shade(theme, k / _GROUND_STEPS) for k in range(_GROUND_STEPS + 1)])
    out.ground_circle(radius, rim, theme.rim)
    if ground.track is not None:
        width = track_width(scale)
        out.ground_circle(ground.track - width / 2.0, width, theme.ground_line)
    return out


@lru_cache(maxsize=8)
def pattern_list(ground: Ground, theme: Theme) -> DisplayList:
    """The marks at the rim and the pattern, a quadrilateral each; not to be changed."""
    out = DisplayList()
    for mark in marks(ground.pattern):
        colour = rounded(mark_shade(theme, abs(sum(mark.corners)) / 4.0, mark.strength))
        out.ground_mark([corner * ground.radius for corner in mark.corners], colour)
    return out


def add_ground(out: DisplayList, camera: Camera, theme: Theme, ground: Ground) -> None:
    """Add the ground with its pattern, as a camera sees it."""
    out.camera(camera, LIGHT, side_shares(theme), shadow_offset(camera))
    out.extend(ground_list(ground, theme, camera.scale))
    out.extend(pattern_list(ground, theme))
