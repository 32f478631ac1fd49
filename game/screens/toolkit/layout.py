"""The layout of a panel: title, tabs, a body of rows that scrolls if it is too long, a footer, and a tip."""

from typing import NamedTuple

import pygame

from game.drawing.text import Type
from game.screens.toolkit.items.basic import Item
from game.screens.toolkit.plate import centred

Row = tuple[Item, ...]

# Lengths are in units of text.
MARGIN = 1.6
"""From the plate's edges to what is on it."""
TOP, TITLE, TITLE_GAP = 1.1, 2.2, 0.9
"""From the plate's upper edge to the title, size of its letters, and from them down to what follows."""
TABS, TABS_GAP = 2.0, 0.6
"""Height of the tabs' heads, and below them."""
_ROW_GAP, _COLUMN_GAP = 0.25, 0.7
"""Between two rows, and between two items of one."""
_FOOTER_GAP, _BOTTOM = 0.7, 1.2
"""Above the footer, and below all."""
TIP, TIP_LINES, _TIP_GAP = 1.0, 2, 0.5
"""Size of the tip's letters, lines of it, and above it."""
LINE = 1.25
"""From line to line, in sizes of the letters."""
_LEAST_BODY = 0.4
"""A body that needs more room than it has gets at least this share of the height that there is."""
_SCREEN_MARGIN = 0.6
"""From the plate to the edges of the surface, at least."""
BAR = 0.45
"""Width of the scroll bar."""
_BAR_ROOM = 1.1
_MOST_STEADY = 0.5
"""Head and foot of a column that stay where they are have their heights up to this share of the area's; beyond, the least."""
FROM_TOP = 99.0
"""For `Content.tall`: the plate's upper edge is as high as it can be, whatever its parts need."""
COLUMN_MARGIN = 0.9
"""From the edges of an area to the rows in it."""
_TIGHTEST, _LEAST_SEEN = 0.75, 0.22
"""Rows in a column are made lower down to this share of their heights; least share of its height for a body that scrolls."""
CLOSE = 1.9
"""Side of the button in the upper right corner."""


class Content(NamedTuple):
    """What a panel shows.

    title: over all. body: rows of items, which scroll where they are too many. footer: rows that stay.
    tabs: names of the panel's parts; tab: index of the one that is shown.
    width: of the plate, units; less where the surface is narrower. centred: the title.
    tall: units; the plate's upper edge is where a body of this height needs it, so that it is the same for all tabs.
    tips: whether room is left for a tip even where no item has one.
    """

    title: str
    body: tuple[Row, ...]
    footer: tuple[Row, ...] = ()
    tabs: tuple[str, ...] = ()
    tab: int = 0
    width: float = 40.0
    centred: bool = False
    tall: float = 0.0
    tips: bool = False


class PositionedItem(NamedTuple):
    """An item and its box. box: pixels. row, column: counted from 0 over body and footer; in_body: whether it scrolls."""

    item: Item
    box: pygame.Rect
    row: int
    column: int
    in_body: bool


class FormLayout(NamedTuple):
    """A panel's content, laid out. All in pixels.

    plate: the whole. close: the button that leads back. tabs: the tabs' heads. body: what is seen of it.
    items: all items; those of the body where the scrolling puts them. tip: where words about the focused item stand.
    over: how far the body can be scrolled, its overflow. bar: right edge of the scroll bar.
    """

    plate: pygame.Rect
    close: pygame.Rect
    tabs: tuple[pygame.Rect, ...]
    body: pygame.Rect
    items: tuple[PositionedItem, ...]
    tip: pygame.Rect
    over: int
    bar: int


def panel_layout(content: Content, area: pygame.Rect, type_: Type, units: tuple[float, float], scroll: float) -> FormLayout:
    """The layout of a panel. All in pixels.

    area: that the plate may take. units: size of text, and of the title, which is large enough where the player wants large
    texts. scroll: of the body. Where little would be seen of the body, the footer scrolls with it.
    """
    unit, title_unit = units
    free = area.inflate(-round(2.0 * _SCREEN_MARGIN * unit), -round(2.0 * _SCREEN_MARGIN * unit))
    width = min(round(content.width * unit), free.width)
    inner = max(round(width - 2.0 * MARGIN * unit), 1)
    footer = sum([_row_height(row, type_, unit, inner) for row in content.footer])
    has_tip = content.tips or any([item.tip for row in (*content.body, *content.footer) for item in row])
    head = (TOP + (TITLE + TITLE_GAP if content.title else 0.0)) * title_unit
    head += (TABS + TABS_GAP) * unit if content.tabs else 0.0
    foot = (_BOTTOM + (_FOOTER_GAP if content.footer else 0.0)) * unit + footer
    foot += (TIP * LINE * TIP_LINES + _TIP_GAP) * unit if has_tip else 0.0
    wanted = sum([_row_height(row, type_, unit, inner) for row in content.body])
    room = max(free.height - head - foot, unit)
    if content.footer and wanted > room and room < free.height * _LEAST_BODY:
        together = content._replace(body=(*content.body, *content.footer), footer=())
        return panel_layout(together, area, type_, units, scroll)
    if wanted > room:
        inner = max(round(inner - _BAR_ROOM * unit), 1)
        wanted = sum([_row_height(row, type_, unit, inner) for row in content.body])
    seen = min(wanted, room)
    plate = centred(area.size, width, head + seen + foot).move(area.topleft)
    if content.tall:
        plate.top = centred(area.size, width, head + min(max(wanted, content.tall * unit), room) + foot).top + area.top
    left = plate.left + round(MARGIN * unit)
    body = pygame.Rect(left, round(plate.top + head), inner, round(seen))
    over = max(round(wanted - seen), 0)
    items = _positioned(content.body, type_, unit, (left, body.top - min(scroll, over), inner), (0, True))
    footer_top = plate.bottom - round(_BOTTOM * unit + footer)
    whole = max(round(width - 2.0 * MARGIN * unit), 1)
    below = _positioned(content.footer, type_, unit, (left, footer_top, whole), (len(content.body), False))
    tip_top = body.bottom + round(_TIP_GAP * unit)
    tip = pygame.Rect(left, tip_top, whole, round(TIP * LINE * TIP_LINES * unit) if has_tip else 0)
    close = pygame.Rect(0, 0, round(CLOSE * unit), round(CLOSE * unit))
    close.topright = (round(plate.right - 0.7 * unit), round(plate.top + 0.7 * unit))
    tabs = _tabs(content.tabs, type_, unit, (left, round(body.top - (TABS + TABS_GAP) * unit), whole))
    return FormLayout(plate, close, tabs, body, (*items, *below), tip, over, plate.right - round(unit * MARGIN))


class Column(NamedTuple):
    """Rows on a part of a surface. head, foot: rows that stay; body: rows between them, which scroll if they are too many."""

    head: tuple[Row, ...]
    body: tuple[Row, ...]
    foot: tuple[Row, ...]


def column_layout(
    column: Column, area: pygame.Rect, type_: Type, unit: float, scroll: float, *, low_foot: bool = False
) -> FormLayout:
    """Head, body and foot below each other from the top of an area, pixels. unit: size of text. scroll: of the body.

    If there is too little room, first all rows are made lower, then the body scrolls; if too little of it would be visible,
    everything scrolls. low_foot: the foot is at the area's bottom, so that head and foot do not depend on the body.
    """
    margin = round(COLUMN_MARGIN * unit)
    left, width = area.left + margin, max(area.width - 2 * margin, 1)
    head, wanted, foot = [sum([_row_height(row, type_, unit, width) for row in rows]) for rows in column]
    squeeze = min(max(area.height / max(head + wanted + foot, 1.0), _TIGHTEST), 1.0)
    steady = squeeze
    if low_foot:
        steady = 1.0 if head + foot < area.height * _MOST_STEADY else _TIGHTEST
        squeeze = min(max((area.height - steady * (head + foot)) / max(wanted, 1.0), _TIGHTEST), 1.0)
    head, wanted, foot = steady * head, squeeze * wanted, steady * foot
    room = area.height - head - foot
    if room < wanted and room < area.height * _LEAST_SEEN and (column.head or column.foot):
        everything = Column((), (*column.head, *column.body, *column.foot), ())
        return column_layout(everything, area, type_, unit, scroll)
    seen = min(wanted, room)
    over = max(round(wanted - seen), 0)
    inner = width - (round(_BAR_ROOM * unit) if over else 0)
    body = pygame.Rect(left, round(area.top + head), inner, round(seen))
    foot_top = round(area.bottom - foot) if low_foot else body.bottom
    before, inside = len(column.head), len(column.head) + len(column.body)
    items = (
        *_positioned(column.head, type_, unit, (left, area.top, width), (0, False), steady),
        *_positioned(column.body, type_, unit, (left, body.top - min(scroll, over), inner), (before, True), squeeze),
        *_positioned(column.foot, type_, unit, (left, foot_top, width), (inside, False), steady),
    )
    bottom = round(foot_top + foot)
    tip = pygame.Rect(left, bottom, width, round(TIP * LINE * TIP_LINES * unit))
    return FormLayout(area, pygame.Rect(0, 0, 0, 0), (), body, items, tip, over, left + width)


def _row_height(row: Row, type_: Type, unit: float, width: float) -> float:
    """Height of a row with the gap below it, pixels."""
    widths = _widths(row, unit, width)
    return unit * (
        max([item.height(type_, unit, wide) for item, wide in zip(row, widths, strict=True)], default=0.0) + _ROW_GAP
    )


def _widths(row: Row, unit: float, width: float) -> list[float]:
    """Widths of the items of a row, pixels."""
    total = sum([item.share for item in row])
    room = max(width - _COLUMN_GAP * unit * (len(row) - 1), 1.0)
    return [room * item.share / total for item in row]


def _positioned(
    rows: tuple[Row, ...],
    type_: Type,
    unit: float,
    start: tuple[int, float, float],
    first: tuple[int, bool],
    squeeze: float = 1.0,
) -> list[PositionedItem]:
    """Rows of items below each other. start: left, top and width; first: number of the first row, and whether it scrolls.

    squeeze: the share of their heights that they have.
    """
    left, y, width = start
    items = []
    for number, row in enumerate(rows, first[0]):
        tall, x = squeeze * _row_height(row, type_, unit, width), float(left)
        for column, (item, wide) in enumerate(zip(row, _widths(row, unit, width), strict=True)):
            box = pygame.Rect(round(x), round(y), round(wide), round(tall - squeeze * _ROW_GAP * unit))
            items.append(PositionedItem(item, box, number, column, first[1]))
            x += wide + _COLUMN_GAP * unit
        y += tall
    return items


def _tabs(names: tuple[str, ...], type_: Type, unit: float, start: tuple[int, int, int]) -> tuple[pygame.Rect, ...]:
    """The tabs' heads: as wide as their words, narrower where there is no room. start: left, top and width."""
    left, top, width = start
    wanted = [type_.rendered(name, unit * 1.15, (0, 0, 0)).get_width() + 1.4 * unit for name in names]
    shrunk = min(width / max(sum(wanted), 1.0), 1.0)
    boxes, x = [], float(left)
    for wide in wanted:
        boxes.append(pygame.Rect(round(x), top, round(wide * shrunk), round(TABS * unit)))
        x += wide * shrunk
    return tuple(boxes)
