"""A signal while a window is open: the game and the settings are kept, one line, 128 + the signal's number."""

import os
import signal
import sys

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pytest

from game.commands import app as command
from game.loop import app
from game.replays import file as replay
from game.replays.verify import verified
from game.settings.file import SettingsFile
from game.storage import games as kept_games
from game.storage.storage import Storage
from game.system import ending
from game.system.command_line import run

if sys.platform == "win32":
    pytest.skip("Windows has no such signals", allow_module_level=True)


@pytest.fixture(params=[signal.SIGINT, signal.SIGTERM, signal.SIGHUP], ids=lambda number: number.name)
def number(request):
    """A signal that the program listens to."""
    before = signal.signal(request.param, ending._handle)
    yield request.param
    signal.signal(request.param, before)


def test_a_signal_in_play_keeps_the_game_and_the_settings(monkeypatch, tmp_path, capsys, number):
    """In the middle of the 60th frame, and once more while everything is being saved."""
    frames, settings, file = [], tmp_path / "settings.json", tmp_path / "game.polar"
    monkeypatch.setattr("game.commands.settings_path", lambda: settings)
    monkeypatch.setattr("game.commands.data_folder", lambda: tmp_path / "data")
    monkeypatch.setattr(kept_games, "_SHORTEST", 0.0)
    drawn, quit_pygame = app.frame, app.pygame.quit

    def looked(window, shared, screen, _seconds):
        frames.append(shared)
        if len(frames) == 10:
            shared.change(shared.settings._replace(volume=30))
        if len(frames) == 60:
            signal.raise_signal(number)
        return drawn(window, shared, screen, 1 / 60)

    def interrupted():
        signal.raise_signal(number)
        quit_pygame()

    monkeypatch.setattr(app, "frame", looked)
    monkeypatch.setattr(app.pygame, "quit", interrupted)
    monkeypatch.setattr(app.display, "refresh_rate", lambda: 1000)
    code = run(command, "polar-breakout", ["--autopilot", "--seed", "3", "--record", str(file)])
    out, err = capsys.readouterr()
    assert (code, out, err) == (128 + number, "", f"polar-breakout: {ending.WORDS[number.name]}\n")
    assert len(frames) == 60
    assert SettingsFile(settings).load().volume == 30
    kept_files = Storage(tmp_path / "data").games.paths()
    for kept in (file, *kept_files):
        recording = replay.load(kept)
        assert recording.ticks > 200
        assert verified(recording).divergence is None
    assert len(kept_files) == 1


@pytest.mark.parametrize("arguments", [["lab"], ["replay", "game.polar"]], ids=["lab", "replay"])
def test_a_signal_in_another_window_keeps_the_settings(monkeypatch, tmp_path, capsys, number, arguments):
    """The lab, and a recorded game that is watched."""
    monkeypatch.chdir(tmp_path)
    settings = tmp_path / "settings.json"
    monkeypatch.setattr("game.commands.settings_path", lambda: settings)
    assert run(command, "polar-breakout", ["--headless", "--autopilot", "--ticks", "50", "--record", "game.polar"]) == 0
    capsys.readouterr()
    drawn = app.frame

    def looked(window, shared, screen, seconds):
        shared.change(shared.settings._replace(volume=30))
        signal.raise_signal(number)
        return drawn(window, shared, screen, seconds)

    monkeypatch.setattr(app, "frame", looked)
    code = run(command, "polar-breakout", arguments)
    assert (code, capsys.readouterr().err) == (128 + number, f"polar-breakout: {ending.WORDS[number.name]}\n")
    assert SettingsFile(settings).load().volume == 30
