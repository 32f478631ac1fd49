"""Programs that check and measure the game and its physics from outside."""

import sys
from importlib.util import find_spec
from pathlib import Path

_HOME = Path(__path__[0]).parent
_GAME = find_spec("game")
if _GAME is None or _GAME.submodule_search_locations != [str(_HOME / "game")]:
    sys.path.insert(0, str(_HOME))  # a foreign `game` would be found before ours, which sees to the rest
