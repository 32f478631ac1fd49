"""A game's picture as a file. Needs no display."""

import io
from pathlib import Path

import pygame

from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import DARK, Theme
from game.drawing.text import Type
from game.effects import NOTHING, Effects
from game.input.view import FLAT, Viewpoint
from game.overlay import hud
from game.overlay.readings import readings
from game.rules import Game
from game.scene import scene_at, still
from game.system.files import write_atomically


def save_screenshot(
    game: Game,
    path: Path,
    size: tuple[int, int],
    theme: Theme = DARK,
    view: Viewpoint = FLAT,
    effects: Effects = NOTHING,
) -> None:
    """Draw a game as the window shows it, and save it as PNG; OSError where it cannot be written. size: pixels."""
    seen = view.seen(layout(size, game.level.ground_radius))
    canvas = Canvas(pygame.Surface(size, 0, 32), seen.camera, theme, Type(), seen.unit)
    Painter().paint(canvas, scene_at(still(game), 1.0, effects))
    hud.draw(canvas, readings(game, effects.streak), seen)
    picture = io.BytesIO()
    pygame.image.save(canvas.surface, picture, "screenshot.png")
    write_atomically(path, picture.getvalue())
