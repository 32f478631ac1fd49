"""The ghost: the best run of a level, played again beside the present one. `game.picture.ghost` shows it."""

import time
from collections.abc import Iterator

from game.levels import Level
from game.replays.file import Recording, load, played
from game.rules import Game, Phase, Ticked
from game.storage.progress import record_name
from game.storage.storage import Storage
from game.system.errors import BadInputError

_BUDGET = 0.004
"""Seconds of a frame that may go into playing the recording up to where it has to be."""


class Ghost:
    """A recorded game from the first serve of one level on, a tick for every tick of the player's after the first serve."""

    def __init__(self, recording: Recording, start: int, number: int) -> None:
        """start: tick of the recording at which the level began. number: of the level in the present game."""
        self._ticks: Iterator[Ticked] = played(recording)
        self._start, self.number = start, number
        self._game: Game | None = None
        self._level = -1
        self._wanted = self._done = 0  # ticks since the level's first serve: the player's, and the recording's
        self._served = self._over = False

    @property
    def game(self) -> Game | None:
        """How it stands; None before the player's first serve, while it lags behind, and after its level's end."""
        return None if self._over or not self._wanted or self._lags else self._game

    def prepare(self) -> None:
        """Play the recording on to where it has to be, for a few milliseconds."""
        until = time.perf_counter() + _BUDGET
        while self._lags and time.perf_counter() < until:
            self._step()

    def after_tick(self, game: Game) -> None:
        """A tick of the player's game has passed: they count from the first serve on."""
        if game.phase not in (Phase.PLAYING, Phase.SERVING) or not (self._wanted or game.phase == Phase.PLAYING):
            return
        prompt = not self._lags
        self._wanted += 1
        if prompt:
            self._step()

    @property
    def _lags(self) -> bool:
        """Whether the recording has to be played on."""
        return not self._over and (not self._served or self._done < self._wanted)

    def _step(self) -> None:
        """One tick of the recording."""
        ticked = next(self._ticks, None)
        if ticked is None:
            self._over = True
            return
        game = self._game = ticked.game
        if self._served:
            self._done += 1
            self._over = game.number != self._level or game.phase > Phase.PLAYING
        else:
            self._level, self._served = game.number, game.tick > self._start and game.phase != Phase.SERVING


def ghost_of(storage: Storage, level: Level, difficulty: str, number: int) -> Ghost | None:
    """The best run of a level, if its replay is still there and was played on this very level: another version is another race.

    number: of the level in the present game.
    """
    folder, best = storage.games.folder, storage.progress.value.best(record_name(level), difficulty)
    if folder is None or best is None or not best.replay:
        return None
    try:
        recording = load(folder / best.replay)
    except BadInputError:
        return None
    same = level.content_hash() in [one.content_hash() for one in recording.levels]
    return Ghost(recording, best.start, number) if same else None
