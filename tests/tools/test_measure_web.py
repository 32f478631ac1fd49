"""How the measurement of the page counts."""

import pytest

from tools.measure.web import new_pictures, shown_by

FRAMES = [0.0, 16.0, 33.0, 50.0]


@pytest.mark.parametrize(
    ("pressed", "painted", "number"),
    [(1.0, 9.0, 1), (15.9, 16.1, 2), (15.9, 33.1, 3), (16.0, 32.9, 1), (34.0, 49.0, 1), (40.0, 51.0, 2)],
)
def test_a_picture_is_shown_by_the_first_frame_after_it_was_painted(pressed, painted, number):
    """Frames are counted from the first that begins after the key's event, also when it begins a moment later."""
    assert shown_by(pressed, painted, FRAMES) == number


def test_a_frame_without_a_new_picture_and_a_picture_that_is_never_shown_do_not_count():
    """Two pictures between two frames are one that is seen; what is painted before the first frame is unknown."""
    assert new_pictures([-1.0, 3.0, 4.0, 49.0, 51.0], FRAMES) == [16.0, 50.0]
