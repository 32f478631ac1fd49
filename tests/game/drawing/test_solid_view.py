"""The solid view: its blocks have their size, it fits any surface, and tipping changes nothing else."""

import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing.painter import Painter
from game.drawing.palette import DARK, layer_colour
from game.drawing.solid.blocks import ring_blocks
from game.effects import Effects, after
from game.input.view import FLAT, SOLID, Viewpoint
from game.levels import classic
from game.picture.slots.contents import ContentKind, SlotContent
from game.picture.solid.rings import ring_prisms
from game.replays.state_hash import state_hash
from game.rules import new_game, tick
from game.scene import scene_at
from game.screenshot import save_screenshot
from tests.support.games.autopilot_games import game_after
from tests.support.paths import REFERENCE
from tests.support.pictures import TIPPED, camera_of, canvas_of, painted, solid_ring

SIZE = (480, 360)


@pytest.mark.parametrize("phase", [0.0, 0.1, 0.23, 0.37])
@pytest.mark.parametrize("size", [(480, 360), (900, 700)])
def test_blocks_cover_as_many_pixels_as_they_should(phase, size):
    """All but upright, what a ring's blocks cover adds up to its sectors' area, to a tenth of a pixel along their edges."""
    base = scene_at(game_after(0, 0)[0], 1.0, Effects())._replace(balls=(), aim=None)
    ring = base.rings[1]._replace(phase=phase)
    scene = base._replace(rings=(base.rings[0], ring), layers=(base.layers[0], (1,) * ring.count))
    camera = camera_of(FLAT, scene, size)._replace(tilt=1e-7)
    pixels = pygame.surfarray.array3d(painted(scene, camera, size)).astype(float)
    brick, ground = np.array(layer_colour(DARK, 1), float), np.array(DARK.ground, float)
    columns, rows = np.indices(pixels.shape[:2]) + 0.5
    near = np.abs(np.hypot(columns - camera.centre.real, rows - camera.centre.imag) / camera.scale - ring.radius) < 1.0
    covered = ((pixels[near] - ground) @ (brick - ground) / ((brick - ground) @ (brick - ground))).sum()
    area = ring.count * 2.0 * ring.half_angle * ring.radius * 2.0 * ring.half_width * camera.scale**2
    edges = ring.count * 2.0 * (2.0 * ring.half_angle * ring.radius + 2.0 * ring.half_width) * camera.scale
    assert abs(covered - area) < 0.1 * edges


@pytest.mark.parametrize("level", range(7))
@pytest.mark.parametrize("size", [(800, 600), (1280, 800)])
def test_all_but_upright_the_blocks_look_as_from_above(level, size):
    """Just before the camera is upright the silhouettes and the tops' colours are those of the top-down picture."""
    done, _ = game_after(level, 900)
    scene = scene_at(done, 0.4, Effects())._replace(aim=None, trails=())
    flat = camera_of(FLAT, scene, size)
    pictures = [
        pygame.surfarray.array3d(painted(scene, camera, size)).astype(int) for camera in (flat, flat._replace(tilt=1e-7))
    ]
    off = np.abs(pictures[0] - pictures[1]).max(axis=2)
    assert (off > 110).mean() < 0.001
    assert off.mean() < 1.0


@pytest.mark.parametrize("size", [(1, 1), (2, 300), (300, 2), (17, 17), (7680, 40), (40, 4320), (800, 600)])
def test_any_size_can_be_drawn(size, tmp_path):
    """Pictures of one pixel, very wide and very high ones have the size that was asked for."""
    path = tmp_path / "picture.png"
    save_screenshot(game_after(5, 300)[0].game, path, size, view=SOLID)
    assert pygame.image.load(path).get_size() == size


def test_eight_thousand_pixels_can_be_drawn():
    """A painter draws on a surface of 7680 by 4320, and on a small one afterwards."""
    scene = scene_at(game_after(4, 300)[0], 0.5, Effects())
    painter = Painter()
    for size in ((7680, 4320), (320, 200)):
        canvas = canvas_of(scene, size, SOLID)
        painter.paint(canvas, scene)
        middle = pygame.surfarray.array3d(canvas.surface)[size[0] // 3 : size[0] * 2 // 3, size[1] // 4 : size[1] * 2 // 3]
        assert len(np.unique(middle[::8, ::8].reshape(-1, 3), axis=0)) > 20


def test_tipping_leaves_the_game_alone():
    """A game that is drawn tipped at every tick while its stacks fall ends in the same state as one that is not."""
    game, pilot, effects, painter = new_game(classic()[4:], 3), Autopilot(), Effects(), Painter()
    fell = 0
    for number in range(1200):
        done = tick(game, pilot.controls(game))
        game, effects = done.game, after(effects, done)
        scene = scene_at(done, 0.3, effects)
        if scene.falling:
            fell += 1
            painter.paint(canvas_of(scene, (80, 60), TIPPED[number % 20]), scene)
    assert fell > 200
    assert state_hash(game) == state_hash(game_after(4, 1200)[0].game)


@pytest.mark.parametrize(("level", "view"), [(4, SOLID), (6, Viewpoint(1.0, 1.0, 2.2, 1.2)), (5, Viewpoint(1.0, 0.4))])
def test_reference_pictures(level, view):
    """Fewer than 0.1 % of the pixels differ from pictures that somebody has looked at."""
    done, _ = game_after(level, 1500)
    scene = scene_at(done, 0.5, Effects())
    surface = painted(scene, camera_of(view, scene, SIZE), SIZE)
    path = REFERENCE / f"3d-level-{level + 1}.png"
    off = np.abs(pygame.surfarray.array3d(surface).astype(int) - pygame.surfarray.array3d(pygame.image.load(path)))
    assert (off.max(axis=2) > 16).mean() < 0.001


@pytest.mark.parametrize(("half_angle", "slots"), [(math.pi, 1), (1.2, 2), (0.1, 20)])
def test_feet_cover_the_sectors_and_only_their_ends_are_ends(half_angle, slots):
    """The feet of a ring's blocks have its sectors' area together; a whole ring has no ends, a sector has two."""
    every = ring_blocks(ring_prisms(solid_ring(half_angle, slots, SlotContent(ContentKind.BRICKS, 1))))
    following = np.roll(every.foot, -1, axis=1)
    area = 0.5 * (every.foot.conjugate() * following).imag.sum()
    assert area == pytest.approx(slots * 2.0 * half_angle * 3.0 * 0.8, rel=0.003)
    assert every.sides[:, 1].sum() == every.sides[:, 3].sum() == (0 if half_angle == math.pi else slots)
    assert every.sides[:, [0, 2]].all()
