"""The protocols of screens: what the loop asks of every screen, and what some can do besides."""

from typing import Protocol, runtime_checkable

import pygame

from game.input.signals import Signal


class Screen(Protocol):
    """One screen. Methods that return a screen return the next one: itself, another one, or None to leave the game."""

    def answer(self, signal: Signal, size: tuple[int, int]) -> "Screen | None":
        """React to the player. size: of the surface that is drawn on, pixels."""

    def advance(self, seconds: float, size: tuple[int, int]) -> "Screen | None":
        """Let time pass."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw everything."""


@runtime_checkable
class CachedScreen(Protocol):
    """A screen that tells when its picture would be the same as before: then the loop does not draw it again."""

    @property
    def appearance(self) -> tuple[object, ...]:
        """Everything that its picture depends on, except the surface's size: equal values mean the same picture."""


@runtime_checkable
class Listener(Protocol):
    """A screen that receives the events of keyboard and mouse directly, not as signals, so that one can type on it.

    Gamepads and fingers come as signals, as on every screen. For a finger SDL also makes events of a mouse, which it receives,
    too.
    """

    def hear(self, event: pygame.Event, size: tuple[int, int], pixels_per_point: complex) -> "Screen | None":
        """React to an event. pixels_per_point: pixels of the surface per unit of the mouse's coordinates, across and down."""


@runtime_checkable
class Typist(Protocol):
    """A screen on which text is entered: there a letter is text, not a command."""

    def typed(self, event: pygame.Event) -> bool:
        """Take an event as text. Returns whether it was text."""
