"""Where the console scripts begin.

Installed, this is a package of its own: `polar_breakout`, a name that nobody else has. So the scripts start even where another
`game` or `tools` is found first, on PYTHONPATH or in the working directory, and look for their own packages before it.
"""

import sys
from importlib.util import find_spec
from pathlib import Path
from typing import NoReturn

_HOME = next(str(folder) for folder in Path(__file__).parents if (folder / "game" / "__main__.py").is_file())
_REPAIR = "pip install --force-reinstall polar-breakout"


def play() -> None:
    """Run the console script `polar-breakout` and exit."""
    _own_game_first()
    try:
        from game.__main__ import main  # noqa: PLC0415  # only now is it certain which game that is

        main()
    except ImportError as error:
        _give_up("polar-breakout", error)


def crosscheck() -> None:
    """Run the console script `polar-crosscheck` and exit."""
    _own_game_first()
    try:
        import game  # noqa: F401, PLC0415  # it looks for its own `tools` first
        from tools.crosscheck.__main__ import main  # noqa: PLC0415  # only now is it certain which tools those are

        main()
    except ImportError as error:
        _give_up("polar-crosscheck", error)


def _own_game_first() -> None:
    """Look for `game` beside this package first if another one would be found; `game` does the same for its neighbours."""
    found = find_spec("game")
    if found is None or found.submodule_search_locations != [str(Path(_HOME) / "game")]:
        sys.path.insert(0, _HOME)


def _give_up(program: str, error: ImportError) -> NoReturn:
    """Say in one line what is missing and which folder is incomplete or mixed with another package, and exit with 3."""
    sys.stderr.write(f"{program}: {error}; {_HOME} lacks it or has another package of that name: {_REPAIR}\n")
    sys.exit(3)
