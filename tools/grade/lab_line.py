"""A vector as a share line of the lab: python -m game lab 'case-2?ball=9.9,0.3&...' opens it."""

import math
from collections.abc import Callable, Mapping, Sequence

from game.lab.kit.parameters import plain
from game.lab.session.share import parsed, share_line
from game.student.signatures import SIGNATURES
from game.system.errors import BadInputError
from tools.vectors.vector import ConformanceVector

_NEAREST_RADIUS, _NEAREST_HALF_WIDTH = 8.0, 0.9
"""The ring of the scene nearest-sector, whose radii cannot be set."""
_PADDLE_RADIUS = 9.5
"""Of the outer face in the scene response-paddle."""


def lab_line(vector: ConformanceVector) -> str | None:
    """The line that shows a vector's geometry; None where no scene can have it."""
    numbers = dict(zip(SIGNATURES[vector.function].numbers, vector.arguments, strict=False))
    line = _LINES[vector.function](numbers, vector.arguments)
    try:
        return None if line is None else share_line(parsed(line))
    except BadInputError:  # a value is beyond the range of the scene
        return None


def _two_angles(given: Mapping[str, float], _: Sequence[float]) -> str:
    """Two angles, and the difference of their directions."""
    return _written("angle-difference", a=_degrees(given["a"]), b=_degrees(given["b"]))


def _on_left(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A ball's angle, and a sector without width."""
    return _written("on-left", theta=_degrees(given["a"]), angle=_degrees(given["b"]), half_angle=0.0)


def _normalize_angle(given: Mapping[str, float], _: Sequence[float]) -> str:
    """An angle of any size."""
    return _written("polar", turn=math.degrees(given["angle"]))


def _to_polar(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A point."""
    return _written("polar", p=_point(given, "p"))


def _to_cartesian(given: Mapping[str, float], _: Sequence[float]) -> str:
    """The point that is right, and the angle."""
    angle = given["angle"]
    p = complex(given["radius"] * math.cos(angle), given["radius"] * math.sin(angle))
    return _written("polar", p=p, turn=math.degrees(angle))


def _closest_point(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A line and a point."""
    return _written("closest-point", A=_point(given, "a"), B=_point(given, "b"), P=_point(given, "p"))


def _outcome(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A ball, the ground, and both rings."""
    names = ("r", "r_g", "r_p", "w_p", "r_b", "w_b")
    return _written("broad-phase", ball=_point(given, "p"), **{name: given[name] for name in names})


def _case_1(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A ball, and a sector whose middle is at its angle."""
    p = _point(given, "p")
    return _written("case-1", ball=p, radius=given["r_p"], angle=math.degrees(math.atan2(p.imag, p.real)) % 360.0)


def _case_2(given: Mapping[str, float], _: Sequence[float]) -> str:
    """A ball beside a sector."""
    return _sector("case-2", given, given["r_p"], given["theta_p"])


def _broad_phase(given: Mapping[str, float], arguments: Sequence[float]) -> str:
    """Sectors in an even ring of the scene nearest-sector; else the nearest of them in case 1 or case 2."""
    positions = arguments[6:]
    paddles = list(zip(positions[::2], positions[1::2], strict=True))
    count = len(paddles)
    turns = [(angle - paddles[0][1]) * count / math.tau for _, angle in paddles]
    even = sorted([round(turn) % count for turn in turns]) == list(range(count))
    usual = {radius for radius, _ in paddles} == {_NEAREST_RADIUS} and given["w_p"] == _NEAREST_HALF_WIDTH
    if even and usual and max([abs(turn - round(turn)) for turn in turns]) < 1e-2:
        fill = given["phi_p"] * count / math.pi
        return _written(
            "nearest-sector", ball=_point(given, "p"), r=given["r"], n=count, fill=fill, phase=_degrees(paddles[0][1])
        )
    theta = given["theta"]
    radius, angle = min(paddles, key=lambda paddle: abs(math.remainder(theta - paddle[1], math.tau)))
    over = abs(math.remainder(theta - angle, math.tau)) <= given["phi_p"]
    return _sector("case-1" if over else "case-2", given, radius, angle)


def _sector(scene: str, given: Mapping[str, float], radius: float, angle: float) -> str:
    """A ball and one sector."""
    return _written(
        scene,
        ball=_point(given, "p"),
        r=given["r"],
        radius=radius,
        angle=_degrees(angle),
        half_width=given["w_p"],
        half_angle=math.degrees(given["phi_p"]),
    )


def _response(given: Mapping[str, float], _: Sequence[float]) -> str:
    """The bounce, turned so that n points up: off a wall at rest, or off a paddle that slides along itself; else as it is."""
    v, n, v_p = _point(given, "v"), _point(given, "n"), _point(given, "v_p")
    up = 1j / n
    heading = _degrees_of(v * up)
    surface = v_p * up
    if abs(surface.imag) > 1e-9:
        return _written(
            "moving-surface", heading=_degrees_of(v), speed=given["v_0"], v_p=v_p, mu=given["mu_p"], normal=_degrees_of(n)
        )
    if abs(surface) < 1e-9:
        return _written("response-wall", theta=90.0, heading=heading, speed=given["v_0"], mu=given["mu_p"])
    spin = -surface.real / _PADDLE_RADIUS
    ball = complex(0.0, _PADDLE_RADIUS + 0.5)
    return _written("response-paddle", ball=ball, heading=heading, speed=given["v_0"], spin=spin, mu=given["mu_p"])


def _degrees_of(vector: complex) -> float:
    """The angle of a vector in degrees."""
    return math.degrees(math.atan2(vector.imag, vector.real)) % 360.0


def _written(scene: str, **values: complex) -> str:
    """A share line."""
    parts = [f"{name}={_value(value)}" for name, value in values.items()]
    return f"{scene}?{'&'.join(parts)}"


def _value(value: complex) -> str:
    """A number, or the two of a point."""
    return f"{plain(value.real)},{plain(value.imag)}" if isinstance(value, complex) else plain(value)


def _point(given: Mapping[str, float], name: str) -> complex:
    """A point among the arguments."""
    return complex(given[f"{name}.x"], given[f"{name}.y"])


def _degrees(angle: float) -> float:
    """From 0 to 360."""
    return math.degrees(angle) % 360.0


_LINES: Mapping[str, Callable[[Mapping[str, float], Sequence[float]], str | None]] = {
    "broad_phase_outcome": _outcome,
    "min_difference": _two_angles,
    "broad_phase": _broad_phase,
    "narrow_phase_case_1": _case_1,
    "on_left": _on_left,
    "to_cartesian": _to_cartesian,
    "closest_point_on_line": _closest_point,
    "narrow_phase_case_2": _case_2,
    "collision_response": _response,
    "normalize_angle": _normalize_angle,
    "add_angles": _two_angles,
    "subtract_angles": _two_angles,
    "to_polar": _to_polar,
}
"""How the call of each function becomes a scene; it is given the arguments by name, and all of them."""
