"""A window on SDL's dummy driver, and a player's hands on it."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"
os.environ["SDL_AUDIODRIVER"] = "dummy"

import pygame

from game.editor.window.screen import Editor
from game.input.scancodes import position_of
from game.input.signals import KeyboardState
from game.levels import classic
from game.loop.app import frame
from game.screens.app_state import AppState
from game.screens.menus.level_select import LevelSelect
from game.screens.title import Title
from game.system import window as display

FRAME = 1.0 / 60.0
SIZE = (640, 400)


def shared(level=0, seed=7, recorder=None, *, autopilot=False):
    """What outlives a screen, before anything has happened."""
    state = AppState(classic(), level, seed, Title, recorder, autopilot)
    state.open_levels = lambda state: LevelSelect(state, Title(state))
    return state


class Desk:
    """Runs the app frame by frame and posts what a player does as events."""

    def __init__(self, state, screen, size=SIZE):
        self.shared, self.screen = state, screen
        self.window = display.open_window("test", size)
        self.down = set()
        pygame.event.clear()

    def press(self, *keys, mod=0):
        """Press and release keys, a frame each."""
        for key in keys:
            self._post_key(pygame.KEYDOWN, key, mod)
            self._post_key(pygame.KEYUP, key, mod)
            self.wait(FRAME)

    def hold(self, key):
        """Press a key and keep it down."""
        self.down.add(position_of(key))
        self._post_key(pygame.KEYDOWN, key)

    def release(self, key):
        """Let a key go."""
        self.down.discard(position_of(key))
        self._post_key(pygame.KEYUP, key)

    def move(self, place, *, held=False):
        """Move the mouse."""
        pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=place, rel=(1, 1), buttons=(int(held), 0, 0)))

    def click(self, place):
        """Click with the main button."""
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=place, button=1))
        self.wait(FRAME)

    @property
    def form(self):
        """The form in use: a panel, or the controls beside the editor's arena."""
        size = self.window.get_surface().get_size()
        return self.screen.side(size) if isinstance(self.screen, Editor) else self.screen

    def box(self, label):
        """Where the item of a panel is that says something."""
        size = self.window.get_surface().get_size()
        items = self.form._form_layout(size).items
        return next(positioned.box for positioned in items if label in _words(positioned.item))

    def click_on(self, label):
        """Click on the item of a panel that says something; the wheel brings it into view."""
        size = self.window.get_surface().get_size()
        for _ in range(60):
            layout = self.form._form_layout(size)
            positioned = next(positioned for positioned in layout.items if label in _words(positioned.item))
            if not positioned.in_body or layout.body.collidepoint(positioned.box.center):
                break
            steps = -1.0 if positioned.box.centery > layout.body.centery else 1.0
            pygame.event.post(pygame.Event(pygame.MOUSEWHEEL, precise_y=steps, x=0, y=0))
            self.wait(FRAME)
        self.move(self.box(label).center)
        self.click(self.box(label).center)

    def choose(self, label):
        """Go to the item of a panel that says something, with arrow keys alone, and press Enter."""
        self.focus(label)
        self.press(pygame.K_RETURN)

    def focus(self, label):
        """Go to the item of a panel that says something, with arrow keys alone."""
        layout = self.form._form_layout(self.window.get_surface().get_size())
        wanted = next(positioned for positioned in layout.items if label in _words(positioned.item))
        for _ in range(100):
            focus = self.form._settled(layout)
            if focus == (wanted.row, wanted.column):
                return
            sideways = pygame.K_LEFT if focus.column > wanted.column else pygame.K_RIGHT
            self.press(sideways if focus.row == wanted.row else pygame.K_DOWN)
        raise AssertionError(f"{label} cannot be reached by arrow keys")

    def type(self, text):
        """Enter text as a keyboard does."""
        for letter in text:
            pygame.event.post(pygame.Event(pygame.KEYDOWN, key=ord(letter.lower()), scancode=0, mod=0, unicode=letter))
            pygame.event.post(pygame.Event(pygame.TEXTINPUT, text=letter))
        self.wait(FRAME)

    def post(self, kind):
        """Send any other event."""
        pygame.event.post(pygame.Event(kind))
        self.wait(FRAME)

    def wait(self, seconds):
        """Let time pass in frames; stops when the game is left."""
        for _ in range(max(round(seconds / FRAME), 1)):
            if self.screen is not None:
                self.screen = frame(self.window, self.shared, self.screen, FRAME, self._keyboard)

    def _post_key(self, kind, key, mod=0):
        """A key of the US layout."""
        pygame.event.post(pygame.Event(kind, key=key, scancode=position_of(key), mod=mod))

    def _keyboard(self):
        """The keys that are down."""
        return KeyboardState(frozenset(self.down))

    def close(self):
        """Take the window away."""
        self.window.destroy()
        pygame.quit()


def _words(item):
    """What an item of a panel says."""
    level = getattr(item, "level", None)
    cells = "  ".join([cell[0] for cell in getattr(item, "cells", ())])
    return getattr(item, "label", "") or getattr(level, "name", "") or cells
