"""The language that the player reads: every text that a screen shows passes through `tr`.

A text in the code is English and is its own key. `ntr` is for texts with a count in them.
"""

import gettext

_catalogue: gettext.NullTranslations = gettext.NullTranslations()


def tr(message: str) -> str:
    """A text in the player's language. message: English; the text itself where it has no translation."""
    return _catalogue.gettext(message)


def ntr(one: str, many: str, count: int) -> str:
    """A text for a count in the player's language. one, many: English, for a count of 1 and for any other."""
    return _catalogue.ngettext(one, many, count)
