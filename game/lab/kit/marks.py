"""Marks that several scenes draw: a ball, a ring's sectors, a contact, the second engine's answer; and numbers in words."""

import math
from collections.abc import Sequence

from game.lab.kit.parameters import Given
from game.lab.kit.picture import AnnularSector, Arc, Arrow, Circle, Disc, Line, Mark, PointMark, Role, Stroke, Toggle
from physics import Ball, Contact, Feature, Ring, dot, to_cartesian

VELOCITY_SCALE = 0.2
"""World units drawn per unit of speed."""
FEATURE_WORDS = {
    Feature.OUTER_FACE: "the outer face",
    Feature.INNER_FACE: "the inner face",
    Feature.END: "an end",
    Feature.CORNER: "a corner",
}
"""What of a sector is nearest or touched, in words."""
_TOUCH = 1e-9
"""World units. A ball nearer to a surface than this is drawn as touching it."""


def ball_marks(position: complex, radius: float, role: Role = Role.BALL) -> tuple[Mark, ...]:
    """A ball and its centre p."""
    return Disc(position, radius, role), PointMark(position, Role.PLAIN, label="p" if role is Role.BALL else "")


def ghost_marks(position: complex, radius: float, toggle: Toggle | None = None) -> tuple[Mark, ...]:
    """Where a ball was or will be."""
    return (Circle(position, radius, Role.GHOST, toggle, Stroke.DASHED),)


def ring_marks(ring: Ring, alive: Sequence[int] | None = None, nearest: int | None = None) -> tuple[Mark, ...]:
    """The sectors of a ring.

    alive: one entry per slot, 0 where it is empty; None for a full ring. nearest: the slot that stands out; None for all alike,
    -1 for none.
    """
    return tuple(
        [
            AnnularSector(
                ring.radius,
                ring.half_width,
                ring.angle(slot),
                ring.half_angle,
                Role.SECTOR if nearest is None or slot == nearest else Role.OTHER,
            )
            for slot in range(ring.count)
            if alive is None or alive[slot]
        ]
    )


def contact_marks(ball: Ball, found: Contact, length: float = 1.0) -> tuple[Mark, ...]:
    """The closest point, the gap and the normal of a contact; a ring around the contact point where the two touch.

    length: of the drawn normal, world units.
    """
    marks: list[Mark] = [PointMark(found.point, Role.OURS, Toggle.CLOSEST, "q")]
    surface = ball.position - found.normal * ball.radius
    marks.append(Line((found.point, surface), Role.OURS, Toggle.GAP, Stroke.THICK))
    marks.append(Arrow(found.point, found.normal * length, Role.OURS, Toggle.NORMALS, label="n"))
    if found.gap <= _TOUCH:
        marks.append(Circle(found.point, 0.12 * length, Role.OURS, Toggle.CONTACTS, Stroke.THICK))
    return tuple(marks)


def gap_words(gap: float) -> str:
    """A gap, and what it means below 0."""
    return f"gap = {gap:.3f}" if gap >= 0.0 else f"gap = {gap:.3f}: they overlap by {-gap:.3f}"


def outline_points(ring: Ring, samples: int) -> list[complex]:
    """Points of the outline of sector 0: so many more than one on each face and, unless the ring is closed, on each end."""
    shares = [2.0 * k / samples - 1.0 for k in range(samples + 1)]
    radii = (ring.inner_radius, ring.outer_radius)
    faces = [to_cartesian(radius, ring.phase + share * ring.half_angle) for radius in radii for share in shares]
    if ring.half_angle >= math.pi:
        return faces
    ends = [to_cartesian(1.0, ring.phase + side * ring.half_angle) for side in (-1.0, 1.0)]
    return faces + [end * (ring.radius + share * ring.half_width) for end in ends for share in shares]


def second_opinion(given: Given, ball: Ball, ring: Ring, slots: Sequence[int], ours: Contact | None) -> tuple[Mark, ...]:
    """The second engine's shapes, its normal at the ball, and the angle between it and ours; nothing without such an engine.

    slots: the sectors that it is asked about. ours: None where there is no normal to compare with.
    """
    engine = given.engine
    if engine is None:
        return ()
    marks: list[Mark] = []
    for shape in engine.shapes(ring, slots):
        if shape.radius > 0.0:
            marks.append(Circle(shape.a, shape.radius, Role.PYMUNK, Toggle.PYMUNK))
        elif shape.a == shape.b:
            marks.append(PointMark(shape.a, Role.PYMUNK, Toggle.PYMUNK))
        else:
            marks.append(Line((shape.a, shape.b), Role.PYMUNK, Toggle.PYMUNK))
    touch = engine.touch(ball, ring, slots)
    if touch is not None:
        start = ball.position - touch.normal * touch.distance
        text = f"{engine.name}: {angle_between(touch.normal, ours.normal)} from ours" if ours is not None else engine.name
        marks.append(Arrow(start, touch.normal * 1.6, Role.PYMUNK, Toggle.PYMUNK, Stroke.SOLID, text))
    return tuple(marks)


def angle_between(one: complex, other: complex) -> str:
    """The angle between two directions in degrees: two decimals, or the power of ten of what is smaller."""
    turn = one * other.conjugate()
    degrees = math.degrees(abs(math.atan2(turn.imag, turn.real)))
    return f"{degrees:.2f}°" if degrees >= 0.01 or degrees == 0.0 else f"{degrees:.0e}°"


def angle_arc(radius: float, start: float, sweep: float, role: Role, label: str) -> Arc:
    """An angle at the origin."""
    return Arc(0j, radius, start, sweep, role, label=label)


def ray(angle: float, reach: float, role: Role = Role.FAINT, label: str = "") -> Line:
    """A line from the origin in a direction."""
    return Line((0j, to_cartesian(reach, angle)), role, None, Stroke.DASHED, label)


def two_decimals(vector: complex) -> str:
    """A point or a vector: both coordinates with two decimals."""
    return f"({round(vector.real, 2) + 0.0:.2f}, {round(vector.imag, 2) + 0.0:.2f})"


def degrees(angle: float) -> str:
    """An angle, given in radians, in degrees with two decimals."""
    return f"{math.degrees(angle):.2f}°"


def is_unit(vector: complex) -> bool:
    """Whether a vector has length 1, but for rounding."""
    return abs(dot(vector, vector) - 1.0) < 1e-12
