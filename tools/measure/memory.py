"""Does a long evening of play cost more and more memory? `python -m tools.measure.memory`.

The window's own screens on SDL's dummy driver: the autopilot plays every level in turn, each frame is drawn and heard, from
above and in 3D by turns. What the process holds at the end is compared with what it held after the first minute.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.memory"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import gc
import os
import sys
from pathlib import Path
from typing import Annotated

import pygame
import typer
from rich.console import Console
from rich.progress import Progress

from game.input.view import Viewpoint
from game.levels import classic
from game.loop.app import frame
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.settings.values import Settings
from game.sound.mixer import Audio
from game.system import window as display
from game.system.command_line import run
from game.system.errors import CheckFailedError, EnvironmentMissingError

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_RATE = 60
_TURN = 4
"""Seconds from one view to the other."""
_TOUR = 8
"""Seconds of each level at first: after a minute all have been seen in both views, and what grows then is no first look."""
_STAY = 90
"""Seconds of each level from then on: all of them come several times, and some are cleared."""
_MOST_GROWTH = 0.05


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def soak(
    minutes: Annotated[float, typer.Option(min=1.1, max=1000.0, help="Simulated minutes of play.")] = 30.0,
    width: Annotated[int, typer.Option(min=16, max=8192, help="Pixels.")] = 640,
    height: Annotated[int, typer.Option(min=16, max=8192, help="Pixels.")] = 400,
) -> None:
    """Play for a long time and compare the memory held at the end with that after the first minute: at most 5 % more."""
    held()
    os.environ.update(SDL_VIDEODRIVER="dummy", SDL_AUDIODRIVER="dummy")
    window = display.open_window("soak", (width, height))
    shared = AppState(classic(), 0, 1, Title, autopilot=True, audio=Audio())
    shared.change(Settings())
    frames = round(minutes * 60 * _RATE)
    first, screen, console = 0.0, _level(shared, 0), Console(stderr=True)
    with Progress(console=console, disable=not console.is_terminal, transient=True) as progress:
        task = progress.add_task("playing", total=frames)
        for number in range(1, frames + 1):
            screen = _later(window, shared, screen, number)
            if number == 60 * _RATE:
                first = held()
            if number % (60 * _RATE) == 0:
                progress.console.print(f"{number // (60 * _RATE):3d} min: {held():7.1f} MB")
            progress.update(task, completed=number)
    last = held()
    pygame.quit()
    growth = last / first - 1.0
    Console().print(
        f"after 1 min {first:.1f} MB, after {minutes:g} min {last:.1f} MB: {growth:+.1%} (at most {_MOST_GROWTH:+.0%})"
    )
    if growth > _MOST_GROWTH:
        raise CheckFailedError(f"memory grew by {growth:.1%}")


def held() -> float:
    """Megabytes of memory that the process holds now; EnvironmentMissingError where the system does not tell."""
    gc.collect()
    try:
        lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
    except OSError:
        raise EnvironmentMissingError("this system does not say how much memory a process holds; run it on Linux") from None
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS:")) / 1024.0


def _later(window: pygame.Window, shared: AppState, screen: Screen, number: int) -> Screen:
    """The screen a frame later; another level when it is time for one, or the game has ended."""
    seconds = number // _RATE
    shared.view = Viewpoint(goal=float(seconds // _TURN % 2), tipped=shared.view.tipped)
    following = frame(window, shared, screen, 1.0 / _RATE)
    stay = _TOUR if seconds < _TOUR * len(shared.catalogue) else _STAY
    if number % (stay * _RATE) == 0 or not isinstance(following, PlayScreen):
        return _level(shared, seconds // stay)
    return following


def _level(shared: AppState, number: int) -> Screen:
    """A game from one of the levels on, by turns."""
    return PlayScreen(shared, shared.catalogue[number % len(shared.catalogue) :])


if __name__ == "__main__":
    main()
