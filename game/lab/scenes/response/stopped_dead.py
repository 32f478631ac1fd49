"""v_res = 0: a surface that retreats at half the ball's speed."""

import math

from game.lab.kit import end_bounce as ends
from game.lab.kit.bounce import response_line
from game.lab.kit.cited_line import CitedLine, source_line
from game.lab.kit.end_bounce import NORMAL, EndBounce, EndFlight, EndWords, end_bounce, end_picture, least_gap
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Picture
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from physics import dot, length

_RUN = 30


def _picture(given: Given, state: EndFlight) -> Picture:
    """The ball of the source, and ours."""
    after = end_bounce(given)
    return end_picture(after, state, EndWords(_formula(after), 1, _cited(after), _note(after)))


def _formula(after: EndBounce) -> tuple[str, ...]:
    """The source's last two equations."""
    found, steps = after.found, after.found.steps
    v, u = dot(found.v, NORMAL), found.surface_speed
    compared = f"v · n = {v:.2f},   v_p · n = {u:.2f},   Δv · n = {found.approach:.2f}"
    if found.separates:
        return (compared, "Δv · n is not below 0: they separate, nothing happens")
    by_source = "0 / 0" if after.by_source is None else two_decimals(after.by_source)
    return (
        compared,
        f"v_res · n = v · n - 2 Δv · n = 2 v_p · n - v · n = {2.0 * u - v:.2f}",
        f"v_res = {two_decimals(steps.result)},   |v_res| = {length(steps.result):.3f}",
        f"the source:   v := v_0 v_res / |v_res| = {by_source}",
        f"here:   v := {two_decimals(steps.velocity)}",
    )


def _cited(after: EndBounce) -> CitedLine:
    """The source's note where it does not hold; else the line of the physics."""
    if after.found.stopped:
        return source_line("Collision response", "v := v_0 v_res / |v_res|,  NOTE: |v_res| > 0")
    return response_line(after.found)


def _note(after: EndBounce) -> str:
    """What is special about these values."""
    found = after.found
    if found.separates:
        return "The end retreats faster than the ball follows: they separate."
    if found.stopped:
        return "v_res = 0: the end takes all of the ball's speed, and no direction is left to reset. Ours leaves along n."
    if found.overtaken:
        return (
            "More than half: v_res points after the retreating end, and the reset to v_0 sends the source's ball into it. "
            "Ours is carried at the end's speed."
        )
    return "Less than half: v_res still points along n, and both answers are the same."


def _check(given: Given) -> tuple[Claim, ...]:
    """v_res by its two parts, and what any answer must do."""
    after = end_bounce(given)
    found, v_res, result = after.found, after.found.steps.result, after.found.steps.velocity
    v, u = found.v, found.surface_speed
    met = not found.separates
    slip = abs(v.real)
    parts = math.hypot(2.0 * u - v.imag, slip - found.friction * min(slip, u - v.imag)) if met else 0.0
    straight = slip < 1e-9 * found.speed
    half = abs(v.imag - 2.0 * u) < 1e-13 * found.speed
    leaves = dot(result, NORMAL)
    return (
        Claim("the parts of v_res are 2 v_p · n - v · n and what friction leaves", not met or _same(length(v_res), parts)),
        Claim("straight on, v_res = 0 where the end retreats at v_0 / 2", not (met and straight and half) or found.stopped),
        Claim("our ball has the speed v_0 all the same", _same(length(result), found.speed)),
        Claim("it leaves no slower than the end, if v_0 allows", not met or leaves >= min(u, found.speed) - 1e-9),
        Claim("where v_res = 0, it leaves along n", not found.stopped or result == NORMAL * found.speed),
        Claim(
            "where the source has an answer that leaves the surface, ours is the same",
            after.by_source is None or found.overtaken or length(result - after.by_source) < 1e-9,
        ),
        Claim(
            "while ω (r_p + w_p) < v_0, ours does not enter the paddle",
            not (met and after.ring_is_slow) or least_gap(given, _RUN) > -1e-9,
        ),
    )


def _same(one: float, other: float) -> bool:
    """Equal but for rounding."""
    return abs(one - other) < 1e-9


SCENE = LabScene(
    name="stopped-dead",
    title="Response: v_res = 0",
    idea="An end that retreats at half the ball's speed takes all of it: the source's v_res / |v_res| is then 0 / 0.",
    functions=("collision_response",),
    parameters=(
        Number("u", "u", "", -8.0, 8.0, -2.0, 0.1, "v_p · n: below 0 the end retreats"),
        Number("speed", "v_0", "", 0.5, 10.0, 4.0, 0.1, "the ball's fixed speed"),
        Number("heading", "ψ", "°", 0.0, 360.0, 270.0, 0.5, "direction of v"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "friction"),
    ),
    handles=ends.handles(),
    view_box=ViewBox(5.9 + 0.2j, 2.6 + 3.0j),
    shows=Motion(ends.start, ends.step, _picture, ticks=240),
    check=_check,
    rows=(4,),
    presets=(
        Preset("half the speed: stopped dead", "u=-2"),
        Preset("a little less", "u=-1.9"),
        Preset("a little more", "u=-2.1"),
        Preset("at rest", "u=0"),
        Preset("rough and slanting: stopped as well", "heading=290&mu=1&u=-1.8793852415718166"),
        Preset("as fast as the ball: separating", "u=-4"),
    ),
)
