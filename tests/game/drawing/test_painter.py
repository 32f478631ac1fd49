"""The flat view shows what the geometry says, and drawing changes nothing."""

import cmath
import itertools
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing.flat.sector_colours import PolarPixels, paint_slot
from game.drawing.painter import Painter
from game.drawing.palette import DARK, contrast, layer_colour, mixed
from game.drawing.raster.annulus import annulus_pixels
from game.effects import Effects, after
from game.levels import classic
from game.picture.display_list import DisplayList
from game.picture.slots.contents import ContentKind, SlotContent
from game.picture.slots.flat import FlatRing, add_content
from game.picture.slots.parts import DOT_SHADE, SlotShape, dots
from game.replays.state_hash import state_hash
from game.rules import PADDLES, new_game, tick
from game.scene import scene_at
from game.screenshot import save_screenshot
from physics import PERMANENT
from tests.support.games.autopilot_games import game_after
from tests.support.pictures import PLAIN_DARK, PLAIN_LIGHT, canvas_of

SIZE = (900, 700)


def tick_after(level, ticks, seed=3):
    """The last tick of an autopilot's game."""
    return game_after(level, ticks, seed)[0]


def painted(scene, size=SIZE, theme=PLAIN_DARK, painter=None):
    """A scene on a new surface, and the camera that saw it."""
    canvas = canvas_of(scene, size, theme=theme)
    (painter or Painter()).paint(canvas, scene)
    return canvas.surface, canvas.camera


def colour_at(surface, camera, point):
    """The pixel that a point of the world falls into."""
    pixel = camera.project(point)
    return tuple(surface.get_at((math.floor(pixel.real), math.floor(pixel.imag))))[:3]


def bare(done, alpha=1.0):
    """A scene without anything that could cover a sector."""
    return scene_at(done, alpha, Effects())._replace(balls=(), aim=None)


def top_colour(theme, layers):
    """What is in the very middle of a stack's top: three layers have a dot there."""
    colour = layer_colour(theme, layers)
    return mixed(colour, theme.ground, DOT_SHADE) if layers == 3 else colour


@pytest.mark.parametrize("theme", [PLAIN_DARK, PLAIN_LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("level", range(7))
def test_sectors_are_where_the_geometry_says(level, theme):
    """In the middle of every slot is the colour of what stands in it; half way to the next slot is the ground's."""
    scene = bare(tick_after(level, 1500))
    surface, camera = painted(scene, theme=theme)
    checked = 0
    for k, (ring, layers) in enumerate(zip(scene.rings, scene.layers, strict=True)):
        for slot, count in enumerate(layers):
            got = colour_at(surface, camera, ring.radius * cmath.exp(1j * ring.angle(slot)))
            if k == PADDLES:
                assert got == theme.paddle_top
            elif count == PERMANENT:
                assert got != theme.ground
            else:
                assert got == (top_colour(theme, count) if count else theme.ground)
            checked += 1
            gap = (math.pi / ring.count - ring.half_angle) * ring.radius * camera.scale
            if k != PADDLES and gap > 2.0:
                between = ring.radius * cmath.exp(1j * (ring.angle(slot) + math.pi / ring.count))
                assert colour_at(surface, camera, between) == theme.ground
    assert checked > 12


@pytest.mark.parametrize("phase", [0.0, 0.001, 0.37, 3.0])
def test_edges_lie_where_they_belong_to_a_fraction_of_a_pixel(phase):
    """At any angle the cover of all pixels of a ring adds up to the area of its sectors."""
    scene = bare(tick_after(0, 0))
    ring = scene.rings[1]._replace(phase=phase, spin=0.1)
    scene = scene._replace(rings=(scene.rings[0], ring), layers=(scene.layers[0], (1,) * ring.count))
    surface, camera = painted(scene)
    brick, ground = np.array(layer_colour(DARK, 1), float), np.array(DARK.ground, float)
    pixels = pygame.surfarray.array3d(surface).astype(float)
    columns, rows = np.indices(pixels.shape[:2]) + 0.5
    near = np.abs(np.hypot(columns - camera.centre.real, rows - camera.centre.imag) / camera.scale - ring.radius) < 1.0
    covered = ((pixels[near] - ground) @ (brick - ground) / ((brick - ground) @ (brick - ground))).sum()
    area = ring.count * 2.0 * ring.half_angle * ring.radius * 2.0 * ring.half_width * camera.scale**2
    edges = ring.count * 2.0 * (2.0 * ring.half_angle * ring.radius + 2.0 * ring.half_width) * camera.scale
    assert abs(covered - area) < 0.1 * edges


def test_every_layer_of_a_stack_can_be_seen():
    """From a stack's face to its middle the colours of all its terraces come in order."""
    scene = bare(tick_after(4, 0))
    surface, camera = painted(scene, (1800, 1400))
    ring, layers = scene.rings[1], scene.layers[1]
    assert max(layers) == 6
    outwards = cmath.exp(1j * ring.angle(0))
    seen = []
    for step in np.linspace(ring.inner_radius, ring.radius, 400):
        colour = np.array(colour_at(surface, camera, complex(step) * outwards), float)
        away = [float(np.abs(colour - layer_colour(DARK, layer)).max()) for layer in range(1, 10)]
        if min(away) < 40.0 and away.index(min(away)) + 1 not in seen:
            seen.append(away.index(min(away)) + 1)
    assert seen == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize("theme", [PLAIN_DARK, PLAIN_LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("layers", range(1, 10))
def test_as_many_dots_as_layers(layers, theme):
    """From two layers on there is a dot for every layer, apart from the others and with contrast enough."""
    found = dots(layers, SlotShape(4.0, 0.45, 0.3, 9, 0.01))
    assert len(found) == (0 if layers == 1 else layers)
    for (radius, angle, half), (other_radius, other_angle, _) in itertools.combinations(found, 2):
        assert max(abs(radius - other_radius), 4.0 * abs(angle - other_angle)) > 2.9 * half
    top = layer_colour(theme, layers)
    assert contrast(top, mixed(top, theme.ground, DOT_SHADE)) > 1.8


def test_a_dot_is_where_it_is_said_to_be():
    """In the middle of a dot is the dots' colour, and beside it the top's."""
    shape, scale = SlotShape(5.0, 1.0, 0.3, 4, 0.05), 20.0
    ring, stack = FlatRing(shape, 1, scale, 0.0, (0.0, 9.0), PLAIN_DARK), DisplayList()
    add_content(stack, ring, SlotContent(ContentKind.BRICKS, 4), ring.sector(0j, 0.0))
    inset = 3.0 * shape.terrace
    for radius, angle, half in dots(4, shape._replace(half_width=1.0 - inset, half_angle=0.3 - inset / 5.0)):
        radii, angles = np.float32([radius, radius + 2.0 * half]) * scale, np.float32([angle, angle])
        picture = np.zeros((3, 2), dtype=np.float32)
        paint_slot(picture, stack, PolarPixels(radii, angles))
        assert np.abs(picture[:, 0] - mixed(layer_colour(DARK, 4), DARK.ground, DOT_SHADE)).max() < 1.0
        assert np.abs(picture[:, 1] - layer_colour(DARK, 4)).max() < 1.0


@pytest.mark.parametrize("layers", [2, 3, 5])
def test_dots_are_where_they_belong_and_nowhere_else(layers):
    """Along the middle of a stack's top the colours change as often as its dots say: twice for every dot on the way."""
    scene = bare(tick_after(0, 0))
    scene = scene._replace(layers=(scene.layers[0], (layers,) * scene.rings[1].count), tallest=(0, 9))
    surface, camera = painted(scene, (1800, 1400))
    ring = scene.rings[1]
    shape = SlotShape(ring.radius, ring.half_width, ring.half_angle, 9, 1.0 / camera.scale)
    inset = (layers - 1) * shape.terrace
    top = shape._replace(half_width=ring.half_width - inset, half_angle=ring.half_angle - inset / ring.radius)
    row = [dot for dot in dots(layers, top) if dot[0] == max(radius for radius, _, _ in dots(layers, top))]
    radius, reach = row[0][0], 0.8 * top.half_angle
    angles = ring.angle(2) + np.linspace(-reach, reach, 900)
    seen = [colour_at(surface, camera, radius * cmath.exp(1j * float(angle))) == layer_colour(DARK, layers) for angle in angles]
    assert sum(one != other for one, other in itertools.pairwise(seen)) == 2 * len(row)


def test_what_cannot_break_differs_in_shape_too():
    """A steel sector is crossed by lines; a stack's top is plain."""
    scene = bare(tick_after(5, 0))
    surface, camera = painted(scene)
    ring, layers = scene.rings[2], scene.layers[2]

    def shades(slot):
        angles = np.linspace(-0.8, 0.8, 60) * ring.half_angle + ring.angle(slot)
        return {colour_at(surface, camera, ring.radius * cmath.exp(1j * float(angle))) for angle in angles}

    assert len(shades(layers.index(1))) == 1
    assert DARK.steel_line in shades(layers.index(PERMANENT))


def test_the_ball_is_drawn_at_its_place():
    """The pixel under the ball's middle is bright; 2.5 radii away from it is the ground."""
    done = tick_after(0, 400)
    scene = scene_at(done, 0.5, Effects())
    surface, camera = painted(scene)
    ball = scene.balls[0]
    assert min(colour_at(surface, camera, ball.position)) > 150
    assert colour_at(surface, camera, ball.position * (1.0 - 2.5 * ball.radius / abs(ball.position))) == DARK.ground


def test_a_cached_picture_equals_a_fresh_one():
    """During thousands of ticks and a change of level, a painter with caches draws what a new one draws, also lit by hits."""
    game, pilot, painter, effects = new_game(classic()[:3], 5), Autopilot(), Painter(), Effects()
    compared = 0
    levels = set()
    for number in range(16_000):
        done = tick(game, pilot.controls(game))
        game, effects = done.game, after(effects, done)
        if number % 200 == 0 or (done.step.hits and number % 7 == 0):
            scene = scene_at(done, 0.5, effects)
            cached, _ = painted(scene, (240, 180), painter=painter)
            fresh, _ = painted(scene, (240, 180))
            assert pygame.image.tobytes(cached, "RGB") == pygame.image.tobytes(fresh, "RGB")
            compared += 1
            levels.add(game.number)
    assert compared > 50
    assert len(levels) > 1


def test_drawing_leaves_the_game_alone():
    """A game that is drawn at every tick ends in the same state as one that is not."""
    game, pilot, painter = new_game(classic()[3:], 11), Autopilot(), Painter()
    for _ in range(500):
        done = tick(game, pilot.controls(game))
        painted(scene_at(done, 0.3, Effects()), (120, 90), painter=painter)
        game = done.game
    assert state_hash(game) == state_hash(tick_after(3, 500, seed=11).game)


@pytest.mark.parametrize("size", [(1, 1), (2, 300), (300, 2), (17, 17), (7680, 40), (800, 600)])
def test_any_size_can_be_drawn(size, tmp_path):
    """Pictures of one pixel, very wide and very high ones have the size that was asked for."""
    path = tmp_path / "picture.png"
    save_screenshot(tick_after(5, 300).game, path, size)
    assert pygame.image.load(path).get_size() == size


def test_a_screenshot_is_a_full_picture(tmp_path):
    """A screenshot has many colours, the figures in its corner, and the same bytes every time."""
    game = tick_after(4, 700).game
    for name in ("one.png", "two.png"):
        save_screenshot(game, tmp_path / name, (800, 600))
    assert (tmp_path / "one.png").read_bytes() == (tmp_path / "two.png").read_bytes()
    pixels = pygame.surfarray.array3d(pygame.image.load(tmp_path / "one.png"))
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 100
    corner = pixels[:150, :90].reshape(-1, 3)
    assert (corner.min(axis=1) > 220).any()


def test_a_screenshot_that_cannot_be_written_says_so(tmp_path):
    """Writing into a folder that does not exist raises the system's error, with the path in it."""
    with pytest.raises(OSError, match="nowhere"):
        save_screenshot(tick_after(0, 0).game, tmp_path / "nowhere" / "picture.png", (64, 64))


@pytest.mark.parametrize("centre", [50 + 40j, 0j, -30 + 20j, 50.5 + 40.25j])
@pytest.mark.parametrize("radii", [(10.0, 20.0), (0.0, 15.5), (33.3, 34.1)])
def test_an_annulus_has_every_pixel_between_its_radii_once(centre, radii):
    """It has the pixels whose middles are between the radii, each of them once."""
    width, height = 100, 80
    pixels = annulus_pixels((width, height), width, centre, *radii)
    xs, ys = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    away = np.hypot(xs - centre.real, ys - centre.imag)
    inside = (away >= radii[0] - 1e-9) & (away <= radii[1] + 1e-9)
    expected = np.flatnonzero(inside.ravel())
    assert sorted(pixels.pixel.tolist()) == expected.tolist()
    assert np.allclose(pixels.radius, away.ravel()[pixels.pixel], atol=1e-4)
