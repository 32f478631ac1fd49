"""How to play, and who made the game: menus of the page that are read."""

from collections.abc import Callable, Iterable

from msgspec import structs

from game.drawing.palette import Theme
from game.input.key_names import play_help
from game.language import tr
from game.overlay.credits_words import PAGE, about, credit_parts, version
from game.overlay.help_words import (
    aiming_words,
    game_words,
    gauges_words,
    keyboard_words,
    other_controls,
    power_words,
    powers_words,
)
from game.picture.display_list import DisplayList
from game.picture.moving.drops import add_chip
from game.rules import PowerUp
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState

_SIGN, _SIGN_RADIUS = 24 + 24j, 22.0
"""Middle and radius of a power-up's sign, pixels of a picture before words."""
_NO_KEY = "– "
"""What the keys of an action without any consist of."""


def help_menu(state: PageState, back: Callable[[], PageScreen], under: PageScreen | None = None) -> MenuScreen:
    """How to play: the desktop's help in one piece."""
    return MenuScreen(state, tr("How to play"), lambda _menu: ((), _read(_help_items(state.theme))), back, under)


def credits_menu(state: PageState, back: Callable[[], PageScreen]) -> MenuScreen:
    """Who made the game, and after whose notes."""
    return MenuScreen(state, tr("Credits"), lambda _menu: ((about(),), _read(_credit_items())), back)


def _credit_items() -> Iterable[PageItem]:
    """What the game owes to whom."""
    computed = tr("is computed: pictures while you play, sounds and music when this page was built.")
    for title, words in credit_parts(PAGE, computed):
        yield from _part(title, [PageItem("", words, "words")])
    yield PageItem("", version(), "words")


def _help_items(theme: Theme) -> Iterable[PageItem]:
    """The parts of the help, with the keys that hold now."""
    mouse = tr("The nearest paddle follows the pointer; a click serves.")
    devices = (keyboard_words(), (tr("Mouse"), mouse), *other_controls())
    keys = [row for row in play_help() if row[0].strip(_NO_KEY)]
    yield from _part(tr("The game"), [PageItem("", line, "words") for line in game_words()])
    yield from _part(tr("Aiming"), [PageItem("", line, "words") for line in aiming_words()])
    signs = [PageItem("", power_words(kind), "words", picture=_sign(kind, theme)) for kind in PowerUp]
    around = [PageItem("", line, "words") for line in (powers_words(), gauges_words())]
    yield from _part(tr("Power-ups"), [around[0], *signs, around[1]])
    yield from _part(tr("Controls"), [PageItem("", name, "pair", hint=how) for name, how in devices])
    yield from _part(tr("Keys"), [PageItem("", names, "pair", hint=meaning) for names, meaning in keys])
    drop = tr("Drop a replay (.polar), a level (.toml) or functions of your own (.py) on this page to open them.")
    yield from _part(tr("Files"), [PageItem("", drop, "words")])


def _part(title: str, items: Iterable[PageItem]) -> Iterable[PageItem]:
    """A heading, and what is below it."""
    yield PageItem("", title, "heading")
    yield from items


def _sign(kind: PowerUp, theme: Theme) -> tuple[float, ...]:
    """A power-up's sign as a list of primitives."""
    out = DisplayList()
    add_chip(out, kind, _SIGN, _SIGN_RADIUS, theme)
    return tuple(out.numbers)


def _read(items: Iterable[PageItem]) -> list[Opened]:
    """Items that are only read, each with an id of its own."""
    return [Opened(structs.replace(item, id=f"read-{number}")) for number, item in enumerate(items)]
