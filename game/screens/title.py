"""The title: a game that plays itself, and the levels to choose from."""

import pygame

from game.drawing.camera import Camera, layout, unit_of
from game.drawing.canvas import Canvas
from game.drawing.raster.primitives import draw_box
from game.input.key_names import key_name
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.demo import Demo
from game.screens.help import Help
from game.screens.panel import index_at
from game.screens.play import PlayScreen
from game.screens.settings_panel import SettingsPanel
from game.screens.thumbnail import thumbnail

NAME = "POLAR BREAKOUT"
# Lengths are in units of text.
_NAME, _NAME_SHARE, _NAME_SPACING = 3.8, 1.0 / 11.0, 0.12
"""Size of the name's letters, their largest share of the surface's width, and the gaps between them in shares of their size."""
_NAME_TOP, _DEMO_TOP, _DEMO_GAP = 1.0, 5.0, 0.8
"""From the surface's top to the name and to the demonstration, and from that to the cards."""
_CARD, _CARD_GAP, _CARDS_MARGIN, _CARDS_BOTTOM = 5.6, 0.7, 1.0, 7.8
"""Side of a card, between two, beside all of them, and from their pictures to the surface's lower edge."""
_CARD_CORNER, _CARD_EDGE, _CHOSEN_EDGE, _CARD_MARGIN = 0.6, 0.06, 0.16, 0.4
"""Radius of a card's corners, widths of its edge, and from the edge to the picture."""
_NUMBER, _NUMBER_BOTTOM, _NUMBER_HEIGHT = 1.1, 0.3, 1.1
"""Size of a level's number, from it to the card's lower edge, and how much a card is higher for it than wide."""
_LEVEL_NAME, _DESCRIPTION, _KEYS = 1.5, 1.05, 0.95
"""Sizes of letters."""
_LEVEL_TOP, _LINE_GAP, _KEYS_BOTTOM = 0.5, 0.2, 0.8
"""From the cards to the level's name, between the lines below, and from the keys to the surface's lower edge."""
_DESCRIPTION_WIDTH = 0.9
"""Share of the surface's width."""
_MOST_PICTURES = 64
"""Pictures of levels cached."""


class Title:
    """Shows the levels over a demonstration of the chosen one."""

    def __init__(self, state: AppState) -> None:
        """Open with the level chosen last."""
        self._state = state
        self._pictures: dict[tuple[int, int, int], pygame.Surface] = {}
        self._demo = self._new_demo()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Choose a level, start it, or leave."""
        count = len(self._state.catalogue)
        match signal:
            case Pressed(Action.LEFT | Action.UP):
                self._choose((self._state.chosen - 1) % count)
            case Pressed(Action.RIGHT | Action.DOWN):
                self._choose((self._state.chosen + 1) % count)
            case Pressed(Action.CONFIRM | Action.SERVE):
                return self._started()
            case Pressed(Action.HELP):
                return Help(self._state, self)
            case Pressed(Action.SETTINGS):
                return SettingsPanel(self._state, self)
            case Pressed(Action.BACK):
                return None
            case Moved(pixel) if (index := index_at(self._cards(size), pixel)) is not None:
                self._choose(index)
            case Clicked(pixel) if (index := index_at(self._cards(size), pixel)) is not None:
                self._choose(index)
                return self._started()
        return self

    def advance(self, seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Let the demonstration play."""
        self._demo.advance(seconds, self._state.settings.shown)
        if self._demo.ended:
            self._demo = self._new_demo()
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The demonstration, the name, the levels, what the keys do."""
        scene = self._demo.scene()._replace(aim=None, pops=())
        canvas = self._state.canvas(surface, self._demo_camera(surface.get_size(), scene.ground_radius))
        self._state.painter.paint(canvas, scene)
        theme, unit, (width, height) = canvas.theme, canvas.unit, canvas.size
        middle, cards = width / 2.0, self._cards(canvas.size)
        name = min(_NAME, width / unit * _NAME_SHARE)
        canvas.write(NAME, name, theme.text, complex(middle, unit * _NAME_TOP), "midtop", _NAME_SPACING)
        self._draw_cards(canvas, cards)
        level = self._state.catalogue[self._state.chosen]
        under = complex(middle, cards[0].bottom + unit * _LEVEL_TOP)
        box = canvas.write(level.name, _LEVEL_NAME, theme.accent, under, "midtop")
        for line in canvas.type.wrapped(level.description, unit * _DESCRIPTION, width * _DESCRIPTION_WIDTH):
            under = complex(middle, box.bottom + unit * _LINE_GAP)
            box = canvas.write(line, _DESCRIPTION, theme.text, under, "midtop")
        canvas.write(_keys_help(), _KEYS, theme.faint, complex(middle, height - unit * _KEYS_BOTTOM), "midbottom")

    def _demo_camera(self, size: tuple[int, int], ground_radius: float) -> Camera:
        """The camera that shows the demonstration between the name and the cards."""
        width, height = size
        unit = unit_of(size)
        above, below = unit * _DEMO_TOP, height - self._cards(size)[0].top + unit * _DEMO_GAP
        fitted = layout((width, max(round(height - above), 1)), ground_radius, below).camera
        return fitted._replace(centre=complex(width / 2.0, above + (height - above - below) / 2.0))

    def _draw_cards(self, canvas: Canvas, cards: list[pygame.Rect]) -> None:
        """A picture of every level, the chosen one framed. cards: their boxes, pixels."""
        theme, unit = canvas.theme, canvas.unit
        for index, card in enumerate(cards):
            chosen = index == self._state.chosen
            colour, edge = (theme.accent, theme.accent) if chosen else (theme.faint, theme.panel_edge)
            line = _CHOSEN_EDGE if chosen else _CARD_EDGE
            draw_box(canvas.surface, card, unit * _CARD_CORNER, theme.panel, edge, unit * line)
            picture = self._picture(index, card.width - round(unit * 2.0 * _CARD_MARGIN))
            corner = (card.centerx, card.top + round(unit * _CARD_MARGIN))
            canvas.surface.blit(picture, picture.get_rect(midtop=corner))
            pixel = complex(card.centerx, card.bottom - unit * _NUMBER_BOTTOM)
            canvas.write(str(index + 1), _NUMBER, colour, pixel, "midbottom")

    def _cards(self, size: tuple[int, int]) -> list[pygame.Rect]:
        """Where the levels' cards are, pixels: a row in the lower half."""
        unit, count = unit_of(size), len(self._state.catalogue)
        gap = unit * _CARD_GAP
        side = min((size[0] - unit * 2.0 * _CARDS_MARGIN - gap * (count - 1)) / count, unit * _CARD)
        side = max(side, 1.0)
        top = size[1] - unit * _CARDS_BOTTOM - side
        left = (size[0] - side * count - gap * (count - 1)) / 2.0
        tall = round(side + unit * _NUMBER_HEIGHT)
        return [pygame.Rect(round(left + index * (side + gap)), round(top), round(side), tall) for index in range(count)]

    def _picture(self, index: int, side: int) -> pygame.Surface:
        """A level's picture, drawn once per size and theme. side: pixels."""
        key = (index, side, id(self._state.theme))
        if key not in self._pictures:
            if len(self._pictures) >= _MOST_PICTURES:
                self._pictures.clear()
            self._pictures[key] = thumbnail(self._state.catalogue[index], side, self._state.theme)
        return self._pictures[key]

    def _choose(self, index: int) -> None:
        """Choose another level, and show its demonstration."""
        if index != self._state.chosen:
            self._state.chosen = index
            self._demo = self._new_demo()

    def _new_demo(self) -> Demo:
        """The chosen level, to be played from its beginning."""
        return Demo(self._state.catalogue[self._state.chosen], self._state.seed)

    def _started(self) -> Screen:
        """The game from the chosen level on."""
        return PlayScreen(self._state, self._state.catalogue[self._state.chosen :])


def _keys_help() -> str:
    """The main keys, as the player's layout writes them."""
    named = f"{key_name(Action.HELP)}: help     {key_name(Action.SETTINGS)}: settings"
    return f"Enter or click: play     Arrows: choose     {named}     F11: full screen     Esc: quit"
