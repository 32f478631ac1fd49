"""Pieces that fly off a struck brick or paddle: plates that tumble and glitter, and streaks."""

from collections.abc import Sequence

from game.drawing.camera import Camera
from game.drawing.palette import Colour
from game.drawing.piece_look import (
    PLATES,
    burning,
    burst_colour,
    earlier,
    glitter,
    least_size,
    plate,
    plate_light,
    streak,
)
from game.effects.piece_paths import FlyingPiece, flown, position, thrown
from game.maths import NUMBERS
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import TICK
from game.scene import Scene

_LEAST_WIDTH = 1.0
"""Pixels; a plate seen edge-on, or a thin streak, is a line so wide."""

Flying = tuple[complex, DisplayList]
"""A piece in the air: the point of the ground below it, and its primitives."""


def flying_pieces(scene: Scene, view: ArenaView) -> list[Flying]:
    """The pieces of all bursts that are large enough to see."""
    least, found = least_size(view.camera), []
    for burst in scene.bursts:
        own, time, before = burst_colour(burst, view.theme), burst.age * TICK, earlier(burst).age * TICK
        for start in thrown(burst):
            piece = flown(NUMBERS, start, time, scene.ground_radius)
            if piece.size > least:
                found.append((complex(piece.x, piece.y), DisplayList()))
                if burst.matter in PLATES:
                    _add_plate(found[-1][1], piece, own, view.camera)
                else:
                    _add_streak(found[-1][1], piece, position(NUMBERS, start, before, scene.ground_radius), own, view)
    return found


def _add_plate(out: DisplayList, piece: FlyingPiece[float], own: Colour, camera: Camera) -> None:
    """Add a plate. own: colour of its material."""
    share, white = glitter(NUMBERS, plate_light(NUMBERS, piece.turn, piece.tumble))
    red, green, blue = own
    colour = round(red * share + white), round(green * share + white), round(blue * share + white)
    _add_shape(out, camera.pixels_above(plate(NUMBERS, piece)), colour)


def _add_streak(
    out: DisplayList, piece: FlyingPiece[float], before: tuple[float, float, float], own: Colour, view: ArenaView
) -> None:
    """Add a streak. before: position and height of the spark some time ago; own: colour of its material."""
    camera, theme = view.camera, view.theme
    front, back = camera.pixels_above([piece[:3], before])
    parts = zip(own, theme.flash, theme.ground, strict=True)
    red, green, blue = [round(burning(NUMBERS, float(one), float(hot), float(cold), piece.share)) for one, hot, cold in parts]
    _add_shape(out, streak(front, back, piece.size * camera.scale), (red, green, blue))


def _add_shape(out: DisplayList, corners: Sequence[complex], colour: Colour) -> None:
    """Add a quadrilateral, or a line where it is narrower than one on average. corners: pixels."""
    one, other = corners[2] - corners[0], corners[3] - corners[1]
    begin = 0 if abs(one) >= abs(other) else 1
    if abs((one.conjugate() * other).imag) < 2.0 * _LEAST_WIDTH * max(abs(one), abs(other)):
        out.line([corners[begin], corners[begin + 2]], _LEAST_WIDTH, colour)
    else:
        out.polygon(corners, colour)
