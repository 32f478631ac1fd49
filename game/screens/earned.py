"""Which skins and trails the player has earned, by the stored bests."""

from game.rules import Rank
from game.storage.progress import OWN, Progress
from game.unlocks import BALLS, TRAILS, Feat, ball_names, trail_names, unlocked


def feats(progress: Progress) -> list[Feat]:
    """What the player has done in the built-in levels. Levels of the player's own do not count: they can be made easy."""
    return [Feat(best.level, best.score, Rank(best.rank)) for best in progress.bests if not best.level.startswith(OWN)]


def earned(progress: Progress) -> tuple[str, ...]:
    """The names, in the player's language, of all balls and trails that were earned."""
    done = feats(progress)
    balls, trails = ball_names(), trail_names()
    return (*[balls[name] for name in unlocked(BALLS, done)], *[trails[name] for name in unlocked(TRAILS, done)])
