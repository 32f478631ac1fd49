"""What every screen has in common."""

from typing import Protocol, runtime_checkable

import pygame

from game.input.signals import Signal


class Screen(Protocol):
    """One screen. Methods that return a screen return the one to go on with: itself, another, or None to leave the game."""

    def answer(self, signal: Signal, size: tuple[int, int]) -> "Screen | None":
        """React to the player. size: of the surface that is drawn on, pixels."""

    def advance(self, seconds: float, size: tuple[int, int]) -> "Screen | None":
        """Let time pass."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw everything."""


@runtime_checkable
class Listener(Protocol):
    """A screen that hears the window's events themselves instead of what the game's keys mean: one can type there."""

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> "Screen | None":
        """React to an event. pixels_per_point: pixels of the surface per unit of the mouse's coordinates, across and down."""
