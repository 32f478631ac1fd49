"""The side of the lab's window: its controls, used by mouse, touch, keys and gamepad.

The keys are the scene's until Tab, or an arrow up or down, gives them to the controls; Esc, or a click on the picture, takes
them back. What the mouse is on is framed as well, but gets no keys.
"""

from collections.abc import Callable

import pygame

from game.input.events import translated
from game.input.keys import Action, position_in
from game.input.signals import Clicked, Moved, Pressed, Released, Signal, Zoomed
from game.lab.kit.parameters import defaults
from game.lab.session.share import SharedScene, share_line
from game.lab.window.controls import (
    Component,
    Controlled,
    NumberRefused,
    PresetChosen,
    Reactions,
    Request,
    SceneChosen,
    Typing,
    controls,
    preset_options,
    scene_options,
)
from game.lab.window.layout import WindowLayout
from game.lab.window.words import small_print_height
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.drop_down import Option, OptionList, Options
from game.screens.toolkit.focus import Focus, first_focus, moved_focus
from game.screens.toolkit.form import Form, spot_at
from game.screens.toolkit.layout import Laid, laid_in_column
from game.screens.toolkit.slider import FIELD_LETTERS, FieldSlider
from game.screens.toolkit.text_field import TextField, after_event, caret_at

_LETTERS = 0.87
"""The toolkit's unit in the lab's: what items are called is about as large as body text then."""
_TOP, _LEAST_SMALL_PRINT = 0.6, 5.0
"""From the window's edge to the controls, and the least room for the small print below them, in the lab's units."""
_NARROW = 19.0
"""A side that is narrower has fewer controls in a row, in the toolkit's units."""
_LONGEST = 32
"""Characters that can be typed into a field."""
_STRIDE = 10
"""Steps that an arrow key moves a slider by with Shift."""
_ARROWS = {pygame.K_LEFT: Action.LEFT, pygame.K_RIGHT: Action.RIGHT, pygame.K_UP: Action.UP, pygame.K_DOWN: Action.DOWN}
MODIFIERS = pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META
"""Keys pressed together with one of these belong to the desktop."""
_ENTERING = (pygame.K_TAB, pygame.K_UP, pygame.K_DOWN)
"""They give the keys to the controls."""
_ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


class LabSide(Form):
    """The controls of the scene that is shown."""

    def __init__(
        self,
        state: AppState,
        screen: Screen,
        ask: Callable[[Request], Screen | None],
        layout: WindowLayout,
        seen: Controlled,
    ) -> None:
        """The side of a screen. ask: does what a control asks for; the screen to go on with. layout, seen: as in `show`."""
        super().__init__()
        self._state, self._screen, self._ask = state, screen, ask
        self._do = Reactions(ask, self._edit, self._scenes, self._presets)
        self._layout, self._seen = layout, seen
        self._small_print = self._small_print_height()
        self._pointer = -1 - 1j  # pixels
        self._drawn: tuple[tuple[object, ...], pygame.Surface] | None = None
        self._typing: Typing | None = None
        self._clicked_while: Typing | None = None  # what was typed when the mouse was pressed
        self._has_keys = False

    @property
    def screen(self) -> Screen:
        """The lab."""
        return self._screen

    def show(self, layout: WindowLayout, seen: Controlled) -> None:
        """Let the controls be those of a scene as it stands, in a window that is so divided."""
        if self._seen.session.scene is not seen.session.scene:
            self._typing, self._scroll = None, 0.0
        is_new = self._seen.session.scene is not seen.session.scene or self._layout != layout
        self._layout, self._seen = layout, seen
        if is_new:
            self._small_print = self._small_print_height()

    def release(self) -> None:
        """Give the keys back to the scene, and leave what is typed."""
        self._typing, self._focus, self._has_keys, self._held = None, None, False, None

    def hear_key(self, event: pygame.Event, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """Whether a key that went down is for the controls, and the screen to go on with. Alt with Tab is the desktop's."""
        if self._typing is not None:
            return True, self._screen if event.mod & pygame.KMOD_ALT else self._typed(self._typing, event, size)
        if event.mod & MODIFIERS or not (self._has_keys or event.key in _ENTERING):
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
        """Whether what a gamepad did is for the controls, and the screen to go on with. Nothing can be typed with it."""
        spot = spot_at(self._laid(size), self._focus)
        match signal:
            case Pressed(Action.TIP):
                self._typing = None
                self._tab(1, size)
            case Pressed(Action.UP | Action.DOWN) if not self._has_keys:
                self._tab(1, size)
            case Pressed() if not self._has_keys:
                return False, self._screen
            case Pressed(Action.BACK):
                self.release()
            case Pressed(Action.LEFT | Action.RIGHT | Action.UP | Action.DOWN):
                self._stride, self._typing = 1, None
                return True, self.answer(signal, size)
            case Pressed(Action.SERVE | Action.CONFIRM):
                is_number = spot is not None and isinstance(spot.item, FieldSlider)
                return True, self._screen if is_number else self.answer(signal, size)
            case Released():
                return True, self.answer(signal, size)
            case _:
                return False, self._screen
        return True, self._screen

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> tuple[bool, Screen | None]:
        """Whether another event is for the controls, and the screen to go on with."""
        if event.type == pygame.TEXTINPUT and self._typing is not None:
            self._typing = self._typing._replace(field=after_event(self._typing.field, event, _LONGEST))
            return True, self._screen
        if event.type == pygame.MOUSEBUTTONUP:
            self._is_pressed = False
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
            case Zoomed():
                taken = self._is_inside(self._pointer)
            case _:
                taken = False
        return taken, self.answer(signal, size) if taken and signal is not None else self._screen

    def draw(self, surface: pygame.Surface) -> float | None:
        """The controls on their plate; where they end, pixels, or None where words about one of them stand below them.

        While nothing on it changes, the plate is shown from memory.
        """
        area, size = self._layout.side, surface.get_size()
        laid = self._laid(size)
        focus = self._settled(laid)
        looks = self._looks(focus)
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

    def _looks(self, focus: Focus | None) -> tuple[object, ...]:
        """All that its picture depends on."""
        session, shown, available, _ = self._seen
        state = session.scene.name, session.given.values, session.tick, session.playing, session.pace
        return (self._state.appearance, self._layout, state, shown, available, self._typing, focus, self._scroll)

    def unit(self, _size: tuple[int, int]) -> float:
        """Size of the toolkit's text, pixels."""
        return self._layout.unit * _LETTERS * self._state.text_scale

    def _laid(self, size: tuple[int, int]) -> Laid:
        """The controls below each other."""
        unit, area = self._layout.unit, self._layout.side.copy()
        area.top += round(unit * _TOP)
        area.height -= round(unit * _TOP + self._small_print)
        letters = self.unit(size)
        rows = controls(self._seen._replace(typing=self._typing), self._do, narrow=area.width < _NARROW * letters)
        laid = laid_in_column(rows, area, self._state.type, letters, self._scroll)
        self._scroll = min(self._scroll, float(laid.over))
        return laid

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
            self._focus = first_focus(laid)
        else:
            self._focus = moved_focus(laid, self._focus, Action.RIGHT if step > 0 else Action.LEFT, None)
        self._has_keys = True
        self._show_focus(size)

    def _edit(self, component: Component, pixels: float | None) -> None:
        """Begin to type a number, all of it selected; or put the caret where the mouse was pressed."""
        before, field = self._clicked_while, TextField.all_of(component.text(self._seen.session))
        if pixels is not None and before is not None and before.component == component:
            letters = before.field.text, FIELD_LETTERS, self.unit((0, 0))
            field = before.field.moved(caret_at(self._state.type, *letters, pixels))
        self._typing, self._clicked_while = Typing(component, field), None

    def _typed(self, typing: Typing, event: pygame.Event, size: tuple[int, int]) -> Screen | None:
        """A key while a number is typed: Enter sets it, Tab goes on to the next one, Esc leaves it as it was."""
        if event.key in _ENTER or event.key == pygame.K_TAB:
            self._typing = None
            following = self._set(typing)
            if event.key == pygame.K_TAB:
                self._has_keys = True
                self._tab(-1 if event.mod & pygame.KMOD_SHIFT else 1, size)
                spot = spot_at(self._laid(size), self._focus)
                if spot is not None and isinstance(spot.item, FieldSlider):
                    spot.item.edit(None)
            return following
        self._typing = (
            None if event.key == pygame.K_ESCAPE else typing._replace(field=after_event(typing.field, event, _LONGEST))
        )
        return self._screen

    def _set(self, typing: Typing) -> Screen | None:
        """Ask for the number that was typed."""
        text = typing.field.text.strip().removesuffix("°")
        try:
            number = float(text)
        except ValueError:
            return self._ask(NumberRefused(f"{typing.component.parameter.label}: {text!r} is not a number"))
        return self._ask(typing.component.requested(self._seen.session, number))

    def _small_print_height(self) -> float:
        """Room for the state hash, for the share line at the defaults, and for a line more."""
        scene = self._seen.session.scene
        lines = "state hash", share_line(SharedScene(scene, defaults(scene.parameters))), "-"
        return max(small_print_height(self._state.type, self._layout, lines), self._layout.unit * _LEAST_SMALL_PRINT)

    def _is_inside(self, pixel: complex) -> bool:
        """Whether a pixel is on the side."""
        return self._layout.side.collidepoint(pixel.real, pixel.imag)

    def _scenes(self) -> Screen | None:
        """The list of all scenes."""
        present = self._seen.session.scene.name
        return self._opened("Scenes", scene_options(), present, lambda option: self._ask(SceneChosen(option.name)))

    def _presets(self) -> Screen | None:
        """The list of the scene's presets."""
        options = preset_options(self._seen.session)
        return self._opened("Presets", options, "", lambda option: self._ask(PresetChosen(option.note)))

    def _opened(self, title: str, options: Options, present: str, choose: Callable[[Option], Screen | None]) -> Screen:
        """A list over the lab. Where it was opened by the mouse, that will be elsewhere when it is left."""
        if not self._has_keys:
            self._focus = None
        return OptionList(self._state, self._screen, title, options, present, choose)
