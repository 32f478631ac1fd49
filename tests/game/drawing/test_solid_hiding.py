"""The solid view: what stands in front hides what is behind, from every angle."""

import math
import os
from collections import Counter

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.drawing.camera import layout
from game.drawing.solid import arena_blocks, faces
from game.drawing.solid.ball_occlusion import occluding_quads
from game.drawing.solid.blocks import ring_blocks
from game.drawing.solid.picture import SolidPicture
from game.effects import Effects
from game.input.view import Viewpoint
from game.picture.slots.contents import ContentKind, SlotContent, slot_contents
from game.picture.slots.parts import Slab, height
from game.picture.solid import prisms
from game.picture.solid.order import back_to_front
from game.picture.solid.rings import ring_prisms
from game.scene import scene_at
from physics import Ball, Ring, contact
from tests.support.games.autopilot_games import game_after
from tests.support.oracles.lines_of_sight import first_met, sight
from tests.support.pictures import TIPPED, camera_of, canvas_of, painted, solid_ring

SIZE = (480, 360)


@pytest.fixture
def plain(monkeypatch):
    """Every ring in a colour of its own, without terraces, marks or light."""

    def one_slab(content, shape, _drop, _theme):
        layers = height(content)
        return (Slab(0.0, layers, 0.0, (round(shape.radius * 25.0), 0, 200)),) if layers else ()

    monkeypatch.setattr(prisms, "parts", one_slab)
    monkeypatch.setattr(faces, "_light", lambda facing, _shares: np.ones(len(facing)))
    prisms.slot_prisms.cache_clear()
    yield
    prisms.slot_prisms.cache_clear()


def free_ball(scene, chance):
    """A ball where it has room between what stands in the arena."""
    while True:
        position = (0.3 + 8.2 * chance.random()) * complex(np.exp(1j * chance.random() * math.tau))
        ball = Ball(position, 1 + 0j, 0.25)
        near = [
            contact(ball, ring, slot).gap
            for ring, layers in zip(scene.rings, scene.layers, strict=True)
            for slot, count in enumerate(layers)
            if count
        ]
        if min(near) > 0.0:
            return ball


def drawn_at(surface, scene, x, y):
    """What a pixel shows, as `first_met` names it; "edge" where its neighbours are of another colour."""
    around = [tuple(surface.get_at((x + i, y + j)))[:3] for i in (-1, 0, 1) for j in (-1, 0, 1)]
    if min(min(colour) for colour in around) > 90:
        return "ball"
    if any(colour != around[0] for colour in around):
        return "edge"
    red, green, blue = around[0]
    if (green, blue) != (0, 200):
        return None
    return next(k for k, ring in enumerate(scene.rings) if red == round(ring.radius * 25.0))


@pytest.mark.usefixtures("plain")
@pytest.mark.parametrize("level", [0, 3, 4, 5, 6])
def test_what_is_in_front_is_drawn_in_front(level):
    """At thousands of pixels from twenty angles, what is drawn is what a line of sight meets first, the ball included."""
    base = scene_at(game_after(level, 1800)[0], 0.4, Effects())._replace(aim=None, trails=(), flashes=(), pops=())
    chance = np.random.default_rng(level)
    wrong, checked = [], Counter()
    for view in TIPPED:
        scene = base._replace(balls=(free_ball(base, chance),))
        camera = camera_of(view, scene, SIZE)
        surface = painted(scene, camera, SIZE)
        spots = [scene.balls[0].position + 0.2 * complex(*chance.normal(size=2)) for _ in range(12)]
        rings = [scene.rings[int(chance.integers(0, len(scene.rings)))].radius for _ in range(50)]
        spots += [radius * complex(np.exp(1j * chance.random() * math.tau)) for radius in rings]
        for spot in spots:
            pixel = camera.project(spot, float(chance.random()) * 1.2)
            x, y = math.floor(pixel.real), math.floor(pixel.imag)
            if not (2 <= x < SIZE[0] - 2 and 2 <= y < SIZE[1] - 2):
                continue
            drawn = drawn_at(surface, scene, x, y)
            met = first_met(scene, *sight(camera, complex(x + 0.5, y + 0.5)))
            checked[drawn if isinstance(drawn, str) else "ground" if drawn is None else "block"] += 1
            if drawn not in {"edge", met}:
                wrong.append((view, (x, y), drawn, met))
    assert min(checked["block"], checked["ground"]) > 150
    assert checked["ball"] > 20
    assert not wrong


def mask_of(quadrilaterals):
    """The pixels that some cover."""
    surface = pygame.Surface(SIZE, 0, 32)
    for corners in np.floor(quadrilaterals.view(np.float64)).reshape(-1, 4, 2).tolist():
        pygame.draw.polygon(surface, (255, 255, 255), corners)
    return pygame.surfarray.array3d(surface)[:, :, 0] > 0


@pytest.mark.parametrize("level", [3, 6])
def test_what_is_far_on_the_screen_hides_no_ball(level):
    """Around a ball, the blocks near it cover the same pixels as all blocks do."""
    base = scene_at(game_after(level, 900)[0], 0.4, Effects())._replace(trails=(), flashes=(), falling=(), recoils=())
    chance = np.random.default_rng(level)
    x, y = np.mgrid[: SIZE[0], : SIZE[1]] + 0.5
    hidden = 0
    for view in TIPPED:
        camera = camera_of(view, base, SIZE)
        canvas = canvas_of(base, SIZE, camera=camera)
        blocks = SolidPicture().draw_blocks(canvas, base, slot_contents(base))
        for _ in range(4):
            ball = free_ball(base, chance)
            pixel, reach = camera.project(ball.position, ball.radius), 8.0
            near, every = (mask_of(occluding_quads(blocks, camera, ball.position, pixel, wide)) for wide in (reach, 1e6))
            around = np.hypot(x - pixel.real, y - pixel.imag) < reach - 1.5
            assert np.array_equal(near[around], every[around])
            hidden += every[around].any()
    assert hidden > 10


@pytest.mark.parametrize("content", [SlotContent(ContentKind.STEEL), SlotContent(ContentKind.BRICKS, 4)])
@pytest.mark.parametrize("tilt", [0.2, 0.9, 1.3])
def test_what_is_painted_on_a_top_comes_after_it(content, tilt):
    """From every side bars and dots are drawn later than all pieces of the top that they lie on, however wide the slot."""
    solid, ring = solid_ring(0.6, 4, content), Ring(3.0, 0.4, 0.6, 4, 0.0, 0.0)
    prisms = ring_prisms(solid)
    joined = arena_blocks._joined([ring_blocks(prisms)], [4 * solid.division.wedges])
    every, wedges = joined.blocks, solid.division.wedges
    flat = [prism for stands in prisms.slots for prism in stands.prisms]
    marks = np.array([prism.wedges is not None for prism in flat])[every.prism]
    assert wedges > 2
    assert marks.sum() >= 16
    for azimuth in np.linspace(0.0, math.tau, 61):
        camera = Viewpoint(1.0, 1.0, float(azimuth), tilt).seen(layout(SIZE, 10.0)).camera
        rank = np.argsort(arena_blocks._order(joined, back_to_front([ring], [wedges], camera), [wedges]))
        for mark in np.flatnonzero(marks):
            under = (every.slot == every.slot[mark]) & ~marks
            under &= (every.wedges[:, 0] >= every.wedges[mark, 0]) & (every.wedges[:, 1] <= every.wedges[mark, 1])
            assert under.any()
            assert rank[mark] > rank[under].max()
