"""Where the files of the user's data are on this system."""

from pathlib import Path

import platformdirs


def data_folder() -> Path | None:
    """The folder of the user's data; None where the system knows none."""
    try:
        folder = platformdirs.user_data_path("polar-breakout", appauthor=False)
    except (RuntimeError, OSError):  # no home
        return None
    return folder if folder.is_absolute() else None
