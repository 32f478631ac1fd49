"""The texts of every language have room: on the smallest usual window, and in the largest letters."""

import itertools
import os
from types import SimpleNamespace

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.drawing.text import Type
from game.editor.window import picture
from game.language import CODES
from game.overlay.captions import Caption
from game.rules import EventKind
from game.screens import play_buttons
from game.screens.gallery import screens
from game.screens.gallery.sample import sample_state
from game.screens.play import PlayScreen
from game.screens.toolkit.panel import Panel

SMALLEST = (800, 600)
GAMES = {name for name, _ in [*screens._games(), *screens._results_of_games()]}
"""Screens that take a game to be played; what is written in a game is looked at below."""
NO_PANELS = {"title", "replay"}
PANELS = {name: opened for name, opened in screens.every_screen() if name not in GAMES | NO_PANELS}


@pytest.fixture
def written(monkeypatch):
    """Every line that is written on the window and not into a picture, with its box, as far as it is seen."""
    lines = []
    plain = Type.write

    def write(self, surface, text, *arguments, **keywords):
        box = plain(self, surface, text, *arguments, **keywords)
        seen = box.clip(surface.get_clip())
        if text.strip() and seen.height > box.height * 0.9 and surface.get_size() == SMALLEST:
            lines.append((text, seen))
        return box

    monkeypatch.setattr(Type, "write", write)
    monkeypatch.setattr(picture, "draw_arena", lambda *_: None)
    monkeypatch.setattr(Panel, "draw_behind", lambda _self, surface: surface.fill((0, 0, 0)))
    return lines


@pytest.fixture(scope="module")
def state(tmp_path_factory):
    """What screens share, with made-up scores and games."""
    pygame.display.init()
    found = sample_state(tmp_path_factory.mktemp("kept"))
    yield found
    found.change(found.settings._replace(language="en"))
    pygame.quit()


@pytest.mark.parametrize("language", CODES)
@pytest.mark.parametrize("text_size", [100, 200])
def test_no_line_is_cut_off_or_written_over_another(state, written, language, text_size):
    """On every panel each line is inside of the window and apart from all others, and none has lost its end."""
    state.change(state.settings._replace(language=language, text_size=text_size))
    surface = pygame.Surface(SMALLEST, 0, 32)
    for name, opened in PANELS.items():
        screen = opened(state)
        written.clear()
        screen.draw(surface)
        assert len(written) >= 3, name
        for text, box in written:
            assert surface.get_rect().contains(box), (name, text)
            assert not text.endswith("…"), (name, text)
        for (first, one), (second, other) in itertools.combinations(written, 2):
            shared = one.clip(other)
            assert shared.width < 3 or shared.height < 0.4 * min(one.height, other.height), (name, first, second)


@pytest.mark.parametrize("language", CODES)
@pytest.mark.parametrize("text_size", [100, 200])
def test_what_is_written_in_a_game_has_room(state, written, language, text_size):
    """Figures, notice, captions, and a long row of what is special about this game."""
    settings = state.settings._replace(language=language, text_size=text_size, captions=True)
    state.change(settings._replace(speed=75, one_button=True, sound=False))
    play = PlayScreen(state, state.catalogue)
    play._record.ghost = SimpleNamespace(game=play._ticked.game)
    sounds = EventKind.BALL_CAUGHT, EventKind.DROP_RELEASED, EventKind.BRICK_HIT
    play._captions = tuple([Caption(kind, 7, 12) for kind in sounds])
    surface = pygame.Surface(SMALLEST, 0, 32)
    written.clear()
    play.draw(surface)
    assert len(written) >= 9
    buttons = play_buttons.button_boxes(play._layout(SMALLEST))
    for text, box in written:
        assert surface.get_rect().contains(box), text
        assert not text.endswith("…"), text
        assert box.collidelist(buttons) == -1, text
    for (first, one), (second, other) in itertools.combinations(written, 2):
        shared = one.clip(other)
        assert shared.width < 3 or shared.height < 0.4 * min(one.height, other.height), (first, second)
    state.change(state.settings._replace(speed=100, one_button=False, sound=True))
