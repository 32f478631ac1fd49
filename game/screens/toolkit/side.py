"""Controls beside a picture, used by mouse, touch, keys and gamepad: one column of items on a plate.

The keys are the picture's until Tab gives them to the controls; Esc, or a click on the picture, takes them back. What the mouse
is on is framed as well, but gets no keys.
"""

from collections.abc import Callable, Hashable
from typing import NamedTuple

import pygame

from game.input.events import translated
from game.input.keys import Action, position_in
from game.input.repeat import Repeat
from game.input.signals import Clicked, Moved, Pressed, Released, Signal, Zoomed
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.focus import Focus, first_focus, moved_focus
from game.screens.toolkit.form import Form, pointed_spot, spot_at
from game.screens.toolkit.layout import Laid
from game.screens.toolkit.slider import FIELD_LETTERS
from game.screens.toolkit.text_entry import NUMBER_KEYS, TextEntry
from game.screens.toolkit.text_field import TextField, after_event, caret_at

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

    name: what it is known by. field: with what is typed. enter: sets it from a text; the screen to go on with.
    title: of the panel on which it is entered without a keyboard.
    """

    name: Hashable
    field: TextField
    enter: Callable[[str], Screen | None]
    title: str


class Side(Form):
    """What the sides of screens derive from: they say what is on them and where (`_laid`)."""

    entering: tuple[int, ...] = (pygame.K_TAB,)
    """Keys that give the keys to the controls."""

    def __init__(self, state: AppState, screen: Screen) -> None:
        """The side of a screen."""
        super().__init__()
        self._state, self._screen = state, screen
        self._pointer = -1 - 1j  # pixels
        self._drawn: tuple[tuple[object, ...], pygame.Surface] | None = None
        self._typing: Typing | None = None
        self._clicked_while: Typing | None = None  # what was typed when the mouse was pressed
        self._has_keys = False
        self._nearest: Focus | None = None  # where the keys begin; None for the first control
        self._mouse_held: tuple[Repeat, int] | None = None  # while the mouse is held, and how often it has acted

    @property
    def screen(self) -> Screen:
        """The one that it is on."""
        return self._screen

    @property
    def has_keys(self) -> bool:
        """Whether keys and gamepad are the controls'."""
        return self._has_keys

    @property
    def area(self) -> pygame.Rect:
        """Where its plate is, pixels."""
        raise NotImplementedError

    @property
    def looks(self) -> tuple[object, ...]:
        """All that its picture depends on, but for what has the focus."""
        raise NotImplementedError

    def release(self) -> None:
        """Give the keys back to the picture, and leave what is typed."""
        self._typing, self._focus, self._has_keys, self._held = None, None, False, None

    def hear_key(self, event: pygame.Event, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """Whether a key that went down is for the controls, and the screen to go on with. Alt with Tab is the desktop's."""
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
        """Whether what a gamepad did is for the controls, and the screen to go on with. A number is entered on a panel."""
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
        """What a finger does on the controls: it uses one where it is lifted, or scrolls. A number is entered on a panel."""
        return self._without_keyboard(self.answer(signal, size)) if self._is_inside(signal.pixel) else self._screen

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> tuple[bool, Screen | None]:
        """Whether another event is for the controls, and the screen to go on with."""
        if event.type == pygame.TEXTINPUT and self._typing is not None:
            self._typing = self._typing._replace(field=after_event(self._typing.field, event, _LONGEST))
            return True, self._screen
        if getattr(event, "touch", False) and self._is_inside(_pixel(event, pixels_per_point)):
            return True, self._screen  # what SDL makes of a finger, which is heard as such
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
        """What is held down acts again and again: a direction, or the mouse on the sign beside a number."""
        if self._mouse_held is not None and self._is_pressed:
            repeat, count = self._mouse_held
            repeat, acts = repeat.later(seconds)
            self._mouse_held = repeat, count + acts
            if acts:
                self._step_by_mouse(_STRIDE if count > _LONG else 1, size)
        return super().advance(seconds, size)

    def draw(self, surface: pygame.Surface) -> float | None:
        """The controls on their plate; where they end, pixels, or None where words about one of them stand below them.

        While nothing on it changes, the plate is shown from memory.
        """
        area, size = self.area, surface.get_size()
        laid = self._laid(size)
        focus = self._settled(laid)
        looks = (*self.looks, area, self._typing, focus, self._scroll)
        if self._drawn is None or self._drawn[0] != looks:
            theme, clip = self._state.theme, surface.get_clip()
            seen = area.clip(clip)  # nothing, in a window that is too small
            surface.set_clip(seen)
            surface.fill(theme.panel, area)
            pygame.draw.line(surface, theme.panel_edge, area.topleft, area.bottomleft)
            self.draw_items(self._state.canvas(surface)._replace(unit=self.unit(size)), laid, focus)
            surface.set_clip(clip)
            self._drawn = looks, surface.subsurface(seen).copy() if seen else pygame.Surface((0, 0))
        else:
            surface.blit(self._drawn[1], area)
        spot = spot_at(laid, focus)
        return float(laid.tip.top) if spot is None or not spot.item.tip else None

    def edit(self, typing: Typing, pixels: float | None) -> None:
        """Begin to type a number, all of it selected; or put the caret where the mouse was pressed.

        pixels: from the field's left edge to there; None by a key.
        """
        before = self._clicked_while
        if pixels is not None and before is not None and before.name == typing.name:
            letters = before.field.text, FIELD_LETTERS, self.unit((0, 0))
            typing = typing._replace(field=before.field.moved(caret_at(self._state.type, *letters, pixels)))
        self._typing, self._clicked_while = typing, None

    def _settled(self, laid: Laid) -> Focus | None:
        """What has the focus; nothing unless the mouse is on it or the keys are the controls'."""
        if self._focus is not None and spot_at(laid, self._focus) is None:
            self._focus = first_focus(laid, self._focus) if self._has_keys else None
        return self._focus

    def _hovered(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """Frame what the mouse is on."""
        if not self._has_keys:
            self._focus = None
        return super()._hovered(pixel, size)

    def _clicked(self, pixel: complex, size: tuple[int, int]) -> Screen | None:
        """A click beside the field leaves what is typed in it."""
        self._clicked_while, self._typing = self._typing, None
        return super()._clicked(pixel, size)

    def _tab(self, step: int, size: tuple[int, int]) -> None:
        """Focus the next control, or the one before; at first, beginning at the one that the mouse is on."""
        laid = self._laid(size)
        if self._focus is None:
            self._focus = first_focus(laid, self._nearest)
        else:
            self._focus = moved_focus(laid, self._focus, Action.RIGHT if step > 0 else Action.LEFT, None)
        self._has_keys = True
        self._show_focus(size)

    def _typed(self, typing: Typing, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """A key while a number is typed: Enter sets it, Tab goes on to the next one, Esc leaves it as it was."""
        if event.key in _ENTER or event.key == pygame.K_TAB:
            self._typing = None
            following = typing.enter(typing.field.text.strip())
            if event.key == pygame.K_TAB:
                self._has_keys = True
                self._tab(-1 if event.mod & pygame.KMOD_SHIFT else 1, size)
                spot = spot_at(self._laid(size), self._focus)
                if spot is not None and spot.item.is_typed:
                    spot.item.accepted(self._screen)
            return following
        self._typing = (
            None if event.key == pygame.K_ESCAPE else typing._replace(field=after_event(typing.field, event, _LONGEST))
        )
        return self._screen

    def _without_keyboard(self, following: Screen | None) -> Screen | None:
        """The screen to go on with; a panel to enter the number on that was just begun to be typed."""
        typing, self._typing = self._typing, None
        if typing is None or following is not self._screen:
            return following
        return TextEntry(
            self._state, self._screen, typing.title, typing.field.text, _LONGEST, typing.enter, letters=NUMBER_KEYS
        )

    def _step_by_mouse(self, steps: int, size: tuple[int, int]) -> None:
        """Step the number on whose sign the mouse is held."""
        spot = pointed_spot(self._laid(size), self._pixel)
        sign = 0 if spot is None else spot.item.held_sign(self._pixel, spot.box, self.unit(size))
        if spot is not None and sign:
            spot.item.stepped(sign * steps)

    def _is_inside(self, pixel: complex) -> bool:
        """Whether a pixel is on the side."""
        return self.area.collidepoint(pixel.real, pixel.imag)


def _pixel(event: pygame.Event, pixels_per_point: complex) -> complex:
    """Where an event of the mouse is."""
    return complex(event.pos[0] * pixels_per_point.real, event.pos[1] * pixels_per_point.imag)
