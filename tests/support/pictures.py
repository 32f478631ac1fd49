"""Games to draw, and what to draw them on."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import Effects, after
from game.input.view import FROM_ABOVE
from game.levels import built_in
from game.rules import new_game, tick
from game.scene import still


def game_after(level, ticks, seed=3):
    """The last tick of an autopilot's game, and its effects. level: counted from 0."""
    pilot, effects, done = Autopilot(), Effects(), still(new_game(built_in()[level:], seed))
    for _ in range(ticks):
        done = tick(done.game, pilot.controls(done.game))
        effects = after(effects, done)
    return done, effects


def camera_of(view, scene, size):
    """The camera through which a view shows a scene. size: of the surface, pixels."""
    return view.seen(layout(size, scene.ground_radius)).camera


def canvas_of(scene, size, view=FROM_ABOVE, theme=DARK, camera=None):
    """A new surface for a scene, black. camera: instead of the view's."""
    return Canvas(pygame.Surface(size, 0, 32), camera or camera_of(view, scene, size), theme, Type(), 10.0)
