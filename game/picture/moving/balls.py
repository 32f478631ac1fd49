"""Balls as a few discs, for painters that shade no pixels.

The desktop's are shaded pixel by pixel, in skins of their own: `game.drawing.balls`.
"""

from game.drawing.camera import Camera
from game.drawing.palette import Theme, mixed
from game.picture.display_list import DisplayList
from physics import Ball


def add_ball(out: DisplayList, ball: Ball, camera: Camera, theme: Theme) -> None:
    """Add a ball: a shaded disc with a shadow."""
    pixel = camera.project(ball.position, 0.0 if camera.flat else ball.radius)
    radius = max(ball.radius * camera.scale_at(ball.position, ball.radius), 1.5)
    foot = camera.project(ball.position)
    out.disc(foot + complex(0.18, 0.22) * radius, radius * 1.02, (0, 0, 0), 0.35)
    out.disc(pixel, radius, mixed(theme.ball, (20, 30, 70), 0.35))
    out.disc(pixel - complex(0.14, 0.16) * radius, radius * 0.8, mixed(theme.ball, (20, 30, 70), 0.1))
    out.disc(pixel - complex(0.26, 0.3) * radius, radius * 0.42, theme.ball)
