"""Draw the documentation's figures: `python -m tools.figures`."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from game.system.command_line import run
from tools.figures.flow import flow, imports
from tools.figures.response import response_symbols
from tools.figures.sheet import Sheet
from tools.figures.sweep import free_flight_symbols, sweep_symbols
from tools.figures.symbols import end_symbols, polar_symbols

FIGURES: dict[str, Callable[[], Sheet]] = {
    "symbols": polar_symbols,
    "end": end_symbols,
    "sweep": sweep_symbols,
    "free-flight": free_flight_symbols,
    "response": response_symbols,
    "flow": flow,
    "imports": imports,
}
"""Every figure by the name of its file."""

FOLDER = Path(__file__).parents[2] / "docs" / "figures"

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.figures"))


@app.command()
def draw(folder: Annotated[Path, typer.Option(help="Where to write the files.")] = FOLDER) -> None:
    """Draw every figure of the documentation into SVG files."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, sheet in FIGURES.items():
        sheet().save(folder / f"{name}.svg")
        typer.echo(folder / f"{name}.svg")


if __name__ == "__main__":
    main()
