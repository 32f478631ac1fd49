"""What exists: balls, rings of evenly spaced annular sectors, and an arena of both."""

import math
from collections.abc import Iterable
from enum import IntEnum
from typing import Any, NamedTuple, Self

from physics.polar import add_angles, normalize_angle, subtract_angles
from physics.tolerances import ANGLE_GRID, LARGEST, SMALLEST
from physics.trig import angle_of, on_angle_grid
from physics.vectors import length, quarter_turn

PERMANENT = -1
"""Layers of a sector that no hit removes."""

_TURN = math.tau

unchecked = tuple.__new__
"""`unchecked(Ball, (position, velocity, radius))` makes a value without its Python constructor.

Where a value is made of valid parts by a rule that keeps them valid, its checks would find nothing. A tick in free flight
makes four values and little else: through their constructors it would take almost twice as long.
"""


class _BallFields(NamedTuple):
    position: complex
    velocity: complex
    radius: float


class Ball(_BallFields):
    """A moving disc.

    Raises ValueError, naming the field, for what is out of its range or not finite; so does `_replace`.

    Attributes:
        position: its centre, world units, at most LARGEST (1e35) from the origin.
        velocity: world units per second, 0 or of a length from SMALLEST (1e-35) to LARGEST.
        radius: world units, from SMALLEST to LARGEST.
    """

    __slots__ = ()

    def __new__(cls, position: complex, velocity: complex, radius: float) -> Self:
        """Check every field."""
        if not length(position) <= LARGEST:
            raise ValueError(f"position must be finite and at most {LARGEST:g} from the origin, not {position}")
        if not (velocity == 0.0 or SMALLEST <= length(velocity) <= LARGEST):
            raise ValueError(f"velocity must be 0 or from {SMALLEST:g} to {LARGEST:g} long, not {velocity}")
        if not SMALLEST <= radius <= LARGEST:
            raise ValueError(f"radius must be from {SMALLEST:g} to {LARGEST:g}, not {radius}")
        return super().__new__(cls, complex(position), complex(velocity), float(radius))

    @classmethod
    def _make(cls, iterable: Iterable[Any]) -> Self:  # type: ignore[override]
        """A ball of its fields in order, checked: `_replace` comes here."""
        return cls(*iterable)

    def theta(self) -> float:
        """Angle of the centre, in [0, 2 pi); at the exact centre of the arena the angle in which the ball flies."""
        return angle_of(self.position if self.position != 0.0 else self.velocity)

    def moved(self, time: float) -> "Ball":
        """The ball after flying straight. time: seconds. Not checked: valid stays valid."""
        position, velocity, radius = self
        return unchecked(Ball, (position + velocity * time, velocity, radius))


class _RingFields(NamedTuple):
    radius: float
    half_width: float
    half_angle: float
    count: int  # type: ignore[assignment]  # the design's name hides tuple.count, which nothing needs
    phase: float
    spin: float
    friction: float


class Ring(_RingFields):
    """`count` equal annular sectors, evenly spaced, turning together: the paddles, or a ring of bricks.

    Slot k has its middle at the angle phase + k 2 pi / count. Raises ValueError, naming the field, for what is out of its
    range or not finite; so does `_replace`.

    Attributes:
        radius: of the ring's middle, world units, from SMALLEST (1e-35) to LARGEST (1e35); the source's r_p.
        half_width: radial, world units, from SMALLEST to below the radius; the source's w_p.
        half_angle: of one sector, radians, in (0, pi / count]; pi / count closes the ring; the source's phi_p.
        count: sectors, a whole number from 1 up.
        phase: middle angle of slot 0, radians, finite; stored in [0, 2 pi) on the angle grid.
        spin: rad/s, counter-clockwise, at most LARGEST; below SMALLEST it is stored as 0.
        friction: in [0, 1]; the source's mu_p.
    """

    __slots__ = ()

    def __new__(
        cls,
        radius: float,
        half_width: float,
        half_angle: float,
        count: int,
        phase: float = 0.0,
        spin: float = 0.0,
        friction: float = 0.0,
    ) -> Self:
        """Check every field, normalise the phase."""
        if not SMALLEST <= radius <= LARGEST:
            raise ValueError(f"radius must be from {SMALLEST:g} to {LARGEST:g}, not {radius}")
        if not SMALLEST <= half_width < radius:
            raise ValueError(f"half_width must be at least {SMALLEST:g} and below the radius {radius}, not {half_width}")
        if not (isinstance(count, int) and not isinstance(count, bool) and 1 <= count <= LARGEST):
            raise ValueError(f"count must be a whole number from 1 up, not {count}")
        widest = math.pi / count
        if not 0.0 < half_angle <= widest * (1.0 + 1e-12):
            raise ValueError(f"half_angle must lie in (0, pi/{count}] or sectors overlap, not be {half_angle}")
        if not math.isfinite(phase):
            raise ValueError(f"phase must be finite, not {phase}")
        if not 0.0 <= friction <= 1.0:
            raise ValueError(f"friction must lie in [0, 1], not be {friction}")
        half_angle = min(float(half_angle), widest)
        phase = normalize_angle(on_angle_grid(normalize_angle(phase)))
        return super().__new__(
            cls, float(radius), float(half_width), half_angle, count, phase, _checked_spin(spin), float(friction)
        )

    @classmethod
    def _make(cls, iterable: Iterable[Any]) -> Self:  # type: ignore[override]
        """A ring of its fields in order, checked: `_replace` comes here."""
        return cls(*iterable)

    @property
    def inner_radius(self) -> float:
        """Radius of the inner faces, world units."""
        return self.radius - self.half_width

    @property
    def outer_radius(self) -> float:
        """Radius of the outer faces, world units."""
        return self.radius + self.half_width

    def angle(self, slot: int) -> float:
        """Middle angle of a slot, in [0, 2 pi), on the angle grid; slot: 0 to count - 1.

        Slots in the second half are counted backwards: a mirrored ring (phase and slot negated) has mirrored angles.
        """
        if 2 * slot <= self.count:
            return add_angles(self.phase, slot / self.count * math.tau)
        return subtract_angles(self.phase, (self.count - slot) / self.count * math.tau)

    def turned(self, time: float) -> "Ring":
        """The ring after turning. time: seconds. Not checked: valid stays valid."""
        radius, half_width, half_angle, count, phase, spin, friction = self
        turn = spin * time
        # Between 4 and 8 floats are the grid itself. The turn is rounded, not the sum: then every sum is exact.
        turn = (turn + 6.0) - 6.0 if -2.0 < turn < 2.0 else _long_turn(turn)
        there = phase + turn
        if there < 0.0:
            there += _TURN
        elif there >= _TURN:
            there = (phase - _TURN) + turn
        return unchecked(Ring, (radius, half_width, half_angle, count, there, spin, friction))

    def steered(self, spin: float) -> "Ring":
        """The ring with another spin, in rad/s; ValueError unless it is finite and at most LARGEST."""
        radius, half_width, half_angle, count, phase, _, friction = self
        return unchecked(Ring, (radius, half_width, half_angle, count, phase, _checked_spin(spin), friction))

    def surface_velocity(self, point: complex) -> complex:
        """Velocity of the ring's material at a point, world units per second: spin x point; the source's v_p."""
        return quarter_turn(point) * self.spin


class Arena(NamedTuple):
    """Everything that moves or can be hit.

    Attributes:
        balls: any number.
        rings: any number; no two may overlap.
        layers: for every ring, for every slot, how many bricks are stacked there; 0 empty, PERMANENT unbreakable.
    """

    balls: tuple[Ball, ...]
    rings: tuple[Ring, ...]
    layers: tuple[tuple[int, ...], ...]


class Feature(IntEnum):
    """The part of a sector that a contact is on.

    Attributes:
        OUTER_FACE: the arc of the outer radius; the normal points away from the centre.
        INNER_FACE: the arc of the inner radius; the normal points to the centre.
        END: one of the two straight sides; the normal is at a right angle to it.
        CORNER: where an arc and a straight side meet; the normal points from there to the ball's centre.
    """

    OUTER_FACE = 0
    INNER_FACE = 1
    END = 2
    CORNER = 3


class Contact(NamedTuple):
    """Where a ball and a sector are nearest.

    Attributes:
        normal: unit vector, from the sector towards the ball.
        point: x + iy on the sector's surface, world units from the arena's centre.
        gap: between the two, world units; > 0 apart, 0 touching, < 0 overlapping by -gap.
        feature: the part of the sector: `Feature.OUTER_FACE`, `INNER_FACE`, `END` or `CORNER`.
    """

    normal: complex
    point: complex
    gap: float
    feature: Feature


def _checked_spin(spin: float) -> float:
    """A spin as it is stored."""
    if not abs(spin) <= LARGEST:
        raise ValueError(f"spin must be finite and at most {LARGEST:g}, not {spin}")
    return float(spin) if abs(spin) >= SMALLEST else 0.0


def _long_turn(turn: float) -> float:
    """A turn of more than 2 radians less its whole revolutions, on the angle grid; the negated turn has the negated one."""
    rest = round(abs(turn) % math.tau * ANGLE_GRID) / ANGLE_GRID
    return rest if turn > 0.0 else -rest
