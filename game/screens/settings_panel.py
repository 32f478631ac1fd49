"""The settings over another screen: what every one means, and what it is now."""

import pygame

from game.drawing.camera import unit_of
from game.drawing.canvas import Canvas
from game.drawing.palette import mixed
from game.drawing.raster.primitives import draw_box, draw_dot
from game.effects import MOVING, PLAIN
from game.input.keys import Action
from game.input.signals import Clicked, Moved, Pressed, Signal
from game.overlay.toast import draw_bar
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.panel import centred, dim, draw_panel, index_at
from game.screens.settings_rows import EFFECTS, GENERAL, ROWS, Row
from game.screens.still_picture import StillPicture
from game.settings.values import LOUDEST

_VOLUME = 0
"""Index of the volume's row."""
# Lengths are in units of text.
_WIDTH, _BELOW_ROWS = 40.0, 5.2
"""Width of the panel, and its height below the rows."""
_LEFT, _TITLE_TOP, _ROWS_TOP, _BOTTOM = 2.0, 1.2, 4.4, 1.0
"""From the panel's edges to the words, and from its top to title and first row."""
_TITLE, _LABEL, _STATE, _MEANING, _KEYS = 2.2, 1.15, 1.0, 1.1, 0.95
"""Sizes of letters."""
_ROW_LEFT, _ROW_PITCH, _COLUMN_PITCH, _ROW_SIZE = 1.4, 1.85, 18.9, (18.3, 1.7)
"""From the panel's left edge to the first column, from row to row, from column to column, and a row's box."""
_ROW_MARGIN = 0.6
"""From a row's words and its switch to its edges."""
_ROW_CORNER, _ROW_EDGE = 0.5, 0.1
"""Of the box around the selected row: radius of corners, width of edge."""
_SWITCH, _SWITCH_GAP, _SWITCH_EDGE, _KNOB_INSET = (1.9, 0.95), 0.5, 0.1, 0.2
"""A switch, from it to the word beside it, the width of its edge, and from its edge to its knob."""
_OVERRULED = 0.45
"""A switch that has no effect now has this share of the way from the panel's colour to its own."""
_VOLUME_BAR = (8.0, 0.7)
_MEANING_GAP, _MEANING_PITCH = 0.7, 1.3
"""Between the keys and the meaning above them, and from line to line of it."""
_KEYS_HELP = "Up, down: choose    Enter, left, right or a click: change    Esc: back"


class SettingsPanel:
    """A panel of switches, in two columns."""

    def __init__(self, state: AppState, under: Screen) -> None:
        """Open over a screen, the first row selected."""
        self._state, self._under = state, under
        self._selected = 0
        self._picture = StillPicture()

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """Select a row, change it, or close the panel."""
        match signal:
            case Pressed(Action.UP):
                self._selected = (self._selected - 1) % len(ROWS)
            case Pressed(Action.DOWN):
                self._selected = (self._selected + 1) % len(ROWS)
            case Pressed(Action.RIGHT | Action.CONFIRM | Action.SERVE):
                self._change(1)
            case Pressed(Action.LEFT):
                self._change(-1)
            case Pressed(Action.BACK | Action.SETTINGS | Action.PAUSE):
                self._state.save_settings()
                return self._under
            case Moved(pixel, False) if (index := index_at(_boxes(size)[1], pixel)) is not None:
                self._selected = index
            case Clicked(pixel) | Moved(pixel, True) if (index := index_at(_boxes(size)[1], pixel)) is not None:
                self._pointed(index, pixel, size, clicked=isinstance(signal, Clicked))
        return self

    def advance(self, _seconds: float, _size: tuple[int, int]) -> Screen | None:
        """Nothing moves."""
        return self

    def draw(self, surface: pygame.Surface) -> None:
        """The screen below, dimmed, and the panel."""
        self._picture.show(surface, (self._state.appearance, self._selected), self._draw)

    def _draw(self, surface: pygame.Surface) -> None:
        """Draw it anew."""
        self._under.draw(surface)
        canvas = self._state.canvas(surface)
        theme, unit = canvas.theme, canvas.unit
        panel, boxes = _boxes(canvas.size)
        dim(surface, theme)
        draw_panel(surface, panel, theme, unit)
        left, bottom = panel.left + unit * _LEFT, panel.bottom - unit * _BOTTOM
        canvas.write("Settings", _TITLE, theme.text, complex(left, panel.top + unit * _TITLE_TOP))
        for index, (row, box) in enumerate(zip(ROWS, boxes, strict=True)):
            self._draw_row(canvas, row, box, selected=index == self._selected)
        keys = canvas.write(_KEYS_HELP, _KEYS, theme.faint, complex(left, bottom), "bottomleft")
        meaning = f"{ROWS[self._selected].meaning}{self._overruled(ROWS[self._selected])}"
        lines = canvas.type.wrapped(meaning, unit * _MEANING, panel.width - unit * 2.0 * _LEFT)
        for index, line in enumerate(reversed(lines)):
            y = keys.top - unit * (_MEANING_GAP + _MEANING_PITCH * index)
            canvas.write(line, _MEANING, theme.text, complex(left, y), "bottomleft")

    def _draw_row(self, canvas: Canvas, row: Row, box: pygame.Rect, *, selected: bool) -> None:
        """A name, and a bar or a switch that says on or off."""
        theme, unit = canvas.theme, canvas.unit
        if selected:
            draw_box(canvas.surface, box, unit * _ROW_CORNER, theme.panel, theme.accent, unit * _ROW_EDGE)
        colour = theme.accent if selected else theme.text
        canvas.write(row.label, _LABEL, colour, complex(box.left + unit * _ROW_MARGIN, box.centery), "midleft")
        if row is ROWS[_VOLUME]:
            draw_bar(canvas.surface, _volume_bar(box, unit), self._state.settings.volume / LOUDEST, theme)
        else:
            _draw_switch(canvas, box, on=row.on(self._state.settings), overruled=bool(self._overruled(row)))

    def _overruled(self, row: Row) -> str:
        """Why an effect that is wanted is not seen all the same; empty if it is."""
        settings = self._state.settings
        if row.kind is None or row.kind in settings.off:
            return ""
        if not settings.effects and row.kind not in PLAIN:
            return " Off now: effects are."
        return " Off now: reduced motion." if settings.reduced_motion and row.kind in MOVING else ""

    def _change(self, step: int) -> None:
        """Change what is selected. step: +1, or -1 for less of it."""
        self._state.change(ROWS[self._selected].change(self._state.settings, step))

    def _pointed(self, index: int, pixel: complex, size: tuple[int, int], *, clicked: bool) -> None:
        """Use a row with the mouse: the volume is where it points, switches turn over with a click."""
        self._selected = index
        if index == _VOLUME:
            bar = _volume_bar(_boxes(size)[1][index], unit_of(size))
            share = min(max((pixel.real - bar.left) / max(bar.width, 1), 0.0), 1.0)
            self._state.change(self._state.settings._replace(volume=round(share * LOUDEST)))
        elif clicked:
            self._change(1)


def _draw_switch(canvas: Canvas, row: pygame.Rect, *, on: bool, overruled: bool) -> None:
    """A switch at the right end of a row, and a word that says how it stands."""
    theme, unit = canvas.theme, canvas.unit
    words = canvas.type.rendered("on" if on else "off", unit * _STATE, theme.text if on and not overruled else theme.faint)
    track = pygame.Rect(0, 0, round(unit * _SWITCH[0]), round(unit * _SWITCH[1]))
    track.midright = (round(row.right - unit * _ROW_MARGIN), row.centery)
    canvas.surface.blit(words, words.get_rect(midright=(track.left - round(unit * _SWITCH_GAP), row.centery)))
    filled = mixed(theme.panel, theme.accent, _OVERRULED if overruled else 1.0)
    radius = track.height / 2.0
    fill, edge = (filled, filled) if on else (theme.panel, theme.panel_edge)
    draw_box(canvas.surface, track, radius, fill, edge, unit * _SWITCH_EDGE)
    knob = complex(track.right - radius if on else track.left + radius, track.centery)
    draw_dot(canvas.surface, knob, max(radius - unit * _KNOB_INSET, 1.0), theme.panel if on else theme.panel_edge)


def _boxes(size: tuple[int, int]) -> tuple[pygame.Rect, list[pygame.Rect]]:
    """The panel and its rows, pixels: the general ones on the left, the effects on the right."""
    unit = unit_of(size)
    panel = centred(size, unit * _WIDTH, unit * (_ROWS_TOP + _ROW_PITCH * len(EFFECTS) + _BELOW_ROWS))
    row = (round(unit * _ROW_SIZE[0]), round(unit * _ROW_SIZE[1]))
    boxes = []
    for column, rows in enumerate((GENERAL, EFFECTS)):
        x = panel.left + round(unit * (_ROW_LEFT + _COLUMN_PITCH * column))
        tops = [panel.top + round(unit * (_ROWS_TOP + _ROW_PITCH * index)) for index in range(len(rows))]
        boxes += [pygame.Rect((x, y), row) for y in tops]
    return panel, boxes


def _volume_bar(row: pygame.Rect, unit: float) -> pygame.Rect:
    """Where the volume's bar is in its row."""
    bar = pygame.Rect(0, 0, round(unit * _VOLUME_BAR[0]), round(unit * _VOLUME_BAR[1]))
    bar.midright = (round(row.right - unit * _ROW_MARGIN), row.centery)
    return bar
