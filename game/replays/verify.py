"""Does a recording still play the same game? And if not, where do the two part?"""

from itertools import islice
from typing import NamedTuple

from game.replays.file import BLOCK, Recording, controls_of, started
from game.replays.state_hash import field_checks, fields, state_hash
from game.rules import Game, tick


class Divergence(NamedTuple):
    """Where a recording and the game that is played from it part.

    block: the first whose hash differs; block k ends after tick (k + 1) BLOCK.
    tick: the first whose trace differs, counted from 1; None where the whole block's trace agrees.
    field: the first that differs there, of state_hash.fields; None where tick is.
    """

    block: int
    tick: int | None
    field: str | None

    def __str__(self) -> str:
        first, last = self.block * BLOCK + 1, (self.block + 1) * BLOCK
        if self.tick is None:
            return f"diverged in ticks {first}-{last}: the trace agrees, the recorded hash does not"
        return f"diverged at tick {self.tick} (block {first}-{last}), first in: {self.field}"


class Verdict(NamedTuple):
    """What playing a recording again gave.

    game: as far as it was played, to the end or to the end of the first block that differs.
    divergence: None where every block agrees.
    """

    game: Game
    divergence: Divergence | None


def verified(recording: Recording) -> Verdict:
    """The recording played again and held against its hashes, up to the first block that differs."""
    game = started(recording)
    controls = controls_of(recording)
    for block in range(len(recording.hashes) // 32):
        start = game
        part = list(islice(controls, BLOCK))
        for one in part:
            game = tick(game, one).game
        if bytes.fromhex(state_hash(game)) != recording.hashes[block * 32 : block * 32 + 32]:
            game = start
            for one in part:
                game = tick(game, one).game
                checks = field_checks(game)
                for number, field in enumerate(fields(recording.ruleset)):
                    if checks[number] != recording.trace[number * recording.ticks + game.tick - 1]:
                        return Verdict(game, Divergence(block, game.tick, field))
            return Verdict(game, Divergence(block, None, None))
    return Verdict(game, None)
