"""When does a flying ball first touch a ring, at rest or turning? pymunk's shape-level segment queries answer.

In the frame that turns with the ring every shape stands still, and the ball flies along a curve. Over h seconds a straight
path along its first velocity differs from that curve by at most A h^2 / 2, where A bounds the acceleration in that frame:
w^2 D + 2 |w| |v|, for a spin w, a speed |v| and a largest distance D from the centre. A ball larger by that much, flying
straight, touches no later than the ball on the curve, and a smaller one no earlier: two segment queries give a window, and a
second sweep over that window alone has an h so much shorter that a few sweeps leave nothing but rounding. The distance from
the centre does not depend on the frame: the faces are met where the straight path in the resting frame meets their circles.
"""

import cmath
import math
from typing import NamedTuple

import pymunk

from tools.crosscheck.pymunk_model.ring_model import RingModel

_WEDGE_NOISE = 1e-12
"""Radians: where a face ends, its corner takes over at the same distance."""

_MOST_SWEEPS = 60
"""Of one shape. Four are usual; a graze takes one for each halving of its window down to rounding, about 40."""

NEVER = math.inf
"""Seconds until what does not happen."""


class Window(NamedTuple):
    """Seconds from the start: the first touch is not earlier than `early` nor later than `late`; both may be infinite.

    If two shapes are nowhere farther apart than s, a ball touches one of them no earlier than a ball larger by s touches the
    other, and no later than a ball smaller by s does. That is a proof, also for a graze, which needs no derivative.
    middle: the touch of the ball itself.
    """

    early: float
    middle: float
    late: float


_NO_TOUCH = Window(NEVER, NEVER, NEVER)


class BallFlight(NamedTuple):
    """A ball in the frame of a ring.

    position, velocity: at the start, along the ring's axes but not turning with it. spin: the ring's, rad/s.
    """

    position: complex
    velocity: complex
    ball_radius: float
    spin: float


def first_touch(model: RingModel, flight: BallFlight, span: float, noise: float) -> Window:
    """The first touch with a ring within `span` seconds, in the frame that the ring has at the start.

    noise: world units by which pymunk's shapes may differ from the game's.
    """
    p, v, ball_radius, spin = flight
    speed = abs(v)
    travel = (speed + abs(spin) * (abs(p) + speed * span)) * span  # in the turning frame
    windows = _face_windows(model, flight, span, noise)
    windows += [_convex_touch(start, flight, span, noise) for start in model.pointed_near(p, travel + ball_radius + noise)]
    early, middle, late = _NO_TOUCH
    for window in windows:
        early, middle, late = min(early, window[0]), min(middle, window[1]), min(late, window[2])
    return Window(early, min(max(middle, early), late), late)


def facet_touch(model: RingModel, p: complex, v: complex, ball_radius: float, span: float) -> float:
    """Seconds to the first touch with the chords and ends of a resting ring alone; infinite if there is none within `span`."""
    near = model.facets_near(p, abs(v) * span + ball_radius)
    return min([_time_to_shape(start, p * turn, v * turn, ball_radius) for start, turn in near], default=NEVER)


def _face_windows(model: RingModel, flight: BallFlight, span: float, noise: float) -> list[Window]:
    """The touches with faces: of the two circles, where a living sector lies under the ball at that moment."""
    p, v, ball_radius, _ = flight
    geometry, distance, travel = model.geometry, abs(p), abs(v) * span + noise
    circles = []
    if distance > geometry.radius and distance - travel <= geometry.outer + ball_radius:
        circles.append(model.outer_circle)
    if distance + travel >= geometry.inner - ball_radius and distance - travel <= geometry.inner:
        circles.append(model.inner_circle)
    return [_circle_window(model, flight, circle, span, noise) for circle in circles]


def _circle_window(model: RingModel, flight: BallFlight, circle: pymunk.Circle, span: float, noise: float) -> Window:
    """The touch with a face on one circle."""
    p, v, ball_radius, spin = flight
    times = []
    for slack in (noise, 0.0, -noise):
        if circle is model.outer_circle:
            time = _time_to_shape(circle.point_query((p.real, p.imag)), p, v, ball_radius + slack)
        else:
            time = _time_out_of(circle, p, v, ball_radius + slack)
        if slack > 0.0 and time > span:
            return _NO_TOUCH
        if time < NEVER:
            under = (p + v * time) * cmath.rect(1.0, -spin * time)
            if model.slot_over(under, math.copysign(_WEDGE_NOISE, slack)) is None:
                time = NEVER
        times.append(time)
    return Window(*times)


def _time_out_of(circle: pymunk.Circle, p: complex, v: complex, ball_radius: float) -> float:
    """Seconds until a ball inside a circle touches it: the same path flown backwards enters the circle smaller by the ball.

    0 for a ball that touches already and flies outward, or that is as large as the circle.
    """
    if ball_radius >= circle.radius:
        return 0.0
    duration = _duration(p, v, circle.radius)
    q = p + v * duration
    found = circle.segment_query((q.real, q.imag), (p.real, p.imag), -ball_radius)
    if found is None:
        touching = circle.radius - ball_radius <= abs(p) < circle.radius
        return 0.0 if touching and (p.conjugate() * v).real > 0.0 else NEVER
    return duration * (1.0 - found.alpha)


class _Piece(NamedTuple):
    """The piece of a flight that is swept next, in seconds: from `time` on for `step`; nothing after `stop` matters."""

    time: float
    step: float
    stop: float


class _Curve(NamedTuple):
    """A flight as the turning ring sees it: its bend, the ball, and how far shapes may differ."""

    acceleration: float
    ball_radius: float
    noise: float

    def bend(self, step: float) -> float:
        """World units: how far the curve leaves a straight path in that many seconds."""
        return 0.5 * self.acceleration * step * step


def _convex_touch(start: pymunk.PointQueryInfo, flight: BallFlight, span: float, noise: float) -> Window:
    """The touch with one end or corner within `span` seconds, by sweeps along straight pieces of the curve.

    start: pymunk's query of the shape at the flight's start.
    """
    position, velocity, ball_radius, spin = flight
    speed = abs(velocity)
    acceleration = spin * spin * (abs(position) + speed * span) + 2.0 * abs(spin) * speed
    curve = _Curve(acceleration, ball_radius, noise)
    velocity -= 1j * spin * position
    piece = _Piece(0.0, span, span)
    for _ in range(_MOST_SWEEPS):
        if start.distance <= ball_radius + noise:
            found = _left_behind(start, velocity, curve, piece)
        else:
            found = _swept(start, position, velocity, curve, piece)
        if isinstance(found, Window):
            return found
        if found.time >= found.stop:
            return _NO_TOUCH if found.stop == span else Window(found.stop, found.stop, found.stop)
        if found.time > piece.time:
            position, velocity = _in_turning_frame(flight, found.time)
            start = _asked_again(start, position)
        piece = found
    return Window(piece.time, piece.time, NEVER)


def _left_behind(start: pymunk.PointQueryInfo, velocity: complex, curve: _Curve, piece: _Piece) -> Window | _Piece:
    """The touch of a ball that touches, to within the noise, and approaches; else the piece on which it may come back.

    The distance of a ball that leaves a convex shape with speed u is at least u t - A t^2 / 2.
    """
    leaving = start.gradient.x * velocity.real + start.gradient.y * velocity.imag
    if leaving < 0.0:
        return Window(piece.time, piece.time, piece.time + 2.0 * curve.noise / -leaving)
    free = 2.0 * leaving / curve.acceleration if curve.acceleration > 0.0 else NEVER
    if piece.time + free >= piece.stop:
        return piece._replace(time=piece.stop)
    if free <= 0.0:
        return Window(piece.time, piece.time, NEVER)
    time = piece.time + 0.5 * free
    return _Piece(time, piece.stop - time, piece.stop)


def _swept(start: pymunk.PointQueryInfo, position: complex, velocity: complex, curve: _Curve, piece: _Piece) -> Window | _Piece:
    """The touch on a piece of the flight, if the piece is short enough to tell; else the piece to sweep next."""
    time, step, stop = piece
    _, ball_radius, noise = curve
    bend = curve.bend(step)
    if start.distance <= ball_radius + noise + bend:  # too near to say anything about so long a piece
        return piece._replace(step=0.5 * step)
    early = _time_to_shape(start, position, velocity, ball_radius + noise + bend)
    if early > step:
        time += step
        return _Piece(time, min(2.0 * step, stop - time), stop)
    late = _time_to_shape(start, position, velocity, ball_radius - noise - bend)
    if bend <= noise:
        return Window(time + early, time + _time_to_shape(start, position, velocity, ball_radius), time + late)
    time += early
    if late <= step:
        stop = piece.time + late
        return _Piece(time, stop - time, stop)
    return _Piece(time, 0.5 * min(step, stop - time), stop)


def _in_turning_frame(flight: BallFlight, time: float) -> tuple[complex, complex]:
    """Position and velocity of a ball, some seconds later, as they are seen from the turning ring."""
    there, turn = flight.position + flight.velocity * time, cmath.rect(1.0, -flight.spin * time)
    return there * turn, (flight.velocity - 1j * flight.spin * there) * turn


def _asked_again(start: pymunk.PointQueryInfo, position: complex) -> pymunk.PointQueryInfo:
    """pymunk's query of the same shape at another point."""
    assert start.shape is not None
    return start.shape.point_query((position.real, position.imag))


def _time_to_shape(start: pymunk.PointQueryInfo, p: complex, v: complex, ball_radius: float) -> float:
    """Seconds until a ball on a straight path touches one convex shape; 0 while it is pressed, infinite while it is left.

    start: pymunk's query of the shape at p. The distance of a straight path to a convex set falls, then grows for good: what
    the ball leaves, it does not touch again. A ball of no size or less touches nothing. The ray is as long as the arena:
    pymunk's root of a quadratic loses digits on short rays.
    """
    assert start.shape is not None
    if ball_radius <= 0.0 or v == 0.0:
        return NEVER
    if start.distance <= ball_radius:
        leaving = start.gradient.x * v.real + start.gradient.y * v.imag
        return 0.0 if leaving < 0.0 else NEVER
    duration = _duration(p, v, start.distance)
    q = p + v * duration
    shapes = [start.shape, *_overlooked_ends(start.shape, p, ball_radius)]
    found = [shape.segment_query((p.real, p.imag), (q.real, q.imag), ball_radius) for shape in shapes]
    return min([hit.alpha * duration for hit in found if hit is not None], default=NEVER)


def _overlooked_ends(shape: pymunk.Shape, p: complex, ball_radius: float) -> list[pymunk.Circle]:
    """The end points of a segment, for a ball that starts between the two lines beside it, at its radius from it.

    pymunk's query of a segment then sees a ball that comes in over an end point leave at best, and not enter.
    """
    if not isinstance(shape, pymunk.Segment):
        return []
    a, normal = complex(*shape.a), complex(*shape.normal)
    if abs(((p - a).conjugate() * normal).real) > ball_radius:
        return []
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    ends = [pymunk.Circle(body, 0.0, end) for end in (shape.a, shape.b)]
    for end in ends:
        end.cache_bb()
    return ends


def _duration(p: complex, v: complex, reach: float) -> float:
    """Seconds of a ray that certainly leads past a shape which is no farther than `reach`."""
    return 2.0 * (abs(p) + reach) / abs(v)
