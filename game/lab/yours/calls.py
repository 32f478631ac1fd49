"""What each scene asks the player's own functions: the calls of the source's functions that its values make."""

import math
from collections.abc import Callable
from typing import NamedTuple

from game.lab.kit.end_bounce import end_bounce
from game.lab.kit.marks import VELOCITY_SCALE
from game.lab.kit.parameters import Given
from physics import (
    Ball,
    Ring,
    add_angles,
    contact,
    min_difference,
    normalize_angle,
    on_left,
    subtract_angles,
    to_cartesian,
    to_polar,
)

_NORMAL = 1.5
"""World units drawn for a unit normal."""


class OwnCall(NamedTuple):
    """A call of one of the source's functions.

    arguments: a flat list of numbers, as in the line protocol. start: where a result that is a vector is drawn from; None for
    one that is a point, or no picture. scale: world units drawn per unit of it. label: of the arrow or the point. case: which
    of several calls of one function it is, before its name.
    """

    function: str
    arguments: tuple[float, ...]
    start: complex | None = None
    scale: float = 1.0
    label: str = ""
    case: str = ""


class _Sector(NamedTuple):
    """A ball beside one sector."""

    p: complex
    r: float
    theta: float
    radius: float
    angle: float
    half_width: float
    half_angle: float

    @property
    def is_over(self) -> bool:
        """Whether this is case 1."""
        return min_difference(self.theta, self.angle) <= self.half_angle


def calls_of(scene: str, given: Given) -> tuple[OwnCall, ...]:
    """The calls of a scene, by its name; none for a scene that asks nothing."""
    return _CALLS[scene](given) if scene in _CALLS else ()


def asking_scenes() -> tuple[str, ...]:
    """The names of the scenes that ask something."""
    return tuple(_CALLS)


def _polar(given: Given) -> tuple[OwnCall, ...]:
    """The point's coordinates and back, and the angle of any size."""
    p, turn = given.point("p"), given.angle("turn") + given.number("epsilon") * 1e-17
    return (
        OwnCall("to_polar", (p.real, p.imag)),
        OwnCall("to_cartesian", to_polar(p), label="p"),
        OwnCall("normalize_angle", (turn,)),
    )


def _angle_difference(given: Given) -> tuple[OwnCall, ...]:
    """Two directions."""
    both = normalize_angle(given.angle("a")), normalize_angle(given.angle("b"))
    names = ("min_difference", "on_left", "subtract_angles", "add_angles")
    return tuple([OwnCall(name, both) for name in names])


def _on_left(given: Given) -> tuple[OwnCall, ...]:
    """The side of the sector's middle, and the end."""
    theta, angle = normalize_angle(given.angle("theta")), normalize_angle(given.angle("angle"))
    sector = _Sector(to_cartesian(6.0, theta), given.number("r"), theta, 6.0, angle, 1.0, given.angle("half_angle"))
    return (OwnCall("on_left", (theta, angle)), *([] if sector.is_over else [_case_2(sector)]))


def _outcome(given: Given) -> tuple[OwnCall, ...]:
    """The four outcomes."""
    p, names = given.point("ball"), ("r", "r_g", "r_p", "w_p", "r_b", "w_b")
    return (OwnCall("broad_phase_outcome", (p.real, p.imag, *[given.number(name) for name in names])),)


def _nearest_sector(given: Given) -> tuple[OwnCall, ...]:
    """The search over a ring."""
    count, p = given.count("n"), given.point("ball")
    ring = Ring(8.0, 0.9, given.number("fill") * math.pi / count, count, given.angle("phase"))
    positions = [(ring.radius, ring.angle(slot)) for slot in range(count)]
    return (_broad_phase(p, given.number("r"), ring, positions)._replace(scale=2.5),)


def _sector(given: Given) -> _Sector:
    """The ball and the sector of the scenes about one contact."""
    p, angle = given.point("ball"), normalize_angle(given.angle("angle"))
    theta = to_polar(p)[1]
    sizes = given.number("half_width"), given.angle("half_angle")
    return _Sector(p, given.number("r"), theta, given.number("radius"), angle, *sizes)


def _one_case(given: Given) -> tuple[OwnCall, ...]:
    """Case 1 or case 2, whichever it is."""
    sector = _sector(given)
    return (_case_1(sector),) if sector.is_over else (_case_2(sector),)


def _case_1_scene(given: Given) -> tuple[OwnCall, ...]:
    """Case 1, wherever the ball is."""
    return (_case_1(_sector(given)),)


def _case_2_scene(given: Given) -> tuple[OwnCall, ...]:
    """The end's corner B, its closest point, and the normal."""
    sector = _sector(given)
    if sector.is_over:
        return ()
    left = on_left(sector.theta, sector.angle)
    end = add_angles(sector.angle, sector.half_angle) if left else subtract_angles(sector.angle, sector.half_angle)
    inner, outer = (to_cartesian(sector.radius + side * sector.half_width, end) for side in (-1.0, 1.0))
    numbers = tuple([part for point in (inner, outer, sector.p) for part in (point.real, point.imag)])
    return (
        OwnCall("to_cartesian", (sector.radius + sector.half_width, end), label="B"),
        OwnCall("closest_point_on_line", numbers, label="q"),
        _case_2(sector),
    )


def _inside(given: Given) -> tuple[OwnCall, ...]:
    """The broad phase with one sector."""
    sector = _sector(given)
    ring = Ring(sector.radius, sector.half_width, sector.half_angle, 1, sector.angle)
    return (_broad_phase(sector.p, sector.r, ring, [(sector.radius, sector.angle)]),)


def _closest_point(given: Given) -> tuple[OwnCall, ...]:
    """The foot."""
    points = [given.point(name) for name in ("A", "B", "P")]
    return (OwnCall("closest_point_on_line", tuple([part for p in points for part in (p.real, p.imag)]), label="q"),)


def _wall(given: Given) -> tuple[OwnCall, ...]:
    """The bounce off a wall at rest."""
    n = to_cartesian(1.0, given.angle("theta"))
    bounce = _response(n * 7.1, _velocity(given), n, 0j, given.number("mu"), given.number("speed"))
    return (bounce._replace(scale=0.34),)


def _paddle(given: Given) -> tuple[OwnCall, ...]:
    """The bounce off a moving paddle, where the ball touches it."""
    ring, v = Ring(9.0, 0.5, 0.35, 1, math.pi / 2.0, given.number("spin")), _velocity(given)
    there = contact(Ball(given.point("ball"), v, 0.5), ring, 0)
    ball = Ball(there.point + there.normal * 0.5, v, 0.5)
    touch = contact(ball, ring, 0)
    v_p = ring.surface_velocity(touch.point)
    bounce = _response(ball.position, v, touch.normal, v_p, given.number("mu"), given.number("speed"))
    return (bounce._replace(scale=0.28),)


def _friction(given: Given) -> tuple[OwnCall, ...]:
    """The bounce with each friction."""
    v_p = complex(-6.6 * given.number("spin"), 0.0)
    bounces = [_response(7.1j, _velocity(given), 1j, v_p, mu, given.number("speed")) for mu in (0.0, 0.5, 1.0)]
    return tuple(
        [one._replace(label=f"{mu}", case=f"μ_p = {mu}:   ") for one, mu in zip(bounces, ("0", "½", "1"), strict=True)]
    )


def _axis_slip(given: Given) -> tuple[OwnCall, ...]:
    """The bounce in the ground's plane."""
    n = to_cartesian(1.0, given.angle("theta"))
    return (_response(n * 1.8, _velocity(given), n, 0j, 0.0, given.number("speed")),)


def _moving_surface(given: Given) -> tuple[OwnCall, ...]:
    """The bounce off any surface."""
    n = to_cartesian(1.0, given.angle("normal"))
    bounce = _response(n * 0.7, _velocity(given), n, given.point("v_p"), given.number("mu"), given.number("speed"))
    return (bounce._replace(scale=0.4),)


def _end(given: Given) -> tuple[OwnCall, ...]:
    """The bounce off the end of a turning paddle."""
    ball, _, found, _ = end_bounce(given)
    bounce = _response(ball.position, found.v, found.normal, found.surface_velocity, found.friction, found.speed)
    return (bounce._replace(scale=0.3),)


def _case_1(sector: _Sector) -> OwnCall:
    """The normal of a face."""
    return OwnCall("narrow_phase_case_1", (sector.p.real, sector.p.imag, sector.radius), sector.p, _NORMAL, "n")


def _case_2(sector: _Sector) -> OwnCall:
    """The normal of an end."""
    return OwnCall("narrow_phase_case_2", (sector.p.real, sector.p.imag, *sector[1:]), sector.p, _NORMAL, "n")


def _broad_phase(p: complex, r: float, ring: Ring, positions: list[tuple[float, float]]) -> OwnCall:
    """The normal of the nearest of some sectors."""
    places = [number for position in positions for number in position]
    numbers = (p.real, p.imag, r, to_polar(p)[1], ring.half_width, ring.half_angle, *places)
    return OwnCall("broad_phase", numbers, p, _NORMAL, "n")


def _velocity(given: Given) -> complex:
    """The ball's velocity before a bounce."""
    return to_cartesian(given.number("speed"), given.angle("heading"))


def _response(p: complex, v: complex, n: complex, v_p: complex, mu: float, v_0: float) -> OwnCall:
    """The velocity after a bounce."""
    numbers = (v.real, v.imag, n.real, n.imag, v_p.real, v_p.imag, mu, v_0)
    return OwnCall("collision_response", numbers, p, VELOCITY_SCALE, "v after")


_CALLS: dict[str, Callable[[Given], tuple[OwnCall, ...]]] = {
    "polar": _polar,
    "angle-difference": _angle_difference,
    "on-left": _on_left,
    "broad-phase": _outcome,
    "nearest-sector": _nearest_sector,
    "case-1": _case_1_scene,
    "case-2": _case_2_scene,
    "closest-point": _closest_point,
    "inside-material": _inside,
    "gap-field": _one_case,
    "response-wall": _wall,
    "response-paddle": _paddle,
    "friction": _friction,
    "axis-slip": _axis_slip,
    "moving-surface": _moving_surface,
    "stopped-dead": _end,
    "carried": _end,
}
