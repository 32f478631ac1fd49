"""What the player is told now: a few words, and what to do. No window, no page."""

from typing import NamedTuple

from game.language import ntr, tr
from game.overlay.readings import player_name
from game.rules import LIVES, Game, Phase


class Notice(NamedTuple):
    """A few words, and what to do; the hint may be empty."""

    title: str
    hint: str


def ready() -> Notice:
    """What is said before play goes on after a pause."""
    return Notice(tr("Ready"), "")


def notice(game: Game, serve: str) -> Notice | None:
    """What to tell the player; None while a ball is in play. serve: the name of the key that serves."""
    if game.phase == Phase.SERVING:
        return Notice(_serve_title(game), tr("{key} or click: serve along the arrow").format(key=serve))
    if game.phase == Phase.CLEARED:
        words = tr("Next: {level}. {key} or click: go on").format(level=tr(game.levels[game.number + 1].name), key=serve)
        return Notice(tr("Level cleared"), words)
    if game.phase == Phase.WON:
        return Notice(tr("All levels cleared"), "")
    return Notice(tr("Game over"), "") if game.phase == Phase.OVER else None


def _serve_title(game: Game) -> str:
    """The level's name before its first serve, else what is left."""
    if game.sides and game.statistics.level.balls_lost:
        return tr("{player} serves").format(player=player_name(game.server))
    if game.tick == game.phase_tick or (game.statistics.level.balls_lost == 0 and game.ruleset.arcade) or game.lives == LIVES:
        return tr(game.level.name)
    if game.lives == 1:
        return tr("Last life")
    return ntr("{count} life left", "{count} lives left", game.lives).format(count=game.lives)
