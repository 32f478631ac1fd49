"""The carried ball: the reset to v_0 leaves it slower than the surface that hit it."""

import math

from game.lab.kit import end_bounce as ends
from game.lab.kit.bounce import response_line
from game.lab.kit.end_bounce import NORMAL, REACH, EndBounce, EndFlight, EndWords, end_bounce, end_picture, least_gap
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Picture
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from physics import cross, dot, length, to_cartesian

_DIRECTIONS, _RUN = 72, 30


def _picture(given: Given, state: EndFlight) -> Picture:
    """The ball of the source, and ours."""
    after = end_bounce(given)
    words = EndWords(_formula(after), 2 if after.found.overtaken else 1, response_line(after.found), _note(after))
    return end_picture(after, state, words)


def _formula(after: EndBounce) -> tuple[str, ...]:
    """The surface's velocity, the reset, and what it is compared with."""
    found, steps = after.found, after.found.steps
    u, v_0 = found.surface_speed, found.speed
    first = f"v_p = ω × q,   ω = {after.ring.spin:.3f} rad/s,   |q| = {REACH:g}:   u = v_p · n = {u:.2f}"
    if found.separates:
        return (first, f"Δv · n = {found.approach:.2f} is not below 0: they separate, nothing happens")
    if after.by_source is None:
        return (first, "v_res = 0: see the scene stopped-dead")
    leaves = dot(after.by_source, NORMAL)
    reset = f"v_res = {two_decimals(steps.result)},   v_0 v_res / |v_res| = {two_decimals(after.by_source)}"
    if not found.overtaken:
        return (first, reset, f"its part along n is {leaves:.2f} ≥ u: the ball gets away")
    along = f"sqrt({v_0:g}² - {abs(u):g}²) = {math.sqrt(v_0 * v_0 - u * u):.2f}" if abs(u) < v_0 else "0, for |u| ≥ v_0"
    return (
        first,
        reset,
        f"its part along n is {leaves:.2f} < u: the surface would overtake the ball",
        f"so v = u n + t sqrt(v_0² - u²),   {along}",
        f"v = {two_decimals(steps.velocity)},   |v| = {length(steps.velocity):.2f}",
    )


def _note(after: EndBounce) -> str:
    """What is special about these values."""
    found = after.found
    if found.separates:
        return "The ball flies away faster than the end comes after it."
    if found.surface_speed >= found.speed:
        return "u ≥ v_0: no velocity of length v_0 keeps up with this end. Every level keeps ω (r_p + w_p) < v_0."
    if found.overtaken and length(found.steps.result) < found.speed:
        return "The reset makes a slow v_res faster: the source's ball flies into the retreating end. Ours is carried."
    if found.overtaken:
        return "The bounce made the ball faster than v_0. After the reset the end would overtake it, so ours is carried."
    return "The ball gets away: both answers are the same." if after.by_source is not None else ""


def _check(given: Given) -> tuple[Claim, ...]:
    """The velocity of a carried ball is the best there is."""
    after = end_bounce(given)
    found, v_res, v = after.found, after.found.steps.result, after.found.steps.velocity
    u, v_0 = found.surface_speed, found.speed
    met = not found.separates
    fits = met and abs(u) < v_0
    carried = fits and found.overtaken
    tries = [to_cartesian(v_0, math.tau * k / _DIRECTIONS) for k in range(_DIRECTIONS)]
    best = max([dot(one, v_res) for one in tries if dot(one, NORMAL) >= u], default=-math.inf)
    return (
        Claim("the speed is v_0", abs(length(v) - v_0) < 1e-9),
        Claim("the ball leaves no slower than the end, if v_0 allows", not fits or dot(v, NORMAL) >= u - 1e-9),
        Claim(
            "of all velocities of length v_0 that keep up with the end, ours is nearest to v_res",
            not fits or found.stopped or dot(v, v_res) >= best - 1e-9,
        ),
        Claim("a carried ball has the end's speed along n", not carried or abs(dot(v, NORMAL) - u) < 1e-9),
        Claim("it slides in the same sense as v_res", not carried or cross(NORMAL, v) * cross(NORMAL, v_res) >= -1e-9),
        Claim("an end faster than v_0 sends the ball along n", not met or u < v_0 or v == NORMAL * v_0),
        Claim(
            "while ω (r_p + w_p) < v_0, ours does not enter the paddle",
            not (met and after.ring_is_slow) or least_gap(given, _RUN) > -1e-9,
        ),
    )


SCENE = LabScene(
    name="carried",
    title="Response: the carried ball",
    idea="Reset to v_0, the ball would be slower than the end that hit it. It is carried: its speed along n is the end's.",
    functions=("collision_response",),
    parameters=(
        Number("u", "u", "", -8.0, 8.0, 4.5, 0.1, "v_p · n: above 0 the end comes after the ball"),
        Number("speed", "v_0", "", 0.5, 10.0, 5.0, 0.1, "the ball's fixed speed"),
        Number("heading", "ψ", "°", 0.0, 360.0, 10.0, 0.5, "direction of v"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.0, 0.01, "friction"),
    ),
    handles=ends.handles(),
    view_box=ViewBox(6.6 + 1.4j, 3.2 + 3.2j),
    shows=Motion(ends.start, ends.step, _picture, ticks=240),
    check=_check,
    rows=(5,),
    presets=(
        Preset("carried", "u=4.5&heading=10"),
        Preset("hit from behind: the ball gets away", "u=2&heading=15"),
        Preset("met head-on: the ball gets away", "u=2&heading=290"),
        Preset("inward along the end", "u=4.5&heading=170"),
        Preset("a retreating end carries, too", "u=-3&heading=280"),
        Preset("faster than v_0", "u=6&heading=60"),
    ),
)
