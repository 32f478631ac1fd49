"""The choices for new games: difficulty or the source's rules, and how many play."""

import msgspec

from game.input.key_names import players_keys
from game.input.players import Players, players_words
from game.language import tr
from game.screens.app_state import AppState
from game.screens.difficulty_names import DIFFICULTIES, difficulty_name, ruleset_of
from game.screens.toolkit.items.basic import ChoiceItem


def players_choice(state: AppState) -> ChoiceItem:
    """The item that chooses how many play on this machine."""

    def choose(index: int) -> None:
        state.players = Players(index)

    names, tips = zip(*players_words(*players_keys()), strict=True)
    return ChoiceItem(tr("Players"), names, int(state.players), choose, tips[state.players])


def difficulty_choice(state: AppState) -> ChoiceItem:
    """The item that chooses the difficulty, and stores the choice."""

    def choose(index: int) -> None:
        state.ruleset = ruleset_of(DIFFICULTIES[index])
        state.storage.progress.update(lambda held: msgspec.structs.replace(held, last_difficulty=DIFFICULTIES[index]))

    names = tuple([difficulty_name(name) for name in DIFFICULTIES])
    tip = tr("Easy: slower balls, wider paddles, more lives. Source's rules: one speed, no power-ups. Each has its own scores.")
    return ChoiceItem(tr("Difficulty"), names, DIFFICULTIES.index(state.difficulty), choose, tip)
