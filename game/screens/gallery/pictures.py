"""Draws the screens into files."""

import io
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import pygame

from game.levels import built_in
from game.overlay import toast_drawing
from game.screens.base import Screen
from game.screens.gallery.sample import FRAME, sample_state
from game.screens.gallery.screens import every_screen
from game.screens.menus.level_select import LevelSelect
from game.settings.values import Settings
from game.system.errors import BadInputError
from game.system.files import write_atomically
from game.system.quiet_stderr import quiet_libraries
from game.system.wording import quoted


def save_pictures(folder: Path, size: tuple[int, int], settings: Settings, only: str = "") -> Iterator[Path]:
    """Draw the screens into PNG files, one after the other: their paths.

    size: pixels. only: a part of the names wanted; BadInputError if no name has it.
    """
    wanted = [(name, opened) for name, opened in every_screen() if only in name]
    if not wanted:
        raise BadInputError(f"--only {quoted(only)}: no screen has that in its name")
    with quiet_libraries():
        pygame.display.init()
    try:
        for name, opened in wanted:
            with TemporaryDirectory() as kept:
                state = sample_state(Path(kept), settings)
                surface = _drawn(opened(state), size)
                if state.toast is not None:
                    toast_drawing.draw(state.words(state.canvas(surface)), state.toast)
                yield _saved(folder / f"{name}.png", surface)
    finally:
        pygame.quit()


def _drawn(screen: Screen, size: tuple[int, int]) -> pygame.Surface:
    """A screen's picture."""
    surface = pygame.Surface(size, 0, 32)
    if isinstance(screen, LevelSelect):  # the levels' pictures come one by one
        for _ in range(2 * len(built_in())):
            screen.advance(FRAME, size)
            screen.draw(surface)
    screen.draw(surface)
    return surface


def _saved(path: Path, surface: pygame.Surface) -> Path:
    """The path of a picture that was written."""
    picture = io.BytesIO()
    pygame.image.save(surface, picture, "screen.png")
    write_atomically(path, picture.getvalue())
    return path
