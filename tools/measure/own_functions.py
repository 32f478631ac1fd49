"""What a game on own functions costs, by the clock: `python -m tools.measure.own_functions mine.py`."""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.own_functions"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import sys
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median, quantiles
from typing import Annotated

import typer

from game.headless import autopilot_game
from game.levels import chosen
from game.rules import Advance
from game.student.functions_file import FunctionsFile
from game.student.own_physics import OwnPhysics
from game.system.command_line import run
from game.system.output import print_line
from physics import Arena, FreeFlight, Step, source_mode

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_LEVEL, _SEED = "6", 7


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def measure(
    file: Annotated[Path, typer.Argument(help="A Python file with any of the source's functions.")],
    ticks: Annotated[int, typer.Option(min=100, max=10**6, help="Ticks of a game on level 6.")] = 10_000,
) -> None:
    """Time the ticks of a game on own functions, beside the slides' own in this process; then a call that does nothing."""
    with FunctionsFile(file) as own:
        trips = [_milliseconds(lambda: own.ask("calls", [])) for _ in range(1000)]
        for name, advance in (("own functions", OwnPhysics(own).advance), ("the slides'", source_mode.advance)):
            times = _tick_times(advance, ticks)
            print_line(f"{name + ':':<16}{_words(times)} a tick with a test")
        print_line(f"{'round trip:':<16}{_words(trips)}")
        own.check()


def _tick_times(advance: Advance, ticks: int) -> list[float]:
    """Milliseconds of every tick in which overlaps were tested, which is one in four."""
    times: list[float] = []

    def timed(arena: Arena, dt: float, speed: float, flight: FreeFlight | None) -> Step:
        """A tick, its time noted."""
        start = time.perf_counter()
        step = advance(arena, dt, speed, flight)
        if arena.balls and step.flight is not None and step.flight[1] == 0.0:
            times.append(1000.0 * (time.perf_counter() - start))
        return step

    autopilot_game(chosen(_LEVEL), _SEED, ticks, advance=timed)
    return times


def _milliseconds(work: Callable[[], object]) -> float:
    """Of a piece of work."""
    start = time.perf_counter()
    work()
    return 1000.0 * (time.perf_counter() - start)


def _words(times: list[float]) -> str:
    """Median and 99 %."""
    return f"median {median(times):.3f} ms, 99 % {quantiles(times, n=100)[98]:.3f} ms"


if __name__ == "__main__":
    main()
