"""The benchmark of frames measures frames."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pytest

from tools.measure import frame as frames


@pytest.mark.parametrize("opened", [frames._plain, frames._window])
def test_every_frame_is_timed(opened):
    """As many times as asked for, none of them nothing, on a surface and in a window, which is closed again."""
    size, taken = frames.timed(frames.Case("3D", (160, 100), frames.TIPPED, 0.02), 7, 25, opened)
    assert size == (160, 100)
    assert len(taken) == 25
    assert min(one.clock for one in taken) > 0.0
    assert sum(one.processor for one in taken) > 0.0


def test_the_table_has_a_row_for_every_case(monkeypatch, capsys):
    """Each names its size and gives five figures."""
    monkeypatch.setattr(frames, "timed", lambda case, _level, count, _opened: (case.size, [frames.Taken(1.0, 2.0)] * count))
    frames.frames(count=20)
    rows = capsys.readouterr().out.splitlines()[1:]
    assert len(rows) == 5
    assert all(row.split()[-5:] == ["1.00", "1.00", "1.00", "2.00", "2.00"] for row in rows)
    assert sum("1280x800" in row for row in rows) == 3
