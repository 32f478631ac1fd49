"""What a frame costs: `python -m tools.measure.frame`. Frame after frame of a game in play, and of panels over it.

The first columns are processor time, the last two the clock's; with --window they include handing the picture to the display.
With --pace frames are drawn 60 a second, by the pace of the game's loop, and the time between them is measured instead.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.frame"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import gc
import sys
import time
from collections.abc import Callable, Iterator
from itertools import pairwise
from statistics import median, quantiles
from typing import Annotated, NamedTuple

import pygame
import typer
from rich.console import Console
from rich.table import Table

from game.autopilot import Autopilot
from game.drawing.camera import layout
from game.drawing.canvas import Canvas
from game.drawing.painter import Painter
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import Effects, after
from game.input.keys import Action
from game.input.signals import Pressed
from game.input.view import FLAT, SOLID, Viewpoint
from game.levels import built_in
from game.loop.frame_pace import FramePace
from game.overlay import hud
from game.overlay.readings import readings
from game.rules import ActivePower, Drop, PowerUp, Ruleset, Ticked, new_game, tick
from game.scene import scene_at, still
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.help.panel import Help
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.system import window as display
from game.system.command_line import run
from game.system.errors import BadInputError
from physics import direction

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM_UP = 20
"""Frames drawn before those that are timed."""
_RATE, _LATE = 60.0, 1.5
"""Frames per second with --pace; and the multiple of their distance after which a frame counts as late."""
_GAMES = 7
"""How many of the cases, the first ones, are games in play."""
_SERVED_TICKS = 600
_TICKS_A_FRAME = 4
_POWERS = tuple([ActivePower(kind, 600, 1200) for kind in (PowerUp.WIDE, PowerUp.SLOW, PowerUp.STICKY, PowerUp.PIERCE)])
_DROPS = tuple([Drop(kind, 6.0 * direction(kind), direction(kind)) for kind in (PowerUp.LIFE, PowerUp.FAST, PowerUp.SHIELD)])

Draw = Callable[[pygame.Surface], None]
"""Draws one frame."""


class FrameCase(NamedTuple):
    """Something to draw.

    name: in words.
    size: of the frame, pixels.
    frames: from a level's number to its frames, one after the other; only what they draw is timed.
    """

    name: str
    size: tuple[int, int]
    frames: Callable[[int], Iterator[Draw]]


class FrameCost(NamedTuple):
    """Milliseconds of a frame.

    processor: of this program.
    clock: by the clock.
    """

    processor: float
    clock: float


class FrameTarget(NamedTuple):
    """Where frames are drawn: a surface, what shows it, and what takes it away."""

    surface: pygame.Surface
    flip: Callable[[], None]
    close: Callable[[], None]


Opened = Callable[[tuple[int, int]], FrameTarget]
"""Opens a target of a size."""


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


def cases() -> tuple[FrameCase, ...]:
    """All that is timed."""
    small, large = (1280, 800), (3840, 2160)
    return (
        FrameCase("top-down", small, lambda level: game_frames(level, FLAT)),
        FrameCase("3D", small, lambda level: game_frames(level, SOLID)),
        FrameCase("3D, orbiting", small, lambda level: game_frames(level, SOLID, 0.02)),
        FrameCase("top-down", large, lambda level: game_frames(level, FLAT)),
        FrameCase("3D", large, lambda level: game_frames(level, SOLID)),
        FrameCase("top-down, power-ups", large, lambda level: game_frames(level, FLAT, busy=True)),
        FrameCase("3D, power-ups", large, lambda level: game_frames(level, SOLID, busy=True)),
        FrameCase("pause", small, lambda level: panel_frames(level, _paused)),
        FrameCase("settings", small, lambda level: panel_frames(level, SettingsPanel)),
        FrameCase("help", small, lambda level: panel_frames(level, Help)),
        FrameCase("help, opening", small, lambda level: panel_frames(level, Help, opening=True)),
    )


@app.command()
def frames(
    level: Annotated[int | None, typer.Option(min=1, help="Level to draw; without it, the one with the most bricks.")] = None,
    count: Annotated[int, typer.Option(min=20, max=100_000, help="Frames of each case.")] = 400,
    window: Annotated[bool, typer.Option("--window", help="Draw into a window, and show every frame.")] = False,  # noqa: FBT002  # a flag
    pace: Annotated[bool, typer.Option("--pace", help="Let 60 frames a second come, and time how evenly.")] = False,  # noqa: FBT002  # a flag
) -> None:
    """Time whole frames, effects on: the scene, everything drawn, the figures, or a panel; with a window, showing it, too."""
    if level is not None and level > len(built_in()):
        raise BadInputError(f"--level {level}: there are {len(built_in())} levels")
    number, opened = busiest_level() if level is None else level, _window if window else _plain
    if pace:
        _print_pace(number, count, opened)
        return
    table = Table(box=None, pad_edge=False)
    table.add_column("frame")
    for heading in ("pixels", "median ms", "99 % ms", "longest ms", "by the clock", "99 %"):
        table.add_column(heading, justify="right")
    for case in cases():
        size, taken = timed(case, number, count, opened)
        processor, clock = [one.processor for one in taken], [one.clock for one in taken]
        figures = (median(processor), _late(processor), max(processor), median(clock), _late(clock))
        table.add_row(case.name, f"{size[0]}x{size[1]}", *[f"{figure:.2f}" for figure in figures])
    Console(width=100).print(table)


def timed(case: FrameCase, level: int, count: int, opened: Opened) -> tuple[tuple[int, int], list[FrameCost]]:
    """How large the frames were, pixels, and the cost of each. A window is no larger than its desktop."""
    target, following = opened(case.size), case.frames(level)
    taken: list[FrameCost] = []
    gc.freeze()  # as the game does
    for _ in range(count + _WARM_UP):
        draw = next(following)
        start, begin = time.process_time(), time.perf_counter()
        draw(target.surface)
        target.flip()
        taken.append(FrameCost((time.process_time() - start) * 1e3, (time.perf_counter() - begin) * 1e3))
    size = target.surface.get_size()
    target.close()
    return size, taken[_WARM_UP:]


def paced(case: FrameCase, level: int, count: int, opened: Opened) -> tuple[tuple[int, int], list[float]]:
    """Size of the frames, pixels, and milliseconds from the beginning of each to that of the next, at 60 frames a second."""
    target, following, steps = opened(case.size), case.frames(level), FramePace()
    begun: list[float] = []
    gc.freeze()  # as the game does
    for _ in range(count + _WARM_UP):
        begun.append(time.perf_counter())
        next(following)(target.surface)
        target.flip()
        steps.wait(_RATE)
    size = target.surface.get_size()
    target.close()
    return size, [(later - earlier) * 1e3 for earlier, later in pairwise(begun[_WARM_UP:])]


def _print_pace(level: int, count: int, opened: Opened) -> None:
    """Print how evenly the frames of games are spaced."""
    table = Table(box=None, pad_edge=False)
    table.add_column("frame")
    for heading in ("pixels", "1 % ms", "median ms", "99 % ms", "longest ms", "late"):
        table.add_column(heading, justify="right")
    for case in cases()[:_GAMES]:
        size, steps = paced(case, level, count, opened)
        figures = (quantiles(steps, n=100)[0], median(steps), _late(steps), max(steps))
        late = sum([step > _LATE * 1e3 / _RATE for step in steps])
        table.add_row(case.name, f"{size[0]}x{size[1]}", *[f"{figure:.2f}" for figure in figures], f"{late} of {len(steps)}")
    Console(width=100).print(table)


def busiest_level() -> int:
    """The number of the level with the most bricks, from 1."""
    bricks = [sum([count != 0 for ring in level.rings for count in ring.slots()]) for level in built_in()]
    return bricks.index(max(bricks)) + 1


def game_frames(level: int, view: Viewpoint, orbit: float = 0.0, *, busy: bool = False) -> Iterator[Draw]:
    """Frames of an autopilot's game. orbit: radians that the camera turns in a frame. busy: with power-ups."""
    pilot, effects, done = Autopilot(), Effects(), still(new_game(built_in()[level - 1 :], 1, Ruleset()))
    for _ in range(_SERVED_TICKS):
        done, effects = _later(done, effects, pilot)
    painter, type_ = Painter(), Type()

    def draw(surface: pygame.Surface) -> None:
        """One frame, as the window draws it."""
        seen = view.seen(layout(surface.get_size(), done.game.level.ground_radius))
        canvas = Canvas(surface, seen.camera, DARK, type_, seen.unit)
        scene = scene_at(done, 0.5, effects)
        painter.paint(canvas, scene._replace(powers=_POWERS, drops=_DROPS) if busy else scene)
        hud.draw(canvas, readings(done.game), seen)

    while True:
        for _ in range(_TICKS_A_FRAME):
            done, effects = _later(done, effects, pilot)
        view = view._replace(azimuth=view.azimuth + orbit)
        yield draw


def panel_frames(level: int, panel: Callable[[AppState, Screen], Screen], *, opening: bool = False) -> Iterator[Draw]:
    """Frames of a panel over a game. opening: each is the first of a panel that has just been opened."""
    state = AppState(built_in(), level - 1, 1, Title, autopilot=True)
    play: Screen = PlayScreen(state, built_in()[level - 1 :])
    shown = panel(state, play)
    while True:
        yield (panel(state, play) if opening else shown).draw


def _paused(_state: AppState, play: Screen) -> Screen:
    """The menu of a game that is interrupted."""
    menu = play.answer(Pressed(Action.PAUSE), (1, 1))
    if menu is None:
        raise AssertionError(play)
    return menu


def _plain(size: tuple[int, int]) -> FrameTarget:
    """A surface that nobody sees."""
    return FrameTarget(pygame.Surface(size, 0, 32), lambda: None, lambda: None)


def _window(size: tuple[int, int]) -> FrameTarget:
    """A window, as the game opens it, no larger than the desktop. Raises EnvironmentMissingError without a display."""
    window = display.open_window("Frames", size)
    return FrameTarget(window.get_surface(), window.flip, pygame.quit)


def _late(times: list[float]) -> float:
    """What 99 of 100 stay below."""
    return quantiles(times, n=100)[-1]


def _later(done: Ticked, effects: Effects, pilot: Autopilot) -> tuple[Ticked, Effects]:
    """The game and its effects a tick later."""
    done = tick(done.game, pilot.controls(done.game))
    return done, after(effects, done)


if __name__ == "__main__":
    main()
