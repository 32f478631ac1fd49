"""Pieces of a burst: where they fly, and what hides them."""

import math
import os
from typing import NamedTuple

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pytest

from game.drawing import debris as debris_picture
from game.drawing.palette import DARK
from game.drawing.piece_look import PLATES, burst_colour, earlier
from game.drawing.solid.debris_occlusion import occluded
from game.effects import NOTHING, debris
from game.effects.bursts import Burst, BurstOrigin, Matter, lifetime
from game.effects.piece_paths import CHANCES, NUMBERS_OF_PIECES, chances
from game.input.view import FLAT, SOLID, Viewpoint
from game.picture.moving.bursts import flying_pieces
from game.picture.primitives import Primitive, primitives, unpacked
from game.picture.slots.contents import resting_contents
from game.picture.slots.parts import LAYER_HEIGHT, height
from game.picture.view import ArenaView
from game.scene import scene_at
from tests.support.games.autopilot_games import game_after
from tests.support.pictures import camera_of

RADIUS = 10.0
SIZE = (480, 360)
SECTOR = BurstOrigin(4.0, 0.2, 1.0, 0.1)
MATTERS = pytest.mark.parametrize("matter", Matter)


def burst(matter=Matter.BRICK, age=0, seed=77, origin=SECTOR, direction=1j):
    """One burst."""
    return Burst(matter, origin, direction, 2, seed, age)


class Pieces(NamedTuple):
    """The pieces of some bursts, as arrays. position: on the ground. Else as in `FlyingPiece`."""

    position: np.ndarray
    height: np.ndarray
    size: np.ndarray
    burst: np.ndarray


def pieces(bursts, ground_radius):
    """All pieces of some bursts."""
    flying, whose = debris.pieces(bursts, ground_radius)
    return Pieces(flying.x + 1j * flying.y, flying.height, flying.size, whose)


def scene_of(level, ticks=0):
    """A level, played for a while."""
    return scene_at(game_after(level, ticks)[0], 1.0, NOTHING)


@MATTERS
def test_pieces_begin_where_the_burst_is_and_end_too_small_to_see(matter):
    """Every piece begins in the burst's sector, stays above the ground and near its start, and has no size at its end."""
    new = pieces([burst(matter)], RADIUS)
    assert len(new.position) == NUMBERS_OF_PIECES[matter]
    assert np.all(np.abs(np.abs(new.position) - 4.0) <= 0.2 + 1e-12)
    assert np.all(np.abs(np.angle(new.position) - 1.0) <= 0.1 + 1e-12)
    assert np.all(new.size > 0.0)
    for age in range(0, lifetime(matter), 3):
        flying = pieces([burst(matter, age)], RADIUS)
        assert np.all(flying.height >= 0.0)
        assert np.all(np.abs(flying.position - new.position) < RADIUS / 2.0)
    assert np.all(pieces([burst(matter, lifetime(matter))], RADIUS).size < 1e-12)


@MATTERS
def test_pieces_go_up_come_down_and_bounce(matter):
    """On average they rise at first; each comes down to the ground and bounces to less than a quarter of its height."""
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
    """In the air the height of every piece is a parabola, with the same gravity for all."""
    heights = np.array([pieces([burst(matter, age)], RADIUS).height for age in range(30)])
    bend = np.diff(heights, 2, axis=0)[np.all([heights[k : 28 + k] > 0.0 for k in range(3)], axis=0)]
    falling = bend[bend < 0.0]
    assert len(falling) > 100
    assert np.allclose(np.median(falling), -1.5 * RADIUS / 240.0**2)
    assert np.isclose(falling, np.median(falling)).mean() > 0.95


def test_pieces_go_in_their_bursts_direction():
    """The mean of many pieces moves in the burst's direction, and hardly to either side of it."""
    for direction in (1.0, 1j, -1.0, (1.0 + 1j) / math.sqrt(2.0)):
        start, later = (
            pieces([burst(Matter.STEEL, age, direction=direction, seed=seed) for seed in range(20)], RADIUS) for age in (0, 40)
        )
        mean = np.mean(later.position - start.position)
        assert (mean * np.conj(direction)).real > 4.0 * abs((mean * np.conj(direction)).imag)


def test_the_same_burst_always_scatters_alike():
    """A burst has the same pieces every time, alone or beside others; with another seed it has other pieces."""
    alone = pieces([burst(age=30)], RADIUS)
    beside = pieces([burst(Matter.BALL, 5, 3), burst(age=30)], RADIUS)
    count = NUMBERS_OF_PIECES[Matter.BRICK]
    mine = beside.burst == 1
    assert mine.sum() == count
    other = pieces([burst(age=30, seed=78)], RADIUS)
    assert not np.allclose(other.position, alone.position)
    again = pieces([burst(age=30)], RADIUS)
    assert all(np.array_equal(one, two) for one, two in zip(alone, again, strict=True))
    assert np.allclose(beside.position[mine], alone.position)


def test_chances_are_spread_evenly():
    """Over many seeds and pieces all random numbers have the mean and the spread of even distributions from -1 to 1."""
    many = np.array([chances(seed, number) for seed in range(200) for number in range(16)])
    assert many.shape == (3200, CHANCES)
    assert np.abs(many.mean(axis=0)).max() < 0.05
    assert many.std(axis=0) == pytest.approx(1.0 / math.sqrt(3.0), abs=0.03)
    assert np.abs(np.corrcoef(many.T) - np.eye(CHANCES)).max() < 0.08


@pytest.mark.parametrize("level", [2, 4, 6])
def test_what_hides_a_point_is_found_as_by_marching(level):
    """For at least 95 % of points the answer is that of a march along the line of sight in four thousand steps."""
    scene = scene_of(level, 900)
    chance = np.random.default_rng(level)
    points = np.sqrt(chance.random(300)) * 9.0 * np.exp(1j * chance.random(300) * math.tau)
    heights = chance.random(300) * 1.5
    for view in (SOLID, Viewpoint(1.0, 1.0, 2.0, 1.2), Viewpoint(1.0, 0.5, -1.0, 0.9)):
        camera = camera_of(view, scene, SIZE)
        found = occluded(points, heights, scene, camera)
        marched = np.array([blocked(scene, camera, point, above) for point, above in zip(points, heights, strict=True)])
        assert (found == marched).mean() > 0.95
        assert 0.03 < marched.mean() < 0.9


def test_a_gap_hides_nothing():
    """On the paddles' track a point within a paddle is hidden, one in the middle between two is not."""
    scene = scene_of(0)
    paddles, pitch = scene.rings[0], math.tau / scene.rings[0].count
    within = paddles.radius * np.exp(1j * (paddles.phase + pitch * np.arange(paddles.count)))
    between = within * np.exp(0.5j * pitch)
    found = occluded(np.concatenate([within, between]), np.zeros(2 * paddles.count), scene, camera_of(SOLID, scene, SIZE))
    assert found.tolist() == [True] * paddles.count + [False] * paddles.count


def blocked(scene, camera, point, above):
    """Whether a line from a point to the eye passes through a brick, by many small steps."""
    foot = -1j * math.sin(camera.tilt) / camera.turning / camera.closeness
    high = math.cos(camera.tilt) / camera.closeness
    share = np.linspace(0.0, 1.0, 4000)
    points, levels = point + (foot - point) * share, above + (high - above) * share
    for ring, contents in zip(scene.rings, resting_contents(scene.layers), strict=True):
        tall = np.array([height(content) for content in contents]) * LAYER_HEIGHT * scene.ground_radius
        turns = (np.angle(points) - ring.phase) / (math.tau / ring.count)
        slot = np.rint(turns).astype(int)
        inside = (np.abs(np.abs(points) - ring.radius) < ring.half_width) & (
            np.abs(turns - slot) * math.tau / ring.count < ring.half_angle
        )
        if np.any(inside & (tall[slot % ring.count] > levels)):
            return True
    return False


@pytest.mark.parametrize("view", [FLAT, SOLID], ids=["flat", "solid"])
@MATTERS
def test_the_page_has_the_same_pieces_as_the_desktop(matter, view):
    """All corners and colours of plates and streaks are the same in the page's list of primitives and the desktop's arrays.

    A piece that is narrower than a pixel is a line between its farthest corners on the page.
    """
    flown = burst(matter, age=20)
    scene = scene_of(1)._replace(bursts=(flown,))
    camera = camera_of(view, scene, SIZE)
    flying, own = debris.pieces([flown], scene.ground_radius), np.array(burst_colour(flown, DARK), dtype=float)
    if matter in PLATES:
        outlines = debris_picture._plates(flying.flying, camera)
        colours = debris_picture._glittering(flying.flying, own)
    else:
        before = debris.pieces([earlier(flown)], scene.ground_radius)
        outlines = debris_picture._streaks(flying.flying, before.flying, camera)
        colours = debris_picture._burning(flying.flying, own, DARK)
    found = flying_pieces(scene, ArenaView(camera, DARK, 20.0, SIZE))
    assert len(found) == len(outlines) == NUMBERS_OF_PIECES[matter]
    for (position, picture), ground, outline, colour in zip(
        found, flying.flying.x + 1j * flying.flying.y, outlines, colours, strict=True
    ):
        ((code, packed, _opacity, own),) = primitives(picture.numbers)
        assert position == pytest.approx(ground)
        corners = np.array(own[3:] if code == Primitive.LINE else own[1:]).reshape(-1, 2) @ np.array([1.0, 1.0j])
        expected = max(outline[::2], outline[1::2], key=lambda ends: abs(ends[1] - ends[0])) if len(corners) == 2 else outline
        assert np.abs(corners - expected).max() < 1e-3
        assert np.abs(np.array(unpacked(packed)) - colour).max() <= 0.5 + 1e-9
