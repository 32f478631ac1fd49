"""A picture of the lab's window in a file, without a window that anybody sees."""

import io
import os
from pathlib import Path

import pygame

from game.lab.session import session
from game.lab.session.share import SharedScene
from game.lab.window.screen import Lab
from game.levels import built_in
from game.screens.app_state import AppState
from game.screens.title import Title
from game.settings.values import Settings
from game.student.functions_file import FunctionsFile
from game.system.files import write_atomically
from game.system.window import open_window


def save_screenshot(
    scene: SharedScene,
    path: Path,
    size: tuple[int, int],
    colours: str,
    functions: FunctionsFile | None = None,
    *,
    presents: bool = False,
) -> None:
    """Draw the lab with a scene as it stands and save it as PNG; OSError where it cannot be written. Needs no display.

    colours: a key of `settings.THEMES`. functions: the player's own, to be shown beside ours.
    presents: whether it is drawn as for a lecture room.
    """
    if not pygame.display.get_init():
        os.environ["SDL_VIDEODRIVER"] = "dummy"
    window = open_window("lab", (16, 16))
    try:
        surface = pygame.Surface(size, 0, 32)
        state = AppState(built_in(), 0, 0, Title, settings=Settings(colours=colours), functions=functions)
        Lab(state, session.opened(scene), step=scene.step, presents=presents).draw(surface)
    finally:
        window.destroy()
    picture = io.BytesIO()
    pygame.image.save(surface, picture, "screenshot.png")
    write_atomically(path, picture.getvalue())
