"""Two fingers on a touch screen that move the camera: by dragging both, and by pinching. Needs no pygame."""

import math
from collections.abc import Iterator

from game.input.signals import Dragged, Signal, Zoomed
from game.input.view import ZOOM_STEP


def two_fingers(before: complex, now: complex, other: complex) -> Iterator[Signal]:
    """What it means that one of two fingers has moved. before, now: pixels of that one; other: of the one that rests."""
    yield Dragged((now - before) / 2.0)
    apart, later = abs(before - other), abs(now - other)
    if apart > 0.0 and later > 0.0:
        yield Zoomed(math.log(later / apart) / math.log(ZOOM_STEP))
