"""Draw the documentation's screenshots of game and lab: `python -m tools.figures.screenshots`."""

import subprocess
import sys
from pathlib import Path
from typing import Annotated

import typer
from PIL import Image

from game.system.command_line import run
from game.system.errors import CheckFailedError

_GAME = ("--size", "1120x700")
_FROM_THE_LAB = ("--size", "960x640", "--theme", "light")
SCREENSHOTS: dict[str, tuple[str, ...]] = {
    "game": ("--headless", "--autopilot", "--level", "14", "--seed", "6", "--ticks", "2400", *_GAME),
    "game-heart": ("--headless", "--autopilot", "--level", "32", "--seed", "7", "--ticks", "2400", "--view", "solid", *_GAME),
    "game-petals": ("--headless", "--autopilot", "--level", "3", "--seed", "3", "--ticks", "2400", "--view", "solid", *_GAME),
    "game-dart-board": (
        "--headless",
        "--autopilot",
        "--level",
        "2",
        "--seed",
        "5",
        "--ticks",
        "2200",
        "--view",
        "solid",
        *_GAME,
    ),
    "game-galaxy": ("--headless", "--autopilot", "--level", "17", "--seed", "4", "--ticks", "2600", "--view", "solid", *_GAME),
    "lab-polar": ("lab", "polar", *_FROM_THE_LAB),
    "lab-on-left": ("lab", "on-left", *_FROM_THE_LAB),
    "lab-broad-phase": ("lab", "broad-phase", *_FROM_THE_LAB),
    "lab-nearest-sector": ("lab", "nearest-sector", *_FROM_THE_LAB),
    "lab-impact-resting": ("lab", "impact-resting", *_FROM_THE_LAB),
    "lab-impact-turning": ("lab", "impact-turning", *_FROM_THE_LAB),
    "lab-case-1": ("lab", "case-1", *_FROM_THE_LAB),
    "lab-case-2": ("lab", "case-2", *_FROM_THE_LAB),
    "lab-closest-point": ("lab", "closest-point", *_FROM_THE_LAB),
    "lab-response-paddle": ("lab", "response-paddle", *_FROM_THE_LAB),
    "lab-inside-material": ("lab", "inside-material", *_FROM_THE_LAB),
    "lab-two-bricks": ("lab", "two-bricks", *_FROM_THE_LAB),
    "lab-discrete-swept": ("lab", "discrete-swept?tick=120", *_FROM_THE_LAB),
    "lab-presented": ("lab", "moving-surface?step=8", "--present", *_FROM_THE_LAB),
    "lab-yours": ("lab", "case-1", "--with", "tools/figures/mine.py", *_FROM_THE_LAB),
}
"""Every screenshot by the name of its file, and what `python -m game` is told to draw it."""

_CHECKOUT = Path(__file__).parents[2]
_COLOURS = 96
"""Colours of the lab's files: few, so that they are small. The game's pictures keep theirs, for they have light and shadow."""

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.figures.screenshots"))


@app.command()
def draw(folder: Annotated[Path, typer.Option(help="Where to write the files.")] = _CHECKOUT / "docs" / "figures") -> None:
    """Draw every screenshot of the documentation into PNG files."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in SCREENSHOTS:
        draw_screenshot(name, folder / f"{name}.png")
        typer.echo(folder / f"{name}.png")


def draw_screenshot(name: str, path: Path) -> None:
    """Draw one of `SCREENSHOTS` by the game's own command."""
    command = [sys.executable, "-m", "game", *SCREENSHOTS[name], "--screenshot", str(path.resolve())]
    finished = subprocess.run(command, capture_output=True, text=True, check=False, cwd=_CHECKOUT)  # noqa: S603
    if finished.returncode:
        raise CheckFailedError(f"{name}: {finished.stderr.strip()}")
    with Image.open(path) as picture:
        whole = picture.convert("RGB")
    few = whole.quantize(_COLOURS, dither=Image.Dither.NONE) if name.startswith("lab") else whole
    few.save(path, optimize=True)


if __name__ == "__main__":
    main()
