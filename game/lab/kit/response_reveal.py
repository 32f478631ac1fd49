"""The source's response, one vector after the other, as its slides build it."""

import math
from typing import NamedTuple

from game.lab.kit.bounce import Bounce
from game.lab.kit.marks import VELOCITY_SCALE, two_decimals
from game.lab.kit.picture import Arrow, Line, Mark, Prediction, RevealStep, Role, Stroke, one_step
from physics import length


class DrawnBounce(NamedTuple):
    """A bounce, and where its vectors are drawn.

    centre: of the ball, where its velocities begin. touched: the point of the surface, where the surface's begins.
    scale: world units drawn per unit of speed.
    """

    found: Bounce
    centre: complex
    touched: complex
    scale: float = VELOCITY_SCALE


def response_reveal(drawn: DrawnBounce, surface: str = "v_p") -> tuple[RevealStep, ...]:
    """The steps from v to the velocity after the bounce. surface: what stands before v_p's numbers, such as "v_p = ω × q"."""
    found = drawn.found
    steps = (_ball_velocity(drawn), _surface_velocity(drawn, surface), _relative_velocity(drawn), _split(drawn))
    if found.separates:
        line = f"Δv · n is not below 0: they separate, nothing happens:   v = {two_decimals(found.v)}"
        return (*steps, one_step("nothing happens", [_arrow(drawn, found.v, Role.GOOD, "v after")], [line]))
    return (*steps, _normal_change(drawn), _tangential_change(drawn), _result(drawn), _final(drawn))


def _ball_velocity(drawn: DrawnBounce) -> RevealStep:
    """The velocity before."""
    v, v_0 = drawn.found.v, drawn.found.speed
    line = f"v = {two_decimals(v)},   |v| = v_0 = {v_0:g}"
    return one_step("v, the ball's velocity", [_arrow(drawn, v, Role.PLAIN, "v")], [line])


def _surface_velocity(drawn: DrawnBounce, surface: str) -> RevealStep:
    """The surface's velocity at the touched point."""
    v_p = drawn.found.surface_velocity
    marks = [Arrow(drawn.touched, v_p * drawn.scale, Role.TWO, label="v_p")]
    asked = Prediction("v_p", drawn.touched, drawn.touched + v_p * drawn.scale, drawn.scale) if surface != "v_p" else None
    return one_step("v_p, the surface's velocity", marks, [f"{surface} = {two_decimals(v_p)}"], asked)


def _relative_velocity(drawn: DrawnBounce) -> RevealStep:
    """The ball's velocity as the surface sees it."""
    found, tip = drawn.found, drawn.centre + drawn.found.v * drawn.scale
    dv = found.steps.relative
    marks: list[Mark] = [_arrow(drawn, dv, Role.ONE, "Δv")]
    if found.surface_velocity != 0.0:
        marks.insert(0, Line((tip, drawn.centre + dv * drawn.scale), Role.TWO, None, Stroke.DASHED, "-v_p"))
    line = f"Δv = v - v_p = {two_decimals(dv)}"
    return one_step("Δv, the relative velocity", marks, [line], _asked(drawn, "Δv", dv))


def _split(drawn: DrawnBounce) -> RevealStep:
    """The relative velocity in two parts, and the question whether to go on."""
    steps, p, scale = drawn.found.steps, drawn.centre, drawn.scale
    tip = p + steps.relative * scale
    marks: list[Mark] = [
        Line((p + steps.normal_part * scale, tip), Role.FAINT, None, Stroke.DASHED),
        Line((p + steps.tangential_part * scale, tip), Role.FAINT, None, Stroke.DASHED),
        _arrow(drawn, steps.normal_part, Role.THREE, "Δv_n", Stroke.SOLID),
        _arrow(drawn, steps.tangential_part, Role.FOUR, "Δv_t", Stroke.SOLID),
    ]
    formula = (
        f"Δv · n = {drawn.found.approach:.2f},   Δv_n = (Δv · n) n = {two_decimals(steps.normal_part)}",
        f"Δv_t = Δv - Δv_n = {two_decimals(steps.tangential_part)}",
    )
    return one_step("Δv_n and Δv_t, its two parts", marks, formula, _asked(drawn, "Δv_n", steps.normal_part))


def _normal_change(drawn: DrawnBounce) -> RevealStep:
    """The bounce."""
    change, tip = drawn.found.steps.normal_change, drawn.centre + drawn.found.v * drawn.scale
    end = tip + change * drawn.scale
    marks = [Arrow(tip, change * drawn.scale, Role.THREE, label="Δv'_n")]
    line = f"Δv'_n = -2 Δv_n = {two_decimals(change)}"
    return one_step("Δv'_n, the bounce", marks, [line], Prediction("Δv'_n", tip, end, drawn.scale))


def _tangential_change(drawn: DrawnBounce) -> RevealStep:
    """The friction."""
    found, steps = drawn.found, drawn.found.steps
    start = drawn.centre + (found.v + steps.normal_change) * drawn.scale
    marks = [Arrow(start, steps.tangential_change * drawn.scale, Role.FOUR, label="Δv'_t")]
    name, asked = "Δv'_t, the friction", Prediction("Δv'_t", start, start + steps.tangential_change * drawn.scale, drawn.scale)
    if length(steps.tangential_part) == 0.0:
        return one_step(name, marks, ["Δv'_t = 0, since |Δv_t| = 0"], asked)
    least = min(length(steps.normal_part), length(steps.tangential_part))
    sign = "-" if found.friction else ""
    size = f"{sign}{found.friction:g} · {least:.2f} Δv_t / |Δv_t|"
    line = f"Δv'_t = -μ_p min(|Δv_n|, |Δv_t|) Δv_t / |Δv_t| = {size} = {two_decimals(steps.tangential_change)}"
    return one_step(name, marks, [line], asked)


def _result(drawn: DrawnBounce) -> RevealStep:
    """The sum."""
    result = drawn.found.steps.result
    marks = [_arrow(drawn, result, Role.PLAIN, "v_res", Stroke.DASHED)]
    line = f"v_res = v + Δv'_n + Δv'_t = {two_decimals(result)},   |v_res| = {length(result):.2f}"
    return one_step("v_res, the sum", marks, [line], _asked(drawn, "v_res", result))


def _final(drawn: DrawnBounce) -> RevealStep:
    """The reset to the fixed speed, and what is beyond the source."""
    found, velocity = drawn.found, drawn.found.steps.velocity
    u, v_0 = found.surface_speed, found.speed
    if found.stopped:
        line = f"v_res = 0 has no direction:   v := v_0 n = {two_decimals(velocity)}"
    elif found.overtaken and abs(u) < v_0:
        along = math.sqrt(v_0 - u) * math.sqrt(v_0 + u)
        line = (
            f"v_0 v_res / |v_res| is slower than u = v_p · n = {u:.2f}:   v := u n + {along:.2f} t = {two_decimals(velocity)}"
        )
    elif found.overtaken:
        line = f"u = v_p · n = {u:.2f} is faster than v_0:   v := v_0 n = {two_decimals(velocity)}"
    else:
        line = f"v := v_0 v_res / |v_res| = {two_decimals(velocity)}"
    marks = [_arrow(drawn, velocity, Role.GOOD, "v after")]
    return one_step("v after the bounce", marks, [line], _asked(drawn, "v after", velocity))


def _arrow(drawn: DrawnBounce, velocity: complex, role: Role, label: str, stroke: Stroke = Stroke.THICK) -> Arrow:
    """A velocity of the ball."""
    return Arrow(drawn.centre, velocity * drawn.scale, role, None, stroke, label)


def _asked(drawn: DrawnBounce, name: str, velocity: complex) -> Prediction:
    """A velocity of the ball, to be predicted."""
    return Prediction(name, drawn.centre, drawn.centre + velocity * drawn.scale, drawn.scale)
