"""The language that the player reads: every text that a screen shows passes through `tr`.

A text in the code is English and is its own key; `ntr` is for texts with a count in them, `tr_noop` for those in tables that
are made before the language is known. The translations are the .po files in game/languages, which any gettext editor opens.
"""

import gettext
import io
from collections.abc import Iterable
from functools import cache
from importlib.resources import files
from typing import NamedTuple


class Language(NamedTuple):
    """A language of the game. code: as in ISO 639. name: what its speakers call it."""

    code: str
    name: str


ENGLISH = Language("en", "English")
LANGUAGES = (ENGLISH, Language("de", "Deutsch"), Language("cs", "Čeština"))
CODES = tuple([language.code for language in LANGUAGES])
SYSTEM = "system"
"""A player's choice to read what the system prefers."""

_THOUSANDS = {"en": ",", "de": ".", "cs": "\N{NO-BREAK SPACE}"}
_POINT = {"en": ".", "de": ",", "cs": ","}
"""Separator of thousands and decimal point, by language."""


class _Reader:
    """Who reads. preferred: the codes of the languages that the system prefers. catalogue: the translations in use."""

    def __init__(self) -> None:
        """English, and a system without preferences."""
        self.preferred: tuple[str, ...] = ()
        self.catalogue: gettext.NullTranslations = gettext.NullTranslations()


_reader = _Reader()


def tr(message: str) -> str:
    """A text in the player's language. message: English; the text itself where it has no translation."""
    return _reader.catalogue.gettext(message) if message else ""


def ntr(one: str, many: str, count: int) -> str:
    """A text for a count in the player's language. one, many: English, for a count of 1 and for any other."""
    return _reader.catalogue.ngettext(one, many, count)


def tr_noop(message: str) -> str:
    """The text itself: marks one that is shown through `tr(variable)` later."""
    return message


def grouped(number: int) -> str:
    """A number with its thousands separated as in the player's language."""
    return f"{number:,}".replace(",", _THOUSANDS[current()])


def decimal(number: float, digits: int) -> str:
    """A number with some decimal digits and the decimal point of the player's language."""
    return f"{number:.{digits}f}".replace(".", _POINT[current()])


def system_prefers(locales: Iterable[str]) -> None:
    """Say what the system prefers, the best first: names of locales or languages, such as "cs_CZ" or "de"."""
    _reader.preferred = tuple([locale.replace("-", "_").partition("_")[0].lower() for locale in locales])


def choose(code: str) -> None:
    """Let texts be in a language from now on. code: of one of LANGUAGES, or SYSTEM."""
    if code == SYSTEM:
        code = next((preferred for preferred in _reader.preferred if preferred in CODES), ENGLISH.code)
    _reader.catalogue = catalogue(code)


def current() -> str:
    """The code of the language that texts are in."""
    return _reader.catalogue.info().get("language", ENGLISH.code)


@cache
def catalogue(code: str) -> gettext.NullTranslations:
    """The translations into a language; none into English."""
    if code == ENGLISH.code:
        return gettext.NullTranslations()
    compiled = files("game.languages").joinpath(f"{code}.mo")
    if compiled.is_file():  # in a browser
        return gettext.GNUTranslations(io.BytesIO(compiled.read_bytes()))
    import polib  # noqa: PLC0415  # only where a translation is wanted

    text = files("game.languages").joinpath(f"{code}.po").read_text(encoding="utf-8")
    return gettext.GNUTranslations(io.BytesIO(polib.pofile(text).to_binary()))
