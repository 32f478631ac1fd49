"""v_res = 0: a surface that retreats at half the ball's speed."""

import math

from game.lab.kit.cited_line import Deciding, code, source
from game.lab.kit.marks import two_decimals
from game.lab.kit.parameters import Given, Number
from game.lab.kit.picture import Picture
from game.lab.kit.scene import Claim, Motion, Preset, Scene, View
from game.lab.source import touched_end
from game.lab.source.touched_end import NORMAL, Answered, Running, answered, clearance, panes
from physics import collision_response, dot, length

_RUN = 30


def _picture(given: Given, state: Running) -> Picture:
    """The ball of the source, and ours."""
    bounce = answered(given)
    return Picture(panes(bounce, state), _formula(bounce), _deciding(bounce), _note(bounce))


def _formula(bounce: Answered) -> tuple[str, ...]:
    """The source's last two equations."""
    v, u = dot(bounce.ball.velocity, NORMAL), bounce.pace
    compared = f"v · n = {v:.2f},   v_p · n = {u:.2f},   Δv · n = {bounce.approach:.2f}"
    if bounce.approach >= 0.0:
        return (compared, "Δv · n is not below 0: they separate, nothing happens")
    theirs = "0 / 0" if bounce.theirs is None else two_decimals(bounce.theirs)
    return (
        compared,
        f"v_res · n = v · n - 2 Δv · n = 2 v_p · n - v · n = {2.0 * u - v:.2f}",
        f"v_res = {two_decimals(bounce.result)},   |v_res| = {length(bounce.result):.3f}",
        f"the source:   v := v_0 v_res / |v_res| = {theirs}",
        f"here:   v := {two_decimals(bounce.ours)}",
    )


def _deciding(bounce: Answered) -> Deciding:
    """The source's note where it is wrong; else ours."""
    if bounce.stopped:
        return source("Collision response", "v := v_0 v_res / |v_res|,  NOTE: |v_res| > 0")
    if bounce.approach >= 0.0:
        return code(collision_response, "if approach >= 0.0")
    return code(collision_response, "leaving_at(" if bounce.overtaken else "STOPPED * speed")


def _note(bounce: Answered) -> str:
    """What is special."""
    if bounce.approach >= 0.0:
        return "The end retreats faster than the ball follows: they separate."
    if bounce.stopped:
        return "v_res = 0: the end takes all of the ball's speed. It has no direction to be reset in; ours leaves along n."
    if bounce.overtaken:
        return (
            "More than half: v_res points after the retreating end, and the reset to v_0 sends the source's ball into it. "
            "Ours keeps pace with the end."
        )
    return "Less than half: v_res still points along n, and both answers are the same."


def _check(given: Given) -> tuple[Claim, ...]:
    """v_res by its two parts, and what any answer must do."""
    bounce = answered(given)
    v, u, mu = bounce.ball.velocity, bounce.pace, bounce.ring.friction
    met = bounce.approach < 0.0
    slip = abs(v.real)
    parts = math.hypot(2.0 * u - v.imag, slip - mu * min(slip, u - v.imag)) if met else 0.0
    straight = slip < 1e-9 * bounce.speed
    half = abs(v.imag - 2.0 * u) < 1e-13 * bounce.speed
    leaves = dot(bounce.ours, NORMAL)
    return (
        Claim("|v_res| is 2 v_p · n - v · n beside what friction leaves", not met or _same(length(bounce.result), parts)),
        Claim("straight on, v_res = 0 where the end retreats at v_0 / 2", not (met and straight and half) or bounce.stopped),
        Claim("our ball has the speed v_0 all the same", _same(length(bounce.ours), bounce.speed)),
        Claim("and leaves no slower than the end, if v_0 allows", not met or leaves >= min(u, bounce.speed) - 1e-9),
        Claim("stopped dead, it leaves along n", not bounce.stopped or bounce.ours == NORMAL * bounce.speed),
        Claim(
            "where the source has an answer that leaves the surface, ours is the same",
            bounce.theirs is None or bounce.overtaken or length(bounce.ours - bounce.theirs) < 1e-9,
        ),
        Claim(
            "while ω (r_p + w_p) < v_0, ours does not enter the paddle",
            not (met and bounce.possible) or clearance(given, _RUN) > -1e-9,
        ),
    )


def _same(one: float, other: float) -> bool:
    """Equal but for rounding."""
    return abs(one - other) < 1e-9


SCENE = Scene(
    name="stopped-dead",
    title="Response: v_res = 0",
    idea="An end that retreats at half the ball's speed stops it dead: the source's v_res / |v_res| is then 0 / 0.",
    functions=("collision_response",),
    parameters=(
        Number("u", "u", "", -8.0, 8.0, -2.0, 0.1, "v_p · n: below 0 the end retreats"),
        Number("speed", "v_0", "", 0.5, 10.0, 4.0, 0.1, "the ball's fixed speed"),
        Number("heading", "ψ", "°", 0.0, 360.0, 270.0, 0.5, "direction of v"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "friction"),
    ),
    handles=touched_end.handles(),
    view=View(5.9 + 0.2j, 2.6 + 3.0j),
    shows=Motion(touched_end.start, touched_end.step, _picture, ticks=240),
    check=_check,
    rows=(4,),
    presets=(
        Preset("half the speed: stopped dead", "u=-2"),
        Preset("a little less", "u=-1.9"),
        Preset("a little more", "u=-2.1"),
        Preset("at rest", "u=0"),
        Preset("rough and slanting: stopped, too", "heading=290&mu=1&u=-1.8793852415718166"),
        Preset("as fast as the ball: separating", "u=-4"),
    ),
)
