"""The game's chance: numbers that its seed and how many were drawn before decide, and nothing else."""

import random

from game.rules.state import Game


def drawn(game: Game) -> tuple[float, Game]:
    """A random number in [0, 1), and the game that has drawn it."""
    return chance_number(game.seed, game.draws), game._replace(draws=game.draws + 1)


def chance_number(seed: int, draws: int) -> float:
    """Number `draws`, from 0, of a seed's chance, in [0, 1)."""
    return random.Random((seed << 32) + draws).random()
