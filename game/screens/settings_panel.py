"""The settings over another screen: what every one means, and what it is now."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.palette import mixed
from game.drawing.primitives import draw_box, draw_dot
from game.effects import MOVING, PLAIN
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.overlay.toast import draw_bar
from game.screens.base import Screen, Shared
from game.screens.panels import dim, draw_panel
from game.screens.settings_rows import EFFECTS, GENERAL, ROWS, Row
from game.settings.values import LOUDEST

_VOLUME = 0
_PITCH = 1.85
"""Units of text from one row to the next."""
_TOP = 4.4


class SettingsPanel:
    """A panel of switches, in two columns."""

    def __init__(self, shared: Shared, under: Screen) -> None:
        """Open over a screen, the first row selected."""
        self._shared, self._under = shared, under
        self._selected = 0

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Select a row, change it, or close the panel."""
        match signal:
            case Pressed(Action.UP):
                self._selected = (self._selected - 1) % len(ROWS)
            case Pressed(Action.DOWN):
                self._selected = (self._selected + 1) % len(ROWS)
            case Pressed(Action.RIGHT | Action.CONFIRM | Action.SERVE):
                self._use(1)
            case Pressed(Action.LEFT):
                self._use(-1)
            case Pressed(Action.BACK | Action.SETTINGS | Action.PAUSE):
                self._shared.keep()
                return self._under
            case Moved(place, False) if (index := self._row_at(place, size)) is not None:
                self._selected = index
            case Clicked(place) | Moved(place, True) if (index := self._row_at(place, size)) is not None:
                self._pointed(index, place, size, clicked=isinstance(signal, Clicked))
        return self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, darker, and the panel."""
        self._under.draw(surface)
        theme, type_, size = self._shared.theme, self._shared.type, surface.get_size()
        panel, boxes = _boxes(size)
        unit = unit_of(size)
        dim(surface, theme)
        draw_panel(surface, panel, theme, unit)
        left = panel.left + unit * 2.0
        type_.write(surface, "Settings", unit * 2.2, theme.text, complex(left, panel.top + unit * 1.2))
        for index, (row, box) in enumerate(zip(ROWS, boxes, strict=True)):
            self._draw_row(surface, row, box, unit, chosen=index == self._selected)
        low = panel.bottom - unit * 1.0
        keys = "Up, down: choose    Enter, left, right or a click: change    Esc: back"
        box = type_.write(surface, keys, unit * 0.95, theme.faint, complex(left, low), "bottomleft")
        meaning = f"{ROWS[self._selected].meaning}{self._overruled(ROWS[self._selected])}"
        lines = type_.wrapped(meaning, unit * 1.1, panel.width - unit * 4.0)
        for index, line in enumerate(lines):
            y = box.top - unit * (0.7 + 1.3 * (len(lines) - 1 - index))
            type_.write(surface, line, unit * 1.1, theme.text, complex(left, y), "bottomleft")

    def _draw_row(self, surface: pygame.Surface, row: Row, box: pygame.Rect, unit: float, *, chosen: bool) -> None:
        """A name, and a bar or a switch that says on or off."""
        theme, type_, settings = self._shared.theme, self._shared.type, self._shared.settings
        if chosen:
            draw_box(surface, box, unit * 0.5, theme.panel, theme.accent, unit * 0.1)
        colour = theme.accent if chosen else theme.text
        type_.write(surface, row.label, unit * 1.15, colour, complex(box.left + unit * 0.6, box.centery), "midleft")
        if row is ROWS[_VOLUME]:
            draw_bar(surface, _volume_bar(box, unit), settings.volume / LOUDEST, theme)
            return
        on = row.on(settings)
        weak = bool(self._overruled(row))
        words = type_.rendered("on" if on else "off", unit * 1.0, theme.faint if weak or not on else theme.text)
        track = pygame.Rect(0, 0, round(unit * 1.9), round(unit * 0.95))
        track.midright = (round(box.right - unit * 0.6), box.centery)
        surface.blit(words, words.get_rect(midright=(track.left - round(unit * 0.5), box.centery)))
        filled = mixed(theme.panel, theme.accent, 0.45 if weak else 1.0)
        radius = track.height / 2.0
        edge = filled if on else theme.panel_edge
        draw_box(surface, track, radius, filled if on else theme.panel, edge, unit * 0.1)
        knob = complex(track.right - radius if on else track.left + radius, track.centery)
        draw_dot(surface, knob, max(radius - unit * 0.2, 1.0), theme.panel if on else theme.panel_edge)

    def _overruled(self, row: Row) -> str:
        """Why an effect that is wanted is not seen all the same; empty if it is."""
        settings = self._shared.settings
        if row.kind is None or row.kind in settings.off:
            return ""
        if not settings.effects and row.kind not in PLAIN:
            return " Off now: effects are."
        return " Off now: reduced motion." if settings.reduced_motion and row.kind in MOVING else ""

    def _use(self, way: int) -> None:
        """Change what is selected."""
        self._shared.change(ROWS[self._selected].change(self._shared.settings, way))

    def _pointed(self, index: int, place: complex, size: tuple[int, int], *, clicked: bool) -> None:
        """Use a row with the mouse: the volume is where it points, switches turn over with a click."""
        self._selected = index
        if index == _VOLUME:
            bar = _volume_bar(_boxes(size)[1][index], unit_of(size))
            share = min(max((place.real - bar.left) / max(bar.width, 1), 0.0), 1.0)
            self._shared.change(self._shared.settings._replace(volume=round(share * LOUDEST)))
        elif clicked:
            self._use(1)

    def _row_at(self, place: complex, size: tuple[int, int]) -> int | None:
        """The row at a pixel."""
        index = pygame.Rect(place.real, place.imag, 1, 1).collidelist(_boxes(size)[1])
        return None if index < 0 else index


def _boxes(size: tuple[int, int]) -> tuple[pygame.Rect, list[pygame.Rect]]:
    """The panel and its rows, pixels: the general ones on the left, the effects on the right."""
    unit = unit_of(size)
    width, height = unit * 40.0, unit * (_TOP + _PITCH * len(EFFECTS) + 5.2)
    panel = pygame.Rect(round((size[0] - width) / 2), round((size[1] - height) / 2), round(width), round(height))
    boxes = []
    for column, rows in enumerate((GENERAL, EFFECTS)):
        for index in range(len(rows)):
            corner = (panel.left + round(unit * (1.4 + 18.9 * column)), panel.top + round(unit * (_TOP + _PITCH * index)))
            boxes.append(pygame.Rect(corner, (round(unit * 18.3), round(unit * 1.7))))
    return panel, boxes


def _volume_bar(box: pygame.Rect, unit: float) -> pygame.Rect:
    """Where the volume's bar is in its row."""
    bar = pygame.Rect(0, 0, round(unit * 8.0), round(unit * 0.7))
    bar.midright = (round(box.right - unit * 0.6), box.centery)
    return bar
