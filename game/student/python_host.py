"""`python python_host.py SECONDS [FILE]`: answers questions by the line protocol with the functions of a student's Python file.

Run as a file in the child process. What the student's code prints goes to stderr, so that it cannot be taken for an answer.
An answer that takes longer than SECONDS, and a crash, end the process with a trace on stderr that names the student's line.
Besides the functions of the source it is asked `load` (a path and the text to take for that file), `calls` and `composed` (any
number of functions with their arguments: the file's alone, or the slides' that call the file's), `bounces` and `advance`
(game/student/flight.py).
"""

import faulthandler
import json
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import NoReturn

sys.path[0] = str(Path(__file__).resolve().parents[2])  # in place of this folder, whose modules the student must not find
from game.student.hosted import HostedFile, answered, problem_of  # noqa: E402

del sys.path[0]
for _name in [name for name in sys.modules if name.partition(".")[0] == "game"]:
    del sys.modules[_name]  # a module of the student's may have any name


def main() -> None:
    """Answer until there are no more questions."""
    questions, answers = os.fdopen(os.dup(0), encoding="utf-8"), os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os._exit = _no_exit  # type: ignore[assignment]  # an end without a trace would not tell the line
    faulthandler.enable()
    seconds, path = float(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else Path()
    file: HostedFile | None = None
    for line in questions:
        question = json.loads(line)
        name, arguments = question["function"], question["arguments"]
        faulthandler.dump_traceback_later(seconds, exit=True)
        try:
            if name == "load":
                path = Path(arguments[0])
                file = HostedFile(path, arguments[1])
                said: Mapping[str, object] = {"result": sorted(file.functions.own)}
            else:
                file = file or HostedFile(path)
                said = answered(file, name, arguments, path)
        except BaseException as error:  # noqa: BLE001  # whatever the student's code raises is its answer
            problem = problem_of(error, path)
            said = {"error": problem} if file or name == "load" else {"unusable": f"{path.name}, {problem}"}
        faulthandler.cancel_dump_traceback_later()
        answers.write(json.dumps(said) + "\n")
        answers.flush()


def _no_exit(code: int = 0) -> NoReturn:
    """In place of `os._exit`."""
    raise SystemExit(f"os._exit({code})")


if __name__ == "__main__":
    main()
