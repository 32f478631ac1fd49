"""What a tick costs, beside pymunk's: `python -m tools.bench`. Processor time, in one process, in alternating rounds.

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
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from random import Random
from statistics import median
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer
from rich.console import Console
from rich.table import Table

from game.system.command_line import run
from game.system.errors import EnvironmentMissingError
from physics import PERMANENT, Arena, Ball, FreeFlight, Ring, advance
from tools.measure.standard_arena import BALL_RADIUS, CHECK_EVERY, GROUND, SPEED, TICK, arena, served

if TYPE_CHECKING:
    from tools.measure.many_games import ManyGames

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

FACETS = 16

_WARM_UP = 1000


BALLS_IN_A_SPACE = 100


class Play(NamedTuple):
    """One way to simulate: its name, a function that does so many ticks, and how many balls a tick of it moves.

    The function may return the seconds of processor time that it spent on what is no simulation.
    """

    name: str
    run: Callable[[int], float | None]
    balls: int = 1


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
    json_file: Annotated[Path | None, typer.Option("--json", metavar="FILE", help="Write the figures here too.")] = None,
) -> int:
    """Time the standard arena: 3 turning paddles, 48 bricks, 1 ball; a lost ball comes back, and so do the bricks."""
    if bounces is not None:
        return _drift(bounces)
    console = Console(width=110, highlight=False)
    plays = [
        Play("physics.advance, 48 bricks", ours(16)),
        Play("physics.advance, 12 bricks", ours(4)),
        Play("physics.advance, 1,200 bricks", ours(400)),
        Play(f"pymunk, arcs of {FACETS} facets", theirs(_facets)),
        Play("pymunk, 4 convex polygons a paddle", theirs(_polygons)),
        Play(f"pymunk, {BALLS_IN_A_SPACE} balls in one space", theirs(_polygons, BALLS_IN_A_SPACE), BALLS_IN_A_SPACE),
        Play(
            f"pymunk, {BALLS_IN_A_SPACE} balls, paddles at rest, {FACETS} facets",
            theirs(_facets, BALLS_IN_A_SPACE, turning=False),
            BALLS_IN_A_SPACE,
        ),
    ]
    many = _batches(console, batch)
    plays += [Play(games.name, games.run, games.games) for games in many]
    times = _timed(plays, rounds, ticks)
    console.print(_table(plays, times))
    for games in many:
        console.print(games.state())
    if json_file is not None:
        json_file.write_text(_as_json(plays, times, rounds, ticks), encoding="utf-8")
    return 0


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
    many = [ManyGames(console, arena(per_row), games) for per_row, games in ((16, 4096), (4, 4096), (4000, 1024))]
    console.print(many[0].compiled)
    return many


def _timed(plays: list[Play], rounds: int, ticks: int) -> list[list[float]]:
    """Nanoseconds a ball-step of every contender, round by round."""
    times: list[list[float]] = [[] for _ in plays]
    for play in plays:
        play.run(_WARM_UP)
    for _ in range(rounds):
        for play, taken in zip(plays, times, strict=True):
            start = time.process_time()
            aside = play.run(ticks) or 0.0
            taken.append((time.process_time() - start - aside) / (ticks * play.balls) * 1e9)
    return times


def _table(plays: list[Play], times: list[list[float]]) -> Table:
    """Each contender's time, and ours as a part of it, the median over the rounds."""
    table = Table(title="mean cost of a ball in a tick, median of rounds")
    for heading in ("contender", "ns a ball-step", "advance (48 bricks) : this"):
        table.add_column(heading, justify="left" if heading == "contender" else "right")
    for play, taken in zip(plays, times, strict=True):
        ratio = median([ours / other for ours, other in zip(times[0], taken, strict=True)])
        shown = f"{ratio:.1f}" if ratio >= 10.0 else f"{ratio:.3f}" if ratio >= 0.1 else f"1 : {1.0 / ratio:.1f}"
        table.add_row(play.name, f"{median(taken):,.1f}", shown)
    return table


def _as_json(plays: list[Play], times: list[list[float]], rounds: int, ticks: int) -> str:
    """The figures, with what they were measured on."""
    rows = [
        {"name": play.name, "balls": play.balls, "median_ns": median(taken), "ns": taken}
        for play, taken in zip(plays, times, strict=True)
    ]
    about = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    return json.dumps(about | {"rounds": rounds, "ticks": ticks, "rows": rows}, indent=1) + "\n"


def ours(per_row: int) -> Callable[[int], None]:
    """Ticks of `physics.advance`."""
    state, full, chance = arena(per_row), arena(per_row).layers, Random(1)
    last: FreeFlight | None = None

    def play(ticks: int) -> None:
        nonlocal state, last
        now, flight = state, last
        for first in range(0, ticks, CHECK_EVERY):
            for _ in range(min(CHECK_EVERY, ticks - first)):
                step = advance(now, TICK, SPEED, flight)
                now, flight = step.arena, step.flight
            p = now.balls[0].position
            if p.real * p.real + p.imag * p.imag > GROUND * GROUND:
                now = Arena((served(chance),), now.rings, full)
        state, last = now, flight

    return play


def theirs(model: Callable[[Any, Any, Ring], list[Any]], balls: int = 1, *, turning: bool = True) -> Callable[[int], float]:
    """Ticks of pymunk's `Space.step`, its speed set anew and its lost balls served again once in a while, as needed to go on.

    balls: in one space; they pass through each other. turning: whether the paddles turn. The seconds spent on setting speeds
    and serving balls are returned.
    """
    pymunk = _pymunk()
    space = pymunk.Space()
    space.iterations = 1 if balls > 1 else space.iterations  # a ball touches one thing at a time: more is lost on it
    for ring in arena(16).rings:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC if ring.spin and turning else pymunk.Body.STATIC)
        body.angular_velocity = ring.spin if turning else 0.0
        space.add(body, *model(pymunk, body, ring))
    chance = Random(1)
    bodies = [pymunk.Body(1.0, math.inf) for _ in range(balls)]
    for body in bodies:
        circle = pymunk.Circle(body, BALL_RADIUS)
        circle.filter = pymunk.ShapeFilter(group=1)
        space.add(body, circle)
        _put(body, served(chance))
    for shape in space.shapes:
        shape.elasticity, shape.friction = 1.0, 0.0

    def play(ticks: int) -> float:
        aside = 0.0
        for first in range(0, ticks, CHECK_EVERY):
            for _ in range(min(CHECK_EVERY, ticks - first)):
                space.step(TICK)
            start = time.process_time()
            for ball in bodies:
                if ball.position.length > GROUND or not ball.velocity.length > 0.0:
                    _put(ball, served(chance))
                ball.velocity = ball.velocity.scale_to_length(SPEED)
            aside += time.process_time() - start
        return aside

    return play


def _put(body: Any, ball: Ball) -> None:
    """Place a pymunk body where a ball is."""
    body.position = ball.position.real, ball.position.imag
    body.velocity = ball.velocity.real, ball.velocity.imag


def _pymunk() -> Any:
    """The pymunk library."""
    try:
        import pymunk  # noqa: PLC0415  # may be missing
    except ImportError:
        raise EnvironmentMissingError("the comparison needs pymunk: pip install pymunk") from None
    return pymunk


def _facets(pymunk: Any, body: Any, ring: Ring) -> list[Any]:
    """Every sector's outline in segments: two arcs of facets, two ends."""
    shapes = []
    for slot in range(ring.count):
        outer, inner = _arc(ring, slot, ring.outer_radius, FACETS), _arc(ring, slot, ring.inner_radius, FACETS)
        outline = [*outer, *inner[::-1], outer[0]]
        shapes += [pymunk.Segment(body, a, b, 0.0) for a, b in pairwise(outline)]
    return shapes


def _polygons(pymunk: Any, body: Any, ring: Ring) -> list[Any]:
    """Every sector as few convex polygons: 4 for a paddle, 1 for a brick."""
    pieces = 4 if ring.spin else 1
    shapes = []
    for slot in range(ring.count):
        outer, inner = _arc(ring, slot, ring.outer_radius, pieces), _arc(ring, slot, ring.inner_radius, pieces)
        shapes += [pymunk.Poly(body, [outer[k], outer[k + 1], inner[k + 1], inner[k]]) for k in range(pieces)]
    return shapes


def _arc(ring: Ring, slot: int, radius: float, pieces: int) -> list[tuple[float, float]]:
    """The corners of an arc cut into pieces."""
    first = ring.phase + slot * math.tau / ring.count - ring.half_angle
    angles = [first + 2.0 * ring.half_angle * k / pieces for k in range(pieces + 1)]
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


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
