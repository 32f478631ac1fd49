"""A second physics engine, handed to the lab from outside: scenes show its answers beside ours.

Where the lab is opened without one, scenes get None and leave those answers out.
"""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from physics import Ball, Ring


class EngineContact(NamedTuple):
    """Where the other engine says that a ball and a ring are nearest.

    normal: unit, from the ring to the ball. distance: from the ball's centre to the shape, world units.
    """

    normal: complex
    distance: float


class EngineShape(NamedTuple):
    """One shape that the other engine makes a ring of: a segment from a to b, or a circle, where a = b is its centre.

    radius: of the circle, or how far the segment is rounded; 0 for a plain segment or point.
    """

    a: complex
    b: complex
    radius: float


class Engine(Protocol):
    """What a scene may ask."""

    name: str

    def touch(self, ball: Ball, ring: Ring, slots: Sequence[int]) -> EngineContact | None:
        """The contact with the shape nearest to the ball, of the sectors in these slots; None beyond two of its radii."""

    def shapes(self, ring: Ring, slots: Sequence[int]) -> tuple[EngineShape, ...]:
        """The shapes that it makes of the sectors in these slots."""

    def flight(self, ball: Ball, rings: Sequence[Ring], dt: float, ticks: int, facets: int = 24) -> tuple[complex, ...]:
        """The ball's position before the first tick and after each, by the engine's own stepping and its own bounces.

        dt: seconds in a tick. facets: chords that stand for an arc, where the engine has no arcs.
        """
