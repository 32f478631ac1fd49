"""The command line of the conformance vectors: `python -m tools.vectors`."""

from pathlib import Path
from typing import Annotated

import typer

from game.system.errors import BadInputError
from game.system.files import check_target, write_text
from game.system.output import print_line
from tools.vectors.environment import check_environment

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


@app.command()
def write(
    out: Annotated[Path, typer.Argument(metavar="OUT", help="Folder for vectors.json and vectors.csv.")],
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="0: the published vectors; others: hidden ones.")] = 0,
) -> int:
    """Write inputs and expected results of every function of the source, for tests in any language.

    Exit code 0: written. 2: bad input. 3: no mpmath.
    """
    check_environment()
    from tools.vectors.files import csv_text, json_text  # noqa: PLC0415  # need mpmath, which has just been looked for
    from tools.vectors.vector import vectors  # noqa: PLC0415

    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInputError(f"{out}: cannot be made a folder; {error.strerror}") from None
    json_file, csv_file = out / "vectors.json", out / "vectors.csv"
    check_target(json_file, "OUT")
    check_target(csv_file, "OUT")
    found = vectors(seed)
    write_text(json_file, json_text(found, seed))
    write_text(csv_file, csv_text(found))
    print_line(f"{len(found):,} vectors of {len({vector.function for vector in found})} functions, seed {seed}: {out}")
    return 0
