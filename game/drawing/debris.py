"""Shards and sparks on the screen: small tumbling plates that glitter, and streaks, in both views by the same projection."""

from collections.abc import Sequence

import numpy as np
import pygame

from game.drawing.camera import Camera, Points
from game.drawing.palette import Colour, Theme, layer_colour
from game.drawing.solid.debris_occlusion import covered
from game.drawing.solid.faces import LIGHT
from game.drawing.solid.prisms import Flags
from game.effects.bursts import Burst, Matter
from game.effects.debris import Pieces, Reals, pieces
from game.scene import Scene

_PLATES = frozenset({Matter.BRICK, Matter.BALL})
"""What breaks into plates; all else gives off sparks."""
_CORNERS = np.exp(0.5j * np.pi * np.arange(4))
_LIGHT_ABOVE = 0.6
_DIMMEST = 0.72
_GLITTER = 6.0
_STREAK_TICKS = 9
"""A streak reaches back to where its spark was then."""
_LEAST = 0.35
"""Pixels; what is smaller is not drawn."""


def draw(surface: pygame.Surface, bursts: Sequence[Burst], scene: Scene, camera: Camera, theme: Theme) -> None:
    """All pieces of some bursts that nothing hides."""
    if not bursts:
        return
    plates = [burst for burst in bursts if burst.matter in _PLATES]
    streaks = [burst for burst in bursts if burst.matter not in _PLATES]
    earlier = [burst._replace(age=max(burst.age - _STREAK_TICKS, 0)) for burst in streaks]
    flying = pieces([*plates, *streaks, *earlier], scene.ground_radius)
    shown = _shown(flying, scene, camera)
    whole, heads = (flying.burst < len(plates)) & shown, (flying.burst >= len(plates)) & (flying.burst < len(bursts))
    tails = flying.burst >= len(bursts)
    shown_heads = shown[heads]
    if whole.any():
        some = _some(flying, whole)
        _fill(surface, _plates(some, camera), _glittering(some, plates, theme))
    if shown_heads.any():
        some = _some(_some(flying, heads), shown_heads)
        _fill(
            surface,
            _streaks(some, _some(_some(flying, tails), shown_heads), camera),
            _burning(some, [*plates, *streaks], theme),
        )


def _shown(flying: Pieces, scene: Scene, camera: Camera) -> Flags:
    """Which pieces are large enough to see and not behind anything."""
    large = flying.size * camera.scale > _LEAST
    return large if camera.flat else large & ~covered(flying.place, flying.height, scene, camera)


def _some(flying: Pieces, which: Flags) -> Pieces:
    """Some of the pieces."""
    return Pieces._make([field[which] for field in flying])


def _plates(flying: Pieces, camera: Camera) -> Points:
    """The corners of plates, pixels, four a row: each turned about the vertical and about one of its own sides."""
    uneven = 0.65 + 0.35 * np.cos(7.0 * flying.shape[:, None] + np.arange(4) * 2.2)
    corners = _CORNERS * uneven * flying.size[:, None]
    flat, high = corners.imag * np.cos(flying.tumble)[:, None], corners.imag * np.sin(flying.tumble)[:, None]
    across = np.exp(1j * flying.turn)[:, None]
    ground = flying.place[:, None] + (corners.real + 1j * flat) * across
    return camera.projected(ground * camera.turning, np.abs(flying.height[:, None] + high))


def _glittering(flying: Pieces, bursts: Sequence[Burst], theme: Theme) -> Reals:
    """The colour of each plate, red, green and blue: brighter, the more it is turned to the light."""
    own = np.array([_colour(burst, theme) for burst in bursts], dtype=np.float64)[flying.burst]
    normal = -1j * np.sin(flying.tumble) * np.exp(1j * flying.turn)
    lit = np.abs((normal * LIGHT.conjugate()).real * (1.0 - _LIGHT_ABOVE) + np.cos(flying.tumble) * _LIGHT_ABOVE)[:, None]
    shade = own * (_DIMMEST + (1.0 - _DIMMEST) * np.minimum(1.4 * lit, 1.0))
    return np.asarray(shade + (255.0 - shade) * 0.6 * np.clip(2.0 * lit - 1.0, 0.0, 1.0) ** _GLITTER)


def _streaks(heads: Pieces, tails: Pieces, camera: Camera) -> Points:
    """The corners of streaks, pixels, four a row: pointed behind, blunt in front."""
    front = camera.projected(heads.place * camera.turning, heads.height)
    back = camera.projected(tails.place * camera.turning, tails.height)
    way = front - back
    side = 1j * way / np.maximum(np.abs(way), 1e-9) * (0.35 * heads.size * camera.scale)
    return np.stack([back, front + side, front + 0.15 * way, front - side], axis=1)


def _burning(heads: Pieces, bursts: Sequence[Burst], theme: Theme) -> Reals:
    """The colour of each streak, red, green and blue: bright at first, the ground's at last."""
    own = np.array([_colour(burst, theme) for burst in bursts], dtype=np.float64)[heads.burst]
    hot, cold = np.array(theme.flash, dtype=np.float64), np.array(theme.ground, dtype=np.float64)
    share = np.clip(heads.share, 0.0, 1.0)[:, None]
    bright = own + (hot - own) * np.clip(1.0 - 3.0 * share, 0.0, 1.0)
    return np.asarray(bright + (cold - bright) * share**2)


def _colour(burst: Burst, theme: Theme) -> Colour:
    """What a burst is made of."""
    match burst.matter:
        case Matter.BRICK:
            return layer_colour(theme, burst.layer)
        case Matter.BALL:
            return theme.danger
        case Matter.STEEL:
            return theme.accent
        case Matter.PADDLE:
            return theme.paddle_top


def _fill(surface: pygame.Surface, outlines: Points, colours: Reals) -> None:
    """Polygons: their edges drawn as lines half a pixel within, and what is left inside filled."""
    middle = outlines.mean(axis=1, keepdims=True)
    out = outlines - middle
    size = np.maximum(np.abs(out), 1e-9)
    corners = _pairs(middle + out * np.maximum(1.0 - 1.0 / size, 0.0))
    edges = _pairs(middle + out * np.maximum(1.0 - 0.5 / size, 0.0) - (0.5 + 0.5j))
    for corner, edge, colour in zip(corners, edges, np.rint(colours).astype(np.int64).tolist(), strict=True):
        pygame.draw.polygon(surface, colour, corner)
        pygame.draw.aalines(surface, colour, True, edge)


def _pairs(outlines: Points) -> list[list[list[float]]]:
    """Rows of points as pygame takes them."""
    points: list[list[list[float]]] = np.ascontiguousarray(outlines).view(np.float64).reshape(*outlines.shape, 2).tolist()
    return points
