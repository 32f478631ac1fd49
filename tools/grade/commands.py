"""The command line of the grading: `python -m tools.grade`."""

from pathlib import Path
from typing import Annotated

import typer

from tools.grade.template import write_template
from tools.vectors.environment import check_environment

app = typer.Typer(add_completion=False, pretty_exceptions_enable=False, rich_markup_mode=None)


@app.command()
def grade(
    file: Annotated[
        Path | None, typer.Argument(metavar="[FILE]", help="Python file with any of the source's functions.")
    ] = None,
    command: Annotated[
        str | None, typer.Option(help="Instead of a file: a program that speaks the line protocol (docs/grading.md).")
    ] = None,
    scheme: Annotated[Path | None, typer.Option(help="The teacher's TOML file: functions, weights, tolerances.")] = None,
    seed: Annotated[int, typer.Option(min=0, max=2**62, help="0: the published vectors; others: hidden ones.")] = 0,
    time_limit: Annotated[float, typer.Option(min=0.01, max=3600.0, help="Seconds for an answer.")] = 2.0,
    start_limit: Annotated[
        float, typer.Option(min=0.01, max=3600.0, help="Seconds for the first answer after a start.")
    ] = 20.0,
    memory: Annotated[int, typer.Option(min=64, max=2**20, help="Mebibytes that the program may use (Linux).")] = 2048,
    json: Annotated[Path | None, typer.Option(help="Write the grade to this JSON file.")] = None,
    junit: Annotated[Path | None, typer.Option(help="Write the grade to this JUnit XML file.")] = None,
    pictures: Annotated[
        Path | None, typer.Option(help="Draw the simplest wrong answer of each function into this folder, as the lab shows it.")
    ] = None,
    template: Annotated[
        Path | None, typer.Option(help="Write a file to begin with, every function still to be written, and end.")
    ] = None,
) -> int:
    """Grade an implementation of the source's functions against the conformance vectors.

    Exit code 0: all that counts is right. 1: something is wrong. 2: bad input. 3: no mpmath.
    """
    if template is not None:
        write_template(template)
        return 0
    check_environment()
    from game.student.program import Limits  # noqa: PLC0415
    from tools.grade.command import chosen_program, grade_program  # noqa: PLC0415  # need mpmath, just looked for

    limits = Limits(time_limit, start_limit, memory)
    return grade_program(chosen_program(file, command, limits), scheme, seed, limits, json, junit, pictures)
