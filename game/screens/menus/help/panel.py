"""The help: what the game is about, how to aim, what drops out of bricks, and all keys."""

from game.input.key_names import play_help
from game.input.keys import Action
from game.input.signals import Pressed, Signal
from game.language import tr
from game.overlay.help_words import aiming_words, game_words, keyboard_words, other_controls
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.help import pictures
from game.screens.menus.help.powers import power_rows
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items.basic import Drawing, Item, TableRow, TextItem
from game.screens.toolkit.layout import FROM_TOP, Content, Row
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel


class Help(Panel):
    """The panel of the help, with a tab for each topic. The key that opened it closes it."""

    def __init__(
        self, state: AppState, under: Screen, title: str = "", keys: tuple[tuple[str, str], ...] | None = None
    ) -> None:
        """Open over a screen. title, keys: pairs of keys and what they do, of a screen that has no other help."""
        super().__init__(state, under)
        self._title, self._keys = title, keys

    def content(self) -> Content:
        """The part that is shown."""
        footer = back_row(tr("Back"), self.back)
        if self._keys is not None:
            return Content(self._title, self._key_rows(self._keys), footer, width=40.0)
        parts = (_game, _aiming, power_rows, _controls, lambda: self._key_rows(play_help()))
        names = (tr("The game"), tr("Aiming"), tr("Power-ups"), tr("Controls"), tr("Keys"))
        return Content(tr("How to play"), parts[self._tab](), footer, names, self._tab, 44.0, tall=FROM_TOP)

    def first(self) -> Focus | None:
        """The button that closes it."""
        return Focus(len(self.content().body), 1)

    def answer(self, signal: Signal, size: tuple[int, int]) -> Screen | None:
        """The keys that open it close it."""
        if isinstance(signal, Pressed) and signal.action in (Action.HELP, Action.PAUSE):
            return self.back()
        return super().answer(signal, size)

    def _key_rows(self, keys: tuple[tuple[str, str], ...]) -> tuple[Row, ...]:
        """A line for each key; two lines if the text is large."""
        if not self.has_large_text:
            return tuple([(TableRow(((names, 1.0, "left"), (meaning, 2.0, "left"))),) for names, meaning in keys])
        words = [(TextItem(names, 1.0, faint=True), TextItem(meaning, 1.1), Item()) for names, meaning in keys]
        return tuple([(item,) for items in words for item in items])


def _game() -> tuple[Row, ...]:
    """The tab about the game's aim."""
    beside = TextItem("\n".join(game_words()), 1.15, share=1.25)
    return (
        (Drawing(12.5, pictures.draw_arena, most=1.0), beside),
        (TextItem(""),),
        (Drawing(4.2, pictures.draw_bricks),),
    )


def _aiming() -> tuple[Row, ...]:
    """The tab about steering the ball."""
    *ways, hint = aiming_words()
    return (
        (
            Drawing(10.5, pictures.draw_hit_position, most=pictures.GROUND_HEIGHT),
            Drawing(10.5, pictures.draw_moving_paddle, most=pictures.GROUND_HEIGHT),
            Drawing(10.5, pictures.draw_serve, most=pictures.GROUND_HEIGHT),
        ),
        tuple([TextItem(line, 1.0) for line in ways]),
        (TextItem(""),),
        (TextItem(hint, 1.0, faint=True),),
    )


def _controls() -> tuple[Row, ...]:
    """The tab about keyboard, mouse, gamepad and touch."""
    ways = (
        keyboard_words(),
        (
            tr("Mouse"),
            tr(
                "The nearest paddle follows the pointer; a click serves. The buttons at the right are pause, help and settings."
            ),
        ),
        *other_controls(),
    )
    rows: list[Row] = []
    for name, how in ways:
        row: tuple[Item, ...] = (TextItem(name, 1.2, share=0.35), TextItem(how, 1.1))
        rows += [row, (Item(),)]
    return tuple(rows)
