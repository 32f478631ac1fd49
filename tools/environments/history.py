"""The controls of one environment's games, as far as a replay of them needs."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any, Self

from game.autopilot.source_pilot import SourcePilot
from game.levels import Level
from game.replays.file import MAX_TICKS, Recorder, save
from game.replays.state_hash import state_hash
from game.rules import Controls, Game, new_game, tick

_Step = tuple[int, int, int, int]
"""Turn, pointer (-1 for none), ticks, and the last tick of the game that served."""


class _Played:
    """The steps of one game."""

    def __init__(self, seed: int, steps: list[_Step]) -> None:
        self.seed = seed
        self.steps = steps


class History:
    """The game that is played, and the one before it."""

    def __init__(self, *, autopilot: bool = False) -> None:
        """Before the first game. autopilot: whether it plays; then the steps say for how long."""
        self._autopilot = autopilot
        self._before: _Played | None = None
        self._now = _Played(0, [])

    def copy(self) -> Self:
        """One that goes on by itself."""
        other = type(self)(autopilot=self._autopilot)
        other._before = self._before  # noqa: SLF001  # nothing is added to it any more
        other._now = _Played(self._now.seed, self._now.steps.copy())  # noqa: SLF001
        return other

    def begin(self) -> None:
        """A new game."""
        self._before = self._now if self._now.steps else self._before
        self._now = _Played(0, [])

    def add(self, episode: Any) -> None:
        """One step, as the row of its environment tells it."""
        self._now.seed = int(episode["seed"])
        self._now.steps.append((int(episode["turn"]), int(episode["pointer"]), int(episode["played"]), int(episode["served"])))

    def save(self, path: Path, level: Level, game: Game) -> None:
        """Write the game that is played, or, where it has just begun, the one before. game: as it stands now."""
        current = self._now if self._now.steps else self._before
        if current is None:
            raise ValueError("nothing to record: no step was taken")
        recorder = Recorder((level,), current.seed)
        replayed = new_game((level,), current.seed)
        pilot = SourcePilot()
        for held in _controls(current.steps):
            controls = pilot.controls(replayed) if self._autopilot else held
            replayed = tick(replayed, controls).game
            recorder.add(controls, replayed)
        if replayed.tick > MAX_TICKS:
            raise ValueError(f"a replay holds at most {MAX_TICKS} ticks, not {replayed.tick}")
        assert current is not self._now or state_hash(replayed) == state_hash(game), "game.rules plays another game"
        save(recorder.recording(), path)


def _controls(steps: list[_Step]) -> Iterator[Controls]:
    """The controls, tick by tick."""
    tick = 0
    for turn, pointer, ticks, served in steps:
        for _ in range(ticks):
            tick += 1
            yield Controls(turn, pointer if pointer >= 0 else None, tick == served)
