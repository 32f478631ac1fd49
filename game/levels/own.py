"""The player's own levels: the TOML files of one folder among the user's data."""

from pathlib import Path
from typing import NamedTuple

import platformdirs

from game.levels import Level, load_file
from game.system.errors import BadInputError

_MOST = 200
"""Files that are looked at."""


class OwnLevels(NamedTuple):
    """What the folder holds.

    levels: those that can be played, by file name.
    paths: of their files, in the same order.
    problems: one line for each file that cannot.
    """

    levels: tuple[Level, ...]
    paths: tuple[Path, ...]
    problems: tuple[str, ...]


def own_levels_folder() -> Path:
    """Where the player's levels are."""
    return platformdirs.user_data_path("polar-breakout", appauthor=False) / "levels"


def own_levels(folder: Path | None = None) -> OwnLevels:
    """The levels of a folder, by default the player's; no levels where there is no folder."""
    found = sorted((own_levels_folder() if folder is None else folder).glob("*.toml"))[:_MOST]
    levels, paths, problems = [], [], []
    for path in found:
        try:
            levels.append(load_file(path))
            paths.append(path)
        except BadInputError as error:
            problems.append(str(error))
    return OwnLevels(tuple(levels), tuple(paths), tuple(problems))
