"""How far the player has come: the best result of every level at every difficulty."""

from functools import cache
from typing import Annotated

import msgspec
from msgspec import Meta

from game.levels import Level, built_in

VERSION = 1
RANKS = ("C", "B", "A", "S")
"""The ranks of a finished level, worst first."""

_MOST_OWN = 100
"""Bests of levels of the player's own that are kept: every change of such a level makes another one of it."""
OWN = "own "
"""Begins the name under which the best of a level of the player's own is kept."""

Word = Annotated[str, Meta(max_length=200)]
Count = Annotated[int, Meta(ge=0, le=2**53)]
Digest = Annotated[str, Meta(pattern="^([0-9a-f]{64})?$")]


class Best(msgspec.Struct, frozen=True):
    """The best that was done in one level at one difficulty.

    level: its name. difficulty: its name. score: points made in the level. rank: index in RANKS. ticks: that it took.
    replay: name of the file of the game in which the score was made, empty for none; sha256: of that file, in hex.
    start: tick of that game at which the level began.
    """

    level: Word
    difficulty: Word
    score: Count = 0
    rank: Annotated[int, Meta(ge=0, le=len(RANKS) - 1)] = 0
    ticks: Count = 0
    replay: Word = ""
    sha256: Digest = ""
    start: Count = 0


class Progress(msgspec.Struct, frozen=True):
    """All bests. last_level: where the player was last; last_difficulty: chosen last."""

    version: int = VERSION
    bests: Annotated[list[Best], Meta(max_length=10_000)] = []
    last_level: Word = ""
    last_difficulty: Word = ""

    def best(self, level: str, difficulty: str) -> Best | None:
        """The best of a level; None where it was never finished at this difficulty."""
        return next((best for best in self.bests if (best.level, best.difficulty) == (level, difficulty)), None)

    def finished(self, level: str) -> bool:
        """Whether a level was finished at any difficulty."""
        return any([best.level == level for best in self.bests])

    def after(self, done: Best) -> "Progress":
        """The progress after a level was finished once more: the better score with its replay, the better rank and time."""
        before = self.best(done.level, done.difficulty)
        if before is not None:
            better = (done.score, bool(done.replay)) > (before.score, bool(before.replay))
            leading, other = (done, before) if better else (before, done)
            rank, ticks = max(done.rank, before.rank), min(leading.ticks or other.ticks, other.ticks or leading.ticks)
            done = msgspec.structs.replace(leading, rank=rank, ticks=ticks)
        others = [best for best in self.bests if best is not before]
        own = [best for best in others if best.level.startswith(OWN)]
        if len(own) >= _MOST_OWN:
            others.remove(own[0])
        return msgspec.structs.replace(self, bests=[*others, done])

    def is_open(self, index: int, levels: list[str]) -> bool:
        """Whether a level may be begun: the first, every finished one, and the one after it. levels: names in order."""
        return index == 0 or self.finished(levels[index]) or self.finished(levels[index - 1])


def record_name(level: Level) -> str:
    """The name under which a level's best is kept: its own, or for a level of the player's what is in it."""
    return level.name if is_built_in(level) else f"{OWN}{level.content_hash()}"


def is_built_in(level: Level) -> bool:
    """Whether a level comes with the game."""
    return level.content_hash() in _built_in_hashes()


@cache
def _built_in_hashes() -> frozenset[str]:
    """The hashes of the levels that come with the game."""
    return frozenset([level.content_hash() for level in built_in()])
