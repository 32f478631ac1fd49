"""The carried ball: the reset to v_0 leaves it slower than the surface that hit it."""

import math

from game.lab.kit.cited_line import Deciding, code
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Picture
from game.lab.kit.scene import Claim, Motion, Preset, Scene, View
from game.lab.source import touched_end
from game.lab.source.touched_end import NORMAL, REACH, Answered, Running, answered, clearance, panes
from physics import collision_response, cross, dot, length, to_cartesian
from physics.response import leaving_at

_DIRECTIONS, _RUN = 72, 30


def _picture(given: Given, state: Running) -> Picture:
    """The ball of the source, and ours."""
    bounce = answered(given)
    return Picture(panes(bounce, state), _formula(bounce), _deciding(bounce), _note(bounce))


def _formula(bounce: Answered) -> tuple[str, ...]:
    """The surface's velocity, the reset, and what it is compared with."""
    u, v_0 = bounce.pace, bounce.speed
    first = f"v_p = ω × q,   ω = {bounce.ring.spin:.3f} rad/s,   |q| = {REACH:g}:   u = v_p · n = {u:.2f}"
    if bounce.approach >= 0.0:
        return (first, f"Δv · n = {bounce.approach:.2f} is not below 0: they separate, nothing happens")
    if bounce.theirs is None:
        return (first, "v_res = 0: see the scene stopped-dead")
    leaves = dot(bounce.theirs, NORMAL)
    reset = f"v_res = {two_decimals(bounce.result)},   v_0 v_res / |v_res| = {two_decimals(bounce.theirs)}"
    if not bounce.overtaken:
        return (first, reset, f"its part along n is {leaves:.2f} ≥ u: the ball gets away")
    along = f"sqrt({v_0:g}² - {abs(u):g}²) = {math.sqrt(v_0 * v_0 - u * u):.2f}" if abs(u) < v_0 else "0, for |u| ≥ v_0"
    return (
        first,
        reset,
        f"its part along n is {leaves:.2f} < u: the surface would overtake the ball",
        f"so v = u n + t sqrt(v_0² - u²),   {along}",
        f"v = {two_decimals(bounce.ours)},   |v| = {length(bounce.ours):.2f}",
    )


def _deciding(bounce: Answered) -> Deciding:
    """The comparison with the surface, or what came before it."""
    if bounce.approach >= 0.0:
        return code(collision_response, "if approach >= 0.0")
    if bounce.stopped:
        return code(collision_response, "STOPPED * speed")
    return code(leaving_at, "normal * normal_speed +") if bounce.overtaken else code(collision_response, "leaving_at(")


def _note(bounce: Answered) -> str:
    """What is special."""
    if bounce.approach >= 0.0:
        return "The ball flies away faster than the end comes after it."
    if bounce.pace >= bounce.speed:
        return "u ≥ v_0: no velocity of length v_0 keeps up with this end. The levels must keep ω (r_p + w_p) < v_0."
    if bounce.overtaken and length(bounce.result) < bounce.speed:
        return "The reset makes a slow v_res faster: the source's ball flies into the retreating end. Ours is carried."
    if bounce.overtaken:
        return "The bounce made the ball faster than v_0; the reset takes so much that the end overtakes it. Ours is carried."
    return "The ball gets away: both answers are the same." if bounce.theirs is not None else ""


def _check(given: Given) -> tuple[Claim, ...]:
    """The answer is the best there is."""
    bounce = answered(given)
    u, v_0, ours = bounce.pace, bounce.speed, bounce.ours
    met = bounce.approach < 0.0
    fits = met and abs(u) < v_0
    carried = fits and bounce.overtaken
    tries = [to_cartesian(v_0, math.tau * k / _DIRECTIONS) for k in range(_DIRECTIONS)]
    best = max([dot(v, bounce.result) for v in tries if dot(v, NORMAL) >= u], default=-math.inf)
    return (
        Claim("the speed is v_0", abs(length(ours) - v_0) < 1e-9),
        Claim("the ball leaves no slower than the end, if v_0 allows", not fits or dot(ours, NORMAL) >= u - 1e-9),
        Claim(
            "of all velocities of length v_0 that keep up with the end, ours is nearest to v_res",
            not fits or bounce.stopped or dot(ours, bounce.result) >= best - 1e-9,
        ),
        Claim("a carried ball keeps the end's pace", not carried or abs(dot(ours, NORMAL) - u) < 1e-9),
        Claim("and the sense in which it slid", not carried or cross(NORMAL, ours) * cross(NORMAL, bounce.result) >= -1e-9),
        Claim("an end faster than v_0 sends it straight ahead", not met or u < v_0 or ours == NORMAL * v_0),
        Claim(
            "while ω (r_p + w_p) < v_0, ours does not enter the paddle",
            not (met and bounce.possible) or clearance(given, _RUN) > -1e-9,
        ),
    )


SCENE = Scene(
    name="carried",
    title="Response: the carried ball",
    idea="A fast end makes the ball faster than v_0; reset to v_0, it would be overtaken, so it is carried at the end's pace.",
    functions=("collision_response",),
    parameters=(
        Number("u", "u", "", -8.0, 8.0, 4.5, 0.1, "v_p · n: above 0 the end comes after the ball"),
        Number("speed", "v_0", "", 0.5, 10.0, 5.0, 0.1, "the ball's fixed speed"),
        Number("heading", "ψ", "°", 0.0, 360.0, 10.0, 0.5, "direction of v"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.0, 0.01, "friction"),
    ),
    handles=touched_end.handles(),
    view=View(6.6 + 1.4j, 3.2 + 3.2j),
    shows=Motion(touched_end.start, touched_end.step, _picture, ticks=240),
    check=_check,
    rows=(5,),
    presets=(
        Preset("carried", "u=4.5&heading=10"),
        Preset("hit from behind: away it goes", "u=2&heading=15"),
        Preset("met head-on: away it goes", "u=2&heading=290"),
        Preset("the other way along the end", "u=4.5&heading=170"),
        Preset("a retreating end carries, too", "u=-3&heading=280"),
        Preset("faster than v_0", "u=6&heading=60"),
    ),
)
