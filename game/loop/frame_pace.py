"""Frames at even distances, however long each of them takes.

`pygame.time.Clock` counts whole milliseconds: for 60 frames a second it gives 62.5. A display that shows 60 leaves out two or
three of them every second, which is visible as stutter.
"""

import time
from collections.abc import Callable


class FramePace:
    """Makes the iterations of a loop begin at even distances."""

    def __init__(self, clock: Callable[[], float] = time.perf_counter, sleep: Callable[[float], None] = time.sleep) -> None:
        """The first frame begins now. clock: returns seconds; sleep: waits for some seconds."""
        self._clock, self._sleep = clock, sleep
        self._due = clock()

    def wait(self, rate: float) -> None:
        """Return when the next frame is due. rate: frames per second.

        After a frame that took too long the next one begins at once, and the others follow at even distances from there. The
        lost time is not made up for, since two frames in quick succession would look like stutter.
        """
        now = self._clock()
        self._due = max(self._due + 1.0 / rate, now)
        if self._due > now:
            self._sleep(self._due - now)
