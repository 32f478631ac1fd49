"""How balls may look and what they may leave behind: names, and what a player must have done for each."""

from collections.abc import Callable, Iterable
from typing import NamedTuple

from game.language import grouped, ntr, tr
from game.rules import Rank

PLAIN_BALL, PLAIN_TRAIL = "pearl", "comet"
"""What everybody has."""


class Feat(NamedTuple):
    """A level that was finished, and the best that was done in it."""

    level: str
    score: int
    rank: Rank


class Condition(NamedTuple):
    """What must have been done.

    needed: of what `counted` counts.
    counted: of all feats.
    said: what is asked for, in words, for a number.
    """

    needed: int
    counted: Callable[[dict[str, Feat]], int]
    said: Callable[[int], str]

    @property
    def text(self) -> str:
        """In words."""
        return self.said(self.needed)


def _levels(best: dict[str, Feat]) -> int:
    """Levels finished."""
    return len(best)


def _points(best: dict[str, Feat]) -> int:
    """Points of all levels together."""
    return sum([feat.score for feat in best.values()])


def _good(best: dict[str, Feat]) -> int:
    """Levels with rank A or better."""
    return sum([feat.rank >= Rank.A for feat in best.values()])


def _perfect(best: dict[str, Feat]) -> int:
    """Levels with rank S."""
    return sum([feat.rank >= Rank.S for feat in best.values()])


def _levels_said(count: int) -> str:
    return ntr("Finish {count} level", "Finish {count} levels", count).format(count=count)


def _points_said(count: int) -> str:
    return tr("Make {count} points in all levels together").format(count=grouped(count))


def _good_said(count: int) -> str:
    return ntr("Finish {count} level with rank A", "Finish {count} levels with rank A", count).format(count=count)


def _perfect_said(count: int) -> str:
    return ntr("Finish {count} level with rank S", "Finish {count} levels with rank S", count).format(count=count)


BALLS: dict[str, Condition] = {
    PLAIN_BALL: Condition(0, _levels, _levels_said),
    "marble": Condition(3, _levels, _levels_said),
    "target": Condition(3, _good, _good_said),
    "ember": Condition(20_000, _points, _points_said),
    "eclipse": Condition(15, _levels, _levels_said),
    "prism": Condition(8, _perfect, _perfect_said),
}
"""How balls may look, and what must have been done for it."""
TRAILS: dict[str, Condition] = {
    PLAIN_TRAIL: Condition(0, _levels, _levels_said),
    "ribbon": Condition(2, _levels, _levels_said),
    "beads": Condition(10_000, _points, _points_said),
    "rings": Condition(6, _good, _good_said),
    "spectrum": Condition(20, _levels, _levels_said),
}
"""What balls may leave behind, and what must have been done for it."""


def ball_names() -> dict[str, str]:
    """What the balls are called, in the player's language."""
    return {
        PLAIN_BALL: tr("Pearl"),
        "marble": tr("Marble"),
        "target": tr("Target"),
        "ember": tr("Ember"),
        "eclipse": tr("Eclipse"),
        "prism": tr("Prism"),
    }


def trail_names() -> dict[str, str]:
    """What the trails are called, in the player's language."""
    return {
        PLAIN_TRAIL: tr("Comet"),
        "ribbon": tr("Ribbon"),
        "beads": tr("Beads"),
        "rings": tr("Rings"),
        "spectrum": tr("Spectrum"),
    }


def unlocked(conditions: dict[str, Condition], feats: Iterable[Feat]) -> tuple[str, ...]:
    """The names of `BALLS` or of `TRAILS` that a player may choose. feats: of any levels, of one level more than one may be."""
    best: dict[str, Feat] = {}
    for feat in feats:
        before = best.get(feat.level, feat)
        best[feat.level] = Feat(feat.level, max(feat.score, before.score), max(feat.rank, before.rank))
    return tuple([name for name, condition in conditions.items() if condition.counted(best) >= condition.needed])
