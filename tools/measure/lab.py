"""What the lab's scenes cost: `python -m tools.measure.lab`. Processor time of a picture, of a tick, of a check."""

from game.system.start import prepare

PROGRAM = "python -m tools.measure.lab"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import sys
import time
from collections.abc import Callable
from typing import Annotated, Any, NamedTuple

import typer
from rich.console import Console
from rich.table import Table

from game.lab.kit.parameters import defaults
from game.lab.kit.scene import LabScene, Motion, picture_of, started, stepped
from game.lab.registry import scenes
from game.system.command_line import run

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


class Cost(NamedTuple):
    """Microseconds of processor time."""

    picture: float
    tick: float | None  # None for a scene that does not run
    check: float


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def bench(rounds: Annotated[int, typer.Option(min=1, max=100_000, help="Times each is done; the mean counts.")] = 20) -> None:
    """Time every scene of the lab at its defaults, without another engine and without a window."""
    table = Table(title="mean cost at the defaults")
    for heading in ("scene", "us a picture", "us a tick", "us a check"):
        table.add_column(heading, justify="left" if heading == "scene" else "right")
    for scene in scenes():
        cost = scene_cost(scene, rounds)
        tick = "" if cost.tick is None else f"{cost.tick:.0f}"
        table.add_row(scene.name, f"{cost.picture:.0f}", tick, f"{cost.check:.0f}")
    Console(width=100).print(table)


def scene_cost(scene: LabScene, rounds: int) -> Cost:
    """What a scene costs at its defaults, the first time left out."""
    given = defaults(scene.parameters)
    states = [started(scene, given)]
    if isinstance(scene.shows, Motion):
        for _ in range(min(rounds, scene.shows.ticks)):
            states.append(stepped(scene, given, states[-1]))
    tick = _mean(lambda state: stepped(scene, given, state), states) if len(states) > 1 else None
    picture = _mean(lambda state: picture_of(scene, given, state), (states * rounds)[:rounds])
    return Cost(picture, tick, _mean(lambda _: scene.check(given), [None] * rounds))


def _mean(work: Callable[[Any], object], inputs: list[Any]) -> float:
    """Microseconds of a piece of work, over its inputs."""
    work(inputs[0])
    start = time.process_time()
    for one in inputs:
        work(one)
    return (time.process_time() - start) / len(inputs) * 1e6


if __name__ == "__main__":
    main()
