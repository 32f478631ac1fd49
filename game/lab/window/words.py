"""The words around the picture: title and idea above; formula, cited line and note below; small print; notices."""

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.drawing.palette import Colour, Theme
from game.drawing.text import Type
from game.lab.kit.differences import differences_line
from game.lab.kit.picture import Picture
from game.lab.kit.scene import LabScene
from game.lab.window.layout import WindowLayout

_LINE = 1.25
"""Height of a line of text in the size of its letters."""
_SMALL, _SMALL_EDGE, _SMALL_ABOVE, _SMALL_BELOW = 0.85, 0.8, 0.3, 0.6
"""Of small print: size of letters, and from it to the edges, to what is above it, and to the window's lower edge; in units."""
_BETWEEN = "      "
"""Between formulas on one line."""


class TextSheet(NamedTuple):
    """What words are written on and with: a surface, its division, colours and letters."""

    surface: pygame.Surface
    layout: WindowLayout
    theme: Theme
    type: Type

    @property
    def unit(self) -> float:
        """Size of body text, pixels."""
        return self.layout.unit


def draw_head(sheet: TextSheet, scene: LabScene, step: str = "") -> float:
    """The title, the idea, and where it goes beyond the source; returns where they end, pixels. step: the one shown last."""
    unit, theme, head = sheet.unit, sheet.theme, sheet.layout.head
    pygame.draw.rect(sheet.surface, theme.background, head)
    title = sheet.type.write(sheet.surface, scene.title, unit * 1.35, theme.text, complex(unit * 0.9, unit * 0.45))
    room = head.right - unit * 0.9 - title.right - unit
    if step and sheet.type.rendered(step, unit, theme.accent).get_width() <= room:
        sheet.type.write(sheet.surface, step, unit, theme.accent, complex(head.right - unit * 0.9, title.bottom), "bottomright")
    top = title.bottom + unit * 0.25
    for text, colour in ((scene.idea, theme.text), (differences_line(scene.rows), theme.faint)):
        top = _write_lines(sheet, text, colour, top, unit * 0.95)
    return top


def draw_words(sheet: TextSheet, picture: Picture) -> float:
    """The formula, the cited line, and the note; returns where they end, pixels.

    Where there is too little room, formulas stand beside each other; where that is not enough, the first are left out.
    """
    unit, theme, area = sheet.unit, sheet.theme, sheet.layout.words
    pygame.draw.rect(sheet.surface, theme.background, area)
    cited = "" if picture.cited is None else f"{picture.cited.where}:  {picture.cited.text}"
    width = sheet.layout.side.left - 1.8 * unit
    below = [(line, theme.faint) for line in sheet.type.wrapped(cited, unit, width)]
    below += [(line, theme.accent) for line in sheet.type.wrapped(picture.note, unit, width)]
    room = area.height - unit * 0.75 - unit * _LINE * len(below)
    lines = _fitting(sheet.type, picture.formula, unit, width, int(room / (unit * _LINE)))
    top = area.top + unit * 0.5
    for line in lines:
        top = _write_line(sheet, line, theme.text, top)
    top += unit * 0.25
    for line, colour in below:
        top = _write_line(sheet, line, colour, top)
    return top


def _fitting(type_: Type, lines: Sequence[str], size: float, width: float, most: int) -> list[str]:
    """Formulas on at most so many lines, if need be several on a line, the first ones left out."""
    found = [part for line in lines for part in type_.wrapped(line, size, width)]
    if len(found) <= most:
        return found
    joined: list[str] = []
    for line in lines:
        longer = f"{joined[-1]}{_BETWEEN}{line}" if joined else line
        if joined and type_.rendered(longer, size, (0, 0, 0)).get_width() <= width:
            joined[-1] = longer
        else:
            joined += type_.wrapped(line, size, width)
    return joined[-most:] if most > 0 else []


def draw_small_print(sheet: TextSheet, top: float, lines: tuple[str, ...]) -> None:
    """Small lines below the controls, which end at `top`: at the bottom of the side, as far as there is room."""
    wrapped, size = _small_lines(sheet.type, sheet.layout, lines), sheet.unit * _SMALL
    left, height = sheet.layout.side.left + sheet.unit * _SMALL_EDGE, _LINE * size * len(wrapped)
    start = max(top + sheet.unit * _SMALL_ABOVE, sheet.layout.size[1] - sheet.unit * _SMALL_BELOW - height)
    for number, part in enumerate(wrapped):
        sheet.type.write(sheet.surface, part, size, sheet.theme.faint, complex(left, start + _LINE * size * number))


def small_print_height(type_: Type, layout: WindowLayout, lines: tuple[str, ...]) -> float:
    """Height that small lines take at the bottom of the side, pixels."""
    count = len(_small_lines(type_, layout, lines))
    return layout.unit * (_SMALL_ABOVE + _LINE * _SMALL * count + _SMALL_BELOW)


def _small_lines(type_: Type, layout: WindowLayout, lines: tuple[str, ...]) -> list[str]:
    """Small lines as wide as the side."""
    size, width = layout.unit * _SMALL, layout.side.width - 2.0 * layout.unit * _SMALL_EDGE
    return [part for line in lines for part in _wrapped_anywhere(type_, line, size, width)]


def draw_notice(sheet: TextSheet, text: str, bottom: float) -> float:
    """A notice on a plate over the world that ends at `bottom`; returns where the plate begins, pixels."""
    unit, theme, area = sheet.unit, sheet.theme, sheet.layout.world
    lines = sheet.type.wrapped(text, unit, area.width - 4.0 * unit)
    height = round(unit * (1.3 * len(lines) + 0.6))
    width = max([sheet.type.rendered(line, unit, theme.accent).get_width() for line in lines]) + round(1.6 * unit)
    plate = pygame.Rect(0, 0, width, height)
    plate.midbottom = (area.centerx, round(bottom))
    pygame.draw.rect(sheet.surface, theme.panel, plate, 0, round(unit * 0.5))
    pygame.draw.rect(sheet.surface, theme.accent, plate, max(1, round(unit * 0.08)), round(unit * 0.5))
    for k, line in enumerate(lines):
        pixel = complex(plate.centerx, plate.top + unit * (0.45 + 1.3 * k))
        sheet.type.write(sheet.surface, line, unit, theme.text, pixel, "midtop")
    return float(plate.top)


def _write_lines(sheet: TextSheet, text: str, colour: Colour, top: float, size: float) -> float:
    """A text in as many lines as it needs beside the controls; returns where the next line begins. size: of letters, pixels."""
    edge = sheet.unit * 0.9
    for line in sheet.type.wrapped(text, size, sheet.layout.side.left - 2.0 * edge):
        sheet.type.write(sheet.surface, line, size, colour, complex(edge, top))
        top += size * _LINE
    return top


def _write_line(sheet: TextSheet, line: str, colour: Colour, top: float) -> float:
    """One line; returns where the next one begins."""
    sheet.type.write(sheet.surface, line, sheet.unit, colour, complex(sheet.unit * 0.9, top))
    return top + sheet.unit * _LINE


def _wrapped_anywhere(type_: Type, text: str, size: float, width: float) -> list[str]:
    """A text in lines no wider than `width` pixels; a share line, which has no spaces, is broken after each "&"."""
    if " " in text:
        return type_.wrapped(text, size, width)
    return [line.replace("& ", "&") for line in type_.wrapped(text.replace("&", "& "), size, width)]
