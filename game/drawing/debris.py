"""Shards and sparks on the screen: small tumbling plates that glitter, and streaks, in both views by the same projection."""

import numpy as np
import pygame
from numpy.typing import NDArray

from game.array_maths import ARRAYS, Arrays
from game.drawing.camera import Camera
from game.drawing.canvas import Canvas
from game.drawing.palette import Theme
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
from game.drawing.raster.arrays import Points, Reals
from game.drawing.raster.pixels import pairs
from game.drawing.raster.primitives import HALF_PIXEL
from game.drawing.solid.debris_occlusion import occluded
from game.effects.debris import Pieces, pieces
from game.effects.piece_paths import FlyingPiece
from game.scene import Scene


def draw(canvas: Canvas, scene: Scene) -> None:
    """All pieces of a scene's bursts that nothing hides."""
    if not scene.bursts:
        return
    camera, theme = canvas.camera, canvas.theme
    plates = [burst for burst in scene.bursts if burst.matter in PLATES]
    sparks = [burst for burst in scene.bursts if burst.matter not in PLATES]
    bursts = [*plates, *sparks]
    flying = pieces([*bursts, *map(earlier, sparks)], scene.ground_radius)
    own = np.array([burst_colour(burst, theme) for burst in bursts], dtype=np.float64)
    first_spark, first_earlier = np.searchsorted(flying.burst, (len(plates), len(scene.bursts)))
    shown = _shown(flying, int(first_earlier), scene, camera)
    whole, heads = shown[shown < first_spark], shown[shown >= first_spark]
    if len(whole):
        some = _some(flying, whole)
        _fill(canvas.surface, _plates(some.flying, camera), _glittering(some.flying, own[some.burst]))
    if len(heads):
        some, tails = _some(flying, heads), _some(flying, heads + (first_earlier - first_spark))
        _fill(canvas.surface, _streaks(some.flying, tails.flying, camera), _burning(some.flying, own[some.burst], theme))


def _shown(flying: Pieces, count: int, scene: Scene, camera: Camera) -> NDArray[np.intp]:
    """Which of the first pieces are large enough to see and not behind anything."""
    piece = flying.flying
    large = np.flatnonzero(piece.size[:count] > least_size(camera))
    if camera.flat:
        return large
    return large[~occluded(_ground(piece)[large], np.asarray(piece.height[large], dtype=np.float64), scene, camera)]


def _some(flying: Pieces, which: NDArray[np.intp]) -> Pieces:
    """Some of the pieces."""
    return Pieces(FlyingPiece[Arrays](*[field[which] for field in flying.flying]), flying.burst[which])


def _ground(piece: FlyingPiece[Arrays]) -> Points:
    """The points of the ground below pieces."""
    return np.asarray(piece.x + 1j * piece.y, dtype=np.complex128)


def _plates(flying: FlyingPiece[Arrays], camera: Camera) -> Points:
    """The corners of plates, pixels, four a row."""
    x, y, height = (np.stack(part, axis=1) for part in zip(*plate(ARRAYS, flying), strict=True))
    return camera.projected((x + 1j * y) * camera.turning, height)


def _glittering(flying: FlyingPiece[Arrays], own: Reals) -> Reals:
    """The colour of each plate, red, green and blue: brighter, the more it is turned to the light. own: of its material."""
    share, white = glitter(ARRAYS, plate_light(ARRAYS, flying.turn, flying.tumble))
    return np.asarray(own * share[:, None] + white[:, None], dtype=np.float64)


def _streaks(heads: FlyingPiece[Arrays], tails: FlyingPiece[Arrays], camera: Camera) -> Points:
    """The corners of streaks, pixels, four a row. heads, tails: sparks now, and the same ones before."""
    front, back = (camera.projected(_ground(end) * camera.turning, np.asarray(end.height)) for end in (heads, tails))
    return np.stack(streak(front, back, (camera.scale * heads.size).astype(np.complex128)), axis=1)


def _burning(heads: FlyingPiece[Arrays], own: Reals, theme: Theme) -> Reals:
    """The colour of each streak, red, green and blue: bright at first, the ground's at last. own: of its material."""
    hot, cold = np.array(theme.flash, dtype=np.float64), np.array(theme.ground, dtype=np.float64)
    return np.asarray(burning(ARRAYS, own, hot, cold, heads.share[:, None]), dtype=np.float64)


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
