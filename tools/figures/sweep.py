"""When a ball can touch a ring at all: the stretches of its flight in the band, the ends of a gap, and how far off they are."""

import cmath
import math

from physics import Ball, Ring, time_of_impact
from tools.figures.sheet import BALL, FAINT, INK, NORMAL, VELOCITY, Sheet

_RING = Ring(radius=5.0, half_width=0.6, half_angle=math.radians(17.0), count=6, phase=math.radians(128.0))
_BALL = Ball(-7.6 + 1.6j, 4.0 + 0.35j, 0.5)


def sweep_symbols() -> Sheet:
    """The path of the ball's centre, in the band and out of it, up to the first touch."""
    sheet = Sheet(-8.9 - 1.3j, 8.9 + 7.3j, 720)
    impact = time_of_impact(_BALL, _RING, 5.0)
    assert impact is not None
    for slot in range(_RING.count):
        middle = _RING.angle(slot)
        sheet.sector(_RING.inner_radius, _RING.outer_radius, middle - _RING.half_angle, middle + _RING.half_angle)
    for slot, sign in ((0, 1), (1, -1), (4, 1), (5, -1)):
        angle = _RING.angle(slot) + sign * _RING.half_angle
        sheet.line(cmath.rect(_RING.inner_radius, angle), cmath.rect(_RING.outer_radius, angle), width=4.0)
    for border in (_RING.inner_radius - _BALL.radius, _RING.outer_radius + _BALL.radius):
        sheet.circle(0j, border, colour=FAINT, dashed=True)
    start, end = _BALL.position, _BALL.moved(impact.time).position
    borders = [time for time in _crossings() if time < impact.time]
    points = [start, *[_BALL.moved(time).position for time in borders], end]
    for k in range(len(points) - 1):
        sheet.line(points[k], points[k + 1], colour=VELOCITY if k % 2 else FAINT, width=4.0 if k % 2 else 1.6)
    for at in points[1:]:
        sheet.circle(at, _BALL.radius, colour=FAINT)
    sheet.circle(start, _BALL.radius, fill=BALL)
    sheet.circle(end, _BALL.radius, fill=BALL)
    sheet.arrow(start, start + 0.3 * _BALL.velocity, colour=INK)
    sheet.arrow(impact.contact.point, impact.contact.point + impact.contact.normal * 1.3, colour=NORMAL, width=2.6)
    for at in (*points, impact.contact.point):
        sheet.dot(at)
    for k in range(len(points) - 1):
        sheet.text((points[k] + points[k + 1]) / 2 + 0.5j, str(k + 1), size=13)
    parts = (
        "1 outside the band: free",
        "2 in the band, inward",
        "3 in the hole: free",
        "4 in the band, outward,",
        "to the first touch",
    )
    sheet.text(-2.3 + 0.75j, "\n".join(parts), size=13, align="left")
    sheet.text(impact.contact.point + impact.contact.normal * 1.3 + 0.3, r"$\mathbf{n}$", colour=NORMAL)
    sheet.text(5.0 + 6.4j, "dashed: the band's borders,\n$r_p \\pm (w_p + r)$", size=13)
    sheet.text(-5.6 + 5.4j, "thick: the two\nends of a gap", size=13)
    return sheet


def free_flight_symbols() -> Sheet:
    """A ball in a gap: the angle that it covers, and what may use up the angle from there to the two ends."""
    ring = Ring(radius=6.0, half_width=0.7, half_angle=math.radians(12.0), count=4, phase=math.radians(45.0))
    ball = Ball(cmath.rect(5.9, math.radians(86.0)), cmath.rect(1.9, math.radians(10.0)), 0.62)
    sheet = Sheet(-5.9 - 0.5j, 5.9 + 8.0j, 560)
    theta, covered = math.radians(86.0), math.asin(ball.radius / 5.9)
    right, left = ring.angle(0) + ring.half_angle, ring.angle(1) - ring.half_angle
    for slot in (0, 1):
        middle = ring.angle(slot)
        sheet.sector(ring.inner_radius, ring.outer_radius, middle - ring.half_angle, middle + ring.half_angle)
    for angle, colour in ((right, INK), (left, INK), (theta - covered, FAINT), (theta + covered, FAINT)):
        sheet.line(0j, cmath.rect(ring.outer_radius, angle), colour=colour, dashed=True)
    sheet.circle(ball.position, ball.radius, fill=BALL)
    sheet.dot(ball.position)
    sheet.dot(0j)
    sheet.arrow(ball.position, ball.position + ball.velocity, colour=VELOCITY)
    sheet.text(ball.position + ball.velocity + 0.3, r"$\mathbf{v}$", colour=VELOCITY)
    sheet.angle(4.3, theta - covered, theta - covered - 0.12, colour=VELOCITY)
    for end, turn in ((right, 0.16), (left, -0.16)):
        sheet.angle(7.05, end, end + turn, colour=NORMAL)
        sheet.angle(4.3, end, end + turn, colour=NORMAL)
    sheet.text(7.62j, "the ring, at its fastest, may turn either way", size=13, colour=NORMAL)
    sheet.text(2.6 + 1.5j, "free until these\narrows meet", size=13)
    sheet.text(-2.7 + 1.5j, "the ball covers\nthe middle angle", size=13, colour=FAINT)
    return sheet


def _crossings() -> list[float]:
    """When the ball's centre crosses the borders of the band, seconds, in order."""
    p, v = _BALL.position, _BALL.velocity
    times = []
    for radius in (_RING.inner_radius - _BALL.radius, _RING.outer_radius + _BALL.radius):
        outward = (p * v.conjugate()).real
        root = math.sqrt(outward**2 - abs(v) ** 2 * (abs(p) ** 2 - radius**2))
        times += [(-outward - root) / abs(v) ** 2, (-outward + root) / abs(v) ** 2]
    return sorted(times)
