"""The drawings of the help: the arena, bricks, and how a ball is aimed."""

import math
from functools import cache, lru_cache
from itertools import pairwise

import pygame

from game.drawing.canvas import Canvas
from game.drawing.flat.sample import brick_sample
from game.drawing.palette import Colour, mixed
from game.drawing.raster.primitives import draw_dot
from game.language import tr
from game.levels import classic
from game.screens.level_pictures import LevelPictures
from physics import PERMANENT

_SAMPLES = (1, 2, 3, 4, 5, 6, PERMANENT)
_ARC = math.radians(34.0)
"""Half angle of the paddles that are drawn."""
_GROUND = (0.62, 0.8)
"""Radius of the ground of which a part is drawn, at most, in widths and in heights of the drawing."""
GROUND_HEIGHT = _GROUND[0] / _GROUND[1]
"""Height of such a drawing, in its widths, beyond which it would be empty at the top."""
_TURN = math.radians(32.0)
"""How far a drawn ball is turned off."""


@cache
def _level_pictures() -> LevelPictures:
    """The cached picture of the arena."""
    return LevelPictures()


def draw_arena(canvas: Canvas, box: pygame.Rect) -> None:
    """The second level as it begins."""
    side = min(box.width, box.height)
    pictures = _level_pictures()
    pictures.next_frame()
    picture = pictures.picture(classic()[1], side, canvas.theme, whole=True)
    if picture is not None:
        canvas.surface.blit(picture, picture.get_rect(midtop=box.midtop))


_sample = lru_cache(maxsize=64)(brick_sample)
"""Samples of bricks, cached."""


def draw_bricks(canvas: Canvas, box: pygame.Rect) -> None:
    """A brick of every kind, and how many hits it takes."""
    theme, unit = canvas.theme, canvas.unit
    pitch = box.width / len(_SAMPLES)
    size = (max(round(min(unit * 4.0, pitch * 0.9)), 1), max(round(unit * 2.0), 1))
    for index, layers in enumerate(_SAMPLES):
        middle = complex(box.left + pitch * (index + 0.5), box.top + unit * 1.2)
        card = _sample(size, unit * 2.0, layers, theme)
        canvas.surface.blit(card, card.get_rect(center=(round(middle.real), round(middle.imag))))
        words = tr("steel") if layers == PERMANENT else str(layers)
        canvas.write(words, 1.0, theme.faint, middle + 1.5j * unit, "midtop")


def draw_hit_position(canvas: Canvas, box: pygame.Rect) -> None:
    """Three balls that come straight down on a resting paddle, left of its middle, on it, and right of it."""
    origin, radius = _ground(canvas, box)
    _paddle(canvas, origin, radius, 0.0)
    for share in (-0.75, 0.0, 0.75):
        angle = -math.pi / 2.0 + share * _ARC
        foot = origin + _flipped(radius * 0.9, angle)
        inward = _flipped(1.0, angle) * -1.0
        _path(canvas, (foot + inward * radius * 0.75, foot), canvas.theme.faint, arrow=False)
        turned = inward * complex(math.cos(share * _TURN), math.sin(share * _TURN))
        _path(canvas, (foot, foot + turned * radius * 0.76), canvas.theme.accent, arrow=True)
        draw_dot(canvas.surface, foot, canvas.unit * 0.34, canvas.theme.ball)


def draw_moving_paddle(canvas: Canvas, box: pygame.Rect) -> None:
    """A ball on a paddle that turns."""
    origin, radius = _ground(canvas, box)
    _paddle(canvas, origin, radius, 0.0)
    foot = origin + _flipped(radius * 0.9, -math.pi / 2.0)
    _path(canvas, (foot - 1j * radius * 0.8, foot), canvas.theme.faint, arrow=False)
    leaving = -1j * complex(math.cos(_TURN * 0.8), math.sin(_TURN * 0.8))
    _path(canvas, (foot, foot + leaving * radius * 0.9), canvas.theme.accent, arrow=True)
    draw_dot(canvas.surface, foot, canvas.unit * 0.34, canvas.theme.ball)
    bow = [origin + _flipped(radius * 1.13, -math.pi / 2.0 + math.radians(degrees)) for degrees in range(-22, 27, 4)]
    _path(canvas, tuple(bow), canvas.theme.paddle_top, arrow=True)


def draw_serve(canvas: Canvas, box: pygame.Rect) -> None:
    """The arrow of the serve, and the directions that it swings through."""
    origin, radius = _ground(canvas, box)
    _paddle(canvas, origin, radius, 0.0)
    foot = origin + _flipped(radius * 0.88, -math.pi / 2.0)
    for degrees in (-44, -22, 0, 22, 44):
        direction = -1j * complex(math.cos(math.radians(degrees)), math.sin(math.radians(degrees)))
        chosen = degrees == 22
        colour = canvas.theme.accent if chosen else mixed(canvas.theme.ground, canvas.theme.faint, 0.45)
        _path(canvas, (foot, foot + direction * radius * (0.85 if chosen else 0.6)), colour, arrow=chosen)
    draw_dot(canvas.surface, foot, canvas.unit * 0.34, canvas.theme.ball)


def _ground(canvas: Canvas, box: pygame.Rect) -> tuple[complex, float]:
    """A part of the ground in a box: pixel of its centre, and its radius."""
    theme = canvas.theme
    radius = min(box.height * _GROUND[1], box.width * _GROUND[0])
    origin = complex(box.centerx, box.bottom - radius * 1.2)
    clip = canvas.surface.get_clip()
    canvas.surface.set_clip(box.clip(clip))
    draw_dot(canvas.surface, origin, radius * 1.06, theme.rim)
    draw_dot(canvas.surface, origin, radius * 1.04, theme.ground)
    canvas.surface.set_clip(clip)
    return origin, radius


def _paddle(canvas: Canvas, origin: complex, radius: float, turned: float) -> None:
    """A paddle at the lower side of the ground."""
    outer, inner = [], []
    for step in range(25):
        angle = -math.pi / 2.0 + turned + _ARC * (step / 12.0 - 1.0)
        outer.append(origin + _flipped(radius * 1.0, angle))
        inner.append(origin + _flipped(radius * 0.94, angle))
    points = [(point.real, point.imag) for point in (*outer, *reversed(inner))]
    pygame.draw.polygon(canvas.surface, canvas.theme.paddle_top, points)
    pygame.draw.aalines(canvas.surface, canvas.theme.paddle_top, True, points)


def _path(canvas: Canvas, points: tuple[complex, ...], colour: Colour, *, arrow: bool) -> None:
    """A line through some pixels, with a head at its end."""
    width = max(round(canvas.unit * 0.14), 1)
    for start, end in pairwise(points):
        pygame.draw.aaline(canvas.surface, colour, (start.real, start.imag), (end.real, end.imag), width)
    if arrow:
        along = (points[-1] - points[-2]) / abs(points[-1] - points[-2]) * canvas.unit
        tip, back = points[-1] + along * 0.5, points[-1] - along * 0.3
        head = (tip, back + along * 0.42j, back - along * 0.42j)
        pygame.draw.polygon(canvas.surface, colour, [(point.real, point.imag) for point in head])


def _flipped(length: float, angle: float) -> complex:
    """A vector on the screen, where y points down, of an angle that is counter-clockwise."""
    return length * complex(math.cos(angle), -math.sin(angle))
