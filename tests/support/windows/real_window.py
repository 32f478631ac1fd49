"""An X server without a screen, the game in a window there, and the hands that use it: keys, a mouse, or a gamepad."""

import contextlib
import json
import os
import select
import shutil
import subprocess
import sys
import time
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
    """A game in a window. seen: what it told last, see `watched_game`; its screen is None once it has ended."""

    def __init__(self, children, display, folder, *arguments, pad=False):
        """Start it without a sound card; what it keeps goes into a folder."""
        hidden = {"SDL_VIDEODRIVER", "WAYLAND_DISPLAY", "PAD", "LANGUAGE", "LC_ALL", "LANG"}
        self.environment = {key: value for key, value in os.environ.items() if key not in hidden}
        self.environment |= dict.fromkeys(("XDG_DATA_HOME", "XDG_CONFIG_HOME", "HOME"), str(folder))
        self.environment |= {"DISPLAY": display, "SDL_AUDIODRIVER": "none"} | ({"PAD": "1"} if pad else {})
        self.process = children.start(
            [sys.executable, "-m", "tests.support.windows.watched_game", *arguments],
            cwd=ROOT,
            env=self.environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self.seen, self._read, self._asked = {}, b"", 0

    def wait(self, condition):
        """Wait until what is to be seen meets a condition, however long that takes on a busy machine."""
        while not condition(self.seen):
            assert self.seen.get("screen", "") is not None, f"it has ended: {self.process.stderr.read().decode()}"
            assert select.select([self.process.stdout], [], [], GIVE_UP)[0], self.seen
            more = os.read(self.process.stdout.fileno(), 1 << 16)
            *lines, self._read = (self._read + more).split(b"\n")
            self.seen = json.loads(lines[-1]) if lines else self.seen if more else {"screen": None}

    def expect(self, screen):
        """Wait for a screen."""
        self.wait(lambda seen: seen.get("screen") == screen)

    def until(self, condition, act):
        """Do something until what is to be seen meets a condition: a busy X server loses a click or a key now and then.

        It is done again only once the game has taken all that was sent before, so never because the game is slow.
        """
        end = time.monotonic() + GIVE_UP
        while not condition(self.seen):
            assert time.monotonic() < end, self.seen
            act()
            self._asked += 1
            self.send(f"answer {self._asked}")
            self.wait(lambda seen: seen["screen"] is None or seen["answered"] == self._asked)

    def changed(self, act):
        """Do something until another screen or other items are seen."""
        before = _content(self.seen)
        self.until(lambda seen: _content(seen) != before, act)

    def send(self, *lines):
        """Write lines to the game's stdin."""
        with contextlib.suppress(BrokenPipeError):  # it has ended, which is to be seen
            self.process.stdin.write("".join([f"{line}\n" for line in lines]).encode())
            self.process.stdin.flush()


def _content(seen):
    """What is to be seen without what moves by itself: the focus, what is scrolled, the window."""
    items = {label: item[5] for label, item in seen.get("items", {}).items()}
    return seen["screen"], seen.get("text"), items


class _Walker:
    """Hands that go from item to item and accept one. `press` is how they do what an action's name says."""

    def __init__(self, game):
        self.game = game

    def choose(self, label):
        """Go to the item that says something, and accept it."""
        self.game.until(lambda seen: seen["focus"] == label, lambda: self.press(self._step(label)))
        self.game.changed(lambda: self.press("ACCEPT"))

    def leave(self):
        """Lead back."""
        self.game.changed(lambda: self.press("BACK"))

    def pause(self):
        """Stop the game for a while."""
        self.game.changed(lambda: self.press("PAUSE"))

    def serve(self):
        """Launch the ball."""
        self.game.until(_is_served, lambda: self.press("SERVE"))

    def steer(self, *, on):
        """Turn the paddles as long as it is on."""
        self.game.until(lambda seen: seen.get("steers", False) == on, lambda: self._hold(on=on))

    def _step(self, label):
        """The action that leads nearer to an item."""
        seen = self.game.seen
        row, column = seen["items"][label][2:4]
        here = seen["items"].get(seen["focus"])
        if here is None or here[2] != row:
            return "DOWN" if here is None or here[2] < row else "UP"
        return "RIGHT" if here[3] < column else "LEFT"


class Keys(_Walker):
    """A keyboard."""

    NAMES = MappingProxyType({"ACCEPT": "Return", "BACK": "Escape", "PAUSE": "p", "SERVE": "space"})

    def press(self, action):
        """Press and release a key."""
        _xdotool(self.game, "key", self.NAMES.get(action, action.capitalize()))

    def enter(self, name):
        """Type."""
        self.game.until(lambda seen: seen["text"] == name, lambda: self._type(name))
        self.game.changed(lambda: self.press("ACCEPT"))

    def _type(self, name):
        """Type the next letter, or take a wrong one away."""
        text = self.game.seen["text"]
        _xdotool(self.game, *(("type", name[len(text)]) if name.startswith(text) else ("key", "BackSpace")))

    def _hold(self, *, on):
        """Hold a turning key down, or let it go."""
        _xdotool(self.game, "keydown" if on else "keyup", "Left")


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
        self.game.send(f"press {self.BUTTONS[action]}", f"release {self.BUTTONS[action]}")

    def enter(self, name):
        """Letter by letter."""
        for letter in name:
            self.choose(letter)
        self.choose("Done")

    def _hold(self, *, on):
        """Squeeze a trigger, or let it go."""
        self.game.send(f"push {pygame.CONTROLLER_AXIS_TRIGGERRIGHT} {1.0 if on else -1.0}")


class Mouse:
    """A mouse."""

    def __init__(self, game):
        self.game = game

    def choose(self, label):
        """Click on the item that says something; the wheel brings it into view."""
        self.game.until(lambda seen: _is_in_view(seen, label), lambda: self._turn_wheel(label))
        self._click_on(lambda seen: seen["items"][label][:2])

    def leave(self):
        """Lead back by a panel's cross, or by the first button beside a replay, or by the editor's."""
        seen = self.game.seen
        if "close" in seen:
            self._click_on(lambda seen: seen["close"])
        elif "buttons" in seen:
            self._click_on(lambda seen: seen["buttons"][0])
        else:
            self.choose("Leave")

    def pause(self):
        """The button beside the arena."""
        self._click_on(lambda seen: seen["buttons"][0])

    def serve(self):
        """A click on the arena."""
        self.game.until(_is_served, lambda: self._click(100, 100))

    def steer(self, *, on):
        """The mouse rests: the paddles follow it once."""

    def enter(self, name):
        """Letter by letter."""
        Pad.enter(self, name)

    def _turn_wheel(self, label):
        """Scroll nearer to an item."""
        seen = self.game.seen
        _xdotool(self.game, "click", "4" if seen["items"][label][1] < seen["view"][0] else "5")

    def _click_on(self, found):
        """Click until something else is seen. found: says where, from what is to be seen."""
        self.game.changed(lambda: self._click(*found(self.game.seen)))

    def _click(self, x, y):
        """A click of the main button."""
        _xdotool(self.game, "mousemove", "--window", self._window(), str(x), str(y), "click", "1")

    def _window(self):
        """The window's number."""
        if not hasattr(self, "_number"):
            self._number = _xdotool(self.game, "getwindowfocus").strip()
        return self._number


def _is_served(seen):
    """Whether no ball waits for a serve."""
    return seen.get("phase") != "SERVING"


def _is_in_view(seen, label):
    """Whether an item's middle is in view."""
    _, y, _, _, scrolls, _ = seen["items"][label]
    return not scrolls or seen["view"][0] <= y < seen["view"][1]


def _xdotool(game, *words):
    """Let the X server see keys and mouse; what xdotool answers."""
    command = [_XDOTOOL, *words]
    return subprocess.run(command, env=game.environment, check=True, capture_output=True, text=True).stdout
