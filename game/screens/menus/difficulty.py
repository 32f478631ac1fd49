"""How difficult new games are."""

from game.language import tr
from game.screens.app_state import AppState
from game.screens.toolkit.items import Choice

DIFFICULTIES = ("easy", "normal", "hard")
"""Names of the difficulties, as they are kept in files."""


def difficulty_name(index: int) -> str:
    """A difficulty in the player's language."""
    return (tr("Easy"), tr("Normal"), tr("Hard"))[index]


def difficulty_index(name: str) -> int:
    """The index of a difficulty; of normal for no known name."""
    return DIFFICULTIES.index(name) if name in DIFFICULTIES else DIFFICULTIES.index("normal")


def difficulty_choice(state: AppState) -> Choice:
    """The item that chooses it."""

    def choose(index: int) -> None:
        state.difficulty = index

    names = tuple([difficulty_name(index) for index in range(len(DIFFICULTIES))])
    tip = tr("Easy has slower balls and wider paddles, hard the opposite. Scores and ranks are counted for each alone.")
    return Choice(tr("Difficulty"), names, state.difficulty, choose, tip)
