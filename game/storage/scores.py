"""The table of high scores. A score carries its replay's name and hash, so that it can be verified."""

import hashlib
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from game.replays.file import decoded
from game.replays.verify import verified
from game.storage.progress import Count, Digest, Word
from game.system.errors import BadInputError
from game.system.files import read_input

VERSION = 1
MOST = 10
"""Scores in the table of one difficulty."""
ENDLESS = "endless"
"""The name of the table, in place of a difficulty's, for games on levels that are made from a seed."""
LONGEST_NAME = 16
"""Characters of a player's name."""
_LARGEST_REPLAY = 16 * 1024 * 1024


class Score(msgspec.Struct, frozen=True):
    """One line of the table.

    name: the player's. score: points. difficulty: its name. first, last: names of the levels where the game began and ended.
    won: whether the last level was finished. speed: of the game in per cent, the slowest that it was played at.
    date: "2026-01-31". replay: name of its file; sha256: of that file, in hex.
    """

    name: Annotated[str, Meta(max_length=LONGEST_NAME)]
    score: Count
    difficulty: Word
    first: Word = ""
    last: Word = ""
    won: bool = False
    speed: Annotated[int, Meta(ge=1, le=100)] = 100
    date: Annotated[str, Meta(max_length=20)] = ""
    replay: Word = ""
    sha256: Digest = ""


class Scores(msgspec.Struct, frozen=True):
    """All scores. last_name: that was entered last, to be offered the next time."""

    version: int = VERSION
    entries: Annotated[list[Score], Meta(max_length=1000)] = []
    last_name: Annotated[str, Meta(max_length=LONGEST_NAME)] = ""

    def table(self, difficulty: str) -> list[Score]:
        """The scores of a difficulty, the best first; of equals, the one that was there first."""
        return sorted([score for score in self.entries if score.difficulty == difficulty], key=lambda score: -score.score)[
            :MOST
        ]

    def qualifies(self, score: int, difficulty: str) -> bool:
        """Whether a score would stand in the table."""
        table = self.table(difficulty)
        return score > 0 and (len(table) < MOST or score > table[-1].score)

    def after(self, score: Score) -> "Scores":
        """The scores with one more; those that have dropped out of the table are forgotten."""
        entries = [*self.entries, score]
        staying = []
        for difficulty in dict.fromkeys([entry.difficulty for entry in entries]):
            staying += msgspec.structs.replace(self, entries=entries).table(difficulty)
        return msgspec.structs.replace(self, entries=staying, last_name=score.name)


def objection(score: Score, folder: Path) -> str | None:
    """Why a score cannot be believed: its replay is gone, another one, or plays to other points; None where it can.

    Plays the whole game again.
    """
    if not score.replay:
        return "no replay was kept"
    if Path(score.replay).name != score.replay:
        return "its replay is outside of the folder"
    try:
        data = read_input(folder / score.replay, "replay", _LARGEST_REPLAY)
        if hashlib.sha256(data).hexdigest() != score.sha256:
            return "its replay is another one than when the score was made"
        verdict = verified(decoded(data, score.replay))
    except BadInputError as error:
        return str(error)
    if verdict.divergence is not None:
        return str(verdict.divergence)
    return None if verdict.game.score == score.score else f"its replay makes {verdict.game.score} points"
