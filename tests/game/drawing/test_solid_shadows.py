"""The solid view: shadows lie where the light is kept out."""

import itertools
import math
import os
from collections import Counter

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.drawing.painter import Painter
from game.drawing.palette import DARK
from game.effects import NOTHING, Effects
from game.effects.falling import FallingStack
from game.input.view import SOLID
from game.levels import campaign
from game.picture.slots.contents import ContentKind, SlotContent
from game.picture.solid.rings import ring_prisms
from game.rules import new_game
from game.scene import scene_at, still
from tests.support.games.autopilot_games import game_after
from tests.support.oracles.lines_of_sight import first_met, in_shadow, sight
from tests.support.pictures import PLAIN_DARK, TIPPED, camera_of, canvas_of, painted, solid_ring

SIZE = (480, 360)


@pytest.mark.parametrize("level", [0, 3, 4, 5, 6])
def test_shadows_lie_where_the_light_is_kept_out(level):
    """The ground is dark exactly where something is between it and the light, falling stacks included."""
    base = scene_at(game_after(level, 1800)[0], 0.4, Effects())
    falling = tuple([FallingStack(1, slot, 1.2, 0.0) for slot in range(0, base.rings[1].count, 2) if base.layers[1][slot] > 0])
    scene = base._replace(aim=None, trails=(), flashes=(), pops=(), balls=(), falling=falling)
    bright, chance = DARK.ground, np.random.default_rng(level)
    dark = tuple(int(channel * (1.0 - DARK.shadow)) for channel in bright)
    wrong, checked = 0, Counter()
    for view in TIPPED[:12]:
        camera = camera_of(view, scene, (900, 700))
        surface = painted(scene, camera, (900, 700))
        for _ in range(300):
            spot = chance.random() * 6.5 * complex(np.exp(1j * chance.random() * math.tau))
            x, y = (math.floor(part) for part in (camera.project(spot).real, camera.project(spot).imag))
            around = {tuple(surface.get_at((x + i, y + j)))[:3] for i in (-1, 0, 1) for j in (-1, 0, 1)}
            if max(abs(one - other) for colour in around for one, other in zip(colour, bright, strict=True)) == 0:
                drawn = False
            elif max(abs(one - other) for colour in around for one, other in zip(colour, dark, strict=True)) <= 1:
                drawn = True
            else:
                continue
            checked[drawn] += 1
            wrong += drawn != in_shadow(scene, camera.unproject(complex(x + 0.5, y + 0.5)), camera.tilt)
    assert checked[False] > 200
    assert checked[True] > 10
    assert wrong <= 0.01 * checked.total()


@pytest.mark.parametrize("azimuth", [0.0, 2.0])
def test_a_wide_paddle_has_its_whole_shadow(azimuth):
    """The ground beside a paddle is dark exactly where it keeps out the light, also beside sides that are seen edge-on."""
    base = scene_at(still(new_game((campaign()[6],), 1)), 1.0, NOTHING)._replace(aim=None, balls=())
    scene = base._replace(layers=(base.layers[0], *[(0,) * ring.count for ring in base.rings[1:]]))
    camera = camera_of(SOLID._replace(azimuth=azimuth), scene, (900, 700))
    pictures = []
    for theme in (PLAIN_DARK, PLAIN_DARK._replace(shadow=0.0)):
        canvas = canvas_of(scene, (900, 700), theme=theme, camera=camera)
        Painter().paint(canvas, scene)
        pictures.append(pygame.surfarray.array3d(canvas.surface).astype(float).sum(axis=2))
    share, checked, wrong = pictures[0] / np.maximum(pictures[1], 1.0), Counter(), 0
    for beyond, angle in itertools.product((0.03, 0.07, 0.11, 0.15, 0.19), np.linspace(0.0, math.tau, 360)):
        pixel = camera.project((scene.rings[0].outer_radius + beyond) * complex(math.cos(angle), math.sin(angle)))
        x, y = math.floor(pixel.real), math.floor(pixel.imag)
        spot = complex(x + 0.5, y + 0.5)
        around = share[x - 1 : x + 2, y - 1 : y + 2]
        if around.max() - around.min() < 0.05:  # no edge
            dark = bool(share[x, y] < 0.8)
            checked[dark] += 1
            differs = dark != in_shadow(scene, camera.unproject(spot), camera.tilt)
            wrong += differs and first_met(scene, *sight(camera, spot)) is None
    assert min(checked[True], checked[False]) > 40
    assert wrong <= 2


@pytest.mark.parametrize("gap", [0.1, 0.2])
def test_no_light_falls_between_close_slots(gap):
    """Ends that are closer than 0.15 cast no shadow: the neighbour that is as high does, over the gap; higher ends cast one."""
    half_angle = math.pi / 20.0 - gap / 6.0
    alike = solid_ring(half_angle, 20, SlotContent(ContentKind.BRICKS, 1))
    high = SlotContent(ContentKind.BRICKS, 2)
    ring = ring_prisms(alike._replace(contents=(alike.contents[0], high, *alike.contents[2:])))
    first, second = ring.shadows[:2]
    assert (first.ends, second.ends) == ((0, 3) if gap < 0.15 else (3, 3))
    beside = [corner * np.exp(1j * math.tau / 20.0) for corner in (first.outline[0], first.outline[-1])]
    middle = len(first.outline) // 2
    reach = first.casting[middle - 1 : middle + 1]
    assert np.allclose(reach, beside if gap < 0.15 else first.outline[middle - 1 : middle + 1])
