"""Draw the documentation's figures: `python -m tools.figures`; with --lab, the lab's pictures, too."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer
from PIL import Image

from game.system.command_line import run
from game.system.errors import CheckFailedError
from tools.figures.flow import flow, imports
from tools.figures.response import response_symbols
from tools.figures.sheet import Sheet
from tools.figures.sweep import sweep_symbols
from tools.figures.symbols import end_symbols, polar_symbols

FIGURES: dict[str, Callable[[], Sheet]] = {
    "symbols": polar_symbols,
    "end": end_symbols,
    "sweep": sweep_symbols,
    "response": response_symbols,
    "flow": flow,
    "imports": imports,
}
"""Every figure by the name of its file."""

LAB_SCENES = {
    "polar": "polar",
    "on-left": "on-left",
    "broad-phase": "broad-phase",
    "nearest-sector": "nearest-sector",
    "closest-point": "closest-point",
    "case-1": "case-1",
    "case-2": "case-2",
    "impact-resting": "impact-resting",
    "impact-turning": "impact-turning",
    "response-paddle": "response-paddle",
    "inside-material": "inside-material",
    "two-bricks": "two-bricks",
    "discrete-swept": "discrete-swept",
}
"""Every picture of the lab by the name of its file, and the scene as `python -m game lab` takes it."""

_CHECKOUT = Path(__file__).parents[2]
FOLDER = _CHECKOUT / "docs" / "figures"
_LAB_SIZE = "960x640"
_LAB_COLOURS = 96
"""Colours of a picture of the lab: few, so that its file is small; its areas are plain."""

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.figures"))


@app.command()
def draw(
    folder: Annotated[Path, typer.Option(help="Where to write the files.")] = FOLDER,
    lab: Annotated[bool, typer.Option("--lab", help="Draw the lab's pictures, too.")] = False,
) -> None:
    """Draw every figure of the documentation."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, sheet in FIGURES.items():
        sheet().save(folder / f"{name}.svg")
        print(folder / f"{name}.svg")
    for name, scene in LAB_SCENES.items() if lab else ():
        draw_lab_scene(scene, folder / f"lab-{name}.png")
        print(folder / f"lab-{name}.png")


def draw_lab_scene(scene: str, path: Path) -> None:
    """Draw one scene of the lab in light colours into a PNG file, by the lab's own command."""
    command = [
        sys.executable,
        "-m",
        "game",
        "lab",
        scene,
        "--screenshot",
        str(path.resolve()),
        "--size",
        _LAB_SIZE,
        "--theme",
        "light",
    ]
    finished = subprocess.run(command, capture_output=True, text=True, check=False, cwd=_CHECKOUT)  # noqa: S603
    if finished.returncode:
        raise CheckFailedError(f"the lab draws no {scene}: {finished.stderr.strip()}")
    with Image.open(path) as picture:
        picture.convert("RGB").quantize(_LAB_COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)


if __name__ == "__main__":
    main()
