"""The symbols of the collision detection: the ball, one sector of a ring, and the sector's end."""

import cmath
import math

from physics import Ball, Ring, contact, to_polar
from tools.figures.sheet import BALL, FAINT, INK, NORMAL, SECTOR_EDGE, Sheet

_RING = Ring(radius=7.0, half_width=0.9, half_angle=math.radians(21.0), count=1, phase=math.radians(68.0))
_END = math.radians(68.0 - 21.0)
_BALL_RADIUS = 1.0
_ALONG = 7.35
"""Distance from the centre of the point of the end that the ball touches."""
_BALL = Ball(cmath.rect(_ALONG, _END) + cmath.rect(_BALL_RADIUS, _END - math.pi / 2), 0j, _BALL_RADIUS)
_A, _B = cmath.rect(_RING.inner_radius, _END), cmath.rect(_RING.outer_radius, _END)


def polar_symbols() -> Sheet:
    """The ball at p with its angle, and a sector with its middle, its half width and its half angle."""
    sheet = Sheet(-1.6 - 0.9j, 9.9 + 9.0j, 620)
    p, middle = _BALL.position, _RING.angle(0)
    theta = to_polar(p)[1]
    for radius in (_RING.inner_radius, _RING.outer_radius):
        sheet.arc(radius, -0.06, 2.0)
    sheet.arc(9.4, -0.06, 1.95, colour=INK, dashed=False)
    sheet.line(-0.5 + 0j, 9.9 + 0j, colour=FAINT, width=1.0)
    sheet.sector(_RING.inner_radius, _RING.outer_radius, middle - _RING.half_angle, middle + _RING.half_angle)
    sheet.arc(_RING.radius, middle - _RING.half_angle, middle + _RING.half_angle, colour=SECTOR_EDGE)
    sheet.line(0j, cmath.rect(_RING.radius, middle))
    sheet.line(0j, _B, colour=FAINT, dashed=True)
    sheet.circle(p, _BALL_RADIUS, fill=BALL)
    sheet.line(0j, p)
    sheet.arrow(p, p + cmath.rect(_BALL_RADIUS, 0.25), width=1.2)
    sheet.text(p + cmath.rect(0.55, 0.78), "$r$")
    sheet.angle(1.7, 0.0, theta)
    sheet.text(cmath.rect(2.1, theta / 2), r"$\theta$")
    sheet.angle(2.8, 0.0, middle)
    sheet.text(cmath.rect(3.25, 0.3), r"$\theta_p$")
    sheet.angle(4.3, middle, _END)
    sheet.text(cmath.rect(4.75, (middle + _END) / 2), r"$\varphi_p$")
    sheet.text(cmath.rect(5.3, middle + 0.07), "$r_p$")
    sheet.text(cmath.rect(4.1, theta - 0.08), r"$|\mathbf{p}|$")
    left = middle + 0.72 * _RING.half_angle
    for start, stop in ((_RING.radius, _RING.outer_radius), (_RING.outer_radius, _RING.radius)):
        sheet.arrow(cmath.rect(start, left), cmath.rect(stop, left), width=1.2)
    sheet.text(cmath.rect(_RING.radius + 0.45, left - 0.07), "$w_p$")
    for at in (0j, p, cmath.rect(_RING.radius, middle)):
        sheet.dot(at)
    sheet.text(p + 0.1 - 0.42j, r"$\mathbf{p}$")
    sheet.text(-0.35 - 0.4j, "centre", size=13)
    sheet.text(8.55 - 0.4j, "polar axis", size=13)
    sheet.text(cmath.rect(8.62, 0.2), "rim of the\nground, $r_g$", size=12)
    sheet.text(cmath.rect(7.0, 0.2), "band of\nthe ring", size=12, colour=FAINT)
    return sheet


def end_symbols() -> Sheet:
    """The end that the ball touches, close: its corners, its nearest point and the normal."""
    p, found = _BALL.position, contact(_BALL, _RING, 0)
    sheet = Sheet(p - 2.55 - 1.75j, p + 2.25 + 2.1j, 520)
    sheet.sector(_RING.inner_radius, _RING.outer_radius, _END, _RING.angle(0) + _RING.half_angle)
    sheet.line(_A * 0.6, _B * 1.3, colour=FAINT, dashed=True)
    sheet.circle(p, _BALL_RADIUS, fill=BALL)
    sheet.line(_A, _B, width=3.0)
    sheet.arrow(found.point, found.point + found.normal * 1.7, colour=NORMAL, width=3.0)
    for at in (_A, _B, found.point, p):
        sheet.dot(at, radius=4.5)
    rim = p + cmath.rect(_BALL_RADIUS, -2.45)
    sheet.arrow(p, rim, width=1.2)
    sheet.text((p + rim) / 2 + 0.16 - 0.1j, "$r$", size=20)
    sheet.text(_A + cmath.rect(0.3, _END + 2.6), "$A$", size=20)
    sheet.text(_B + cmath.rect(0.3, _END + 1.2), "$B$", size=20)
    sheet.text(found.point + cmath.rect(0.33, _END + 1.9), r"$\hat{\mathbf{q}}$", size=20)
    sheet.text(p + cmath.rect(0.3, 1.1), r"$\mathbf{p}$", size=20)
    sheet.text(found.point + found.normal * 1.7 + 0.3 + 0.05j, r"$\mathbf{n}$", size=20, colour=NORMAL)
    sheet.text(_A * 0.5 + _B * 0.5 + cmath.rect(1.35, 2.35), "the sector's\nmaterial", size=13, colour=SECTOR_EDGE)
    return sheet
