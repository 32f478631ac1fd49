"""Contact of the ball with one sector (the source: "Narrow phase", cases 1 and 2)."""

import math
from typing import NamedTuple

from physics.polar import add_angles, min_difference, on_left, subtract_angles, to_cartesian, to_polar
from physics.shapes import Ball, Contact, Feature, Ring
from physics.tolerances import JOINT
from physics.vectors import dot, length, quarter_turn, unit


class NearestEnd(NamedTuple):
    """The end of a sector that a ball can touch (the slide's A, B and q).

    Attributes:
        a: its inner corner.
        b: its outer corner.
        q: its point nearest to the ball. All in world units.
        outward: unit vector at a right angle to AB, out of the sector.
    """

    a: complex
    b: complex
    q: complex
    outward: complex


def contact(ball: Ball, ring: Ring, slot: int) -> Contact:
    """The nearest point of one sector to the ball, with the gap between them. slot: 0 to ring.count - 1.

    Case 1, face: the ball's angle lies within the sector, so an arc is nearest and the normal is radial.
    Case 2, end: it lies outside, so the straight end nearer in angle is nearest; its two corners need no code
    of their own, they are the clamped foot of the perpendicular.
    A ball whose centre is inside the material is nearest to the side through which the way out is shortest. One at the
    exact centre is equally near to a whole inner face: the point that it flies towards is taken.
    """
    theta = to_polar(ball.position)[1] if ball.position != 0.0 else ball.theta()
    angle = ring.angle(slot)
    if not is_over(ring, theta, angle):
        return end_contact(ball, ring, slot, theta)
    return contact_above(ball, ring, theta, angle)


def contact_above(ball: Ball, ring: Ring, theta: float, angle: float) -> Contact:
    """`contact` with a sector, its middle at `angle`, within which the ball's angle theta is known to lie."""
    face = face_contact(ball, ring)
    if face.gap > -ball.radius or ring.half_angle == math.pi:
        return face
    return _inside_contact(ball, ring, angle, theta, face)


def is_over(ring: Ring, theta: float, angle: float) -> bool:
    """Whether an angle theta lies within a sector with its middle at `angle`: the source's question, case 1 or case 2.

    A closed ring has no gap, though rounding leaves one of a few lines of the angle grid where two of its sectors join (JOINT).
    """
    closed = 2.0 * ring.half_angle * ring.count >= math.tau
    return min_difference(theta, angle) <= (ring.half_angle + JOINT if closed else ring.half_angle)


def narrow_phase_case_1(p: complex, radius: float) -> complex:
    """Normal of a face, for a ball whose angle lies within the sector's: radial, away from the ring's middle radius.

    p: the ball's centre; radius: of the ring's middle (the source's r_p); both in world units. The result is a unit vector
    from the obstacle to the ball. For p = 0 the angle is 0 by convention.

    >>> narrow_phase_case_1(3 + 4j, 6.0), narrow_phase_case_1(3 + 4j, 4.0)
    ((-0.6-0.8j), (0.6+0.8j))
    """
    n = unit(p) if p != 0.0 else complex(1.0, 0.0)
    return -n if length(p) < radius else n


def narrow_phase_case_2(
    p: complex, ball_radius: float, theta: float, radius: float, angle: float, half_width: float, half_angle: float
) -> complex | None:
    """Normal of an end, for a ball whose angle theta lies outside the sector's; None when it does not touch.

    theta, angle: radians, normalised. half_angle: radians, in (0, pi]. p, ball_radius, radius, half_width: world units.
    radius, angle: the sector's middle (the source's r_p, theta_p). The result is a unit vector from the obstacle to the ball.
    Touching means a distance in [0, ball_radius). At the distance 0, which the source leaves out, the normal is the end's own.
    Which end is decided by the side of the sector's middle on which theta lies; that is right however wide the sector is.
    """
    end = nearest_end(p, theta, radius, angle, half_width, half_angle)
    distance = length(p - end.q)
    if distance >= ball_radius:
        return None
    return end_normal(p, end, distance)


def end_normal(p: complex, end: NearestEnd, distance: float) -> complex:
    """Unit vector from the nearest point of an end to the ball's centre p, `distance` away; on AB the end's own normal."""
    return unit(p - end.q) if end.q in (end.a, end.b) and distance > 0.0 else end.outward


def closest_point_on_line(a: complex, b: complex, p: complex) -> complex:
    """The point of the segment from a to b nearest to p.

    a, b, p: in any unit of length, all in the same. The source's line AB, clamped to the segment: the clamp is what makes
    the corners. Returns a or b itself beyond the ends, and a when a = b.

    >>> closest_point_on_line(0j, 2 + 0j, 1 + 5j), closest_point_on_line(0j, 2 + 0j, 7 + 5j)
    ((1+0j), (2+0j))
    """
    ab = b - a
    along = dot(p - a, ab)
    if along <= 0.0:
        return a
    square = dot(ab, ab)
    if along >= square:
        return b
    return a + ab * (along / square)


def face_contact(ball: Ball, ring: Ring) -> Contact:
    """Contact with the face on the ball's side of the middle radius (case 1)."""
    p, v, ball_radius = ball
    if p == 0.0 and v != 0.0:  # the point that it flies towards: its own normal, seen from a hair along its flight
        normal = narrow_phase_case_1(unit(v) * (0.5 * ring.radius), ring.radius)
    else:
        normal = narrow_phase_case_1(p, ring.radius)
    distance = length(p)
    if distance < ring.radius:
        inner = ring.radius - ring.half_width
        return Contact(normal, -normal * inner, inner - distance - ball_radius, Feature.INNER_FACE)
    outer = ring.radius + ring.half_width
    return Contact(normal, normal * outer, distance - outer - ball_radius, Feature.OUTER_FACE)


def end_angle(angle: float, half_angle: float, side: int) -> float:
    """Angle of one end of a sector with its middle at an angle: side +1 the counter-clockwise end, -1 the clockwise one."""
    return add_angles(angle, half_angle) if side > 0 else subtract_angles(angle, half_angle)


def end_contact(ball: Ball, ring: Ring, slot: int, theta: float) -> Contact:
    """Contact with the straight end, and its two corners, on that side of a sector's middle where theta lies (case 2)."""
    p, _, ball_radius = ball
    radius, half_width, half_angle = ring.radius, ring.half_width, ring.half_angle
    angle = ring.angle(slot)
    normal = narrow_phase_case_2(p, math.inf, theta, radius, angle, half_width, half_angle)
    assert normal is not None, "an infinite ball touches every end"
    end = nearest_end(p, theta, radius, angle, half_width, half_angle)
    feature = Feature.CORNER if end.q in (end.a, end.b) else Feature.END
    # The normal is made anew because a compiler of these functions cannot know from the assertion that it is no None.
    return Contact(complex(normal.real, normal.imag), end.q, length(p - end.q) - ball_radius, feature)


def nearest_end(p: complex, theta: float, radius: float, angle: float, half_width: float, half_angle: float) -> NearestEnd:
    """The end on theta's side of the sector's middle: A, B, and the point nearest to p."""
    side = 1 if on_left(theta, angle) else -1
    along = to_cartesian(1.0, end_angle(angle, half_angle, side))
    a, b = along * (radius - half_width), along * (radius + half_width)
    return NearestEnd(a, b, closest_point_on_line(a, b, p), quarter_turn(along) * side)


def _inside_contact(ball: Ball, ring: Ring, angle: float, theta: float, face: Contact) -> Contact:
    """The shortest way out for a centre inside the material: through the face, or straight through the nearer end.

    Where a corner is the nearest point of that end, the face that ends there is nearer still.
    """
    p, _, ball_radius = ball
    end = nearest_end(p, theta, ring.radius, angle, ring.half_width, ring.half_angle)
    gap = -length(p - end.q) - ball_radius
    return face if end.q in (end.a, end.b) or gap <= face.gap else Contact(end.outward, end.q, gap, Feature.END)
