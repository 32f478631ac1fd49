"""When does a flying ball first touch a sector at rest?"""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import FEATURE_WORDS, ball_marks, contact_marks, ring_marks, second_opinion
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    Arc,
    Arrow,
    Circle,
    Line,
    Mark,
    Picture,
    PointMark,
    Prediction,
    Role,
    Stroke,
    Toggle,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, EngineUse, LabScene, Preset, ViewBox
from physics import Ball, Contact, Feature, Impact, Ring, contact, cross, dot, length, time_of_impact, to_cartesian
from physics.time_of_impact import first_impact

_SCALE = 0.2
_SAMPLES = 48


class _Root(NamedTuple):
    """A time at which the ball touches one of the lines and circles that bound the sector.

    position: of the ball's centre then. found: its contact with the sector then.
    """

    time: float
    position: complex
    found: Contact

    @property
    def touches(self) -> bool:
        """Whether the ball touches the sector, and not only the line or the circle that an edge is a part of."""
        return abs(self.found.gap) < 1e-7


class _FlightPast(NamedTuple):
    """The flight, its roots in the order of time, the contact at time 0, and the impact."""

    ball: Ball
    ring: Ring
    dt: float
    roots: tuple[_Root, ...]
    now: Contact
    impact: Impact | None


def _flight_past(given: Given) -> _FlightPast:
    """The ball and the sector that the values make."""
    ball = Ball(given.point("ball"), given.point("v"), given.number("r"))
    ring = Ring(given.number("radius"), given.number("half_width"), given.angle("half_angle"), 1, given.angle("angle"))
    dt = given.number("dt")
    times = sorted([time for time in _times(ball, ring) if 0.0 <= time <= dt])
    positions = [ball.moved(time) for time in times]
    roots = tuple([_Root(time, at.position, contact(at, ring, 0)) for time, at in zip(times, positions, strict=True)])
    return _FlightPast(ball, ring, dt, roots, contact(ball, ring, 0), time_of_impact(ball, ring, dt))


def _times(ball: Ball, ring: Ring) -> list[float]:
    """Times at which the ball touches a bounding line or circle: two arcs, two ends, four corners."""
    p, v, r = ball
    times = [*_circle_times(p, v, ring.outer_radius + r), *_circle_times(p, v, ring.inner_radius - r)]
    if ring.half_angle >= math.pi:
        return times
    for side in (-1.0, 1.0):
        a, b = source.end_points(ring.radius, ring.half_width, ring.angle(0) + side * ring.half_angle)
        along = (b - a) / length(b - a)
        climb = cross(along, v)
        times += [(height - cross(along, p)) / climb for height in (-r, r) if climb != 0.0]
        times += [time for corner in (a, b) for time in _circle_times(p - corner, v, r)]
    return times


def _circle_times(p: complex, v: complex, radius: float) -> list[float]:
    """Both t with |p + v t| = radius."""
    a, b, c = dot(v, v), dot(p, v), dot(p, p) - radius * radius
    square = b * b - a * c
    if radius <= 0.0 or a == 0.0 or square < 0.0:
        return []
    return [(-b - math.sqrt(square)) / a, (-b + math.sqrt(square)) / a]


def _picture(given: Given) -> Picture:
    """The path, the roots on it, and the ball at the first touch."""
    flight = _flight_past(given)
    ball, ring, impact = flight.ball, flight.ring, flight.impact
    count, *equation, last = _formula(flight)
    path = Line((ball.position, ball.moved(flight.dt).position), Role.PLAIN, Toggle.SWEPT, Stroke.DASHED)
    touch: list[Mark] = []
    if impact is not None:
        there = ball.moved(impact.time)
        touch += [Circle(there.position, ball.radius, Role.OURS, None, Stroke.THICK), *contact_marks(there, impact.contact)]
        touch += second_opinion(given, there, ring, (0,), impact.contact)
    steps = (
        one_step(
            "a ball and a sector at rest",
            [
                *ring_marks(ring),
                *ball_marks(ball.position, ball.radius),
                Arrow(ball.position, ball.velocity * _SCALE, Role.PLAIN, label="v"),
            ],
        ),
        one_step("the path, and the sector grown by r", [path, *_grown(ball.radius, ring)]),
        one_step("where they meet", [_root_mark(root, impact) for root in flight.roots], [count]),
        one_step(
            "the first touch",
            touch,
            [*equation, last],
            None if impact is None else Prediction("position at the touch", None, ball.moved(impact.time).position),
        ),
    )
    return in_steps(steps, _cited(flight), _note(flight))


def _root_mark(root: _Root, impact: Impact | None) -> PointMark:
    """Where the path meets one part of the grown outline, with the time where that is on the sector."""
    first = impact is not None and abs(root.time - impact.time) < 1e-9
    role = Role.TWO if root.touches else Role.FAINT
    label = f"{root.time:.3f}" if root.touches else ""
    return PointMark(root.position, Role.OURS if first else role, Toggle.SWEPT, label)


def _grown(r: float, ring: Ring) -> list[Mark]:
    """The sector grown by the ball's radius: the ball touches the sector where its centre touches this outline."""
    start, sweep = ring.angle(0) - ring.half_angle, 2.0 * ring.half_angle
    marks: list[Mark] = [
        Arc(0j, radius, start, sweep, Role.GHOST, Toggle.BANDS, Stroke.DASHED)
        for radius in (ring.outer_radius + r, ring.inner_radius - r)
        if radius > 0.0
    ]
    if ring.half_angle >= math.pi:
        return marks
    for side in (-1.0, 1.0):
        angle = ring.angle(0) + side * ring.half_angle
        ends = source.end_points(ring.radius, ring.half_width, angle)
        aside = to_cartesian(r, angle + side * math.pi / 2.0)
        marks.append(Line((ends[0] + aside, ends[1] + aside), Role.GHOST, Toggle.BANDS, Stroke.DASHED))
        marks += [
            Arc(corner, r, turn, side * math.pi / 2.0, Role.GHOST, Toggle.BANDS, Stroke.DASHED)
            for corner, turn in ((ends[1], angle), (ends[0], angle + side * math.pi / 2.0))
        ]
    return marks


def _formula(flight: _FlightPast) -> tuple[str, ...]:
    """The equation of what is touched first, with its root."""
    p, v, r = flight.ball
    ring, impact = flight.ring, flight.impact
    count = f"{len(flight.roots)} roots within {flight.dt:g} s, {sum([root.touches for root in flight.roots])} on the sector"
    if impact is None:
        return (count, "at none of them the ball flies into the sector: time_of_impact(...) = None")
    found = impact.contact
    last = f"t = {impact.time:.6f} s: {FEATURE_WORDS[found.feature]}"
    if found.feature is Feature.END:
        along = found.point / length(found.point)
        height, climb = abs(cross(along, p)), -abs(cross(along, v))
        return (
            count,
            "distance of p from the end's line: h + h' t = r",
            f"h = {height:.3f},   h' = {climb:.3f},   r = {r:g}",
            last,
        )
    centre = found.point if found.feature is Feature.CORNER else 0j
    reach = {Feature.CORNER: r, Feature.OUTER_FACE: ring.outer_radius + r}.get(found.feature, ring.inner_radius - r)
    words = {Feature.CORNER: "|p - c + v t| = r", Feature.OUTER_FACE: "|p + v t| = r_p + w_p + r"}
    a, b, c = dot(v, v), dot(p - centre, v), dot(p - centre, p - centre) - reach * reach
    return (
        count,
        f"{words.get(found.feature, '|p + v t| = r_p - w_p - r')} = {reach:.3f}:   a t² + 2 b t + c = 0",
        f"a = {a:.3f},   b = {b:.3f},   c = {c:.3f},   b² - a c = {b * b - a * c:.3f}",
        last,
    )


def _cited(flight: _FlightPast) -> CitedLine:
    """The line that computes the time."""
    if flight.impact is None:
        return code_line(first_impact, "return impact")
    if flight.impact.contact.feature in {Feature.END, Feature.CORNER}:
        return code_line(first_impact, "impact = None if inward is None else _first_touch(ball, ring, inward, alive)")
    return code_line(first_impact, "inward, outward = band_stretches(ball, ring, dt)")


def _note(flight: _FlightPast) -> str:
    """What is special about these values."""
    if length(flight.ball.velocity) == 0.0:
        return "v = 0: the ball stays where it is, and a sector at rest does not come to it."
    if flight.now.gap < 0.0:
        return (
            "The ball overlaps the sector at t = 0: the impact is at 0 if it approaches, and there is none while it flies out."
        )
    if flight.impact is None:
        return "The ball flies past: p does not cross the dashed outline, the sector grown by r."
    return "The dashed outline is the sector grown by r. Grey roots lie on the lines and circles, but not on the sector."


def _check(given: Given) -> tuple[Claim, ...]:
    """The impact is the first root, nothing overlaps before it, and the mirrored flight takes the same time."""
    flight = _flight_past(given)
    ball, ring, impact = flight.ball, flight.ring, flight.impact
    apart = flight.now.gap > 1e-7
    speed = length(ball.velocity)
    touching = [root for root in flight.roots if root.touches]
    first = touching[0] if touching else None
    grazes = first is not None and abs(dot(first.found.normal, ball.velocity)) < 1e-3 * speed
    clear = apart and not grazes
    until = flight.dt if impact is None else impact.time
    least = min([contact(ball.moved(until * k / _SAMPLES), ring, 0).gap for k in range(_SAMPLES + 1)])
    there = Ring(ring.radius, ring.half_width, ring.half_angle, 1, -ring.phase)
    mirrored = time_of_impact(Ball(ball.position.conjugate(), ball.velocity.conjugate(), ball.radius), there, flight.dt)
    back = None
    if impact is not None:
        back = time_of_impact(Ball(ball.moved(impact.time).position, -ball.velocity, ball.radius), ring, impact.time)
    same = (first is None) == (impact is None) and (first is None or impact is None or abs(first.time - impact.time) < 1e-6)
    return (
        Claim("the impact is the first root that lies on the sector", not clear or same),
        Claim("before the impact the ball overlaps nothing", not apart or least > -1e-9),
        Claim("at the impact the gap is 0", not apart or impact is None or abs(impact.contact.gap) < 1e-9),
        Claim(
            "at the impact the ball approaches", not apart or impact is None or dot(impact.contact.normal, ball.velocity) < 1e-9
        ),
        Claim("flown backwards from there, it touches nothing", not clear or back is None),
        Claim(
            "the mirrored flight has its impact at the same time",
            not apart or (None if mirrored is None else mirrored.time) == (None if impact is None else impact.time),
        ),
    )


SCENE = LabScene(
    name="impact-resting",
    title="Time of impact: a sector at rest",
    idea="The ball touches where its centre meets the sector grown by r: arcs, corners and ends give one equation each.",
    functions=("time_of_impact",),
    parameters=(
        Point("ball", "p", -15.0, 15.0, -1.5 - 3.5j, meaning="the ball's centre"),
        Point("v", "v", -30.0, 30.0, 9.0 + 6.5j, 0.1, "its velocity"),
        Number("r", "r", "", 0.05, 3.0, 0.8, 0.05, "the ball's radius"),
        Number("dt", "Δt", "s", 0.05, 5.0, 1.6, 0.05, "time that is searched"),
        Number("radius", "r_p", "", 2.0, 13.0, 6.0, 0.05, "the sector's middle radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 20.0, 0.5, "the sector's middle angle"),
        Number("half_width", "w_p", "", 0.05, 1.9, 0.8, 0.05, "its half width"),
        Number("half_angle", "φ_p", "°", 0.5, 180.0, 45.0, 0.5, "its half angle"),
    ),
    handles=(
        handles.vector("v", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
        *handles.sector_handles("radius", "half_width", "angle", "half_angle"),
    ),
    view_box=ViewBox(3.6 + 1.4j, 9.4 + 6.0j),
    shows=_picture,
    check=_check,
    rows=(6,),
    presets=(
        Preset("the inner face", "v=9,6.5"),
        Preset("the outer face", "ball=11,5&v=-8,-3"),
        Preset("an end", "ball=-2,6&v=6,0"),
        Preset("a corner", "ball=-3,7.4&v=8,-0.8"),
        Preset("through the gap of a wide sector", "half_angle=150&angle=0&ball=-10,0&v=9,0"),
        Preset("past it", "ball=-2,-4&v=9,-1"),
        Preset("at rest", "v=0,0"),
        Preset("inside of the material", "ball=6,2&v=3,1"),
    ),
    engine_use=EngineUse.TOGGLE,
)
