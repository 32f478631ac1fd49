"""The focus: which item of a form has it, and which one gets it next."""

from typing import NamedTuple

from game.input.keys import Action
from game.screens.toolkit.layout import FormLayout, PositionedItem

TABS = -1
"""The row of the tabs' heads."""


class Focus(NamedTuple):
    """The position of the item that has the focus. row: as in `PositionedItem`, or TABS; column: from 0."""

    row: int
    column: int


def first_focus(layout: FormLayout, near: Focus | None = None) -> Focus | None:
    """The first item that can be used, or the one nearest to what had the focus before; None where none can be."""
    items = _usable(layout)
    if not items:
        return None
    if near is None:
        return Focus(items[0].row, items[0].column)
    positioned = min(items, key=lambda positioned: (abs(positioned.row - near.row), abs(positioned.column - near.column)))
    return Focus(positioned.row, positioned.column)


def moved_focus(layout: FormLayout, focus: Focus, action: Action, tab: int | None) -> Focus:
    """The focus after an arrow key. tab: the one that is shown; None if there are no tabs.

    Left and right go through all items in the order of reading; up and down to the row above or below, there to the item that
    is nearest across, and around the ends.
    """
    items = _usable(layout)
    if not items:
        return focus
    if action in (Action.LEFT, Action.RIGHT):
        found = [index for index, positioned in enumerate(items) if (positioned.row, positioned.column) == focus]
        step = 1 if action is Action.RIGHT else -1
        positioned = items[(found[0] + step) % len(items)] if found else items[0]
        return Focus(positioned.row, positioned.column)
    rows = sorted({positioned.row for positioned in items} | (set() if tab is None else {TABS}))
    step = 1 if action is Action.DOWN else -1
    row = rows[(rows.index(focus.row) + step) % len(rows)] if focus.row in rows else rows[0]
    if row == TABS and tab is not None:
        return Focus(TABS, tab)
    before = next((positioned.box.centerx for positioned in items if (positioned.row, positioned.column) == focus), None)
    in_row = [positioned for positioned in items if positioned.row == row]
    positioned = in_row[0] if before is None else min(in_row, key=lambda positioned: abs(positioned.box.centerx - before))
    return Focus(positioned.row, positioned.column)


def _usable(layout: FormLayout) -> list[PositionedItem]:
    """The items that can be used."""
    return [positioned for positioned in layout.items if positioned.item.focusable]
