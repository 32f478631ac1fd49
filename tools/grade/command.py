"""The command's work, once the options are read and the machine is known to have mpmath."""

import shlex
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

from game.student.program import Limits, Student, Wait, next_line, python_host
from game.system.errors import BadInputError
from game.system.files import check_target, write_text
from game.system.output import print_line
from tools.grade.findings import all_findings
from tools.grade.grading import grade
from tools.grade.pictures import drawn
from tools.grade.report import report_lines
from tools.grade.report_files import json_text, junit_text
from tools.grade.scheme import Scheme, load_scheme
from tools.vectors.vector import vectors


class Program(NamedTuple):
    """What is graded: a command, and the Python file that it runs, if any."""

    command: list[str]
    file: Path | None = None


def grade_program(
    program: Program,
    scheme_file: Path | None,
    seed: int,
    limits: Limits,
    json: Path | None,
    junit: Path | None,
    pictures: Path | None = None,
    wait: Wait = next_line,
) -> int:
    """Grade a program that speaks the line protocol; the exit code."""
    check_target(json, "--json")
    check_target(junit, "--junit")
    scheme = Scheme() if scheme_file is None else load_scheme(scheme_file)
    student = Student(program.command, limits, wait, program.file)
    try:
        found = grade(student, vectors(seed), scheme, seed)
    finally:
        student.close()
    if not any([function.defined for function in found.functions]):
        raise BadInputError("none of the source's functions is written yet; docs/grading.md has their names")
    findings = all_findings(found)
    for line in report_lines(found, findings):
        print_line(line)
    if json is not None:
        write_text(json, json_text(found, findings))
    if junit is not None:
        write_text(junit, junit_text(found, findings))
    for picture in () if pictures is None else drawn(findings, pictures, program.file):
        print_line(f"picture: {picture}")
    return 0 if found.right else 1


def chosen_program(file: Path | None, command: str | None, limits: Limits) -> Program:
    """The program to ask: a Python file's host, or a command. BadInputError unless it is exactly one of them, and is there."""
    if (file is None) is (command is None):
        raise BadInputError("expected a Python file or --command, one of them")
    if file is not None:
        if not file.is_file():
            raise BadInputError(f"{file}: no such file")
        return Program(python_host(limits, file), file.resolve())
    try:
        words = shlex.split(command or "", posix=sys.platform != "win32")
    except ValueError as error:
        raise BadInputError(f"--command {command}: {error}") from None
    if not words or shutil.which(words[0]) is None:
        raise BadInputError(f"--command {command}: no such program")
    return Program(words)
