"""`python python_host.py FILE`: answers questions by the line protocol with the functions of a student's Python file.

Run as a file in the child process. What the student's code prints goes to stderr, so that it cannot be taken for an answer.
"""

import importlib.util
import json
import os
import sys
import traceback
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

sys.path[0] = str(Path(__file__).resolve().parents[2])  # in place of this folder, whose modules the student must not find
from tools.vectors.signatures import SIGNATURES, Signature  # noqa: E402

del sys.path[0]

_PYTHON_ORDER = {"broad_phase": ("p", "r", "theta", "positions", "w_p", "phi_p")}
"""Where the order of the parameters in Python is not that of the protocol, whose lists come last."""


def main() -> None:
    """Answer until there are no more questions."""
    questions, answers = os.fdopen(os.dup(0), encoding="utf-8"), os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    path = Path(sys.argv[1]).resolve()
    module: ModuleType | None = None
    for line in questions:
        question = json.loads(line)
        try:
            module = module or _loaded(path)
            answer = _answer(module, question["function"], question["arguments"])
        except BaseException as error:  # noqa: BLE001  # whatever the student's code raises is its answer
            problem = _problem(error, path)
            answer = {"error": problem} if module else {"unusable": f"{path.name}, {problem}"}
        answers.write(json.dumps(answer) + "\n")
        answers.flush()


def _loaded(path: Path) -> ModuleType:
    """The student's file as a module."""
    sys.path.insert(0, str(path.parent))
    found = importlib.util.spec_from_file_location("student_functions", path)
    assert found is not None
    assert found.loader is not None
    module = importlib.util.module_from_spec(found)
    sys.modules[found.name] = module
    found.loader.exec_module(module)
    return module


def _answer(module: ModuleType, name: str, numbers: list[float]) -> Mapping[str, object]:
    """The answer to one question."""
    function = getattr(module, name, None)
    if function is None:
        return {"undefined": True}
    signature = SIGNATURES[name]
    values = _values(signature, numbers, getattr(module, "make_point", complex))
    return {"result": _plain(function(*[values[parameter] for parameter in _PYTHON_ORDER.get(name, signature.parameters)]))}


def _values(signature: Signature, numbers: list[float], make_point: Any) -> dict[str, Any]:
    """The value of each parameter: points are complex numbers, unless the file says how to make them."""
    rest = list(numbers)
    values: dict[str, Any] = {}
    for parameter in signature.parameters:
        if parameter == "positions":
            values[parameter] = list(zip(rest[::2], rest[1::2], strict=True))
        elif parameter in signature.points:
            values[parameter] = make_point(rest.pop(0), rest.pop(0))
        else:
            values[parameter] = rest.pop(0)
    return values


def _plain(result: Any) -> Any:
    """A result as JSON has it; TypeError for what no function of the source answers."""
    result = result.tolist() if hasattr(result, "tolist") else result  # numpy's arrays and numbers
    if isinstance(result, complex):
        return [result.real, result.imag]
    if isinstance(result, tuple | list):
        return [_plain(part) for part in result]
    if result is None or isinstance(result, bool | int | float | str):
        return result
    raise TypeError(f"the result is a {type(result).__name__}")


def _problem(error: BaseException, path: Path) -> str:
    """Where and why the student's code failed, in one line."""
    words = " ".join(f"{type(error).__name__}: {error}".split()).removesuffix(":")
    if isinstance(error, SyntaxError) and error.filename == str(path):
        return f"line {error.lineno}: {words}"
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    return f"line {lines[-1]}: {words}" if lines else words


if __name__ == "__main__":
    main()
