"""World to screen and back."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.drawing.camera import Camera, bearing, layout, unit_of
from game.input.hands import Hands
from game.input.keys import Action
from game.input.signals import Dragged, FocusLost, KeyboardState, Pointed, Pressed, Released, Zoomed
from game.input.view import FLAT, LEAST_TILT, LEAST_ZOOM, MOST_TILT, MOST_ZOOM, SOLID, Viewpoint
from game.levels import classic
from game.rules import POINTER_STEPS, new_game

SIZES = st.tuples(st.integers(1, 8000), st.integers(1, 8000))
POINTS = st.complex_numbers(max_magnitude=20.0, allow_nan=False, allow_infinity=False)


@given(SIZES, POINTS)
def test_unproject_undoes_project(size, point):
    """Unprojecting the pixel of a point of the world gives the point."""
    camera = layout(size, 10.0).camera
    assert camera.unproject(camera.project(point)) == pytest.approx(point, abs=1e-6)


@given(st.tuples(st.integers(64, 8000), st.integers(64, 8000)), st.floats(1.0, 1000.0), st.floats(0.0, 2.0 * math.pi))
def test_the_arena_lies_on_the_surface(size, radius, angle):
    """Every point of the rim is on the surface, whatever its shape."""
    pixel = layout(size, radius).camera.project(radius * complex(math.cos(angle), math.sin(angle)))
    assert 0.0 <= pixel.real <= size[0]
    assert 0.0 <= pixel.imag <= size[1]


def test_up_in_the_world_is_up_on_the_screen():
    """The screen's y grows downwards, the world's upwards."""
    camera = layout((800, 600), 10.0).camera
    assert camera.project(5j).imag < camera.project(0j).imag
    assert camera.project(5 + 0j).real > camera.project(0j).real


def test_room_below_is_left_free():
    """The arena and the figures keep away from the pixels at the bottom that are asked to stay free."""
    free = layout((800, 600), 10.0, below=100.0)
    assert free.size == (800, 500)
    assert free.camera.project(-10j).imag < 500.0


def test_a_square_window_has_bands_for_the_figures():
    """In a square window the arena leaves bands above and below; in a wide one the figures stand beside it."""
    assert layout((800, 600), 10.0).beside
    square = layout((800, 800), 10.0)
    assert not square.beside
    assert square.camera.project(10j).imag > 2.0 * unit_of((800, 800))


def test_bearing_of_the_pointer():
    """The pointer's bearing is counter-clockwise from the right; on the centre it has none."""
    camera = layout((800, 600), 10.0).camera
    assert bearing(camera, camera.project(0.0 + 3j)) == pytest.approx(math.pi / 2.0)
    assert bearing(camera, camera.project(-2.0 + 2j)) == pytest.approx(0.75 * math.pi)
    assert bearing(camera, camera.centre + 1.0) is None


@given(
    st.tuples(st.floats(-math.pi, math.pi), st.floats(0.0, 1.3), st.floats(0.0, 0.034)),
    st.complex_numbers(max_magnitude=12.0, allow_nan=False, allow_infinity=False),
)
def test_unproject_undoes_project_on_the_ground_of_a_tipped_camera(pose, point):
    """Unprojecting the pixel of a point of the ground gives the point, however the camera is turned, tipped and near."""
    camera = Camera(400 + 300j, 30.0, *pose)
    assert camera.unproject(camera.project(point)) == pytest.approx(point, abs=1e-6)


@given(SIZES, POINTS, st.floats(0.0, 3.0))
def test_upright_the_tipped_camera_is_the_flat_one(size, point, height):
    """With no tilt, azimuth and perspective a point's pixel is the top-down camera's, whatever its height."""
    camera = layout(size, 10.0).camera
    turned = np.array([point * camera.turning])
    assert camera.project(point, height) == camera.project(point)
    assert complex(camera.projected(turned, height)[0]) == pytest.approx(camera.project(point), abs=1e-6)


@given(st.tuples(st.floats(-3.0, 3.0), st.floats(0.0, 1.3), st.floats(0.0, 0.034)), POINTS, st.floats(0.0, 3.0))
def test_one_point_and_many_are_projected_alike(pose, point, height):
    """`projected` and `project` are the same projection."""
    camera = Camera(400 + 300j, 30.0, *pose)
    many = camera.projected(np.array([point * camera.turning]), height)
    assert complex(many[0]) == pytest.approx(camera.project(point, height), abs=1e-6)


@pytest.mark.parametrize("tilt", [0.3, 0.9, 1.3])
def test_a_pixel_beyond_the_horizon_still_has_a_bearing(tilt):
    """A pixel straight up above the horizon has the bearing straight away from the eye."""
    camera = Camera(400 + 300j, 30.0, 0.5, tilt, 0.034)
    assert bearing(camera, 400 - 1e6j) == pytest.approx(0.5 + math.pi / 2.0)


def test_the_way_from_one_view_to_the_other_has_no_jumps():
    """A point moves by a few pixels a frame while the camera tips, and after tipping back it is where it was."""
    flat, view = layout((1280, 800), 10.0), FLAT.after(Pressed(Action.TIP), 20.0)
    pixels = [flat.camera.project(6 + 5j)]
    while view.tipped < 1.0:
        view = view.later(1.0 / 60.0)
        pixels.append(view.seen(flat).camera.project(6 + 5j, 0.5))
    assert len(pixels) > 30
    assert max(abs(after - before) for before, after in pairwise(pixels)) < 12.0
    view = view.after(Pressed(Action.FLAT), 20.0).later(10.0)
    assert view.seen(flat).camera == flat.camera


def test_players_who_want_no_motion_get_a_cut():
    """Without smooth motion the camera is tipped in the next frame."""
    assert FLAT.after(Pressed(Action.SOLID), 20.0).later(0.0, smooth=False).tipped == 1.0


def test_dragging_and_zooming_stay_within_bounds():
    """Tilt and zoom stay within their bounds however far the mouse goes, and seen from above a drag turns nothing."""
    view = SOLID
    for drag in (1e5 + 1e5j, -3e5 - 2e5j):
        view = view.after(Dragged(drag), 20.0).after(Zoomed(drag.real), 20.0)
        assert math.radians(10.0) < view.tilt < math.radians(80.0)
        assert 0.5 < view.zoom < 4.0
        assert abs(view.azimuth) <= math.pi
    assert FLAT.after(Dragged(50 + 0j), 20.0).after(Zoomed(2.0), 20.0) == FLAT


def test_keys_and_the_right_stick_move_the_camera_as_long_as_they_are_held():
    """A quarter of a turn takes the same time at any frame rate; up and nearer; nothing from above, or once let go."""
    key = Pressed(Action.ORBIT_RIGHT, 27)
    once, often = SOLID.after(key, 20.0).later(0.4), SOLID.after(key, 20.0)
    for _ in range(40):
        often = often.later(0.01)
    assert once.azimuth == pytest.approx(often.azimuth)
    assert once.azimuth == pytest.approx(SOLID.after(Pointed(1 + 0j, aims=True), 20.0).later(0.4).azimuth)
    assert once.azimuth > SOLID.azimuth
    assert SOLID.after(Dragged(-20 + 0j), 20.0).azimuth > SOLID.azimuth
    up = SOLID.after(Pointed(1j, aims=True), 20.0).later(0.2)
    assert up.tilt < SOLID.tilt
    assert SOLID.after(Pressed(Action.ZOOM_IN), 20.0).later(0.2).zoom > SOLID.zoom
    for ended in (Released(Action.ORBIT_RIGHT, 27), KeyboardState(frozenset()), FocusLost()):
        assert once.after(ended, 20.0).later(1.0).azimuth == once.azimuth
    assert FLAT.after(key, 20.0).later(1.0).azimuth == 0.0


@pytest.mark.parametrize("tilt", [0.2, 0.9, 1.3])
@pytest.mark.parametrize("size", [(800, 600), (1280, 800), (600, 900), (3840, 2160)])
def test_the_tipped_arena_lies_on_the_surface(size, tilt):
    """Every point of the rim is on the surface, from every side."""
    camera = SOLID._replace(tilt=tilt, azimuth=0.7).seen(layout(size, 10.0)).camera
    for angle in np.linspace(0.0, math.tau, 90):
        pixel = camera.project(10.0 * complex(math.cos(angle), math.sin(angle)))
        assert 0.0 <= pixel.real <= size[0]
        assert 0.0 <= pixel.imag <= size[1]


@pytest.mark.parametrize("zoom", [LEAST_ZOOM, 1.0, MOST_ZOOM])
@pytest.mark.parametrize("tilt", [LEAST_TILT, 0.9, MOST_TILT])
def test_the_wall_stays_in_sight(tilt, zoom):
    """However near the camera is, the arena's centre is in the middle of the surface, a seventh of its height up or down."""
    for azimuth in (0.0, 2.0, -2.0):
        camera = Viewpoint(1.0, 1.0, azimuth, tilt, zoom).seen(layout((1280, 800), 10.0)).camera
        assert abs(camera.project(0j) - (640 + 400j)) < 800.0 / 7.0


@pytest.mark.parametrize("azimuth", np.linspace(-math.pi, math.pi, 9))
@pytest.mark.parametrize("tilt", [LEAST_TILT, 0.9, MOST_TILT])
def test_the_mouse_aims_at_paddles_from_every_side(azimuth, tilt):
    """The bearing of a pixel on the track is that of the point below it; of one on a paddle's top it is nearly the same."""
    camera, game = Viewpoint(1.0, 1.0, azimuth, tilt, 1.2).seen(layout((1280, 800), 10.0)).camera, new_game(classic(), 1)
    for angle in np.linspace(0.0, math.tau, 24, endpoint=False):
        point = 9.2 * complex(math.cos(angle), math.sin(angle))
        for height, most in ((0.0, 0.001), (0.3, 0.15)):
            steps = Hands(pointer=camera.project(point, height)).controls(camera, game).pointer
            assert abs(math.remainder(steps / POINTER_STEPS * math.tau - angle, math.tau)) < most
