"""Two players against each other: who has won."""

from game.language import tr
from game.overlay.readings import player_name
from game.rules import Game, winner


def verdict(game: Game) -> str:
    """Who has won, in words."""
    who = winner(game)
    return tr("A draw") if who is None else tr("{player} wins").format(player=player_name(who))
