"""What a frame costs: `python -m tools.frames`. Processor time, frame after frame of a game in play, without a display."""

import gc
import sys
import time
from statistics import median, quantiles
from typing import Annotated, NamedTuple

import pygame
import typer
from rich.console import Console
from rich.table import Table

from game import hud
from game.autopilot import Autopilot
from game.camera import layout
from game.command_line import run
from game.effects import Effects, after
from game.levels import built_in
from game.palette import DARK
from game.render import Painter
from game.rules import Ticked, new_game, tick
from game.scene import scene_at, still
from game.text import Type
from game.view import FROM_ABOVE, TIPPED, View

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM_UP = 20
_SERVED = 600
_TICKS_A_FRAME = 4


class Case(NamedTuple):
    """One way to look at a game."""

    name: str
    size: tuple[int, int]
    view: View
    orbit: float = 0.0  # radians a frame


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.frames"))


@app.command()
def frames(
    level: Annotated[int, typer.Option(min=1, max=7, help="Level to draw; 7 has 150 bricks.")] = 7,
    count: Annotated[int, typer.Option(min=20, max=100_000, help="Frames of each case.")] = 400,
) -> None:
    """Time whole frames, effects on: the scene, everything drawn, the figures."""
    cases = (
        Case("top-down, 1280x800", (1280, 800), FROM_ABOVE),
        Case("3D, 1280x800", (1280, 800), TIPPED),
        Case("3D, 1280x800, orbiting", (1280, 800), TIPPED, 0.02),
        Case("top-down, 3840x2160", (3840, 2160), FROM_ABOVE),
        Case("3D, 3840x2160", (3840, 2160), TIPPED),
    )
    table = Table(box=None, pad_edge=False)
    for heading, justify in (("frame", "left"), ("median ms", "right"), ("99 % ms", "right"), ("longest ms", "right")):
        table.add_column(heading, justify="left" if justify == "left" else "right")
    for case in cases:
        taken = timed(case, level, count)
        table.add_row(case.name, f"{median(taken):.2f}", f"{quantiles(taken, n=100)[-1]:.2f}", f"{max(taken):.2f}")
    Console(width=100).print(table)


def timed(case: Case, level: int, count: int) -> list[float]:
    """Milliseconds of every frame."""
    game, pilot, effects = new_game(built_in()[level - 1 :], 1), Autopilot(), Effects()
    done = still(game)
    for _ in range(_SERVED):
        done, effects = _later(done, effects, pilot)
    surface, painter, type_, view = pygame.Surface(case.size, 0, 32), Painter(DARK), Type(), case.view
    taken: list[float] = []
    gc.freeze()  # as the game does
    for _ in range(count + _WARM_UP):
        for _ in range(_TICKS_A_FRAME):
            done, effects = _later(done, effects, pilot)
        view = view._replace(azimuth=view.azimuth + case.orbit)
        start = time.process_time()
        _draw(surface, done, effects, view, painter, type_)
        taken.append((time.process_time() - start) * 1e3)
    return taken[_WARM_UP:]


def _later(done: Ticked, effects: Effects, pilot: Autopilot) -> tuple[Ticked, Effects]:
    """The game and its effects a tick later."""
    done = tick(done.game, pilot.controls(done.game))
    return done, after(effects, done)


def _draw(surface: pygame.Surface, done: Ticked, effects: Effects, view: View, painter: Painter, type_: Type) -> None:
    """One frame, as the window draws it."""
    place = view.seen(layout(surface.get_size(), done.game.level.ground_radius))
    painter.paint(surface, scene_at(done, 0.5, effects), place.camera, type_, place.unit)
    hud.draw(surface, place, hud.readings(done.game), painter.theme, type_)


if __name__ == "__main__":
    main()
