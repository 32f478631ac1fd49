"""The look of flying pieces: shape and light of plates, shape and colours of sparks. The formulas take numbers or arrays."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeVar

from game.drawing.camera import Camera
from game.drawing.light import LIGHT
from game.drawing.palette import Colour, Theme, layer_colour
from game.effects.bursts import Burst, Matter
from game.effects.piece_paths import FlyingPiece
from game.maths import Maths, Values

if TYPE_CHECKING:  # in a browser there is no numpy
    from game.drawing.raster.arrays import Points

Pixels = TypeVar("Pixels", complex, "Points")
"""A pixel, or an array of them."""

PLATES = frozenset({Matter.BRICK, Matter.BALL})
"""Materials that break into plates; the others give off sparks."""
_STREAK_TICKS = 9
"""A streak extends from its spark's position to the position this many ticks ago."""
_STREAK_WIDTH, _STREAK_FRONT = 0.35, 0.15
"""Half the width of a streak in sizes of its spark, and how far its blunt end extends ahead, in lengths of the streak."""
_LEAST_SIZE = 0.35
"""Pixels; smaller pieces are not drawn."""
_LIGHT_ABOVE = 0.6
"""Share of a plate's light that comes from above, the rest from the side."""
_DIMMEST = 0.72
"""Share of its colour that a plate shows while it is edge-on to the light."""
_GLITTER, _WHITEST = 6.0, 0.6
"""Exponent of a plate's highlight as it turns towards the light, and how far the highlight goes to white."""


def burst_colour(burst: Burst, theme: Theme) -> Colour:
    """The colour of what a burst is made of."""
    if burst.matter is Matter.BRICK:
        return layer_colour(theme, burst.layer)
    return {Matter.BALL: theme.danger, Matter.STEEL: theme.accent, Matter.PADDLE: theme.paddle_top}[burst.matter]


def least_size(camera: Camera) -> float:
    """World units; smaller pieces are not drawn."""
    return _LEAST_SIZE / camera.scale


def plate(maths: Maths[Values], piece: FlyingPiece[Values]) -> Sequence[tuple[Values, Values, Values]]:
    """The four corners of a plate, each x, y and height: it is rotated about the vertical and about one of its diagonals."""
    cosine, sine, level, up = maths.cos(piece.turn), maths.sin(piece.turn), maths.cos(piece.tumble), maths.sin(piece.tumble)
    aside, across = level * cosine, level * sine
    return (
        (piece.x + piece.front * cosine, piece.y + piece.front * sine, piece.height),
        (piece.x - piece.left * across, piece.y + piece.left * aside, abs(piece.height + piece.left * up)),
        (piece.x - piece.back * cosine, piece.y - piece.back * sine, piece.height),
        (piece.x + piece.right * across, piece.y - piece.right * aside, abs(piece.height - piece.right * up)),
    )


def earlier(burst: Burst) -> Burst:
    """A burst at the moment from which the streaks of its sparks extend to the present."""
    return burst._replace(age=max(burst.age - _STREAK_TICKS, 0))


def streak(front: Pixels, back: Pixels, size: Pixels) -> tuple[Pixels, Pixels, Pixels, Pixels]:
    """The corners of a streak on the screen, pointed behind, blunt in front.

    front, back: pixels of a spark now and `earlier`; size: of the spark, pixels.
    """
    along = front - back
    aside = 1j * along / (abs(along) + 1e-9) * (_STREAK_WIDTH * size)
    return back, front + aside, front + _STREAK_FRONT * along, front - aside


def plate_light(maths: Maths[Values], turn: Values, tumble: Values) -> Values:
    """The light on a plate, 0 to 1. turn, tumble: angles about the vertical and about a horizontal axis."""
    from_the_side = maths.sin(tumble) * (maths.sin(turn) * LIGHT.real - maths.cos(turn) * LIGHT.imag)
    return abs(from_the_side * (1.0 - _LIGHT_ABOVE) + maths.cos(tumble) * _LIGHT_ABOVE)


def glitter(maths: Maths[Values], light: Values) -> tuple[Values, Values]:
    """What a plate shows in some light: a share of its material's colour, and white that is added to it, 0 to 255.

    light: 0 to 1.
    """
    shade = _DIMMEST + (1.0 - _DIMMEST) * maths.clip(1.4 * light, 0.0, 1.0)
    white = _WHITEST * maths.clip(2.0 * light - 1.0, 0.0, 1.0) ** _GLITTER
    return shade * (1.0 - white), 255.0 * white


def burning(maths: Maths[Values], own: Values, hot: Values, cold: Values, share: Values) -> Values:
    """A spark's red, green or blue after a share of its life. hot: at first; own: then; cold: at last, the ground's."""
    share = maths.clip(share, 0.0, 1.0)
    bright = own + (hot - own) * maths.clip(1.0 - 3.0 * share, 0.0, 1.0)
    left: Values = bright + (cold - bright) * share * share
    return left
