"""`python python_host.py SECONDS [FILE]`: answers questions by the line protocol with the functions of a student's Python file.

Run as a file in the child process. What the student's code prints goes to stderr, so that it cannot be taken for an answer.
An answer that takes longer than SECONDS, and a crash, end the process with a trace on stderr that names the student's line.
Besides the functions of the source it is asked `load` (a path and the text to take for that file), `calls` and `composed` (any
number of functions with their arguments: the file's alone, or the slides' that call the file's), `bounces` and `advance`
(game/student/flight.py).
"""

import faulthandler
import importlib.machinery
import importlib.util
import json
import os
import sys
import traceback
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any, NoReturn

sys.path[0] = str(Path(__file__).resolve().parents[2])  # in place of this folder, whose modules the student must not find
from game.student.flight import bounces, own_advance  # noqa: E402
from game.student.own_functions import PYTHON_ORDER, OwnFunctions, is_written, plain, values_of, wrong_result_line  # noqa: E402
from game.student.signatures import SIGNATURES, answer  # noqa: E402

del sys.path[0]
for _name in [name for name in sys.modules if name.partition(".")[0] == "game"]:
    del sys.modules[_name]  # a module of the student's may have any name


class _StudentsFile:
    """The module that a student's file makes, and the source's functions with its own in their place."""

    def __init__(self, path: Path, text: str | None = None) -> None:
        """Run the file; whatever it raises is raised. text: in place of what the file holds now."""
        if str(path.parent) not in sys.path:
            sys.path.insert(0, str(path.parent))
        loader = importlib.machinery.SourceFileLoader("student_functions", str(path))
        found = importlib.util.spec_from_file_location(loader.name, path, loader=loader)
        assert found is not None
        self.module = importlib.util.module_from_spec(found)
        sys.modules[found.name] = self.module
        code = loader.source_to_code(path.read_bytes() if text is None else text, str(path))
        exec(code, self.module.__dict__)  # noqa: S102  # running the student's file is the purpose
        self.functions = OwnFunctions(self.module)


def main() -> None:
    """Answer until there are no more questions."""
    questions, answers = os.fdopen(os.dup(0), encoding="utf-8"), os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os._exit = _no_exit  # type: ignore[assignment]  # an end without a trace would not tell the line
    faulthandler.enable()
    seconds, path = float(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else Path()
    file: _StudentsFile | None = None
    for line in questions:
        question = json.loads(line)
        name, arguments = question["function"], question["arguments"]
        faulthandler.dump_traceback_later(seconds, exit=True)
        try:
            if name == "load":
                path = Path(arguments[0])
                file = _StudentsFile(path, arguments[1])
                said: Mapping[str, object] = {"result": sorted(file.functions.own)}
            else:
                file = file or _StudentsFile(path)
                said = _answered(file, name, arguments, path)
        except BaseException as error:  # noqa: BLE001  # whatever the student's code raises is its answer
            problem = _problem(error, path)
            said = {"error": problem} if file or name == "load" else {"unusable": f"{path.name}, {problem}"}
        faulthandler.cancel_dump_traceback_later()
        answers.write(json.dumps(said) + "\n")
        answers.flush()


def _answered(file: _StudentsFile, name: str, arguments: list[Any], path: Path) -> Mapping[str, object]:
    """The answer to one question."""
    if name in {"calls", "composed"}:
        return {"result": [_called(file, call, path, composed=name == "composed") for call in arguments]}
    if name == "bounces":
        return {"result": bounces(file.functions, *arguments)}
    if name == "advance":
        return {"result": own_advance(file.module.advance, file.functions, *arguments)}
    return _answer(file.module, name, arguments)


def _called(file: _StudentsFile, call: list[Any], path: Path, *, composed: bool) -> Mapping[str, object]:
    """The answer to one of several calls, an error included."""
    try:
        return {"result": answer(file.functions, *call)} if composed else _answer(file.module, *call)
    except Exception as error:  # noqa: BLE001  # the other calls are answered
        return {"error": _problem(error, path)}


def _answer(module: ModuleType, name: str, numbers: list[float]) -> Mapping[str, object]:
    """What a function of the source, as the file has it, answers."""
    function = getattr(module, name, None)
    if name not in SIGNATURES or not is_written(function):
        return {"undefined": True}
    values = values_of(SIGNATURES[name], numbers, getattr(module, "make_point", complex))
    try:
        return {"result": plain(function(*[values[parameter] for parameter in PYTHON_ORDER[name]]))}
    except NotImplementedError:
        return {"undefined": True}


def _no_exit(code: int = 0) -> NoReturn:
    """In place of `os._exit`."""
    raise SystemExit(f"os._exit({code})")


def _problem(error: BaseException, path: Path) -> str:
    """Where and why the student's code failed, in one line."""
    words = " ".join(f"{type(error).__name__}: {error}".split()).removesuffix(":")
    if isinstance(error, SyntaxError) and error.filename == str(path):
        return f"line {error.lineno}: {type(error).__name__}: {error.msg}"
    if (line := wrong_result_line(error)) is not None:
        return f"line {line}: {error}"
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    return f"line {lines[-1]}: {words}" if lines else words


if __name__ == "__main__":
    main()
