"""An X server without a screen, the game in a window there, and the hands that use it: keys, a mouse, or a gamepad."""

import json
import os
import select
import shutil
import subprocess
import sys
from types import MappingProxyType

import pygame
import pytest

from tests.support.children import GIVE_UP
from tests.support.paths import ROOT

_XDOTOOL = shutil.which("xdotool") or ""
NO_SERVER = pytest.mark.skipif(
    not _XDOTOOL or shutil.which("Xvfb") is None, reason="needs an X server and a hand on it: Xvfb and xdotool"
)
_SCREEN = "480x400x24"


def started_server(children):
    """An X server of one's own; the name of its display."""
    reading, writing = os.pipe()
    children.start(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", _SCREEN, "-nolisten", "tcp"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    with os.fdopen(reading) as told:
        return f":{told.readline().strip()}"


class RealGame:
    """A game in a window. seen: what it told last (tests/support/watched_game.py)."""

    def __init__(self, children, display, folder, *arguments, pad=False):
        """Start it; what it keeps goes into a folder."""
        hidden = {"SDL_VIDEODRIVER", "WAYLAND_DISPLAY", "PAD", "LANGUAGE", "LC_ALL", "LANG"}
        self.environment = {key: value for key, value in os.environ.items() if key not in hidden}
        self.environment |= dict.fromkeys(("XDG_DATA_HOME", "XDG_CONFIG_HOME", "HOME"), str(folder))
        self.environment |= {"DISPLAY": display, "SDL_AUDIODRIVER": "dummy"} | ({"PAD": "1"} if pad else {})
        self.process = children.start(
            [sys.executable, "-m", "tests.support.watched_game", *arguments],
            cwd=ROOT,
            env=self.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self.seen, self._read = {}, b""

    def wait(self, condition):
        """Wait until what is to be seen meets a condition, however long that takes on a busy machine."""
        while not condition(self.seen):
            assert select.select([self.process.stdout], [], [], GIVE_UP)[0], self.seen
            more = os.read(self.process.stdout.fileno(), 1 << 16)
            assert more, f"it has ended: {self.process.stderr.read().decode()} {self.seen}"
            *lines, self._read = (self._read + more).split(b"\n")
            self.seen = json.loads(lines[-1]) if lines else self.seen

    def expect(self, screen):
        """Wait for a screen."""
        self.wait(lambda seen: seen.get("screen") == screen)

    def changed(self, act):
        """Do something, and wait until that is seen."""
        before = self.seen
        act()
        self.wait(lambda seen: seen != before)


class _Walker:
    """Hands that go from item to item and accept one. `press` is how they do what an action's name says."""

    def __init__(self, game):
        self.game = game

    def choose(self, label):
        """Go to the item that says something, and accept it."""
        while (seen := self.game.seen)["focus"] != label:
            row, column = seen["items"][label][2:4]
            here = seen["items"].get(seen["focus"])
            if here is None or here[2] != row:
                step = "DOWN" if here is None or here[2] < row else "UP"
            else:
                step = "RIGHT" if here[3] < column else "LEFT"
            self.game.changed(lambda step=step: self.press(step))
        self.press("ACCEPT")

    def leave(self):
        """Lead back."""
        self.press("BACK")

    def pause(self):
        """Stop the game for a while."""
        self.press("PAUSE")

    def serve(self):
        """Launch the ball."""
        self.press("SERVE")


class Keys(_Walker):
    """A keyboard."""

    NAMES = MappingProxyType({"ACCEPT": "Return", "BACK": "Escape", "PAUSE": "p", "SERVE": "space"})

    def press(self, action):
        """Press and release a key."""
        _xdotool(self.game, "key", self.NAMES.get(action, action.capitalize()))

    def steer(self, *, on):
        """Turn the paddles as long as it is on."""
        _xdotool(self.game, "keydown" if on else "keyup", "Left")

    def enter(self, name):
        """Type."""
        _xdotool(self.game, "type", name)
        self.press("ACCEPT")


class Pad(_Walker):
    """A gamepad."""

    BUTTONS = MappingProxyType(
        {
            "ACCEPT": pygame.CONTROLLER_BUTTON_A,
            "SERVE": pygame.CONTROLLER_BUTTON_A,
            "BACK": pygame.CONTROLLER_BUTTON_B,
            "PAUSE": pygame.CONTROLLER_BUTTON_START,
            "UP": pygame.CONTROLLER_BUTTON_DPAD_UP,
            "DOWN": pygame.CONTROLLER_BUTTON_DPAD_DOWN,
            "LEFT": pygame.CONTROLLER_BUTTON_DPAD_LEFT,
            "RIGHT": pygame.CONTROLLER_BUTTON_DPAD_RIGHT,
        }
    )

    def press(self, action):
        """Press and release a button."""
        self._does(f"press {self.BUTTONS[action]}", f"release {self.BUTTONS[action]}")

    def steer(self, *, on):
        """Turn the paddles with a trigger as long as it is on."""
        self._does(f"push {pygame.CONTROLLER_AXIS_TRIGGERRIGHT} {1.0 if on else -1.0}")

    def enter(self, name):
        """Letter by letter."""
        for letter in name:
            self.choose(letter)
        self.choose("Done")

    def _does(self, *acts):
        """Send what the gamepad does."""
        self.game.process.stdin.write("".join([f"{act}\n" for act in acts]).encode())
        self.game.process.stdin.flush()


class Mouse:
    """A mouse."""

    def __init__(self, game):
        self.game = game

    def choose(self, label):
        """Click on the item that says something; the wheel brings it into view."""
        while (seen := self.game.seen)["items"][label][4] and not self._is_seen(label):
            wheel = "4" if seen["items"][label][1] < seen["view"][0] else "5"
            self.game.changed(lambda wheel=wheel: _xdotool(self.game, "click", wheel))
        self._click(*self.game.seen["items"][label][:2])

    def leave(self):
        """Lead back by a panel's cross, or by the first button beside a replay, or by the editor's."""
        seen = self.game.seen
        if "close" in seen:
            self._click(*seen["close"])
        elif "buttons" in seen:
            self._click(*seen["buttons"][0])
        else:
            self.choose("leave")

    def pause(self):
        """The button beside the arena."""
        self._click(*self.game.seen["buttons"][0])

    def serve(self):
        """A click on the arena."""
        self._click(100, 100)

    def steer(self, *, on):
        """The mouse rests: the paddles follow it once."""

    def enter(self, name):
        """Letter by letter."""
        Pad.enter(self, name)

    def _is_seen(self, label):
        """Whether an item's middle is in view."""
        upper, lower = self.game.seen["view"]
        return upper <= self.game.seen["items"][label][1] < lower

    def _click(self, x, y):
        """A click of the main button."""
        _xdotool(self.game, "mousemove", "--window", self._window(), str(x), str(y), "click", "1")

    def _window(self):
        """The window's number."""
        if not hasattr(self, "_number"):
            self._number = _xdotool(self.game, "getwindowfocus").strip()
        return self._number


def _xdotool(game, *words):
    """Let the X server see keys and mouse; what xdotool answers."""
    command = [_XDOTOOL, *words]
    return subprocess.run(command, env=game.environment, check=True, capture_output=True, text=True).stdout
