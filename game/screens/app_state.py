"""What outlives a screen."""

from collections.abc import Callable
from dataclasses import dataclass, field

import pygame

from game import second_opinion
from game.chosen_physics import SWEPT, ChosenPhysics
from game.drawing.camera import Camera, unit_of
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.view import FLAT, Viewpoint
from game.levels import Level
from game.overlay.toast import Toast
from game.rules import SOURCE_RULES, Controls, Game, Ruleset, Ticked
from game.screens.base import Screen
from game.second_opinion import Compare, NormalPair
from game.settings.file import SettingsFile
from game.settings.values import LOUDEST, Settings
from game.sound.mixer import Audio

Recorder = Callable[[Controls, Game], None]
"""Told every tick of a played game: its controls, and the game after it. `tick` is 1 after the first tick of a new game."""

_PIXELS = Camera(0j, 1.0)
"""For what is no picture of the world."""


@dataclass(slots=True)
class AppState:
    """The state that all screens share, and what they do with it.

    catalogue: levels that the title offers; chosen: index of one of them.
    seed: of every new game.
    open_title: makes the title's screen.
    recorder: told every tick that is played; None for nobody.
    autopilot: whether it plays instead of the player.
    physics: that games are flown on. ruleset: of new games.
    settings: the player's, as they hold now; settings_file: where they outlive the session.
    full_screen: whether the window is.
    view: from where the player looks at the arena.
    compare: asks another engine about contacts; None without one. shows_normals: whether its normals are shown.
    open_lab: makes the lab's screen, over another one; None where there is no lab.
    audio: the sound; None without.
    toast: words that are shown for a moment.
    painter, type: draw all pictures and all text, and cache them.
    """

    catalogue: tuple[Level, ...]
    chosen: int
    seed: int
    open_title: "Callable[[AppState], Screen]"
    recorder: Recorder | None = None
    autopilot: bool = False
    settings: Settings = field(default_factory=Settings)
    full_screen: bool = False
    view: Viewpoint = FLAT
    compare: Compare | None = None
    open_lab: "Callable[[AppState, Screen], Screen] | None" = None
    shows_normals: bool = False
    audio: Audio | None = None
    settings_file: SettingsFile | None = None
    toast: Toast | None = None
    physics: ChosenPhysics = SWEPT
    ruleset: Ruleset = SOURCE_RULES
    painter: Painter = field(default_factory=Painter)
    type: Type = field(default_factory=Type)

    @property
    def theme(self) -> Theme:
        """The colours."""
        return self.settings.theme

    @property
    def appearance(self) -> tuple[object, ...]:
        """All of this that may change how a screen that stands still looks."""
        return self.settings, self.shows_normals

    def canvas(self, surface: pygame.Surface, camera: Camera = _PIXELS) -> Canvas:
        """A canvas in the settings' colours. camera: of what is drawn, unless it is text and boxes alone."""
        return Canvas(surface, camera, self.theme, self.type, unit_of(surface.get_size()))

    def change(self, settings: Settings, told: Toast | None = None) -> None:
        """Let other settings hold, on the screen and in what sounds now. told: words to show about it."""
        self.settings = settings
        if told is not None:
            self.toast = told
        if self.audio is not None:
            self.audio.muted = not settings.sound
            self.audio.volume = settings.volume / LOUDEST

    def save_settings(self) -> None:
        """Write the settings down for the next session."""
        if self.settings_file is not None:
            self.settings_file.keep(self.settings)

    def play_sounds(self, ticked: Ticked, camera: Camera) -> None:
        """Make the sounds of a tick, each where its event is on the screen."""
        if self.audio is not None and ticked.events:
            reach = ticked.game.level.ground_radius
            self.audio.play(ticked.events, lambda position: camera.side(position, reach), ticked.game.combo)

    def normals_after(self, shown: tuple[NormalPair, ...], ticked: Ticked) -> tuple[NormalPair, ...]:
        """The normals to show after a tick: none unless the player wants them."""
        if not self.shows_normals or self.compare is None:
            return ()
        return second_opinion.after(shown, ticked, self.compare)
