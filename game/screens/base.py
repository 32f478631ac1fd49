"""What every screen has in common."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol, runtime_checkable

import pygame

from game import second_opinion as opinions
from game.drawing.camera import Camera
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.signals import Signal
from game.input.view import FROM_ABOVE, Viewpoint
from game.levels import Level
from game.overlay.toast import Toast
from game.rules import Controls, Game, Ticked
from game.second_opinion import Compare, Opinions
from game.settings.file import SettingsFile
from game.settings.values import LOUDEST, Settings
from game.sound.mixer import Audio

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
    settings: Settings = field(default_factory=Settings)
    full_screen: bool = False
    view: Viewpoint = FROM_ABOVE
    compare: Compare | None = None  # another engine to ask about contacts
    lab: "Callable[[Shared, Screen], Screen] | None" = None  # opens the lab over a screen
    normals: bool = False  # show what it says
    audio: Audio | None = None
    kept: SettingsFile | None = None  # where settings outlive the session
    toast: Toast | None = None
    painter: Painter = field(default_factory=Painter)
    type: Type = field(default_factory=Type)

    @property
    def theme(self) -> Theme:
        """The colours."""
        return self.settings.theme

    def change(self, settings: Settings, told: Toast | None = None) -> None:
        """Let other settings hold, on the screen and in what sounds now. told: what to say about it."""
        self.settings = settings
        self.painter.theme = settings.theme
        if told is not None:
            self.toast = told
        if self.audio is not None:
            self.audio.muted = not settings.sound
            self.audio.volume = settings.volume / LOUDEST

    def keep(self) -> None:
        """Write the settings down for the next session."""
        if self.kept is not None:
            self.kept.keep(self.settings)

    def heard(self, ticked: Ticked, camera: Camera) -> None:
        """Make the sounds of a tick, each where it is on the screen."""
        if self.audio is not None and ticked.events:
            reach = ticked.game.level.ground_radius
            self.audio.play(ticked.events, lambda position: camera.side(position, reach), ticked.game.combo)

    def opinions(self, shown: tuple[Opinions, ...], ticked: Ticked) -> tuple[Opinions, ...]:
        """The normals to show after a tick: none unless the player wants them."""
        return opinions.after(shown, ticked, self.compare) if self.normals and self.compare is not None else ()


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
