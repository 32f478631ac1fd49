"""The source's functions, replaced by those that a student's file defines. Each calls the others, whoever wrote them.

For the child process that runs the file.
"""

from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import Any, TypeGuard

from game.student.signatures import OUTCOMES, SIGNATURES, Signature, is_number
from game.student.slides import Plane, Scalar, SlideFunctions

PYTHON_ORDER: Mapping[str, Sequence[str]] = {
    **{name: signature.parameters for name, signature in SIGNATURES.items()},
    "broad_phase": ("p", "r", "theta", "positions", "w_p", "phi_p"),
}
"""The parameters of each function in Python; in the protocol a list comes last."""

_EXPECTED = {
    "number": "a number",
    "angle": "an angle",
    "truth": "True or False",
    "outcome": f"one of {', '.join(map(repr, OUTCOMES))}",
    "point": "a point",
    "polar": "a radius and an angle",
    "normal": "a normal or None",
}


class WrongResultError(Exception):
    """A function returned something unusable. line: of the student's file, where the function begins."""

    def __init__(self, message: str, line: int | None) -> None:
        super().__init__(message)
        self.line = line


class OwnFunctions(SlideFunctions):
    """The slides' functions, replaced by those that a module defines. Points are complex numbers, whatever the file uses.

    own: the names of the functions that are the module's, `advance` among them. A function that raises NotImplementedError is
    not written yet: the slides' answers for it.
    """

    def __init__(self, module: ModuleType) -> None:
        super().__init__()
        self.make_point: Callable[[float, float], Any] = getattr(module, "make_point", complex)
        names = (*SIGNATURES, "advance")
        self.own = frozenset([name for name in names if is_written(getattr(module, name, None))])
        for name in self.own & SIGNATURES.keys():
            setattr(self, name, self._standing_in(getattr(module, name), SIGNATURES[name], getattr(self, name)))

    def narrow_phase_case_1(self, p: Plane, r_p: Scalar) -> Plane:
        """The normal of a face; at the exact centre, where the slide divides by zero, along the x axis."""
        return super().narrow_phase_case_1(p, r_p) if p != 0 else complex(-1.0, 0.0)

    def final_velocity(self, v_res: Plane, v_0: Scalar, n: Plane, v_p: Plane) -> Plane:
        """v_0 v_res / |v_res|; where the slide divides by zero the ball stands still."""
        return super().final_velocity(v_res, v_0, n, v_p) if v_res != 0 else 0j

    def _standing_in(self, function: Callable[..., Any], signature: Signature, ours: Callable[..., Any]) -> Callable[..., Any]:
        """The student's function with the interface of the slides' one; WrongResultError if its result is unusable."""
        order = PYTHON_ORDER[signature.name]

        def called(*values: Any) -> Any:
            given = dict(zip(signature.parameters, values, strict=True))
            for name in signature.points:
                given[name] = self.make_point(given[name].real, given[name].imag)
            try:
                result = function(*[given[name] for name in order])
            except NotImplementedError:
                return ours(*values)
            return checked_result(result, signature.result, function)

        return called


def is_written(function: object) -> TypeGuard[Callable[..., Any]]:
    """Whether something is a function that does more than raise NotImplementedError."""
    code = getattr(function, "__code__", None)
    return callable(function) and getattr(code, "co_names", ()) != ("NotImplementedError",)


def values_of(signature: Signature, numbers: Sequence[float], make_point: Callable[[float, float], Any]) -> dict[str, Any]:
    """The value of each parameter, of the flat list of numbers that the protocol has. make_point: from x and y."""
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


def plain(result: Any) -> Any:
    """A result as JSON has it; TypeError for what no function of the source answers."""
    result = result.tolist() if hasattr(result, "tolist") else result  # numpy's arrays and numbers
    if isinstance(result, complex):
        return [result.real, result.imag]
    if isinstance(result, tuple | list):
        return [plain(part) for part in result]
    if result is None or isinstance(result, bool | int | float | str):
        return result
    raise TypeError(f"the result is a {type(result).__name__}")


def checked_result(result: Any, kind: str, function: Callable[..., Any]) -> Any:
    """A student's result as the slides' functions have it: points complex. kind: one of `signatures.KINDS`."""
    try:
        value = plain(result)
    except TypeError:
        value = result
    if kind == "truth" and isinstance(value, bool | int):
        return bool(value)
    if (kind == "outcome" and value in OUTCOMES) or (kind == "normal" and value is None):
        return value
    if kind in {"number", "angle"} and is_number(value):
        return float(value)
    if kind in {"point", "polar", "normal"} and isinstance(value, list) and len(value) == 2 and all(map(is_number, value)):
        return (float(value[0]), float(value[1])) if kind == "polar" else complex(*value)
    raise wrong_result(function, result, _EXPECTED[kind])


def wrong_result(function: Callable[..., Any], result: object, expected: str) -> WrongResultError:
    """The error for a result that is not what was expected."""
    code = getattr(function, "__code__", None)
    shown = repr(result) if len(repr(result)) <= 40 else f"a {type(result).__name__}"
    name = getattr(function, "__name__", "the function")
    return WrongResultError(f"{name} returned {shown}; expected {expected}", getattr(code, "co_firstlineno", None))


def wrong_result_line(error: BaseException) -> int | None:
    """The line of a WrongResultError; None for any other."""
    return error.line if isinstance(error, WrongResultError) else None
