"""Collision detection and response in polar coordinates, for balls among turning rings of annular sectors.

The plane is the complex plane, x to the right and y up; angles are radians, counter-clockwise; normals are unit vectors
from the obstacle to the ball. Pure functions over immutable values; imports nothing but `math` and itself.
"""

from physics.broad_phase import Outcome, broad_phase, broad_phase_outcome, has_left, in_band, nearest_slot
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
from physics.response import collision_response
from physics.shapes import Ball, Contact, Feature, Ring
from physics.step import PERMANENT, Arena, Hit, Step, advance
from physics.time_of_impact import Impact, time_of_impact
from physics.trig import angle_of, direction
from physics.vectors import cross, dot, length

PHYSICS_VERSION = 1
"""Changes whenever the same inputs could give other bits. A replay made by another version is refused."""

__all__ = [
    "PERMANENT",
    "PHYSICS_VERSION",
    "Arena",
    "Ball",
    "Contact",
    "Feature",
    "Hit",
    "Impact",
    "Outcome",
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
    "signed_difference",
    "subtract_angles",
    "time_of_impact",
    "to_cartesian",
    "to_polar",
]
