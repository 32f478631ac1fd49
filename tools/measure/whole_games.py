"""How much faster than real time whole games are: without a window, and verified from a recording."""

import time
from collections.abc import Iterator

from game.headless import autopilot_game
from game.levels import chosen
from game.replays.file import Recorder
from game.replays.verify import verified
from game.rules import TICK

_SEED = 7
_TICKS, _QUICK_TICKS = 40_000, 8_000


def speeds(*, quick: bool) -> Iterator[str]:
    """A line each for the autopilot on the first level and for the verification of its recording. Processor time."""
    levels, ticks = chosen("First Wall"), _QUICK_TICKS if quick else _TICKS
    start = time.process_time()
    game = autopilot_game(levels, _SEED, ticks)
    yield f"headless game with the autopilot: {game.tick * TICK / (time.process_time() - start):,.0f} times real time"
    recorder = Recorder(levels, _SEED)
    autopilot_game(levels, _SEED, ticks, recorder)
    recording = recorder.recording()
    start = time.process_time()
    verdict = verified(recording)
    assert verdict.divergence is None
    yield f"verification of its recording: {verdict.game.tick * TICK / (time.process_time() - start):,.0f} times real time"
