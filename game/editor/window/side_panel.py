"""The side panel of the editor: its controls."""

from collections.abc import Callable

import pygame

from game.drawing.palettes import themed
from game.editor import session as editing
from game.editor.fields import Field, PanelPart, is_optional, longest
from game.editor.session import EditorSession, value_of
from game.editor.window.controls import PARTS, EditorCallbacks, EditorControls, controls, number_text
from game.editor.window.layout import EditorLayout
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.form import focused_item
from game.screens.toolkit.items.text_field import TextField
from game.screens.toolkit.layout import FormLayout, column_layout
from game.screens.toolkit.side_panel import MODIFIERS, SidePanel, Typing
from game.screens.toolkit.text_entry import TextEntry

_NARROW = 13.5
"""A side that is narrower has one switch in a row, in units of text."""
_DIGITS = "0123456789-.,"
_TOP = 0.4
"""Above and below the controls, in units of text."""


class EditorSidePanel(SidePanel):
    """The controls of the edited level. When it gets the keys back, the control that had the focus has it again."""

    def __init__(
        self,
        state: AppState,
        screen: Screen,
        put: Callable[[EditorSession], None],
        command: Callable[[str], Screen | None],
        shown: tuple[EditorLayout, EditorSession],
    ) -> None:
        """The side panel of a screen. put: takes a changed session; command: runs a command; shown: as in `show`."""
        super().__init__(state, screen)
        self._put = put
        self._callbacks = EditorCallbacks(put, command, self.open_part, self._edit, self._enter)
        self._layout, self._session = shown
        self.part = PanelPart.BRICKS

    @property
    def area(self) -> pygame.Rect:
        """The right side of the window."""
        return self._layout.side

    @property
    def appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on, except the focus."""
        return self._state.appearance, self._layout, self._session, self.part

    @property
    def full_appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on."""
        return self.part, self._typing, self._focus, self._scroll, self._has_keys

    @property
    def is_typed_into(self) -> bool:
        """Whether a number is being typed."""
        return self._typing is not None

    def hear_key(self, event: pygame.Event, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """As in every side panel; in addition, a digit on a number begins to type it."""
        written = getattr(event, "unicode", "")
        if self._typing is None and self._has_keys and written and written in _DIGITS and not event.mod & MODIFIERS:
            positioned = focused_item(self._form_layout(size), self._focus)
            if positioned is not None and positioned.item.is_typed:
                return True, positioned.item.accepted(self._screen)
        return super().hear_key(event, size)

    def show(self, layout: EditorLayout, session: EditorSession) -> None:
        """Show the controls of a session, in a window with this layout."""
        self._layout, self._session = layout, session

    def open_part(self, part: PanelPart) -> None:
        """Show another part, scrolled to its top."""
        if part is not self.part:
            self.part, self._scroll, self._typing, self._nearest = part, 0.0, None, None

    def turn(self, offset: int) -> None:
        """Show the part `offset` after this one, with the focus on its name."""
        self.open_part(PARTS[(PARTS.index(self.part) + offset) % len(PARTS)])

    def release(self) -> None:
        """Give the keys back to the arena."""
        self._nearest = self._focus if self._has_keys else self._nearest
        super().release()

    def tip(self, size: tuple[int, int]) -> str:
        """The tip of the focused control."""
        layout = self._form_layout(size)
        positioned = focused_item(layout, self._settled(layout))
        return "" if positioned is None else positioned.item.tip

    def unit(self, _size: tuple[int, int]) -> float:
        """Size of the controls' text, pixels."""
        return self._layout.unit

    def _form_layout(self, _size: tuple[int, int]) -> FormLayout:
        """The controls below each other, without tips: these are drawn below the arena."""
        unit = self._layout.unit
        area = self._layout.side.inflate(0, -round(2.0 * _TOP * unit))
        theme = themed(self._state.theme, self._session.document.level.look.palette)
        seen = EditorControls(self._session, self.part, theme, self._typing, area.width < _NARROW * unit)
        layout = column_layout(controls(seen, self._callbacks), area, self._state.type, unit, self._scroll, low_foot=True)
        self._scroll = min(self._scroll, float(layout.over))
        return layout._replace(tip=pygame.Rect(0, 0, 0, 0))

    def _edit(self, field: Field, pixels: float | None) -> None:
        """Begin to type a number, or put the caret at a distance from the field's left edge, pixels."""
        shown = TextField.all_of(number_text(self._session, field))
        self.edit(Typing(field, shown, lambda text: self._entered(field, text), tr(field.label)), pixels)

    def _entered(self, field: Field, text: str) -> Screen:
        """Set a number from the typed text; an empty field removes an optional key from the file."""
        optional = is_optional(field.table, field.key)
        try:
            self._put(editing.entered(self._session, field, None if optional and not text else float(text.replace(",", "."))))
        except ValueError:
            self._put(self._session._replace(message=tr("{text}: not a number").format(text=text or '""')))
        return self._screen

    def _enter(self, field: Field) -> Screen:
        """A panel to enter a text on."""

        def done(text: str) -> Screen:
            """Set it; an empty one is left out."""
            self._put(editing.entered(self._session, field, text or (None if is_optional(field.table, field.key) else text)))
            return self._screen

        present, most = value_of(self._session, field), longest(field.table, field.key)
        return TextEntry(self._state, self._screen, tr(field.label), present, most, done)
