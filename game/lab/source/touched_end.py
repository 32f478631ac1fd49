"""A ball that touches the end of a turning paddle, and what the source and the engine make of it, side by side.

The end lies on the x axis, so its normal is the y axis, and the surface's velocity there is u along it.
"""

import math
from typing import NamedTuple

from game.lab.kit.handles import Handle, polar_vector
from game.lab.kit.marks import ring_marks
from game.lab.kit.parameters import Given
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Stroke, Toggle, Tone, Words
from game.lab.source import literal
from game.lab.source.discrete import Flight, frame, reset
from physics import PERMANENT, Arena, Ball, Ring, advance, collision_response, contact, dot, length, to_cartesian
from physics.tolerances import STOPPED

REACH, RADIUS = 6.0, 0.5
"""Distance of the touched point from the centre, and the ball's radius."""
NORMAL = 1j
TICK = 1.0 / 240.0
_HALF_WIDTH, _HALF_ANGLE = 1.0, 0.4
_AT = complex(REACH - _HALF_WIDTH, 0.0)
"""The inner corner, where one takes hold of the end's velocity."""
_SCALE = 0.3
"""World units drawn per unit of speed."""


class Answered(NamedTuple):
    """One bounce, in the source's letters."""

    ball: Ball  # at the moment of touch
    ring: Ring
    speed: float  # v_0
    pace: float  # u = v_p . n
    result: complex  # v_res
    theirs: complex | None  # v by the source; None for 0 / 0
    ours: complex  # v

    @property
    def approach(self) -> float:
        """dv . n."""
        return dot(self.ball.velocity, NORMAL) - self.pace

    @property
    def stopped(self) -> bool:
        """Whether v_res is 0 but for rounding."""
        return self.approach < 0.0 and length(self.result) <= STOPPED * self.speed

    @property
    def overtaken(self) -> bool:
        """Whether the source's ball leaves slower than the surface comes after it, or not at all."""
        return self.approach < 0.0 and self.theirs is not None and dot(self.theirs, NORMAL) < self.pace

    @property
    def possible(self) -> bool:
        """Whether no point of the end is faster than the ball, as the levels make sure."""
        return abs(self.ring.spin) * self.ring.outer_radius < self.speed


class Running(NamedTuple):
    """Both balls some ticks after the bounce."""

    ring: Ring
    theirs: Flight
    ours: Ball


def answered(given: Given) -> Answered:
    """The bounce that the values make: `u`, `speed`, `heading`, `mu`."""
    speed, pace, mu = given.number("speed"), given.number("u"), given.number("mu")
    ring = Ring(REACH, _HALF_WIDTH, _HALF_ANGLE, 1, -_HALF_ANGLE, pace / REACH, mu)
    ball = Ball(complex(REACH, RADIUS), to_cartesian(speed, given.angle("heading")), RADIUS)
    surface = NORMAL * pace
    result = literal.bounced(ball.velocity, NORMAL, surface, mu)
    ours = collision_response(ball.velocity, NORMAL, surface, mu, speed)
    return Answered(ball, ring, speed, pace, result, reset(ball.velocity, result, speed), ours)


def start(given: Given) -> Running:
    """Right after the bounce."""
    bounce = answered(given)
    ball = bounce.ball
    return Running(bounce.ring, Flight(ball.position, bounce.theirs), Ball(ball.position, bounce.ours, ball.radius))


def step(given: Given, state: Running) -> Running:
    """A tick later: the source's frame, and ours."""
    speed, ring = given.number("speed"), state.ring.turned(TICK)
    theirs = frame(state.theirs, RADIUS, (ring,), TICK, speed)
    after = advance(Arena((state.ours,), (state.ring,), ((PERMANENT,),)), TICK, speed).arena
    return Running(ring, theirs, after.balls[0])


def panes(bounce: Answered, state: Running) -> tuple[Pane, Pane]:
    """The source's ball at the left, ours at the right."""
    theirs, ours = state.theirs, state.ours
    return (
        _pane(bounce, state.ring, theirs.position, theirs.velocity, Tone.SOURCE, "the source"),
        _pane(bounce, state.ring, ours.position, ours.velocity, Tone.GOOD, "here"),
    )


def _pane(bounce: Answered, ring: Ring, place: complex, velocity: complex | None, tone: Tone, who: str) -> Pane:
    """The paddle and one ball as they are now, and where it came from."""
    p = bounce.ball.position
    marks: list[Mark] = [
        *ring_marks(ring),
        Circle(p, RADIUS, Tone.GHOST, Toggle.SWEPT, Stroke.DASHED),
        Line((p, place), tone, Toggle.SWEPT, Stroke.DASHED),
        *[_surface(ring, bounce.ring.surface_velocity(q), q) for q in (_AT, 2.0 * REACH - _AT)],
        Disc(place, RADIUS, Tone.BALL),
        Arrow(p, bounce.ball.velocity * _SCALE, Tone.PLAIN, label="v before"),
    ]
    if velocity is None:
        marks.append(Words(place + 0.75j, "v = 0 / 0", tone))
    else:
        marks.append(Arrow(place, velocity * _SCALE, tone, label="v"))
    gap = contact(Ball(place, 0j, RADIUS), ring, 0).gap
    return Pane(tuple(marks), f"{who}:   gap = {gap + 0.0:.3f}")


def _surface(ring: Ring, velocity: complex, q: complex) -> Arrow:
    """The velocity of a point of the end at the bounce."""
    return Arrow(q, velocity * _SCALE, Tone.ONE, label="ω × q" if ring.spin else "")


def handles() -> tuple[Handle, Handle]:
    """The ball's velocity, and the paddle's."""
    share = _AT.real / REACH * _SCALE
    return (
        polar_vector("speed", "heading", lambda _: complex(REACH, RADIUS), _SCALE, "velocity"),
        Handle(
            "u",
            lambda given: _AT + NORMAL * given.number("u") * share,
            lambda _, place: {"u": place.imag / share},
        ),
    )


def clearance(given: Given, ticks: int) -> float:
    """The least gap between our ball and the paddle in so many ticks."""
    state, least = start(given), math.inf
    for _ in range(ticks):
        state = step(given, state)
        least = min(least, contact(state.ours, state.ring, 0).gap)
    return least
