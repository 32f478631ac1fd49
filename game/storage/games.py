"""The games that were played, each stored at its end; of those that the player has not kept, the last twenty."""

import hashlib
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Annotated

import msgspec
from msgspec import Meta

from game.replays.file import Recorder, encoded, save
from game.rules import TICK, Controls, Game, Phase
from game.storage.progress import Count, Digest, Word
from game.storage.stored_file import StoredFile
from game.system.ending import deferred
from game.system.errors import BadInputError
from game.system.files import remove_temporaries, write_new
from game.system.wording import quoted_path

VERSION = 1
MOST = 20
"""Games that stay although the player has not kept them."""
_SHORTEST = 5.0
"""Seconds of a game that is worth keeping."""
SUFFIX = ".polar"


class StoredGame(msgspec.Struct, frozen=True):
    """What the list says about a game, so that it needs not be played again to be listed.

    file: its name in the folder. title: that the player gave it. kept: whether it stays until the player deletes it.
    score, ticks: at its end. first, last: names of the levels where it began and ended. won: whether the last was finished.
    difficulty: its name. date: "2026-01-31 23:59". sha256: of the file, in hex.
    """

    file: Word
    title: Word = ""
    kept: bool = False
    score: Count = 0
    ticks: Count = 0
    first: Word = ""
    last: Word = ""
    won: bool = False
    difficulty: Word = ""
    date: Annotated[str, Meta(max_length=20)] = ""
    sha256: Digest = ""


class StoredGames(msgspec.Struct, frozen=True):
    """The list of the games."""

    version: int = VERSION
    games: Annotated[list[StoredGame], Meta(max_length=10_000)] = []


class GameFiles:
    """Records every game of a session in the window, and writes each when it ends.

    Shorter games than five seconds are not kept. Where writing fails, `problem` says why, and play goes on.
    """

    def __init__(self, folder: Path | None, needed: Callable[[], set[str]] = set, record: Path | None = None) -> None:
        """folder: of the replays; None keeps none. needed: names of files that something else refers to: they stay.

        record: a file that gets the last game of the session as well.
        """
        self.folder, self._needed, self._record = folder, needed, record
        self._index = StoredFile(None if folder is None else folder / "games.json", StoredGames, VERSION)
        self._recorder: Recorder | None = None
        self._game: Game | None = None
        self._write_problem: str | None = None
        self.last: StoredGame | None = None
        if folder is not None:
            remove_temporaries(folder)

    @property
    def problem(self) -> str | None:
        """What went wrong last."""
        return self._write_problem or self._index.problem

    def __call__(self, controls: Controls, after: Game) -> None:
        """Record one tick; the first tick of a game begins a new recording, its end writes it."""
        if after.tick == 1:
            self.close()
            self._recorder, self.last = Recorder(after.levels, after.seed, after.ruleset), None
        if self._recorder is None:
            return
        self._recorder.add(controls, after)
        self._game = after
        if after.phase in (Phase.OVER, Phase.WON):
            self.close()

    def close(self) -> None:
        """Write the game that has been recorded, if it is worth keeping, and forget the oldest beyond twenty."""
        recorder, game, self._recorder = self._recorder, self._game, None
        if recorder is None or game is None:
            return
        recording = recorder.recording()
        with deferred():
            try:
                if self._record is not None:
                    save(recording, self._record)
                if recorder.ticks * TICK >= _SHORTEST and self.folder is not None:
                    self.folder.mkdir(parents=True, exist_ok=True)
                    data = encoded(recording)
                    path = write_new(self.folder, f"{time.strftime('%Y-%m-%d %H-%M-%S')}{SUFFIX}", data)
                    stored = self.last = _described(path.name, game, hashlib.sha256(data).hexdigest())
                    self._index.update(lambda held: _with(held, stored))
                    self._forget_oldest()
            except BadInputError as error:
                self._write_problem = str(error)
            except OSError as error:
                self._write_problem = f"{quoted_path(self.folder)}: {error.strerror or error}"

    def listed(self) -> list[StoredGame]:
        """The games that there are, newest first; of files that the list does not know, the name alone."""
        known = {game.file: game for game in self._index.value.games}
        return [known.get(path.name) or StoredGame(path.name, kept=True, date=path.stem[:16]) for path in self.paths()]

    def paths(self) -> list[Path]:
        """The files of the games, newest first; what is no file, or a link to nothing, is left out."""
        ages: list[tuple[int, str, Path]] = []
        if self.folder is not None:
            for path in self.folder.glob(f"*{SUFFIX}"):
                with suppress(OSError):
                    if path.is_file():
                        ages.append((path.stat().st_mtime_ns, path.name, path))
        return [path for _, _, path in sorted(ages, reverse=True)]

    def change(self, game: StoredGame) -> None:
        """Put other words about a game in the list: another title, whether it is kept."""
        self._index.update(lambda held: _with(held, game))

    def delete(self, game: StoredGame) -> str | None:
        """Remove a game and its file; what went wrong."""
        if self.folder is None or Path(game.file).name != game.file:
            return "not there"
        try:
            (self.folder / game.file).unlink(missing_ok=True)
        except OSError as error:
            return error.strerror or str(error)
        self._index.update(lambda held: _without(held, {game.file}))
        return None

    def export(self, game: StoredGame, folder: Path) -> Path:
        """Copy a game's file into a folder, under its title where it has one: the new path. OSError if it cannot be."""
        if self.folder is None:
            raise FileNotFoundError(game.file)
        data = (self.folder / game.file).read_bytes()
        words = "".join([letter for letter in game.title if letter.isalnum() or letter in " -_"]).strip()
        folder.mkdir(parents=True, exist_ok=True)
        return write_new(folder, f"{words or Path(game.file).stem}{SUFFIX}", data)

    def _forget_oldest(self) -> None:
        """Remove the oldest games beyond those that stay: kept by the player, or needed by a score or a best."""
        needed = self._needed()
        free = [game for game in self.listed() if not game.kept and game.file not in needed]
        gone = {game.file for game in free[MOST:]}
        for name in gone:
            if self.folder is not None:
                (self.folder / name).unlink(missing_ok=True)
        if gone:
            self._index.update(lambda held: _without(held, gone))


def _described(name: str, game: Game, sha256: str) -> StoredGame:
    """What the list says about a game that has just ended."""
    return StoredGame(
        name,
        score=game.score,
        ticks=game.tick,
        first=game.levels[0].name,
        last=game.level.name,
        won=game.phase == Phase.WON,
        difficulty=game.ruleset.difficulty.name.lower() if game.ruleset.arcade else "source",
        date=time.strftime("%Y-%m-%d %H:%M"),
        sha256=sha256,
    )


def _with(held: StoredGames, game: StoredGame) -> StoredGames:
    """The list with a game, which replaces the entry of the same file."""
    others = [other for other in held.games if other.file != game.file]
    return msgspec.structs.replace(held, games=[*others, game])


def _without(held: StoredGames, files: set[str]) -> StoredGames:
    """The list without some files."""
    return msgspec.structs.replace(held, games=[game for game in held.games if game.file not in files])
