"""The benchmark of frames measures frames."""

import itertools
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from tools.measure import frame as frames


@pytest.mark.parametrize("opened", [frames._plain, frames._window])
def test_every_frame_is_timed(opened):
    """As many times as asked for, none of them nothing, on a surface and in a window, which is closed again."""
    case = frames.FrameCase("3D", (160, 100), lambda level: frames.game_frames(level, frames.SOLID, 0.02))
    size, taken = frames.timed(case, 7, 25, opened)
    assert size == (160, 100)
    assert len(taken) == 25
    assert min(one.clock for one in taken) > 0.0
    assert sum(one.processor for one in taken) > 0.0


@pytest.mark.parametrize("case", frames.cases(), ids=lambda case: f"{case.name} {case.size[0]}")
def test_every_case_draws_frames(case):
    """Each covers the whole surface; those of a game that goes on differ, those of a panel are the same."""
    surface, pictures = pygame.Surface((160, 100), 0, 32), set()
    following = case.frames(7)
    for _ in range(3):
        surface.fill((255, 0, 255))
        next(following)(surface)
        assert tuple(surface.get_at((0, 0)))[:3] != (255, 0, 255)
        pictures.add(pygame.image.tobytes(surface, "RGB"))
    assert len(pictures) == (3 if case.name.startswith(("top-down", "3D")) else 1)


def test_the_table_has_a_row_for_every_case(monkeypatch, capsys):
    """Each names its size and gives five figures."""
    cost = frames.FrameCost(1.0, 2.0)
    monkeypatch.setattr(frames, "timed", lambda case, _level, count, _opened: (case.size, [cost] * count))
    frames.frames(count=20)
    rows = capsys.readouterr().out.splitlines()[1:]
    assert len(rows) == len(frames.cases())
    assert all(row.split()[-5:] == ["1.00", "1.00", "1.00", "2.00", "2.00"] for row in rows)
    assert sum("1280x800" in row for row in rows) == 7


def test_the_distances_between_frames_are_timed(monkeypatch):
    """There is one distance less than frames; the first frames, which fill caches, are not counted."""
    monkeypatch.setattr(frames, "_RATE", 1000.0)
    case = frames.FrameCase("nothing", (16, 10), lambda _level: itertools.repeat(lambda _surface: None))
    size, steps = frames.paced(case, 7, 25, frames._plain)
    assert size == (16, 10)
    assert len(steps) == 24
    assert min(steps) > 0.0
