"""The display goes away in the middle of a game: the game is kept, one line, exit code 3."""

import os
import shutil
import subprocess
import sys

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame
import pytest

from game.commands import app as command
from game.levels import campaign
from game.loop import app
from game.replays import file as replay
from game.replays.verify import verified
from game.system.command_line import run
from game.system.errors import DisplayLostError
from tests.support.paths import ROOT

_PICTURES = 60
_PROGRAM = f"""
import sys
from game.loop import app
from game.__main__ import main

shown, plain = 0, app.frame

def frame(*arguments):
    global shown
    shown += 1
    if shown == {_PICTURES}:
        print("playing", flush=True)
    return plain(*arguments)

app.frame = frame
main()
"""
"""The game; it says so on stdout once a number of pictures have been shown."""
NO_SERVER = pytest.mark.skipif(shutil.which("Xvfb") is None, reason="needs an X server to kill: Xvfb")


class Broken:
    """A window whose display is gone after some pictures."""

    focused, size = True, (320, 200)

    def __init__(self, pictures):
        self.left, self.surface, self.position = pictures, pygame.Surface(self.size, 0, 32), (0, 0)

    def get_surface(self):
        return self.surface

    def flip(self):
        self.left -= 1
        if self.left < 0:
            raise pygame.error("lost device")


def test_a_window_that_cannot_be_shown_any_more_ends_the_game_cleanly(monkeypatch, tmp_path, capsys):
    """The system says so by an error: the recorded game is written whole, and the exit code is 3."""
    monkeypatch.setattr("game.commands.settings_path", lambda: tmp_path / "settings.json")
    monkeypatch.setattr("game.commands.data_folder", lambda: tmp_path)
    monkeypatch.setattr(app.display, "open_window", lambda *_: pygame.display.init() or Broken(40))
    monkeypatch.setattr(app.display, "refresh_rate", lambda: 60)
    file = tmp_path / "game.polar"
    assert run(command, "polar-breakout", ["--autopilot", "--seed", "3", "--record", str(file)]) == 3
    out, err = capsys.readouterr()
    assert err == "polar-breakout: the display is gone: lost device\n"
    assert out == ""
    recording = replay.load(file)
    assert recording.ticks > 20
    assert verified(recording).divergence is None


def test_a_surface_that_is_gone_says_so_too():
    """Before anything could be drawn."""

    class Gone(Broken):
        def get_surface(self):
            raise pygame.error("Window surface is invalid")

    with pytest.raises(DisplayLostError, match="the display is gone: Window surface"):
        app.frame(Gone(1), None, None, 0.0)


def started_server(children):
    """An X server of one's own and the name of its display."""
    reading, writing = os.pipe()
    server = children.start(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24", "-nolisten", "tcp"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    with os.fdopen(reading) as told:
        number = told.readline().strip()
    return server, f":{number}"


def started_game(children, display, folder, *arguments):
    """A game in a window that has shown pictures, its files in a folder: the process, and the recording's file."""
    file, hidden = folder / "game.polar", {"SDL_VIDEODRIVER", "WAYLAND_DISPLAY"}
    environment = {key: value for key, value in os.environ.items() if key not in hidden}
    environment |= {"DISPLAY": display, "XDG_DATA_HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "HOME": str(folder)}
    game = children.start(
        [sys.executable, "-c", _PROGRAM, "--seed", "3", "--record", str(file), *arguments],
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    while (line := game.stdout.readline()) != "playing\n":
        assert line, game.stderr.read()  # else it has ended
    return game, file


@NO_SERVER
@pytest.mark.parametrize("autopilot", [["--autopilot"], []], ids=["playing", "title"])
def test_a_killed_x_server(children, tmp_path, autopilot):
    """Xlib would end the program with two lines of its own; the game writes what it has, says one line, and exits with 3."""
    server, name = started_server(children)
    game, file = started_game(children, name, tmp_path, *autopilot)
    server.kill()
    out, err = game.communicate()
    assert game.returncode == 3, err
    assert err.startswith("polar-breakout: the display is gone")
    assert err.count("\n") == 1
    assert out == ""
    if autopilot:
        recording = replay.load(file)
        assert recording.ticks > 100
        assert recording.levels[0] == campaign()[0]
        assert verified(recording).divergence is None
    else:
        assert not file.exists()


@NO_SERVER
def test_being_ended_is_being_closed(children, tmp_path):
    """SIGTERM, as a system sends it on shutting down: the game is kept, one line, and exit code 128 + 15."""
    _, name = started_server(children)
    game, file = started_game(children, name, tmp_path, "--autopilot")
    game.terminate()
    _, err = game.communicate()
    assert (game.returncode, err) == (143, "polar-breakout: terminated\n")
    assert verified(replay.load(file)).divergence is None
