"""Which tasks of the course are done, kept in the user's data folder from one session to the next."""

from pathlib import Path

import msgspec

from game.storage.stored_file import StoredFile

VERSION = 1
NAME = "lab-progress.json"
"""Of the file."""


class CourseProgress(msgspec.Struct, frozen=True):
    """The file. done: names of tasks."""

    version: int = VERSION
    done: frozenset[str] = frozenset()


def course_progress(path: Path | None) -> StoredFile[CourseProgress]:
    """This session's hold on a file of progress; None keeps it in memory alone."""
    return StoredFile(path, CourseProgress, VERSION)


def keep_done(file: StoredFile[CourseProgress], done: frozenset[str]) -> None:
    """Write down what is done now, beside what another process has written."""
    file.update(lambda held: CourseProgress(VERSION, held.done | done))
