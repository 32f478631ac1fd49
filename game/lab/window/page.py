"""How the window is divided, and the words around the picture: title above, formula and deciding line below."""

from typing import NamedTuple

import pygame

from game.drawing.camera import Camera, unit_of
from game.drawing.palette import Theme
from game.drawing.text import Type
from game.lab.kit.beyond_the_source import rows_line
from game.lab.kit.picture import Picture, Toggle
from game.lab.kit.scene import Scene
from game.lab.window.canvas import Canvas, draw_marks, write_beside

_BODY = 0.8
"""Size of the lab's text in the game's."""
_LEAST = 14.5
"""Pixels: nobody reads smaller letters from a chair."""
_SMALLEST = (640, 480)
"""Of a smaller window, the rest is cut off."""
_HEAD, _TALL_HEAD, _NARROW = 5.8, 6.6, 40.0
"""Height of the title and the idea, and that where they have little width, in sizes of text."""
_LINES, _MORE_LINES = 8.2, 9.3
"""Lines of formula and notes, and those where they have little width."""


class Page(NamedTuple):
    """Where everything is, pixels."""

    size: tuple[int, int]
    unit: float  # size of body text
    head: pygame.Rect
    world: pygame.Rect
    words: pygame.Rect
    side: pygame.Rect  # sliders and buttons


def page(size: tuple[int, int]) -> Page:
    """The division of a surface."""
    width, height = max(size[0], _SMALLEST[0]), max(size[1], _SMALLEST[1])
    unit = max(unit_of((width, height)) * _BODY, _LEAST)
    side = min(max(round(unit * 20.0), round(width * 0.24)), round(width * 0.4))
    left = width - side
    tall, lines = (_HEAD, _LINES) if left > _NARROW * unit else (_TALL_HEAD, _MORE_LINES)
    head = round(unit * tall)
    words = round(unit * (1.25 * lines + 1.0))
    return Page(
        (width, height),
        unit,
        pygame.Rect(0, 0, left, head),
        pygame.Rect(0, head, left, max(height - head - words, 1)),
        pygame.Rect(0, height - words, left, words),
        pygame.Rect(left, 0, side, height),
    )


def panes(place: Page, count: int) -> list[pygame.Rect]:
    """The world's area in equal parts, side by side."""
    width = place.world.width / count
    return [
        pygame.Rect(round(k * width), place.world.top, round((k + 1) * width) - round(k * width), place.world.height)
        for k in range(count)
    ]


def draw_picture(
    surface: pygame.Surface,
    place: Page,
    picture: Picture,
    cameras: list[Camera],
    theme: Theme,
    type_: Type,
    shown: frozenset[Toggle],
) -> None:
    """The worlds, side by side, each with its title."""
    for pane, area, camera in zip(picture.panes, panes(place, len(picture.panes)), cameras, strict=True):
        pygame.draw.rect(surface, theme.ground, area)
        canvas = Canvas(surface, area, camera, theme, type_, place.unit, shown)
        draw_marks(canvas, pane.marks)
        if pane.title:
            spot = complex(area.centerx, area.top + place.unit * 0.4)
            write_beside(canvas, spot, pane.title, theme.text, "midtop")
        if area.left > place.world.left:
            pygame.draw.line(surface, theme.panel_edge, area.topleft, area.bottomleft)


def draw_side(surface: pygame.Surface, place: Page, top: float, lines: tuple[str, ...], theme: Theme, type_: Type) -> None:
    """Small lines below the widgets: tick, hash, share line. They lie lower where there is room."""
    unit = place.unit * 0.85
    edge, width = place.side.left + place.unit * 0.8, place.side.width - place.unit * 1.6
    broken = [piece for line in lines for piece in _broken(type_, line, unit, width)]
    start = max(top + place.unit * 0.3, place.size[1] - place.unit * 0.6 - 1.25 * unit * len(broken))
    for number, piece in enumerate(broken):
        type_.write(surface, piece, unit, theme.faint, complex(edge, start + 1.25 * unit * number))


def draw_head(surface: pygame.Surface, place: Page, scene: Scene, theme: Theme, type_: Type) -> float:
    """The title, the idea, and what of it goes beyond the source; where they end, pixels."""
    unit = place.unit
    pygame.draw.rect(surface, theme.background, place.head)
    edge, width = unit * 0.9, place.head.width - 1.8 * unit
    top = type_.write(surface, scene.title, unit * 1.35, theme.text, complex(edge, unit * 0.45)).bottom + unit * 0.25
    for text, colour in ((scene.idea, theme.text), (rows_line(scene.rows), theme.faint)):
        top = _lines(surface, type_, text, colour, complex(edge, top), (unit * 0.95, width))
    return top


def draw_words(surface: pygame.Surface, place: Page, picture: Picture, theme: Theme, type_: Type) -> float:
    """The formula, what decided, and what is special; where they end, pixels."""
    unit = place.unit
    pygame.draw.rect(surface, theme.background, place.words)
    edge, width = unit * 0.9, place.words.width - 1.8 * unit
    top = place.words.top + unit * 0.5
    for line in picture.formula:
        top = _lines(surface, type_, line, theme.text, complex(edge, top), (unit, width))
    top += unit * 0.25
    decided = f"{picture.cited.where}:  {picture.cited.text}"
    top = _lines(surface, type_, decided, theme.faint, complex(edge, top), (unit, width))
    return _lines(surface, type_, picture.note, theme.accent, complex(edge, top), (unit, width))


def _lines(
    surface: pygame.Surface, type_: Type, text: str, colour: tuple[int, int, int], spot: complex, measure: tuple[float, float]
) -> float:
    """A text in lines; where the next one begins. measure: size of the letters and width of a line, pixels."""
    unit, width = measure
    top = spot.imag
    for line in type_.wrapped(text, unit, width):
        type_.write(surface, line, unit, colour, complex(spot.real, top))
        top += unit * 1.25
    return top


def _broken(type_: Type, text: str, unit: float, width: float) -> list[str]:
    """A text without spaces in lines no wider than `width` pixels, broken after "&" where that will do."""
    if " " in text:
        return type_.wrapped(text, unit, width)
    return [line.replace("& ", "&") for line in type_.wrapped(text.replace("&", "& "), unit, width)]
