"""What a tick costs, beside other engines': `python -m tools.bench`. Contenders play in alternating rounds, in one process.

A cost is that of one ball in one tick, a ball-step: contenders that move many balls at once are divided by their number.
"""

from game.system.start import prepare

PROGRAM = "python -m tools.bench"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import json
import math
import platform
import sys
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.table import Table

from game.system.command_line import run
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.files import check_target, read_input, write_atomically, write_text
from game.system.wording import quoted_path
from physics import PERMANENT, Arena, Ball, FreeFlight, Ring, advance
from tools.measure.contenders import BALLS_IN_A_SPACE, FACETS, Play, box2d_play, facets, floor, plain, polygons, pymunk_play
from tools.measure.standard_arena import BALL_RADIUS, TICK, arena, closed_arena
from tools.measure.whole_games import speeds

if TYPE_CHECKING:
    from tools.measure.many_games import ManyGames

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_WARM_UP = 1000
_QUICK_ROUNDS, _QUICK_TICKS = 3, 400
_FLOOR_GAMES = 4096
_BATCHES = (16, 4096), (4, 4096), (4, 1024), (4000, 1024), (16, 65_536)
"""Bricks a row, games: few and many bricks with as many games; the last are shared by threads, too."""
_CLOSED_BATCHES = (4, 1024), (4000, 1024)
"""Of these all balls fly the same."""
_MOST_BYTES = 2**20


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, PROGRAM))


@app.command()
def bench(
    rounds: Annotated[int, typer.Option(min=1, max=1000, help="Rounds; the median counts.")] = 15,
    ticks: Annotated[int, typer.Option(min=100, max=10**7, help="Ticks of each contender in a round.")] = 4000,
    bounces: Annotated[
        int | None, typer.Option(min=1, max=10**9, help="Measure the drift of the speed over so many bounces instead.")
    ] = None,
    batch: Annotated[
        bool | None, typer.Option("--batch/--no-batch", help="With the compiled batch; by default where numba is installed.")
    ] = None,
    *,
    quick: Annotated[bool, typer.Option("--quick", help="Few rounds: under a minute once the batch is compiled.")] = False,
    json_file: Annotated[Path | None, typer.Option("--json", metavar="FILE", help="Write the figures here too.")] = None,
    compare: Annotated[Path | None, typer.Option(metavar="FILE", help="Show beside the figures those of such a file.")] = None,
    plot: Annotated[Path | None, typer.Option(help="Measure against the number of bricks and balls instead: a .png.")] = None,
) -> int:
    """Time the standard arena: 3 turning paddles, 48 bricks, 1 ball; a lost ball comes back, and so do the bricks."""
    check_target(json_file, "--json")
    check_target(plot, "--plot", ".png")
    earlier = {} if compare is None else _earlier(compare)
    if bounces is not None:
        return _drift(bounces)
    if quick:
        rounds, ticks = _QUICK_ROUNDS, _QUICK_TICKS
    if plot is not None:
        from tools.measure.scaling import scaling_plot  # noqa: PLC0415  # matplotlib takes a second to load

        write_atomically(plot, scaling_plot(rounds, ticks))
        return 0
    console = Console(width=130, highlight=False)
    plays = _plain_plays()
    many = _batches(console, batch)
    for games in many:
        plays += games.plays()
    times = _timed(plays, rounds, ticks)
    console.print(_table(plays, times, earlier))
    for games in many:
        console.print(games.state())
    for line in speeds(quick=quick):
        console.print(line)
    if json_file is not None:
        write_text(json_file, _as_json(plays, times, rounds, ticks))
    return 0


def _plain_plays() -> list[Play]:
    """The contenders that need no numba."""
    plays = [
        Play("physics.advance, 48 bricks", plain(16)),
        Play("physics.advance, 12 bricks", plain(4)),
        Play("physics.advance, 1,200 bricks", plain(400)),
        Play(f"pymunk, arcs of {FACETS} facets", pymunk_play(facets)),
        Play("pymunk, 4 convex polygons a paddle", pymunk_play(polygons)),
        Play(f"pymunk, {BALLS_IN_A_SPACE} balls in one space", pymunk_play(polygons, BALLS_IN_A_SPACE), BALLS_IN_A_SPACE),
        Play(
            f"pymunk, {BALLS_IN_A_SPACE} balls, paddles at rest, {FACETS} facets",
            pymunk_play(facets, BALLS_IN_A_SPACE, turning=False),
            BALLS_IN_A_SPACE,
        ),
    ]
    box2d = box2d_play()
    if box2d is not None:
        plays.append(Play(f"Box2D, {BALLS_IN_A_SPACE} balls, paddles at rest, polygons", box2d, BALLS_IN_A_SPACE))
    return [*plays, Play(f"floor: {_FLOOR_GAMES:,} positions moved, nothing else", floor(_FLOOR_GAMES), _FLOOR_GAMES)]


def _batches(console: Console, wanted: bool | None) -> "list[ManyGames]":  # noqa: FBT001  # an option of the command
    """The contenders that need numba; none where it is missing and nobody insists on them."""
    from tools.measure.many_games import ManyGames, missing  # noqa: PLC0415  # it imports this module

    if wanted is False:
        return []
    lacking = missing()
    if lacking is not None and wanted:
        raise EnvironmentMissingError(lacking)
    if lacking is not None:
        console.print(f"without the batch: {lacking}")
        return []
    many = [ManyGames(console, arena(per_row), games) for per_row, games in _BATCHES]
    many += [ManyGames(console, closed_arena(per_row), games, " in closed rows") for per_row, games in _CLOSED_BATCHES]
    console.print(many[0].compiled)
    return many


def _timed(plays: list[Play], rounds: int, ticks: int) -> list[list[float]]:
    """Nanoseconds a ball-step of every contender, round by round."""
    times: list[list[float]] = [[] for _ in plays]
    for play in plays:
        play.run(min(_WARM_UP, ticks))
    for _ in range(rounds):
        for play, taken in zip(plays, times, strict=True):
            start = play.clock()
            aside = play.run(ticks) or 0.0
            taken.append((play.clock() - start - aside) / (ticks * play.balls) * 1e9)
    return times


def _table(plays: list[Play], times: list[list[float]], earlier: dict[str, tuple[float, float]]) -> Table:
    """Each contender's time, and ours as a part of it, the median over the rounds. earlier: from `_earlier`."""
    table = Table(title="mean cost of a ball in a tick, median of rounds")
    headings = ["contender", "ns a ball-step", "advance (48 bricks) : this"] + (["then: ns", "then: ratio"] if earlier else [])
    for heading in headings:
        table.add_column(heading, justify="left" if heading == "contender" else "right")
    for play, taken in zip(plays, times, strict=True):
        ratio = median([ours / other for ours, other in zip(times[0], taken, strict=True)])
        cells = [play.name, f"{median(taken):,.1f}", _shown(ratio)]
        if earlier:
            then = earlier.get(play.name)
            cells += ["-", "-"] if then is None else [f"{then[0]:,.1f}", _shown(then[1])]
        table.add_row(*cells)
    return table


def _shown(ratio: float) -> str:
    """A ratio of costs in words of a table."""
    return f"{ratio:.1f}" if ratio >= 10.0 else f"{ratio:.3f}" if ratio >= 0.1 else f"1 : {1.0 / ratio:.1f}"


def _as_json(plays: list[Play], times: list[list[float]], rounds: int, ticks: int) -> str:
    """The figures, with what they were measured on."""
    rows = [
        {"name": play.name, "balls": play.balls, "median_ns": median(taken), "ns": taken}
        for play, taken in zip(plays, times, strict=True)
    ]
    about = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    return json.dumps(about | {"rounds": rounds, "ticks": ticks, "rows": rows}, indent=1) + "\n"


def _earlier(path: Path) -> dict[str, tuple[float, float]]:
    """By the contender's name, its median in a file of `--json`, and the first contender's divided by it."""
    try:
        rows: list[dict[str, Any]] = json.loads(read_input(path, "figures", _MOST_BYTES))["rows"]
        return {row["name"]: (row["median_ns"], rows[0]["median_ns"] / row["median_ns"]) for row in rows}
    except (ValueError, KeyError, TypeError, IndexError, ZeroDivisionError):
        raise BadInputError(f"--compare {quoted_path(path)}: expected a file that --json has written") from None


def _drift(bounces: int) -> int:
    """The drift of the speed over many bounces between a wall and three pillars at rest; 1 if it exceeds 1e-12."""
    speed = 50.0 * BALL_RADIUS / TICK
    wall, pillars = Ring(13.0, 0.5, math.pi, 1), Ring(3.0, 0.5, 0.2, 7, 0.1)
    state = Arena((Ball(0.3j, complex(speed, 0.0), BALL_RADIUS),), (wall, pillars), ((PERMANENT,), (PERMANENT,) * 7))
    flight: FreeFlight | None = None
    done, worst = 0, 0.0
    while done < bounces:
        step = advance(state, TICK * 10.0, speed, flight)
        state, flight, done = step.arena, step.flight, done + len(step.hits)
        v = state.balls[0].velocity
        worst = max(worst, abs(math.hypot(v.real, v.imag) / speed - 1.0))
    Console().print(f"{done} bounces: the speed was off by {worst:.1e} of itself at most", highlight=False)
    return 0 if worst < 1e-12 else 1


if __name__ == "__main__":
    main()
