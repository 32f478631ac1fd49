"""One picture, two painters: the same list on the page's canvas and on a surface of pygame."""

import base64
import io
import math

import numpy as np
import pygame
import pytest

from game.drawing import light
from game.drawing.balls.ball import BallPictures
from game.drawing.camera import Camera
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.painter import Painter
from game.drawing.text import Type
from game.effects import NOTHING, Burst, FallingStack, Light, Wave
from game.effects.bursts import BurstOrigin, Matter
from game.effects.lights import LightSource
from game.effects.piece_paths import NUMBERS_OF_PIECES
from game.effects.waves import WaveTone
from game.input.view import FLAT, SOLID
from game.levels import campaign, classic
from game.picture.arena import ArenaPicture
from game.picture.display_list import DisplayList
from game.picture.ground import colours, lists, measures
from game.picture.moving.balls import BallTextures, add_ball
from game.picture.moving.layers import add_in_air, add_on_ground
from game.picture.slots import flat
from game.picture.solid import rings
from game.rules import ActivePower, Drop, PowerUp, Ruleset, new_game
from game.scene import Aim, Well, scene_at, still
from game.unlocks import BALLS, PLAIN_TRAIL, TRAILS
from physics import Ball
from tests.support.pictures import DARK, LIGHT, camera_of, canvas_of

SIZE = (900, 700)
TOLERANCE = (0.3, 80.0)
"""Of the pictures' mean difference and of the worst block's, of 255: pygame draws small dots with whole pixels."""
PAINT = """async ([numbers, ground, width, height]) => {
  const { paint } = await import("./painter.js");
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = canvas.getContext("2d");
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  paint(context, new Float32Array(numbers), []);
  return canvas.toDataURL();
}"""
COUNT = """async ([numbers, width, height]) => {
  const { paint } = await import("./painter.js");
  const canvas = Object.assign(document.createElement("canvas"), { width, height }), context = canvas.getContext("2d");
  paint(context, new Float32Array(numbers), []);
  const { data } = context.getImageData(0, 0, width, height), alphas = {}, colours = {};
  for (let k = 0; k < data.length; k += 4) {
    if (data[k + 3]) alphas[data[k + 3]] = (alphas[data[k + 3]] ?? 0) + 1;
    if (data[k + 3] === 255) colours[data.subarray(k, k + 3)] = (colours[data.subarray(k, k + 3)] ?? 0) + 1;
  }
  return [alphas, colours];
}"""
"""Counts on a transparent canvas: pixels by opacity, and opaque pixels by colour."""
RESTING = (0.5, 23.0)
"""The same of the ground and of what stands on it, which differ in their smooth edges alone.

Levels with wells or bumpers are not compared so: their discs and circles are the display list's, and the desktop puts the
centres of these on the nearest pixel's. That makes up to 60 in the worst block."""
IN_3D = (0.7, 70.0)
"""The same in 3D: the desktop fills whole pixels of a finer drawing. The worst blocks are pieces some pixels wide: there the
desktop draws an outline inside each, which makes it up to a pixel wider and its tips blunt."""
DESCRIPTIONS = (flat._flat_rings, lists.ground_list)
"""What caches parts of the description."""
SQUARE = (-0.5 - 0.5j, -0.5 + 0.5j, 0.5 + 0.5j, 0.5 - 0.5j)


def everything_that_moves():
    """A scene with all of it, on a bare ground."""
    game = new_game(classic(), 1, Ruleset())
    return scene_at(still(game), 1.0, NOTHING)._replace(
        balls=(Ball(2.0 + 1.0j, 3.0 + 1.0j, 0.25),),
        trails=(tuple([complex(2.0 - 0.2 * k, 1.0 - 0.02 * k * k) for k in range(24)][::-1]),),
        aim=Aim(-3.0 - 3.0j, 0.6 + 0.8j),
        waves=(Wave(WaveTone.GOOD, 1.0, 8.0, 40),),
        lights=(Light(LightSource.PADDLE, -5.0 + 2.0j, 0.26, 0.9, 70),),
        shining=True,
        wells=(Well(5.0 - 3.0j, 2.0, 30.0),),
        clock=1.3,
        powers=tuple([ActivePower(kind, 700, 1000) for kind in (PowerUp.PIERCE, PowerUp.SLOW, PowerUp.FAST)]),
        drops=tuple([Drop(kind, 5.0j + 1.5 * k, 1j) for k, kind in enumerate(PowerUp)]),
        core=0.6,
    )


def blocks(picture):
    """Means over blocks of 4 by 4 pixels: what anti-aliasing does to an edge counts little."""
    pixels = pygame.surfarray.array3d(picture).astype(np.float64)
    return pixels.reshape(SIZE[0] // 4, 4, SIZE[1] // 4, 4, 3).mean(axis=(1, 3))


def painted_by_page(page, numbers, ground=(0, 0, 0)):
    """What the page paints for a list on a ground, as `blocks`."""
    shown = page.tab.evaluate(PAINT, [numbers.tolist(), "#{:02x}{:02x}{:02x}".format(*ground), *SIZE])
    return blocks(pygame.image.load(io.BytesIO(base64.b64decode(shown.split(",")[1])), "shown.png"))


def both_pictures(page, canvas, scene):
    """The desktop's picture of a scene, and the page's of its two lists, as `blocks`."""
    Painter().paint(canvas, scene)
    arena = ArenaPicture()
    numbers = arena.backdrop(scene, canvas.view).numbers + arena.frame(scene, canvas.view).numbers
    return blocks(canvas.surface), painted_by_page(page, numbers)


@pytest.mark.parametrize(
    ("view", "theme", "trail"),
    [*[(FLAT, DARK, trail) for trail in TRAILS], (SOLID, DARK, PLAIN_TRAIL), (FLAT, LIGHT, PLAIN_TRAIL)],
    ids=[*TRAILS, "solid", "light"],
)
def test_both_painters_show_the_same(page, view, theme, trail):
    """Everything that moves, of every trail: mean difference of a channel, of 255, and of the worst block."""
    scene = everything_that_moves()
    canvas = canvas_of(scene, SIZE, theme=theme, camera=camera_of(view, scene, SIZE))._replace(unit=20.0, trail=trail)
    picture = DisplayList()
    add_on_ground(picture, scene, canvas.view)
    add_in_air(picture, scene, canvas.view)
    canvas.surface.fill(theme.ground)
    DisplayListPainter().paint(canvas.surface, Type(), picture)
    apart = np.abs(blocks(canvas.surface) - painted_by_page(page, picture.numbers, theme.ground))
    assert apart.mean() < TOLERANCE[0]
    assert apart.max() < TOLERANCE[1]


@pytest.fixture
def other_description(monkeypatch):
    """Other dimensions and shares of what one sees from above, as a change of the description would have them."""
    values = {"_EDGE": 0.4, "_AT_FACES": 0.5, "_AT_ENDS": 0.3, "_SLOPE": 0.2, "_SHADOW": 0.04, "_INWARDS": 0.8, "_ASIDE": 0.9}
    for name, value in values.items():
        monkeypatch.setattr(flat, name, value)
    monkeypatch.setattr(measures, "_RIM", 0.2)
    monkeypatch.setattr(measures, "_TRACK", 0.2)
    monkeypatch.setattr(colours, "_INNER_GLOW", 0.4)
    for function in DESCRIPTIONS:
        function.cache_clear()
    yield
    for function in DESCRIPTIONS:
        function.cache_clear()


def from_above(page, theme, level):
    """Pictures of a level before its serve: the desktop's, and the page's of its two lists, as arrays."""
    game = new_game((level,), 1, Ruleset())
    scene = scene_at(still(game), 1.0, NOTHING)._replace(aim=None, balls=())
    canvas = canvas_of(scene, SIZE, theme=theme, camera=camera_of(FLAT, scene, SIZE))
    return both_pictures(page, canvas, scene)


@pytest.mark.parametrize("number", [0, 4, 15], ids=["plain", "stacks", "crowded"])
@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_arena_from_above_is_the_desktops(page, theme, number):
    """Ground, rim, track, bricks with their light and shadows, and paddles."""
    apart = np.abs(np.subtract(*from_above(page, theme, campaign()[number])))
    assert apart.mean() < RESTING[0]
    assert apart.max() < RESTING[1]


@pytest.mark.usefixtures("other_description")
def test_both_painters_follow_a_change_of_the_description(page, monkeypatch):
    """With other widths, strengths and colours both pictures are others, and still agree."""
    level = campaign()[4]
    desktop, on_page = from_above(page, DARK, level)
    assert np.abs(desktop - on_page).mean() < RESTING[0]
    monkeypatch.undo()
    for function in DESCRIPTIONS:
        function.cache_clear()
    before = from_above(page, DARK, level)
    assert np.abs(desktop - before[0]).mean() > 1.0
    assert np.abs(on_page - before[1]).mean() > 1.0


def in_3d(page, theme, level, seed=5):
    """A level's first moment in 3D, its highest stacks falling and a brick bursting: the desktop's picture and the page's."""
    scene = scene_at(still(new_game((level,), 1, Ruleset())), 1.0, NOTHING)._replace(aim=None)
    tall = [k for k, layers in enumerate(scene.tallest) if layers > 1]
    view = SOLID._replace(azimuth=0.7)
    scene = scene._replace(
        falling=tuple([FallingStack(k, 0, 0.6, 0.0) for k in tall]),
        bursts=(Burst(Matter.BRICK, BurstOrigin(7.0, 0.2, -0.8, 0.1), 1j, 2, seed, 20),),
    )
    canvas = canvas_of(scene, SIZE, view, theme=theme)
    return both_pictures(page, canvas, scene)


@pytest.mark.parametrize("number", [0, 4, 15], ids=["plain", "stacks", "crowded"])
@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
def test_the_arena_in_3d_is_the_desktops(page, theme, number):
    """Blocks with their shades and shadows, stacks that fall, and all pieces of a burst."""
    apart = np.abs(np.subtract(*in_3d(page, theme, campaign()[number])))
    assert apart.mean() < IN_3D[0]
    assert apart.max() < IN_3D[1]


def test_both_painters_follow_a_change_of_the_prisms_and_pieces(page, monkeypatch):
    """With other heights, shades, shadows and numbers of pieces both pictures are others, and still agree."""
    before = in_3d(page, DARK, campaign()[4])
    monkeypatch.setattr(rings, "LAYER_HEIGHT", 0.07)
    monkeypatch.setattr(light, "SHADOW_SLANT", 1.4)
    monkeypatch.setattr(light, "_BRIGHTEST", 0.55)
    monkeypatch.setitem(NUMBERS_OF_PIECES, Matter.BRICK, 40)
    desktop, on_page = in_3d(page, DARK, campaign()[4], seed=6)  # another one, as the pieces of a burst are cached
    assert np.abs(desktop - on_page).mean() < IN_3D[0]
    assert np.abs(desktop - before[0]).mean() > 1.0
    assert np.abs(on_page - before[1]).mean() > 1.0


def counted(page, picture):
    """The pixels that the page paints for a list on a canvas of 400 by 400."""
    return page.tab.evaluate(COUNT, [picture.numbers.tolist(), 400, 400])


def test_a_shadow_is_what_a_foot_passes_over_and_none_is_darker_for_lying_in_two(page):
    """A square of side 1 moved by (2, 1) sweeps its area and those of its two leading sides; without the end, one less."""
    camera, picture = Camera(200 + 200j, 40.0), DisplayList()
    picture.camera(camera, 1 + 0j, (0.4, 0.8), 1.0 + 0.5j)
    picture.slot(0.0)
    for foot in (SQUARE, [corner - 3.0 for corner in SQUARE], SQUARE):
        picture.shadows(foot, [(0.0, 0.0, 2.0)], 0.5)
    alphas, _colours = counted(page, picture)
    assert alphas.keys() <= {str(alpha) for alpha in range(129)}
    assert alphas["128"] == pytest.approx(2.0 * (1.0 + 2.0 + 1.0) * camera.scale**2, rel=0.05)
    picture = DisplayList()
    picture.camera(camera, 1 + 0j, (0.4, 0.8), 1.0 + 0.5j)
    picture.slot(0.0)
    picture.shadows(SQUARE, [(0.0, 0.0, 2.0)], 0.5, ends=1)
    alphas, _colours = counted(page, picture)
    assert alphas["128"] == pytest.approx((1.0 + 2.0) * camera.scale**2, rel=0.05)


@pytest.mark.parametrize(("light", "share"), [(1j, 0.4), (-1j, 0.8)], ids=["away from the light", "towards it"])
def test_a_prism_is_projected_as_by_the_camera_and_its_sides_are_shaded_by_the_light(page, light, share):
    """A cube seen from the side and above: its top, and the one side that faces the eye, in the colour's shade."""
    camera, picture = Camera(200 + 200j, 100.0, tilt=math.radians(60.0)), DisplayList()
    picture.camera(camera, light, (0.4, 0.8), 0j)
    picture.slot(math.pi / 2.0)
    picture.prism(SQUARE, 0.0, 1.0, (200, 100, 50))
    _alphas, colours = counted(page, picture)
    size = camera.scale**2
    side = ",".join([str(round(part * share)) for part in (200, 100, 50)])
    assert colours["200,100,50"] == pytest.approx(size * math.cos(camera.tilt), rel=0.03)
    assert colours[side] == pytest.approx(size * math.sin(camera.tilt), rel=0.03)


@pytest.mark.parametrize("skin", BALLS)
@pytest.mark.parametrize("view", [FLAT, SOLID], ids=["flat", "solid"])
def test_balls_have_the_desktops_skins(page, view, skin):
    """A disc filled with a texture looks like the desktop's ball, which is shaded pixel by pixel, far away and near.

    Edges may differ: the desktop uses one picture for positions and radii within a quarter of a pixel.
    """
    game = new_game(classic(), 1, Ruleset())
    scene = scene_at(still(game), 1.0, NOTHING)._replace(balls=(Ball(-3.0 + 2.0j, 1j, 0.6), Ball(3.0 - 4.0j, 1j, 0.6)))
    canvas = canvas_of(scene, SIZE, camera=camera_of(view, scene, SIZE))._replace(ball=skin)
    canvas.surface.fill(DARK.ground)
    BallPictures().draw(canvas, scene)
    picture = DisplayList()
    texture = BallTextures().texture(picture, canvas.camera, DARK, skin)
    for ball in scene.balls:
        add_ball(picture, ball, canvas.camera, texture)
    apart = np.abs(blocks(canvas.surface) - painted_by_page(page, picture.numbers, DARK.ground))
    assert apart.max() < 30.0
    assert apart.sum() < 0.1 * np.abs(blocks(canvas.surface) - DARK.ground).sum()
