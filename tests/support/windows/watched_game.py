"""The game as it is started from a terminal, in a real window; it tells on stdout what is to be seen there.

Each line is a JSON object, written whenever something in it changes:
screen: name of the class. focused: whether the window has the keyboard. focus: label of the item that has the focus.
items: of a panel or the editor, by label: x and y of the middle in pixels, row and column, whether it scrolls, and its state.
view: upper and lower edge of the part that scrolls, pixels. close: the button that leads back; buttons: those beside the
arena; x and y. text: that is being entered. phase: of a game that is played; steers: whether a key or a trigger turns the
paddles; is_kept: whether it has lasted for long enough that its replay will be kept. moved: whether the replay that is watched
has left its beginning. answered: the number of the last question.
Each line on stdin is a question ("answer 7"), or with the environment's PAD set, which plugs a gamepad in, a method of it and
its numbers ("press 0"). A question is answered once the game has taken all that was sent to its window before.
"""

import json
import os
import select
import sys

from game.__main__ import main
from game.editor.window.screen import Editor
from game.loop import app
from game.rules import TICK
from game.screens.play import buttons as play_buttons
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.text_entry import TextEntry
from game.screens.watch import Watch
from game.storage import games as kept_games
from tests.support.windows.virtual_pad import VirtualPad, library

_FRAMES = 2
"""From a question to its answer: the first of these frames begins with all events that were sent before."""


class _Told:
    """What was told last; a panel is only looked at again when it has changed."""

    def __init__(self):
        self.told, self.looks, self.pad, self.heard = None, None, None, b""
        self.answered, self.question = 0, None

    def frame(self, window, state, screen, *rest):
        """A turn of the loop, and word of what it has changed."""
        self._obey_hands()
        following = _plain(window, state, screen, *rest)
        self._answer()
        size = window.size
        looks = following, size, window.focused, self.answered, _looks(following)
        if looks != self.looks:
            self.looks = looks
            basic = {"screen": type(following).__name__, "focused": window.focused, "answered": self.answered}
            told = json.dumps(basic | _described(following, size))
            if told != self.told:
                self.told = told
                sys.stdout.write(f"{told}\n")
                sys.stdout.flush()
        return following

    def _obey_hands(self):
        """Do what stdin says, one thing in a frame: SDL looks at a gamepad once in each."""
        if self.pad is None and "PAD" in os.environ:
            self.pad = VirtualPad(library())
        while select.select([0], [], [], 0.0)[0] and (more := os.read(0, 4096)):
            self.heard += more
        line, ended, rest = self.heard.partition(b"\n")
        if not ended or self.question is not None:
            return
        self.heard = rest
        act, *numbers = line.decode().split()
        if act == "answer":
            self.question = (int(numbers[0]), _FRAMES)
        else:
            getattr(self.pad, act)(*[float(number) if "." in number else int(number) for number in numbers])

    def _answer(self):
        """Answer the question once its frames have passed."""
        if self.question is not None:
            number, left = self.question
            self.question = (number, left - 1) if left > 1 else None
            self.answered = number if left == 1 else self.answered


def _looks(screen):
    """What a screen's description depends on."""
    if isinstance(screen, Panel):
        return Panel.appearance.fget(screen)
    if isinstance(screen, PlayScreen):
        return screen._ticked.game.phase, _steers(screen), _is_kept(screen)
    if isinstance(screen, Watch):
        return screen._at > 0.0
    return None


def _described(screen, size):
    """The part of the line that is the screen's own."""
    if isinstance(screen, Panel):
        return _panel(screen, size)
    if isinstance(screen, Editor):
        return {"items": _panel(screen.side(size), size)["items"]}
    if isinstance(screen, PlayScreen):
        boxes = play_buttons.button_boxes(screen._layout(size))
        seen = {"phase": screen._ticked.game.phase.name, "steers": _steers(screen), "is_kept": _is_kept(screen)}
        return seen | {"buttons": [box.center for box in boxes]}
    if isinstance(screen, Watch):
        boxes = play_buttons.button_boxes(screen._layout(size), play_buttons.WATCHING)
        return {"moved": screen._at > 0.0, "buttons": [box.center for box in boxes]}
    return {}


def _panel(panel, size):
    """A panel's items."""
    layout = panel._form_layout(size)
    focus, controls, focused = panel._settled(layout), {}, None
    for positioned in layout.items:
        if positioned.item.focusable and (words := _words(positioned.item)):
            controls.setdefault(
                words, [*positioned.box.center, positioned.row, positioned.column, positioned.in_body, _state(positioned.item)]
            )
            focused = words if (positioned.row, positioned.column) == focus else focused
    view, text = [layout.body.top, layout.body.bottom], {"text": panel.text} if isinstance(panel, TextEntry) else {}
    return {"items": controls, "focus": focused, "view": view, "close": layout.close.center} | text


def _words(item):
    """What an item of a panel says."""
    cells = "  ".join([cell[0] for cell in getattr(item, "cells", ())])
    return getattr(item, "label", "") or getattr(getattr(item, "level", None), "name", "") or cells


def _state(item):
    """What an item stands at: of a switch or a choice."""
    return str(getattr(item, "on", getattr(item, "index", "")))


def _steers(play):
    """Whether a key or a trigger turns the paddles."""
    return bool(play._hands.held or play._hands.spin)


def _is_kept(play):
    """Whether a game has lasted for long enough that its replay will be kept."""
    return play._ticked.game.tick * TICK >= kept_games._SHORTEST


_plain = app.frame

if __name__ == "__main__":
    app.frame = _Told().frame
    sys.exit(main())
