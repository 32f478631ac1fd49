"""The game's chance: numbers that its seed and how many were drawn before decide, and nothing else."""

import random

from game.rules.state import Game


def drawn(game: Game) -> tuple[float, Game]:
    """A random number in [0, 1), and the game that has drawn it."""
    return random.Random((game.seed << 32) + game.draws).random(), game._replace(draws=game.draws + 1)
