"""Pieces of a burst: where they fly, and what hides them."""

import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game.autopilot import Autopilot
from game.drawing import debris as debris_picture
from game.drawing.camera import layout
from game.drawing.palette import DARK, layer_colour
from game.drawing.solid.debris_occlusion import covered
from game.effects import Effects
from game.effects.bursts import Burst, Matter, Place, lasting
from game.effects.debris import THROWS, pieces
from game.input.view import FROM_ABOVE, TIPPED, Viewpoint
from game.levels import built_in
from game.rules import new_game, tick
from game.scene import scene_at, still

RADIUS = 10.0
SECTOR = Place(4.0, 0.2, 1.0, 0.1)
MATTERS = pytest.mark.parametrize("matter", Matter)


def burst(matter=Matter.BRICK, age=0, seed=77, place=SECTOR, way=1j):
    """One burst."""
    return Burst(matter, place, way, 2, seed, age)


def scene_of(level, ticks=0):
    """A level, played for a while."""
    game, pilot = new_game(built_in()[level:], 3), Autopilot()
    done = still(game)
    for _ in range(ticks):
        done = tick(done.game, pilot.controls(done.game))
    return scene_at(done, 1.0, Effects())


def camera_of(view, scene, size=(480, 360)):
    """The camera of a view."""
    return view.seen(layout(size, scene.ground_radius)).camera


@MATTERS
def test_pieces_begin_where_the_burst_is_and_end_too_small_to_see(matter):
    """All of them in the burst's sector; none left at its end; never below the ground in between."""
    new = pieces([burst(matter)], RADIUS)
    assert len(new.place) == THROWS[matter].number
    assert np.all(np.abs(np.abs(new.place) - 4.0) <= 0.2 + 1e-12)
    assert np.all(np.abs(np.angle(new.place) - 1.0) <= 0.1 + 1e-12)
    assert np.all(new.size > 0.0)
    for age in range(0, lasting(matter), 3):
        flying = pieces([burst(matter, age)], RADIUS)
        assert np.all(flying.height >= 0.0)
        assert np.all(np.abs(flying.place - new.place) < RADIUS / 2.0)
    assert np.all(pieces([burst(matter, lasting(matter))], RADIUS).size < 1e-12)


@MATTERS
def test_pieces_go_up_come_down_and_bounce(matter):
    """Their middle height rises at first; each is on the ground once, and above it again, lower, if there is time."""
    heights = np.array([pieces([burst(matter, age)], RADIUS).height for age in range(400)])
    assert heights[8].mean() > heights[0].mean()
    for piece in heights.T:
        peak = int(np.argmax(piece))
        landed = peak + int(np.argmax(np.diff(piece[peak:]) > 0.0))
        assert landed > peak
        assert piece[landed] < 0.1 * RADIUS * 0.01 * 30.0
        assert piece[landed:].max() < 0.25 * piece[peak]
    assert heights[-1].max() < 1e-9


@MATTERS
def test_pieces_fall_as_stones_do(matter):
    """In the air every height is a parabola, bent downwards by the same gravity for all."""
    heights = np.array([pieces([burst(matter, age)], RADIUS).height for age in range(30)])
    bend = np.diff(heights, 2, axis=0)[np.all([heights[k : 28 + k] > 0.0 for k in range(3)], axis=0)]
    falling = bend[bend < 0.0]
    assert len(falling) > 100
    assert np.allclose(np.median(falling), -1.5 * RADIUS / 240.0**2)
    assert np.isclose(falling, np.median(falling)).mean() > 0.95


def test_the_way_leads():
    """Pieces go along their burst's way on the average."""
    for way in (1.0, 1j, -1.0, (1.0 + 1j) / math.sqrt(2.0)):
        start, later = (pieces([burst(Matter.STEEL, age, way=way, seed=seed) for seed in range(20)], RADIUS) for age in (0, 40))
        mean = np.mean(later.place - start.place)
        assert (mean * np.conj(way)).real > 4.0 * abs((mean * np.conj(way)).imag)


def test_the_same_burst_always_scatters_alike():
    """And beside other bursts as alone; another seed scatters otherwise."""
    alone = pieces([burst(age=30)], RADIUS)
    beside = pieces([burst(Matter.BALL, 5, 3), burst(age=30)], RADIUS)
    count = THROWS[Matter.BRICK].number
    mine = beside.burst == 1
    assert mine.sum() == count
    other = pieces([burst(age=30, seed=78)], RADIUS)
    assert not np.allclose(other.place, alone.place)
    again = pieces([burst(age=30)], RADIUS)
    assert all(np.array_equal(one, two) for one, two in zip(alone, again, strict=True))
    assert np.allclose(beside.place[mine], alone.place)


def test_chances_are_spread_evenly():
    """Over many seeds, sizes and turns have the middle they should."""
    many = pieces([burst(seed=seed) for seed in range(400)], RADIUS)
    assert abs(np.mean(many.turn)) < 0.1
    assert np.mean(many.shape) == pytest.approx(0.5, abs=0.02)
    assert np.std(many.shape) == pytest.approx(1.0 / math.sqrt(12.0), abs=0.02)


@pytest.mark.parametrize("level", [2, 4, 6])
def test_what_hides_a_point_is_found_as_by_marching(level):
    """Along a thousand finer steps towards the eye: the same answer, but for a few that graze a corner."""
    scene = scene_of(level, 900)
    chance = np.random.default_rng(level)
    points = np.sqrt(chance.random(300)) * 9.0 * np.exp(1j * chance.random(300) * math.tau)
    heights = chance.random(300) * 1.5
    for view in (TIPPED, Viewpoint(1.0, 1.0, 2.0, 1.2), Viewpoint(1.0, 0.5, -1.0, 0.9)):
        camera = camera_of(view, scene)
        found = covered(points, heights, scene, camera)
        marched = np.array([blocked(scene, camera, point, height) for point, height in zip(points, heights, strict=True)])
        assert (found == marched).mean() > 0.95
        assert 0.03 < marched.mean() < 0.9


def test_a_gap_hides_nothing():
    """On the paddles' track a place within a paddle is hidden, one in the middle between two is not."""
    scene = scene_of(0)
    paddles, pitch = scene.rings[0], math.tau / scene.rings[0].count
    within = paddles.radius * np.exp(1j * (paddles.phase + pitch * np.arange(paddles.count)))
    between = within * np.exp(0.5j * pitch)
    found = covered(np.concatenate([within, between]), np.zeros(2 * paddles.count), scene, camera_of(TIPPED, scene))
    assert found.tolist() == [True] * paddles.count + [False] * paddles.count


def blocked(scene, camera, point, height):
    """Whether a line from a point to the eye passes through a brick, by many small steps."""
    foot = -1j * math.sin(camera.tilt) / camera.turning / camera.closeness
    high = math.cos(camera.tilt) / camera.closeness
    share = np.linspace(0.0, 1.0, 4000)
    places, levels = point + (foot - point) * share, height + (high - height) * share
    for ring, layers in zip(scene.rings, scene.layers, strict=True):
        tall = np.array([1.0 if count < 0 else float(count) for count in layers]) * 0.045 * scene.ground_radius
        turns = (np.angle(places) - ring.phase) / (math.tau / ring.count)
        slot = np.rint(turns).astype(int)
        inside = (np.abs(np.abs(places) - ring.radius) < ring.half_width) & (
            np.abs(turns - slot) * math.tau / ring.count < ring.half_angle
        )
        if np.any(inside & (tall[slot % ring.count] > levels)):
            return True
    return False


@pytest.mark.parametrize("view", [FROM_ABOVE, TIPPED], ids=["flat", "tipped"])
def test_shards_have_the_colour_of_their_layer(view):
    """On an empty surface every pixel that changes is a shade of it, or of it and white light."""
    scene = scene_of(0)._replace(layers=tuple([(0,) * len(ring) for ring in scene_of(0).layers]))
    surface = pygame.Surface((480, 360), 0, 32)
    surface.fill(DARK.ground)
    debris_picture.draw(surface, [burst(age=20)], scene, camera_of(view, scene), DARK)
    pixels = pygame.surfarray.array3d(surface).reshape(-1, 3).astype(float)
    drawn = pixels[np.abs(pixels - DARK.ground).max(axis=1) > 60]
    assert len(drawn) > 30
    own = np.array(layer_colour(DARK, 2), dtype=float)
    assert np.all(drawn[:, 2] > drawn[:, 1] - 2.0), "violet or whiter"
    assert np.min(np.abs(drawn - own).max(axis=1)) < 60


def test_nothing_to_draw_draws_nothing():
    """No bursts, or bursts behind a wall."""
    scene = scene_of(4)
    camera = camera_of(TIPPED, scene)
    surface = pygame.Surface((480, 360), 0, 32)
    debris_picture.draw(surface, [], scene, camera, DARK)
    tower = scene.rings[1]
    inside = Place(tower.radius, 0.0, tower.angle(0), 0.0)
    debris_picture.draw(surface, [burst(place=inside, way=0j)], scene, camera, DARK)
    assert not pygame.surfarray.array3d(surface).any()
