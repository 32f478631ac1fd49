"""What the player is told now: a few words, and what to do. No window, no page."""

from typing import NamedTuple

from game.language import ntr, tr
from game.levels.names import level_name
from game.overlay.readings import player_name
from game.rules import LIVES, Game, Phase


class Notice(NamedTuple):
    """A few words, what to do, and what the level is about; the hint and what it is about may be empty."""

    title: str
    hint: str
    about: str = ""


def ready() -> Notice:
    """What is said before play goes on after a pause."""
    return Notice(tr("Ready"), "")


def notice(game: Game, serve: str) -> Notice | None:
    """What to tell the player; None while a ball is in play. serve: the name of the key that serves."""
    if game.phase == Phase.SERVING:
        about = tr(game.level.description) if _is_new(game) else ""
        return Notice(_serve_title(game), tr("{key} or click: serve along the arrow").format(key=serve), about)
    if game.phase == Phase.CLEARED:
        words = tr("Next: {level}. {key} or click: go on").format(
            level=level_name(game.levels[game.number + 1].name), key=serve
        )
        return Notice(tr("Level cleared"), words)
    if game.phase == Phase.WON:
        return Notice(tr("All levels cleared"), "")
    return Notice(tr("Game over"), "") if game.phase == Phase.OVER else None


def who_steers(game: Game, first: str, second: str, serve: str) -> Notice | None:
    """Which keys each of two players has, before the first serve of a game; None later. first, second, serve: names of keys."""
    if game.phase != Phase.SERVING or game.tick != game.phase_tick:
        return None
    words = tr("Player 1: {first}. Player 2: {second}. {key}: serve").format(first=first, second=second, key=serve)
    return Notice(_serve_title(game), words)


def to_newcomer(told: Notice, left: str, right: str) -> Notice:
    """The same for somebody who has not finished a level yet: it says how one steers. left, right: the names of the keys."""
    steering = tr("{left}, {right} or the mouse: turn the paddles").format(left=left, right=right)
    return told._replace(about=f"{told.about}\n{steering}") if told.about else told


def by_touch(told: Notice, game: Game, *, new: bool) -> Notice:
    """The notice for a player who plays by touch. new: whether no level is finished yet, so that it explains the steering."""
    steering = tr("Drag to where a paddle should go; tap to serve. In 3D two fingers turn and zoom.") if new else ""
    if game.phase == Phase.SERVING:
        lines = [line for line in (told.about, steering) if line]
        return told._replace(hint=tr("Tap: serve along the arrow"), about="\n".join(lines) if told.about else "")
    if game.phase == Phase.CLEARED:
        return told._replace(hint=tr("Next: {level}. Tap: go on").format(level=level_name(game.levels[game.number + 1].name)))
    return told


def _is_new(game: Game) -> bool:
    """Whether no ball of the level was served yet."""
    tally = game.statistics.level
    return tally.ticks == 0 and tally.balls_lost == 0


def _serve_title(game: Game) -> str:
    """The level's name before its first serve, else what is left."""
    if game.sides and game.statistics.level.balls_lost:
        return tr("{player} serves").format(player=player_name(game.server))
    if game.tick == game.phase_tick or (game.statistics.level.balls_lost == 0 and game.ruleset.arcade) or game.lives == LIVES:
        return level_name(game.level.name)
    if game.lives == 1:
        return tr("Last life")
    return ntr("{count} life left", "{count} lives left", game.lives).format(count=game.lives)
