"""The commands that measure memory over an evening and the time to the first picture."""

import os
import sys
import time

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pytest

from game.system.command_line import run
from game.system.errors import CheckFailedError, EnvironmentMissingError
from tools.measure import memory as soak
from tools.measure import startup


@pytest.fixture(autouse=True)
def _quick(monkeypatch):
    """Two frames a second instead of sixty."""
    monkeypatch.setattr(soak, "_RATE", 2)


def test_memory_that_stays_is_fine(monkeypatch, capsys):
    """The figures of the first minute and of the end, and exit code 0."""
    figures = iter([50.0, 60.0, 60.0, 62.0])
    monkeypatch.setattr(soak, "held", lambda: next(figures))
    assert run(soak.app, "soak", ["--minutes", "1.1", "--width", "64", "--height", "48"]) == 0
    out, _ = capsys.readouterr()
    assert "after 1 min 60.0 MB, after 1.1 min 62.0 MB: +3.3% (at most +5%)" in out


def test_memory_that_grows_is_found(monkeypatch, capsys):
    """More than the bound is exit code 1, in one line."""
    figures = iter([50.0, 60.0, 60.0, 63.1])
    monkeypatch.setattr(soak, "held", lambda: next(figures))
    assert run(soak.app, "soak", ["--minutes", "1.1", "--width", "64", "--height", "48"]) == 1
    _, err = capsys.readouterr()
    assert err.endswith("\nsoak: memory grew by 5.2%\n")


def test_the_soak_sees_every_level_from_both_sides(monkeypatch):
    """In the first minute, as it says; and what it plays are the window's own screens."""
    seen = set()
    later = soak._later
    monkeypatch.setattr(soak, "held", lambda: 50.0)

    def looked(window, shared, screen, number):
        following = later(window, shared, screen, number)
        if number <= 60 * soak._RATE:
            seen.add((following._levels[0].name, shared.view.tipped > 0.5))
        return following

    monkeypatch.setattr(soak, "_later", looked)
    run(soak.app, "soak", ["--minutes", "1.1", "--width", "64", "--height", "48"])
    assert len(seen) == 14


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere the system does not tell")
def test_held_is_this_process(monkeypatch):
    """A hundred megabytes more are seen; where the system does not tell, that is said."""
    before = soak.held()
    ballast = bytearray(os.urandom(1024)) * (100 * 1024)
    assert 80.0 < soak.held() - before < 130.0
    assert len(ballast) == 100 * 1024 * 1024

    def nothing(_self, **_):
        raise OSError

    monkeypatch.setattr(soak.Path, "read_text", nothing)
    with pytest.raises(EnvironmentMissingError, match="Linux"):
        soak.held()


def test_a_start_is_timed_to_its_first_picture():
    """The whole program in a Python of its own."""
    before = time.time()
    start = startup.first_picture()
    assert 0.0 < start.waited < time.time() - before
    assert start.worked > 0.0 or sys.platform == "win32"


def test_a_game_that_does_not_start_is_no_start(monkeypatch):
    """What it says goes on."""
    monkeypatch.setattr(startup, "_PROGRAM", "raise SystemExit('no such game')")
    with pytest.raises(CheckFailedError, match="no such game"):
        startup.first_picture()


def test_a_late_picture_is_exit_code_1(monkeypatch, capsys):
    """By the median; cold starts are asked for."""
    monkeypatch.setattr(startup, "first_picture", lambda: startup.Start(1.2, 0.5))
    assert run(startup.app, "startup", ["--count", "3"]) == 1
    out, err = capsys.readouterr()
    assert "1.20" in out
    assert "cold" not in out
    assert err == "startup: too late: warm\n"
    monkeypatch.setattr(startup, "first_picture", lambda: startup.Start(0.9, 0.5))
    assert run(startup.app, "startup", ["--count", "3"]) == 0
