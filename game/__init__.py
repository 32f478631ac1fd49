"""The game: rules, levels, replays and the autopilot know no pygame; screens, drawing and controls do."""

import os
import sys
from importlib.util import find_spec
from pathlib import Path

VERSION = "0.1.0"
"""Of the game as a whole; a replay names the one that made it."""

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")  # stdout is for the game's own lines


def _own_packages_first() -> None:
    """Look beside this package first, if a foreign `physics` or `tools` would be found before the game's own."""
    home = Path(__path__[0]).parent
    for name in ("physics", "tools"):
        found = find_spec(name)
        if found is None or found.submodule_search_locations != [str(home / name)]:
            sys.path.insert(0, str(home))
            return


_own_packages_first()
