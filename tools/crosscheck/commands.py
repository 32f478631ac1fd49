"""The options of the pymunk harness: `python -m tools.crosscheck`."""

from pathlib import Path
from typing import Annotated

import typer

from game.replays.file import MAX_TICKS
from game.system.errors import BadInputError
from tools.crosscheck.environment import check_environment
from tools.crosscheck.pymunk_model.facets import FEWEST, MOST

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_MOST_GAMES = 100_000
_MOST_WORKERS = 256
_CLASSES = ("grazing", "tie", "rule", "unexplained")
_SABOTAGES = ("rotated-normal", "swapped-end", "corner-as-end", "still-surface", "dropped-bounce")


@app.command()
def crosscheck(
    replays: Annotated[list[str] | None, typer.Argument(metavar="[REPLAY ...]", help="Recorded games (.polar).")] = None,
    games: Annotated[
        int | None,
        typer.Option(
            min=1, max=_MOST_GAMES, help="Games the autopilot plays.", show_default="one of each level if no REPLAY is given"
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="Seed of the first game; the next ones count up.")] = 1,
    level: Annotated[
        str | None,
        typer.Option(
            help="Level to play: number, name, TOML file, or 'random' for arenas drawn from the seed.",
            show_default="all in turn",
        ),
    ] = None,
    ticks: Annotated[int, typer.Option(min=1, max=MAX_TICKS, help="Longest game, in ticks of 1/240 s.")] = 14_400,
    facets: Annotated[int, typer.Option(min=FEWEST, max=MOST, help="Facets of each arc in pymunk's model.")] = 64,
    workers: Annotated[int, typer.Option(min=1, max=_MOST_WORKERS, help="Processes to share the games.")] = 1,
    report: Annotated[Path | None, typer.Option(help="Write a page with tables and pictures to this HTML file.")] = None,
    json: Annotated[Path | None, typer.Option(help="Write all numbers to this JSON file.")] = None,
    convergence: Annotated[
        bool, typer.Option("--convergence", help="Show that arcs of 8 to 1024 facets come ever closer.")
    ] = False,
    free_run: Annotated[bool, typer.Option("--free-run", help="Let both engines run alone from the same start.")] = False,
    tick: Annotated[int | None, typer.Option(min=0, help="Compare this one tick only.")] = None,
    listed: Annotated[str | None, typer.Option("--list", help=f"List every case of a class: {', '.join(_CLASSES)}.")] = None,
    sabotage: Annotated[
        str | None, typer.Option(help=f"Put a mistake into our side, to see it found: {', '.join(_SABOTAGES)}.")
    ] = None,
) -> int:
    """Compare our contacts with pymunk's: normals, presence, times and bounces, over whole games.

    Exit code 0: nothing unexplained. 1: a disagreement. 2: bad input. 3: no fitting pymunk.
    """
    check_environment()
    from tools.crosscheck import cli  # noqa: PLC0415  # needs pymunk, which has just been looked for

    _one_of("--list", listed, _CLASSES)
    _one_of("--sabotage", sabotage, _SABOTAGES)
    return cli.crosscheck(
        cli.Wishes(
            replays=tuple(replays or ()),
            games=games,
            seed=seed,
            level=level,
            ticks=ticks,
            facets=facets,
            workers=workers,
            only=tick,
            listed=listed,
            sabotage=sabotage,
            report=report,
            json=json,
            convergence=convergence,
            free_run=free_run,
        )
    )


def _one_of(option: str, value: str | None, known: tuple[str, ...]) -> None:
    """BadInputError for a word that is not known."""
    if value is not None and value not in known:
        raise BadInputError(f"{option} {value}: expected one of {', '.join(known)}")
