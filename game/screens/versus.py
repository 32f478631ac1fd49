"""Two players against each other: what each has, beside the arena, and who has won."""

from game.drawing.canvas import Canvas
from game.language import ntr, tr
from game.rules import Game, winner

# Lengths are in units of text.
_EDGE, _CAPTION, _FIGURE, _LIVES = 0.8, 0.9, 1.6, 1.0
"""From the words to the surface's edge, and sizes of letters."""
_HEIGHTS = (0.63, 0.4)
"""Where the words of each player stand, in shares of the surface's height: the second one has the upper half."""


def draw(canvas: Canvas, game: Game) -> None:
    """Points and lives of both players, each beside the half that is theirs; the leading one's in the accent's colour."""
    ahead = winner(game)
    for index, side in enumerate(game.sides):
        corner = complex(canvas.unit * _EDGE, canvas.size[1] * _HEIGHTS[index])
        colour = canvas.theme.accent if index == ahead else canvas.theme.text
        box = canvas.write(player_name(index).upper(), _CAPTION, canvas.theme.faint, corner)
        box = canvas.write(f"{side.score:,}", _FIGURE, colour, complex(box.left, box.bottom + canvas.unit * 0.1))
        lives = ntr("{count} life", "{count} lives", side.lives).format(count=side.lives)
        canvas.write(lives, _LIVES, canvas.theme.faint, complex(box.left, box.bottom + canvas.unit * 0.1))


def player_name(index: int) -> str:
    """What a player is called. index: 0 for the one below the centre."""
    return tr("Player {number}").format(number=index + 1)


def verdict(game: Game) -> str:
    """Who has won, in words."""
    who = winner(game)
    return tr("A draw") if who is None else tr("{player} wins").format(player=player_name(who))
