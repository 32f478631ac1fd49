"""When does a flying ball first touch a resting ring? pymunk's shape-level segment queries answer."""

import math
from typing import NamedTuple

import pymunk

from tools.crosscheck.pymunk_model.ring_model import Part, RingModel

_WEDGE_NOISE = 1e-12
"""Radians: where a face ends, its corner takes over at the same distance."""


class Window(NamedTuple):
    """Seconds from the start: the first touch cannot be earlier than `early` nor later than `late`; both may be infinite.

    If two shapes are nowhere farther apart than s, a ball touches one of them no earlier than a ball larger by s touches the
    other, and no later than a ball smaller by s does. That is a proof, also for a graze, which needs no derivative.
    """

    early: float
    middle: float
    late: float


class _Flight(NamedTuple):
    """A ball in the frame of a resting ring."""

    place: complex
    velocity: complex
    ball_radius: float
    duration: float  # seconds of a ray as long as the arena: pymunk's root of a quadratic loses digits on short rays


def first_touch(model: RingModel, p: complex, v: complex, ball_radius: float, span: float, noise: float) -> Window:
    """The first touch of a ball with a resting ring within about `span` seconds, in the ring's frame.

    noise: world units by which exact shapes may differ from the game's. Facets of an inner face differ by their sagitta.
    """
    flight = _Flight(p, v, ball_radius, 2.0 * model.geometry.outer / abs(v))
    reach = abs(v) * span + ball_radius + model.inner_sagitta + noise
    early = middle = late = math.inf
    for part, start in _near(model, p, reach):
        slack = noise + (model.inner_sagitta if part == Part.INNER_FACET else 0.0)
        first = _time(model, part, start, flight, slack)
        if first <= span:
            early = min(early, first)
            middle = min(middle, _time(model, part, start, flight, 0.0))
            late = min(late, _time(model, part, start, flight, -slack))
    return Window(early, middle, late)


def facet_touch(model: RingModel, p: complex, v: complex, ball_radius: float, span: float) -> float:
    """Seconds to the first touch with facets and ends alone; infinite if there is none within about `span`."""
    flight = _Flight(p, v, ball_radius, 2.0 * model.geometry.outer / abs(v))
    near = model.space.point_query((p.real, p.imag), abs(v) * span + ball_radius, pymunk.ShapeFilter(mask=Part.FACETED))
    return min((_time_to_shape(start, flight, 0.0) for start in near), default=math.inf)


def _near(model: RingModel, p: complex, reach: float) -> list[tuple[Part, pymunk.PointQueryInfo]]:
    """The exact shapes and inner facets that the ball may reach on its way, as seen from its start."""
    place = (p.real, p.imag)
    found = model.space.point_query(place, reach, pymunk.ShapeFilter(mask=Part.POINTED | Part.INNER_FACET))
    near = [(model.pieces[info.shape].part, info) for info in found if info.shape is not None]
    circle = model.outer_circle.shape.point_query(place)
    if abs(circle.distance) <= reach:
        near.append((Part.OUTER_CIRCLE, circle))
    return near


def _time(model: RingModel, part: Part, start: pymunk.PointQueryInfo, flight: _Flight, slack: float) -> float:
    """Seconds to the touch with one shape; with the outer circle only where a living sector lies under the ball."""
    time = _time_to_shape(start, flight, slack)
    if part == Part.OUTER_CIRCLE and time < math.inf:
        widened = math.copysign(_WEDGE_NOISE, slack)
        if model.slot_over(flight.place + flight.velocity * time, widened) is None:
            return math.inf
    return time


def _time_to_shape(start: pymunk.PointQueryInfo, flight: _Flight, slack: float) -> float:
    """Seconds until a ball larger by `slack` touches one convex shape; 0 while it is pressed, infinite while it is left.

    The distance of a straight flight to a convex set falls, then grows for good: what it leaves, it does not touch again.
    """
    p, v, ball_radius, duration = flight
    ball_radius += slack
    if start.shape is None or start.distance <= ball_radius:
        leaving = start.gradient.x * v.real + start.gradient.y * v.imag
        return 0.0 if leaving < 0.0 else math.inf
    q = p + v * duration
    found = start.shape.segment_query((p.real, p.imag), (q.real, q.imag), ball_radius)
    return math.inf if found is None else found.alpha * duration
