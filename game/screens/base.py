"""What every screen has in common."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

import pygame

from game.controls import Signal
from game.levels import Level
from game.palette import DARK, LIGHT, Theme
from game.render import Painter
from game.rules import Controls, Game
from game.text import Type

Recorder = Callable[[Controls, Game], None]
"""Told every tick of a played game: its controls, and the game after it. `tick` is 1 after the first tick of a new game."""


@dataclass
class Shared:
    """What outlives a screen."""

    catalogue: tuple[Level, ...]  # that the title offers
    chosen: int  # of them
    seed: int
    home: "Callable[[Shared], Screen]"  # opens the title
    recorder: Recorder | None = None
    autopilot: bool = False  # plays instead of the player
    muted: bool = False
    effects: bool = True
    full_screen: bool = False
    theme: Theme = DARK
    painter: Painter = field(default_factory=Painter)
    type: Type = field(default_factory=Type)

    def toggle_theme(self) -> None:
        """Dark to light and back."""
        self.theme = LIGHT if self.theme is DARK else DARK
        self.painter.theme = self.theme


class Screen(Protocol):
    """One screen. Methods that return a screen return the one to go on with: itself, another, or None to leave the game."""

    def answer(self, signal: Signal, size: tuple[int, int]) -> "Screen | None":
        """React to the player. size: of the surface that is drawn on, pixels."""

    def advance(self, seconds: float, size: tuple[int, int]) -> "Screen | None":
        """Let time pass."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw everything."""
