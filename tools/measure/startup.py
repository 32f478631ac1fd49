"""How long from starting Python to the first picture: `python -m tools.measure.startup`.

A real start, closed after its first frame.

Warm starts find the libraries in memory. Before a cold one the system is made to forget every file it has read, which takes
root, Linux, and a machine on which nobody else is disturbed by it.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.startup"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import Annotated, NamedTuple

import typer
from rich.console import Console
from rich.table import Table

from game.system.command_line import run
from game.system.errors import CheckFailedError, EnvironmentMissingError

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM, _COLD = 1.0, 2.0
"""Seconds until the first picture, at most."""
_PROGRAM = """
import sys, time
from game import __main__ as program
from game import commands
import game.loop.app as app
flip = app._flip
def first(window):
    flip(window)
    print(time.time(), flush=True)
    sys.exit(0)
app._flip = first
commands.settings_path = lambda: commands.Path({settings!r})
sys.argv = ["polar-breakout"]
program.main()
"""
_CACHES = Path("/proc/sys/vm/drop_caches")


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def startup(
    count: Annotated[int, typer.Option(min=1, max=1000, help="Warm starts.")] = 9,
    cold: Annotated[int, typer.Option(min=0, max=100, help="Cold starts; they need root.")] = 0,
) -> None:
    """Time whole starts to the first picture; exit 1 if the median is above 1.0 s warm or 2.0 s cold."""
    first_picture()
    table = Table(box=None, pad_edge=False)
    for heading in ("start", "median s", "longest s", "at most s", "processor s"):
        table.add_column(heading, justify="left" if heading == "start" else "right")
    late = []
    for name, times, most in (
        ("warm", [first_picture() for _ in range(count)], _WARM),
        ("cold", [_cold_picture() for _ in range(cold)], _COLD),
    ):
        if times:
            waited, worked = ([start[k] for start in times] for k in (0, 1))
            table.add_row(name, f"{median(waited):.2f}", f"{max(waited):.2f}", f"{most:.1f}", f"{median(worked):.2f}")
            late += [name] if median(waited) > most else []
    Console(width=100).print(table)
    if late:
        raise CheckFailedError(f"too late: {', '.join(late)}")


class Start(NamedTuple):
    """One start of the game."""

    waited: float  # seconds from starting Python to the first picture
    worked: float  # of the processor, until the end: what is left of it on a busy machine


def first_picture() -> Start:
    """One start, on SDL's dummy drivers unless others are asked for."""
    drivers = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "1"}
    with tempfile.TemporaryDirectory() as folder:
        program = _PROGRAM.format(settings=str(Path(folder) / "settings.json"))
        worked, start = _children(), time.time()
        done = subprocess.run(  # noqa: S603  # this very Python and the program above
            [sys.executable, "-c", program],
            env={**drivers, **os.environ},
            capture_output=True,
            text=True,
            check=False,
        )
    if done.returncode:
        raise CheckFailedError(f"the game did not start: {done.stderr.strip()}")
    return Start(float(done.stdout) - start, _children() - worked)


def _children() -> float:
    """Seconds of the processor that programs started here have used; always 0 on Windows."""
    times = os.times()
    return times.children_user + times.children_system


def _cold_picture() -> Start:
    """The same with no file in memory."""
    os.sync()
    try:
        _CACHES.write_text("3", encoding="ascii")
    except OSError as error:
        raise EnvironmentMissingError(
            f"{_CACHES}: {error.strerror}; a cold start needs root on Linux, leave --cold out"
        ) from None
    return first_picture()


if __name__ == "__main__":
    main()
