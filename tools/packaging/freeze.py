"""A one-folder application that needs no Python: `python -m tools.packaging.freeze`. It is for the system that makes it."""

import shutil
import sys
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from game.system.command_line import run
from game.system.errors import EnvironmentMissingError

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_ROOT = Path(__file__).parents[2]
_NAME = "polar-breakout"
_UNUSED = ("matplotlib", "PIL", "tkinter", "hypothesis", "pytest", "mypy", "numba", "scipy", "setuptools")
"""Libraries that others of ours can use and that the game never loads."""


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.packaging.freeze"))


@app.command()
def freeze(
    output: Annotated[Path, typer.Option(help="Folder for the application; an older one is replaced.")] = Path("dist"),
) -> None:
    """Build the application and print the path of its program. Exit code 3 without PyInstaller."""
    try:
        from PyInstaller.__main__ import run as pyinstaller  # noqa: PLC0415  # may be missing
    except ImportError:
        raise EnvironmentMissingError("freezing needs PyInstaller: pip install pyinstaller") from None
    with tempfile.TemporaryDirectory() as work:
        pyinstaller(_options(output, Path(work)))
    sys.stdout.write(f"{shutil.which(_NAME, path=output / _NAME)}\n")


def _options(output: Path, work: Path) -> list[str]:
    """PyInstaller's command line. The game's modules are all collected: not all of them are imported by name."""
    return [
        *("--onedir", "--noconfirm", "--clean", "--log-level", "WARN", "--name", _NAME),
        *("--paths", str(_ROOT), "--distpath", str(output), "--workpath", str(work), "--specpath", str(work)),
        *("--collect-submodules", "game", "--collect-data", "game"),
        *[option for name in _UNUSED for option in ("--exclude-module", name)],
        str(_ROOT / "game" / "__main__.py"),
    ]


if __name__ == "__main__":
    main()
