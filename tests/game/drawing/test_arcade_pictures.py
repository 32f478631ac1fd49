"""What the arcade rules add to the picture can be told apart without colours, and is where the rules say."""

import cmath
import itertools
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import msgspec
import numpy as np
import pygame
import pytest

from game.drawing.arcade.signs import power_colour
from game.drawing.balls.ball import BallPictures
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.painter import Painter
from game.drawing.palette import DARK, LIGHT, contrast
from game.drawing.text import Type
from game.effects import NOTHING
from game.input.view import FLAT, SOLID
from game.level_format.specs import WellSpec
from game.levels import classic
from game.picture.display_list import DisplayList
from game.picture.moving.drops import add_chip
from game.picture.moving.gauges import CHIP_ROOM, ICONS, RADIUS, SPAN
from game.picture.slots.contents import ContentKind, slot_contents
from game.rules import ActivePower, Drop, HeldBall, PowerUp, Ruleset, new_game
from game.rules.drops import DROP_RADIUS
from game.scene import scene_at, still
from game.unlocks import BALLS, TRAILS
from physics import Ball
from tests.support.pictures import canvas_of

SIZE = (900, 700)
THEMES = pytest.mark.parametrize("theme", [DARK, LIGHT], ids=["dark", "light"])
VIEWS = pytest.mark.parametrize("view", [FLAT, SOLID], ids=["flat", "tipped"])


def game_of(level=1, **changes):
    """A game of the arcade rules before its first serve."""
    specs = msgspec.structs.replace(classic()[level - 1], **changes)
    return new_game((specs,), 1, Ruleset())


def scene_of(game, alpha=1.0):
    """A game without effects."""
    return scene_at(still(game), alpha, NOTHING)._replace(aim=None)


def painted(scene, view=FLAT, **looks):
    """A scene as an array of colours, and its camera."""
    canvas = canvas_of(scene, SIZE, view)._replace(**looks)
    Painter().paint(canvas, scene)
    return pygame.surfarray.array3d(canvas.surface).astype(int), canvas.camera


def changed(before, after, camera, point, reach):
    """How many pixels around a point of the world differ. reach: pixels."""
    pixel = camera.project(point)
    columns, rows = np.indices(SIZE) + 0.5
    near = np.hypot(columns - pixel.real, rows - pixel.imag) < reach
    return int((np.abs(before - after).max(axis=2)[near] > 20).sum())


@THEMES
def test_signs_differ_in_shape(theme):
    """In grey, at least 7 % of a chip's pixels tell any two power-ups apart."""
    grey = {}
    for kind in PowerUp:
        icon, picture = pygame.Surface((50, 50), pygame.SRCALPHA), DisplayList()
        add_chip(picture, kind, 25 + 25j, 24.0, theme)
        DisplayListPainter().paint(icon, Type(), picture)
        alpha = pygame.surfarray.array_alpha(icon) > 128
        light = pygame.surfarray.array3d(icon).astype(float).mean(axis=2)
        grey[kind] = np.where(alpha, np.where(light > (light[alpha].min() + light[alpha].max()) / 2.0, 1.0, 0.0), 0.5)
    for one, other in itertools.combinations(PowerUp, 2):
        assert (grey[one] != grey[other]).mean() > 0.07, (one.name, other.name)


@THEMES
def test_chips_stand_out_from_the_ground(theme):
    """Every chip has a contrast of at least 3 to the ground."""
    for kind in PowerUp:
        assert contrast(power_colour(kind, theme), theme.ground) >= 3.0


@VIEWS
def test_a_drop_is_where_the_rules_say(view):
    """Its chip covers the ground around its position at that tick, or before it; tipped, it floats above."""
    game = game_of()
    drop = Drop(PowerUp.WIDE, 5.0 + 3.0j, 2.0 + 0j)
    with_drop = game._replace(drops=(drop,))
    bare, camera = painted(scene_of(game), view)
    picture, _ = painted(scene_of(with_drop), view)
    area = math.pi * (DROP_RADIUS * game.level.ground_radius * camera.scale_at(drop.position)) ** 2
    assert changed(bare, picture, camera, drop.position, 12.0) > 0.3 * area
    assert changed(bare, picture, camera, -drop.position, 12.0) == 0
    (early,) = scene_of(with_drop, 0.0).drops
    assert early.position == pytest.approx(drop.position - drop.velocity / 240.0)


@pytest.mark.parametrize("share", [1.0, 0.6, 0.3])
def test_a_gauge_is_as_long_as_what_is_left(share):
    """The arc beyond the rim has the power-up's colour for the share of its time that is left, and is dim behind."""
    game = game_of()
    power = ActivePower(PowerUp.SLOW, round(1000 * share), 1000)
    picture, camera = painted(scene_of(game._replace(powers=(power,))))
    colour = power_colour(PowerUp.SLOW, DARK)
    begin = ICONS[0] + CHIP_ROOM
    angles = np.linspace(begin + 0.01, begin + SPAN - 0.01, 60)
    pixels = [camera.project(10.0 * RADIUS * cmath.exp(1j * float(angle))) for angle in angles]
    lit = [tuple(picture[math.floor(pixel.real), math.floor(pixel.imag)]) == colour for pixel in pixels]
    assert sum(lit) / len(lit) == pytest.approx(share, abs=0.06)
    assert lit == sorted(lit, reverse=True)


def test_shield_bumpers_and_growing_bricks_have_looks_of_their_own():
    """The shield is shown while there is one; a bumper is no plain steel, and a brick that grows again no plain brick."""
    game = game_of(6)
    assert {content.kind for content in slot_contents(scene_of(game))[-1]} == {ContentKind.EMPTY}
    shielded = game._replace(arena=game.arena._replace(layers=(*game.arena.layers[:-1], (1,))))
    assert {content.kind for content in slot_contents(scene_of(shielded))[-1]} == {ContentKind.SHIELD}
    rings = classic()[5].rings
    bumpers = [rings[0], msgspec.structs.replace(rings[1], bumper=True, layers=-1)]
    assert {content.kind for content in slot_contents(scene_of(game_of(6, rings=bumpers)))[2]} == {ContentKind.BUMPER}
    growing = [rings[0], msgspec.structs.replace(rings[1], layers=1, regrow=4.0)]
    scene = scene_of(game_of(6, rings=growing))
    assert {content.kind for content in slot_contents(scene)[2]} == {ContentKind.GROWING}
    assert scene.core == 1.0


@VIEWS
def test_a_well_is_seen_within_its_reach_alone(view):
    """What pulls and what pushes are drawn around their middles, in two colours, and nowhere beyond their reach."""
    bare, camera = painted(scene_of(game_of()), view)
    colours = []
    for strength in (30.0, -30.0):
        picture, _ = painted(scene_of(game_of(wells=[WellSpec(6.0, strength, 1.5, 0.0)])), view)
        off = np.abs(picture - bare).max(axis=2) > 0
        reach = [abs(camera.unproject(complex(x + 0.5, y + 0.5)) - 6.0) for x, y in np.argwhere(off)[::7]]
        assert max(reach) < 1.5 + 2.0 / camera.scale
        pixel = camera.project(6.0 + 0j)
        colours.append(tuple(picture[math.floor(pixel.real), math.floor(pixel.imag)]))
    assert len({*colours, DARK.ground}) == 3


def test_a_held_ball_has_an_arrow():
    """From a ball that sticks to a paddle an arrow points inward, turned to the side where it sticks."""
    game = game_of()
    for offset in (-0.2, 0.0, 0.2):
        (aim,) = scene_of(game._replace(held=(HeldBall(0, offset, 0.25, 5),))).held_aims
        inward = -aim.origin / abs(aim.origin)
        turn = cmath.phase(aim.direction / inward)
        assert (turn < -1e-6) - (turn > 1e-6) == (offset > 0.0) - (offset < 0.0)


@pytest.mark.parametrize("kind", [PowerUp.PIERCE, PowerUp.FAST, PowerUp.SLOW])
def test_what_acts_on_a_ball_shows_around_it(kind):
    """The mark lies around the ball, and no two are the same in grey."""
    game = game_of()
    ball = Ball(0j, 3.0 + 1.0j, 0.25)
    scene = scene_of(game)._replace(balls=(ball,))
    plain, camera = painted(scene)
    marked = {power: painted(scene._replace(powers=(ActivePower(power, 9, 9),)))[0] for power in (kind, PowerUp.WIDE)}
    assert changed(plain, marked[kind], camera, 0j, 30.0) > 30
    assert changed(plain, marked[PowerUp.WIDE], camera, 0j, 30.0) == 0


def test_every_ball_and_every_trail_can_be_told_from_the_others():
    """No two skins and no two trails are drawn the same."""
    game = game_of()
    ball = Ball(2.0 + 1.0j, 3.0 + 1.0j, 0.25)
    trail = tuple([complex(-0.2 * k, 3.0 - 0.3 * k) for k in range(16)])
    scene = scene_of(game)._replace(balls=(ball,), trails=(trail,))
    balls = {painted(scene, ball=name)[0].tobytes() for name in BALLS}
    trails = {painted(scene, trail=name)[0].tobytes() for name in TRAILS}
    assert (len(balls), len(trails)) == (len(BALLS), len(TRAILS))


def test_skins_are_cached_apart():
    """Balls of two skins drawn by the same pictures keep their own looks."""
    scene = scene_of(game_of())._replace(balls=(Ball(0j, 1 + 0j, 0.25),))
    pictures, seen = BallPictures(), []
    for name in ("pearl", "eclipse", "pearl"):
        canvas = canvas_of(scene, SIZE)._replace(ball=name)
        pictures.draw(canvas, scene)
        seen.append(pygame.image.tobytes(canvas.surface, "RGB"))
    assert seen[0] == seen[2] != seen[1]
