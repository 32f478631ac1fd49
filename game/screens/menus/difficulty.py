"""How difficult new games are, or by whose rules they are played."""

import msgspec

from game.language import tr
from game.screens.app_state import AppState
from game.screens.difficulty_names import DIFFICULTIES, difficulty_name, ruleset_of
from game.screens.toolkit.items import Choice


def players_choice(state: AppState) -> Choice:
    """The item that chooses how many play on this machine."""

    def choose(index: int) -> None:
        state.two_players = index == 1

    tip = tr("Two together: one has the arrow keys, mouse or gamepad, the other A and D or a second gamepad.")
    return Choice(tr("Players"), (tr("One"), tr("Two together")), int(state.two_players), choose, tip)


def difficulty_choice(state: AppState) -> Choice:
    """The item that chooses it, and remembers it."""

    def choose(index: int) -> None:
        state.ruleset = ruleset_of(DIFFICULTIES[index])
        state.kept.progress.update(lambda held: msgspec.structs.replace(held, last_difficulty=DIFFICULTIES[index]))

    names = tuple([difficulty_name(name) for name in DIFFICULTIES])
    tip = tr("Easy: slower balls, wider paddles, more lives. Source's rules: one speed, no power-ups. Each has its own scores.")
    return Choice(tr("Difficulty"), names, DIFFICULTIES.index(state.difficulty), choose, tip)
