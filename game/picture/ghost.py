"""The ghost of the best run, as pale outlines, and how far ahead of it the player is; for pygame and for a browser."""

from game.drawing.camera import Camera, Layout
from game.drawing.letter_sizes import LINE
from game.drawing.palette import Theme, mixed
from game.language import tr
from game.picture.display_list import DisplayList
from game.rules import PADDLES, Game
from physics import direction

_PALE = 0.4
"""Share of the way from the ground's colour to the text's."""
_ARC_STEPS = 24
_LEAST_RADIUS = 2.0
"""Of a ball, pixels."""
# Lengths are in units of text.
_PADDLE_LINE, _BALL_LINE = 0.06, 0.09
_EDGE, _ABOVE_NAME, _CAPTION, _FIGURE = 0.8, 4.6, 0.9, 1.5
"""From the words to the surface's left and lower edges, and sizes of letters."""


def add_ghost(out: DisplayList, game: Game, camera: Camera, theme: Theme, unit: float) -> None:
    """Add the outlines of balls and paddles; the bricks are not shown, as they would be taken for the player's."""
    colour = mixed(theme.ground, theme.text, _PALE)
    paddles = game.arena.rings[PADDLES]
    for slot in range(paddles.count):
        angle, half = paddles.angle(slot), paddles.half_angle
        arc = [direction(angle + half * (2.0 * step / _ARC_STEPS - 1.0)) for step in range(_ARC_STEPS + 1)]
        outline = [paddles.outer_radius * towards for towards in arc]
        outline += [paddles.inner_radius * towards for towards in reversed(arc)]
        out.line(camera.pixels([*outline, outline[0]]), max(unit * _PADDLE_LINE, 1.0), colour)
    width = max(unit * _BALL_LINE, 1.0)
    for ball in game.arena.balls:
        radius = max(ball.radius * camera.scale_at(ball.position), _LEAST_RADIUS)
        out.circle(camera.project(ball.position), radius - width / 2.0, width, colour)


def add_lead(out: DisplayList, game: Game, ghost: Game, layout: Layout, theme: Theme, unit: float, foot: float = 0.0) -> None:
    """Add by how many points of the level the player is ahead, above the level's name.

    foot: height of what is in the lower left corner, pixels, where that is more than the level's name.
    """
    lead = (game.score - game.score_before) - (ghost.score - ghost.score_before)
    colour = theme.accent if lead > 0 else theme.danger if lead < 0 else theme.text
    caption, figure = unit * _CAPTION * LINE, unit * _FIGURE * LINE
    top = layout.size[1] - max(unit * _ABOVE_NAME, foot) - caption - figure
    left, edge = unit * _EDGE, min(layout.left_edge(top), layout.left_edge(top + caption))
    out.text(tr("BEST RUN"), unit * _CAPTION, complex(left, top + caption / 2.0), theme.faint, 0.0, room=edge - left)
    out.text(f"{lead:+,}", unit * _FIGURE, complex(left, top + caption + figure / 2.0), colour, 0.0)
