"""What levels are called in the player's language."""

import re

from game.language import tr

GENERATED = "Endless {number}"
"""The name of a level that was made from a seed. number: its position among those of the seed, from 1."""
_GENERATED = re.compile(r"Endless (\d+)(.*)")


def level_name(name: str) -> str:
    """A level's name, as it is in its file or among kept scores, in the player's language."""
    found = _GENERATED.fullmatch(name)
    return tr("Endless {number}").format(number=found[1]) + found[2] if found else tr(name)
