"""A side panel: one column of controls beside a picture.

Keys act on the picture until Tab directs them to the controls; Esc, or a click on the picture, directs them back. The control
under the mouse is framed as well, but receives no keys.
"""

from collections.abc import Callable, Hashable
from typing import NamedTuple

import pygame

from game.input.events import position_in, translated
from game.input.keys import Action
from game.input.repeat import Repeat
from game.input.signals import Clicked, Moved, Pressed, Released, Signal, Zoomed
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus, first_focus, moved_focus
from game.screens.toolkit.form import Form, focused_item, pointed_item
from game.screens.toolkit.items.slider import FIELD_LETTERS
from game.screens.toolkit.items.text_field import TextField, after_event, caret_at
from game.screens.toolkit.layout import FormLayout
from game.screens.toolkit.text_entry import NUMBER_KEYS, TextEntry

_LONGEST = 32
"""Characters that can be typed into a field."""
_STRIDE = 10
"""Steps that an arrow key moves a number by with Shift, and the mouse that has been held for long."""
_LONG = 30
"""Repetitions after which the mouse has been held for long."""
_ARROWS = {pygame.K_LEFT: Action.LEFT, pygame.K_RIGHT: Action.RIGHT, pygame.K_UP: Action.UP, pygame.K_DOWN: Action.DOWN}
MODIFIERS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META
"""Keys pressed together with one of these belong to the desktop."""
_ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


class Typing(NamedTuple):
    """The number that is being typed.

    name: identifies the number. field: has the typed text. enter: sets the number from a text, and returns the next screen.
    title: of the panel on which it is entered without a keyboard.
    """

    name: Hashable
    field: TextField
    enter: Callable[[str], Screen | None]
    title: str


class SidePanel(Form):
    """Base class of the controls beside a screen's picture; a derived class lays out its items (`_form_layout`)."""

    entering: tuple[int, ...] = (pygame.K_TAB,)
    """Keys that give the keys to the controls."""

    def __init__(self, state: AppState, screen: Screen) -> None:
        """The side panel of a screen."""
        super().__init__()
        self._state, self._screen = state, screen
        self._pointer = -1 - 1j  # pixels
        self._drawn: tuple[tuple[object, ...], pygame.Surface] | None = None
        self._typing: Typing | None = None
        self._clicked_while: Typing | None = None  # what was typed when the mouse was pressed
        self._has_keys = False
        self._nearest: Focus | None = None  # the control that Tab focuses first; None for the topmost one
        self._mouse_held: tuple[Repeat, int] | None = None  # while a mouse button is held, and how many steps it has made

    @property
    def screen(self) -> Screen:
        """The screen that it belongs to."""
        return self._screen

    @property
    def has_keys(self) -> bool:
        """Whether keys and gamepad act on the controls."""
        return self._has_keys

    @property
    def area(self) -> pygame.Rect:
        """The box of its plate, pixels."""
        raise NotImplementedError

    @property
    def appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on, except the focus."""
        raise NotImplementedError

    def release(self) -> None:
        """Give the keys back to the picture, and discard the text being typed."""
        self._typing, self._focus, self._has_keys, self._held = None, None, False, None

    def hear_key(self, event: pygame.Event, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """React to a pressed key. Returns whether it acted on the controls, and the next screen. Alt+Tab is the desktop's."""
        if self._typing is not None:
            return True, self._screen if event.mod & pygame.KMOD_ALT else self._typed(self._typing, event, size)
        if event.mod & MODIFIERS or not (self._has_keys or event.key in self.entering):
            return False, self._screen
        if event.key == pygame.K_TAB or not self._has_keys:
            self._tab(-1 if event.mod & pygame.KMOD_SHIFT else 1, size)
        elif event.key == pygame.K_ESCAPE:
            self.release()
        elif event.key in _ARROWS:
            self._stride = _STRIDE if event.mod & pygame.KMOD_SHIFT else 1
            return True, self.answer(Pressed(_ARROWS[event.key], position_in(event)), size)
        elif event.key in _ENTER:
            return True, self.answer(Pressed(Action.CONFIRM, position_in(event)), size)
        else:
            return False, self._screen
        return True, self._screen

    def hear_pad(self, signal: Signal, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """React to a gamepad, with a panel to enter a number. Returns whether it acted on the controls, and the next screen."""
        match signal:
            case Pressed(Action.TIP):
                self._typing = None
                self._tab(1, size)
            case Pressed() if not self._has_keys:
                return False, self._screen
            case Pressed(Action.BACK):
                self.release()
            case Pressed(Action.LEFT | Action.RIGHT | Action.UP | Action.DOWN):
                self._stride, self._typing = 1, None
                return True, self.answer(signal, size)
            case Pressed(Action.SERVE | Action.CONFIRM):
                return True, self._without_keyboard(self.answer(signal, size))
            case Released():
                return True, self.answer(signal, size)
            case _:
                return False, self._screen
        return True, self._screen

    def hear_finger(self, signal: Moved | Clicked, size: tuple[int, int]) -> Screen | None:
        """React to a finger: it uses the control where it is lifted, or scrolls. A number is entered on a panel."""
        return self._without_keyboard(self.answer(signal, size)) if self._is_inside(signal.pixel) else self._screen

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> tuple[bool, Screen | None]:
        """React to another event. Returns whether it acted on the controls, and the next screen."""
        if event.type == pygame.TEXTINPUT and self._typing is not None:
            self._typing = self._typing._replace(field=after_event(self._typing.field, event, _LONGEST))
            return True, self._screen
        if getattr(event, "touch", False) and self._is_inside(_pixel(event, pixels_per_point)):
            return True, self._screen  # made by SDL from a finger, which is handled itself
        if event.type == pygame.MOUSEBUTTONUP:
            self._is_pressed, self._mouse_held = False, None
        signal = translated(event, pixels_per_point)
        match signal:
            case Moved(pixel, held):
                self._is_pressed = self._is_pressed and held
                taken = self._is_pressed or (not held and self._is_inside(pixel))
                if not taken and not self._has_keys:
                    self._focus = None
                self._pointer = pixel
            case Clicked(pixel):
                taken = self._is_inside(pixel)
                if not taken:
                    self.release()
                self._mouse_held = (Repeat(0), 0) if taken else None
            case Zoomed():
                taken = self._is_inside(self._pointer)
            case _:
                taken = False
        return taken, self.answer(signal, size) if taken and signal is not None else self._screen

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Repeat what is held down: a direction, or a mouse button on the sign beside a number."""
        if self._mouse_held is not None and self._is_pressed:
            repeat, count = self._mouse_held
            repeat, acts = repeat.later(seconds)
            self._mouse_held = repeat, count + acts
            if acts:
                self._step_by_mouse(_STRIDE if count > _LONG else 1, size)
        return super().advance(seconds, size)

    def draw(self, surface: pygame.Surface) -> float | None:
        """Draw the controls on their plate. Returns their lower end, pixels; None if the tip of a control stands below them.

        The plate is cached while nothing on it changes.
        """
        area, size = self.area, surface.get_size()
        layout = self._form_layout(size)
        focus = self._settled(layout)
        appearance = (*self.appearance, area, self._typing, focus, self._scroll)
        if self._drawn is None or self._drawn[0] != appearance:
            theme, clip = self._state.theme, surface.get_clip()
            seen = area.clip(clip)  # empty in a window that is too small
            surface.set_clip(seen)
            surface.fill(theme.panel, area)
            pygame.draw.line(surface, theme.panel_edge, area.topleft, area.bottomleft)
            self.draw_items(self._state.canvas(surface)._replace(unit=self.unit(size)), layout, focus)
            surface.set_clip(clip)
            self._drawn = appearance, surface.subsurface(seen).copy() if seen else pygame.Surface((0, 0))
        else:
            surface.blit(self._drawn[1], area)
        positioned = focused_item(layout, focus)
        return float(layout.tip.top) if positioned is None or not positioned.item.tip else None

    def edit(self, typing: Typing, pixels: float | None) -> None:
        """Begin to type a number, with all of it selected; or put the caret where the mouse was pressed.

        pixels: from the field's left edge to the mouse; None after a key.
        """
        before = self._clicked_while
        if pixels is not None and before is not None and before.name == typing.name:
            letters = before.field.text, FIELD_LETTERS, self.unit((0, 0))
            typing = typing._replace(field=before.field.moved(caret_at(self._state.type, *letters, pixels)))
        self._typing, self._clicked_while = typing, None

    def _settled(self, layout: FormLayout) -> Focus | None:
        """The control with a frame: the one under the mouse, or the focused one if keys act on the controls; else None."""
        if self._focus is not None and focused_item(layout, self._focus) is None:
            self._focus = first_focus(layout, self._focus) if self._has_keys else None
        return self._focus

    def _hovered(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Frame the control under the mouse."""
        if not self._has_keys:
            self._focus = None
        return super()._hovered(pixel, size)

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """React to a click; beside the field it discards the typed text."""
        self._clicked_while, self._typing = self._typing, None
        return super()._clicked(pixel, size)

    def _tab(self, step: int, size: tuple[int, int]) -> None:
        """Focus the next or the previous control; at first, counted from the one under the mouse."""
        layout = self._form_layout(size)
        if self._focus is None:
            self._focus = first_focus(layout, self._nearest)
        else:
            self._focus = moved_focus(layout, self._focus, Action.RIGHT if step > 0 else Action.LEFT, None)
        self._has_keys = True
        self._show_focus(size)

    def _typed(self, typing: Typing, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """React to a key while a number is typed: Enter sets it, Tab goes on to the next one, Esc restores it."""
        if event.key in _ENTER or event.key == pygame.K_TAB:
            self._typing = None
            following = typing.enter(typing.field.text.strip())
            if event.key == pygame.K_TAB:
                self._has_keys = True
                self._tab(-1 if event.mod & pygame.KMOD_SHIFT else 1, size)
                positioned = focused_item(self._form_layout(size), self._focus)
                if positioned is not None and positioned.item.is_typed:
                    positioned.item.accepted(self._screen)
            return following
        self._typing = (
            None if event.key == pygame.K_ESCAPE else typing._replace(field=after_event(typing.field, event, _LONGEST))
        )
        return self._screen

    def _without_keyboard(self, following: Screen | None) -> Screen | None:
        """The next screen: if typing has just begun, a panel to enter the number on; else `following`."""
        typing, self._typing = self._typing, None
        if typing is None or following is not self._screen:
            return following
        return TextEntry(
            self._state, self._screen, typing.title, typing.field.text, _LONGEST, typing.enter, letters=NUMBER_KEYS
        )

    def _step_by_mouse(self, steps: int, size: tuple[int, int]) -> None:
        """Step the number on whose sign a mouse button is held."""
        positioned = pointed_item(self._form_layout(size), self._pixel)
        sign = 0 if positioned is None else positioned.item.held_sign(self._pixel, positioned.box, self.unit(size))
        if positioned is not None and sign:
            positioned.item.stepped(sign * steps)

    def _is_inside(self, pixel: complex) -> bool:
        """Whether a pixel is on the plate."""
        return self.area.collidepoint(pixel.real, pixel.imag)


def _pixel(event: pygame.Event, pixels_per_point: complex) -> complex:
    """The pixel of an event of the mouse."""
    return complex(event.pos[0] * pixels_per_point.real, event.pos[1] * pixels_per_point.imag)
