"""The title: a demonstration game, the name, and buttons for everything else."""

import pygame

from game.drawing.camera import Camera, unit_of
from game.drawing.canvas import Canvas
from game.input.keys import Action
from game.language import tr
from game.levels import from_level
from game.levels.names import level_name
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.demo import Demo
from game.screens.menus.credits import Credits
from game.screens.menus.endless import endless_menu
from game.screens.menus.help.panel import Help
from game.screens.menus.high_scores import HighScores
from game.screens.menus.level_select import LevelSelect, next_level
from game.screens.menus.replays import Replays
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.items.basic import ButtonItem, Item
from game.screens.toolkit.layout import Content, FormLayout
from game.screens.toolkit.menu import Entry, Menu
from game.screens.toolkit.panel import Panel

NAME = ("POLAR", "BREAKOUT")
# Lengths are in units of text.
_NAME, _NAME_SPACING, _NAME_PITCH = 4.2, 0.12, 4.0
"""Size of the name's letters, the gaps between them in shares of their size, and from line to line."""
_NAME_TOP, _LEFT, _COLUMN = 1.7, 2.2, 15.0
"""From the surface's upper edge to the name, from its left edge to name and buttons, and width of these."""
_INSET = 2.9
"""From the edge of the buttons' room to their words."""
_BUTTONS_TOP = 9.4
"""From the surface's upper edge to the room of the buttons."""
_WIDE = 1.2
"""Aspect ratio from which the demonstration has its own part of the surface, at the right."""
_DEMO_RADIUS = 0.475
"""Of the ground, in shares of the surface's height, or of the width that is left."""
_VEIL = 185
"""How much the demonstration is covered where the buttons stand over it, of 255."""
_STILL_SECONDS = 6.0
"""With reduced motion: the moment of the demonstration that is shown."""
_STEP = 0.25


class Title(Panel):
    """Buttons beside a demonstration."""

    rate = 30
    """Pictures per second: it is looked at in passing."""

    def __init__(self, state: AppState) -> None:
        """Open with the level playing that is to be played next."""
        super().__init__(state, None)
        self._shown = 0
        self._demo = self._new_demo()

    @property
    def appearance(self) -> tuple[object, ...]:
        """As of every panel, and the demonstration's frame: it moves."""
        return *super().appearance, self._shown

    def content(self) -> Content:
        """The buttons."""
        state = self.state
        following = level_name(state.catalogue[next_level(state)].name)
        items: tuple[Item, ...] = (
            ButtonItem(tr("Play"), self._play, note=following, large=True),
            ButtonItem(tr("Levels"), lambda: LevelSelect(state, self)),
            ButtonItem(tr("Endless"), lambda: endless_menu(state, self)),
            ButtonItem(tr("High scores"), lambda: HighScores(state, self)),
            ButtonItem(tr("Replays"), lambda: Replays(state, self)),
            ButtonItem(tr("How to play"), lambda: Help(state, self), Action.HELP),
            ButtonItem(tr("Settings"), lambda: SettingsPanel(state, self), Action.SETTINGS),
            ButtonItem(tr("Credits"), lambda: Credits(state, self)),
            ButtonItem(tr("Quit"), lambda: None),
        )
        return Content("", tuple([(item,) for item in items]), width=_COLUMN + 2.0 * _INSET)

    def back(self) -> Screen | None:
        """Esc asks first."""
        entries = (Entry(tr("Stay"), lambda: self), Entry(tr("Quit"), lambda: None))
        return Menu(self.state, self, tr("Leave the game?"), (), entries, back=lambda: self)

    def area(self, size: tuple[int, int]) -> pygame.Rect:
        """The column below the name; in the middle of a narrow surface."""
        unit, (width, height) = self.unit(size), size
        top = round(unit_of(size) * _BUTTONS_TOP)
        left = unit_of(size) * _LEFT - unit * _INSET if _is_wide(size) else (width - unit * _COLUMN) / 2.0 - unit * _INSET
        room = max(min(round(unit * (_COLUMN + 2.0 * _INSET)), round(width - left)), 1)
        return pygame.Rect(round(left), top, room, max(height - top, 1))

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Advance the demonstration."""
        if not self.state.settings.reduced_motion:
            self._demo.advance(seconds, self.state.settings.shown)
            self._shown += 1
            if self._demo.ended:
                self._demo = self._new_demo()
        return super().advance(seconds, size)

    def draw_behind(self, surface: pygame.Surface) -> None:
        """Draw the demonstration, dimmed if the buttons are over it."""
        self.draw_ground(surface)
        if not _is_wide(surface.get_size()):
            veil = pygame.Surface(surface.get_size(), 0, surface)
            veil.fill(self.state.theme.background)
            veil.set_alpha(_VEIL)
            surface.blit(veil, (0, 0))

    def draw_ground(self, surface: pygame.Surface) -> None:
        """Draw the demonstration alone."""
        size, state = surface.get_size(), self.state
        scene = self._demo.scene()._replace(aim=None, pops=())
        canvas = state.canvas(surface, _demo_camera(size, self.unit(size), scene.ground_radius))
        state.painter.paint(canvas, scene)

    def draw_plate(self, canvas: Canvas, _content: Content, layout: FormLayout) -> None:
        """Draw the name, instead of a panel's plate."""
        unit, wide = unit_of(canvas.size), _is_wide(canvas.size)
        canvas = canvas._replace(unit=unit)
        for index, (word, colour) in enumerate(zip(NAME, (canvas.theme.text, canvas.theme.accent), strict=True)):
            x = unit * _LEFT if wide else canvas.size[0] / 2.0
            pixel = complex(x, unit * (_NAME_TOP + _NAME_PITCH * index))
            canvas.write(word, _NAME, colour, pixel, "topleft" if wide else "midtop", _NAME_SPACING)
        layout.close.size = (0, 0)

    def _play(self) -> Screen:
        """The campaign from the first level that was not finished yet."""
        state = self.state
        state.chosen = next_level(state)
        return PlayScreen(state, from_level(state.chosen, state.catalogue))

    def _new_demo(self) -> Demo:
        """Begin a new demonstration, with the level after the last one's."""
        state = self.state
        index = (next_level(state) + self._shown) % len(state.catalogue)
        demo = Demo(state.catalogue[index], state.seed)
        if state.settings.reduced_motion:
            for _ in range(round(_STILL_SECONDS / _STEP)):
                demo.advance(_STEP, frozenset())
        return demo


def _is_wide(size: tuple[int, int]) -> bool:
    """Whether there is room for the demonstration beside the buttons."""
    return size[0] > size[1] * _WIDE


def _demo_camera(size: tuple[int, int], unit: float, ground_radius: float) -> Camera:
    """The camera that shows the demonstration: at the right, its edge perhaps beyond the surface's; else in the middle.

    unit: size of the buttons' text, pixels.
    """
    width, height = size
    if not _is_wide(size):
        return Camera(complex(width, height) / 2.0, max(min(size) * _DEMO_RADIUS / ground_radius, 1e-3))
    radius = height * _DEMO_RADIUS
    left = unit * (_LEFT + _COLUMN + 3.5)
    middle = max(left + radius, (left + width) / 2.0)
    return Camera(complex(middle, height / 2.0), max(radius / ground_radius, 1e-3))
