"""Frames begin at even distances."""

from itertools import pairwise

from game.loop.frame_pace import FramePace


class Clock:
    """A clock that advances only by work and by sleep."""

    def __init__(self):
        self.now = 5.0

    def __call__(self):
        return self.now

    def pass_by(self, seconds):
        self.now += seconds


def starts(works, rate=60.0):
    """The times at which frames begin. works: seconds of work of each frame."""
    clock = Clock()
    pace, begun = FramePace(clock, clock.pass_by), []
    for work in works:
        begun.append(clock.now)
        clock.pass_by(work)
        pace.wait(rate)
    return begun


def steps(begun):
    """The seconds from each frame to the next, in milliseconds."""
    return [round(1000.0 * (later - earlier), 6) for earlier, later in pairwise(begun)]


def test_frames_begin_at_even_distances_whatever_they_take():
    """Each frame begins 1/60 s after the one before, also after minutes."""
    begun = starts([0.001, 0.016, 0.009, 0.0] * 2_500)
    assert set(steps(begun[:100])) == {round(1000.0 / 60.0, 6)}
    assert abs(begun[-1] - begun[0] - (len(begun) - 1) / 60.0) < 1e-6


def test_a_frame_that_is_late_is_not_made_up_for():
    """The frame after it begins at once, and no two frames follow in quick succession."""
    assert steps(starts([0.002, 0.050, 0.002, 0.002, 0.002])) == [16.666667, 50.0, 16.666667, 16.666667]


def test_the_rate_may_change():
    """A window that loses the focus draws less often; with the focus again, at the full rate at once."""
    clock = Clock()
    pace = FramePace(clock, clock.pass_by)
    pace.wait(10.0)
    assert round(clock.now, 6) == 5.1
    pace.wait(60.0)
    assert round(clock.now, 6) == round(5.1 + 1.0 / 60.0, 6)
