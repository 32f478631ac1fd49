"""A ball between two bricks touches both."""

import math
from itertools import pairwise
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import ring_marks, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    Arrow,
    Circle,
    Disc,
    Line,
    Mark,
    Pane,
    Picture,
    PointMark,
    RevealStep,
    Role,
    Stroke,
    Toggle,
    in_steps,
)
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import PERMANENT, Arena, Ball, Hit, Ring, Step, advance, contact, dot, length, response_steps, time_of_impact
from physics.source_mode import normal_at
from physics.time_of_impact import first_impact

_RADIUS, _COUNT = 8.0, 4
_RATE = 60
"""Frames per second of the source's loop."""
_SCALE = 0.12
_SAME = 1e-9
"""Seconds between touches that count as simultaneous."""
_ROUNDING = 1e-9
"""World units, and world units per second: more than rounding errors of a few bounces add up to."""


class _Notch(NamedTuple):
    """The ball, the bricks on both sides of the notch, and the step of the physics.

    apart: whether the ball touches nothing at first.
    """

    ball: Ball
    ring: Ring
    dt: float
    step: Step
    apart: bool

    @property
    def hits(self) -> tuple[Hit, ...]:
        """Our bounces."""
        return self.step.hits

    @property
    def tie(self) -> bool:
        """Whether the first two bricks are touched at the same time."""
        return len(self.hits) > 1 and self.hits[0].slot != self.hits[1].slot and self.hits[1].time - self.hits[0].time < _SAME


def _notch(given: Given) -> _Notch:
    """The ball and the bricks that the values make."""
    ball = Ball(given.point("ball"), given.point("v"), given.number("r"))
    half = math.pi / _COUNT - given.angle("notch")
    ring = Ring(_RADIUS, given.number("half_width"), half, _COUNT, math.pi / _COUNT)
    dt, speed = given.number("dt"), length(ball.velocity)
    apart = min([contact(ball, ring, slot).gap for slot in range(_COUNT)]) > 1e-7
    return _Notch(ball, ring, dt, advance(Arena((ball,), (ring,), ((PERMANENT,) * _COUNT,)), dt, speed), apart)


def _picture(given: Given) -> Picture:
    """The source's path at the left, ours at the right."""
    notch = _notch(given)
    panes = (
        Pane((), f"the source: the nearest brick, {_RATE} tests a second"),
        Pane((), "here: every brick, in the order of time"),
    )
    ball, formula = notch.ball, _formula(notch)
    situation: tuple[Mark, ...] = (
        *ring_marks(notch.ring),
        Disc(ball.position, ball.radius, Role.BALL),
        Arrow(ball.position, ball.velocity * _SCALE, Role.PLAIN, label="v"),
    )
    ours = len(formula) - (1 if notch.tie else 0)
    steps = (
        RevealStep("a ball before a notch between two bricks", (situation, situation)),
        RevealStep("the source, once a frame", (_theirs(notch), ()), formula[ours:]),
        RevealStep("here, in the order of time", ((), _ours(notch)), formula[:ours]),
    )
    return in_steps(steps, _cited(notch), _note(notch), panes)


def _theirs(notch: _Notch) -> tuple[Mark, ...]:
    """The source's ball, frame by frame."""
    ball, speed = notch.ball, length(notch.ball.velocity)
    flight, positions = source.SourceBall(ball.position, ball.velocity), [ball.position]
    marks: list[Mark] = []
    for _ in range(round(notch.dt * _RATE)):
        flight = source.frame(flight, ball.radius, (notch.ring,), 1.0 / _RATE, speed)
        positions.append(flight.position)
        normal = normal_at(Ball(flight.position, 0j, ball.radius), notch.ring, (1,) * _COUNT)
        overlap = min([contact(Ball(flight.position, 0j, ball.radius), notch.ring, slot).gap for slot in range(_COUNT)]) < 0.0
        if normal is not None and overlap:
            marks.append(Circle(flight.position, ball.radius, Role.SOURCE, Toggle.CONTACTS))
            marks.append(Arrow(flight.position, normal * 1.2, Role.SOURCE, Toggle.NORMALS, Stroke.SOLID))
    return (*marks, *_flown(ball, tuple(positions)))


def _ours(notch: _Notch) -> tuple[Mark, ...]:
    """Our ball, bounce by bounce, the bounces numbered."""
    ball = notch.ball
    marks: list[Mark] = []
    positions = [ball.position]
    for number, hit in enumerate(notch.hits, 1):
        position = hit.contact.point + hit.contact.normal * ball.radius
        positions.append(position)
        marks.append(Circle(position, ball.radius, Role.OURS, Toggle.CONTACTS))
        marks.append(Arrow(hit.contact.point, hit.contact.normal * 1.2, Role.OURS, Toggle.NORMALS, Stroke.SOLID))
        marks.append(PointMark(hit.contact.point, Role.OURS, Toggle.CONTACTS, str(number)))
    return (*marks, *_flown(ball, (*positions, notch.step.arena.balls[0].position)))


def _flown(ball: Ball, positions: tuple[complex, ...]) -> tuple[Mark, ...]:
    """A path, and the ball at its end."""
    return (
        Line(positions, Role.PLAIN, Toggle.SWEPT),
        Circle(positions[-1], ball.radius, Role.GHOST, Toggle.SWEPT, Stroke.DASHED),
    )


def _formula(notch: _Notch) -> tuple[str, ...]:
    """Our bounces, and what is wrong after the single one of the source."""
    if not notch.hits:
        return (f"no brick is touched within {notch.dt:g} s",)
    lines = [
        f"{number}:   t = {hit.time:.6f} s,   slot {hit.slot},   n = {two_decimals(hit.contact.normal)},   "
        f"v := {two_decimals(hit.after)}"
        for number, hit in enumerate(notch.hits[:3], 1)
    ]
    if len(notch.hits) > 3:
        slot = notch.hits[0].slot
        lines.append(
            f"and {len(notch.hits) - 3} more;   {sum([hit.slot == slot for hit in notch.hits])} in all with slot {slot}"
        )
    if notch.tie:
        first, other = notch.hits[0].contact.normal, notch.hits[1].contact.normal
        velocity = notch.ball.velocity
        after = response_steps(velocity, first, 0j, 0.0, length(velocity)).result
        lines.append(f"the source answers only the first:   afterwards v · n of the other = {dot(after, other):.2f}")
    return tuple(lines)


def _cited(notch: _Notch) -> CitedLine:
    """The source's search for the nearest one, or our search in the order of time."""
    if notch.tie:
        return source_line("Broad phase", "if min_difference(θ, θ'_p) < min_difference(θ, θ_p): r_p, θ_p = r'_p, θ'_p")
    return code_line(first_impact, "impact = None if inward is None else _first_touch(ball, ring, inward, alive)")


def _note(notch: _Notch) -> str:
    """What is special about these values."""
    if not notch.apart:
        return "The ball overlaps a brick at the start: it is pushed out before it flies."
    if notch.step.dropped:
        return "After 32 bounces the rest of the tick is dropped and counted, so that no wedge can stop the game."
    if notch.tie:
        return "Both are touched at the same time: one bounce answers both. The source answers one of them only."
    if len({hit.slot for hit in notch.hits}) > 1:
        return "One after the other: each bounce starts from the velocity after the one before."
    return "One brick only. Aim the ball at the notch."


def _check(given: Given) -> tuple[Claim, ...]:
    """Order in time, speed, no overlap, and the same in a world turned by a quarter."""
    notch = _notch(given)
    hits, speed = notch.hits, length(notch.ball.velocity)
    times = [hit.time for hit in hits]
    end = notch.step.arena.balls[0]
    quarter = Ball(notch.ball.position * 1j, notch.ball.velocity * 1j, notch.ball.radius)
    turned = advance(Arena((quarter,), (notch.ring,), ((PERMANENT,) * _COUNT,)), notch.dt, speed).hits
    alone = _alone(notch)
    tie = len(alone) > 1 and alone[1][0] - alone[0][0] < _SAME
    firsts = (*hits[:1], *turned[:1])
    left = any([hit.contact.point.real < 0.0 for hit in hits])  # its bricks lie about pi, which a float is not exactly
    error = _ROUNDING if left else 0.0
    sharp = all([dot(hit.before, hit.contact.normal) < -0.05 * speed and hit.time < notch.dt - _SAME for hit in firsts])
    return (
        Claim("the bounces are in the order of time", times == sorted(times)),
        Claim(
            "the brick that would be touched first without the others is touched first, of equals the lower slot",
            not notch.apart or [(hit.time, hit.slot) for hit in hits[:1]] == alone[:1],
        ),
        Claim(
            "the ball approaches each brick that it touches", all([dot(hit.before, hit.contact.normal) < 1e-9 for hit in hits])
        ),
        Claim("it leaves each at the speed v_0", all([_leaves(hit, speed) for hit in hits])),
        Claim("each bounce starts from the velocity after the one before", all([_follows(a, b) for a, b in pairwise(hits)])),
        Claim("a flight that is its own mirror image stays so", not _is_mirrored(notch.ball) or _is_mirrored(end, error)),
        Claim("in the end the ball overlaps nothing", not notch.apart or min(_gaps(notch.ring, end)) > -1e-8),
        Claim("there are no more than 32 bounces", len({(hit.time, hit.before) for hit in hits}) <= 32),
        Claim(
            "turned by a quarter, the first bounce is one slot on",
            not (notch.apart and sharp) or tie or _first_is_one_on(hits, turned),
        ),
    )


def _follows(one: Hit, other: Hit) -> bool:
    """Whether a hit starts from the velocity after the one before, or both are one bounce off two bricks at once."""
    return other.before == one.after or (one.time, one.before, one.after) == (other.time, other.before, other.after)


def _is_mirrored(ball: Ball, error: float = 0.0) -> bool:
    """Whether a ball is on the x axis and flies along it, so that it is its own mirror image.

    error: of its position, world units, and of its velocity, world units per second, that is allowed.
    """
    return abs(ball.position.imag) <= error and abs(ball.velocity.imag) <= error


def _gaps(ring: Ring, ball: Ball) -> list[float]:
    """Between the ball and every brick."""
    return [contact(ball, ring, slot).gap for slot in range(ring.count)]


def _alone(notch: _Notch) -> list[tuple[float, int]]:
    """When the ball would touch each brick, if no other were there; the first one first."""
    found = []
    for slot in range(_COUNT):
        impact = time_of_impact(notch.ball, notch.ring, notch.dt, [int(slot == other) for other in range(_COUNT)])
        if impact is not None:
            found.append((impact.time, slot))
    return sorted(found)


def _leaves(hit: Hit, speed: float) -> bool:
    """Whether the ball leaves the brick, with its speed."""
    return dot(hit.after, hit.contact.normal) > 0.0 and abs(length(hit.after) - speed) < 1e-9 * max(speed, 1.0)


def _first_is_one_on(hits: tuple[Hit, ...], turned: tuple[Hit, ...]) -> bool:
    """Whether the first bounces are the same, but for the slot's number."""
    if not hits or not turned:
        return not hits and not turned
    return abs(hits[0].time - turned[0].time) < 1e-8 and turned[0].slot == (hits[0].slot + 1) % _COUNT


SCENE = LabScene(
    name="two-bricks",
    title="Two bricks at once",
    idea="A ball in a notch touches both of its sides. Every contact is answered, in the order of time.",
    functions=("broad_phase", "collision_response"),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 12.8 + 0.0j, meaning="the ball's centre"),
        Point("v", "v", -30.0, 30.0, -14.0 + 0.0j, 0.1, "its velocity"),
        Number("r", "r", "", 0.05, 3.0, 1.2, 0.05, "the ball's radius"),
        Number("notch", "φ_n", "°", 0.5, 40.0, 6.5, 0.5, "half of the notch's angle"),
        Number("half_width", "w_b", "", 0.1, 5.0, 1.5, 0.1, "the bricks' half width"),
        Number("dt", "Δt", "s", 0.05, 1.0, 0.4, 0.05, "how long it flies"),
    ),
    handles=(
        handles.vector("v", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
    ),
    view_box=ViewBox(10.0 + 0j, 4.6 + 4.6j),
    shows=_picture,
    check=_check,
    rows=(8,),
    presets=(
        Preset("both at the same time", "ball=12.8,0"),
        Preset("one after the other", "ball=12.8,0.1"),
        Preset("down into the wedge", "r=0.5&half_width=4&v=-24,5&dt=0.6&notch=7"),
        Preset("a large ball", "r=2.5&ball=14,0.1"),
        Preset("one brick only", "ball=12.8,3"),
    ),
)
