"""The squeezed ball: two rings turn against each other and close on it."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    AnnularSector,
    Arrow,
    Circle,
    Disc,
    Line,
    Mark,
    Picture,
    PointMark,
    Role,
    Stroke,
    Toggle,
    single,
)
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, contact, length, to_cartesian
from physics.escape import freed
from physics.tolerances import MAX_IMPACTS

_RADIUS, _HALF_WIDTH, _HALF_ANGLE = 10.0, 0.6, 0.3
_SCALE = 0.08
_RUN = 90
_TRAIL = 64


class _Squeeze(NamedTuple):
    """The arena, and what has happened to the ball.

    hits: in the last tick. most: in any tick. dropped: ticks whose rest was dropped. freed: times the ball was put outside.
    trail: the ball's centre at its last bounces and ends of ticks.
    """

    arena: Arena
    hits: int
    most: int
    dropped: int
    freed: int
    trail: tuple[complex, ...]


def _start(given: Given) -> _Squeeze:
    """Two paddles, one on each side of the x axis, and the ball between them."""
    spin, gap = given.number("spin"), given.angle("gap")
    upper = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, _HALF_ANGLE + gap, -spin)
    lower = Ring(_RADIUS, _HALF_WIDTH, _HALF_ANGLE, 1, -_HALF_ANGLE - gap, spin)
    velocity = to_cartesian(given.number("speed"), given.angle("heading"))
    ball = Ball(given.point("ball"), velocity, given.number("r"))
    return _Squeeze(Arena((ball,), (upper, lower), ((PERMANENT,), (PERMANENT,))), 0, 0, 0, 0, (ball.position,))


def _step(given: Given, state: _Squeeze) -> _Squeeze:
    """A tick later."""
    step = advance(state.arena, TICK, given.number("speed"))
    r = step.arena.balls[0].radius
    bounces = [hit.contact.point + hit.contact.normal * r for hit in step.hits]
    trail = (*state.trail, *bounces, step.arena.balls[0].position)[-_TRAIL:]
    return _Squeeze(
        step.arena,
        len(step.hits),
        max(state.most, len(step.hits)),
        state.dropped + step.dropped,
        state.freed + step.freed,
        trail,
    )


def _picture(given: Given, state: _Squeeze) -> Picture:
    """Both paddles, the ball, its path, and the bearing on which it was put outward."""
    ball, (upper, lower) = state.arena.balls[0], state.arena.rings
    marks: list[Mark] = [
        AnnularSector(upper.radius, upper.half_width, upper.phase, upper.half_angle, Role.SECTOR),
        AnnularSector(lower.radius, lower.half_width, lower.phase, lower.half_angle, Role.OTHER),
    ]
    marks.append(Circle(given.point("ball"), ball.radius, Role.GHOST, None, Stroke.DASHED))
    marks += [_spin_arrow(ring) for ring in (upper, lower)]
    if state.freed:
        marks.append(Line((0j, ball.position * (20.0 / max(length(ball.position), 1.0))), Role.FAINT, None, Stroke.DASHED))
    marks.append(Line(state.trail, Role.OURS, Toggle.SWEPT))
    marks += [Circle(ball.position, ball.radius, Role.GOOD if state.freed else Role.OURS, None, Stroke.THICK)]
    marks += [Disc(ball.position, ball.radius, Role.BALL), PointMark(ball.position, Role.FAINT)]
    marks.append(Arrow(ball.position, ball.velocity * _SCALE, Role.PLAIN, label="v"))
    return single(tuple(marks), _formula(state), _cited(state), _note(given, state))


def _spin_arrow(ring: Ring) -> Arrow:
    """The velocity of a paddle's end."""
    side = -1.0 if ring.spin < 0.0 else 1.0
    middle = to_cartesian(_RADIUS, ring.phase + side * (_HALF_ANGLE - 0.03))
    return Arrow(middle, ring.surface_velocity(middle) * _SCALE, Role.ONE, label="")


def _formula(state: _Squeeze) -> tuple[str, ...]:
    """The distance between the ends, and the counts."""
    ball, (upper, lower) = state.arena.balls[0], state.arena.rings
    between = upper.phase - upper.half_angle - (lower.phase + lower.half_angle)
    between = math.remainder(between, math.tau)
    width = 2.0 * length(ball.position) * math.sin(between / 2.0)
    gap = f"2 |p| sin(φ) = {width:.4f}" if width >= 0.0 else f"no gap, the ends overlap by {-width:.4f}"
    return (
        f"between the ends, at the ball's distance:   {gap},   2 r = {2.0 * ball.radius:g}",
        f"bounces in this tick:   {state.hits} of at most {MAX_IMPACTS},   most in a tick so far {state.most}",
        f"ticks whose rest was dropped: {state.dropped}",
        f"times put at the nearest free position outward: {state.freed}",
    )


def _cited(state: _Squeeze) -> CitedLine:
    """The line that puts the ball outward, or the one that flies it."""
    if state.freed:
        return code_line(freed, "return _outward(ball, rings, layers)")
    return code_line(advance, "return _flown(free, _moved_balls(arena, free), dt, speed)")


def _note(given: Given, state: _Squeeze) -> str:
    """What is happening."""
    if given.number("spin") == 0.0:
        return "ω = 0: nothing closes, and the ball goes on bouncing."
    if state.freed and not state.dropped:
        return "The ball overlapped an end before it flew: it is pushed out, or put outward where there is no room."
    if state.freed:
        return "No motion at v_0 could free it: after 32 bounces it is put at the nearest free position outward, and counted."
    if state.hits:
        return "The nearer the ends, the more bounces in a tick: v_0 is too slow to get away from both."
    return "The two rings turn against each other: their ends close on the ball."


def _check(given: Given) -> tuple[Claim, ...]:
    """A third of a second: no overlap at the end of any tick, a bounded number of bounces, and every push counted."""
    state, speed = _start(given), given.number("speed")
    least, most, put, unexplained = math.inf, 0, 0, 0
    touching = True
    for _ in range(_RUN):
        before = state
        state = _step(given, state)
        gap = min(_gaps(state.arena))
        least, most = min(least, gap), max(most, state.hits)
        if state.freed > before.freed and state.dropped > before.dropped:
            put += 1
            touching &= gap < 1e-6
        unexplained += state.freed > before.freed and min(_gaps(before.arena)) > -1e-12 and state.dropped == before.dropped
    ball = state.arena.balls[0]
    return (
        Claim("the ball overlaps nothing at the end of any tick", least > -1e-9),
        Claim("no tick has more than 32 bounces", most <= MAX_IMPACTS),
        Claim("a ball that is put outside after its tick touches what it was put away from", touching),
        Claim("the ball is put elsewhere only after an overlap or a dropped tick", unexplained == 0),
        Claim("a tick with 32 bounces is counted as dropped", state.dropped > 0 or most < MAX_IMPACTS),
        Claim("the speed is v_0 at the end", abs(length(ball.velocity) - speed) < 1e-9),
    )


def _gaps(arena: Arena) -> list[float]:
    """Between the ball and each paddle."""
    return [contact(arena.balls[0], ring, 0).gap for ring in arena.rings]


SCENE = LabScene(
    name="squeezed",
    title="The squeezed ball",
    idea="Two ends close on the ball, and no motion at v_0 can free it: after 32 bounces in a tick it is put outward.",
    functions=("advance",),
    parameters=(
        Number("spin", "ω", "rad/s", 0.0, 3.0, 0.2, 0.05, "of both rings, against each other"),
        Number("gap", "φ_0", "°", 0.5, 20.0, 5.0, 0.5, "half of the angle between the ends at first"),
        Point("ball", "p", -12.0, 12.0, 9.8 + 0.1j, meaning="the ball's centre at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 90.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 1.0, 20.0, 8.0, 0.5, "the ball's fixed speed"),
        Number("r", "r", "", 0.1, 1.0, 0.3, 0.05, "the ball's radius"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
    ),
    view_box=ViewBox(10.1 + 0j, 2.9 + 1.8j),
    shows=Motion(_start, _step, _picture, ticks=240),
    check=_check,
    rows=(8,),
    presets=(
        Preset("closing slowly", "spin=0.2"),
        Preset("closing fast", "spin=2"),
        Preset("it gets out in time", "heading=50&spin=0.2"),
        Preset("put between them, too wide from the start", "gap=1&spin=0.2"),
        Preset("nothing closes", "spin=0"),
    ),
)
