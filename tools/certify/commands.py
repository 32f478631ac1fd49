"""The options of the proofs: `python -m tools.certify`."""

from pathlib import Path
from typing import Annotated

import typer

from tools.certify.environment import check_environment
from tools.executor.options import ClusterOption, WorkersOption, where

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)

_MOST_IMPACTS = 10**7
_MOST_PIECES = 10**7


@app.command()
def certify(
    context: typer.Context,
    sources: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[SOURCE ...]", help="Recorded games (.polar), game:LEVEL:SEED, arena:SEED:INDEX, impacts:SEED:BATCH."
        ),
    ] = None,
    impacts: Annotated[
        int, typer.Option(min=1, max=_MOST_IMPACTS, help="Without a SOURCE: how many impacts at least.")
    ] = 10_000,
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="Without a SOURCE: seed of the games and arenas.")] = 1,
    workers: WorkersOption = 1,
    cluster: ClusterOption = None,
    json: Annotated[Path | None, typer.Option(help="Write all numbers to this JSON file.")] = None,
    functions: Annotated[
        int | None,
        typer.Option(
            min=1, max=_MOST_PIECES, metavar="PIECES", help="Prove the source's functions over boxes cut into so many pieces."
        ),
    ] = None,
    every_case: Annotated[bool, typer.Option("--list", help="List every claim that is not certified.")] = False,
) -> int:
    """Prove every impact: when it is, that nothing is touched before, and the normal, in ball arithmetic.

    Exit code 0: nothing refuted. 1: a claim is wrong. 2: bad input. 3: no python-flint.
    """
    check_environment()
    from tools.certify import command  # noqa: PLC0415  # needs python-flint, which has just been looked for

    if functions is not None:
        return command.certify_functions(functions, json)
    return command.certify(tuple(sources or ()), impacts, seed, where(context, workers, cluster), json, every_case=every_case)
