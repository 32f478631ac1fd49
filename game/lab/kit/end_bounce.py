"""A ball that touches the end of a turning paddle, and the velocity that the source and the physics give it, side by side.

The end lies on the x axis, so its normal is the y axis, and the surface's velocity at the touched point is u along it.
"""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit.bounce import Bounce, bounce
from game.lab.kit.cited_line import CitedLine
from game.lab.kit.handles import Handle, polar_vector
from game.lab.kit.marks import ring_marks
from game.lab.kit.parameters import Given
from game.lab.kit.picture import (
    Arrow,
    Circle,
    Disc,
    Line,
    Mark,
    Pane,
    Picture,
    RevealStep,
    Role,
    Stroke,
    Toggle,
    Words,
    in_steps,
)
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, contact, to_cartesian

REACH, RADIUS = 6.0, 0.5
"""Distance of the touched point from the centre, and the ball's radius."""
NORMAL = 1j
_HALF_WIDTH, _HALF_ANGLE = 1.0, 0.4
_AT = complex(REACH - _HALF_WIDTH, 0.0)
"""The inner corner, where one takes hold of the end's velocity."""
_TOUCH = 1e-9
"""World units. A gap below 0 by less than this is rounding."""
_SCALE = 0.3
"""World units drawn per unit of speed."""


class EndBounce(NamedTuple):
    """One bounce off the end.

    ball, ring: at the moment of touch. found: the bounce and its steps. by_source: v as the source has it; None for 0 / 0.
    """

    ball: Ball
    ring: Ring
    found: Bounce
    by_source: complex | None

    @property
    def ring_is_slow(self) -> bool:
        """Whether no point of the paddle is faster than the ball, as every level makes sure."""
        return abs(self.ring.spin) * self.ring.outer_radius < self.found.speed


class EndFlight(NamedTuple):
    """Both balls some ticks after the bounce.

    by_source: the ball that flies on as the source has it. by_physics: the ball that flies on as in the game.
    """

    ring: Ring
    by_source: source.SourceBall
    by_physics: Ball


class EndWords(NamedTuple):
    """What is written about a bounce off the end.

    formula: first of the situation, then the source's answer, then ours in the last lines; ours: how many those are.
    """

    formula: tuple[str, ...]
    ours: int
    cited: CitedLine
    note: str


def end_bounce(given: Given) -> EndBounce:
    """The bounce that the values `u`, `speed`, `heading` and `mu` make."""
    speed, u, mu = given.number("speed"), given.number("u"), given.number("mu")
    ring = Ring(REACH, _HALF_WIDTH, _HALF_ANGLE, 1, -_HALF_ANGLE, u / REACH, mu)
    ball = Ball(complex(REACH, RADIUS), to_cartesian(speed, given.angle("heading")), RADIUS)
    found = bounce(ball.velocity, NORMAL, NORMAL * u, mu, speed)
    return EndBounce(ball, ring, found, source.slides_response(ball.velocity, NORMAL, NORMAL * u, mu, speed))


def start(given: Given) -> EndFlight:
    """Right after the bounce."""
    after = end_bounce(given)
    ball = Ball(after.ball.position, after.found.steps.velocity, after.ball.radius)
    return EndFlight(after.ring, source.SourceBall(ball.position, after.by_source), ball)


def step(given: Given, state: EndFlight) -> EndFlight:
    """A tick later: a frame of the source's loop, and a step of the physics."""
    speed, ring = given.number("speed"), state.ring.turned(TICK)
    by_source = source.frame(state.by_source, RADIUS, (ring,), TICK, speed)
    after = advance(Arena((state.by_physics,), (state.ring,), ((PERMANENT,),)), TICK, speed).arena
    return EndFlight(ring, by_source, after.balls[0])


def end_picture(after: EndBounce, state: EndFlight, words: EndWords) -> Picture:
    """The source's ball at the left, ours at the right: the bounce first, then both answers."""
    formula = words.formula
    left, right = state.by_source, source.SourceBall(state.by_physics.position, state.by_physics.velocity)
    panes = tuple(
        [
            Pane((), f"{title}:   {_gap_words(contact(Ball(ball.position, 0j, RADIUS), state.ring, 0).gap)}")
            for title, ball in (("the source", left), ("here", right))
        ]
    )
    before = _before(after, state.ring)
    ours = max(len(formula) - words.ours, 1)
    steps = (
        RevealStep("v and v_p at the moment of the bounce", (before, before), formula[:1]),
        RevealStep("the source's answer", (_flight(after, left, Role.SOURCE), ()), formula[1:ours]),
        RevealStep("the answer here", ((), _flight(after, right, Role.GOOD)), formula[ours:]),
    )
    return in_steps(steps, words.cited, words.note, panes)


def handles() -> tuple[Handle, Handle]:
    """The ball's velocity, and the paddle's."""
    scale = _AT.real / REACH * _SCALE
    return (
        polar_vector("speed", "heading", lambda _: complex(REACH, RADIUS), _SCALE, "velocity"),
        Handle(
            "u",
            lambda given: _AT + NORMAL * given.number("u") * scale,
            lambda _, point: {"u": point.imag / scale},
        ),
    )


def least_gap(given: Given, ticks: int) -> float:
    """The least gap between our ball and the paddle in so many ticks."""
    state, least = start(given), math.inf
    for _ in range(ticks):
        state = step(given, state)
        least = min(least, contact(state.by_physics, state.ring, 0).gap)
    return least


def _before(after: EndBounce, ring: Ring) -> tuple[Mark, ...]:
    """The paddle as it is now, and where the ball came from."""
    touched = after.ball.position
    return (
        *ring_marks(ring),
        Circle(touched, RADIUS, Role.GHOST, Toggle.SWEPT, Stroke.DASHED),
        *[_surface_arrow(after.ring, q) for q in (_AT, 2.0 * REACH - _AT)],
        Arrow(touched, after.ball.velocity * _SCALE, Role.PLAIN, label="v before"),
    )


def _flight(after: EndBounce, flight: source.SourceBall, role: Role) -> tuple[Mark, ...]:
    """One ball as it is now, and its way from the bounce."""
    now = flight.position
    velocity = (
        Words(now + 0.75j, "v = 0 / 0", role)
        if flight.velocity is None
        else Arrow(now, flight.velocity * _SCALE, role, label="v after")
    )
    line = Line((after.ball.position, now), role, Toggle.SWEPT, Stroke.DASHED)
    return (line, Disc(now, RADIUS, Role.BALL), velocity)


def _gap_words(gap: float) -> str:
    """A gap, or how deep an overlap is."""
    return f"gap = {gap + 0.0:.3f}" if gap > -_TOUCH else f"they overlap by {-gap:.3f}"


def _surface_arrow(ring: Ring, q: complex) -> Arrow:
    """The velocity of a point of the end at the moment of the bounce."""
    return Arrow(q, ring.surface_velocity(q) * _SCALE, Role.ONE, label="ω × q" if ring.spin else "")
