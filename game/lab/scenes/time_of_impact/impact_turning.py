"""When does a flying ball first touch a turning end? A search by steps that cannot pass the touch."""

from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import ball_marks, contact_marks, ghost_marks
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    AnnularSector,
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
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from physics import (
    Ball,
    Contact,
    Impact,
    Ring,
    closest_point_on_line,
    contact,
    dot,
    length,
    normalize_angle,
    time_of_impact,
    to_cartesian,
)
from physics.narrow_phase import end_contact
from physics.sweep.turning_end import safe_step
from physics.tolerances import MAX_STEPS, TOUCH

_SCALE = 0.2
_HALF_ANGLE = 0.35
_SAMPLES = 64
_NUMBERED = 8
_SURE = 1e-6


class _Search(NamedTuple):
    """The ball, the ring with the end, and every time at which the search stopped.

    times: 0 first. touch: when they touch; None within dt seconds. now: the contact with the end at time 0.
    """

    ball: Ball
    ring: Ring
    dt: float
    times: tuple[float, ...]
    touch: float | None
    now: Contact

    def end(self, time: float) -> tuple[complex, complex]:
        """Both corners of the end at a time."""
        angle = self.ring.phase + self.ring.half_angle + self.ring.spin * time
        return source.end_points(self.ring.radius, self.ring.half_width, angle)

    def distance(self, time: float) -> float:
        """Between the end and the ball's centre."""
        p = self.ball.moved(time).position
        return length(p - closest_point_on_line(*self.end(time), p))

    def contact(self, time: float) -> Contact:
        """Of the ball with the end."""
        angle = self.ring.phase + self.ring.half_angle + self.ring.spin * time
        return end_contact(self.ball.moved(time), self.ring.turned(time), 0, normalize_angle(angle))


def _search(given: Given) -> _Search:
    """The search for the counter-clockwise end of the sector, as the engine does it."""
    angle, spin, dt = given.angle("angle") - _HALF_ANGLE, given.number("spin"), given.number("dt")
    ring = Ring(given.number("radius"), given.number("half_width"), _HALF_ANGLE, 1, angle, spin)
    ball = Ball(given.point("ball"), given.point("v"), given.number("r"))
    empty = _Search(ball, ring, dt, (), None, contact(ball, ring, 0))
    times, touch = _steps(empty)
    return empty._replace(times=times, touch=touch, now=empty.contact(0.0))


def _steps(search: _Search) -> tuple[tuple[float, ...], float | None]:
    """Every time at which the search stops, and the time of the touch; None for no touch."""
    ball, ring, dt = search.ball, search.ring, search.dt
    rate = abs(ring.spin)
    jerk = rate * rate * (rate * (ring.outer_radius + ball.radius) + 3.0 * length(ball.velocity))
    longest = 1.0 / rate if rate else dt
    times = [0.0]
    while len(times) <= MAX_STEPS:
        time = times[-1]
        horizon = min(dt - time, longest)
        there, along = ball.moved(time), to_cartesian(1.0, ring.phase + ring.half_angle + ring.spin * time)
        inner, outer = ring.inner_radius, ring.outer_radius
        step = safe_step(there.position, there.velocity, ball.radius, ring.spin, along, inner, outer, jerk, horizon)
        if step < horizon and time + step <= time:
            return tuple(times), time
        times.append(time + step)
        if time + step >= dt:
            return tuple(times), None
    return tuple(times), times[-1]


def _picture(given: Given) -> Picture:
    """The ball and the end at every step of the search."""
    search = _search(given)
    ball, ring = search.ball, search.ring
    bound, jerk, sizes, last = _formula(search)
    situation: list[Mark] = [
        AnnularSector(ring.radius, ring.half_width, ring.phase, ring.half_angle, Role.OTHER, None, 0.5),
        Line((ball.position, ball.moved(search.dt).position), Role.FAINT, Toggle.SWEPT, Stroke.DASHED),
        Line(search.end(0.0), Role.SECTOR, Toggle.SWEPT, Stroke.THICK),
        *ball_marks(ball.position, ball.radius),
        Arrow(ball.position, ball.velocity * _SCALE, Role.PLAIN, label="v"),
        _spin_arrow(ring),
    ]
    touch: list[Mark] = []
    if search.touch is not None:
        there = ball.moved(search.touch)
        touch = [
            Circle(there.position, ball.radius, Role.OURS, None, Stroke.THICK),
            *contact_marks(there, search.contact(search.touch)),
        ]
    steps = (
        one_step("a ball and a turning end", situation),
        one_step("how far a step is safe", [], [bound, jerk]),
        one_step("step by step nearer", _step_marks(search), [sizes]),
        one_step(
            "the touch",
            touch,
            [last],
            None if search.touch is None else Prediction("position at the touch", None, ball.moved(search.touch).position),
        ),
    )
    return in_steps(steps, _cited(search), _note(search))


def _step_marks(search: _Search) -> list[Mark]:
    """The ball and the end after every step of the search."""
    marks: list[Mark] = []
    for number, time in enumerate(search.times[1:], 1):
        position = search.ball.moved(time).position
        marks.append(Line(search.end(time), Role.SECTOR, Toggle.SWEPT, Stroke.SOLID))
        marks += ghost_marks(position, search.ball.radius, Toggle.SWEPT)
        marks.append(PointMark(position, Role.PLAIN, Toggle.SWEPT, str(number) if number <= _NUMBERED else ""))
    return marks


def _spin_arrow(ring: Ring) -> Arrow:
    """The velocity of the end's outer corner."""
    corner = to_cartesian(ring.outer_radius, ring.phase + ring.half_angle)
    return Arrow(corner, ring.surface_velocity(corner) * _SCALE, Role.ONE, label="ω × q" if ring.spin else "")


def _formula(search: _Search) -> tuple[str, ...]:
    """The bound that makes a step safe, and the sizes of the steps."""
    ring, ball, steps = search.ring, search.ball, len(search.times) - 1
    rate = abs(ring.spin)
    jerk = rate**3 * (ring.outer_radius + ball.radius) + 3.0 * rate * rate * length(ball.velocity)
    first = search.times[1] - search.times[0] if steps else 0.0
    last = search.times[-1] - search.times[-2] if steps else 0.0
    ended = "no touch" if search.touch is None else f"t = {search.touch:.9f} s"
    return (
        "in the end's frame:   f(s) ≥ f + f' s + f'' s² / 2 - J s³ / 6,   f: distance from the end's line, or from a corner",
        f"J = |ω|³ (r_p + w_p + r) + 3 ω² |v| = {jerk:.2f}",
        f"steps: {steps} of at most {MAX_STEPS};   the first {first:.4f} s, the last {last:.1e} s",
        f"{ended};   there |p - q| - r = {search.contact(search.times[-1]).gap:.1e}",
    )


def _cited(search: _Search) -> CitedLine:
    """The line that ended the search."""
    if search.touch is None:
        return code_line(safe_step, "if height <= -touch or beyond >= horizon:")
    a, b = search.end(search.touch)
    p = search.ball.moved(search.touch).position
    beside = length(a) <= dot(p, b) / length(b) <= length(b)
    return code_line(safe_step, "return 0.0 if height <= touch and dy < 0.0" if beside else "if gap <= touch and rate < 0.0:")


def _note(search: _Search) -> str:
    """What is special about these values."""
    if search.now.gap <= TOUCH * (search.ring.outer_radius + search.ball.radius):
        return "The ball touches or overlaps the end at t = 0: the touch is at 0 if they approach, else the search goes on."
    if search.ring.spin == 0.0:
        return "ω = 0: the end is at rest, and the bound is exact. The engine then solves the equation in closed form."
    if search.touch is None:
        return "No touch within Δt: every step is as long as the bound allows, at most a radian of turning."
    return "Each ghost is a moment up to which no touch is possible. Near the touch the steps shrink faster than Newton's."


def _check(given: Given) -> tuple[Claim, ...]:
    """No step passes the touch, and the last one ends at it."""
    search = _search(given)
    r, until = search.ball.radius, search.times[-1]
    apart = search.now.gap > _SURE
    least = min([search.distance(until * k / _SAMPLES) for k in range(_SAMPLES + 1)])
    outside = contact(search.ball, search.ring, 0).gap > _SURE
    impact = time_of_impact(search.ball, search.ring, search.dt)
    here = impact is not None and abs(search.distance(impact.time) - r) < 1e-9
    touches = search.touch is not None
    grazes = search.touch is not None and _closing(search, search.touch) > -_SURE
    turned = _turned(search)
    return (
        Claim("before the last step ends, the ball does not reach the end", not apart or least > r - 1e-9),
        Claim("where the search ends with a touch, the gap is 0", not (apart and touches) or search.contact(until).gap < 1e-9),
        Claim("the steps are no more than allowed", len(search.times) - 1 <= MAX_STEPS),
        Claim("the steps go forward in time", list(search.times) == sorted(search.times)),
        Claim("time_of_impact is no later", not outside or grazes or search.touch is None or _by(impact, search.touch)),
        Claim("time_of_impact with this end is no earlier", not (outside and here) or search.touch is not None),
        Claim("turned by a radian, the touch is at the same time", grazes or not apart or turned),
    )


def _closing(search: _Search, time: float) -> float:
    """How fast the ball and the end approach at a time; below 0 when they do."""
    found = search.contact(time)
    return dot(found.normal, search.ball.velocity - search.ring.surface_velocity(found.point))


def _by(impact: Impact | None, time: float) -> bool:
    """Whether an impact is no later than a time."""
    return impact is not None and impact.time <= time + 1e-9


def _turned(search: _Search) -> bool:
    """Whether the search in a world turned by a radian ends at the same time."""
    turn = to_cartesian(1.0, 1.0)
    ball, ring = search.ball, search.ring
    there = Ring(ring.radius, ring.half_width, ring.half_angle, 1, ring.phase + 1.0, ring.spin)
    touch = _steps(search._replace(ball=Ball(ball.position * turn, ball.velocity * turn, ball.radius), ring=there))[1]
    if touch is None or search.touch is None:
        return touch is search.touch or max(touch or 0.0, search.touch or 0.0) > search.dt - 1e-9
    return abs(touch - search.touch) < 1e-8


SCENE = LabScene(
    name="impact-turning",
    title="Time of impact: a turning end",
    idea="No formula gives the time of the touch: each step of the search is so short that it cannot pass the touch.",
    functions=("time_of_impact",),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 9.9 + 5.5j, meaning="the ball's centre"),
        Point("v", "v", -30.0, 30.0, -10.9 - 3.3j, 0.1, "its velocity"),
        Number("r", "r", "", 0.05, 3.0, 0.5, 0.05, "the ball's radius"),
        Number("spin", "ω", "rad/s", -12.0, 12.0, 2.0, 0.05, "the ring's spin"),
        Number("dt", "Δt", "s", 0.05, 3.0, 1.5, 0.05, "time that is searched"),
        Number("radius", "r_p", "", 3.0, 13.0, 6.0, 0.05, "the sector's middle radius"),
        Number("half_width", "w_p", "", 0.05, 2.9, 1.2, 0.05, "its half width"),
        Number("angle", "ε", "°", 0.0, 360.0, 0.0, 0.5, "the end's angle at first"),
    ),
    handles=(
        handles.vector("v", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
        handles.on_circle("angle", lambda given: given.number("radius"), "end"),
    ),
    view_box=ViewBox(2.4 + 2.6j, 9.8 + 5.6j),
    shows=_picture,
    check=_check,
    rows=(6,),
    presets=(
        Preset("across the end's path", "spin=2"),
        Preset("the end comes to meet the ball", "ball=2,9&v=2.4,-4&spin=1.2"),
        Preset("a corner", "ball=2,9&v=3,-9&spin=0.2"),
        Preset("a fast ball, a slow end", "ball=2,9&v=4,-9&spin=0.2"),
        Preset("a fast end", "ball=2,9&v=0.5,-5&spin=12&dt=1"),
        Preset("past it", "v=12,2&dt=1"),
        Preset("the end at rest", "spin=0&ball=4,7&v=1,-5"),
        Preset("touching at t = 0", "ball=6,0.5&v=0,3&spin=1.2"),
    ),
)
