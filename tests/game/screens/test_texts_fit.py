"""In every language all texts fit, are legible, and are translated."""

import gettext
import itertools
import os
import re
from types import SimpleNamespace

os.environ["SDL_VIDEODRIVER"] = "dummy"

import numpy as np
import pygame
import pytest

from game import language as languages
from game.drawing.palette import contrast
from game.drawing.text import Type
from game.editor.window import picture
from game.language import CODES
from game.overlay.captions import Caption
from game.rules import EventKind
from game.screens.gallery import screens
from game.screens.gallery.sample import sample_state
from game.screens.play import buttons as play_buttons
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.panel import Panel
from game.settings.values import THEMES

SMALLEST = (800, 600)
GAMES = {name for name, _ in [*screens._games(), *screens._results_of_games()]}
"""Screens that take a game to be played; what is written in a game is looked at below."""
NO_PANELS = {"title", "replay"}
LEAST_CONTRAST = 4.5
PLAYERS = {"ADA", "Ada", "Grace", "Emmy", "Sofia", "Hypatia", "The one with the long rally"}
EDITED = {"Orbit", "Gravity", "Three orbits", "My level", "my-level.toml"}
KEY = "rings[0].radius"
"""Of a level file: the message about a broken rule names it in every language."""
NAMES = {
    *PLAYERS,
    *EDITED,
    "Python",
    "(Language)",
    *[one.name for one in languages.LANGUAGES],
}
"""Words, or beginnings of words, that have Latin letters in every language."""
PANELS = {name: opened for name, opened in screens.every_screen() if name not in GAMES | NO_PANELS}


def ground_of(surface, box):
    """The most frequent colour in a box."""
    colours, counts = np.unique(pygame.surfarray.array2d(surface.subsurface(box)), return_counts=True)
    return surface.unmap_rgb(int(colours[counts.argmax()]))[:3]


@pytest.fixture
def written(monkeypatch):
    """Every line that is written on the window and not into a picture, with the visible part of its box.

    With each line comes the contrast of its colour to the background.
    """
    lines = []
    plain, nowhere = Type.write, pygame.Surface((1, 1))

    def write(self, surface, text, size, colour, *arguments, **keywords):
        box = plain(self, nowhere, text, size, colour, *arguments, **keywords)
        seen = box.clip(surface.get_clip())
        if text.strip() and seen.height > box.height * 0.9 and surface.get_size() == SMALLEST:
            lines.append((text, seen, contrast(colour, ground_of(surface, seen))))
        return plain(self, surface, text, size, colour, *arguments, **keywords)

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
    found.change(found.settings._replace(language="en", colours="dark"))
    pygame.quit()


@pytest.mark.parametrize(("language", "colours"), list(zip(CODES, THEMES, strict=True)))
@pytest.mark.parametrize("text_size", [100, 200])
def test_every_line_can_be_read(state, written, language, colours, text_size):
    """On every panel each line is inside of the window, overlaps no other, is not cut off, and has enough contrast."""
    state.change(state.settings._replace(language=language, text_size=text_size, colours=colours))
    surface = pygame.Surface(SMALLEST, 0, 32)
    for name, opened in PANELS.items():
        screen = opened(state)
        written.clear()
        screen.draw(surface)
        assert len(written) >= 3, name
        for text, box, ratio in written:
            assert surface.get_rect().contains(box), (name, text)
            assert not text.endswith("…"), (name, text)
            assert ratio >= LEAST_CONTRAST, (name, text, ratio)
        for (first, one, _), (second, other, _) in itertools.combinations(written, 2):
            shared = one.clip(other)
            assert shared.width < 3 or shared.height < 0.4 * min(one.height, other.height), (name, first, second)


class Greek(gettext.NullTranslations):
    """Translations in which every Latin letter outside of braces is replaced by a Greek one."""

    letters = str.maketrans({chr(code): chr(0x370 + code) for code in range(ord("A"), ord("z") + 1) if chr(code).isalpha()})

    def gettext(self, message):
        """A text in Greek letters, placeholders unchanged."""
        return "".join(
            [part if part.startswith("{") else part.translate(self.letters) for part in re.split("({.*?})", message)]
        )

    def ngettext(self, one, many, count):
        """The same for a count."""
        return self.gettext(one if count == 1 else many)


def test_no_text_is_left_untranslated(state, written, monkeypatch):
    """With these translations every word on a panel is in Greek letters, except names."""
    monkeypatch.setattr(languages, "catalogue", lambda _code: Greek())
    state.change(state.settings._replace(text_size=100))
    surface = pygame.Surface(SMALLEST, 0, 32)
    for name, opened in PANELS.items():
        screen = opened(state)
        written.clear()
        screen.draw(surface)
        latin = {text for text, *_ in written if re.search("[A-Za-z]{2}", text.replace(KEY, ""))}
        assert all(any(name in text for name in NAMES) for text in latin), (name, latin)
        assert len(latin) < len(written)


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
    for text, box, _ in written:
        assert surface.get_rect().contains(box), text
        assert not text.endswith("…"), text
        assert box.collidelist(buttons) == -1, text
    for (first, one, _), (second, other, _) in itertools.combinations(written, 2):
        shared = one.clip(other)
        assert shared.width < 3 or shared.height < 0.4 * min(one.height, other.height), (first, second)
    state.change(state.settings._replace(speed=100, one_button=False, sound=True))
