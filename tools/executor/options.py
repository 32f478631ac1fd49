"""The options of the commands that share their work."""

from typing import Annotated

import typer

from game.system.command_line import refuse_ignored
from tools.executor.results import Where

MOST_WORKERS = 256

WorkersOption = Annotated[int, typer.Option("--workers", min=1, max=MOST_WORKERS, help="Processes to share the work.")]
ClusterOption = Annotated[
    str | None,
    typer.Option("--cluster", metavar="ADDRESS", help="Dask scheduler whose workers share the work: tcp://HOST:PORT."),
]


def where(context: typer.Context, workers: int, cluster: str | None) -> Where:
    """Where the work is to be done; BadInputError where both are given."""
    if cluster is None:
        return workers
    refuse_ignored(context, "does nothing beside --cluster", "workers")
    return cluster
