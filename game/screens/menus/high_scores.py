"""The table of high scores, with a tab for every difficulty. A line opens its replay."""

from game.language import grouped, tr
from game.levels.names import level_name
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.difficulty_names import DIFFICULTIES, difficulty_name
from game.screens.menus.replay_file import opened_replay
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items.basic import ButtonItem, Item, TableRow, TextItem
from game.screens.toolkit.layout import FROM_TOP, Content
from game.screens.toolkit.menu import Entry, back_row
from game.screens.toolkit.panel import Panel
from game.storage.scores import ENDLESS, Score

_TABLES = (*DIFFICULTIES, ENDLESS)
_COLUMNS = ((0.6, "right"), (0.2, "left"), (3.6, "left"), (2.0, "right"), (0.6, "left"), (3.6, "left"), (2.2, "right"))
"""The columns, two of them empty: parts of the width, and where their words stand."""
_FEW_COLUMNS = 4
"""So many of them where texts are large; the tip says the rest."""


class HighScores(Panel):
    """The panel of high scores."""

    def __init__(self, state: AppState, under: Screen, entered: Score | None = None, entries: tuple[Entry, ...] = ()) -> None:
        """Open at the present difficulty. entered: the score that was just made, marked; entries: where it leads then."""
        super().__init__(state, under)
        self._entered, self._entries = entered, entries
        self._tab = _TABLES.index(entered.difficulty if entered is not None else state.difficulty)

    def content(self) -> Content:
        """The table of one difficulty."""
        table = self.state.storage.scores.value.table(_TABLES[self._tab])
        heads = ("#", "", tr("Name"), tr("Score"), "", tr("Reached"), tr("Date"))
        rows: list[tuple[Item, ...]] = [(TableRow(self._cells(heads), faint=True),)] if table else []
        rows += [(self._line(number, score),) for number, score in enumerate(table, 1)]
        if not table:
            rows.append(
                (TextItem(tr("Nobody yet: the first game that ends with points will be listed here."), 1.1, faint=True),)
            )
        names = (*[difficulty_name(name) for name in DIFFICULTIES], tr("Endless"))
        footer = back_row(tr("Back"), self.back)
        if self._entries:
            footer = (tuple([ButtonItem(one.label, one.chosen, centred=True) for one in self._entries]),)
        return Content(tr("High scores"), tuple(rows), footer, names, self._tab, 42.0, tall=FROM_TOP)

    def back(self) -> Screen | None:
        """After a game to the title, else to the screen below."""
        return self.state.open_title(self.state) if self._entries else super().back()

    def first(self) -> Focus | None:
        """After a game, the first button that leads on."""
        return Focus(len(self.content().body), 0) if self._entries else None

    def _line(self, number: int, score: Score) -> TableRow:
        """A line of the table."""
        until = tr("the end") if score.won else level_name(score.last)
        name = score.name or "-"
        if score.speed < 100:
            name = tr("{name} ({speed} %)").format(name=name, speed=score.speed)
        words = (str(number), "", name, grouped(score.score), "", until, score.date)
        tip = tr("Watch this game.") if score.replay else tr("No replay of this game was kept.")
        if self.has_large_text:
            tip = f"{until}, {score.date}. {tip}"
        return TableRow(self._cells(words), lambda: self._watched(score), tip, strong=score == self._entered)

    def _cells(self, words: tuple[str, ...]) -> tuple[tuple[str, float, str], ...]:
        """The words of the columns for which there is room."""
        cells = tuple([(word, *column) for word, column in zip(words, _COLUMNS, strict=True)])
        return cells[:_FEW_COLUMNS] if self.has_large_text else cells

    def _watched(self, score: Score) -> Screen:
        """The screen of the score's replay, or a message why there is none."""
        if not score.replay:
            return self
        opened = opened_replay(self.state, self, score.replay)
        if isinstance(opened, str):
            self.state.toast = Toast(opened)
            return self
        return opened
