"""A preview of the chosen ball and trail on a strip of ground, as they look in play."""

import pygame

from game.drawing.balls.ball import BallPictures
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.raster.primitives import draw_box
from game.picture.display_list import DisplayList
from game.picture.moving.trails import add_trail
from game.screens.toolkit.items.basic import Drawing
from physics import Ball

_TALL, _CORNER, _EDGE = 3.2, 0.5, 0.06
"""Height of the strip, radius of its corners and width of its edge, units of text."""
_RADIUS = 0.75
"""Of the ball, units of text."""
_BALL = Ball(0j, 1 + 0j, 0.25)
_ALONG = 0.62
"""Position of the ball along the strip, as a share of its width."""
_STEP, _BEND, _POSITIONS = 0.11, 0.16, 17
"""Of the trail: world units from one position to the next, how far its begin is beside the flight, and its positions."""
_TRAIL = tuple([complex(-_STEP * k, -_BEND * (k / _POSITIONS) ** 2) for k in range(_POSITIONS, 0, -1)])
_balls, _lists = BallPictures(), DisplayListPainter()


def ball_preview() -> Drawing:
    """The drawing of the preview; the canvas has the names of ball and trail."""
    return Drawing(_TALL, _paint)


def _paint(canvas: Canvas, box: pygame.Rect) -> None:
    """Draw the strip, the trail, and the ball at its end."""
    theme, unit = canvas.theme, canvas.unit
    draw_box(canvas.surface, box, unit * _CORNER, theme.ground, theme.panel_edge, unit * _EDGE)
    camera = Camera(complex(box.left + box.width * _ALONG, box.centery), unit * _RADIUS / _BALL.radius)
    seen, picture = canvas._replace(camera=camera), DisplayList()
    add_trail(picture, _TRAIL, _BALL.radius, 0.0, seen.view)
    _lists.paint(canvas.surface, canvas.type, picture)
    _balls.draw_ball(seen, _BALL)
