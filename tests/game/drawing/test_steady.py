"""The solid view from frame to frame: nothing flickers while the camera moves, and what is cached changes nothing."""

import math
import os
from itertools import pairwise

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing.painter import Painter
from game.drawing.raster.pixels import packed
from game.drawing.raster.quads import QuadRaster, fill_quads
from game.drawing.solid import arena_blocks
from game.effects import Effects, after
from game.input.view import SOLID, Viewpoint
from game.levels import classic
from game.picture.solid.order import back_to_front
from game.rules import new_game, tick
from game.scene import scene_at
from tests.support.games.autopilot_games import game_after
from tests.support.pictures import canvas_of

SIZE = (480, 360)
BLOCK = 6
"""Pixels across and down: what appears or vanishes fills at least a block, the fringe of a moving edge does not."""
MOST = 30.0
"""Shades of 255. Even movement stays below 22, for corners lie on half pixels; a wrong order makes 45 to 130."""


def scene_after(level, ticks, seed=3):
    """The scene of an autopilot's game, without words."""
    done, effects = game_after(level, ticks, seed)
    return scene_at(done, 0.4, effects)._replace(pops=())


def frames(scene, views):
    """Pictures of a scene from one view after the other."""
    painter = Painter()
    for view in views:
        canvas = canvas_of(scene, SIZE, view)
        painter.paint(canvas, scene)
        yield pygame.surfarray.array3d(canvas.surface).astype(np.int16)


def flicker(pictures):
    """The largest distance of a block of pixels from the mean of the frames before and after, in shades of 255.

    What moves evenly is near that mean; what is there in one frame and gone in the next is not.
    """
    worst, pairs = 0.0, pairwise(pictures)
    before, _ = next(pairs)
    for picture, following in pairs:
        red, green, blue = np.moveaxis(np.abs(2 * picture - before - following), 2, 0)
        off = np.maximum(np.maximum(red, green), blue)
        width, height = (length // BLOCK for length in off.shape)
        columns = off[: width * BLOCK, : height * BLOCK].reshape(width, BLOCK, -1).sum(axis=1)
        blocks = columns.reshape(width, height, BLOCK).sum(axis=2)
        worst, before = max(worst, float(blocks.max()) / (2 * BLOCK * BLOCK)), picture
    return worst


MOVES = {
    "orbit, low": [Viewpoint(1.0, 1.0, 0.3 + 0.0008 * k, math.radians(72.0)) for k in range(36)],
    "orbit": [Viewpoint(1.0, 1.0, 0.3 + 0.0008 * k, math.radians(45.0)) for k in range(36)],
    "orbit, high": [Viewpoint(1.0, 1.0, 2.0 + 0.0008 * k, math.radians(20.0)) for k in range(36)],
    "tipping": [Viewpoint(1.0, 0.25 + 0.001 * k) for k in range(36)],
    "tilting": [Viewpoint(1.0, 1.0, 0.7, 0.6 + 0.001 * k) for k in range(36)],
    "zooming": [Viewpoint(1.0, 1.0, -2.0, 0.9, 1.0 + 0.001 * k) for k in range(36)],
}


@pytest.mark.parametrize("level", [3, pytest.param(4, marks=pytest.mark.deep), pytest.param(5, marks=pytest.mark.deep), 6])
@pytest.mark.parametrize("move", MOVES)
def test_nothing_flickers_while_the_camera_moves(level, move):
    """While the camera moves slowly, every frame is near the mean of its neighbours."""
    assert flicker(frames(scene_after(level, 1800), MOVES[move])) < MOST


@pytest.mark.parametrize("level", [3, 4, 5, 6])
def test_a_wrong_order_flickers(level, monkeypatch):
    """With blocks drawn in an order for another angle in every frame, the bound is exceeded."""

    def wrong(rings, wedges, camera):
        return back_to_front(rings, wedges, camera._replace(azimuth=997.0 * camera.azimuth))

    monkeypatch.setattr(arena_blocks, "back_to_front", wrong)
    assert flicker(frames(scene_after(level, 1800), MOVES["orbit"][:12])) > MOST


def test_a_cached_picture_equals_a_fresh_one():
    """Through hits, falls, a moving camera and a change of size, a used painter draws what a new one draws."""
    game, pilot, effects, painter, view = new_game(classic()[4:], 3), Autopilot(), Effects(), Painter(), SOLID
    compared = fell = 0
    for number in range(3000):
        done = tick(game, pilot.controls(game))
        game, effects = done.game, after(effects, done)
        scene = scene_at(done, 0.5, effects)
        if number % 60 and not (scene.falling and number % 8 == 0):
            continue
        if number > 1500:
            view = view._replace(azimuth=view.azimuth + 0.1, zoom=1.0 + number / 3000.0)
        size = (240, 180) if number % 1000 < 800 else (300, 260)
        pictures = []
        for one in (painter, Painter()):
            canvas = canvas_of(scene, size, view)
            one.paint(canvas, scene)
            pictures.append(pygame.image.tobytes(canvas.surface, "RGB"))
        assert pictures[0] == pictures[1]
        compared, fell = compared + 1, fell + bool(scene.falling)
    assert min(compared, fell) > 50


@pytest.mark.parametrize("finer", [1, 2, 3])
@pytest.mark.parametrize("size", [(700, 300), (97, 250), (1, 1)])
def test_a_raster_looks_as_if_drawn_in_one_piece(size, finer):
    """Tiles show what one large drawing scaled down would show, also where it leaves the surface."""
    chance = np.random.default_rng(5)
    low = chance.integers(-100, np.array(size) * finer + 60, (120, 1, 2))
    corners = (low + np.array([[0, 0], [60, 9], [66, 70], [-9, 80]])).astype(np.int32)
    colours = [pygame.Color(*chance.integers(0, 255, 3).tolist(), 255) for _ in corners]
    canvas = pygame.Surface((size[0] * finer, size[1] * finer), pygame.SRCALPHA, 32)
    mapped = np.array([canvas.map_rgb(colour) & 0xFFFFFFFF for colour in colours], dtype=np.uint32)
    raster, whole, tiled = QuadRaster(), pygame.Surface(size, 0, 32), pygame.Surface(size, 0, 32)
    whole.fill((40, 90, 20))
    raster.draw(tiled, pixels(corners[:9]), mapped[:9], finer)
    tiled.fill((40, 90, 20))
    raster.draw(tiled, pixels(corners), mapped, finer)
    for colour, (a, b, c, d) in zip(colours, corners.tolist(), strict=True):
        first, second = ((a, b, c), (a, c, d)) if abs(a[1] - c[1]) <= abs(b[1] - d[1]) else ((b, c, d), (b, d, a))
        pygame.draw.polygon(canvas, colour, first)
        pygame.draw.polygon(canvas, colour, second)
    whole.blit(pygame.transform.smoothscale(canvas, size), (0, 0), special_flags=pygame.BLEND_PREMULTIPLIED)
    off = np.abs(pygame.surfarray.array3d(whole).astype(int) - pygame.surfarray.array3d(tiled))
    assert off.max() <= 1
    assert size == (1, 1) or len(np.unique(pygame.surfarray.array3d(tiled).reshape(-1, 3), axis=0)) > 20


def test_filled_at_once_quadrilaterals_look_as_in_tiles():
    """On a large surface they are filled without tiles: pixel by pixel the same as with tiles that are no finer."""
    chance = np.random.default_rng(7)
    low = chance.integers(-60, 700, (150, 1, 2))
    corners = pixels((low + np.array([[0, 0], [60, 9], [66, 70], [-9, 80]])).astype(np.int32))
    colours = chance.integers(0, 255, (len(corners), 3)).astype(np.float32)
    at_once, tiled = pygame.Surface((700, 300), 0, 32), pygame.Surface((700, 300), 0, 32)
    fill_quads(at_once, corners, colours)
    raster = QuadRaster()
    raster.draw(tiled, corners, packed(raster.canvas, colours), 1)
    assert np.array_equal(pygame.surfarray.array3d(at_once), pygame.surfarray.array3d(tiled))


def pixels(corners):
    """Columns and rows, along the last axis, as `QuadRaster` takes them."""
    return np.ascontiguousarray(corners, dtype=np.float32).view(np.complex64)[..., 0]


def test_a_tile_that_shows_the_same_is_not_drawn_again(monkeypatch):
    """Of a scene at rest no tile is drawn twice; of one in which the paddles move, only some are."""
    scene = scene_after(0, 700)._replace(balls=(), trails=(), flashes=(), aim=None)
    drawn = []
    fill = QuadRaster._fill
    monkeypatch.setattr(QuadRaster, "_fill", lambda self, quads, *rest: drawn.append(quads.box) or fill(self, quads, *rest))
    painter = Painter()
    turned = scene._replace(rings=(scene.rings[0]._replace(phase=0.3), *scene.rings[1:]))
    counts = []
    for seen in (scene, scene, turned):
        drawn.clear()
        painter.paint(canvas_of(seen, (1280, 800), SOLID), seen)
        counts.append(len(drawn))
    assert counts[0] > 10
    assert counts[1] == 0
    assert 0 < counts[2] < counts[0]


def test_a_raster_of_nothing_changes_nothing():
    """No quadrilateral at all, or one beside the surface, changes no pixel."""
    surface = pygame.Surface((40, 30), 0, 32)
    beside = np.array([[[90, 10], [99, 10], [99, 20], [90, 20]]], dtype=np.int32)
    for corners in (beside[:0], beside):
        QuadRaster().draw(surface, pixels(corners), np.full(len(corners), 0xFFFFFFFF, dtype=np.uint32), 2)
    assert not pygame.surfarray.array3d(surface).any()
