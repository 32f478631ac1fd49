"""The lab's view: dragged, zoomed about a pixel, widened to show what is far."""

import math

import pygame
from hypothesis import given
from hypothesis import strategies as st

from game.lab.kit.scene import View
from game.lab.window.lens import Lens
from tests.support.strategies import points, reals

VIEW = View(1 + 2j, 4 + 3j)
AREA = pygame.Rect(30, 40, 500, 400)


def lenses():
    """Any view that hands can make."""
    return st.builds(Lens, points(8.0), reals(0.2, 20.0))


def pixels():
    """Places in the area."""
    return st.builds(complex, reals(30.0, 530.0), reals(40.0, 440.0))


@given(lenses(), pixels(), reals(-3.0, 3.0))
def test_what_is_under_the_pointer_stays_there(lens, pixel, steps):
    """However one zooms."""
    camera = lens.camera(VIEW, AREA)
    after = lens.zoomed(camera, VIEW, AREA, pixel, steps)
    assert abs(after.camera(VIEW, AREA).project(camera.unproject(pixel)) - pixel) < 1e-6


@given(lenses(), st.builds(complex, reals(-300.0, 300.0), reals(-300.0, 300.0)), points(5.0))
def test_what_is_dragged_stays_under_the_hand(lens, way, place):
    """Every place moves by as many pixels, unless the world's border is reached."""
    camera = lens.camera(VIEW, AREA)
    after = lens.dragged(camera, way)
    moved = after.camera(VIEW, AREA).project(place) - camera.project(place)
    assert abs(moved - way) < 1e-6 or abs(after.aside) >= 50.0 - 1e-9


@given(st.lists(st.tuples(pixels(), reals(-1e6, 1e6), st.builds(complex, reals(-1e4, 1e4), reals(-1e4, 1e4))), max_size=30))
def test_no_hand_gets_lost(moves):
    """After any drags and turns of the wheel the view is finite and not far away."""
    lens = Lens()
    for pixel, steps, way in moves:
        lens = lens.zoomed(lens.camera(VIEW, AREA), VIEW, AREA, pixel, steps)
        lens = lens.dragged(lens.camera(VIEW, AREA), way)
        assert abs(lens.aside) <= 50.0 * (1.0 + 1e-12)
        assert 0.0 < lens.zoom < math.inf


@given(st.lists(points(30.0), max_size=5))
def test_the_whole_view_shows_every_handle(places):
    """And is the scene's own where that shows them already."""
    lens = Lens.showing(VIEW, places)
    camera = lens.camera(VIEW, AREA)
    for place in [*places, VIEW.centre + VIEW.half, VIEW.centre - VIEW.half]:
        spot = camera.project(place)
        assert AREA.left - 1e-6 <= spot.real <= AREA.right + 1e-6
        assert AREA.top - 1e-6 <= spot.imag <= AREA.bottom + 1e-6
    near = [VIEW.centre + complex(place.real / 30.0 * 4.0, place.imag / 30.0 * 3.0) * 0.87 for place in places]
    assert Lens.showing(VIEW, near) == Lens()
