"""Shards and sparks on the screen: small tumbling plates that glitter, and streaks, in both views by the same projection."""

from collections.abc import Sequence

import numpy as np
import pygame

from game.array_maths import ARRAYS
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.palette import Theme
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
from game.drawing.raster.arrays import Points, Reals
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL
from game.drawing.solid.blocks import Flags
from game.drawing.solid.debris_occlusion import occluded
from game.effects.bursts import Burst
from game.effects.debris import Pieces, pieces
from game.scene import Scene

_CORNERS = np.exp(0.5j * np.pi * np.arange(4))


def draw(canvas: Canvas, scene: Scene) -> None:
    """All pieces of a scene's bursts that nothing hides."""
    if not scene.bursts:
        return
    camera, theme = canvas.camera, canvas.theme
    plates = [burst for burst in scene.bursts if burst.matter in PLATES]
    sparks = [burst for burst in scene.bursts if burst.matter not in PLATES]
    earlier = [burst._replace(age=max(burst.age - STREAK_TICKS, 0)) for burst in sparks]
    bursts, shown_bursts = [*plates, *sparks, *earlier], len(scene.bursts)
    flying = pieces(bursts, scene.ground_radius)
    shown = _shown(flying, scene, camera)
    whole, heads = (flying.burst < len(plates)) & shown, (flying.burst >= len(plates)) & (flying.burst < shown_bursts)
    tails, shown_heads = flying.burst >= shown_bursts, shown[heads]
    if whole.any():
        some = _some(flying, whole)
        _fill(canvas.surface, _plates(some, camera), _glittering(some, bursts, theme))
    if shown_heads.any():
        ends = _some(_some(flying, heads), shown_heads), _some(_some(flying, tails), shown_heads)
        _fill(canvas.surface, _streaks(*ends, camera), _burning(ends[0], bursts, theme))


def _shown(flying: Pieces, scene: Scene, camera: Camera) -> Flags:
    """Which pieces are large enough to see and not behind anything."""
    large = flying.size * camera.scale > LEAST_SIZE
    return large if camera.flat else large & ~occluded(flying.position, flying.height, scene, camera)


def _some(flying: Pieces, which: Flags) -> Pieces:
    """Some of the pieces."""
    return Pieces._make([field[which] for field in flying])


def _plates(flying: Pieces, camera: Camera) -> Points:
    """The corners of plates, pixels, four a row: each turned about the vertical and about one of its own sides."""
    uneven = np.stack([unevenness(ARRAYS, flying.shape, corner) for corner in range(4)], axis=1)
    corners = _CORNERS * uneven * flying.size[:, None]
    level, high = corners.imag * np.cos(flying.tumble)[:, None], corners.imag * np.sin(flying.tumble)[:, None]
    across = np.exp(1j * flying.turn)[:, None]
    ground = flying.position[:, None] + (corners.real + 1j * level) * across
    return camera.projected(ground * camera.turning, np.abs(flying.height[:, None] + high))


def _glittering(flying: Pieces, bursts: Sequence[Burst], theme: Theme) -> Reals:
    """The colour of each plate, red, green and blue: brighter, the more it is turned to the light."""
    own = np.array([burst_colour(burst, theme) for burst in bursts], dtype=np.float64)[flying.burst]
    light = plate_light(ARRAYS, flying.turn, flying.tumble)[:, None]
    return np.asarray(glittering(ARRAYS, own, light), dtype=np.float64)


def _streaks(heads: Pieces, tails: Pieces, camera: Camera) -> Points:
    """The corners of streaks, pixels, four a row: pointed behind, blunt in front."""
    front = camera.projected(heads.position * camera.turning, heads.height)
    back = camera.projected(tails.position * camera.turning, tails.height)
    along = front - back
    aside = 1j * along / np.maximum(np.abs(along), 1e-9) * (STREAK_WIDTH * heads.size * camera.scale)
    return np.stack([back, front + aside, front + STREAK_FRONT * along, front - aside], axis=1)


def _burning(heads: Pieces, bursts: Sequence[Burst], theme: Theme) -> Reals:
    """The colour of each streak, red, green and blue: bright at first, the ground's at last."""
    own = np.array([burst_colour(burst, theme) for burst in bursts], dtype=np.float64)[heads.burst]
    hot, cold = np.array(theme.flash, dtype=np.float64), np.array(theme.ground, dtype=np.float64)
    share = np.clip(heads.share, 0.0, 1.0)[:, None]
    return np.asarray(burning(ARRAYS, own, hot, cold, share), dtype=np.float64)


def _fill(surface: pygame.Surface, outlines: Points, colours: Reals) -> None:
    """Polygons: their edges drawn as lines half a pixel within, and what is left inside filled."""
    middle = outlines.mean(axis=1, keepdims=True)
    out = outlines - middle
    size = np.maximum(np.abs(out), 1e-9)
    corners = pairs(middle + out * np.maximum(1.0 - 1.0 / size, 0.0))
    edges = pairs(middle + out * np.maximum(1.0 - 0.5 / size, 0.0) - HALF_PIXEL)
    for corner, edge, colour in zip(corners, edges, np.rint(colours).astype(np.int64).tolist(), strict=True):
        pygame.draw.polygon(surface, colour, corner)
        pygame.draw.aalines(surface, colour, True, edge)
