"""A picture of a scene in a file, without a window."""

import io
from pathlib import Path

import pygame

from game.lab.checks import run_to
from game.lab.parameters import written
from game.lab.picture import Toggle
from game.lab.scene import picture_of
from game.lab.share import Shared
from game.lab.window.canvas import camera_for
from game.lab.window.page import draw_picture, draw_words, page, panes
from game.palette import DARK, Theme
from game.text import Type

SHOWN = frozenset(Toggle) - {Toggle.PYMUNK}
"""What is shown at first."""


def save_screenshot(shared: Shared, path: Path, size: tuple[int, int], theme: Theme = DARK) -> None:
    """Draw a scene as it stands and save it as PNG; OSError where it cannot be written. Needs no display."""
    surface = pygame.Surface(size, 0, 32)
    surface.fill(theme.background)
    place, type_ = page(size), Type()
    picture = picture_of(shared.scene, shared.given, run_to(shared.scene, shared.given, shared.tick))
    cameras = [camera_for(shared.scene.view, area) for area in panes(place, len(picture.panes))]
    draw_picture(surface, place, picture, cameras, theme, type_, SHOWN)
    draw_words(surface, place, shared.scene, picture, theme, type_)
    top = place.unit
    for parameter in shared.scene.parameters:
        text = f"{parameter.label} = {written(parameter, shared.given.values[parameter.name])}   {parameter.meaning}"
        type_.write(surface, text, place.unit, theme.text, complex(place.side.left + place.unit, top))
        top += place.unit * 1.6
    picture_file = io.BytesIO()
    pygame.image.save(surface, picture_file, "screenshot.png")
    path.write_bytes(picture_file.getvalue())
