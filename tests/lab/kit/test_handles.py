"""The lab's handles: dragged to a point, the values are those that put the handle there."""

import cmath
import math

import pytest
from hypothesis import assume, given

from game.lab.kit import handles
from game.lab.kit.handles import dragged
from game.lab.kit.parameters import Given, Number, Point
from tests.support.strategies import points, reals

SECTOR = (
    Number("radius", "r_p", "", 1.0, 20.0, 10.0, 1e-9),
    Number("angle", "θ_p", "°", 0.0, 360.0, 0.0, 1e-9),
    Number("half_width", "w_p", "", 0.01, 5.0, 1.0, 1e-9),
    Number("half_angle", "φ_p", "°", 0.0, 180.0, 20.0, 1e-9),
)
MIDDLE, LEFT, RIGHT, FACE = handles.sector_handles("radius", "half_width", "angle", "half_angle")


def sector(angle, half_angle=20.0):
    """The values of a sector."""
    return Given({"radius": 10.0, "angle": angle, "half_width": 1.0, "half_angle": half_angle})


@given(reals(0.0, 359.0), reals(2.0, 18.0), reals(0.0, 359.0))
def test_the_body_goes_where_the_pointer_goes(angle, radius, bearing):
    """The dragged sector's middle is at the pointer; its half width and half angle do not change."""
    target = cmath.rect(radius, math.radians(bearing))
    after = dragged(SECTOR, sector(angle), MIDDLE, target).given
    assert abs(MIDDLE.position(after) - target) < 1e-6
    assert (after.number("half_width"), after.number("half_angle")) == (1.0, 20.0)


@given(reals(0.0, 359.0), reals(5.0, 175.0), reals(-4.0, 4.0), reals(5.0, 15.0))
def test_an_end_turns_to_the_pointers_bearing(angle, half_angle, more, distance):
    """Either end turns to the pointer's bearing on its own side, also for half angles beyond a right angle."""
    for handle, side in ((LEFT, 1.0), (RIGHT, -1.0)):
        bearing = math.radians(angle + side * (half_angle + more))
        after = dragged(SECTOR, sector(angle, half_angle), handle, cmath.rect(distance, bearing)).given
        assert abs(after.number("half_angle") - (half_angle + more)) < 1e-6
        assert after.number("angle") == angle


@given(reals(0.0, 359.0), reals(0.1, 4.0), reals(-30.0, 30.0))
def test_the_outer_face_goes_out_and_in(angle, half_width, aside):
    """The outer face moves to the pointer's distance from the centre, whatever its bearing."""
    target = cmath.rect(10.0 + half_width, math.radians(angle + aside))
    after = dragged(SECTOR, sector(angle), FACE, target).given
    assert abs(after.number("half_width") - half_width) < 1e-6


@given(points(), points())
def test_the_tip_of_a_vector(start, offset):
    """A vector given by coordinates or by length and angle ends at the pointer."""
    parameters = (
        Point("v", "v", -100.0, 100.0, 0j, 1e-9),
        Number("length", "v_0", "", 0.0, 100.0, 1.0, 1e-9),
        Number("heading", "ψ", "°", 0.0, 360.0, 0.0, 1e-9),
    )
    assume(abs(offset) > 1e-3)
    before = Given({"v": 1 + 1j, "length": 1.0, "heading": 0.0})
    for handle in (
        handles.vector("v", lambda _: start, 0.5, "v"),
        handles.polar_vector("length", "heading", lambda _: start, 0.5, "v"),
    ):
        after = dragged(parameters, before, handle, start + offset).given
        assert abs(handle.position(after) - start - offset) < 1e-6


@pytest.mark.parametrize("handle", [MIDDLE, LEFT, RIGHT, FACE])
def test_a_drag_to_the_centre_leaves_the_angle(handle):
    """The centre has no bearing: a drag to it leaves the sector's angle as it was."""
    after = dragged(SECTOR, sector(77.0), handle, 0j).given
    assert after.number("angle") == 77.0
