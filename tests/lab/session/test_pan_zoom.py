"""Which part of the world the lab shows: dragged, zoomed about a pixel, widened to show what is far."""

import math

import pygame
from hypothesis import given
from hypothesis import strategies as st

from game.lab.kit.scene import ViewBox
from game.lab.session.pan_zoom import PanZoom
from tests.support.strategies import points, reals

BOX = ViewBox(1 + 2j, 4 + 3j)
AREA = pygame.Rect(30, 40, 500, 400)


def pans_and_zooms():
    """Any pan and zoom that drags and the wheel can make."""
    return st.builds(PanZoom, points(8.0), reals(0.2, 20.0))


def pixels():
    """Pixels of the area."""
    return st.builds(complex, reals(30.0, 530.0), reals(40.0, 440.0))


@given(pans_and_zooms(), pixels(), reals(-3.0, 3.0))
def test_what_is_under_the_pointer_stays_there(pan_zoom, pixel, steps):
    """The point of the world under the pointer stays there while the wheel zooms."""
    camera = pan_zoom.camera(BOX, AREA)
    after = pan_zoom.zoomed(BOX, AREA, pixel, steps)
    assert abs(after.camera(BOX, AREA).project(camera.unproject(pixel)) - pixel) < 1e-6


@given(pans_and_zooms(), st.builds(complex, reals(-300.0, 300.0), reals(-300.0, 300.0)), points(5.0))
def test_what_is_dragged_stays_under_the_pointer(pan_zoom, offset, point):
    """Every point moves by as many pixels as the pointer, unless the farthest pan is reached."""
    camera = pan_zoom.camera(BOX, AREA)
    after = pan_zoom.dragged(camera, offset)
    moved = after.camera(BOX, AREA).project(point) - camera.project(point)
    assert abs(moved - offset) < 1e-6 or abs(after.pan) >= 50.0 - 1e-9


@given(st.lists(st.tuples(pixels(), reals(-1e6, 1e6), st.builds(complex, reals(-1e4, 1e4), reals(-1e4, 1e4))), max_size=30))
def test_the_world_stays_in_reach(moves):
    """After any drags and turns of the wheel the pan is bounded and the zoom is finite."""
    pan_zoom = PanZoom()
    for pixel, steps, offset in moves:
        pan_zoom = pan_zoom.zoomed(BOX, AREA, pixel, steps)
        pan_zoom = pan_zoom.dragged(pan_zoom.camera(BOX, AREA), offset)
        assert abs(pan_zoom.pan) <= 50.0 * (1.0 + 1e-12)
        assert 0.0 < pan_zoom.zoom < math.inf


@given(st.lists(points(30.0), max_size=5))
def test_the_whole_scene_shows_every_handle(positions):
    """What is shown contains the view box and every position, and is the view box where that contains them already."""
    pan_zoom = PanZoom.showing(BOX, positions)
    camera = pan_zoom.camera(BOX, AREA)
    for point in [*positions, BOX.centre + BOX.half, BOX.centre - BOX.half]:
        pixel = camera.project(point)
        assert AREA.left - 1e-6 <= pixel.real <= AREA.right + 1e-6
        assert AREA.top - 1e-6 <= pixel.imag <= AREA.bottom + 1e-6
    near = [BOX.centre + complex(point.real / 30.0 * 4.0, point.imag / 30.0 * 3.0) * 0.87 for point in positions]
    assert PanZoom.showing(BOX, near) == PanZoom()
