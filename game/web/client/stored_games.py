"""The stored games on the page: to be watched, named, kept or deleted, as on the desktop."""

from collections.abc import Callable, Iterable

import msgspec

from game.language import grouped, tr
from game.levels.names import level_name
from game.storage.games import MOST, StoredGame
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState

_LONGEST_TITLE = 40

Watch = Callable[[str, bytes], PageScreen]
"""Makes the screen that shows a replay: of the name and the bytes of its file."""


def replays_menu(state: PageState, watch: Watch, back: Callable[[], PageScreen]) -> MenuScreen:
    """The list of games, newest first."""

    def contents(_menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        items = [_line(state, game, watch, lambda: replays_menu(state, watch, back)) for game in state.storage.games.listed()]
        rule = tr("Your last {count} games, and those that you keep or that a score refers to.").format(count=MOST)
        none = tr("None yet: games of five seconds or more are kept when they end. A file can be dropped on this page.")
        return (rule if items else none,), items

    return MenuScreen(state, tr("Replays"), contents, back)


def _line(state: PageState, game: StoredGame, watch: Watch, back: Callable[[], PageScreen]) -> Opened:
    """A game of the list."""
    kept = f"  ({tr('Kept').lower()})" if game.kept else ""
    words = f"{game.title or game.date}  {level_name(game.first)}  {grouped(game.score)}{kept}"
    return Opened(PageItem(f"replay-{game.file}", words), lambda _value: _game_menu(state, game, watch, back))


def _game_menu(state: PageState, game: StoredGame, watch: Watch, back: Callable[[], PageScreen]) -> MenuScreen:
    """What can be done with a game. back: makes the list anew."""

    def watched(_value: str) -> PageScreen:
        folder = state.storage.games.folder
        try:
            data = b"" if folder is None else (folder / game.file).read_bytes()
        except OSError as error:
            state.notifications.append(f"{game.file}: {error.strerror}")
            return back()
        return watch(game.file, data)

    def changed(game: StoredGame) -> PageScreen:
        state.storage.games.change(game)
        state.changed = True
        return _game_menu(state, game, watch, back)

    def named(title: str) -> PageScreen:
        title = title.strip()[:_LONGEST_TITLE]
        return changed(msgspec.structs.replace(game, title=title, kept=game.kept or bool(title)))

    items = (
        Opened(PageItem("watch", tr("Watch")), watched),
        Opened(PageItem("name", tr("Title of this game"), "text", game.title, high=_LONGEST_TITLE), named),
        Opened(
            PageItem("keep", tr("Keep it"), "switch", str(game.kept)),
            lambda value: changed(msgspec.structs.replace(game, kept=value == "True")),
        ),
        Opened(PageItem("delete", tr("Delete")), lambda _value: _delete_menu(state, game, menu, back)),
    )
    menu = MenuScreen(state, game.title or game.date, lambda _menu: ((), items), back)
    return menu


def _delete_menu(state: PageState, game: StoredGame, before: PageScreen, back: Callable[[], PageScreen]) -> MenuScreen:
    """Asks before a game is removed; the safe answer comes first."""

    def deleted(_value: str) -> PageScreen:
        problem = state.storage.games.delete(game)
        state.changed = True
        state.notifications += [] if problem is None else [problem]
        return back()

    line = tr("Its file is removed for good.")
    if game.file in state.storage.needed():
        line = tr("A score or a best run refers to it and could no longer be verified.")
    items = (
        Opened(PageItem("go-on", tr("Keep it")), lambda _value: before),
        Opened(PageItem("delete", tr("Delete")), deleted),
    )
    return MenuScreen(state, tr("Delete this game?"), lambda _menu: ((line,), items), lambda: before)
