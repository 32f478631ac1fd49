"""The solid view: what stands in front hides what is behind, from every angle, and tipping changes nothing else."""

import itertools
import math
import os
from collections import Counter

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.light import LIGHT, SHADOW_SLANT
from game.drawing.painter import Painter
from game.drawing.palette import DARK, layer_colour
from game.drawing.solid import arena_blocks, faces
from game.drawing.solid.ball_occlusion import occluding_quads
from game.drawing.solid.blocks import ring_blocks
from game.drawing.solid.picture import SolidPicture
from game.effects import NOTHING, Effects, after
from game.effects.falling import FallingStack
from game.input.view import FLAT, SOLID, Viewpoint
from game.levels import campaign, classic
from game.picture.slots.contents import ContentKind, SlotContent, resting_contents, slot_contents
from game.picture.slots.parts import LAYER_HEIGHT, Slab, SlotShape, height
from game.picture.solid import prisms
from game.picture.solid.order import back_to_front
from game.picture.solid.prisms import slot_division
from game.picture.solid.rings import RingLook, ring_prisms
from game.replays.state_hash import state_hash
from game.rules import new_game, tick
from game.scene import scene_at, still
from game.screenshot import save_screenshot
from physics import Ball, Ring, contact
from tests.support.games.autopilot_games import game_after
from tests.support.paths import REFERENCE
from tests.support.pictures import PLAIN_DARK, camera_of, canvas_of

SIZE = (480, 360)
HIGHEST = 0.45 * 8
"""World units: as high as the highest stack."""
STEP = 7.5e-5
"""Of a line of sight, as a part of its length: how finely it is marched along."""


def seen_from(view, scene, size=SIZE):
    """The camera of a view."""
    return camera_of(view, scene, size)


def painted(scene, camera, size=SIZE):
    """A scene on a new surface."""
    canvas = canvas_of(scene, size, camera=camera)
    Painter().paint(canvas, scene)
    return canvas.surface


def first_met(scene, eye, ray, reach):
    """What a line of sight meets first: a ring's number, "ball", or None for the ground.

    Found by marching along the line: no order, no projection, no polygons.
    """
    steps = np.arange(*reach, STEP * reach[1])
    x, y, z = (eye[k] + ray[k] * steps for k in range(3))
    radius, angle = np.hypot(x, y), np.arctan2(y, x)
    best, found, standing = math.inf, None, standing_heights(scene)
    for k, ring in enumerate(scene.rings):
        near = np.flatnonzero(np.abs(radius - ring.radius) < ring.half_width)
        slot, off = slots_at(ring, angle[near])
        top = standing[k][slot]
        inside = near[(np.abs(off) < ring.half_angle) & (z[near] < top) & (top > 0.0)]
        if len(inside) and steps[inside[0]] < best:
            best, found = steps[inside[0]], k
    for ball in scene.balls:
        inside = np.sqrt((x - ball.position.real) ** 2 + (y - ball.position.imag) ** 2 + (z - ball.radius) ** 2) < ball.radius
        if inside.any() and steps[inside.argmax()] < best:
            best, found = steps[inside.argmax()], "ball"
    return found


def slots_at(ring, angle):
    """The nearest slots to some angles, and how far from their middles these are."""
    pitch = math.tau / ring.count
    slot = np.rint((angle - ring.phase) / pitch).astype(int) % ring.count
    return slot, (angle - ring.phase - slot * pitch + math.pi) % math.tau - math.pi


def standing_heights(scene):
    """Heights of what stands in the slots of each ring, world units."""
    unit = LAYER_HEIGHT * scene.ground_radius
    return [np.array([height(content) * unit for content in ring]) for ring in resting_contents(scene.layers)]


def sight(camera, pixel):
    """The line of sight through a pixel: the eye, its unit direction, and the part of it low enough for things to be there."""
    ground = camera.unproject(pixel)
    bearing = camera.azimuth - math.pi / 2.0
    towards = np.array(
        [math.cos(bearing) * math.sin(camera.tilt), math.sin(bearing) * math.sin(camera.tilt), math.cos(camera.tilt)]
    )
    eye = towards / camera.closeness
    ray = np.array([ground.real, ground.imag, 0.0]) - eye
    length = float(np.linalg.norm(ray))
    return eye, ray / length, ((1.0 - HIGHEST / eye[2]) * length, length)


VIEWS = [
    Viewpoint(1.0, 1.0, azimuth, math.radians(tilt))
    for azimuth, tilt in itertools.product((0.0, 0.9, 2.2, -2.7, -1.1), (15.0, 45.0, 62.0, 76.0))
]


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
    for view in VIEWS:
        scene = base._replace(balls=(free_ball(base, chance),))
        camera = seen_from(view, scene)
        surface = painted(scene, camera)
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
    for view in VIEWS:
        camera = seen_from(view, base)
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


def in_shadow(scene, spot, tilt):
    """Whether something is between a point of the ground and the light. Found by marching up the light."""
    standing = standing_heights(scene)
    z, lifted = np.linspace(0.0, 3.0, 3000), {(drop.ring, drop.slot): 0.45 * drop.height for drop in scene.falling}
    ray = spot + LIGHT * SHADOW_SLANT * math.sin(tilt) * z
    radius, angle = np.abs(ray), np.angle(ray)
    for k, ring in enumerate(scene.rings):
        near = np.flatnonzero(np.abs(radius - ring.radius) < ring.half_width)
        slot, off = slots_at(ring, angle[near])
        top = standing[k][slot]
        foot = np.array([lifted.get((k, number), 0.0) for number in range(ring.count)])[slot]
        if ((np.abs(off) < ring.half_angle) & (z[near] > foot) & (z[near] < foot + top)).any():
            return True
    return False


@pytest.mark.parametrize("level", [0, 3, 4, 5, 6])
def test_shadows_lie_where_the_light_is_kept_out(level):
    """The ground is dark exactly where something is between it and the light, falling stacks included."""
    base = scene_at(game_after(level, 1800)[0], 0.4, Effects())
    falling = tuple([FallingStack(1, slot, 1.2, 0.0) for slot in range(0, base.rings[1].count, 2) if base.layers[1][slot] > 0])
    scene = base._replace(aim=None, trails=(), flashes=(), pops=(), balls=(), falling=falling)
    bright, chance = DARK.ground, np.random.default_rng(level)
    dark = tuple(int(channel * (1.0 - DARK.shadow)) for channel in bright)
    wrong, checked = 0, Counter()
    for view in VIEWS[:12]:
        camera = seen_from(view, scene, (900, 700))
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
    camera = seen_from(SOLID._replace(azimuth=azimuth), scene, (900, 700))
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
    look = look_of(half_angle, 20, SlotContent(ContentKind.BRICKS, 1))
    high = SlotContent(ContentKind.BRICKS, 2)
    ring = ring_prisms(look._replace(contents=(look.contents[0], high, *look.contents[2:])))
    first, second = ring.shadows[:2]
    assert (first.ends, second.ends) == ((0, 3) if gap < 0.15 else (3, 3))
    beside = [corner * np.exp(1j * math.tau / 20.0) for corner in (first.outline[0], first.outline[-1])]
    middle = len(first.outline) // 2
    reach = first.casting[middle - 1 : middle + 1]
    assert np.allclose(reach, beside if gap < 0.15 else first.outline[middle - 1 : middle + 1])


@pytest.mark.parametrize("phase", [0.0, 0.1, 0.23, 0.37])
@pytest.mark.parametrize("size", [(480, 360), (900, 700)])
def test_blocks_cover_as_many_pixels_as_they_should(phase, size):
    """All but upright, what a ring's blocks cover adds up to its sectors' area, to a tenth of a pixel along their edges."""
    base = scene_at(game_after(0, 0)[0], 1.0, Effects())._replace(balls=(), aim=None)
    ring = base.rings[1]._replace(phase=phase)
    scene = base._replace(rings=(base.rings[0], ring), layers=(base.layers[0], (1,) * ring.count))
    camera = seen_from(FLAT, scene, size)._replace(tilt=1e-7)
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
    flat = seen_from(FLAT, scene, size)
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
            painter.paint(canvas_of(scene, (80, 60), VIEWS[number % 20]), scene)
    assert fell > 200
    assert state_hash(game) == state_hash(game_after(4, 1200)[0].game)


@pytest.mark.parametrize(("level", "view"), [(4, SOLID), (6, Viewpoint(1.0, 1.0, 2.2, 1.2)), (5, Viewpoint(1.0, 0.4))])
def test_reference_pictures(level, view):
    """Fewer than 0.1 % of the pixels differ from pictures that somebody has looked at."""
    done, _ = game_after(level, 1500)
    scene = scene_at(done, 0.5, Effects())
    surface = painted(scene, seen_from(view, scene))
    path = REFERENCE / f"3d-level-{level + 1}.png"
    off = np.abs(pygame.surfarray.array3d(surface).astype(int) - pygame.surfarray.array3d(pygame.image.load(path)))
    assert (off.max(axis=2) > 16).mean() < 0.001


def look_of(half_angle, slots, content, widest=0.2):
    """The look of a ring at radius 3. widest: half angle of its widest wedge."""
    shape = SlotShape(3.0, 0.4, half_angle, 4, 0.0)
    division = slot_division(shape, widest, 40.0, 0.0)
    return RingLook((content,) * slots, shape, division, (), 0.45, DARK)


@pytest.mark.parametrize("content", [SlotContent(ContentKind.STEEL), SlotContent(ContentKind.BRICKS, 4)])
@pytest.mark.parametrize("tilt", [0.2, 0.9, 1.3])
def test_what_is_painted_on_a_top_comes_after_it(content, tilt):
    """From every side bars and dots are drawn later than all pieces of the top that they lie on, however wide the slot."""
    look, ring = look_of(0.6, 4, content), Ring(3.0, 0.4, 0.6, 4, 0.0, 0.0)
    prisms = ring_prisms(look)
    joined = arena_blocks._joined([ring_blocks(prisms)], [4 * look.division.wedges])
    every, wedges = joined.blocks, look.division.wedges
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


@pytest.mark.parametrize(("half_angle", "slots"), [(math.pi, 1), (1.2, 2), (0.1, 20)])
def test_feet_cover_the_sectors_and_only_their_ends_are_ends(half_angle, slots):
    """The feet of a ring's blocks have its sectors' area together; a whole ring has no ends, a sector has two."""
    every = ring_blocks(ring_prisms(look_of(half_angle, slots, SlotContent(ContentKind.BRICKS, 1))))
    following = np.roll(every.foot, -1, axis=1)
    area = 0.5 * (every.foot.conjugate() * following).imag.sum()
    assert area == pytest.approx(slots * 2.0 * half_angle * 3.0 * 0.8, rel=0.003)
    assert every.sides[:, 1].sum() == every.sides[:, 3].sum() == (0 if half_angle == math.pi else slots)
    assert every.sides[:, [0, 2]].all()
