"""Effects on the screen: where they should be, in both views, and nothing else changed."""

import cmath
import itertools
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.display_list_painter import DisplayListPainter
from game.drawing.painter import Painter
from game.drawing.palette import DARK
from game.drawing.solid.picture import SolidPicture
from game.effects import ALL, FLASH_TICKS, NOTHING, Flash, Pop, Recoil, Wave, bursts
from game.effects.waves import WAVE_TICKS, WaveTone
from game.input.view import FLAT, SOLID, Viewpoint
from game.levels import classic
from game.picture.display_list import DisplayList
from game.picture.moving.waves import add_waves
from game.picture.moving.words import add_words
from game.picture.primitives import Primitive, primitives
from game.picture.slots.contents import ContentKind, slot_contents, wall_contents
from game.picture.slots.parts import LAYER_HEIGHT, PADDLE_HEIGHT
from game.rules import PADDLES, EventKind, new_game, tick
from game.scene import scene_at
from tests.support.games.autopilot_games import game_after
from tests.support.pictures import canvas_of
from tests.support.windows.dummy_window import shared

SIZE = (900, 700)
VIEWS = pytest.mark.parametrize("view", [FLAT, SOLID], ids=["flat", "tipped"])


def scene_of(level=4, ticks=0):
    """A level, played for a while, without anything that fades."""
    return scene_at(game_after(level, ticks)[0], 1.0, NOTHING)._replace(aim=None, balls=())


def painted(scene, view=FLAT):
    """A scene as an array of colours, and the camera that saw it."""
    canvas = canvas_of(scene, SIZE, view)
    Painter().paint(canvas, scene)
    return pygame.surfarray.array3d(canvas.surface).astype(int), canvas.camera


def at(picture, camera, point, height=0.0):
    """The colour where a point of the world is seen."""
    pixel = camera.project(point, height)
    return tuple(int(channel) for channel in picture[math.floor(pixel.real), math.floor(pixel.imag)])


@VIEWS
def test_a_shaken_picture_is_the_picture_moved(view):
    """The picture moves by whole pixels, upwards where the shake goes upwards; the camera stays as it is."""
    scene = scene_of()
    rest, camera = painted(scene, view)
    reach = scene.ground_radius * camera.scale
    moved, same = painted(scene._replace(shaken=complex(7.2, 4.1) / reach), view)
    assert same == camera
    assert np.array_equal(moved[40:-40, 40:-40], rest[33:-47, 44:-36])


@pytest.mark.parametrize("slot", [0, 1, 2])
def test_a_struck_paddle_is_farther_out_from_above(slot):
    """Beyond its outer face there is paddle, in its slot ground and track; the other paddles are where they were."""
    scene = scene_of()
    ring = scene.rings[PADDLES]
    away = scene._replace(recoils=(Recoil(slot, 1.0, 16),))
    out = away.recoils[0].out
    assert out > 0.3
    rest, camera = painted(scene)
    picture, _ = painted(away)
    middle = cmath.exp(1j * ring.angle(slot))
    for turn in (-0.8, 0.0, 0.8):
        ray = middle * cmath.exp(1j * turn * ring.half_angle)
        assert at(picture, camera, ray * (ring.radius + out)) == DARK.paddle_top
        assert at(picture, camera, ray * (ring.inner_radius + 0.02)) == DARK.ground
        assert at(picture, camera, ray * ring.radius) != DARK.ground
    others = [cmath.exp(1j * ring.angle(other)) * ring.radius for other in range(ring.count) if other != slot]
    assert all(at(picture, camera, point) == at(rest, camera, point) == DARK.paddle_top for point in others)


def test_a_paddle_at_rest_looks_the_same_as_one_whose_recoil_is_over():
    """A paddle that is drawn apart from its ring looks as in the ring, but for a few pixels of its edges."""
    scene = scene_of()
    rest, _ = painted(scene)
    picture, _ = painted(scene._replace(recoils=(Recoil(1, 0.0, 3),)))
    off = np.abs(rest - picture).max(axis=2)
    assert (off > 100).mean() < 0.0005
    assert off.mean() < 0.1


def test_a_struck_paddle_is_farther_out_in_3d():
    """On top of the paddle, farther out by the recoil, is the paddle's colour; without the recoil it is not there."""
    scene = scene_of()
    ring = scene.rings[PADDLES]
    away = scene._replace(recoils=(Recoil(0, 1.0, 16),))
    out = away.recoils[0].out
    rest, camera = painted(scene, SOLID)
    picture, _ = painted(away, SOLID)
    height = PADDLE_HEIGHT * LAYER_HEIGHT * scene.ground_radius
    top = cmath.exp(1j * ring.angle(0)) * (ring.radius + out)
    assert at(picture, camera, top, height) == DARK.paddle_top
    assert at(rest, camera, top, height) != DARK.paddle_top


@VIEWS
@pytest.mark.parametrize("slot", range(3))
def test_a_struck_paddle_lights_up_where_it_was_hit(view, slot):
    """The light is brightest at the hit and fades; the paddle's other half, and the other paddles, look as before."""
    scene = scene_of()
    ring, height = scene.rings[PADDLES], 0.0 if view is FLAT else PADDLE_HEIGHT * LAYER_HEIGHT * scene.ground_radius
    hit = 0.6 * ring.half_angle
    before, camera = painted(scene, view)
    light = []
    for age in (0.0, 0.5, 0.95):
        picture, _ = painted(scene._replace(flashes=(Flash(PADDLES, slot, -1, age, offset=hit),)), view)
        at_hit = cmath.rect(ring.radius, ring.angle(slot) + hit)
        light.append(sum(at(picture, camera, at_hit, height)) - sum(at(before, camera, at_hit, height)))
        for far in (ring.angle(slot) - hit, ring.angle(slot + 1), ring.angle(slot + 2) + hit):
            point = cmath.rect(ring.radius, far)
            assert at(picture, camera, point, height) == at(before, camera, point, height)
    assert light[0] > 150
    assert light[0] > light[1] > light[2] >= 0


def test_words_fade_with_their_plate():
    """A plate exists as long as its words, at their opacity; words without a plate have an outline that fades with them."""
    scene = scene_of()
    view = canvas_of(scene, SIZE, FLAT).view
    for age, plate in itertools.product((0.0, 0.3, 0.7, 0.99), (True, False)):
        out = DisplayList()
        add_words(out, scene._replace(pops=(Pop(2 + 1j, "wide paddles", bad=False, age=age, plate=plate),)), view)
        codes = [(Primitive(code), opacity) for code, _, opacity, _ in primitives(out.numbers)]
        assert [code for code, _ in codes] == ([Primitive.PLATE, Primitive.TEXT] if plate else [Primitive.TEXT] * 5)
        assert len({opacity for _, opacity in codes}) == 1
        assert codes[0][1] == pytest.approx(1.0 if age < 0.5 else (1.0 - age) / 0.4, abs=1e-6)


def test_only_the_struck_paddles_blocks_are_pushed():
    """All corners of its feet go outwards by the same length, so that it keeps its width; everything else stays where it is."""
    scene = scene_of()
    ring, recoil = scene.rings[PADDLES], Recoil(1, 1.0, 16)
    canvas = canvas_of(scene, SIZE, SOLID)
    seen = [
        SolidPicture().draw_blocks(canvas, shown, slot_contents(shown)) for shown in (scene, scene._replace(recoils=(recoil,)))
    ]
    moved, outwards = seen[1].foot - seen[0].foot, seen[0].foot / np.abs(seen[0].foot)
    middle = cmath.rect(ring.radius, ring.angle(1))
    near = np.abs(seen[0].foot / canvas.camera.turning - middle) < 2.0 * ring.half_angle * ring.radius
    struck = (np.abs(moved) > 1e-9).all(axis=1)
    assert struck.any()
    assert near[struck].all()
    assert np.allclose(moved[struck], recoil.out * outwards[struck])
    assert not moved[~struck].any()


def test_light_runs_around_a_ring_both_ways():
    """It is the same on both sides of the broken brick, is farther away with every step, and reaches every slot."""
    layers, slot = (1,) * 24, 5
    reached, farthest = set(), []
    for step in range(6):
        contents = wall_contents(layers, [Flash(1, slot, 0, (step + 0.5) / 6.0, lit=False, echoed=True)])
        glows = [content.glow for content in contents]
        assert [glows[(slot + k) % 24] for k in range(24)] == [glows[(slot - k) % 24] for k in range(24)]
        lit = {k for k, glow in enumerate(glows) if glow}
        reached |= lit
        farthest.append(max(abs((k - slot + 12) % 24 - 12) for k in lit))
    assert farthest == sorted(set(farthest))
    assert reached >= set(range(24)) - {slot}


def test_light_leaves_gaps_dark_and_flashes_alone():
    """Empty slots stay empty, a slot that was hit has its own glow, and without light around the ring no other slot glows."""
    layers = (1, 0, -1, 2, 0, 1)
    for age in (0.1, 0.5, 0.9):
        contents = wall_contents(layers, [Flash(1, 3, 2, age, lit=True, echoed=True)])
        assert [look.kind is ContentKind.EMPTY for look in contents] == [False, True, False, False, True, False]
        plain = wall_contents(layers, [Flash(1, 3, 2, age)])
        assert contents[3] == plain[3]
        assert all(look.glow == 0 for k, look in enumerate(plain) if k != 3)


def draw_waves(canvas, scene):
    """The waves alone."""
    picture = DisplayList()
    add_waves(picture, scene, canvas.view)
    DisplayListPainter().paint(canvas.surface, canvas.type, picture)


@VIEWS
def test_a_wave_is_a_circle_on_the_ground(view):
    """It is drawn at its radius all around and nowhere else; before it begins and after it ends nothing is drawn."""
    scene = scene_of()
    canvas = canvas_of(scene, SIZE, view)
    surface, camera = canvas.surface, canvas.camera
    surface.fill(DARK.ground)
    unseen = Wave(WaveTone.BAD, 2.0, 9.0, -1), Wave(WaveTone.BAD, 2.0, 9.0, WAVE_TICKS)
    draw_waves(canvas, scene._replace(waves=unseen))
    assert len(np.unique(pygame.surfarray.array3d(surface).reshape(-1, 3), axis=0)) == 1
    wave = Wave(WaveTone.BAD, 2.0, 9.0, 30)
    draw_waves(canvas, scene._replace(waves=(wave,)))
    picture = pygame.surfarray.array3d(surface).astype(int)
    for angle in np.arange(0.0, math.tau, 0.37):
        outwards = cmath.exp(1j * angle)
        near = [at(picture, camera, outwards * (wave.radius + off)) for off in (-0.04, 0.0, 0.04)]
        assert any(colour != DARK.ground for colour in near)
        assert (
            at(picture, camera, outwards * (wave.radius + 0.4))
            == at(picture, camera, outwards * (wave.radius - 0.4))
            == DARK.ground
        )


def test_many_bursts_at_once_make_room_for_the_newest():
    """Of fifteen bursts in one tick the last MOST are left."""
    game, pilot, done = new_game(classic()[4:], 3), Autopilot(), None
    while done is None or not any(event.kind == EventKind.BRICK_HIT for event in done.events):
        done = tick(game, pilot.controls(game))
        game = done.game
    (event,) = [event for event in done.events if event.kind == EventKind.BRICK_HIT]
    many = tuple(event._replace(hit=event.hit._replace(slot=slot)) for slot in range(15))
    found = bursts.after_tick((), done._replace(events=many), ALL)
    assert len(found) == bursts.MOST
    alone = [bursts.after_tick((), done._replace(events=(one,)), ALL)[0] for one in many]
    assert list(found) == alone[-bursts.MOST :]


def test_a_glow_lasts_as_long_as_its_flash():
    """The contents of a ring change only when the flash's own glow changes, which is six times."""
    layers = (2,) * 12
    contents = [wall_contents(layers, [Flash(1, 0, 2, age / FLASH_TICKS, lit=True, echoed=True)]) for age in range(FLASH_TICKS)]
    assert 1 + sum(one != other for one, other in itertools.pairwise(contents)) == 6


def test_sounds_come_from_their_place_on_the_screen():
    """A sound is heard where its event is on the screen: seen from behind, left and right are swapped."""

    class Card:
        sides = ()

        def follow(self, _mood):
            """The music is not looked at here."""

        def play(self, events, side, _combo):
            self.sides = [side(event.position) for event in events]

    app = shared()
    app.audio = card = Card()
    game = new_game(classic(), 1)
    done = tick(game, Autopilot().controls(game)._replace(serve=True))
    (event,) = done.events
    placed = done._replace(events=tuple(event._replace(position=position) for position in (6.0 + 0j, -6.0 + 0j, 6j, 10.0 + 0j)))
    flat = layout((1600, 800), 10.0)

    def heard(view):
        app.play_sounds(placed, view.seen(flat).camera)
        return card.sides

    assert heard(FLAT) == pytest.approx([0.6, -0.6, 0.0, 1.0])
    front = heard(Viewpoint(1.0, 1.0))
    behind = heard(Viewpoint(1.0, 1.0, math.pi))
    assert front[0] > 0.4 > -0.4 > front[1]
    assert behind[:2] == pytest.approx([front[1], front[0]])
    aside = heard(Viewpoint(1.0, 1.0, math.pi / 2.0))
    assert abs(aside[0]) < 1e-9
    assert abs(aside[2]) > 0.4
