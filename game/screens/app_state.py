"""The state that all screens of a session share."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pygame

from game import second_opinion
from game.chosen_physics import SWEPT, ChosenPhysics
from game.drawing.camera import Camera, unit_of
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.input.devices import Devices
from game.input.keys import KEYS
from game.input.players import Players
from game.input.rebinding import bindings, checked
from game.input.view import FLAT, Viewpoint
from game.language import choose, tr_noop
from game.levels import Level
from game.levels.own import OwnLevels
from game.loop.session_seed import game_seed
from game.overlay.toast import Toast
from game.rules import SOURCE_RULES, Controls, Game, Ruleset, Ticked
from game.screens.base import Screen
from game.screens.difficulty_names import SOURCE
from game.screens.level_pictures import LevelPictures
from game.second_opinion import Compare, NormalPair
from game.settings.file import SettingsFile
from game.settings.values import LOUDEST, Settings
from game.sound.mixer import Audio
from game.sound.music.mood import mood_of
from game.storage.storage import Storage
from game.student.functions_file import FunctionsFile

Recorder = Callable[[Controls, Game], None]
"""Told every tick of a played game: its controls, and the game after it. `tick` is 1 after the first tick of a new game."""

_TOLD_SECONDS = 6.0
"""How long is told what is wrong with the kept files."""
_PIXELS = Camera(0j, 1.0)
"""For what is no picture of the world."""


@dataclass(slots=True)
class AppState:
    """What all screens of a session share, from the settings to the sound, and what they do with it.

    catalogue: levels that can be chosen; chosen: index of the chosen one.
    seed: of the session; every new game's seed is derived from it. games: how many have begun.
    open_title: makes the title's screen; home: label of the buttons that lead to it. open_levels: makes the choice of levels
    over it; None if there is none.
    own_levels: reads the player's; open_editor: makes the editor's screen for one of their files, None for a new one, with a
    function that leads back; None where there is no editor.
    storage: scores, progress and finished games.
    recorder: called with every tick that is played; None without.
    autopilot: whether it plays instead of the player.
    physics: moves the balls of new games. ruleset: of new games. players: how many steer the paddles.
    functions: the player's own, which the lab shows beside ours; None without.
    settings: the player's present ones; settings_file: stores them for the next session.
    full_screen: whether the window is; wants_full_screen: whether it shall be, as the settings say; None for no wish.
    settings_tab: index of the part of the settings that was open last.
    view: from where the player looks at the arena.
    compare: asks another engine about contacts; None without one. shows_normals: whether its normals are shown.
    open_lab: makes the lab's screen, over another one; None where there is no lab.
    audio: the sound; None without.
    toast: words that are shown for a moment.
    devices: keyboard, mouse, touch screen and gamepads.
    reported: problems with stored files that were shown already. away: whether another window has the focus.
    shown: the appearance of the picture that is on the window; None if it has to be drawn again.
    painter, type: draw all pictures and all text, and cache them; pictures: those of the levels.
    """

    catalogue: tuple[Level, ...]
    chosen: int
    seed: int
    open_title: "Callable[[AppState], Screen]"
    recorder: Recorder | None = None
    autopilot: bool = False
    settings: Settings = field(default_factory=Settings)
    home: str = tr_noop("Main menu")
    open_levels: "Callable[[AppState], Screen] | None" = None
    own_levels: Callable[[], OwnLevels] = lambda: OwnLevels((), (), ())
    open_editor: "Callable[[AppState, Callable[[], Screen | None], Path | None], Screen] | None" = None
    storage: Storage = field(default_factory=lambda: Storage(None))
    full_screen: bool = False
    wants_full_screen: bool | None = None
    settings_tab: int = 0
    view: Viewpoint = FLAT
    compare: Compare | None = None
    open_lab: "Callable[[AppState, Screen], Screen] | None" = None
    shows_normals: bool = False
    audio: Audio | None = None
    settings_file: SettingsFile | None = None
    toast: Toast | None = None
    reported: set[str] = field(default_factory=set)
    away: bool = False
    shown: object = None
    physics: ChosenPhysics = SWEPT
    functions: FunctionsFile | None = None
    ruleset: Ruleset = SOURCE_RULES
    players: Players = Players.ONE
    games: int = 0
    devices: Devices = field(default_factory=Devices)
    painter: Painter = field(default_factory=Painter)
    type: Type = field(default_factory=Type)
    pictures: LevelPictures = field(default_factory=LevelPictures)

    @property
    def difficulty(self) -> str:
        """The name under which scores and bests of new games are stored."""
        return self.ruleset.difficulty.name.lower() if self.ruleset.arcade else SOURCE

    @property
    def game_rules(self) -> Ruleset:
        """Of new games: two who play against each other need the arcade rules."""
        versus = self.players == Players.VERSUS
        return self.ruleset._replace(versus=versus, arcade=self.ruleset.arcade or versus)

    def next_seed(self) -> int:
        """The seed of the game that begins now."""
        self.games += 1
        return game_seed(self.seed, self.games - 1)

    @property
    def theme(self) -> Theme:
        """The colours."""
        return self.settings.theme

    @property
    def text_scale(self) -> float:
        """The player's text size as a factor of the usual one."""
        return self.settings.text_size / 100.0

    def levels(self) -> Screen:
        """The choice of levels, or the title where there is none."""
        return self.open_title(self) if self.open_levels is None else self.open_levels(self)

    @property
    def appearance(self) -> tuple[object, ...]:
        """The part of this state on which a screen's picture depends, even if nothing moves on it."""
        return self.settings, self.shows_normals, self.full_screen

    def canvas(self, surface: pygame.Surface, camera: Camera = _PIXELS) -> Canvas:
        """A canvas in the settings' colours. camera: of the world; for text and boxes alone the default will do."""
        skins = self.settings.ball, self.settings.trail
        return Canvas(surface, camera, self.theme, self.type, unit_of(surface.get_size()), *skins)

    def words(self, canvas: Canvas) -> Canvas:
        """The same canvas with its unit scaled by the player's text size."""
        return canvas._replace(unit=canvas.unit * self.text_scale)

    def change(self, settings: Settings, message: Toast | None = None) -> None:
        """Apply other settings at once, to colours, sound, keys and language. message: about the change."""
        self.settings = settings
        KEYS.change(bindings(checked(settings.own_keys)))
        choose(settings.language)
        if message is not None:
            self.toast = message
        if self.audio is not None:
            self.audio.muted = not settings.sound
            self.audio.volume = settings.volume / LOUDEST
            self.audio.music_volume = settings.music / LOUDEST

    def save_settings(self) -> None:
        """Write the settings down for the next session."""
        if self.settings_file is not None:
            self.settings_file.keep(self.settings)

    def tell_problem(self) -> None:
        """Say on the screen what could not be saved, once."""
        problems = self.storage.problems
        if problems and problems[-1] not in self.reported:
            self.reported.add(problems[-1])
            self.toast = Toast(problems[-1], left=_TOLD_SECONDS)

    def play_sounds(self, ticked: Ticked, camera: Camera) -> None:
        """Play the sounds of a tick, panned to where their events are on the screen; update the music."""
        if self.audio is None:
            return
        self.audio.follow(mood_of(ticked.game))
        if ticked.events:
            reach = ticked.game.level.ground_radius
            self.audio.play(ticked.events, lambda position: camera.side(position, reach), ticked.game.combo)

    def normals_after(self, shown: tuple[NormalPair, ...], ticked: Ticked) -> tuple[NormalPair, ...]:
        """The normals to show after a tick: none unless the player wants them."""
        if not self.shows_normals or self.compare is None:
            return ()
        return second_opinion.after(shown, ticked, self.compare)
