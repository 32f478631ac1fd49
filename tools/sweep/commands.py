"""The options of the sweep: `python -m tools.sweep`."""

from contextlib import closing
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from game.levels import built_in, chosen
from game.rules import SOURCE_RULES, TICK, Difficulty, Ruleset
from game.system.command_line import refuse_ignored
from game.system.errors import BadInputError
from game.system.files import check_target, check_working_directory, write_atomically
from game.system.output import print_error, print_line
from game.system.wording import quoted
from tools.balance.players import AUTOPILOT, parsed_skills
from tools.executor import Where, results, sure
from tools.executor.options import ClusterOption, WorkersOption, where
from tools.sweep.journal import Journal, add
from tools.sweep.plan import Axes, Plan, grid, sample
from tools.sweep.play import Row, played
from tools.sweep.table import PointSummary, check_table, summaries, write_table

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_MOST_POINTS = 10**7
_LARGEST_FACTOR = 10.0
_RULES = {"source": SOURCE_RULES} | {each.name.lower(): Ruleset(each) for each in Difficulty}
_HEADINGS = ("level", "player", "top", "friction", "ball", "games", "cleared", "s", "loops", "impacts/tick", "gap", "lost")
_MOST_LINES = 200
"""Points that are printed; a table of more is read by a program."""


@app.command()
def sweep(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="Write a row for every game to this .csv or .parquet file.")],
    level: Annotated[
        list[str] | None, typer.Option(help="A level: number, name or TOML file; again for more. Default: all.")
    ] = None,
    players: Annotated[str, typer.Option(help="autopilot, or simulated humans as MS/DEG.")] = f"{AUTOPILOT},220/5",
    top_speed: Annotated[str, typer.Option(metavar="X,...", help="Factors of the paddles' top speed.")] = "1",
    friction: Annotated[str | None, typer.Option(metavar="X,...", help="Frictions of the paddles; else the level's.")] = None,
    ball_speed: Annotated[str, typer.Option(metavar="X,...", help="Factors of the ball's speed.")] = "1",
    seeds: Annotated[int, typer.Option(min=1, max=10**6, help="Games at every point of the grid.")] = 5,
    samples: Annotated[
        int | None, typer.Option(min=1, max=_MOST_POINTS, help="Games at so many points drawn between the axes' ends instead.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="Of the drawn points.")] = 1,
    rules: Annotated[str, typer.Option(help=f"{', '.join(_RULES)}: the source's, or the arcade's and how hard.")] = "normal",
    minutes: Annotated[float, typer.Option(min=0.01, max=60.0, help="After which a game is given up.")] = 5.0,
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    plot: Annotated[Path | None, typer.Option(help="Draw what the axes do, to this .png file.")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on where a run with the same options was stopped.")] = False,
) -> int:
    """Play levels many times, over a grid or a random sample of speeds and frictions, and write what happened in each game.

    Exit code 0: done. 2: bad input. 3: no such cluster, or a library is missing. 130: Ctrl-C; what was played is written.
    """
    check_working_directory()
    check_table(out)
    check_target(out, "--out")
    check_target(plot, "--plot", ".png")
    if samples is None:
        refuse_ignored(context, "needs --samples", "seed")
    else:
        refuse_ignored(context, "does nothing beside --samples", "seeds")
    if rules not in _RULES:
        raise BadInputError(f"--rules {quoted(rules)}: expected one of {', '.join(_RULES)}")
    levels = built_in() if level is None else tuple([chosen(name)[0] for name in level])
    frictions = [] if friction is None else _numbers("--friction", friction, 0.0, 1.0)
    axes = Axes(levels, _players(players), _factors("--top-speed", top_speed), frictions, _factors("--ball-speed", ball_speed))
    ticks = round(minutes * 60.0 / TICK)
    ruleset = _RULES[rules]
    plan = grid(axes, seeds, ruleset, ticks) if samples is None else sample(axes, samples, seed, ruleset, ticks)
    for reason in plan.left_out:
        print_error(f"left out: {reason}")
    if not plan.jobs:
        raise BadInputError("no point can be played")
    return _swept(plan, out, plot, where(context, workers, cluster), resume=resume)


def _swept(plan: Plan, out: Path, plot: Path | None, place: Where, *, resume: bool) -> int:
    """Play the games that are missing, and write the table; after a signal a part of it, under a name of its own."""
    journal = Journal(out, plan)
    rows = journal.rows() if resume else []
    try:
        with (
            journal.written(rows) as file,
            _bar() as bar,
            closing(sure(results(played, plan.jobs[len(rows) :], place))) as answers,
        ):
            task = bar.add_task("games", total=len(plan.jobs), completed=len(rows))
            for row in answers:
                rows.append(row)
                add(file, row)
                bar.update(task, completed=len(rows))
    except KeyboardInterrupt:
        partial = out.with_name(f"{out.stem}.partial{out.suffix}")
        write_table(partial, rows)
        print_line(f"partial result, {len(rows)} of {len(plan.jobs)} games: {partial}; --resume goes on")
        raise
    write_table(out, rows)
    journal.remove()
    points = summaries(rows)
    if plot is not None:
        from tools.sweep.plots import plot as drawn  # noqa: PLC0415  # matplotlib takes a second to load

        write_atomically(plot, drawn(points))
    _print(points, rows)
    return 0


def _players(text: str) -> list[str]:
    """The players that an option names; BadInputError for what is none."""
    parsed_skills(text)
    return text.split(",")


def _factors(option: str, text: str) -> list[float]:
    """Factors that an option lists."""
    return _numbers(option, text, 1.0 / _LARGEST_FACTOR, _LARGEST_FACTOR)


def _numbers(option: str, text: str, least: float, most: float) -> list[float]:
    """Numbers that an option lists; BadInputError for anything else, or out of range."""
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = [most + 1.0]
    if not all([least <= number <= most for number in numbers]):
        raise BadInputError(f"{option} {quoted(text)}: expected numbers from {least:g} to {most:g}, with commas between")
    return numbers


def _print(points: list[PointSummary], rows: list[Row]) -> None:
    """A line for every point, unless they are too many, and one for all."""
    if len(points) <= _MOST_LINES:
        table = Table(box=None, pad_edge=False)
        headings = (
            "level",
            "player",
            "top",
            "friction",
            "ball",
            "games",
            "cleared",
            "s",
            "loops",
            "impacts/tick",
            "gap",
            "lost",
        )
        for heading in headings:
            table.add_column(heading, justify="left" if heading in {"level", "player"} else "right")
        for point in points:
            numbers = [f"{number:g}" for number in (point.top_speed, point.friction, point.ball_speed, point.games)]
            seconds = "-" if point.seconds is None else f"{point.seconds:.0f}"
            counts = [f"{point.loops:.1f}", f"{point.impacts_per_tick:.4f}", f"{point.longest_gap:.1f}", f"{point.lost:.1f}"]
            table.add_row(point.level, point.player, *numbers, f"{point.cleared:.0%}", seconds, *counts)
        Console(width=120).print(table)
    cleared = sum([row.cleared for row in rows]) / len(rows)
    print_line(f"{len(rows)} games at {len(points)} points: {cleared:.0%} cleared, {sum([row.loops for row in rows])} loops")


def _bar() -> Progress:
    """A progress bar on stderr, where somebody can see it."""
    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    console = Console(stderr=True)
    return Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
