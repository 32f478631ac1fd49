"""The editor's help: every key and what the mouse does."""

import pygame

from game.input.signals import Clicked, Pressed, Signal
from game.language import tr, tr_noop
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.still_picture import StillPicture
from game.screens.toolkit.plate import centred, dim, draw_panel

# Lengths are in units of text.
_WIDTH, _LEFT, _TOP, _BOTTOM = 36.0, 2.0, 1.2, 1.2
_TITLE, _TEXT, _PITCH, _LINES_TOP, _MEANING_LEFT = 2.2, 1.05, 1.5, 3.8, 11.0

LINES = (
    (tr_noop("Left button"), tr_noop("paint bricks with the brush, also by dragging")),
    (tr_noop("Right button"), tr_noop("take bricks away")),
    (tr_noop("Wheel"), tr_noop("over the arena: the brush; over a number: the number")),
    ("1-9, 0, -", tr_noop("brush: layers of a stack, a gap, unbreakable")),
    ("R, M", tr_noop("repeat a stroke around the ring; mirror it")),
    ("Tab, Shift+Tab", tr_noop("choose the next ring outward or inward")),
    (tr_noop("Up, down"), tr_noop("choose a number")),
    (tr_noop("Left, right"), tr_noop("change it; with Shift ten steps at once")),
    (tr_noop("Enter"), tr_noop("type it; Enter again takes it over")),
    ("C or Ins, Del", tr_noop("copy the chosen ring outward; remove it")),
    ("F", tr_noop("fill the chosen ring with the brush")),
    ("Ctrl+Z, Ctrl+Y", tr_noop("undo, redo")),
    ("F5", tr_noop("play the level; Esc there comes back")),
    ("Ctrl+S", tr_noop("save; comments in the file stay")),
    ("Esc", tr_noop("leave; asks where changes are not saved")),
)
"""Keys, and what they do."""
_NOTE = tr_noop("A file that is changed in a text editor is taken over at once, and can be undone.")


class EditorHelp:
    """A panel that any key of the game or a click closes."""

    def __init__(self, state: AppState, under: Screen) -> None:
        """Open over the editor."""
        self._state, self._under = state, under
        self._picture = StillPicture()

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """Close it, or wait on."""
        return self._under if isinstance(signal, Pressed | Clicked) else self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The editor, dimmed, and the panel."""
        self._picture.show(surface, (self._state.appearance,), self._draw)

    def _draw(self, surface: pygame.Surface) -> None:
        """Draw it anew."""
        self._under.draw(surface)
        canvas = self._state.canvas(surface)
        theme, unit = canvas.theme, canvas.unit
        dim(surface, theme)
        height = _LINES_TOP + _PITCH * (len(LINES) + 1) + _BOTTOM
        panel = centred(canvas.size, unit * _WIDTH, unit * height)
        draw_panel(surface, panel, theme, unit)
        corner = complex(panel.left + unit * _LEFT, panel.top + unit * _TOP)
        canvas.write(tr("The editor"), _TITLE, theme.text, corner)
        for index, (keys, meaning) in enumerate(LINES):
            line = complex(corner.real, panel.top + unit * (_LINES_TOP + _PITCH * index))
            canvas.write(tr(keys), _TEXT, theme.accent, line)
            canvas.write(tr(meaning), _TEXT, theme.text, line + unit * _MEANING_LEFT)
        last = complex(corner.real, panel.top + unit * (_LINES_TOP + _PITCH * len(LINES)))
        canvas.write(tr(_NOTE), _TEXT, theme.faint, last)
