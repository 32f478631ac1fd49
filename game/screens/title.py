"""The title: a game that plays itself, and the levels to choose from."""

import pygame

from game.drawing.camera import layout, unit_of
from game.drawing.primitives import draw_box
from game.input.key_names import key_name
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.screens.base import Screen, Shared
from game.screens.demo import Demo
from game.screens.panels import Help
from game.screens.play import Play
from game.screens.settings_panel import SettingsPanel
from game.screens.thumbnail import thumbnail

NAME = "POLAR BREAKOUT"


class Title:
    """Shows the levels over a demonstration of the chosen one."""

    def __init__(self, shared: Shared) -> None:
        """Open with the level chosen last."""
        self._shared = shared
        self._pictures: dict[tuple[int, int, int], pygame.Surface] = {}
        self._demo = self._new_demo()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Choose a level, start it, or leave."""
        count = len(self._shared.catalogue)
        match signal:
            case Pressed(Action.LEFT | Action.UP):
                self._choose((self._shared.chosen - 1) % count)
            case Pressed(Action.RIGHT | Action.DOWN):
                self._choose((self._shared.chosen + 1) % count)
            case Pressed(Action.CONFIRM | Action.SERVE):
                return self._started()
            case Pressed(Action.HELP):
                return Help(self._shared, self)
            case Pressed(Action.SETTINGS):
                return SettingsPanel(self._shared, self)
            case Pressed(Action.BACK):
                return None
            case Moved(place) if (index := self._card_at(place, size)) is not None:
                self._choose(index)
            case Clicked(place) if (index := self._card_at(place, size)) is not None:
                self._choose(index)
                return self._started()
        return self

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Let the demonstration play."""
        self._demo.advance(seconds, self._shared.settings.shown)
        if self._demo.ended:
            self._demo = self._new_demo()
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The demonstration, the name, the levels, what the keys do."""
        shared, size = self._shared, surface.get_size()
        theme, type_, unit = shared.theme, shared.type, unit_of(size)
        scene = self._demo.scene()._replace(aim=None, pops=())
        width, height = size
        middle = width / 2.0
        above, below = unit * 5.0, height - self._cards(size)[0].top + unit * 0.8
        small = layout((width, max(round(height - above), 1)), scene.ground_radius, below).camera
        camera = small._replace(centre=complex(middle, above + (height - above - below) / 2.0))
        shared.painter.paint(surface, scene, camera, type_, unit)
        type_.write(surface, NAME, min(unit * 3.8, width / 11.0), theme.text, complex(middle, unit * 1.0), "midtop", 0.12)
        level = shared.catalogue[shared.chosen]
        self._draw_cards(surface)
        under = self._cards(size)[0].bottom + unit * 0.5
        box = type_.write(surface, level.name, unit * 1.5, theme.accent, complex(middle, under), "midtop")
        for line in type_.wrapped(level.description, unit * 1.05, width * 0.9):
            box = type_.write(surface, line, unit * 1.05, theme.text, complex(middle, box.bottom + unit * 0.2), "midtop")
        help_, settings = key_name(Action.HELP), key_name(Action.SETTINGS)
        named = f"{help_}: help     {settings}: settings"
        hint = f"Enter or click: play     Arrows: choose     {named}     F11: full screen     Esc: quit"
        type_.write(surface, hint, unit * 0.95, theme.faint, complex(middle, height - unit * 0.8), "midbottom")

    def _draw_cards(self, surface: pygame.Surface) -> None:
        """A picture of every level, the chosen one framed."""
        theme, type_, unit = self._shared.theme, self._shared.type, unit_of(surface.get_size())
        for index, card in enumerate(self._cards(surface.get_size())):
            chosen = index == self._shared.chosen
            edge = theme.accent if chosen else theme.panel_edge
            draw_box(surface, card, unit * 0.6, theme.panel, edge, unit * (0.16 if chosen else 0.06))
            picture = self._picture(index, card.width - round(unit * 0.8))
            surface.blit(picture, picture.get_rect(midtop=(card.centerx, card.top + round(unit * 0.4))))
            colour = theme.accent if chosen else theme.faint
            place = complex(card.centerx, card.bottom - unit * 0.3)
            type_.write(surface, str(index + 1), unit * 1.1, colour, place, "midbottom")

    def _cards(self, size: tuple[int, int]) -> list[pygame.Rect]:
        """Where the levels' cards are, pixels: a row in the lower half."""
        unit, count = unit_of(size), len(self._shared.catalogue)
        gap = unit * 0.7
        side = min((size[0] - unit * 2.0 - gap * (count - 1)) / count, unit * 5.6)
        side = max(side, 1.0)
        top = size[1] - unit * 7.8 - side
        left = (size[0] - side * count - gap * (count - 1)) / 2.0
        tall = round(side + unit * 1.1)
        return [pygame.Rect(round(left + index * (side + gap)), round(top), round(side), tall) for index in range(count)]

    def _card_at(self, place: complex, size: tuple[int, int]) -> int | None:
        """The card at a pixel."""
        index = pygame.Rect(place.real, place.imag, 1, 1).collidelist(self._cards(size))
        return None if index < 0 else index

    def _picture(self, index: int, side: int) -> pygame.Surface:
        """A level's picture, drawn once per size and theme."""
        key = (index, side, id(self._shared.theme))
        if key not in self._pictures:
            if len(self._pictures) > 64:
                self._pictures.clear()
            self._pictures[key] = thumbnail(self._shared.catalogue[index], side, self._shared.theme)
        return self._pictures[key]

    def _choose(self, index: int) -> None:
        """Another level, and its demonstration."""
        if index != self._shared.chosen:
            self._shared.chosen = index
            self._demo = self._new_demo()

    def _new_demo(self) -> Demo:
        """The chosen level, to be played from its beginning."""
        return Demo(self._shared.catalogue[self._shared.chosen], self._shared.seed)

    def _started(self) -> Screen:
        """The game from the chosen level on."""
        return Play(self._shared, self._shared.catalogue[self._shared.chosen :])
