"""The lab's view: dragged, zoomed about a pixel, widened to show what is far."""

import math

import pygame
from hypothesis import given
from hypothesis import strategies as st

from game.lab.kit.scene import ViewBox
from game.lab.window.pan_zoom import PanZoom
from tests.support.strategies import points, reals

BOX = ViewBox(1 + 2j, 4 + 3j)
AREA = pygame.Rect(30, 40, 500, 400)


def lenses():
    """Any view that hands can make."""
    return st.builds(PanZoom, points(8.0), reals(0.2, 20.0))


def pixels():
    """Places in the area."""
    return st.builds(complex, reals(30.0, 530.0), reals(40.0, 440.0))


@given(lenses(), pixels(), reals(-3.0, 3.0))
def test_what_is_under_the_pointer_stays_there(pan_zoom, pixel, steps):
    """However one zooms."""
    camera = pan_zoom.camera(BOX, AREA)
    after = pan_zoom.zoomed(camera, BOX, AREA, pixel, steps)
    assert abs(after.camera(BOX, AREA).project(camera.unproject(pixel)) - pixel) < 1e-6


@given(lenses(), st.builds(complex, reals(-300.0, 300.0), reals(-300.0, 300.0)), points(5.0))
def test_what_is_dragged_stays_under_the_hand(pan_zoom, way, place):
    """Every place moves by as many pixels, unless the world's border is reached."""
    camera = pan_zoom.camera(BOX, AREA)
    after = pan_zoom.dragged(camera, way)
    moved = after.camera(BOX, AREA).project(place) - camera.project(place)
    assert abs(moved - way) < 1e-6 or abs(after.pan) >= 50.0 - 1e-9


@given(st.lists(st.tuples(pixels(), reals(-1e6, 1e6), st.builds(complex, reals(-1e4, 1e4), reals(-1e4, 1e4))), max_size=30))
def test_no_hand_gets_lost(moves):
    """After any drags and turns of the wheel the view is finite and not far away."""
    pan_zoom = PanZoom()
    for pixel, steps, way in moves:
        pan_zoom = pan_zoom.zoomed(pan_zoom.camera(BOX, AREA), BOX, AREA, pixel, steps)
        pan_zoom = pan_zoom.dragged(pan_zoom.camera(BOX, AREA), way)
        assert abs(pan_zoom.pan) <= 50.0 * (1.0 + 1e-12)
        assert 0.0 < pan_zoom.zoom < math.inf


@given(st.lists(points(30.0), max_size=5))
def test_the_whole_view_shows_every_handle(places):
    """And is the scene's own where that shows them already."""
    pan_zoom = PanZoom.showing(BOX, places)
    camera = pan_zoom.camera(BOX, AREA)
    for place in [*places, BOX.centre + BOX.half, BOX.centre - BOX.half]:
        spot = camera.project(place)
        assert AREA.left - 1e-6 <= spot.real <= AREA.right + 1e-6
        assert AREA.top - 1e-6 <= spot.imag <= AREA.bottom + 1e-6
    near = [BOX.centre + complex(place.real / 30.0 * 4.0, place.imag / 30.0 * 3.0) * 0.87 for place in places]
    assert PanZoom.showing(BOX, near) == PanZoom()
