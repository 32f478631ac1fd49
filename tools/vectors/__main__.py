"""The command line of the conformance vectors: `python -m tools.vectors`."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from game.system.command_line import run
from game.system.errors import BadInputError
from tools.crosscheck.files import check_writable, write_whole
from tools.vectors.environment import check_environment

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


def main() -> None:
    """Run the command line and exit."""
    sys.exit(run(app, "python -m tools.vectors"))


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
    check_writable(json_file, "OUT")
    check_writable(csv_file, "OUT")
    found = vectors(seed)
    write_whole(json_file, json_text(found, seed))
    write_whole(csv_file, csv_text(found))
    print(f"{len(found):,} vectors of {len({vector.function for vector in found})} functions, seed {seed}: {out}")
    return 0


if __name__ == "__main__":
    main()
