"""World to screen and back."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.camera import bearing, layout, unit_of

SIZES = st.tuples(st.integers(1, 8000), st.integers(1, 8000))
POINTS = st.complex_numbers(max_magnitude=20.0, allow_nan=False, allow_infinity=False)


@given(SIZES, POINTS)
def test_unproject_undoes_project(size, point):
    """Every point of the world comes back from its pixel."""
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
    """What is asked to stay free at the bottom is not part of the layout."""
    free = layout((800, 600), 10.0, below=100.0)
    assert free.size == (800, 500)
    assert free.camera.project(-10j).imag < 500.0


def test_a_square_window_has_bands_for_the_figures():
    """Where there is no room beside the arena there is some above and below."""
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
