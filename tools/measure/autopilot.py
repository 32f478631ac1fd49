"""What does the compiled autopilot cost, and are its games the game's own? `python -m tools.measure.autopilot`."""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.autopilot"

if __name__ == "__main__":
    prepare(PROGRAM)  # before the slow imports

import sys
import time
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import track

from game.headless import autopilot_game
from game.levels import Level, built_in, chosen
from game.rules import TICK, Phase, new_game
from game.rules.serving import served_ball, swung_aim
from game.system.command_line import run
from game.system.errors import CheckFailedError, EnvironmentMissingError
from physics import Arena

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_ROUND = 240
"""Ticks of all games in a round."""
_PLAIN_TICKS = 2000
"""Ticks of one game in plain Python in a round."""
_AIMS = 480
"""Serves that differ."""
_COUNT = 2
"""Games of a level that are compared side by side."""


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def cost(
    games: Annotated[int, typer.Option(min=1, max=1_000_000, help="Games of the batch.")] = 1024,
    level: Annotated[str, typer.Option(help="Number, name or TOML file.")] = "1",
    rounds: Annotated[int, typer.Option(min=1, max=10_000, help="Of the batch and of plain Python, by turns.")] = 10,
    compare: Annotated[int, typer.Option(min=0, max=1_000_000_000, help="Compare so many ticks instead, on all levels.")] = 0,
) -> None:
    """Time a batch that the autopilot plays, and a headless game in plain Python; or compare such games tick by tick."""
    console = Console()
    try:
        if compare:
            _compare(console, compare)
        else:
            _time(console, games, chosen(level)[0], rounds)
    except ImportError as error:
        raise EnvironmentMissingError(str(error)) from None


def _time(console: Console, games: int, level: Level, rounds: int) -> None:
    """Print nanoseconds of processor time for one tick of one game: the best round of each."""
    from physics.batch import Batch  # noqa: PLC0415  # an extra
    from tools.autopilot import BatchAutopilot  # noqa: PLC0415

    batch = Batch([_served(level, n) for n in range(games)], dt=TICK, speed=level.ball.speed, ground_radius=level.ground_radius)
    with console.status("compiling, or loading what was compiled before"):
        autopilot = BatchAutopilot(level, games)
        batch.step(ticks=_ROUND, autopilot=autopilot)
    compiled, plain = [], []
    for seed in range(rounds):
        start = time.process_time()
        batch.step(ticks=_ROUND, autopilot=autopilot)
        compiled.append((time.process_time() - start) / (_ROUND * games) * 1e9)
        start = time.process_time()
        played = autopilot_game((level,), seed, _PLAIN_TICKS).tick
        plain.append((time.process_time() - start) / played * 1e9)
    console.print(
        f"{level.name}, {games:,} games, one thread: {min(compiled):.0f} ns for a game and tick; plain Python's headless game "
        f"{min(plain):,.0f} ns, {min(plain) / min(compiled):.0f} times as much"
    )


def _served(level: Level, number: int) -> Arena:
    """A level's arena with its ball just served, in another direction for every number."""
    arena = new_game((level,), 0).arena
    ball = served_ball(arena.rings[0], level.ball.radius, level.ball.speed, swung_aim(number % _AIMS))
    return arena._replace(balls=(ball,))


def _compare(console: Console, ticks: int) -> None:
    """Compare games of all levels; print what they went through. CheckFailedError where one differs."""
    from tools.autopilot.comparison import compared_ticks, played_environments  # noqa: PLC0415  # needs an extra

    levels = built_in()
    steps = -(-ticks // (len(levels) * _COUNT))
    seen = dict.fromkeys(("ticks", "serves", "hits", "lost", "nudges", "won", "over"), 0)
    for seed, level in enumerate(track(levels, "comparing", console=console, transient=True)):
        many = played_environments(level.name, seed, _COUNT)
        try:
            for before, controls, done in compared_ticks(many, [many.game(index) for index in range(_COUNT)], steps):
                after = done.game
                seen["ticks"] += 1
                seen["serves"] += controls.serve and after.phase == Phase.PLAYING
                seen["hits"] += len(done.step.hits)
                seen["lost"] += after.lives < before.lives
                seen["nudges"] += after.draws > before.draws
                seen["won"] += after.phase == Phase.WON
                seen["over"] += after.phase == Phase.OVER
        except AssertionError as error:
            raise CheckFailedError(str(error)) from None
    console.print(f"All bits equal on {len(levels)} levels: {', '.join([f'{name} {count:,}' for name, count in seen.items()])}")


if __name__ == "__main__":
    main()
