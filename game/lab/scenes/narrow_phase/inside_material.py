"""A ball that starts inside the material: through which side does it leave?"""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import FEATURE_WORDS, ball_marks, contact_marks, outline_points, ring_marks, two_decimals
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import (
    Arrow,
    Circle,
    Line,
    Mark,
    Picture,
    Prediction,
    Role,
    Stroke,
    Toggle,
    Words,
    in_steps,
    one_step,
)
from game.lab.kit.scene import Claim, LabScene, Preset, ViewBox
from game.rules import TICK
from physics import (
    PERMANENT,
    Arena,
    Ball,
    Contact,
    Feature,
    Ring,
    Step,
    advance,
    angle_of,
    contact,
    dot,
    length,
    min_difference,
)
from physics.narrow_phase import contact_above, face_contact
from physics.tolerances import OVERLAP

_SAMPLES = 200


class _BallInside(NamedTuple):
    """A ball put somewhere, the contacts through which it could leave, and the tick that follows.

    face: the source's contact, a face wherever the centre is. found: ours, with the nearest side.
    """

    ball: Ball
    ring: Ring
    face: Contact
    found: Contact
    step: Step

    @property
    def over(self) -> bool:
        """Whether the ball's angle lies within the sector's: the source's case 1."""
        return min_difference(angle_of(self.ball.position), self.ring.angle(0)) <= self.ring.half_angle

    @property
    def inside(self) -> bool:
        """Whether the ball's centre is in the material."""
        return self.over and self.ring.inner_radius < length(self.ball.position) < self.ring.outer_radius


def _ball_inside(given: Given) -> _BallInside:
    """The ball and the sector that the values make."""
    ring = Ring(given.number("radius"), given.number("half_width"), given.angle("half_angle"), 1, given.angle("angle"))
    ball = Ball(given.point("ball"), 0j, given.number("r"))
    face = face_contact(ball, ring)
    step = advance(Arena((ball,), (ring,), ((PERMANENT,),)), TICK, 1.0)
    return _BallInside(ball, ring, face, contact(ball, ring, 0), step)


def _picture(given: Given) -> Picture:
    """The ball, and where it is put by the source and by the physics."""
    start = _ball_inside(given)
    ball, ring = start.ball, start.ring
    *depths, last = _formula(start)
    theirs = _push(ball, start.face, Role.SOURCE, "the source: a face") if start.over and start.face.gap < 0.0 else []
    there = ball.position - start.found.normal * start.found.gap
    steps = (
        one_step("a ball inside the material", [*ring_marks(ring), *ball_marks(ball.position, ball.radius)]),
        one_step("the depths", [], depths),
        one_step("the source: always a face", theirs),
        one_step("here: the nearest side", _put_by_physics(start), [last], Prediction("new position", None, there)),
    )
    return in_steps(steps, _cited(start), _note(start))


def _put_by_physics(start: _BallInside) -> list[Mark]:
    """Where the physics puts the ball; the contact, for a ball that is left where it is."""
    ball = start.ball
    if not start.step.freed:
        return list(contact_marks(ball, start.found))
    position = start.step.arena.balls[0].position
    if length(position - ball.position + start.found.normal * start.found.gap) < 1e-9:
        return _push(ball, start.found, Role.OURS, "here: the nearest side")
    return [
        Circle(position, ball.radius, Role.OURS, Toggle.SWEPT, Stroke.THICK),
        Line((ball.position, position), Role.OURS),
    ]


def _push(ball: Ball, side: Contact, role: Role, words: str) -> list[Mark]:
    """The ball after it was pushed out through one side, and how far."""
    there = ball.position - side.normal * side.gap
    return [
        Circle(there, ball.radius, role, Toggle.SWEPT, Stroke.THICK),
        Arrow(ball.position, there - ball.position, role, Toggle.NORMALS),
        Words(there + side.normal * (ball.radius + 0.7), words, role, Toggle.NORMALS),
    ]


def _formula(start: _BallInside) -> tuple[str, ...]:
    """The depths, and the least of them."""
    ring, p, r = start.ring, start.ball.position, start.ball.radius
    if not start.inside:
        return ("the centre is not in the material", f"gap = {start.found.gap:.3f},   n = {two_decimals(start.found.normal)}")
    offset = ring.half_angle - min_difference(angle_of(p), ring.angle(0))
    end = f"{length(p) * math.sin(offset):.3f}" if offset < math.pi / 2.0 else "out of reach"
    return (
        f"to the outer face:   r_p + w_p - |p| = {ring.outer_radius - length(p):.3f}",
        f"to the inner face:   |p| - (r_p - w_p) = {length(p) - ring.inner_radius:.3f}",
        f"to the nearer end:   |p| sin(φ_p - |θ - θ_p|) = {end}",
        f"the least: {FEATURE_WORDS[start.found.feature]}, plus r = {r:g}: the ball is moved by {-start.found.gap:.3f}",
        f"the tick that follows:   freed = {start.step.freed}",
    )


def _cited(start: _BallInside) -> CitedLine:
    """The source's line where it is wrong, else the line of the physics."""
    if start.inside and start.found.feature is Feature.END:
        return source_line("Broad phase", "if min_difference(θ, θ_p) ≤ φ_p: return narrow_phase_case_1(p, r_p)")
    return code_line(contact_above, "if face.gap > -ball.radius or ring.half_angle == math.pi:")


def _note(start: _BallInside) -> str:
    """What is special about these values."""
    if start.ring.half_angle >= math.pi:
        return "φ_p = 180°: a closed ring has no ends, so the ball leaves through a face."
    if not start.inside:
        return "The centre is outside the material, as always in a game that has begun. Drag the ball into the sector."
    if start.found.feature is Feature.END:
        return "θ lies within the sector, so the source pushes the ball out through a face. The end is nearer."
    return "A face is the nearest side: here the source is right."


def _check(given: Given) -> tuple[Claim, ...]:
    """The ball leaves through the nearest side, and then overlaps nothing."""
    start = _ball_inside(given)
    ball, ring, found = start.ball, start.ring, start.found
    depth = -found.gap - ball.radius
    nearest = min([length(ball.position - point) for point in outline_points(ring, _SAMPLES)])
    pushed = Ball(ball.position - found.normal * found.gap, 0j, ball.radius)
    simple = start.inside and ring.half_angle <= math.pi / 2.0 and ball.radius < ring.inner_radius
    after = start.step.arena.balls[0]
    overlaps = found.gap < -OVERLAP * ball.radius
    clear = abs(found.gap + OVERLAP * ball.radius) > 1e-12
    return (
        Claim("no point of the outline is nearer than the chosen side", not start.inside or depth <= nearest + 1e-9),
        Claim("our push is no longer than the source's", not start.inside or found.gap >= start.face.gap - 1e-12),
        Claim("after the push the ball touches the sector", not simple or abs(contact(pushed, ring, 0).gap) < 1e-9),
        Claim("the next tick frees a ball that overlaps, and no other", not clear or start.step.freed == int(overlaps)),
        Claim("after that tick nothing overlaps", contact(after, ring, 0).gap > -1e-9),
        Claim("the push is not counted as a bounce", start.step.hits == ()),
        Claim(
            "the normal points out of the sector", not start.inside or dot(found.normal, found.point - ball.position) > -1e-12
        ),
    )


SCENE = LabScene(
    name="inside-material",
    title="A ball inside the material",
    idea="That θ within the sector means a face is true only for a ball outside. One inside leaves through the nearest side.",
    functions=("narrow_phase_case_1", "broad_phase"),
    parameters=(
        Point("ball", "p", -15.0, 15.0, 4.6 + 5.2j, meaning="where the ball is put"),
        Number("r", "r", "", 0.05, 3.0, 0.6, 0.05, "the ball's radius"),
        Number("radius", "r_p", "", 3.0, 13.0, 7.5, 0.05, "the sector's middle radius"),
        Number("angle", "θ_p", "°", 0.0, 360.0, 20.0, 0.5, "the sector's middle angle"),
        Number("half_width", "w_p", "", 0.05, 2.9, 2.0, 0.05, "its half width"),
        Number("half_angle", "φ_p", "°", 0.5, 180.0, 32.0, 0.5, "its half angle"),
    ),
    handles=(handles.point("ball", "ball", "r"), *handles.sector_handles("radius", "half_width", "angle", "half_angle")),
    view_box=ViewBox(6.0 + 3.2j, 6.6 + 5.5j),
    shows=_picture,
    check=_check,
    rows=(7,),
    presets=(
        Preset("near an end", "ball=4.6,5.2"),
        Preset("near the outer face", "ball=8.6,2.5"),
        Preset("near the inner face", "ball=5.5,2.4"),
        Preset("equally far from three sides", "ball=6.1,3.2"),
        Preset("outside", "ball=3,6.5"),
        Preset("a closed ring", "half_angle=180"),
    ),
)
