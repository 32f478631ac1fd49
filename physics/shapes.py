"""The two things that exist: balls, and rings of evenly spaced annular sectors."""

import math
from enum import IntEnum
from typing import NamedTuple, Self

from physics.polar import add_angles, normalize_angle, signed_difference
from physics.tolerances import ANGLE_GRID, LARGEST
from physics.vectors import length, quarter_turn

_TURN = math.tau
_new = tuple.__new__  # a NamedTuple without its Python constructor


class _BallFields(NamedTuple):
    position: complex
    velocity: complex
    radius: float


class Ball(_BallFields):
    """A moving disc.

    position: centre, world units. velocity: units per second. radius: > 0.
    Raises ValueError, naming the field, for what is not finite, beyond 1e100, or a radius <= 0.
    """

    __slots__ = ()

    def __new__(cls, position: complex, velocity: complex, radius: float) -> Self:
        """Check every field."""
        if not length(position) <= LARGEST:
            raise ValueError(f"position must be finite and at most {LARGEST:g} from the origin, not {position}")
        if not length(velocity) <= LARGEST:
            raise ValueError(f"velocity must be finite and at most {LARGEST:g}, not {velocity}")
        if not 0.0 < radius <= LARGEST:
            raise ValueError(f"radius must be finite and above 0, not {radius}")
        return super().__new__(cls, complex(position), complex(velocity), float(radius))

    def moved(self, time: float) -> Self:
        """The ball after flying straight for some seconds. Not checked: valid stays valid."""
        position, velocity, radius = self
        return tuple.__new__(type(self), (position + velocity * time, velocity, radius))


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

    radius: of the ring's middle, world units. half_width: radial, in (0, radius). half_angle: of one sector, radians, in
    (0, pi / count]; pi / count closes the ring. phase: middle angle of slot 0, stored in [0, 2 pi). spin: rad/s.
    friction: the source's mu, in [0, 1]. Slot k has its middle at phase + k 2 pi / count.
    Raises ValueError, naming the field.
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
        if not 0.0 < radius <= LARGEST:
            raise ValueError(f"radius must be finite and above 0, not {radius}")
        if not 0.0 < half_width < radius:
            raise ValueError(f"half_width must lie between 0 and the radius {radius}, not be {half_width}")
        if not (isinstance(count, int) and not isinstance(count, bool) and 1 <= count <= LARGEST):
            raise ValueError(f"count must be a whole number from 1 up, not {count}")
        widest = math.pi / count
        if not 0.0 < half_angle <= widest * (1.0 + 1e-12):
            raise ValueError(f"half_angle must lie in (0, pi/{count}] or sectors overlap, not be {half_angle}")
        if not math.isfinite(phase):
            raise ValueError(f"phase must be finite, not {phase}")
        if not abs(spin) <= LARGEST:
            raise ValueError(f"spin must be finite and at most {LARGEST:g}, not {spin}")
        if not 0.0 <= friction <= 1.0:
            raise ValueError(f"friction must lie in [0, 1], not be {friction}")
        half_angle = min(float(half_angle), widest)
        return super().__new__(
            cls, float(radius), float(half_width), half_angle, count, _on_grid(phase), float(spin), float(friction)
        )

    @property
    def inner_radius(self) -> float:
        """Radius of the inner faces."""
        return self.radius - self.half_width

    @property
    def outer_radius(self) -> float:
        """Radius of the outer faces."""
        return self.radius + self.half_width

    def angle(self, slot: int) -> float:
        """Middle angle of a slot, in [0, 2 pi)."""
        return add_angles(self.phase, slot * (math.tau / self.count))

    def angle_near(self, slot: int, bearing: float) -> float:
        """Middle angle of a slot, not folded to [0, 2 pi) but within half a turn of a bearing.

        A mirrored ring (phase and slot negated) has exactly the negated angle near the negated bearing: folding a small
        negative angle to near 2 pi would cost it its last bits.
        """
        pitch = math.tau / self.count
        phase = signed_difference(self.phase, 0.0)
        turns = round((phase + slot * pitch - bearing) / math.tau)
        return phase + (slot - turns * self.count) * pitch

    def turned(self, time: float) -> "Ring":
        """The ring after turning for some seconds. Not checked: valid stays valid."""
        radius, half_width, half_angle, count, phase, spin, friction = self
        turn = spin * time
        # Between 4 and 8 floats are the grid itself. The turn is rounded, not the sum: then every sum is exact.
        turn = (turn + 6.0) - 6.0 if -2.0 < turn < 2.0 else round(math.fmod(turn, math.tau) * ANGLE_GRID) / ANGLE_GRID
        there = phase + turn
        if not 0.0 <= there < _TURN:
            there = there + _TURN if there < 0.0 else (phase - _TURN) + turn
        return _new(Ring, (radius, half_width, half_angle, count, there, spin, friction))

    def surface_velocity(self, point: complex) -> complex:
        """Velocity of the ring's material at a point: spin x point."""
        return quarter_turn(point) * self.spin


class Feature(IntEnum):
    """The part of a sector that a contact is on."""

    OUTER_FACE = 0
    INNER_FACE = 1
    END = 2
    CORNER = 3


class Contact(NamedTuple):
    """Where a ball and a sector are nearest."""

    normal: complex  # unit, from the sector towards the ball
    point: complex  # on the sector's surface
    gap: float  # > 0 apart, 0 touching, < 0 overlapping by -gap
    feature: Feature


def _on_grid(phase: float) -> float:
    """The phase in [0, 2 pi), rounded to a grid on which negation is exact."""
    return normalize_angle(round(phase % math.tau * ANGLE_GRID) / ANGLE_GRID)
