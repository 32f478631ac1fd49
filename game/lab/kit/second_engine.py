"""Another engine, handed to the lab from outside: scenes ask it for a second opinion and do without it where there is none."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from physics import Ball, Ring


class Touch(NamedTuple):
    """Where another engine says that a ball and a ring are nearest."""

    normal: complex  # unit, from the ring to the ball
    distance: float  # from the ball's centre to the shape


class Piece(NamedTuple):
    """One shape that the other engine makes a ring of: a segment, or a circle where both ends are its centre."""

    a: complex
    b: complex
    radius: float


class Engine(Protocol):
    """What a scene may ask."""

    name: str

    def touch(self, ball: Ball, ring: Ring, slots: Sequence[int]) -> Touch | None:
        """The shape nearest to the ball, of the sectors in these slots; None where nothing is within two radii."""

    def pieces(self, ring: Ring, slots: Sequence[int]) -> tuple[Piece, ...]:
        """The shapes that it makes of the sectors in these slots."""

    def flight(self, ball: Ball, rings: Sequence[Ring], dt: float, ticks: int, facets: int = 24) -> tuple[complex, ...]:
        """The ball's place before the first tick and after each, by the engine's own stepping and its own bounces.

        facets: chords that stand for an arc, where the engine has no arcs.
        """
