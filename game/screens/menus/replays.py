"""The list of finished games: watch, rename, keep, copy or delete them."""

from collections.abc import Callable
from pathlib import Path

import msgspec
import platformdirs

from game.language import grouped, tr
from game.levels.names import level_name
from game.overlay.toast import Toast
from game.screens.base import Screen
from game.screens.difficulty_names import difficulty_name
from game.screens.menus.level_select import clock
from game.screens.menus.replay_file import opened_replay
from game.screens.toolkit.items.basic import Item, TableRow, TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.menu import Entry, Menu, back_row
from game.screens.toolkit.panel import Panel
from game.screens.toolkit.text_entry import TextEntry
from game.storage.games import MOST, StoredGame

_SHARES = ((4.2, "left"), (3.4, "left"), (1.8, "right"), (1.2, "right"), (1.4, "centre"))
"""The columns: parts of the width, and where their words stand."""
_FEW_COLUMNS = (0, 2, 3)
"""These of them where texts are large; the tip says the rest."""
_LONGEST_TITLE, _LONGEST_PATH = 40, 240
_TOLD_SECONDS = 5.0
"""How long a path is told: it takes time to read."""


class Replays(Panel):
    """The list of games, newest first."""

    def content(self) -> Content:
        """A line for every game."""
        rows: list[tuple[Item, ...]] = [(TextItem(_rule(), 1.0, faint=True),)]
        games = self.state.storage.games.listed()
        if games:
            heads = (tr("Game"), tr("Reached"), tr("Score"), tr("Time"), tr("Kept"))
            rows.append((TableRow(self._cells(heads), faint=True),))
        else:
            rows.append((TextItem(tr("None yet: games of five seconds or more are kept when they end."), 1.1),))
        rows += [(self._line(game),) for game in games]
        footer = back_row(tr("Back"), self.back)
        return Content(tr("Replays"), tuple(rows), footer, width=44.0)

    def _line(self, game: StoredGame) -> TableRow:
        """A game's line."""
        until = tr("the end") if game.won else level_name(game.last)
        words = (
            game.title or game.date,
            until,
            grouped(game.score) if game.ticks else "",
            clock(game.ticks) if game.ticks else "",
            tr("yes") if game.kept else "",
        )
        tip = tr("Watch, rename, keep, copy or delete it.")
        if self.has_large_text:
            tip = f"{until}. {tip}"
        return TableRow(self._cells(words), lambda: self._menu(game), tip)

    def _cells(self, words: tuple[str, ...]) -> tuple[tuple[str, float, str], ...]:
        """The words of the columns for which there is room."""
        cells = tuple([(word, *column) for word, column in zip(words, _SHARES, strict=True)])
        return tuple([cells[column] for column in _FEW_COLUMNS]) if self.has_large_text else cells

    def _menu(self, game: StoredGame) -> Screen:
        """What can be done with a game."""
        lines = [f"{game.date}   {_played(game)}".strip()]
        keep = tr("Stop keeping it") if game.kept else tr("Keep it")
        entries = (
            Entry(tr("Watch"), lambda: self._watched(game)),
            Entry(tr("Rename"), lambda: self._rename(game)),
            Entry(keep, lambda: self._changed(msgspec.structs.replace(game, kept=not game.kept))),
            Entry(tr("Copy to a folder"), lambda: self._export(game)),
            Entry(tr("Delete"), lambda: self._delete(game)),
            Entry(tr("Back"), lambda: self),
        )
        return Menu(self.state, self, game.title or tr("Replay"), tuple(lines), entries, back=lambda: self)

    def _watched(self, game: StoredGame) -> Screen:
        """The screen of the game's replay, or a message why there is none."""
        opened = opened_replay(self.state, self, game.file)
        return self._told(opened) if isinstance(opened, str) else opened

    def _rename(self, game: StoredGame) -> Screen:
        """Enter a title; a game that has one is kept."""

        def done(title: str) -> Screen:
            return self._changed(msgspec.structs.replace(game, title=title, kept=game.kept or bool(title)))

        return TextEntry(self.state, self, tr("Title of this game"), game.title, _LONGEST_TITLE, done)

    def _export(self, game: StoredGame) -> Screen:
        """Enter a folder, and copy the file there."""

        def done(folder: str) -> Screen:
            try:
                path = self.state.storage.games.export(game, Path(folder).expanduser())
            except (OSError, RuntimeError, ValueError) as error:
                return self._told(tr("Not copied: {reason}").format(reason=getattr(error, "strerror", None) or error))
            return self._told(tr("Copied to {path}").format(path=path))

        return TextEntry(self.state, self, tr("Folder to copy it to"), _share_folder(), _LONGEST_PATH, done)

    def _delete(self, game: StoredGame) -> Screen:
        """Ask first; the safe answer is selected."""

        def deleted() -> Screen:
            problem = self.state.storage.games.delete(game)
            self._changes += 1
            return self if problem is None else self._told(problem)

        entries = (Entry(tr("Keep it"), lambda: self), Entry(tr("Delete"), deleted))
        line = tr("Its file is removed for good.")
        if game.file in self.state.storage.needed():
            line = tr("A score or a best run refers to it and could no longer be verified.")
        return Menu(self.state, self, tr("Delete this game?"), (line,), entries, back=lambda: self)

    def _changed(self, game: StoredGame) -> Screen:
        """Change what is stored about a game, and return to the list."""
        self.state.storage.games.change(game)
        self._changes += 1
        return self

    def _told(self, words: str) -> Screen:
        """Return to the list with a message."""
        self.state.toast = Toast(words, left=_TOLD_SECONDS)
        return self


def _rule() -> str:
    """A line about which games are kept."""
    return tr("Your last {count} games, and those that you keep or that a score refers to.").format(count=MOST)


def _played(game: StoredGame) -> str:
    """What was played, in words."""
    words = [" – ".join(dict.fromkeys([level_name(game.first), level_name(game.last)]))] if game.first else []
    return ", ".join([word for word in (*words, difficulty_name(game.difficulty)) if word])


def _share_folder() -> str:
    """The folder that is offered: the user's documents."""
    finder: Callable[[], str] = platformdirs.user_documents_dir
    try:
        return finder()
    except (OSError, RuntimeError):
        return ""
