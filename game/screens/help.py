"""The help over another screen: the keys, and what the things in the arena are."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.flat.sample import brick_sample
from game.input.key_names import play_help
from game.input.signals import Clicked, Pressed, Signal
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.panel import centred, dim, draw_panel
from game.screens.still_picture import StillPicture
from physics import PERMANENT

# Lengths are in units of text.
_WIDTH, _HEIGHT = 34.0, 33.0
_LEFT, _TOP = 2.0, 1.2
"""From the panel's edges to the words."""
_TITLE, _GOAL, _KEYS, _SMALL = 2.2, 1.1, 1.15, 0.95
"""Sizes of letters."""
_GOAL_TOP, _KEYS_TOP, _SAMPLES_TOP = 2.6, 4.7, 23.9
"""From the title's top down, the last to the middle of the samples."""
_KEYS_HEIGHT, _KEYS_PITCH = 17.2, 1.55
"""Height of all lines of keys together, and from line to line where there is room."""
_MEANING_LEFT = 11.0
"""From the keys to what they do."""
_FIRST_SAMPLE, _SAMPLE_PITCH = 1.9, 4.3
"""From the words' left edge to the middle of the first sample, and from one to the next."""
_SAMPLE, _SAMPLE_SCALE = (4.0, 2.0), 2.0
"""Width and height of a sample, and of a unit of the world in it."""
_SAMPLE_LABEL = 1.6
"""From the middle of a sample down to its label."""
_NOTE_TOP, _NOTE_PITCH, _NOTE_WIDTH = 3.4, 1.2, 30.0
"""From the middle of the samples down to the note, from line to line of it, and its width."""
_BOTTOM = 0.7
"""From the last line to the panel's lower edge."""

_SAMPLES = ((1, "1 hit"), (2, "2 hits"), (3, "3"), (4, "4"), (5, "5"), (6, "6"), (PERMANENT, "never breaks"))
_NOTE = "Each step of a brick is one layer. Bricks in a row without a paddle between them multiply the points."


class Help:
    """A panel that any key of the game or a click closes."""

    def __init__(
        self, state: AppState, under: Screen, title: str = "How to play", keys: tuple[tuple[str, str], ...] | None = None
    ) -> None:
        """Open over a screen. keys: pairs of keys and what they do; None for those of a game."""
        self._state, self._under = state, under
        self._title, self._keys = title, play_help() if keys is None else keys
        self._picture = StillPicture()

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """Close it, or wait on."""
        return self._under if isinstance(signal, Pressed | Clicked) else self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed, and the panel."""
        self._picture.show(surface, (self._state.appearance,), self._draw)

    def _draw(self, surface: pygame.Surface) -> None:
        """Draw it anew."""
        self._under.draw(surface)
        canvas = self._state.canvas(surface)
        theme, unit = canvas.theme, canvas.unit
        dim(surface, theme)
        panel = centred(canvas.size, unit * _WIDTH, unit * _HEIGHT)
        draw_panel(surface, panel, theme, unit)
        corner = complex(panel.left + unit * _LEFT, panel.top + unit * _TOP)
        canvas.write(self._title, _TITLE, theme.text, corner)
        goal = "Keep the ball inside the circle; break every brick."
        canvas.write(goal, _GOAL, theme.faint, corner + 1j * unit * _GOAL_TOP)
        pitch = min(_KEYS_PITCH, _KEYS_HEIGHT / len(self._keys))
        for index, (keys, meaning) in enumerate(self._keys):
            line = corner + 1j * unit * (_KEYS_TOP + pitch * index)
            canvas.write(keys, _KEYS, theme.accent, line)
            canvas.write(meaning, _KEYS, theme.text, line + unit * _MEANING_LEFT)
        _draw_samples(canvas, corner + 1j * unit * _SAMPLES_TOP)
        close = "Esc, Space or a click closes this panel"
        canvas.write(close, _SMALL, theme.faint, complex(panel.centerx, panel.bottom - unit * _BOTTOM), "midbottom")


def _draw_samples(canvas: Canvas, left: complex) -> None:
    """Samples of bricks and what they are. left: pixel at the left end of the line through their middles."""
    theme, unit = canvas.theme, canvas.unit
    size = (round(unit * _SAMPLE[0]), round(unit * _SAMPLE[1]))
    for index, (layers, words) in enumerate(_SAMPLES):
        middle = left + unit * (_FIRST_SAMPLE + index * _SAMPLE_PITCH)
        card = brick_sample(size, unit * _SAMPLE_SCALE, layers, theme)
        canvas.surface.blit(card, card.get_rect(center=(round(middle.real), round(middle.imag))))
        canvas.write(words, _SMALL, theme.text, middle + 1j * unit * _SAMPLE_LABEL, "midtop")
    for index, line in enumerate(canvas.type.wrapped(_NOTE, unit * _SMALL, unit * _NOTE_WIDTH)):
        canvas.write(line, _SMALL, theme.faint, left + 1j * unit * (_NOTE_TOP + _NOTE_PITCH * index))
