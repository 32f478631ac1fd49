"""All stored files of a session, and what could not be read or written."""

from pathlib import Path

import msgspec

from game.storage import progress, scores, window
from game.storage.games import GameFiles, StoredGame
from game.storage.progress import Best, Progress
from game.storage.scores import Score, Scores
from game.storage.stored_file import StoredFile
from game.storage.window import WindowBox

NO_FOLDER = "no folder of the user's: nothing is saved"


class Storage:
    """The files of a session. folder: that they are in; None keeps everything in memory alone."""

    def __init__(self, folder: Path | None, record: Path | None = None) -> None:
        """Read what there is. record: a file that gets the last game of the session as well."""
        self._finished: list[Best] = []
        self.scores = StoredFile(None if folder is None else folder / "scores.json", Scores, scores.VERSION)
        self.progress = StoredFile(None if folder is None else folder / "progress.json", Progress, progress.VERSION)
        self.window = StoredFile(None if folder is None else folder / "window.json", WindowBox, window.VERSION)
        self.games = GameFiles(None if folder is None else folder / "replays", self.needed, record)

    @property
    def problems(self) -> list[str]:
        """What went wrong, one line each."""
        no_folder = [NO_FOLDER] if self.games.folder is None else []
        named = (("scores", self.scores), ("progress", self.progress), ("window", self.window), ("game", self.games))
        return [*no_folder, *[f"{name} {held.problem}" for name, held in named if held.problem is not None]]

    def level_done(self, best: Best) -> Best | None:
        """Note that a level was finished, before anything else can happen; the best before it. Its replay is known later."""
        before = self.progress.value.best(best.level, best.difficulty)
        self.progress.update(lambda held: held.after(best))
        self._finished.append(best)
        return before

    def game_done(self) -> StoredGame | None:
        """Write the game that was played and let the levels finished in it refer to its replay; None where none was kept."""
        self.games.close()
        last, finished, self._finished = self.games.last, self._finished, []
        if last is not None and finished:
            replayed = [msgspec.structs.replace(best, replay=last.file, sha256=last.sha256) for best in finished]

            def change(held: Progress) -> Progress:
                for best in replayed:
                    held = held.after(best)
                return held

            self.progress.update(change)
        return last

    def enter(self, score: Score) -> None:
        """Put a score into the table."""
        self.scores.update(lambda held: held.after(score))

    def needed(self) -> set[str]:
        """Names of the replays that a score or a best refers to."""
        return {score.replay for score in self.scores.value.entries} | {best.replay for best in self.progress.value.bests}
