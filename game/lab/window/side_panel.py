"""The side panel of the lab: its controls, used by mouse, touch, keys and gamepad."""

from collections.abc import Callable

import pygame

from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.lab.kit.parameters import defaults
from game.lab.session.share import SharedScene, share_line
from game.lab.window.controls import (
    Component,
    LabCallbacks,
    LabControls,
    NumberRefused,
    PresetChosen,
    Request,
    SceneChosen,
    controls,
    preset_options,
    scene_options,
)
from game.lab.window.layout import WindowLayout
from game.lab.window.words import small_print_height
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items.drop_down import Option, OptionList, Options
from game.screens.toolkit.items.text_field import TextField
from game.screens.toolkit.layout import FormLayout, column_layout
from game.screens.toolkit.side_panel import SidePanel, Typing

_LETTERS = 0.87
"""The toolkit's unit in the lab's: what items are called is about as large as body text then."""
_TOP, _LEAST_SMALL_PRINT = 0.6, 5.0
"""From the window's edge to the controls, and the least room for the small print below them, in the lab's units."""
_NARROW = 19.0
"""A side that is narrower has fewer controls in a row, in the toolkit's units."""


class LabSidePanel(SidePanel):
    """The controls of the shown scene. Arrow up and arrow down give them the keys, as Tab does."""

    entering = (pygame.K_TAB, pygame.K_UP, pygame.K_DOWN)

    def __init__(
        self,
        state: AppState,
        screen: Screen,
        ask: Callable[[Request], Screen | None],
        layout: WindowLayout,
        seen: LabControls,
    ) -> None:
        """The side panel of a screen. ask: does what a control asks for; the next screen. layout, seen: as in `show`."""
        super().__init__(state, screen)
        self._ask = ask
        self._callbacks = LabCallbacks(ask, self._edit, self._scenes, self._presets)
        self._layout, self._seen = layout, seen
        self._small_print = self._small_print_height()

    @property
    def area(self) -> pygame.Rect:
        """The right side of the window."""
        return self._layout.side

    @property
    def appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on, except the focus."""
        session, shown, available, _ = self._seen
        state = session.scene.name, session.given.values, session.tick, session.playing, session.pace
        return self._state.appearance, self._layout, state, shown, available

    def show(self, layout: WindowLayout, seen: LabControls) -> None:
        """Let the controls be those of a scene as it stands, in a window that is so divided."""
        is_other = self._seen.session.scene is not seen.session.scene
        if is_other:
            self._typing, self._scroll = None, 0.0
        is_new = is_other or self._layout != layout
        self._layout, self._seen = layout, seen
        if is_new:
            self._small_print = self._small_print_height()

    def hear_pad(self, signal: Signal, size: tuple[int, int]) -> tuple[bool, Screen | None]:
        """React to a gamepad. Returns whether the signal acted on the controls, and the next screen."""
        if isinstance(signal, Pressed) and signal.action in (Action.UP, Action.DOWN) and not self._has_keys:
            self._tab(1, size)
            return True, self._screen
        return super().hear_pad(signal, size)

    def unit(self, _size: tuple[int, int]) -> float:
        """Size of the toolkit's text, pixels."""
        return self._layout.unit * _LETTERS * self._state.text_scale

    def _form_layout(self, size: tuple[int, int]) -> FormLayout:
        """The controls below each other."""
        unit, area = self._layout.unit, self._layout.side.copy()
        area.top += round(unit * _TOP)
        area.height -= round(unit * _TOP + self._small_print)
        letters = self.unit(size)
        rows = controls(self._seen._replace(typing=self._typing), self._callbacks, narrow=area.width < _NARROW * letters)
        layout = column_layout(rows, area, self._state.type, letters, self._scroll)
        self._scroll = min(self._scroll, float(layout.over))
        return layout

    def _edit(self, component: Component, pixels: float | None) -> None:
        """Begin to type a number, or put the caret at a distance from the field's left edge, pixels."""
        field = TextField.all_of(component.text(self._seen.session))
        self.edit(Typing(component, field, lambda text: self._set(component, text), component.parameter.meaning), pixels)

    def _set(self, component: Component, text: str) -> Screen | None:
        """Ask for the number that was typed."""
        text = text.removesuffix("°")
        try:
            number = float(text)
        except ValueError:
            return self._ask(NumberRefused(f"{component.parameter.label}: {text!r} is not a number"))
        return self._ask(component.requested(self._seen.session, number))

    def _small_print_height(self) -> float:
        """Room for the state hash, for the share line at the defaults, and for a line more."""
        scene = self._seen.session.scene
        lines = "state hash", share_line(SharedScene(scene, defaults(scene.parameters))), "-"
        return max(small_print_height(self._state.type, self._layout, lines), self._layout.unit * _LEAST_SMALL_PRINT)

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
