"""The figures of a game that the player reads. No window, no page."""

from typing import NamedTuple

from game.effects import Streak
from game.effects.streaks import NO_STREAK
from game.language import tr
from game.levels import number_of
from game.levels.names import level_name
from game.rules import Game, layers_left, winner


class PlayerReadings(NamedTuple):
    """The figures of one of two players who play against each other.

    leads: whether this player is ahead, or has won. scores: whether bricks in a row count for this player now.
    """

    name: str
    score: int
    lives: int
    leads: bool
    scores: bool


class Readings(NamedTuple):
    """The figures, as they are shown.

    score, combo, lives: of the game.
    level_number: from 1. level_count, level_name: of all levels, and of this one.
    layers: left to be broken.
    muted: whether the sound is off.
    badge: what kind of game this is, when it is not simply played.
    streak: the bricks in a row with their effect; NO_STREAK for players who want none, who see the combo alone.
    palette: name of the arena's colours. players: two who play against each other, else none; then score and lives are theirs.
    """

    score: int
    combo: int
    lives: int
    level_number: int
    level_count: int
    level_name: str
    layers: int
    muted: bool = False
    badge: str = ""
    streak: Streak = NO_STREAK
    palette: str = ""
    players: tuple[PlayerReadings, ...] = ()


def readings(game: Game, streak: Streak = NO_STREAK, *, muted: bool = False, badge: str = "") -> Readings:
    """The figures of a game. The other arguments are those of `Readings`."""
    number, count = number_of(game.level, game.levels)
    left = layers_left(game)
    figures = game.score, game.combo, game.lives, number, count, level_name(game.level.name), left
    return Readings(*figures, muted, badge, streak, game.level.look.palette, _players(game))


def _players(game: Game) -> tuple[PlayerReadings, ...]:
    """The figures of two who play against each other; none where one plays alone."""
    ahead = winner(game)
    return tuple(
        [
            PlayerReadings(player_name(index), *side, leads=index == ahead, scores=index == game.last_player)
            for index, side in enumerate(game.sides)
        ]
    )


def player_name(index: int) -> str:
    """What one of two players is called. index: 0 for the one whose half is below the centre."""
    return tr("Player {number}").format(number=index + 1)
