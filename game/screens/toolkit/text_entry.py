"""A panel to enter a line of text: typed on a keyboard, or letter by letter with mouse, touch or gamepad."""

from collections.abc import Callable

import pygame

from game.drawing.canvas import Canvas
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items.basic import ButtonItem, Drawing, Item
from game.screens.toolkit.items.text_field import TextField, draw_field
from game.screens.toolkit.layout import Content, Row
from game.screens.toolkit.panel import Panel

TEXT_KEYS = ("ABCDEFGHIJ", "KLMNOPQRST", "UVWXYZ-_.!", "0123456789")
NUMBER_KEYS = ("123", "456", "789", "-0.")
"""Letters of the on-screen keyboard, row by row: for a text, and for a number."""
_OTHER_SIGNS = str.maketrans("-_.!", ",;:?")
"""The signs that are shown with small letters."""
_FEW_LETTERS = 6
_NAVIGATION = frozenset(
    {pygame.K_UP, pygame.K_DOWN, pygame.K_LEFT, pygame.K_RIGHT, pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_ESCAPE}
)
"""Keys that keep their meaning while text is entered."""


class TextEntry(Panel):
    """A field and a small keyboard of buttons. Enter on a real keyboard accepts what is in the field."""

    def __init__(
        self,
        state: AppState,
        under: Screen,
        title: str,
        text: str,
        longest: int,
        done: Callable[[str], Screen | None],
        letters: tuple[str, ...] = TEXT_KEYS,
    ) -> None:
        """Open with a text. longest: most characters; done: called with the accepted text, returns the next screen.

        letters: of the on-screen keyboard. The first letter that is entered replaces a number.
        """
        super().__init__(state, under)
        self._title, self._longest, self._done, self._letters = title, longest, done, letters
        self._small = False  # whether the on-screen keyboard shows small letters and further signs
        self.field = TextField.all_of(text[:longest])
        if letters == TEXT_KEYS:
            self.field = self.field.moved(longest)

    @property
    def text(self) -> str:
        """What is in the field."""
        return self.field.text

    def content(self) -> Content:
        """The field, the letters, and what to do with them."""
        keys: list[Row] = [(Drawing(2.6, self._draw_field),)]
        for line in self._lines:
            letters = [ButtonItem(letter, self._typed(letter), centred=True) for letter in line]
            keys.append((*letters, *[Item()] * (len(self._lines[0]) - len(line))))
        erase = ButtonItem(tr("Erase"), self._erase, centred=True)
        if self._letters == TEXT_KEYS:
            case = ButtonItem("ABC" if self._small else "abc", self._change_case, centred=True)
            keys.append((ButtonItem(tr("Space"), self._typed(" "), centred=True), case, erase))
        else:
            keys.append((erase,))
        done = ButtonItem(tr("Done"), lambda: self._done(self.text.strip()), centred=True, large=True)
        footer: tuple[tuple[Item, ...], ...] = ((done,),)
        return Content(self._title, tuple(keys), footer, width=30.0 if self._letters == TEXT_KEYS else 20.0)

    def first(self) -> Focus | None:
        """The first focus: the button that accepts, so that one can type and press Enter; for a number, the first digit."""
        return Focus(len(self._lines) + 2, 0) if self._letters == TEXT_KEYS else None

    @property
    def _lines(self) -> tuple[str, ...]:
        """The letters, fewer beside each other where the player wants large texts."""
        letters = "".join(self._letters)
        letters = letters.lower().translate(_OTHER_SIGNS) if self._small else letters
        wide = min(len(self._letters[0]), _FEW_LETTERS) if self.has_large_text else len(self._letters[0])
        return tuple([letters[start : start + wide] for start in range(0, len(letters), wide)])

    def typed(self, event: pygame.Event) -> bool:
        """Take an event of the keyboard as text; whether it is one. Arrows, Enter and Esc mean what they mean everywhere."""
        if event.type == pygame.TEXTINPUT:
            self._type(str(event.text))
            return True
        if event.type != pygame.KEYDOWN or event.key in _NAVIGATION:
            return False
        if event.key == pygame.K_BACKSPACE:
            self._erase()
        return True

    def _typed(self, letter: str) -> Callable[[], Screen | None]:
        """What a button of the small keyboard does."""

        def typed() -> Screen | None:
            self._type(letter)
            return self

        return typed

    def _type(self, text: str) -> None:
        """Add to the field what can be read in one line."""
        self.field = self.field.typed(text, self._longest)
        self._changes += 1

    def _erase(self) -> Screen | None:
        """Take the last letter away."""
        self.field = self.field.without(-1)
        self._changes += 1
        return self

    def _change_case(self) -> Screen | None:
        """Switch the on-screen keyboard between capitals and small letters."""
        self._small = not self._small
        self._changes += 1
        return self

    def _draw_field(self, canvas: Canvas, box: pygame.Rect) -> None:
        """The text and where the next letter goes."""
        draw_field(canvas, box, self.text, 1.6, self.field)
