"""Mistakes that students make, each as the source's functions with that mistake in them, and a hint."""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from game.student.slides import Plane, Scalar, SlideFunctions


class NamedMistake(NamedTuple):
    """A mistake. functions: makes the functions that have it. hint: what to look at."""

    name: str
    functions: Callable[[], SlideFunctions]
    hint: str


class _DegreeLibrary:
    """Sine, cosine and arc tangent of degrees."""

    pi = 180.0

    @staticmethod
    def sin(angle: float) -> float:
        """Of degrees."""
        return math.sin(math.radians(angle))

    @staticmethod
    def cos(angle: float) -> float:
        """Of degrees."""
        return math.cos(math.radians(angle))

    @staticmethod
    def atan2(y: float, x: float) -> float:
        """In degrees."""
        return math.degrees(math.atan2(y, x))


class _Degrees(SlideFunctions):
    """A full turn is 360."""

    def __init__(self) -> None:
        super().__init__(_DegreeLibrary())


def _without(method: str, replacement: Callable[..., Any]) -> Callable[[], SlideFunctions]:
    """The source's functions with another method in place of one; the replacement is given the functions themselves first."""
    return type(f"With_{method}", (SlideFunctions,), {method: replacement})


def _once(angle: float) -> float:
    """Wrapped by at most one turn."""
    if angle < 0.0:
        return angle + math.tau
    return angle - math.tau if angle >= math.tau else angle


def _both_or(_: SlideFunctions, p: Plane, r: Scalar, r_g: Scalar, r_p: Scalar, w_p: Scalar, r_b: Scalar, w_b: Scalar) -> str:
    """The band's two conditions joined by "or"."""
    if abs(p) - r > r_g:
        return "game over"
    if abs(p) + r >= r_p - w_p or abs(p) - r <= r_p + w_p:
        return "paddles"
    return "bricks" if abs(p) + r >= r_b - w_b or abs(p) - r <= r_b + w_b else "no collision"


def _outcome_of(radius: Callable[[float], float], rim: Callable[[float], float]) -> Callable[[], SlideFunctions]:
    """The outcome with another radius of the ball at the bands, and at the rim."""

    def outcome(_: SlideFunctions, p: Plane, r: Scalar, r_g: Scalar, *rings: Scalar) -> str:
        right, shifted = SlideFunctions(), math.inf
        if abs(p) - rim(r) > r_g:
            return "game over"
        return right.broad_phase_outcome(p, radius(r), shifted, *rings)

    return _without("broad_phase_outcome", outcome)


def _farthest(f: SlideFunctions, theta: Scalar, positions: Sequence[tuple[Scalar, Scalar]]) -> tuple[Scalar, Scalar]:
    """The paddle farthest in angle."""
    return max(positions, key=lambda position: f.min_difference(theta, position[1]))


def _endless(_: SlideFunctions, a: Plane, b: Plane, p: Plane) -> Plane:
    """The share of AB not divided by its squared length."""
    return a + (b - a) * ((p - a) * (b - a).conjugate()).real


def _divided_once(_: SlideFunctions, a: Plane, b: Plane, p: Plane) -> Plane:
    """The share of AB divided by its length, not by the square."""
    return a + (b - a) * ((p - a) * (b - a).conjugate()).real / abs(b - a)


def _relative_result(f: SlideFunctions, v: Plane, n: Plane, v_p: Plane, mu: Scalar, v_0: Scalar) -> Plane:
    """The changes added to dv."""
    return (
        SlideFunctions.collision_response(f, v - v_p, n, 0, mu, v_0)
        if (v - v_p).real * n.real + (v - v_p).imag * n.imag < 0
        else v
    )


_ANGLES = (
    NamedMistake(
        "no wrap",
        _without("min_difference", lambda _, a, b: abs(a - b)),
        "|a - b| is wrong when the polar axis lies between them: normalise the difference, then take min(d, 2π - d).",
    ),
    NamedMistake(
        "no wrap",
        _without("on_left", lambda _, a, b: a > b),
        "a > b is wrong when the polar axis lies between them: normalise a - b, and compare it with π.",
    ),
    NamedMistake("no wrap", _without("normalize_angle", lambda _, a: a), "The angle is never normalised; see slide 11."),
    NamedMistake(
        "wrap in one direction only",
        _without("normalize_angle", lambda _, a: a - math.tau * max(math.floor(a / math.tau), 0)),
        "Angles below 0 stay below 0: add full turns to them, too.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("normalize_angle", lambda _, a: a % math.tau if a < 0.0 else a),
        "Angles above 2π stay above it: subtract full turns from them, too.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("normalize_angle", lambda _, a: a - math.tau if a >= math.tau else a),
        "Angles below 0 stay below 0, and a second turn stays: use a remainder that is never negative.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("normalize_angle", lambda _, a: a + math.tau if a < 0.0 else a),
        "Angles above 2π stay above it: subtract full turns from them, too.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("normalize_angle", lambda _, a: math.fmod(a, math.tau)),
        "fmod keeps the sign: a negative angle stays negative. Add 2π to a negative remainder.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("min_difference", lambda _, a, b: (a - b) % math.tau),
        "This is the angle from b to a counter-clockwise. The other direction may be shorter: min(d, 2π - d).",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("min_difference", lambda _, a, b: (b - a) % math.tau),
        "This is the angle from a to b counter-clockwise. The other direction may be shorter: min(d, 2π - d).",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("min_difference", lambda _, a, b: math.tau - (a - b) if a - b > math.pi else abs(a - b)),
        "The difference is wrapped where a - b > π, but not where it is below -π.",
    ),
    NamedMistake(
        "wrap in one direction only",
        _without("min_difference", lambda _, a, b: math.tau - (b - a) if b - a > math.pi else abs(a - b)),
        "The difference is wrapped where a - b < -π, but not where it is above π.",
    ),
    NamedMistake(
        "one turn at most",
        _without("normalize_angle", lambda _, a: _once(a)),
        "One full turn is added or subtracted, but an angle can be several turns away: repeat it, or use a remainder.",
    ),
    NamedMistake(
        "range from -π to π",
        _without("normalize_angle", lambda _, a: math.remainder(a, math.tau)),
        "The slides normalise to (0, 2π): add 2π to what is below 0.",
    ),
    NamedMistake(
        "range from -π to π",
        _without("to_polar", lambda _, p: (abs(p), math.atan2(p.imag, p.real))),
        "atan2 answers from -π to π: normalise its angle.",
    ),
    NamedMistake("degrees for radians", _Degrees, "Sine, cosine and atan2 work in radians, and a full turn is 2π, not 360."),
    NamedMistake(
        "degrees for radians",
        _without("to_cartesian", lambda _, r, a: _Degrees().to_cartesian(r, a)),
        "The angle is in radians already, and so is what sine and cosine take.",
    ),
    NamedMistake(
        "degrees for radians",
        _without("to_polar", lambda _, p: _Degrees().to_polar(p)),
        "atan2 answers in radians, and so must you.",
    ),
    NamedMistake(
        "x and y swapped",
        _without("to_polar", lambda f, p: (abs(p), f.normalize_angle(math.atan2(p.real, p.imag)))),
        "It is atan2(y, x), with y first.",
    ),
    NamedMistake(
        "quadrant lost",
        _without("to_polar", lambda f, p: (abs(p), f.normalize_angle(math.atan(p.imag / p.real if p.real else math.inf)))),
        "atan(y / x) cannot tell a point from the opposite one: use atan2(y, x).",
    ),
    NamedMistake(
        "sine and cosine swapped",
        _without("to_cartesian", lambda _, r, a: complex(r * math.sin(a), r * math.cos(a))),
        "x = r cos(angle), y = r sin(angle).",
    ),
    NamedMistake(
        "left and right swapped",
        _without("on_left", lambda _, a, b: 0.0 < (b - a) % math.tau < math.pi),
        "Left is counter-clockwise: a is on the left of b where a - b, normalised, lies between 0 and π.",
    ),
)

_DETECTION = (
    NamedMistake(
        "wrong sign at |p| < r_p",
        _without("narrow_phase_case_1", lambda _, p, r_p: p / abs(p) if abs(p) < r_p else -p / abs(p)),
        "Inside of r_p the normal points to the centre: -p / |p|; outside away from it.",
    ),
    NamedMistake(
        "wrong sign at |p| < r_p",
        _without("narrow_phase_case_1", lambda _, p, __: p / abs(p)),
        "The inner face's normal points to the centre: return -n where |p| < r_p.",
    ),
    NamedMistake(
        "wrong sign at |p| > r_p",
        _without("narrow_phase_case_1", lambda _, p, __: -p / abs(p)),
        "The outer face's normal points away from the centre: return n where |p| > r_p.",
    ),
    NamedMistake(
        "normal not of length 1",
        _without("narrow_phase_case_1", lambda _, p, r_p: -p if abs(p) < r_p else p),
        "Divide by |p|.",
    ),
    NamedMistake(
        "end by the wrong rule",
        _without("end_sign", lambda f, t, t_p, phi: -1 if f.on_left(t, t_p + phi) else 1),
        "The sign is the wrong way round: 1 where the ball is on the left.",
    ),
    NamedMistake(
        "end by the wrong rule",
        _without("end_sign", lambda *_: 1),
        "It is always the counter-clockwise end: ask on_left, and take -1 for the other.",
    ),
    NamedMistake(
        "end by the wrong rule",
        _without("end_sign", lambda *_: -1),
        "It is always the clockwise end: ask on_left, and take 1 for the other.",
    ),
    NamedMistake(
        "end by the wrong rule",
        _without("end_sign", lambda _, t, t_p, __: 1 if t > t_p else -1),
        "θ > θ_p is wrong when the polar axis lies between them: use on_left.",
    ),
    NamedMistake(
        "end by the wrong rule",
        _without("end_sign", lambda _, t, t_p, phi: 1 if t > t_p + phi else -1),
        "θ > θ_p + φ_p is wrong when the polar axis lies between them: use on_left.",
    ),
    NamedMistake(
        "distance not tested",
        _without("end_normal", lambda _, p, q, __: (p - q) / abs(p - q)),
        "There is a contact only where |p - q| is below r: else return None.",
    ),
    NamedMistake(
        "normal the wrong way round",
        _without("end_normal", lambda _, p, q, r: (q - p) / abs(p - q) if 0 < abs(p - q) < r else None),
        "The normal points from the obstacle to the ball: p - q, not q - p.",
    ),
    NamedMistake(
        "normal not of length 1",
        _without("end_normal", lambda _, p, q, r: p - q if 0 < abs(p - q) < r else None),
        "Divide by |p - q|.",
    ),
    NamedMistake(
        "share of AB not divided by |AB|²",
        _without("closest_point_on_line", _endless),
        "(p - A) · (B - A) / |B - A|² is the share of AB.",
    ),
    NamedMistake(
        "share of AB divided by |AB| only",
        _without("closest_point_on_line", _divided_once),
        "(p - A) · (B - A) / |B - A|² is the share of AB; with a unit direction in place of one B - A there is no division.",
    ),
    NamedMistake(
        "first paddle only", _without("nearest", lambda _, __, all_of: all_of[0]), "Search all positions for the nearest."
    ),
    NamedMistake(
        "farthest paddle", _without("nearest", _farthest), "The comparison is the wrong way round: keep the smaller difference."
    ),
    NamedMistake(
        "or in place of and", _without("broad_phase_outcome", _both_or), "Both conditions of a band must hold: ∧ is and."
    ),
    NamedMistake(
        "ball's radius forgotten",
        _outcome_of(lambda _: 0.0, lambda _: 0.0),
        "The ball reaches r farther than p: |p| + r, |p| - r.",
    ),
    NamedMistake("ball's radius forgotten", _outcome_of(lambda _: 0.0, lambda r: r), "At the bands, too: |p| + r, |p| - r."),
    NamedMistake("game over too early", _outcome_of(lambda r: r, lambda r: -r), "The whole ball must be out: |p| - r > r_g."),
    NamedMistake("game over too early", _outcome_of(lambda r: r, lambda _: 0.0), "The whole ball must be out: |p| - r > r_g."),
)

_RESPONSE = (
    NamedMistake(
        "friction unclamped",
        _without("tangential_change", lambda _, __, t, mu: -mu * t),
        "Friction is at most μ |Δv_n|: multiply the direction of Δv_t by min(|Δv_n|, |Δv_t|).",
    ),
    NamedMistake(
        "friction unclamped",
        _without("tangential_change", lambda _, n, t, mu: -mu * abs(n) * t / abs(t) if abs(t) > 0 else 0),
        "Friction is at most μ |Δv_t|, or it turns the sliding round: min(|Δv_n|, |Δv_t|).",
    ),
    NamedMistake(
        "friction in the wrong direction",
        _without("tangential_change", lambda _, n, t, mu: mu * min(abs(n), abs(t)) * t / abs(t) if abs(t) > 0 else 0),
        "Friction works against Δv_t: mind the minus sign.",
    ),
    NamedMistake("friction forgotten", _without("tangential_change", lambda *_: 0), "Δv'_t is missing; see slide 10."),
    NamedMistake(
        "speed not reset", _without("final_velocity", lambda _, v, *__: v), "The last step is v := v_0 v_res / |v_res|."
    ),
    NamedMistake(
        "responding while separating",
        _without("separates", lambda *_: False),
        "Continue only if Δv · n < 0 (slide 9): else the ball already leaves, and v stays.",
    ),
    NamedMistake(
        "responding while separating",
        _without("separates", lambda _, approach: approach < 0),
        "The condition is the wrong way round: continue only if Δv · n < 0 (slide 9).",
    ),
    NamedMistake(
        "v_p forgotten",
        _without("relative_velocity", lambda _, v, __: v),
        "The bounce is relative to the paddle: Δv = v - v_p (slide 8).",
    ),
    NamedMistake(
        "v_p added", _without("relative_velocity", lambda _, v, v_p: v + v_p), "Δv = v - v_p: mind the minus sign (slide 8)."
    ),
    NamedMistake(
        "v_p forgotten in v_res",
        _without("collision_response", _relative_result),
        "The changes are added to v, not to Δv: v_res = v + Δv'_n + Δv'_t.",
    ),
    NamedMistake(
        "half a bounce", _without("normal_change", lambda _, n: -n), "Δv'_n = -2 Δv_n: with -Δv_n the ball only stops."
    ),
    NamedMistake("no bounce", _without("normal_change", lambda *_: 0), "Δv'_n = -2 Δv_n is missing (slide 10)."),
    NamedMistake(
        "bounce the wrong way",
        _without("normal_change", lambda _, n: 2 * n),
        "Δv'_n = -2 Δv_n: mind the minus sign (slide 10).",
    ),
)

MISTAKES = (*_ANGLES, *_DETECTION, *_RESPONSE)
"""The catalogue. Several entries have one name where the same mistake is made in several forms."""
