"""Panels over another screen: a menu with a title, and the help. What lies under them stands still."""

import math
from collections.abc import Callable
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera, unit_of
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.primitives import draw_box
from game.drawing.slots import wall_looks
from game.input.key_names import play_help
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.screens.base import Screen, Shared
from physics import PERMANENT, Ring


class Entry(NamedTuple):
    """One line of a menu."""

    label: str
    chosen: Callable[[], Screen | None]
    key: Action | None = None  # chooses it at once


class Menu:
    """A panel with a title, some lines of text and entries to choose from."""

    def __init__(
        self,
        shared: Shared,
        under: Screen,
        title: str,
        lines: tuple[str, ...],
        entries: tuple[Entry, ...],
        back: Callable[[], Screen | None],
    ) -> None:
        """Open over a screen, the first entry selected. back: what Esc does."""
        self._shared, self._under = shared, under
        self._title, self._lines, self._entries = title, lines, entries
        self._back = back
        self._selected = 0

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Move the selection, or do what the entry says."""
        match signal:
            case Pressed(Action.UP | Action.LEFT):
                self._selected = (self._selected - 1) % len(self._entries)
            case Pressed(Action.DOWN | Action.RIGHT):
                self._selected = (self._selected + 1) % len(self._entries)
            case Pressed(Action.CONFIRM | Action.SERVE):
                return self._entries[self._selected].chosen()
            case Pressed(Action.BACK):
                return self._back()
            case Pressed(Action.HELP):
                return Help(self._shared, self)
            case Pressed(action):
                named = [entry for entry in self._entries if entry.key is action]
                return named[0].chosen() if named else self
            case Moved(place) if (index := self._entry_at(place, size)) is not None:
                self._selected = index
            case Clicked(place) if (index := self._entry_at(place, size)) is not None:
                return self._entries[index].chosen()
        return self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, darker, and the panel."""
        self._under.draw(surface)
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        panel, boxes = self._boxes(size)
        unit = unit_of(size)
        dim(surface, theme)
        draw_panel(surface, panel, theme, unit)
        middle = float(panel.centerx)
        type_.write(surface, self._title, unit * 2.4, theme.text, complex(middle, panel.top + unit * 1.2), "midtop")
        for index, line in enumerate(self._lines):
            y = panel.top + unit * (3.9 + 1.4 * index)
            type_.write(surface, line, unit * 1.1, theme.faint, complex(middle, y), "midtop")
        for index, (entry, box) in enumerate(zip(self._entries, boxes, strict=True)):
            chosen = index == self._selected
            if chosen:
                draw_box(surface, box, unit * 0.5, theme.panel, theme.accent, unit * 0.1)
            colour = theme.accent if chosen else theme.text
            type_.write(surface, entry.label, unit * 1.3, colour, complex(box.centerx, box.centery), "center")

    def _boxes(self, size: tuple[int, int]) -> tuple[pygame.Rect, list[pygame.Rect]]:
        """The panel and its entries, pixels."""
        unit = unit_of(size)
        texts = [self._shared.type.rendered(line, unit * 1.1, self._shared.theme.faint).get_width() for line in self._lines]
        width = max([unit * 22.0, *[text + unit * 4.0 for text in texts]])
        top = 3.9 + 1.4 * len(self._lines) + (0.7 if self._lines else 0.0)
        height = unit * (top + 2.3 * len(self._entries) + 1.0)
        panel = pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))
        entry = (round(width - unit * 6.0), round(unit * 2.0))
        left = panel.left + round(unit * 3.0)
        return panel, [
            pygame.Rect((left, panel.top + round(unit * (top + 2.3 * index))), entry) for index in range(len(self._entries))
        ]

    def _entry_at(self, place: complex, size: tuple[int, int]) -> int | None:
        """The entry at a pixel."""
        index = pygame.Rect(place.real, place.imag, 1, 1).collidelist(self._boxes(size)[1])
        return None if index < 0 else index


class Help:
    """The keys, and what the things in the arena are."""

    def __init__(
        self, shared: Shared, under: Screen, title: str = "How to play", keys: tuple[tuple[str, str], ...] | None = None
    ) -> None:
        """Open over a screen. keys: pairs of keys and what they do; None for those of a game."""
        self._shared, self._under = shared, under
        self._title, self._keys = title, play_help() if keys is None else keys

    def answer(self, signal: Signal, _size: tuple[int, int]) -> Screen | None:
        """Any key of the game or a click closes it."""
        return self._under if isinstance(signal, Pressed | Clicked) else self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, darker, and the panel."""
        self._under.draw(surface)
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        unit = unit_of(size)
        dim(surface, theme)
        width, height = unit * 34.0, unit * 33.0
        panel = pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))
        draw_panel(surface, panel, theme, unit)
        left, top = panel.left + unit * 2.0, panel.top + unit * 1.2
        type_.write(surface, self._title, unit * 2.2, theme.text, complex(left, top))
        goal = "Keep the ball inside the circle; break every brick."
        type_.write(surface, goal, unit * 1.1, theme.faint, complex(left, top + unit * 2.6))
        for index, (keys, meaning) in enumerate(self._keys):
            y = top + unit * (4.7 + min(1.55, 17.2 / len(self._keys)) * index)
            type_.write(surface, keys, unit * 1.15, theme.accent, complex(left, y))
            type_.write(surface, meaning, unit * 1.15, theme.text, complex(left + unit * 11.0, y))
        self._draw_legend(surface, complex(left, top + unit * 22.1), unit)
        close = "Esc, Space or a click closes this panel"
        type_.write(surface, close, unit * 0.95, theme.faint, complex(panel.centerx, panel.bottom - unit * 0.7), "midbottom")

    def _draw_legend(self, surface: pygame.Surface, place: complex, unit: float) -> None:
        """Samples of bricks and what they are."""
        theme, type_ = self._shared.theme, self._shared.type
        samples = [(1, "1 hit"), (2, "2 hits"), (3, "3"), (4, "4"), (5, "5"), (6, "6"), (PERMANENT, "never breaks")]
        pitch = unit * 4.3
        for index, (layers, words) in enumerate(samples):
            spot = place + complex(unit * 1.9 + index * pitch, unit * 1.8)
            self._draw_sample(surface, spot, unit, layers)
            type_.write(surface, words, unit * 0.95, theme.text, spot + 1j * unit * 1.6, "midtop")
        note = "Each step of a brick is one layer. Bricks in a row without a paddle between them multiply the points."
        for index, line in enumerate(type_.wrapped(note, unit * 0.95, unit * 30.0)):
            type_.write(surface, line, unit * 0.95, theme.faint, place + 1j * unit * (5.2 + 1.2 * index))

    def _draw_sample(self, surface: pygame.Surface, middle: complex, unit: float, layers: int) -> None:
        """One brick on its own, as in the arena but on a panel."""
        ring = Ring(4.0, 0.45, 0.2, 1, math.pi / 2.0)
        size = round(unit * 4.0)
        card = pygame.Surface((size, size), 0, 32)
        theme = self._shared.theme
        card.fill(theme.panel)
        painter = Painter(theme._replace(ground=theme.panel))
        painter.paint_ring(card, Camera(complex(size, size) / 2.0 + 8j * unit, unit * 2.0), ring, wall_looks((layers,), []), 6)
        half = pygame.Rect(0, round(size * 0.25), size, round(size * 0.5))
        surface.blit(card, (round(middle.real - size / 2.0), round(middle.imag - size * 0.25)), half)


def draw_panel(surface: pygame.Surface, panel: pygame.Rect, theme: Theme, unit: float) -> None:
    """A plain rectangle with round corners and an edge."""
    draw_box(surface, panel, unit * 0.8, theme.panel, theme.panel_edge, unit * 0.08)


def dim(surface: pygame.Surface, theme: Theme, strength: int = 150) -> None:
    """Cover a surface with a veil of the background's colour. strength: 0 to 255."""
    veil = pygame.Surface(surface.get_size(), 0, surface)
    veil.fill(theme.background)
    veil.set_alpha(strength)
    surface.blit(veil, (0, 0))
