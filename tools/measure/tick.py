"""What a tick costs, beside pymunk's: `python -m tools.bench`. Processor time, in one process, in alternating rounds."""

from game.system.start import prepare

PROGRAM = "python -m tools.bench"

if __name__ == "__main__":
    prepare(PROGRAM)  # before what takes time to load

import cmath
import math
import sys
import time
from collections.abc import Callable
from itertools import pairwise
from random import Random
from statistics import median
from typing import Annotated, Any, NamedTuple

import typer
from rich.console import Console
from rich.table import Table

from game.system.command_line import run
from game.system.errors import EnvironmentMissingError
from physics import PERMANENT, Arena, Ball, FreeFlight, Ring, advance

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

TICK = 1.0 / 240.0
SPEED = 8.0
BALL_RADIUS = 0.25
GROUND = 12.0
BRICK_ROWS = (2.6, 3.8, 5.0)
FACETS = 16

_PADDLES = Ring(10.0, 0.3, 0.35, 3, 0.0, 0.72)  # as fast as a level lets them turn: 0.93 of the ball at the rim
_WARM_UP = 1000
_CHECK_EVERY = 20
"""Ticks between two looks at where the ball is, the same for every contender."""


class Play(NamedTuple):
    """One way to simulate a batch of ticks: its name, and a function that does so many."""

    name: str
    run: Callable[[int], None]


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
) -> int:
    """Time the standard arena: 3 turning paddles, 48 bricks, 1 ball; a lost ball comes back, and so do the bricks."""
    if bounces is not None:
        return _drift(bounces)
    plays = [
        Play("physics.advance, 48 bricks", ours(16)),
        Play("physics.advance, 12 bricks", ours(4)),
        Play("physics.advance, 1,200 bricks", ours(400)),
        Play(f"pymunk, arcs of {FACETS} facets", theirs(_facets)),
        Play("pymunk, 4 convex polygons a paddle", theirs(_polygons)),
    ]
    Console(width=100).print(_table(plays, _timed(plays, rounds, ticks)))
    return 0


def _timed(plays: list[Play], rounds: int, ticks: int) -> list[list[float]]:
    """Microseconds a tick of every contender, round by round."""
    times: list[list[float]] = [[] for _ in plays]
    for play in plays:
        play.run(_WARM_UP)
    for _ in range(rounds):
        for play, taken in zip(plays, times, strict=True):
            start = time.process_time()
            play.run(ticks)
            taken.append((time.process_time() - start) / ticks * 1e6)
    return times


def _table(plays: list[Play], times: list[list[float]]) -> Table:
    """Each contender's time, and ours as a part of it, the median over the rounds."""
    table = Table(title="mean cost of a tick, median of rounds")
    for heading in ("contender", "us a tick", "ours (48 bricks) : this"):
        table.add_column(heading, justify="left" if heading == "contender" else "right")
    for play, taken in zip(plays, times, strict=True):
        ratio = median([ours / other for ours, other in zip(times[0], taken, strict=True)])
        table.add_row(play.name, f"{median(taken):.2f}", f"{ratio:.3f}" if ratio >= 0.1 else f"1 : {1.0 / ratio:.1f}")
    return table


def arena(per_row: int) -> Arena:
    """The standard arena, with so many bricks in each of the three rows."""
    rows = [Ring(radius, 0.4, 0.9 * math.pi / per_row, per_row) for radius in BRICK_ROWS]
    layers = (PERMANENT,) * 3, *[(1,) * per_row for _ in rows]
    return Arena((_served(Random(1)),), (_PADDLES, *rows), layers)


def ours(per_row: int) -> Callable[[int], None]:
    """Ticks of `physics.advance`."""
    state, full, chance = arena(per_row), arena(per_row).layers, Random(1)
    last: FreeFlight | None = None

    def play(ticks: int) -> None:
        nonlocal state, last
        now, flight = state, last
        for first in range(0, ticks, _CHECK_EVERY):
            for _ in range(min(_CHECK_EVERY, ticks - first)):
                step = advance(now, TICK, SPEED, flight)
                now, flight = step.arena, step.flight
            p = now.balls[0].position
            if p.real * p.real + p.imag * p.imag > GROUND * GROUND:
                now = Arena((_served(chance),), now.rings, full)
        state, last = now, flight

    return play


def _served(chance: Random) -> Ball:
    """A ball between bricks and paddles, somewhere, going somewhere."""
    position, velocity = cmath.rect(7.0, chance.random() * math.tau), cmath.rect(SPEED, chance.random() * math.tau)
    return Ball(position, velocity, BALL_RADIUS)


def theirs(model: Callable[[Any, Any, Ring], list[Any]]) -> Callable[[int], None]:
    """Ticks of pymunk's `Space.step`, its speed set anew and its lost ball served again once in a while, as needed to go on."""
    pymunk = _pymunk()
    space = pymunk.Space()
    for ring in arena(16).rings:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC if ring.spin else pymunk.Body.STATIC)
        body.angular_velocity = ring.spin
        space.add(body, *model(pymunk, body, ring))
    ball = pymunk.Body(1.0, math.inf)
    circle = pymunk.Circle(ball, BALL_RADIUS)
    space.add(ball, circle)
    for shape in space.shapes:
        shape.elasticity, shape.friction = 1.0, 0.0
    chance = Random(1)
    _put(ball, _served(chance))

    def play(ticks: int) -> None:
        for first in range(0, ticks, _CHECK_EVERY):
            for _ in range(min(_CHECK_EVERY, ticks - first)):
                space.step(TICK)
            if ball.position.length > GROUND or not ball.velocity.length > 0.0:
                _put(ball, _served(chance))
            ball.velocity = ball.velocity.scale_to_length(SPEED)

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
