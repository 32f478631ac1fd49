"""Every scene's own claims, at its defaults, at its presets, and after random drags."""

import cmath
import math
import random
from collections.abc import Iterator
from typing import NamedTuple

from game.lab.kit.handles import dragged
from game.lab.kit.parameters import Count, Given, Parameter, Point, clamped, defaults
from game.lab.kit.picture import ScalarField
from game.lab.kit.scene import LabScene, Motion, picture_of, started
from game.lab.kit.second_engine import Engine
from game.lab.session.share import SharedScene, preset, share_line

_REACH = 2.0
"""Random drags reach this many times as far from the centre as the view box."""
_RUN_EVERY = 50
"""Of a scene that runs, the claims are checked after every so many drags only, since each check runs it."""


class FailedClaim(NamedTuple):
    """A claim that does not hold. line: the share line that opens the scene there."""

    line: str
    fact: str


class Report(NamedTuple):
    """The result of checking one scene. settings: how many were checked. claims: how many, of all settings together."""

    scene: LabScene
    settings: int
    claims: int
    failures: tuple[FailedClaim, ...]


def report(scene: LabScene, drags: int, seed: int, engine: Engine | None = None, more: tuple[Given, ...] = ()) -> Report:
    """Check a scene's claims at its defaults, its presets, after random drags, and at more settings."""
    checked = [*lines(scene, engine), *more, *after_drags(scene, drags, seed, engine)]
    found = [failure for given in checked for failure in failures(scene, given)]
    claims = len(scene.check(checked[0])) + 1
    return Report(scene, len(checked), claims * len(checked), tuple(found))


def failures(scene: LabScene, given: Given) -> tuple[FailedClaim, ...]:
    """The claims that do not hold at some values, and any number of the picture that is not finite."""
    line = share_line(SharedScene(scene, given))
    found = [FailedClaim(line, claim.fact) for claim in scene.check(given) if not claim.holds]
    if not _is_finite(picture_of(scene, given, started(scene, given))):
        found.append(FailedClaim(line, "every number of the picture is finite"))
    return tuple(found)


def lines(scene: LabScene, engine: Engine | None = None) -> tuple[Given, ...]:
    """The defaults and the presets."""
    return (defaults(scene.parameters, engine), *[preset(scene, one.line, engine) for one in scene.presets])


def after_drags(scene: LabScene, count: int, seed: int, engine: Engine | None = None) -> Iterator[Given]:
    """The values after each of many random drags and slider moves, some far out of range; of a scene that runs, every 50th."""
    chance = random.Random(seed)
    given = defaults(scene.parameters, engine)
    for number in range(count):
        given = _dragged_somewhere(scene, given, chance)
        if not isinstance(scene.shows, Motion) or number % _RUN_EVERY == 0:
            yield given


def _dragged_somewhere(scene: LabScene, given: Given, chance: random.Random) -> Given:
    """The values after one drag of one handle, or one slider."""
    if scene.handles and chance.random() < 0.7:
        handle = scene.handles[int(chance.random() * len(scene.handles))]
        return dragged(scene.parameters, given, handle, _somewhere(scene, given, chance)).given
    parameter = scene.parameters[int(chance.random() * len(scene.parameters))]
    return clamped(scene.parameters, given, {parameter.name: _some_value(parameter, chance)}).given


def _somewhere(scene: LabScene, given: Given, chance: random.Random) -> complex:
    """A point of the world: mostly anywhere around the view box, at times the centre or the position of another handle."""
    kind = chance.random()
    if kind < 0.05:
        return 0j
    if kind < 0.15:
        return scene.handles[int(chance.random() * len(scene.handles))].position(given)
    across, up = (2.0 * chance.random() - 1.0, 2.0 * chance.random() - 1.0)
    return scene.view_box.centre + _REACH * complex(across * scene.view_box.half.real, up * scene.view_box.half.imag)


def _some_value(parameter: Parameter, chance: random.Random) -> complex:
    """A value anywhere in the range, at its border, or beyond it."""
    kind = chance.random()
    low, high = float(parameter.low), float(parameter.high)
    numbers = [low, high, 2.0 * high - low] if kind < 0.2 else [low + (high - low) * chance.random() for _ in range(2)]
    one = numbers[int(chance.random() * len(numbers))]
    if isinstance(parameter, Point):
        return complex(one, numbers[int(chance.random() * len(numbers))])
    return float(round(one)) if isinstance(parameter, Count) else one


def _is_finite(value: object) -> bool:
    """Whether every number in a nested value is finite; of a field those at its corners."""
    if isinstance(value, float | complex):
        return cmath.isfinite(value)
    if isinstance(value, ScalarField):
        return all([math.isfinite(value.values.at(corner)) for corner in (value.lower, value.upper)])
    return not isinstance(value, tuple) or all(map(_is_finite, value))
