"""When the next frame is due: at even distances, whatever the frames themselves take.

`pygame.time.Clock` counts whole milliseconds: asked for 60 frames a second it allows 62.5, and a display that shows 60 leaves
out two or three of them every second, which is seen as a jerk.
"""

import time
from collections.abc import Callable


class FramePace:
    """Lets the turns of a loop begin at even distances."""

    def __init__(self, clock: Callable[[], float] = time.perf_counter, sleep: Callable[[float], None] = time.sleep) -> None:
        """The first frame begins now. clock: seconds; sleep: lets so many seconds pass."""
        self._clock, self._sleep = clock, sleep
        self._due = clock()

    def wait(self, rate: float) -> None:
        """Return when the next frame is due. rate: frames per second.

        A frame that took too long is not made up for: the next one begins at once, and those after it are evenly spaced from
        there on, as two in quick succession would look like a jerk.
        """
        now = self._clock()
        self._due = max(self._due + 1.0 / rate, now)
        if self._due > now:
            self._sleep(self._due - now)
