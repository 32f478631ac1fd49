"""The side of the window, made of pygame_gui's widgets: the list of scenes, sliders with fields, check boxes, buttons."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame
import pygame_gui
from pygame_gui.elements import UIButton, UICheckBox, UIDropDownMenu, UIHorizontalSlider, UITextEntryLine

from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.key_names import code_names
from game.lab.kit.parameters import Count, Parameter, Point, plain, snapped, written
from game.lab.kit.picture import Toggle
from game.lab.registry import scenes
from game.lab.session.commands import Command
from game.lab.session.session import PACES, Session
from game.lab.window.commands import KEYS, TOGGLE_KEYS
from game.lab.window.layout import WindowLayout
from game.lab.window.widget_theme import widget_theme

_PRESETS = "presets"
_HEIGHT, _GAP = 1.75, 0.3
"""Height of a row and of the gap between rows, in units, the size of body text."""
_NAME, _NUMBER, _BOX = 1.25, 1.5, 1.25
"""Heights of a parameter's name, of a slider, of a check box, in units."""
_SMALL_PRINT = 5.0
"""Room for the small print below the widgets, in units."""
_MOST_PAGES = 6
"""In a window so small that even these do not fit, the rest is cut off."""
_TIGHTEST = 0.7
"""In a low window all rows are made lower, down to this share of their heights."""


class ValueRequested(NamedTuple):
    """A value was typed, or a slider was moved to it. name: of the parameter."""

    name: str
    value: complex


class Refused(NamedTuple):
    """What was typed is no number. note: a sentence that says so."""

    note: str


class SceneChosen(NamedTuple):
    """A scene was chosen from the list. name: of the scene."""

    name: str


class PresetChosen(NamedTuple):
    """A preset was chosen. line: its values, as in `Preset.line`."""

    line: str


class PageTurned(NamedTuple):
    """The next page of parameters is asked for."""


Request = ValueRequested | Refused | SceneChosen | PresetChosen | PageTurned | Toggle | Command


class _Row(NamedTuple):
    """The slider and the field of one number: a parameter's own, or one coordinate of it.

    coordinate: 0 for a number, or for the x of a point; 1 for its y.
    """

    parameter: Parameter
    coordinate: int
    slider: UIHorizontalSlider
    field: UITextEntryLine


class Side:
    """The widgets of one scene, for one size and theme of the window."""

    def __init__(self, layout: WindowLayout, theme: Theme, type_: Type, session: Session, page: int = 0) -> None:
        """Build them for a division of the window. page: of the parameters, where they are too many for one; taken round."""
        area, unit = layout.side, layout.unit
        self._area, self._unit, self._theme, self._type = area, unit, theme, type_
        self._manager = pygame_gui.UIManager(layout.size, widget_theme(theme, round(unit)), enable_live_theme_updates=False)
        self._top = area.top + unit * 0.6
        self._commands: dict[UIButton, Command] = {}
        self._boxes: dict[UICheckBox, Toggle] = {}
        self._shown: frozenset[Toggle] = frozenset()
        self._presets = {preset.label: preset.line for preset in session.scene.presets}
        pages = _pages(session, area.height / unit)
        parameters = pages[page % len(pages)]
        self._squeeze = _squeeze(session, parameters, area.height / unit, paged=len(pages) > 1)
        self._page: UIButton | None = None
        self._names: list[tuple[Parameter, pygame.Rect]] = []
        self._list, self._preset_list = self._lists(session)
        self._rows = [row for parameter in parameters for row in self._parameter(parameter)]
        if len(pages) > 1:
            text = f"page {page % len(pages) + 1} of {len(pages)}: more values"
            self._page = UIButton(self._line(), text, self._manager, tool_tip_text="the next page of values (Tab)")
        self._clock: pygame.Rect | None = None
        self._play: UIButton | None = None
        if session.runs:
            self._time()
        self._toggles()
        self._buttons()

    @property
    def bottom(self) -> float:
        """Where the widgets end, pixels."""
        return self._top

    @property
    def busy(self) -> bool:
        """Whether keys belong to the widgets: a field is typed into, or a list is open."""
        return self._is_open or any([row.field.is_focused for row in self._rows])

    @property
    def _is_open(self) -> bool:
        """Whether a list is open, which may cover sliders."""
        lists = [one for one in (self._list, self._preset_list) if one is not None]
        return any([one.current_state is one.menu_states["expanded"] for one in lists])

    def hear(self, event: pygame.Event) -> tuple[bool, Request | None]:
        """Whether the widgets took an event for themselves, and what it asks for."""
        pressed = event.type == pygame.MOUSEBUTTONDOWN and event.button == pygame.BUTTON_LEFT
        moved = self._beside_a_knob(event) if pressed else None
        taken = self._manager.process_events(event)
        if moved is not None:
            return True, self._slid(moved)
        match event.type:
            case pygame_gui.UI_HORIZONTAL_SLIDER_MOVED:
                return True, self._slid(event.ui_element)
            case pygame_gui.UI_TEXT_ENTRY_FINISHED:
                return True, self._typed(event.ui_element)
            case pygame_gui.UI_DROP_DOWN_MENU_CHANGED:
                return True, self._picked(event)
            case pygame_gui.UI_BUTTON_PRESSED:
                return True, PageTurned() if event.ui_element is self._page else self._commands.get(event.ui_element)
        return taken, self._ticked()

    def release_focus(self) -> None:
        """Take the keyboard away from the fields, and close a list that is open."""
        self._manager.set_focus_set(None)

    def show(self, session: Session, shown: frozenset[Toggle], available: frozenset[Toggle]) -> None:
        """Give every widget the value that the scene has. shown: toggles that are on; available: toggles of its marks."""
        self._shown = shown
        for row in self._rows:
            value = session.given.values[row.parameter.name]
            number = value.imag if row.coordinate else value.real
            if not row.field.is_focused and row.field.get_text() != plain(number):
                row.field.set_text(plain(number))
            if not row.slider.grabbed_slider and row.slider.current_value != number:
                row.slider.set_current_value(number, warn=False)
        for box, toggle in self._boxes.items():
            _set_box(box, on=toggle in shown, enabled=toggle in available)
        if self._play is not None:
            self._play.set_text("Pause" if session.playing else "Play")

    def draw(self, surface: pygame.Surface, session: Session, seconds: float, pixels_per_point: complex) -> None:
        """Draw the widgets after some seconds, and each parameter's value and meaning above its sliders."""
        for parameter, box in self._names:
            value = f"{parameter.label} = {written(parameter, session.given.values[parameter.name])}"
            left = complex(box.left, box.centery)
            after = self._type.write(surface, value, self._unit * 0.95, self._theme.text, left, "midleft")
            meaning, end = complex(after.right + self._unit * 0.7, box.centery), float(box.right)
            words = self._type.wrapped(parameter.meaning, self._unit * 0.95, end - meaning.real)[:1]
            self._type.write(surface, "".join(words), self._unit * 0.95, self._theme.faint, meaning, "midleft")
        if self._clock is not None:
            middle = complex(*self._clock.center)
            self._type.write(surface, _clock(session), self._unit * 0.95, self._theme.text, middle, "center")
        self._manager.mouse_pos_scale_factor = [pixels_per_point.real, pixels_per_point.imag]
        self._manager.update(seconds)
        self._manager.draw_ui(surface)

    def _lists(self, session: Session) -> tuple[UIDropDownMenu, UIDropDownMenu | None]:
        """The list of scenes between its two buttons, and the list of presets."""
        before, middle, after = self._split(self._line(), (2.0, 0.0, 2.0))
        self._button(before, Command.PREVIOUS)
        self._button(after, Command.NEXT)
        names: list[str | tuple[str, str]] = [scene.name for scene in scenes()]
        listed = UIDropDownMenu(names, session.scene.name, middle, self._manager)
        if not self._presets:
            return listed, None
        labels: list[str | tuple[str, str]] = [_PRESETS, *self._presets]
        return listed, UIDropDownMenu(labels, _PRESETS, self._line(), self._manager)

    def _parameter(self, parameter: Parameter) -> list[_Row]:
        """A parameter's name and meaning, and a slider with a field for each of its numbers."""
        self._names.append((parameter, self._line(_NAME, 0.0)))
        return [self._number(parameter, coordinate) for coordinate in range(2 if isinstance(parameter, Point) else 1)]

    def _number(self, parameter: Parameter, coordinate: int) -> _Row:
        """One slider and its field."""
        default = parameter.default.imag if coordinate else parameter.default.real
        left, right = self._split(self._line(_NUMBER), (0.0, 6.0))
        span = (float(parameter.low), float(parameter.high))
        slider = UIHorizontalSlider(left, default, span, self._manager)
        field = UITextEntryLine(right, self._manager, initial_text=plain(default))
        field.set_text_length_limit(32)
        return _Row(parameter, coordinate, slider, field)

    def _time(self) -> None:
        """The buttons to run, to step and to restart; below them the clock between those for slower and faster."""
        for command, box in zip(
            (Command.BACK, Command.PLAY, Command.FORWARD, Command.RESTART), self._split(self._line(), (0.0,) * 4), strict=True
        ):
            button = self._button(box, command)
            if command is Command.PLAY:
                self._play = button
        slower, self._clock, faster = self._split(self._line(), (2.0, 0.0, 2.0))
        self._button(slower, Command.SLOWER)
        self._button(faster, Command.FASTER)

    def _toggles(self) -> None:
        """A box for each kind of mark, two in a row."""
        toggles = list(Toggle)
        self._top += self._unit * _GAP
        for first in range(0, len(toggles), 2):
            for toggle, area in zip(toggles[first : first + 2], self._split(self._line(_BOX, 0.2), (0.0, 0.0)), strict=False):
                box = pygame.Rect(area.left, area.top, area.height, area.height)
                key = next(pygame.key.name(key) for key, found in TOGGLE_KEYS.items() if found is toggle)
                self._boxes[UICheckBox(box, f"{key}  {toggle.value}", self._manager)] = toggle  # empty, as _shown is

    def _buttons(self) -> None:
        """The buttons for everything else."""
        self._top += self._unit * _GAP
        for commands in (
            (Command.REVEAL, Command.PREDICT, Command.COURSE, Command.PRESENT),
            (Command.DEFAULTS, Command.WHOLE, Command.COPY),
            (Command.SAVE, Command.THEME, Command.HELP),
        ):
            for command, box in zip(commands, self._split(self._line(), (0.0,) * len(commands)), strict=True):
                self._button(box, command)

    def _button(self, box: pygame.Rect, command: Command) -> UIButton:
        """A button, with a tool tip that names its key."""
        binding = next(one for one in KEYS if one.command is command)
        button = UIButton(
            box, command.value, self._manager, tool_tip_text=f"{binding.meaning} ({'  '.join(code_names(binding.keys))})"
        )
        self._commands[button] = command
        return button

    def _slid(self, slider: UIHorizontalSlider) -> Request | None:
        """The value that a slider was moved to, rounded to the parameter's step."""
        row = next((row for row in self._rows if row.slider is slider), None)
        if row is None:
            return None
        name, value = row.parameter.name, self._whole_value(row, float(slider.current_value))
        return ValueRequested(name, snapped((row.parameter,), {name: value})[name])

    def _beside_a_knob(self, event: pygame.Event) -> UIHorizontalSlider | None:
        """The slider that was pressed beside its knob. The knob is moved to the pointer, so that the press takes hold of it."""
        pixel = self._manager.calculate_scaled_mouse_position(event.pos)
        slider = next((row.slider for row in self._rows if row.slider.hover_point(*pixel)), None)
        if slider is None or slider.sliding_button is None or self._is_open or slider.sliding_button.rect.collidepoint(pixel):
            return None
        half, (low, high) = slider.sliding_button.rect.width / 2.0, slider.value_range
        share = (pixel[0] - slider.rect.left - half) / max(slider.rect.width - 2.0 * half, 1.0)
        slider.set_current_value(low + share * (high - low), warn=False)
        return slider

    def _typed(self, field: UITextEntryLine) -> Request | None:
        """The number that was typed."""
        row = next((row for row in self._rows if row.field is field), None)
        if row is None:
            return None
        self.release_focus()
        text = field.get_text().strip().removesuffix("°")
        try:
            number = float(text)
        except ValueError:
            return Refused(f"{row.parameter.label}: {text!r} is not a number")
        return ValueRequested(row.parameter.name, self._whole_value(row, number))

    def _whole_value(self, row: _Row, number: float) -> complex:
        """The parameter's value with this number: a point's other coordinate is taken from its own slider."""
        if not isinstance(row.parameter, Point):
            return float(round(number)) if isinstance(row.parameter, Count) and row.slider.grabbed_slider else number
        other = next(one for one in self._rows if one.parameter is row.parameter and one.coordinate != row.coordinate)
        rest = float(other.slider.current_value)
        return complex(rest, number) if row.coordinate else complex(number, rest)

    def _ticked(self) -> Request | None:
        """The toggle whose check box was clicked.

        The boxes themselves are asked, since pygame_gui sends its events for changes that `show` makes, too.
        """
        for box, toggle in self._boxes.items():
            if box.get_state() is not (toggle in self._shown):
                self._shown = self._shown ^ {toggle}  # reported once, however many events come before the next picture
                return toggle
        return None

    def _picked(self, event: pygame.Event) -> Request | None:
        """A scene or a preset from its list."""
        if event.ui_element is self._list:
            return SceneChosen(event.text)
        line = self._presets.get(event.text)
        return None if line is None else PresetChosen(line)

    def _line(self, height: float = _HEIGHT, gap: float = _GAP) -> pygame.Rect:
        """The next row, across the whole side."""
        edge, size = self._unit * 0.8, self._unit * self._squeeze
        box = pygame.Rect(
            round(self._area.left + edge), round(self._top), round(self._area.width - 2 * edge), round(size * height)
        )
        self._top += size * (height + gap)
        return box

    def _split(self, box: pygame.Rect, widths: tuple[float, ...]) -> list[pygame.Rect]:
        """A row divided into boxes. widths: in units; 0 for an equal share of what is left."""
        gap = self._unit * _GAP
        fixed = sum([width * self._unit for width in widths])
        share = (box.width - fixed - gap * (len(widths) - 1)) / max(widths.count(0.0), 1)
        boxes, left = [], float(box.left)
        for width in widths:
            pixels = width * self._unit if width else share
            boxes.append(pygame.Rect(round(left), box.top, round(pixels), box.height))
            left += pixels + gap
        return boxes


def _clock(session: Session) -> str:
    """The tick that is shown, and how fast the scene runs."""
    pace = PACES[session.pace]
    return f"tick {session.tick} of {session.last}, {'real' if pace == 1.0 else f'1/{round(1 / pace)}'} time"


def _squeeze(session: Session, parameters: Sequence[Parameter], room: float, *, paged: bool) -> float:
    """The share of their heights with which all rows fit into the side. room: the side's height, in units."""
    return min(max((room - _SMALL_PRINT) / _height(session, parameters, paged=paged), _TIGHTEST), 1.0)


def _pages(session: Session, room: float) -> list[tuple[Parameter, ...]]:
    """The parameters on as few pages as fit into the side, each with about as many."""
    parameters = session.scene.parameters
    for count in range(1, len(parameters) + 1):
        size = -(-len(parameters) // count)
        pages = [parameters[first : first + size] for first in range(0, len(parameters), size)]
        heights = [_height(session, page, paged=count > 1) * _TIGHTEST for page in pages]
        if max(heights, default=0.0) <= room - _SMALL_PRINT or count >= _MOST_PAGES:
            return pages
    return [parameters]


def _height(session: Session, parameters: Sequence[Parameter], *, paged: bool) -> float:
    """Of all rows at their full heights, in units."""
    row = _HEIGHT + _GAP
    numbers = [2 if isinstance(parameter, Point) else 1 for parameter in parameters]
    rows = row * (5 + (1 if session.scene.presets else 0) + (2 if session.runs else 0) + (1 if paged else 0))
    sliders = _NAME * len(numbers) + (_NUMBER + _GAP) * sum(numbers)
    toggles = (_BOX + 0.2) * (len(Toggle) + 1) // 2
    return rows + sliders + toggles + 2 * _GAP


def _set_box(box: UICheckBox, *, on: bool, enabled: bool) -> None:
    """Give a check box its state."""
    if box.get_state() is not on:
        box.set_state(on)
    if enabled != box.is_enabled:
        change = box.enable if enabled else box.disable
        change()  # type: ignore[no-untyped-call]  # pygame_gui leaves these two without types
