"""Where this system keeps the progress in the course."""

from pathlib import Path

from game.lab.course.progress import NAME
from game.storage.folder import data_folder


def progress_path() -> Path | None:
    """Where the progress is kept; None where the system knows no folder of the user's."""
    folder = data_folder()
    return None if folder is None else folder / NAME
