"""Collision detection and response in polar coordinates, for balls among turning rings of annular sectors.

After the lecture "Collision detection and response in the assignment" by Marek Trtík, PA199, Masaryk University ("the
source"). Its functions are here under their own names, and they are the ones that run: a moving ball's first touch is
searched for in time, and at that moment the source's functions say what is touched and how the ball leaves. One is not needed
for that, the search over a list, `broad_phase`: `nearest_slot` finds the same sector by arithmetic.

The plane is the complex plane, x to the right and y up. Angles are radians, counter-clockwise; a normalised angle is in
[0, 2 pi). Lengths are world units, times seconds. Normals are unit vectors from the obstacle to the ball; a gap is > 0
apart, 0 touching, < 0 overlapping. Everything is a pure function of immutable values, and needs only the standard library.

    >>> paddles = Ring(radius=9.0, half_width=0.2, half_angle=0.4, count=3, spin=0.5)
    >>> impact = time_of_impact(Ball(position=7 + 0j, velocity=8 + 1j, radius=0.25), paddles, dt=1.0)
    >>> impact.slot, impact.contact.feature.name, round(impact.time, 3)
    (0, 'INNER_FACE', 0.193)
"""

from physics.broad_phase import Outcome, broad_phase, broad_phase_outcome, has_left, in_band, nearest_slot
from physics.free_flight import FreeFlight
from physics.narrow_phase import closest_point_on_line, contact, narrow_phase_case_1, narrow_phase_case_2
from physics.polar import (
    add_angles,
    min_difference,
    normalize_angle,
    on_left,
    signed_difference,
    subtract_angles,
    to_cartesian,
    to_polar,
)
from physics.response import Response, collision_response, response_steps
from physics.shapes import PERMANENT, Arena, Ball, Contact, Feature, Ring
from physics.step import Hit, Step, advance
from physics.time_of_impact import Impact, time_of_impact
from physics.trig import angle_of, direction
from physics.vectors import cross, dot, length

PHYSICS_VERSION = 2
"""Changes whenever the same inputs could give other bits. A replay made by another version is refused."""

__all__ = [
    "PERMANENT",
    "PHYSICS_VERSION",
    "Arena",
    "Ball",
    "Contact",
    "Feature",
    "FreeFlight",
    "Hit",
    "Impact",
    "Outcome",
    "Response",
    "Ring",
    "Step",
    "add_angles",
    "advance",
    "angle_of",
    "broad_phase",
    "broad_phase_outcome",
    "closest_point_on_line",
    "collision_response",
    "contact",
    "cross",
    "direction",
    "dot",
    "has_left",
    "in_band",
    "length",
    "min_difference",
    "narrow_phase_case_1",
    "narrow_phase_case_2",
    "nearest_slot",
    "normalize_angle",
    "on_left",
    "response_steps",
    "signed_difference",
    "subtract_angles",
    "time_of_impact",
    "to_cartesian",
    "to_polar",
]
