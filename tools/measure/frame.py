"""What a frame costs: `python -m tools.measure.frame`. Frame after frame of a game in play.

The first columns are processor time, the last two the clock's; with --window they include handing the picture to the display.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.frame"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import gc
import sys
import time
from collections.abc import Callable
from statistics import median, quantiles
from typing import Annotated, NamedTuple

import pygame
import typer
from rich.console import Console
from rich.table import Table

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.painter import Painter
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import Effects, after
from game.input.view import FROM_ABOVE, TIPPED, Viewpoint
from game.levels import built_in
from game.overlay import hud
from game.rules import Ticked, new_game, tick
from game.scene import scene_at, still
from game.system import window as display
from game.system.command_line import run

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM_UP = 20
_SERVED = 600
_TICKS_A_FRAME = 4


class Case(NamedTuple):
    """One way to look at a game."""

    name: str
    size: tuple[int, int]
    view: Viewpoint
    orbit: float = 0.0  # radians a frame


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def frames(
    level: Annotated[int, typer.Option(min=1, max=7, help="Level to draw; 7 has 150 bricks.")] = 7,
    count: Annotated[int, typer.Option(min=20, max=100_000, help="Frames of each case.")] = 400,
    window: Annotated[bool, typer.Option("--window", help="Draw into a window, and show every frame.")] = False,  # noqa: FBT002  # a flag
) -> None:
    """Time whole frames, effects on: the scene, everything drawn, the figures; with a window, showing it, too."""
    cases = (
        Case("top-down", (1280, 800), FROM_ABOVE),
        Case("3D", (1280, 800), TIPPED),
        Case("3D, orbiting", (1280, 800), TIPPED, 0.02),
        Case("top-down", (3840, 2160), FROM_ABOVE),
        Case("3D", (3840, 2160), TIPPED),
    )
    table = Table(box=None, pad_edge=False)
    table.add_column("frame")
    for heading in ("pixels", "median ms", "99 % ms", "longest ms", "by the clock", "99 %"):
        table.add_column(heading, justify="right")
    for case in cases:
        size, taken = timed(case, level, count, _window if window else _plain)
        processor, clock = [one.processor for one in taken], [one.clock for one in taken]
        figures = (median(processor), _late(processor), max(processor), median(clock), _late(clock))
        table.add_row(case.name, f"{size[0]}x{size[1]}", *[f"{figure:.2f}" for figure in figures])
    Console(width=100).print(table)


class Taken(NamedTuple):
    """Milliseconds of a frame."""

    processor: float  # of this program
    clock: float


class Shown(NamedTuple):
    """Where frames are drawn."""

    surface: pygame.Surface
    flip: Callable[[], None]
    close: Callable[[], None]


def timed(
    case: Case, level: int, count: int, opened: Callable[[tuple[int, int]], Shown]
) -> tuple[tuple[int, int], list[Taken]]:
    """How large the frames were, pixels, and the cost of each. A window is no larger than its desktop."""
    game, pilot, effects = new_game(built_in()[level - 1 :], 1), Autopilot(), Effects()
    done = still(game)
    for _ in range(_SERVED):
        done, effects = _later(done, effects, pilot)
    shown, painter, type_, view = opened(case.size), Painter(DARK), Type(), case.view
    taken: list[Taken] = []
    gc.freeze()  # as the game does
    for _ in range(count + _WARM_UP):
        for _ in range(_TICKS_A_FRAME):
            done, effects = _later(done, effects, pilot)
        view = view._replace(azimuth=view.azimuth + case.orbit)
        start, begin = time.process_time(), time.perf_counter()
        _draw(shown.surface, done, effects, view, painter, type_)
        shown.flip()
        taken.append(Taken((time.process_time() - start) * 1e3, (time.perf_counter() - begin) * 1e3))
    size = shown.surface.get_size()
    shown.close()
    return size, taken[_WARM_UP:]


def _plain(size: tuple[int, int]) -> Shown:
    """A surface that nobody sees."""
    return Shown(pygame.Surface(size, 0, 32), lambda: None, lambda: None)


def _window(size: tuple[int, int]) -> Shown:
    """A window, as the game opens it, no larger than the desktop. Raises EnvironmentMissingError without a display."""
    window = display.open_window("Frames", size)
    return Shown(window.get_surface(), window.flip, pygame.quit)


def _late(times: list[float]) -> float:
    """What 99 of 100 stay below."""
    return quantiles(times, n=100)[-1]


def _later(done: Ticked, effects: Effects, pilot: Autopilot) -> tuple[Ticked, Effects]:
    """The game and its effects a tick later."""
    done = tick(done.game, pilot.controls(done.game))
    return done, after(effects, done)


def _draw(surface: pygame.Surface, done: Ticked, effects: Effects, view: Viewpoint, painter: Painter, type_: Type) -> None:
    """One frame, as the window draws it."""
    place = view.seen(layout(surface.get_size(), done.game.level.ground_radius))
    painter.paint(surface, scene_at(done, 0.5, effects), place.camera, type_, place.unit)
    hud.draw(surface, place, hud.readings(done.game), painter.theme, type_)


if __name__ == "__main__":
    main()
