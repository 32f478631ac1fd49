"""Nothing flashes more than three times a second on an area that matters, as WCAG 2.3.1 defines it.

A flash is a pair of opposing changes of the relative luminance by a tenth of the highest, where the darker one is below 0.8.
The area is too large when it fills a quarter of any field of view of 10°, a third of the picture across and down.
"""

import cmath
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game import effects
from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import LIGHT
from game.drawing.text import Type
from game.effects import ALL
from game.levels import classic
from game.rules import Controls, EventKind, new_game, tick
from game.scene import scene_at
from physics import Ball

SIZE, RATE, SECONDS, BALLS = (320, 240), 30, 2.0, 8
TICKS_PER_FRAME = 240 // RATE


def luminance(surface):
    """Relative luminance of every pixel."""
    channels = pygame.surfarray.array3d(surface).astype(np.float32) / 255.0
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    return linear @ np.array([0.2126, 0.7152, 0.0722], dtype=np.float32)


def dense_game():
    """A level with many balls at once, all on their way out through bricks and paddles."""
    game = new_game(classic()[2:], 7)
    for _ in range(3):
        game = tick(game, Controls(serve=True)).game
    (ball,) = game.arena.balls
    balls = []
    for index in range(BALLS):
        heading = cmath.rect(abs(ball.velocity), index * cmath.tau / BALLS + 3.5 + 0.3 * index)
        balls.append(Ball(cmath.rect(0.58 * game.level.ground_radius, index * cmath.tau / BALLS), heading, ball.radius))
    return game._replace(arena=game.arena._replace(balls=tuple(balls)))


def pictures(game):
    """The luminance of every frame, and the kinds of all events."""
    pilot, shown, painter, letters, seen = (
        Autopilot(),
        effects.NOTHING,
        Painter(),
        Type(),
        layout(SIZE, game.level.ground_radius),
    )
    frames, kinds = [], []
    for number in range(round(SECONDS * 240)):
        ticked = tick(game, pilot.controls(game))
        game, shown = ticked.game, effects.after(shown, ticked, ALL)
        kinds += [event.kind for event in ticked.events]
        if number % TICKS_PER_FRAME == 0:
            surface = pygame.Surface(SIZE, 0, 32)
            painter.paint(Canvas(surface, seen.camera, LIGHT, letters, seen.unit), scene_at(ticked, 1.0, shown))
            frames.append(luminance(surface))
    return frames, kinds


def flashes(frames):
    """Of every pixel and every second that ends with a frame, the number of flashes."""
    extreme, rising = frames[0].copy(), np.zeros(frames[0].shape, dtype=np.int8)
    changes = [np.zeros(frames[0].shape, dtype=bool)]
    for frame in frames[1:]:
        dark = np.minimum(frame, extreme) < 0.8
        up = (frame - extreme >= 0.1) & dark & (rising <= 0)
        down = (extreme - frame >= 0.1) & dark & (rising >= 0)
        rising = np.where(up, 1, np.where(down, -1, rising))
        follows = up | down | ((rising > 0) & (frame > extreme)) | ((rising < 0) & (frame < extreme))
        extreme = np.where(follows, frame, extreme)
        changes.append(up | down)
    counted = np.cumsum(changes, axis=0, dtype=np.int16)
    return (counted[RATE:] - counted[:-RATE]) // 2


def largest_share(mask):
    """The largest share of a third of the picture, across and down, that a mask fills."""
    width, height = (side // 3 for side in mask.shape)
    sums = np.zeros((mask.shape[0] + 1, mask.shape[1] + 1))
    sums[1:, 1:] = mask.cumsum(0).cumsum(1)
    inside = sums[width:, height:] - sums[:-width, height:] - sums[width:, :-height] + sums[:-width, :-height]
    return inside.max() / (width * height)


def test_what_flashes_is_found():
    """Three frames of white and two of black in turns are six flashes in 30 frames, of the whole picture."""
    frames = [np.full(SIZE, float(index % 5 < 3), dtype=np.float32) for index in range(RATE + 1)]
    assert flashes(frames).max() == pytest.approx(6, abs=1)
    assert largest_share(flashes(frames)[0] > 3) == 1.0


def test_many_lost_balls_do_not_flash():
    """Eight balls in play with every effect on the light theme, some lost at once: less than a quarter of any field flashes."""
    frames, kinds = pictures(dense_game())
    assert kinds.count(EventKind.BALL_LOST) >= 3
    assert kinds.count(EventKind.BRICK_HIT) >= 5
    assert max([largest_share(one > 3) for one in flashes(frames)[::2]]) < 0.25
