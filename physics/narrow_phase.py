"""Contact of the ball with one sector (the source: "Narrow phase", cases 1 and 2)."""

import math

from physics.polar import on_left
from physics.shapes import Ball, Contact, Feature, Ring
from physics.trig import bearing_of, direction
from physics.vectors import cross, dot, length, quarter_turn, unit


def closest_point_on_line(a: complex, b: complex, p: complex) -> complex:
    """The point of the segment from a to b nearest to p.

    The source's line AB, clamped to the segment: the clamp is what makes the corners. Returns a or b itself
    beyond the ends, and a when a = b.

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


def narrow_phase_case_1(p: complex, radius: float) -> complex:
    """Normal of a face, for a ball whose angle lies within the sector's: radial, away from the ring's middle radius.

    p: the ball's centre. radius: of the ring's middle (the source's r_p). For p = 0 the bearing is 0 by convention.

    >>> narrow_phase_case_1(3 + 4j, 6.0), narrow_phase_case_1(3 + 4j, 4.0)
    ((-0.6-0.8j), (0.6+0.8j))
    """
    n = unit(p) if p != 0.0 else complex(1.0, 0.0)
    return -n if length(p) < radius else n


def narrow_phase_case_2(
    p: complex, ball_radius: float, theta: float, radius: float, angle: float, half_width: float, half_angle: float
) -> complex | None:
    """Normal of an end, for a ball whose angle theta lies outside the sector's; None when it does not touch.

    radius, angle: the sector's middle (the source's r_p, theta_p). Touching means a distance in [0, ball_radius): where
    the source leaves out the distance 0, the normal is the end's own. The nearer end is found from the sector's middle,
    which is right however wide the sector is.
    """
    sign = 1.0 if on_left(theta, angle) else -1.0
    inner, outer = radius - half_width, radius + half_width
    found = end_contact(p, ball_radius, direction(angle + sign * half_angle), sign, inner, outer)
    return found.normal if found.gap < 0.0 else None


def contact(ball: Ball, ring: Ring, slot: int) -> Contact:
    """The nearest point of one sector to the ball, with the gap between them.

    Case 1, face: the ball's bearing lies within the sector, so an arc is nearest and the normal is radial.
    Case 2, end: it lies outside, so the straight end nearer in angle is nearest; its two corners need no code
    of their own, they are the clamped foot of the perpendicular.
    A ball whose centre is inside the material is nearest to the side through which the way out is shortest.
    """
    bearing = bearing_of(ball.position)
    middle = ring.angle_near(slot, bearing)
    return sector_contact(ball.position, ball.radius, ring, middle, bearing - middle)


def sector_contact(p: complex, ball_radius: float, ring: Ring, middle: float, offset: float) -> Contact:
    """`contact` for a sector whose middle angle, and the ball's signed offset from it, are known."""
    radius, half_width, half_angle = ring.radius, ring.half_width, ring.half_angle
    inner, outer = radius - half_width, radius + half_width
    if abs(offset) <= half_angle:
        distance = length(p)
        if half_angle < math.pi and inner < distance < outer:
            return _inside_contact(p, ball_radius, ring, middle, offset)
        return face_contact(p, ball_radius, radius, half_width)
    sign = 1.0 if offset > 0.0 else -1.0
    return end_contact(p, ball_radius, direction(middle + sign * half_angle), sign, inner, outer)


def face_contact(p: complex, ball_radius: float, radius: float, half_width: float) -> Contact:
    """Contact with the face on the ball's side of the middle radius (case 1)."""
    normal = narrow_phase_case_1(p, radius)
    distance = length(p)
    if distance < radius:
        inner = radius - half_width
        return Contact(normal, -normal * inner, inner - distance - ball_radius, Feature.INNER_FACE)
    outer = radius + half_width
    return Contact(normal, normal * outer, distance - outer - ball_radius, Feature.OUTER_FACE)


def end_contact(p: complex, ball_radius: float, end: complex, sign: float, inner: float, outer: float) -> Contact:
    """Contact with one straight end and its two corners (case 2).

    end: unit vector along the end, outwards. sign: +1 for the counter-clockwise end of a sector, -1 for the clockwise one.
    """
    a, b = end * inner, end * outer
    q = closest_point_on_line(a, b, p)
    distance = length(p - q)
    feature = Feature.CORNER if q in (a, b) else Feature.END
    normal = quarter_turn(end) * sign if feature == Feature.END or distance == 0.0 else unit(p - q)
    return Contact(normal, q, distance - ball_radius, feature)


def _inside_contact(p: complex, ball_radius: float, ring: Ring, middle: float, offset: float) -> Contact:
    """The shortest way out for a centre inside the material: through a face or through the nearer end."""
    face = face_contact(p, ball_radius, ring.radius, ring.half_width)
    sign = 1.0 if offset > 0.0 else -1.0
    end = direction(middle + sign * ring.half_angle)
    depth = abs(cross(end, p))
    along = dot(end, p)
    if along <= 0.0 or depth + ball_radius >= -face.gap:
        return face
    return Contact(quarter_turn(end) * sign, end * along, -depth - ball_radius, Feature.END)
