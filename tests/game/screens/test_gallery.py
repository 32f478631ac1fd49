"""The pictures of every screen."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.drawing.palette import HIGH_CONTRAST
from game.language import choose
from game.screens.gallery.pictures import save_pictures
from game.screens.gallery.screens import every_screen
from game.settings.values import Settings


@pytest.fixture(autouse=True)
def english():
    """Texts are English again."""
    yield
    choose("en")


def test_a_screen_is_drawn_as_the_settings_say(tmp_path):
    """In the colours, the language and the size of text that are wanted, and nothing but the screens asked for."""
    pictures = {}
    for settings in (Settings(), Settings("contrast"), Settings(text_size=200, language="de")):
        (path,) = save_pictures(tmp_path, (320, 200), settings, "credits")
        pictures[path.read_bytes()] = pygame.image.load(path)
    assert len(pictures) == 3
    assert {picture.get_size() for picture in pictures.values()} == {(320, 200)}
    assert list(pictures.values())[1].get_at((160, 60))[:3] == HIGH_CONTRAST.panel


@pytest.mark.deep
def test_every_screen_is_drawn(tmp_path):
    """Each has a name of its own and a picture with much in it."""
    names = [name for name, _ in every_screen()]
    paths = list(save_pictures(tmp_path, (320, 200), Settings(captions=True)))
    assert sorted(path.stem for path in paths) == sorted(set(names))
    for path in paths:
        colours = set(pygame.surfarray.array2d(pygame.image.load(path)).ravel().tolist())
        assert len(colours) > 30, path.stem
