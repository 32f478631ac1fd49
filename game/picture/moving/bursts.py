"""Pieces that fly off a struck brick or paddle: fewer than the desktop's, on the same paths and in the same colours.

`game.effects.piece_paths` and `game.drawing.piece_colours` have the formulas; the desktop computes hundreds in arrays.
"""

import cmath
import math
from functools import lru_cache
from typing import NamedTuple

from game.drawing.camera import Camera
from game.drawing.palette import Colour, Theme
from game.drawing.piece_colours import (
    LEAST_SIZE,
    PLATES,
    STREAK_FRONT,
    STREAK_TICKS,
    STREAK_WIDTH,
    burning,
    burst_colour,
    glittering,
    plate_light,
    unevenness,
)
from game.effects import Burst
from game.effects.bursts import lifetime
from game.effects.piece_paths import (
    NUMBERS_OF_PIECES,
    THROWS,
    Scattered,
    chances,
    height,
    reach,
    scattered,
    shrunk,
    tumbled,
)
from game.maths import NUMBERS
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import TICK
from game.scene import Scene

_MOST = 10
"""Pieces of a burst."""


class _Piece(NamedTuple):
    """A piece at its beginning.

    position: world units. velocity: along the ground, hundredths of the ground's radius per second. drag: of the air, per
    second. life: seconds.
    """

    position: complex
    velocity: complex
    drag: float
    life: float
    start: Scattered[float]


def add_bursts(out: DisplayList, scene: Scene, view: ArenaView) -> None:
    """Add the pieces of all bursts: plates that tumble and glitter, and streaks."""
    unit = 0.01 * scene.ground_radius
    for burst in scene.bursts:
        own, time = burst_colour(burst, view.theme), burst.age * TICK
        for piece in _thrown(burst._replace(age=0)):
            share = time / piece.life
            size = piece.start.size * unit * shrunk(NUMBERS, share)
            if size * view.camera.scale <= LEAST_SIZE:
                continue
            if burst.matter in PLATES:
                _add_plate(out, piece, own, time, (unit, size), view.camera)
            else:
                _add_streak(out, piece, own, time, (unit, size), view)


@lru_cache(maxsize=64)
def _thrown(burst: Burst) -> tuple[_Piece, ...]:
    """The pieces of a burst at their beginning."""
    throw, life, origin = THROWS[burst.matter], lifetime(burst.matter) * TICK, burst.origin
    pieces = []
    for number in range(min(NUMBERS_OF_PIECES[burst.matter], _MOST)):
        start = scattered(throw, chances(burst.seed, number))
        position = cmath.rect(origin.radius + origin.half_width * start.out, origin.angle + origin.half_angle * start.aside)
        velocity = burst.direction * start.along + cmath.rect(start.apart, start.apart_angle)
        pieces.append(_Piece(position, velocity, throw.drag, life * start.life, start))
    return tuple(pieces)


def _at(piece: _Piece, time: float, unit: float) -> tuple[complex, float]:
    """Position and height of a piece, world units."""
    position = piece.position + piece.velocity * (unit * reach(NUMBERS, piece.drag, time))
    return position, height(NUMBERS, piece.start.height, piece.start.up, time) * unit


def _add_plate(
    out: DisplayList, piece: _Piece, own: Colour, time: float, measures: tuple[float, float], camera: Camera
) -> None:
    """Add a plate, rotated about the vertical and about one of its sides. measures: unit of lengths, and size of the plate."""
    unit, size = measures
    start = piece.start
    position, high = _at(piece, time, unit)
    turn, tumble = start.turn + start.spin * time, tumbled(start.tumble, start.spin, time)
    middle, scale = camera.project(position, high), camera.scale_at(position, high) * size
    across, level, up = cmath.rect(scale, turn) * camera.turning, math.cos(tumble), math.sin(tumble)
    sine, cosine = math.sin(camera.tilt), math.cos(camera.tilt)
    corners = []
    for corner, offset in enumerate((1 + 0j, 1j, -1 + 0j, -1j)):
        away = offset * unevenness(NUMBERS, start.shape, corner)
        flat = complex(away.real, away.imag * level) * across
        corners.append(middle + complex(flat.real, -flat.imag * cosine - away.imag * up * scale * sine))
    light = plate_light(NUMBERS, turn, tumble)
    red, green, blue = [round(glittering(NUMBERS, float(part), light)) for part in own]
    out.polygon(corners, (red, green, blue))


def _add_streak(
    out: DisplayList, piece: _Piece, own: Colour, time: float, measures: tuple[float, float], view: ArenaView
) -> None:
    """Add a streak: pointed behind, blunt in front. measures: as of a plate."""
    unit, size = measures
    camera, theme = view.camera, view.theme
    front, back = (camera.project(*_at(piece, max(moment, 0.0), unit)) for moment in (time, time - STREAK_TICKS * TICK))
    along = front - back
    aside = 1j * along / max(abs(along), 1e-9) * (STREAK_WIDTH * size * camera.scale)
    out.polygon((back, front + aside, front + STREAK_FRONT * along, front - aside), _spark(own, theme, time / piece.life))


def _spark(own: Colour, theme: Theme, share: float) -> Colour:
    """The colour of a spark after a share of its life."""
    parts = zip(own, theme.flash, theme.ground, strict=True)
    red, green, blue = [
        round(burning(NUMBERS, float(one), float(hot), float(cold), min(share, 1.0))) for one, hot, cold in parts
    ]
    return red, green, blue
