"""The source's algorithm taken literally, as the slides have it: discrete, once a frame, its errors included.

`advance` here has the shape of `physics.advance`, so a game can be flown on it: `python -m game --physics source`.
Where the slides' own words give another answer than the functions of the same name in this package, they are written out
below; `broad_phase`, `narrow_phase_case_1` and the formulas of the response are the same. "Beyond the source" in the
documentation has every difference.
"""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from physics.broad_phase import broad_phase, in_band
from physics.free_flight import FreeFlight
from physics.narrow_phase import contact
from physics.polar import min_difference, to_cartesian, to_polar
from physics.response import response_steps
from physics.shapes import Arena, Ball, Ring
from physics.step import Hit, Step
from physics.tolerances import STOPPED
from physics.vectors import dot, length

FRAME = 1.0 / 60.0
"""Seconds between two tests for an overlap."""

_ROUNDING = 1e-9
"""Seconds. Ticks that add up to a frame may miss it by so much."""


class SlidesBounce(NamedTuple):
    """A bounce as the slides see one: indices of the ball, the ring and the slot; the normal; the velocity afterwards."""

    ball: int
    ring: int
    slot: int
    normal: complex
    after: complex


def bounces(arena: Arena, speed: float) -> tuple[SlidesBounce, ...]:
    """The bounces of all balls where they are, by the slides' functions; a brick that breaks leaves the next ball a gap."""
    layers, found = arena.layers, []
    for index, ball in enumerate(arena.balls):
        bounce = _bounce(index, ball, arena.rings, layers, speed)
        if bounce is not None:
            found.append(bounce)
            layers = _after_hit(layers, bounce)
    return tuple(found)


def advance(
    arena: Arena,
    dt: float,
    speed: float,
    flight: FreeFlight | None = None,
    bounces: Callable[[Arena, float], Sequence[SlidesBounce]] = bounces,
) -> Step:
    """The arena dt seconds later: everything moves; once a frame, every ball's overlap is tested and answered.

    dt: seconds, finite and >= 0, else ValueError. speed: every ball's fixed speed v_0. flight: `Step.flight` of the tick
    before, which here counts the seconds since the last test. bounces: what tests and answers, such as a student's functions.
    By the slides' a ball is tested against the first ring, in their order, whose band it is in; the paddles come first.
    """
    if not 0.0 <= dt < math.inf:
        raise ValueError(f"dt must be finite and at least 0, not {dt}")
    since = dt if flight is None else flight[1] + dt
    moved = Arena(
        tuple([ball.moved(dt) for ball in arena.balls]), tuple([ring.turned(dt) for ring in arena.rings]), arena.layers
    )
    if since < FRAME - _ROUNDING:
        return Step(moved, (), 0, 0, (moved, since, ()))
    later, hits = answered(moved, bounces(moved, speed), dt)
    return Step(later, hits, 0, 0, (later, 0.0, ()))


def answered(arena: Arena, bounces: Sequence[SlidesBounce], time: float) -> tuple[Arena, tuple[Hit, ...]]:
    """The arena after its balls have bounced where they are, and the hits. time: of the hits, seconds after the start."""
    layers, balls, hits = arena.layers, list(arena.balls), []
    for bounce in bounces:
        ball = arena.balls[bounce.ball]
        balls[bounce.ball] = Ball(ball.position, bounce.after, ball.radius)
        layers = _after_hit(layers, bounce)
        found = contact(ball, arena.rings[bounce.ring], bounce.slot)._replace(normal=bounce.normal)
        left = layers[bounce.ring][bounce.slot]
        hits.append(Hit(time, bounce.ball, bounce.ring, bounce.slot, found, ball.velocity, bounce.after, left))
    return Arena(tuple(balls), arena.rings, layers), tuple(hits)


def _bounce(
    index: int, ball: Ball, rings: Sequence[Ring], layers: Sequence[Sequence[int]], speed: float
) -> SlidesBounce | None:
    """The bounce of a ball that overlaps a sector of the first ring whose band it is in, and approaches it."""
    for k, ring in enumerate(rings):
        if in_band(length(ball.position), ball.radius, ring):
            slot = nearest_living(ball.position, ring, layers[k])
            normal = None if slot is None else normal_at(ball, ring, layers[k])
            if slot is None or normal is None:
                return None
            surface_velocity = ring.surface_velocity(to_cartesian(ring.radius, ring.angle(slot)))
            if dot(ball.velocity - surface_velocity, normal) >= 0.0:
                return None
            after = slides_response(ball.velocity, normal, surface_velocity, ring.friction, speed)
            return SlidesBounce(index, k, slot, normal, 0j if after is None else after)
    return None


def _after_hit(layers: tuple[tuple[int, ...], ...], bounce: SlidesBounce) -> tuple[tuple[int, ...], ...]:
    """The layers without the one that a bounce takes, where its slot can break."""
    row, slot = layers[bounce.ring], bounce.slot
    if row[slot] <= 0:
        return layers
    row = (*row[:slot], row[slot] - 1, *row[slot + 1 :])
    return (*layers[: bounce.ring], row, *layers[bounce.ring + 1 :])


def nearest_living(p: complex, ring: Ring, alive: Sequence[int]) -> int | None:
    """The living slot nearest in angle, the first of equals, by looking at every one of them; None where none is left."""
    living = [slot for slot in range(ring.count) if alive[slot] != 0]
    theta = to_polar(p)[1]
    return min(living, key=lambda slot: min_difference(theta, ring.angle(slot)), default=None)


def normal_at(ball: Ball, ring: Ring, alive: Sequence[int]) -> complex | None:
    """The slides' pages in a row: the band, the search for the nearest sector, case 1 or case 2; None without contact."""
    distance, theta = to_polar(ball.position)
    positions = [(ring.radius, ring.angle(slot)) for slot in range(ring.count) if alive[slot] != 0]
    if not positions or distance == 0.0 or not in_band(distance, ball.radius, ring):
        return None
    return broad_phase(
        ball.position, ball.radius, theta, positions, ring.half_width, ring.half_angle, slides_narrow_phase_case_2
    )


def slides_normalize_angle(angle: float) -> float:
    """The angle folded by a plain remainder: 2 pi itself for -1e-17."""
    return angle % math.tau


def slides_on_left(a: float, b: float) -> bool:
    """Whether a is reached from b by turning counter-clockwise less than half a turn; any angles."""
    return 0.0 < slides_normalize_angle(a - b) < math.pi


def slides_closest_point_on_line(a: complex, b: complex, p: complex) -> complex | None:
    """The foot of the perpendicular from p to the line AB, endless on both sides; None where A = B leaves no line."""
    square = dot(b - a, b - a)
    return None if square == 0.0 else a + (b - a) * (dot(p - a, b - a) / square)


def slides_end(theta: float, angle: float, half_angle: float) -> float:
    """Angle of the end that the slides look at: theta_p + sign phi_p, sign = 1 if on_left(theta, theta_p + phi_p) else -1."""
    return angle + half_angle if slides_on_left(theta, angle + half_angle) else angle - half_angle


def slides_narrow_phase_case_2(
    p: complex, ball_radius: float, theta: float, radius: float, angle: float, half_width: float, half_angle: float
) -> complex | None:
    """(p - q) / |p - q| if |p - q| is in (0, r), else None, with q on the line AB."""
    end = slides_end(theta, angle, half_angle)
    a, b = to_cartesian(radius - half_width, end), to_cartesian(radius + half_width, end)
    q = slides_closest_point_on_line(a, b, p)
    distance = 0.0 if q is None else length(p - q)
    return (p - q) / distance if q is not None and 0.0 < distance < ball_radius else None


def slides_response(v: complex, normal: complex, surface_velocity: complex, friction: float, speed: float) -> complex | None:
    """v := v_0 v_res / |v_res|; None for 0 / 0, also where v_res is 0 but for rounding. v itself for a pair that separates."""
    steps = response_steps(v, normal, surface_velocity, friction, speed)
    if dot(steps.relative, normal) >= 0.0:
        return v
    size = length(steps.result)
    return None if size <= STOPPED * speed else steps.result * (speed / size)
