"""The side of the window: the list of scenes, sliders with their numbers, check boxes, buttons. All of them pygame_gui's."""

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
from game.lab.session.session import PACES, Session
from game.lab.window.commands import KEYS, TOGGLE_KEYS, Command
from game.lab.window.page import Page
from game.lab.window.skin import skin

_PRESETS = "presets"
_HEIGHT, _GAP = 1.75, 0.3
"""Of a row, and between rows, in sizes of text."""
_NAME, _NUMBER, _BOX = 1.25, 1.5, 1.25
"""Heights of a parameter's name, of a slider, of a check box."""
_PRINT = 5.0
"""Room for the small print below."""
_TIGHTEST = 0.7
"""The least share of these heights."""


class Wished(NamedTuple):
    """A value was typed or slid to."""

    name: str
    value: complex


class Refused(NamedTuple):
    """What was typed is no number."""

    note: str


class Chosen(NamedTuple):
    """A scene was chosen from the list."""

    name: str


class Preset(NamedTuple):
    """A preset was chosen."""

    line: str


Asked = Wished | Refused | Chosen | Preset | Toggle | Command


class _Row(NamedTuple):
    """The slider and the field of one number: a parameter's own, or one coordinate of it."""

    parameter: Parameter
    part: int  # 1 for the second coordinate
    slider: UIHorizontalSlider
    field: UITextEntryLine


class Side:
    """The widgets of one scene, for one size and theme of the window."""

    def __init__(self, place: Page, theme: Theme, type_: Type, session: Session) -> None:
        """Build them. place: the window's division."""
        area, unit = place.side, place.unit
        self._area, self._unit, self._theme, self._type = area, unit, theme, type_
        self._manager = pygame_gui.UIManager(place.size, skin(theme, round(unit)), enable_live_theme_updates=False)
        self._top = area.top + unit * 0.6
        self._commands: dict[UIButton, Command] = {}
        self._boxes: dict[UICheckBox, Toggle] = {}
        self._shown: frozenset[Toggle] = frozenset()
        self._presets = {preset.label: preset.line for preset in session.scene.presets}
        self._squeeze = _squeeze(session, area.height / unit)
        self._names: list[tuple[Parameter, pygame.Rect]] = []
        self._list, self._preset_list = self._lists(session)
        self._rows = [row for parameter in session.scene.parameters for row in self._parameter(parameter)]
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

    def hear(self, event: pygame.Event) -> tuple[bool, Asked | None]:
        """Whether the widgets took an event for themselves, and what was asked for by it."""
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
                return True, self._commands.get(event.ui_element)
        return taken, self._ticked()

    def let_go(self) -> None:
        """Take the keys away from the fields, and close what is open."""
        self._manager.set_focus_set(None)

    def show(self, session: Session, shown: frozenset[Toggle], available: frozenset[Toggle]) -> None:
        """Bring every widget in line with how the scene stands."""
        self._shown = shown
        for row in self._rows:
            value = session.given.values[row.parameter.name]
            number = value.imag if row.part else value.real
            if not row.field.is_focused and row.field.get_text() != plain(number):
                row.field.set_text(plain(number))
            if not row.slider.grabbed_slider and row.slider.current_value != number:
                row.slider.set_current_value(number, warn=False)
        for box, toggle in self._boxes.items():
            _set_box(box, on=toggle in shown, enabled=toggle in available)
        if self._play is not None:
            self._play.set_text("Pause" if session.playing else "Play")

    def draw(self, surface: pygame.Surface, session: Session, seconds: float, pixels_per_point: complex) -> None:
        """Let the widgets live for a while, and draw them, each parameter's value and meaning above its sliders."""
        for parameter, box in self._names:
            value = f"{parameter.label} = {written(parameter, session.given.values[parameter.name])}"
            place = complex(box.left, box.centery)
            after = self._type.write(surface, value, self._unit * 0.95, self._theme.text, place, "midleft")
            meaning, end = complex(after.right + self._unit * 0.7, box.centery), float(box.right)
            words = self._type.wrapped(parameter.meaning, self._unit * 0.95, end - meaning.real)[:1]
            self._type.write(surface, "".join(words), self._unit * 0.95, self._theme.faint, meaning, "midleft")
        if self._clock is not None:
            place = complex(*self._clock.center)
            self._type.write(surface, _clock(session), self._unit * 0.95, self._theme.text, place, "center")
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
        return [self._number(parameter, part) for part in range(2 if isinstance(parameter, Point) else 1)]

    def _number(self, parameter: Parameter, part: int) -> _Row:
        """One slider and its field."""
        default = parameter.default.imag if part else parameter.default.real
        left, right = self._split(self._line(_NUMBER), (0.0, 6.0))
        span = (float(parameter.low), float(parameter.high))
        slider = UIHorizontalSlider(left, default, span, self._manager)
        field = UITextEntryLine(right, self._manager, initial_text=plain(default))
        field.set_text_length_limit(32)
        return _Row(parameter, part, slider, field)

    def _time(self) -> None:
        """Run, step, slow motion."""
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
        """What else can be asked for."""
        self._top += self._unit * _GAP
        for commands in (
            (Command.DEFAULTS, Command.VIEW, Command.COPY),
            (Command.SAVE, Command.THEME, Command.HELP),
        ):
            for command, box in zip(commands, self._split(self._line(), (0.0,) * 3), strict=True):
                self._button(box, command)

    def _button(self, box: pygame.Rect, command: Command) -> UIButton:
        """A button, and its key on its tip."""
        keys = next(one for one in KEYS if one.command is command)
        button = UIButton(
            box, command.value, self._manager, tool_tip_text=f"{keys.meaning} ({'  '.join(code_names(keys.keys))})"
        )
        self._commands[button] = command
        return button

    def _slid(self, slider: UIHorizontalSlider) -> Asked | None:
        """The value that a slider was moved to, rounded to the parameter's step."""
        row = next((row for row in self._rows if row.slider is slider), None)
        if row is None:
            return None
        wish = self._with_part(row, float(slider.current_value))
        return Wished(row.parameter.name, snapped((row.parameter,), {row.parameter.name: wish})[row.parameter.name])

    def _beside_a_knob(self, event: pygame.Event) -> UIHorizontalSlider | None:
        """The slider that was pressed beside its knob; the knob has come to that place, so that the press takes hold of it."""
        place = self._manager.calculate_scaled_mouse_position(event.pos)
        slider = next((row.slider for row in self._rows if row.slider.hover_point(*place)), None)
        if slider is None or slider.sliding_button is None or self._is_open or slider.sliding_button.rect.collidepoint(place):
            return None
        half, (low, high) = slider.sliding_button.rect.width / 2.0, slider.value_range
        share = (place[0] - slider.rect.left - half) / max(slider.rect.width - 2.0 * half, 1.0)
        slider.set_current_value(low + share * (high - low), warn=False)
        return slider

    def _typed(self, field: UITextEntryLine) -> Asked | None:
        """The number that was typed."""
        row = next((row for row in self._rows if row.field is field), None)
        if row is None:
            return None
        self.let_go()
        text = field.get_text().strip().removesuffix("°")
        try:
            number = float(text)
        except ValueError:
            return Refused(f"{row.parameter.label}: {text!r} is not a number")
        return Wished(row.parameter.name, self._with_part(row, number))

    def _with_part(self, row: _Row, number: float) -> complex:
        """A number as a value of its parameter: of a point, the other coordinate comes from its own slider."""
        if not isinstance(row.parameter, Point):
            return float(round(number)) if isinstance(row.parameter, Count) and row.slider.grabbed_slider else number
        other = next(one for one in self._rows if one.parameter is row.parameter and one.part != row.part)
        rest = float(other.slider.current_value)
        return complex(rest, number) if row.part else complex(number, rest)

    def _ticked(self) -> Asked | None:
        """The toggle whose box a hand has changed. pygame_gui's events tell of changes that `show` makes, too."""
        for box, toggle in self._boxes.items():
            if box.get_state() is not (toggle in self._shown):
                self._shown = self._shown ^ {toggle}  # told once, however many events come before the next picture
                return toggle
        return None

    def _picked(self, event: pygame.Event) -> Asked | None:
        """A scene or a preset from its list."""
        if event.ui_element is self._list:
            return Chosen(event.text)
        line = self._presets.get(event.text)
        return None if line is None else Preset(line)

    def _line(self, height: float = _HEIGHT, gap: float = _GAP) -> pygame.Rect:
        """The next row, across the whole side."""
        edge, size = self._unit * 0.8, self._unit * self._squeeze
        box = pygame.Rect(
            round(self._area.left + edge), round(self._top), round(self._area.width - 2 * edge), round(size * height)
        )
        self._top += size * (height + gap)
        return box

    def _split(self, box: pygame.Rect, widths: tuple[float, ...]) -> list[pygame.Rect]:
        """A row in pieces. widths: in sizes of text, 0 for an equal share of what is left."""
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
    """Where in its run a scene is, and how fast it goes."""
    pace = PACES[session.pace]
    return f"tick {session.tick} of {session.last}, {'real' if pace == 1.0 else f'1/{round(1 / pace)}'} time"


def _squeeze(session: Session, room: float) -> float:
    """The share of their heights that makes all rows fit. room: in sizes of text."""
    row = _HEIGHT + _GAP
    numbers = [2 if isinstance(parameter, Point) else 1 for parameter in session.scene.parameters]
    rows = row * (4 + (1 if session.scene.presets else 0) + (2 if session.runs else 0))
    parameters = _NAME * len(numbers) + (_NUMBER + _GAP) * sum(numbers)
    toggles = (_BOX + 0.2) * (len(Toggle) + 1) // 2
    return min(max((room - _PRINT) / (rows + parameters + toggles + 2 * _GAP), _TIGHTEST), 1.0)


def _set_box(box: UICheckBox, *, on: bool, enabled: bool) -> None:
    """Bring a box in line."""
    if box.get_state() is not on:
        box.set_state(on)
    if enabled != box.is_enabled:
        change = box.enable if enabled else box.disable
        change()  # type: ignore[no-untyped-call]  # pygame_gui leaves these two without types
