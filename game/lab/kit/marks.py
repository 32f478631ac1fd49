"""Marks that scenes share: a ball, a sector, a contact, another engine's opinion of it."""

import math
from collections.abc import Sequence

from game.lab.kit.parameters import Given
from game.lab.kit.picture import Arc, Arrow, Circle, Disc, Dot, Line, Mark, Sector, Stroke, Toggle, Tone
from physics import Ball, Contact, Ring, dot, to_cartesian

VELOCITY_SCALE = 0.2
"""World units drawn per unit of speed."""
_TOUCH = 1e-9
"""World units. Balls this near to a surface are said to touch it."""


def ball_marks(position: complex, radius: float, tone: Tone = Tone.BALL) -> tuple[Mark, ...]:
    """A ball and its centre p."""
    return Disc(position, radius, tone), Dot(position, Tone.FAINT, label="p" if tone is Tone.BALL else "")


def ghost_marks(position: complex, radius: float, toggle: Toggle | None = None) -> tuple[Mark, ...]:
    """A place where a ball was or will be."""
    return (Circle(position, radius, Tone.GHOST, toggle, Stroke.DASHED),)


def ring_marks(ring: Ring, alive: Sequence[int] | None = None, nearest: int | None = None) -> tuple[Mark, ...]:
    """The sectors of a ring. alive: one entry per slot; nearest: the one that stands out, None for all alike."""
    return tuple(
        [
            Sector(
                ring.radius,
                ring.half_width,
                ring.angle(slot),
                ring.half_angle,
                Tone.SECTOR if nearest is None or slot == nearest else Tone.OTHER,
            )
            for slot in range(ring.count)
            if alive is None or alive[slot]
        ]
    )


def contact_marks(ball: Ball, found: Contact, length: float = 1.0) -> tuple[Mark, ...]:
    """The closest point, the gap and the normal of a contact; the contact point when they touch. length: of the normal."""
    marks: list[Mark] = [Dot(found.point, Tone.OURS, Toggle.CLOSEST, "q")]
    surface = ball.position - found.normal * ball.radius
    marks.append(Line((found.point, surface), Tone.OURS, Toggle.GAP, Stroke.THICK))
    marks.append(Arrow(found.point, found.normal * length, Tone.OURS, Toggle.NORMALS, label="n"))
    if found.gap <= _TOUCH:
        marks.append(Circle(found.point, 0.12 * length, Tone.OURS, Toggle.CONTACTS, Stroke.THICK))
    return tuple(marks)


def second_opinion(given: Given, ball: Ball, ring: Ring, slots: Sequence[int], ours: Contact | None) -> tuple[Mark, ...]:
    """The other engine's shapes, its normal at the ball, and the angle between it and ours; nothing without an engine."""
    engine = given.engine
    if engine is None:
        return ()
    marks: list[Mark] = []
    for piece in engine.pieces(ring, slots):
        if piece.radius > 0.0:
            marks.append(Circle(piece.a, piece.radius, Tone.PYMUNK, Toggle.PYMUNK))
        elif piece.a == piece.b:
            marks.append(Dot(piece.a, Tone.PYMUNK, Toggle.PYMUNK))
        else:
            marks.append(Line((piece.a, piece.b), Tone.PYMUNK, Toggle.PYMUNK))
    touch = engine.touch(ball, ring, slots)
    if touch is not None:
        start = ball.position - touch.normal * touch.distance
        text = f"{engine.name}: {angle_between(touch.normal, ours.normal)} from ours" if ours is not None else engine.name
        marks.append(Arrow(start, touch.normal * 1.6, Tone.PYMUNK, Toggle.PYMUNK, Stroke.SOLID, text))
    return tuple(marks)


def angle_between(one: complex, other: complex) -> str:
    """The angle between two directions, as people read it."""
    turn = one * other.conjugate()
    degrees = math.degrees(abs(math.atan2(turn.imag, turn.real)))
    return f"{degrees:.2f}°" if degrees >= 0.01 or degrees == 0.0 else f"{degrees:.0e}°"


def angle_arc(radius: float, start: float, sweep: float, tone: Tone, label: str) -> Arc:
    """An angle at the origin."""
    return Arc(0j, radius, start, sweep, tone, label=label)


def ray(angle: float, reach: float, tone: Tone = Tone.FAINT, label: str = "") -> Line:
    """A line from the origin in a direction."""
    return Line((0j, to_cartesian(reach, angle)), tone, None, Stroke.DASHED, label)


def two_decimals(vector: complex) -> str:
    """A point or a vector in two numbers."""
    return f"({round(vector.real, 2) + 0.0:.2f}, {round(vector.imag, 2) + 0.0:.2f})"


def degrees(angle: float) -> str:
    """An angle in degrees."""
    return f"{math.degrees(angle):.2f}°"


def is_unit(vector: complex) -> bool:
    """Whether a vector has length 1, but for rounding."""
    return abs(dot(vector, vector) - 1.0) < 1e-12
