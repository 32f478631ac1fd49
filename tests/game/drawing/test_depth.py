"""Light and shadow of the flat view, the ground's colours and its patterns."""

import cmath
import math
import os
from typing import get_args

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.drawing import palettes
from game.drawing.ground.picture import ground_picture
from game.drawing.ground.shades import discs
from game.drawing.painter import Painter
from game.drawing.palette import DARK, LIGHT, luminance, without_depth
from game.effects import NOTHING, Light, LightSource
from game.input.view import FLAT, SOLID
from game.level_format.specs import GroundPattern, Palette
from game.picture.ground.colours import around_shade, ground_shade, rounded
from game.picture.ground.lists import ground_list
from game.picture.ground.measures import Ground
from game.picture.ground.patterns import NAMES, marks
from game.scene import scene_at
from tests.support.games.autopilot_games import game_after
from tests.support.pictures import canvas_of

SIZE = (900, 700)
THEMES = pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])


def painted(theme, view=FLAT, **changes):
    """The first level with single bricks before its serve, as an array of colours, its camera and its scene."""
    scene = scene_at(game_after(0, 0)[0], 1.0, NOTHING)
    single = (scene.layers[0], *[(1,) * ring.count for ring in scene.rings[1:]])
    scene = scene._replace(aim=None, balls=(), layers=single, **changes)
    canvas = canvas_of(scene, SIZE, view, theme)
    Painter().paint(canvas, scene)
    return pygame.surfarray.array3d(canvas.surface).astype(int), canvas.camera, scene


def brightness(picture, camera, point):
    """Of the pixel that a point of the ground falls into."""
    pixel = camera.project(point)
    return luminance(tuple(picture[math.floor(pixel.real), math.floor(pixel.imag)]))


@THEMES
def test_light_falls_from_the_centre(theme):
    """A brick's inner edge is brighter than its middle, that than its outer edge; behind it the ground lies in its shadow."""
    picture, camera, scene = painted(theme)
    ring, pixel = scene.rings[1], 1.0 / camera.scale
    for slot in range(ring.count):
        out = cmath.exp(1j * ring.angle(slot))
        radii = (ring.inner_radius + 1.5 * pixel, ring.radius, ring.outer_radius - 1.5 * pixel)
        inner, middle, outer = (brightness(picture, camera, out * radius) for radius in radii)
        assert inner > middle > outer
        shaded = brightness(picture, camera, out * (ring.outer_radius + 2.0 * pixel))
        assert shaded < 0.9 * brightness(picture, camera, out * (ring.outer_radius + 0.5))


@THEMES
@pytest.mark.parametrize("share", [0.0, 0.4003, 0.9701, 1.0, 1.0203, 1.59])
def test_many_pixels_of_the_ground_have_the_colour_of_each(theme, share):
    """To a fiftieth of a step of a channel, also between the distances at which the list gives colours."""
    around, ground = discs(ground_list(Ground(10.0), theme, 30.0))
    disc, shade = (ground, ground_shade) if share <= 1.0 else (around, around_shade)
    assert disc.at(np.float32([10.0 * share]))[0] == pytest.approx(shade(theme, share), abs=0.02)


@THEMES
def test_the_ground_is_lighter_in_the_middle_and_smooth(theme):
    """A picture shows the colours to a step of 255, and neighbouring ones differ by a step; the middle is the lightest."""
    canvas = canvas_of(scene_at(game_after(0, 0)[0], 1.0, NOTHING), SIZE, FLAT, theme)
    ground = Ground(10.0)
    picture = pygame.surfarray.array3d(ground_picture(canvas, ground)).astype(int)
    middle = canvas.camera.centre
    row = picture[round(middle.real) : round(middle.real + 9.0 * canvas.camera.scale), math.floor(middle.imag)]
    shares = (np.arange(len(row)) + 0.5) / (10.0 * canvas.camera.scale)
    assert np.abs(row - [ground_shade(theme, share) for share in shares.tolist()]).max() < 1.0
    assert np.abs(np.diff(row, axis=0)).max() <= 1
    assert luminance(tuple(row[0])) == max(map(luminance, row[shares < 0.9].tolist()))
    plain = pygame.surfarray.array3d(ground_picture(canvas._replace(theme=without_depth(theme)), ground))
    assert tuple(plain[round(middle.real) + 90, round(middle.imag)]) == theme.ground == rounded(theme.ground)


@pytest.mark.parametrize("name", NAMES)
def test_a_pattern_stays_on_the_ground_and_faint(name):
    """Every mark lies within the rim, and no mark is as strong as what the ball can meet."""
    drawn = marks(name)
    outermost = [max(map(abs, mark.corners)) for mark in drawn]
    assert max(outermost) < 1.0
    inner = [mark for mark, far in zip(drawn, outermost, strict=True) if far < 0.95]
    assert all([mark.strength <= 1.0 for mark in inner])
    assert bool(inner) == (name != "plain")


def test_a_pattern_turns_with_the_arena():
    """Seen from the side, what was at the right is at the bottom: the ground's pattern is of the world, not of the screen."""
    dots = [painted(DARK, SOLID._replace(azimuth=azimuth), ground="rays")[:2] for azimuth in (0.0, 0.2)]
    spots = [cmath.rect(6.5, math.tau * (k + 0.5) / 24.0 + 0.01) for k in range(24)]
    rows = [[brightness(picture, camera, spot) for spot in spots] for picture, camera in dots]
    assert np.corrcoef(*rows)[0, 1] > 0.8


def test_gaps_of_a_turning_ring_show_the_pattern():
    """Where no brick stands, the pixels are those of a picture without the ring."""
    scene = scene_at(game_after(3, 0)[0], 1.0, NOTHING)._replace(aim=None, balls=(), ground="dots")
    assert scene.rings[1].spin
    pictures = []
    for one in (scene, scene._replace(layers=(scene.layers[0], *[(0,) * len(ring) for ring in scene.layers[1:]]))):
        canvas = canvas_of(one, SIZE, FLAT, DARK)
        Painter().paint(canvas, one)
        pictures.append(pygame.surfarray.array3d(canvas.surface).astype(int))
    columns, rows = np.indices(SIZE) + 0.5
    points = (columns - canvas.camera.centre.real) + 1j * (canvas.camera.centre.imag - rows)
    radius, angle = np.abs(points) / canvas.camera.scale, np.angle(points)
    free = np.ones(SIZE, dtype=bool)
    for ring in scene.rings[1:]:
        off = np.abs((angle - ring.phase + math.pi / ring.count) % (math.tau / ring.count) - math.pi / ring.count)
        free &= (np.abs(radius - ring.radius) > ring.half_width + 0.3) | (off > ring.half_angle + 0.3 / ring.radius)
    assert (np.abs(pictures[0] - pictures[1]).max(axis=2)[free] <= 1).all()
    assert (np.abs(pictures[0] - pictures[1]).max(axis=2)[~free] > 30).any()


def test_levels_name_what_is_drawn():
    """The palettes and grounds that a level file may name are those that there are, the default first."""
    assert get_args(Palette) == palettes.NAMES
    assert get_args(GroundPattern) == NAMES


@THEMES
def test_a_hit_throws_light_that_fades(theme):
    """Near a light the ground is lighter on the dark theme, tinted on the light one, less and less; far away it is not."""
    light = Light(LightSource.PADDLE, 6.0 + 0j, 0.26, 0.6, 70)
    dim, camera, _ = painted(theme)
    off = []
    for age in (0, 20, 45):
        picture, _, _ = painted(theme, lights=(light._replace(age=age),))
        change = picture - dim
        near, far = camera.project(6.3 + 0.4j), camera.project(-6.0 + 0j)
        assert not change[math.floor(far.real), math.floor(far.imag)].any()
        off.append(np.abs(change[math.floor(near.real), math.floor(near.imag)]).sum())
        assert (change.min() >= 0) if theme is DARK else (change.max() <= 0)
    assert off[0] > off[1] > off[2] > 0
