"""The difficulties of new games by name. Used by the window and by the page in the browser, so it needs no pygame."""

from game.language import tr
from game.rules import SOURCE_RULES, Difficulty, Ruleset

SOURCE = "source"
"""The name under which scores by the source's rules are kept."""
DIFFICULTIES = (*[difficulty.name.lower() for difficulty in Difficulty], SOURCE)
"""The names under which scores and bests are kept."""


def difficulty_name(name: str) -> str:
    """A difficulty in the player's language; "" for no known one."""
    names = (tr("Easy"), tr("Normal"), tr("Hard"), tr("Source's rules"))
    return dict(zip(DIFFICULTIES, names, strict=True)).get(name, "")


def ruleset_of(name: str) -> Ruleset:
    """The rules of a difficulty; those of a normal game for no known one."""
    if name == SOURCE:
        return SOURCE_RULES
    return Ruleset(Difficulty[name.upper()]) if name in DIFFICULTIES else Ruleset()
