"""The part of the help about what drops out of bricks: every power-up's sign, and what it does."""

import pygame

from game.drawing.canvas import Canvas
from game.drawing.display_list_painter import DisplayListPainter
from game.effects.pops import POWER_NAMES
from game.language import tr
from game.picture.display_list import DisplayList
from game.picture.moving.drops import add_chip
from game.rules import LASTING, TICK, PowerUp
from game.screens.toolkit.items.basic import Drawing, Item, TextItem
from game.screens.toolkit.layout import Row

_SIGN = 0.16
"""Width of a sign's column, in comparison with the words'."""
_ROW, _ICON = 2.6, 0.95
"""Height of a row and radius of an icon, units of text."""
_painter = DisplayListPainter()


def power_rows() -> tuple[Row, ...]:
    """All power-ups, two in a row."""
    cells = [_cell(kind) for kind in PowerUp]
    rows: list[Row] = [
        (*left, *right)
        for left, right in zip(cells[::2], [*cells[1::2], (TextItem("", share=_SIGN), TextItem(""))], strict=False)
    ]
    caught = tr("A broken brick may release a power-up. It drifts outward: catch it with a paddle before it leaves the circle.")
    harmful = tr("Let the spiky ones go.")
    arcs = tr("Arcs beside the circle show how long each lasts; the red one with the target, what is left of a core.")
    return ((TextItem(f"{caught} {harmful}", 1.1),), (TextItem("", 0.4),), *rows, (TextItem(arcs, 1.0, faint=True),))


def _cell(kind: PowerUp) -> tuple[Item, Item]:
    """A sign, and what it does."""
    words, seconds = _first_upper(tr(POWER_NAMES[kind])), LASTING.get(kind, 0) * TICK
    if seconds:
        words = tr("{power} for {seconds:.0f} s").format(power=words, seconds=seconds)
    if kind in _meanings():
        words = f"{words}: {_meanings()[kind]}"

    def paint(canvas: Canvas, box: pygame.Rect) -> None:
        pixel = complex(*box.center)
        radius = min(canvas.unit * _ICON, box.width * 0.5)
        sign = DisplayList()
        add_chip(sign, kind, pixel, radius, canvas.theme)
        _painter.paint(canvas.surface, canvas.type, sign)

    return Drawing(_ROW, paint, share=_SIGN), TextItem(words, 1.0, midway=True)


def _first_upper(words: str) -> str:
    """Words that begin a sentence."""
    return words[:1].upper() + words[1:]


def _meanings() -> dict[PowerUp, str]:
    """What those do whose names do not say it."""
    return {
        PowerUp.MULTI_BALL: tr("two more balls; only losing the last one costs a life."),
        PowerUp.STICKY: tr("a paddle holds the ball until you serve."),
        PowerUp.SHIELD: tr("a ring at the rim sends one ball back."),
        PowerUp.PIERCE: tr("it breaks bricks and flies on."),
    }
