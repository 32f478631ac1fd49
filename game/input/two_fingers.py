"""Moving the camera with two fingers on a touch screen: by dragging and by pinching. Needs no pygame."""

import math
from collections.abc import Iterator

from game.input.signals import Dragged, Signal, Zoomed
from game.input.view import ZOOM_STEP


def two_fingers(before: complex, now: complex, other: complex) -> Iterator[Signal]:
    """The signals of a movement by one of two fingers. before, now: its pixels; other: the pixel of the finger at rest."""
    yield Dragged((now - before) / 2.0)
    apart, later = abs(before - other), abs(now - other)
    if apart > 0.0 and later > 0.0:
        yield Zoomed(math.log(later / apart) / math.log(ZOOM_STEP))
