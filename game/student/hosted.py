"""A student's Python file where it runs: what its functions answer to the questions of the line protocol."""

import importlib.machinery
import importlib.util
import sys
import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from game.student.flight import bounces, own_advance
from game.student.own_functions import PYTHON_ORDER, OwnFunctions, is_written, plain, values_of, wrong_result_line
from game.student.signatures import SIGNATURES, answer


class HostedFile:
    """The module of a student's file, and the source's functions with those of the file in their place."""

    def __init__(self, path: Path, text: str | None = None, watch: Callable[[CodeType], None] | None = None) -> None:
        """Run the file; whatever it raises is raised.

        text: in place of what the file holds now. watch: is given the file's code before it runs.
        """
        if str(path.parent) not in sys.path:
            sys.path.insert(0, str(path.parent))
        loader = importlib.machinery.SourceFileLoader("student_functions", str(path))
        found = importlib.util.spec_from_file_location(loader.name, path, loader=loader)
        assert found is not None
        self.module = importlib.util.module_from_spec(found)
        sys.modules[found.name] = self.module
        code = loader.source_to_code(path.read_bytes() if text is None else text, str(path))
        if watch is not None:
            watch(code)
        exec(code, self.module.__dict__)  # noqa: S102  # running the student's file is the purpose
        self.functions = OwnFunctions(self.module)


def answered(file: HostedFile, name: str, arguments: list[Any], path: Path) -> Mapping[str, object]:
    """The answer to one question."""
    if name in {"calls", "composed"}:
        return {"result": [_called(file, call, path, composed=name == "composed") for call in arguments]}
    if name == "bounces":
        return {"result": bounces(file.functions, *arguments)}
    if name == "advance":
        return {"result": own_advance(file.module.advance, file.functions, *arguments)}
    return _answer(file.module, name, arguments)


def _called(file: HostedFile, call: list[Any], path: Path, *, composed: bool) -> Mapping[str, object]:
    """The answer to one of several calls, an error included."""
    try:
        return {"result": answer(file.functions, *call)} if composed else _answer(file.module, *call)
    except Exception as error:  # noqa: BLE001  # the other calls are answered
        return {"error": problem_of(error, path)}


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


def problem_of(error: BaseException, path: Path) -> str:
    """Where and why the student's code failed, in one line."""
    words = " ".join(f"{type(error).__name__}: {error}".split()).removesuffix(":")
    if isinstance(error, SyntaxError) and error.filename == str(path):
        return f"line {error.lineno}: {type(error).__name__}: {error.msg}"
    if (line := wrong_result_line(error)) is not None:
        return f"line {line}: {error}"
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    return f"line {lines[-1]}: {words}" if lines else words
