"""The controls beside the picture as rows of items: lists of scenes and presets, sliders with fields, switches, buttons."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import pygame

from game.input.key_names import code_names
from game.lab.kit.parameters import Parameter, Point, plain, snapped, step_of, written
from game.lab.kit.picture import Toggle
from game.lab.registry import chapters
from game.lab.session.commands import Command
from game.lab.session.session import PACES, Session
from game.lab.window.commands import KEYS, TOGGLE_KEYS
from game.screens.base import Screen
from game.screens.toolkit.items.basic import ButtonItem, Item, Space, Switch
from game.screens.toolkit.items.drop_down import DropDown, Option, Options
from game.screens.toolkit.items.label import LabelItem
from game.screens.toolkit.items.slider import FieldSlider
from game.screens.toolkit.layout import Column, Row
from game.screens.toolkit.side_panel import Typing

_LIST_SHARE = 6.0
"""Widths of the list of scenes and of the clock, in those of the buttons beside them."""
_SPACE: Row = (Space(0.1),)
"""Between groups of controls."""
_BUTTONS = (
    (Command.REVEAL, Command.PREDICT, Command.COURSE, Command.PRESENT),
    (Command.DEFAULTS, Command.WHOLE, Command.COPY),
    (Command.SAVE, Command.THEME, Command.HELP),
)
"""In rows."""


class ValueRequested(NamedTuple):
    """A value was typed, or a slider was moved to it. name: of the parameter."""

    name: str
    value: complex


class NumberRefused(NamedTuple):
    """What was typed is no number. note: a sentence that says so."""

    note: str


class SceneChosen(NamedTuple):
    """A scene was chosen from the list. name: of the scene."""

    name: str


class PresetChosen(NamedTuple):
    """A preset was chosen. line: its values, as in `Preset.line`."""

    line: str


Request = ValueRequested | NumberRefused | SceneChosen | PresetChosen | Toggle | Command


class Component(NamedTuple):
    """One number of the scene: a parameter's own, or a coordinate of a point: 0 for its x, 1 for its y."""

    parameter: Parameter
    coordinate: int

    def number(self, session: Session) -> float:
        """What it is now."""
        value = session.given.values[self.parameter.name]
        return value.imag if self.coordinate else value.real

    def text(self, session: Session) -> str:
        """The same as it is typed: with all its digits."""
        return plain(self.number(session))

    def requested(self, session: Session, number: float) -> ValueRequested:
        """It shall be another number; a point's other coordinate stays."""
        name, other = self.parameter.name, session.given.values[self.parameter.name]
        if not isinstance(self.parameter, Point):
            return ValueRequested(name, number)
        return ValueRequested(name, complex(other.real, number) if self.coordinate else complex(number, other.imag))

    def moved(self, session: Session, number: float) -> ValueRequested:
        """The same by a slider: inside the range, and a multiple of the parameter's step."""
        low, high = float(self.parameter.low), float(self.parameter.high)
        rounded = snapped((self.parameter,), {self.parameter.name: number})[self.parameter.name].real
        return self.requested(session, min(max(rounded, low), high))


class LabControls(NamedTuple):
    """What the controls show. shown: toggles that are on; available: toggles of the picture's marks; typing: if anything is."""

    session: Session
    shown: frozenset[Toggle]
    available: frozenset[Toggle]
    typing: Typing | None = None


class LabCallbacks(NamedTuple):
    """The functions that the controls call.

    ask: does what is asked for; the screen to go on with. edit: begins to type a number, or puts the caret at so many pixels
    from its field's left edge. scenes, presets: open the lists.
    """

    ask: Callable[[Request], Screen | None]
    edit: Callable[[Component, float | None], None]
    scenes: Callable[[], Screen | None]
    presets: Callable[[], Screen | None]


def controls(seen: LabControls, callbacks: LabCallbacks, *, narrow: bool = False) -> Column:
    """All controls: the lists above, the buttons below, and the numbers between them, which scroll where they are too many.

    narrow: a row has room for two buttons, or for one switch.
    """
    scene = seen.session.scene
    lists: list[Row] = [
        (
            _button(Command.PREVIOUS, callbacks),
            DropDown(scene.name, callbacks.scenes, "all scenes", _LIST_SHARE),
            _button(Command.NEXT, callbacks),
        ),
    ]
    if scene.presets:
        lists.append((DropDown("Presets", callbacks.presets, "values worth looking at"),))
    numbers = [row for parameter in scene.parameters for row in _parameter(parameter, seen, callbacks)]
    time = [*_time(seen.session, callbacks, narrow=narrow), _SPACE] if seen.session.runs else []
    switches = [_switch(key, toggle, seen, callbacks) for key, toggle in TOGGLE_KEYS.items()]
    below = [_SPACE, *time, *_rows(switches, 1 if narrow else 2), _SPACE]
    buttons = [[_button(command, callbacks) for command in commands] for commands in _BUTTONS]
    below += _rows([button for row in buttons for button in row], 2) if narrow else [tuple(row) for row in buttons]
    lists.append(_SPACE)
    return Column(tuple(lists), tuple(numbers), tuple(below))


def scene_options() -> Options:
    """All scenes by chapter, with their titles."""
    return tuple(
        [
            (title.capitalize(), tuple([Option(scene.name, scene.title) for scene in found]))
            for title, found in chapters().items()
        ]
    )


def preset_options(session: Session) -> Options:
    """A scene's presets, with their values as in a share line."""
    return (("", tuple([Option(preset.label, preset.line) for preset in session.scene.presets])),)


def _parameter(parameter: Parameter, seen: LabControls, callbacks: LabCallbacks) -> list[Row]:
    """A parameter's value and meaning, and a slider with a field for each of its numbers."""
    value = f"{parameter.label} = {written(parameter, seen.session.given.values[parameter.name])}"
    count = 2 if isinstance(parameter, Point) else 1
    sliders: list[Row] = [(_slider(Component(parameter, coordinate), seen, callbacks),) for coordinate in range(count)]
    return [(LabelItem(value, parameter.meaning),), *sliders]


def _slider(component: Component, seen: LabControls, callbacks: LabCallbacks) -> FieldSlider:
    """One number."""
    session, parameter = seen.session, component.parameter
    low, high, number = float(parameter.low), float(parameter.high), component.number(session)
    typed = seen.typing is not None and seen.typing.name == component

    def level(value: float) -> float:
        return min(max((value - low) / (high - low), 0.0), 1.0)

    def moved_to(value: float) -> None:
        callbacks.ask(component.moved(session, value))

    return FieldSlider(
        parameter.name,
        level(number),
        component.text(session),
        lambda steps: moved_to(number + steps * step_of(parameter)),
        lambda put: moved_to(low + put * (high - low)),
        edit=lambda pixels: callbacks.edit(component, pixels),
        origin=level(0.0),
        field=seen.typing.field if seen.typing is not None and typed else None,
    )


def _time(session: Session, callbacks: LabCallbacks, *, narrow: bool) -> list[Row]:
    """The buttons to run, to step and to restart; below them the clock between those for slower and faster."""
    play = _button(Command.PLAY, callbacks, "Pause" if session.playing else "Play")
    steps = (_button(Command.BACK, callbacks), play, _button(Command.FORWARD, callbacks), _button(Command.RESTART, callbacks))
    pace = PACES[session.pace]
    clock = f"tick {session.tick} of {session.last}, {'real' if pace == 1.0 else f'1/{round(1 / pace)}'} time"
    middle = LabelItem(clock, centred=True, share=_LIST_SHARE)
    return [*_rows(steps, 2 if narrow else 4), (_button(Command.SLOWER, callbacks), middle, _button(Command.FASTER, callbacks))]


def _rows(items: Sequence[Item], count: int) -> list[Row]:
    """Items in rows of so many, the last row filled up with empty room."""
    filled = [*items, *[Item()] * (-len(items) % count)]
    return [tuple(filled[first : first + count]) for first in range(0, len(filled), count)]


def _switch(key: int, toggle: Toggle, seen: LabControls, callbacks: LabCallbacks) -> Switch:
    """One kind of mark, of which the picture may have none."""

    def turned() -> None:
        callbacks.ask(toggle)

    label = f"{pygame.key.name(key)}  {toggle.value}"
    return Switch(label, toggle in seen.shown, turned, usable=toggle in seen.available)


def _button(command: Command, callbacks: LabCallbacks, label: str = "") -> ButtonItem:
    """A button; what is said about it names its key."""
    binding = next(one for one in KEYS if one.command is command)
    tip = f"{binding.meaning} ({'  '.join(code_names(binding.keys))})"
    return ButtonItem(label or command.value, lambda: callbacks.ask(command), tip=tip, centred=True)
