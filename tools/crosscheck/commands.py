"""The options of the pymunk harness: `python -m tools.crosscheck`."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from game.replays.file import MAX_TICKS
from game.student.functions_file import FunctionsFile
from game.system.command_line import refuse_ignored
from game.system.errors import BadInputError
from tools.crosscheck.environment import check_environment
from tools.crosscheck.pymunk_model.facets import FEWEST, MOST
from tools.executor.options import ClusterOption, WorkersOption, where

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_MOST_GAMES = 100_000
_VERDICTS = ("grazing", "tie", "rule", "unexplained")
_NOT_WITH_OWN = ("facets", "workers", "report", "json", "convergence", "free_run", "tick", "listed", "sabotage", "corpus")
_DIFFICULTIES = ("easy", "normal", "hard")
_PLAYERS = ("autopilot", "mouse", "keys")


@app.command()
def crosscheck(
    context: typer.Context,
    replays: Annotated[list[str] | None, typer.Argument(metavar="[REPLAY ...]", help="Recorded games (.polar).")] = None,
    games: Annotated[
        int | None,
        typer.Option(
            min=1,
            max=_MOST_GAMES,
            help="How many games to play.",
            show_default="three of each level, random arenas and aimed contacts, if nothing is named",
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="Seed of the first game; the next ones count up.")] = 1,
    level: Annotated[
        str | None,
        typer.Option(
            help="Level to play: number, name, TOML file, 'random' for arenas drawn from the seed, 'aimed' for contacts of "
            "every kind.",
            show_default="all in turn",
        ),
    ] = None,
    ticks: Annotated[int, typer.Option(min=1, max=MAX_TICKS, help="Longest game, in ticks of 1/240 s.")] = 14_400,
    player: Annotated[str | None, typer.Option(help=f"Who plays: {', '.join(_PLAYERS)}.", show_default="autopilot")] = None,
    arcade: Annotated[
        str | None,
        typer.Option(
            help=f"Play by the arcade rules, at a difficulty: {', '.join(_DIFFICULTIES)}.", show_default="source's rules"
        ),
    ] = None,
    facets: Annotated[int, typer.Option(min=FEWEST, max=MOST, help="Facets of each arc in pymunk's chain.")] = 64,
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    report: Annotated[Path | None, typer.Option(help="Write a page with tables and pictures to this HTML file.")] = None,
    json: Annotated[Path | None, typer.Option(help="Write all numbers, a row for each contact, to this JSON file.")] = None,
    convergence: Annotated[
        bool, typer.Option("--convergence", help="Show that arcs of 8 to 1024 facets come ever closer.")
    ] = False,
    free_run: Annotated[bool, typer.Option("--free-run", help="Let both engines run alone from the same start.")] = False,
    tick: Annotated[int | None, typer.Option(min=0, help="Compare this one tick only.")] = None,
    listed: Annotated[str | None, typer.Option("--list", help=f"List all of a verdict: {', '.join(_VERDICTS)}.")] = None,
    sabotage: Annotated[
        str | None, typer.Option(help="Make a mistake in the game's code, to see it found; 'all' for a table of all mistakes.")
    ] = None,
    corpus: Annotated[
        Path | None, typer.Option(help="Check the fixed list of games into this folder; go on where an earlier run stopped.")
    ] = None,
    with_: Annotated[
        Path | None,
        typer.Option("--with", help="A Python file with any of the source's functions: these are compared (docs/student.md)."),
    ] = None,
) -> int:
    """Compare our contacts with pymunk's: what is hit, normals, presence, times and bounces, over whole games.

    Exit code 0: nothing unexplained. 1: a disagreement. 2: bad input. 3: no fitting pymunk.
    """
    check_environment()
    from tools.crosscheck import command  # noqa: PLC0415  # needs pymunk, which has just been looked for
    from tools.crosscheck.run import Choice, chosen_sources  # noqa: PLC0415
    from tools.crosscheck.sabotage.catalogue import MISTAKES  # noqa: PLC0415

    _one_of("--list", listed, _VERDICTS)
    _one_of("--player", player, _PLAYERS)
    _one_of("--arcade", arcade, _DIFFICULTIES)
    if sabotage is not None:
        _one_of("--sabotage", sabotage, ("all", *MISTAKES))
    choice = Choice(tuple(replays or ()), games, seed, level, ticks, player, arcade)
    if with_ is not None:
        from tools.crosscheck.own import compare_own  # noqa: PLC0415

        refuse_ignored(context, "does nothing beside --with", *_NOT_WITH_OWN)
        with FunctionsFile(with_) as own:
            compare_own(chosen_sources(choice), own, Console())
        return 0
    return command.crosscheck(
        command.Options(
            choice=choice,
            facets=facets,
            workers=where(context, workers, cluster),
            only=tick,
            listed=listed,
            sabotage=sabotage,
            report=report,
            json=json,
            convergence=convergence,
            free_run=free_run,
            corpus=corpus,
        )
    )


def _one_of(option: str, value: str | None, known: tuple[str, ...]) -> None:
    """BadInputError for a word that is not known."""
    if value is not None and value not in known:
        raise BadInputError(f"{option} {value}: expected one of {', '.join(known)}")
