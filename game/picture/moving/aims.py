"""The arrows that show where balls that wait will go."""

from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.scene import Scene

_REACH = 2.4
"""World units from the ball's middle to the arrow's tip."""
_DOTS = tuple([0.5 + (_REACH - 1.05) * k / 5.0 for k in range(6)])
"""World units from the ball's middle to each dot of the line."""
_DOT_RADIUS, _LEAST_DOT_RADIUS = 0.055, 1.5
"""World units, and pixels."""
_HEAD_WIDTH = 0.2
"""World units; half the width of the arrow's head."""
_HEAD = (
    complex(_REACH, 0.0),
    complex(_REACH - 1.7 * _HEAD_WIDTH, _HEAD_WIDTH),
    complex(_REACH - 1.25 * _HEAD_WIDTH, 0.0),
    complex(_REACH - 1.7 * _HEAD_WIDTH, -_HEAD_WIDTH),
)
"""The corners of a head that points along angle 0."""


def add_aims(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add a line of dots that ends in an arrow's head for every ball that waits to be let go."""
    camera, colour = view.camera, view.theme.accent
    for origin, direction in (*scene.held_aims, *([] if scene.aim is None else [scene.aim])):
        for distance in _DOTS:
            point = origin + direction * distance
            radius = max(_LEAST_DOT_RADIUS, _DOT_RADIUS * camera.scale_at(point))
            out.disc(camera.project(point), radius, colour)
        out.polygon(camera.pixels([origin + corner * direction for corner in _HEAD]), colour)
