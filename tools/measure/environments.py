"""How many steps a second do many environments take on one core? `python -m tools.measure.environments`."""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.environments"

if __name__ == "__main__":
    prepare(PROGRAM)  # before the slow imports

import statistics
import sys
import time
from typing import Annotated

import numpy as np
import typer
from rich.console import Console

from game.levels import chosen
from game.system.command_line import run
from game.system.errors import EnvironmentMissingError

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM_UP = 1000
"""Steps before the timed ones: games begin together, and are in different phases after these steps."""
_STEPS = 200
"""Steps in a round."""
_ACTIONS = 64


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def speed(
    games: Annotated[int, typer.Option(min=1, max=1_000_000, help="Environments that are played together.")] = 1024,
    level: Annotated[str, typer.Option(help="Number, name or TOML file.")] = "1",
    frame_skip: Annotated[int, typer.Option(min=1, max=1000, help="Ticks that an action is held.")] = 1,
    rounds: Annotated[int, typer.Option(min=1, max=10_000, help="Timed one by one.")] = 40,
) -> None:
    """Time steps of many environments: observations, rewards and infos included, discrete actions at random, processor time."""
    try:
        from tools.environments import PolarBreakoutVectorEnv  # noqa: PLC0415  # an extra
    except ImportError as error:
        raise EnvironmentMissingError(str(error)) from None
    chosen(level)  # refuses, in one line, what is none
    console = Console()
    with console.status("compiling, or loading what was compiled before"):
        env = PolarBreakoutVectorEnv(games, level=level, frame_skip=frame_skip, copy=False)
    actions = np.random.default_rng(1).integers(0, 3, (_ACTIONS, games))
    env.reset(seed=1)
    for number in range(_WARM_UP):
        env.step(actions[number % _ACTIONS])
    nanoseconds = []
    for _ in range(rounds):
        start = time.process_time()
        for number in range(_STEPS):
            env.step(actions[number % _ACTIONS])
        nanoseconds.append((time.process_time() - start) / (_STEPS * games) * 1e9)
    median, best = statistics.median(nanoseconds), min(nanoseconds)
    console.print(
        f"{games:,} environments of level {level}, ticks a step: {frame_skip}. A step of one: median {median:.1f} ns, "
        f"best {best:.1f} ns; {1e3 / median:.1f} and {1e3 / best:.1f} million steps a second on one core"
    )


if __name__ == "__main__":
    main()
