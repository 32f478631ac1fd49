"""The menu of endless levels: those of today's date, those of a new seed, or those of a seed that is entered."""

import datetime as dt

from game.generated import daily_seed, sequence
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.endless_seeds import LONGEST_SEED, new_seed, seed_of
from game.screens.play.screen import PlayScreen
from game.screens.toolkit.menu import Entry, Menu
from game.screens.toolkit.text_entry import TextEntry


def endless_menu(state: AppState, under: Screen) -> Menu:
    """The menu."""
    day = dt.datetime.now(tz=dt.UTC).date()
    same = tr("Everyone gets the same levels on {day}.").format(day=day)
    lines = (tr("Levels made from a number: the same number gives everyone the same levels."),)
    entries = (
        Entry(
            tr("Today's levels"),
            lambda: begun(state, daily_seed(day)),
            tip=same,
        ),
        Entry(tr("New levels"), lambda: begun(state, new_seed())),
        Entry(tr("Levels from a number"), lambda: _seed_entry(state, menu)),
        Entry(tr("Back"), lambda: under),
    )
    menu = Menu(state, under, tr("Endless"), lines, entries, back=lambda: under)
    return menu


def begun(state: AppState, seed: int) -> Screen:
    """A game on the levels of a seed."""
    return PlayScreen(state, sequence(seed), seed)


def _seed_entry(state: AppState, menu: Screen) -> Screen:
    """The entry of a seed: a number, or words from which a number is made."""

    def done(text: str) -> Screen:
        return begun(state, seed_of(text)) if text else menu

    return TextEntry(state, menu, tr("Number of these levels"), "", LONGEST_SEED, done)
