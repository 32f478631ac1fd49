"""Which item of a panel has the focus, and which one gets it next."""

from typing import NamedTuple

from game.input.keys import Action
from game.screens.toolkit.layout import Laid, Spot

TABS = -1
"""The row of the tabs' heads."""


class Focus(NamedTuple):
    """What has the focus. row: as in `Spot`, or TABS; column: from 0."""

    row: int
    column: int


def first_focus(laid: Laid, near: Focus | None = None) -> Focus | None:
    """The first item that can be used, or the one nearest to what had the focus before; None where none can be."""
    spots = _usable(laid)
    if not spots:
        return None
    if near is None:
        return Focus(spots[0].row, spots[0].column)
    spot = min(spots, key=lambda spot: (abs(spot.row - near.row), abs(spot.column - near.column)))
    return Focus(spot.row, spot.column)


def moved_focus(laid: Laid, focus: Focus, action: Action, tab: int | None) -> Focus:
    """What gets the focus by an arrow key. tab: the one that is shown; None where there are no tabs.

    Left and right go through all items in the order of reading; up and down to the row above or below, there to the item that
    is nearest across, and around the ends.
    """
    spots = _usable(laid)
    if not spots:
        return focus
    if action in (Action.LEFT, Action.RIGHT):
        found = [index for index, spot in enumerate(spots) if (spot.row, spot.column) == focus]
        step = 1 if action is Action.RIGHT else -1
        spot = spots[(found[0] + step) % len(spots)] if found else spots[0]
        return Focus(spot.row, spot.column)
    rows = sorted({spot.row for spot in spots} | (set() if tab is None else {TABS}))
    step = 1 if action is Action.DOWN else -1
    row = rows[(rows.index(focus.row) + step) % len(rows)] if focus.row in rows else rows[0]
    if row == TABS and tab is not None:
        return Focus(TABS, tab)
    before = next((spot.box.centerx for spot in spots if (spot.row, spot.column) == focus), None)
    in_row = [spot for spot in spots if spot.row == row]
    spot = in_row[0] if before is None else min(in_row, key=lambda spot: abs(spot.box.centerx - before))
    return Focus(spot.row, spot.column)


def _usable(laid: Laid) -> list[Spot]:
    """The items that can be used."""
    return [spot for spot in laid.spots if spot.item.focusable]
