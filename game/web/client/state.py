"""What all of the page's screens share, and what a screen of the page is."""

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

from game.drawing.camera import Camera, Layout, layout, unit_of
from game.drawing.palette import Theme
from game.input.keys import KEYS
from game.input.players import Players
from game.input.signals import Signal
from game.input.view import FLAT, Viewpoint
from game.lab.kit.second_engine import Engine
from game.language import choose
from game.levels import Level, campaign
from game.overlay.toast import Toast
from game.picture.arena import ArenaPicture
from game.picture.display_list import DisplayList
from game.picture.view import ArenaView
from game.rules import Ruleset, Ticked
from game.scene import Scene
from game.screens.demo import Demo
from game.screens.difficulty_names import SOURCE, ruleset_of
from game.settings.file import SettingsFile
from game.settings.values import Settings
from game.storage.storage import Storage
from game.web.client.functions.panel import OwnFunctionsPanel
from game.web.client.keys import page_bindings
from game.web.client.messages import Download, PageItem, PageMenu
from game.web.client.music import MusicOnPage
from game.web.client.sounds import Sounds

_SMALLEST = 16.0
"""CSS pixels of the unit of text, at least."""
_NARROW, _LOW, _BUTTONS = 640.0, 480.0, 136.0
"""CSS pixels: width up to which the buttons are at the lower edge, unless the page is at most so high; and from that edge to
the top of buttons with two lines."""


class PageScreen(Protocol):
    """What can be on the page."""

    @property
    def menu(self) -> PageMenu | None:
        """The controls beside or over the picture; None for none."""

    @property
    def toolbar(self) -> tuple[PageItem, ...]:
        """Buttons that are always there."""

    def answer(self, signal: Signal, size: tuple[int, int]) -> "PageScreen":
        """The screen after a signal."""

    def choose(self, item: str, value: str) -> "PageScreen":
        """The screen after a control was used. item: its id."""

    def advance(self, seconds: float, size: tuple[int, int]) -> "PageScreen":
        """The screen some time later."""

    def draw(self, out: "Pictures", size: tuple[int, int]) -> None:
        """Show it."""

    @property
    def fragment(self) -> str:
        """What the address of the page is to say about it."""

    @property
    def described(self) -> str:
        """What the picture shows, in words."""


@dataclass
class Pictures:
    """What a screen draws. backdrop: what seldom changes, the very same list as long as it has not; frame: painted over it."""

    backdrop: DisplayList
    frame: DisplayList


@dataclass
class PageState:
    """The state that all screens share. folder: of stored files; None if nothing can be stored.

    players: how many steer the paddles of new games. levels: of the campaign. own: the player's, by the names of their files.
    density: pixels of the canvas per CSS pixel. notifications: lines for the player to read for a moment.
    announcements: for a screen reader. started: sounds to be played now.
    engine: the lab's second engine, once it is loaded; asks_engine: whether to load it.
    functions: the player's own, in the editor. changed: whether what is stored has changed. download: a file for the player.
    full_screen: whether to switch full screen on or off. touched: whether it is played by touch.
    toast: words about a key, which are drawn for a moment. demo: the demonstration behind menus.
    """

    sounds: Sounds
    folder: Path | None
    storage: Storage
    settings_file: SettingsFile | None
    settings: Settings
    seed: Callable[[], int]
    levels: tuple[Level, ...] = field(default_factory=campaign)
    own: dict[str, Level] = field(default_factory=dict)
    ruleset: Ruleset = field(default_factory=Ruleset)
    players: Players = Players.ONE
    view: Viewpoint = FLAT
    density: float = 1.0
    arena: ArenaPicture = field(default_factory=ArenaPicture)
    notifications: list[str] = field(default_factory=list)
    announcements: list[str] = field(default_factory=list)
    started: list[tuple[int, float, float]] = field(default_factory=list)
    changed: bool = False
    music: MusicOnPage = field(default_factory=MusicOnPage)
    functions: OwnFunctionsPanel = field(default_factory=OwnFunctionsPanel)
    download: Download | None = None
    full_screen: bool = False
    touched: bool = False
    engine: Engine | None = None
    asks_engine: bool = False
    problems: set[str] = field(default_factory=set)
    toast: Toast | None = None
    demo: Demo | None = None

    @property
    def theme(self) -> Theme:
        """The colours."""
        return self.settings.theme

    @property
    def difficulty(self) -> str:
        """The name under which scores and bests of new games are kept."""
        return self.ruleset.difficulty.name.lower() if self.ruleset.arcade else SOURCE

    @property
    def game_rules(self) -> Ruleset:
        """The rules of new games: two opponents need the arcade rules."""
        versus = self.players == Players.VERSUS
        return self.ruleset._replace(versus=versus, arcade=self.ruleset.arcade or versus)

    def text_unit(self, size: tuple[int, int]) -> float:
        """Size of text, pixels: never too small to be read on a phone."""
        return self.scene_unit(size) * self.settings.text_size / 100.0

    def scene_unit(self, size: tuple[int, int]) -> float:
        """Size of text beside the arena, pixels."""
        return max(unit_of(size), _SMALLEST * self.density)

    def buttons_below(self, size: tuple[int, int]) -> float:
        """Height of the page's buttons with what is below them, if its style sheet has them at the lower edge; else 0."""
        width, height = size[0] / self.density, size[1] / self.density
        below = width <= height or (width <= _NARROW and height > _LOW)
        return _BUTTONS * self.density if below else 0.0

    def choose_difficulty(self, name: str) -> None:
        """Let new games be of a difficulty."""
        self.ruleset = ruleset_of(name)

    def change(self, settings: Settings) -> None:
        """Let other settings hold, and keep them."""
        self.use(settings)
        if self.settings_file is not None:
            self.settings_file.keep(settings)
            self.changed = True

    def use(self, settings: Settings) -> None:
        """Let settings hold, for keys and texts, too."""
        self.settings = settings
        KEYS.change(page_bindings(settings.own_keys))
        choose(settings.language)

    def layout(self, size: tuple[int, int], ground_radius: float) -> Layout:
        """Where everything is on the canvas."""
        return self.view.seen(layout(size, ground_radius))

    def draw_scene(self, out: Pictures, scene: Scene, camera: Camera, size: tuple[int, int]) -> None:
        """Show a scene."""
        seen = ArenaView(camera, self.theme, self.scene_unit(size), size, self.settings.trail, self.settings.ball)
        out.backdrop = self.arena.backdrop(scene, seen)
        out.frame = self.arena.frame(scene, seen)

    def play_sounds(self, ticked: Ticked, camera: Camera) -> None:
        """Begin the sounds of a tick, each where its event is on the screen."""
        if ticked.events and self.settings.sound and self.settings.volume:
            reach = ticked.game.level.ground_radius
            now = time.monotonic()
            self.started += self.sounds.started(
                ticked.events, lambda position: camera.side(position, reach), ticked.game.combo, now
            )

    def end_game(self) -> None:
        """Store the game that was played, if it is worth it, with the bests made in it."""
        self.storage.game_done()
        self.changed = True
        self.notify_problems()

    def notify_problems(self) -> None:
        """Say once what could not be read or written."""
        settings = None if self.settings_file is None else self.settings_file.problem
        for line in [*([] if settings is None else [settings]), *self.storage.problems]:
            if line not in self.problems:
                self.problems.add(line)
                self.notifications.append(line)
