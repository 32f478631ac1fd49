"""A scene as it stands, written as one line: case-2?ball=9.9,0.3&half_angle=25. For a running scene it ends with the tick."""

import math
from typing import NamedTuple

from game.lab.kit.parameters import Count, Given, Parameter, Point, clamped, defaults, plain, written
from game.lab.kit.scene import LabScene, Motion
from game.lab.kit.second_engine import Engine
from game.lab.registry import scene_named
from game.system.errors import BadInputError
from game.system.wording import quoted

_TICK, _STEP = "tick", "step"
_LONGEST = 4096
_MOST_STEPS = 99
"""No scene has as many; of a higher step than it has, the whole picture is shown."""


class SharedScene(NamedTuple):
    """A scene with its values, at a tick. step: of its reveal; None for the whole picture."""

    scene: LabScene
    given: Given
    tick: int = 0
    step: int | None = None


def share_line(shared: SharedScene) -> str:
    """The line that opens a scene as it stands. Every value is written exactly."""
    parts = [
        f"{parameter.name}={_printed(shared.given.values[parameter.name], parameter)}" for parameter in shared.scene.parameters
    ]
    if shared.tick:
        parts.append(f"{_TICK}={shared.tick}")
    if shared.step is not None:
        parts.append(f"{_STEP}={shared.step}")
    return f"{shared.scene.name}?{'&'.join(parts)}"


def parsed(line: str, engine: Engine | None = None) -> SharedScene:
    """The scene and the values that a line names; what it does not name has its default.

    BadInputError names the part that cannot be used: an unknown scene or value, a value given twice, something that is not a
    number, or a number out of range.
    """
    if len(line) > _LONGEST:
        raise BadInputError(f"lab: a share line of {len(line)} characters; expected at most {_LONGEST}")
    name, mark, rest = line.strip().partition("?")
    scene = scene_named(name)
    return _read(scene, rest, engine) if mark and rest else SharedScene(scene, defaults(scene.parameters, engine))


def preset(scene: LabScene, line: str, engine: Engine | None = None) -> Given:
    """The values of one of a scene's presets."""
    return _read(scene, line, engine).given


def _read(scene: LabScene, rest: str, engine: Engine | None) -> SharedScene:
    """The values, the tick and the step after the question mark."""
    parameters = {parameter.name: parameter for parameter in scene.parameters}
    counted = {_TICK: scene.shows.ticks, _STEP: _MOST_STEPS} if isinstance(scene.shows, Motion) else {_STEP: _MOST_STEPS}
    values: dict[str, complex] = {}
    counts: dict[str, int] = {}
    for part in rest.split("&"):
        name, equals, text = part.partition("=")
        if not equals:
            raise _refused(part, "expected NAME=VALUE")
        if name in values or name in counts:
            raise _refused(part, f"{quoted(name)} is given twice")
        if name in parameters:
            values[name] = _value(part, text, parameters[name])
        elif name in counted:
            counts[name] = _whole_number(part, text, counted[name])
        else:
            raise _refused(part, f"{scene.name} has no '{quoted(name)}'; expected {', '.join([*parameters, *counted])}")
    given = clamped(scene.parameters, defaults(scene.parameters, engine), values).given
    return SharedScene(scene, given, counts.get(_TICK, 0), counts.get(_STEP))


def _whole_number(part: str, text: str, most: int) -> int:
    """The whole number that a part names."""
    if not text.isdecimal() or not text.isascii() or len(text) > 9 or int(text) > most:
        raise _refused(part, f"expected a whole number from 0 to {most}")
    return int(text)


def _value(part: str, text: str, parameter: Parameter) -> complex:
    """The value that a part gives to a parameter, inside its range."""
    texts = text.split(",")
    if len(texts) != (2 if isinstance(parameter, Point) else 1):
        expected = "two numbers X,Y" if isinstance(parameter, Point) else "one number"
        raise _refused(part, f"expected {expected}")
    numbers = [_number(part, text) for text in texts]
    for number in numbers:
        if not parameter.low <= number <= parameter.high:
            low, high = written_borders(parameter)
            raise _refused(part, f"{plain(number)} is not from {low} to {high}")
        if isinstance(parameter, Count) and number != round(number):
            raise _refused(part, "expected a whole number")
    return complex(*numbers) if isinstance(parameter, Point) else numbers[0]


def written_borders(parameter: Parameter) -> tuple[str, str]:
    """The lowest and the highest number of a parameter, with its unit."""
    if isinstance(parameter, Point):
        return plain(parameter.low), plain(parameter.high)
    return written(parameter, parameter.low), written(parameter, parameter.high)


def _refused(part: str, reason: str) -> BadInputError:
    """The error for a part of a line that cannot be used."""
    return BadInputError(f"lab: part '{quoted(part)}' of the share line: {reason}")


def _number(part: str, text: str) -> float:
    """A finite number."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number) or "_" in text or text != text.strip():
        raise _refused(part, f"'{quoted(text)}' is not a number")
    return number


def _printed(value: complex, parameter: Parameter) -> str:
    """A value as a share line has it."""
    return f"{plain(value.real)},{plain(value.imag)}" if isinstance(parameter, Point) else plain(value.real)
