"""The teacher's file: which functions count, how much, and how exact they must be."""

import math
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from game.student.signatures import SIGNATURES, Result
from game.system.errors import BadInputError
from tools.vectors.vector import ConformanceVector, size


class Scheme(NamedTuple):
    """How functions are graded.

    title: above the report. functions: those that must be there; None: whichever the program has. weights: 1 unless given.
    tolerance: of every number, times the result's size where that is above 1; None: the vector's own. tolerances: by function.
    """

    title: str = ""
    functions: tuple[str, ...] | None = None
    weights: Mapping[str, float] = {}
    tolerance: float | None = None
    tolerances: Mapping[str, float] = {}

    def counts(self, name: str) -> bool:
        """Whether a function counts, if it is there."""
        return self.functions is None or name in self.functions

    def weight(self, name: str) -> float:
        """The weight of a function."""
        return self.weights.get(name, 1.0)

    def tolerance_of(self, vector: ConformanceVector, expected: Result) -> float:
        """By how much a number of a result may differ."""
        given = self.tolerances.get(vector.function, self.tolerance)
        return vector.tolerance if given is None else given * size(expected)


def load_scheme(path: Path) -> Scheme:
    """Read a teacher's TOML file; BadInputError names the key and the rule."""
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise BadInputError(f"{path}: cannot be read; {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise BadInputError(f"{path}: {error}") from None
    unknown = table.keys() - set(Scheme._fields)
    if unknown:
        raise BadInputError(f"{path}: no key {min(unknown)!r}; expected {', '.join(Scheme._fields)}")
    title = table.get("title", "")
    if not isinstance(title, str):
        raise BadInputError(f"{path}: title: expected text")
    weights = _numbers(path, table, "weights", zero=True)
    names = table.get("functions")
    if names is not None and (not isinstance(names, list) or not names):
        raise BadInputError(f"{path}: functions: expected a list of names")
    functions = None if names is None else tuple([_known(path, "functions", name) for name in names])
    if not any([weights.get(name, 1.0) > 0.0 for name in functions or SIGNATURES]):
        raise BadInputError(f"{path}: weights: all are 0")
    tolerance = None if "tolerance" not in table else _number(path, "tolerance", table["tolerance"])
    return Scheme(title, functions, weights, tolerance, _numbers(path, table, "tolerances"))


def _numbers(path: Path, table: Mapping[str, object], key: str, *, zero: bool = False) -> dict[str, float]:
    """A table with a number for some functions."""
    numbers = table.get(key, {})
    if not isinstance(numbers, dict):
        raise BadInputError(f"{path}: {key}: expected a table [{key}]")
    return {_known(path, key, name): _number(path, f"{key}.{name}", number, zero=zero) for name, number in numbers.items()}


def _known(path: Path, key: str, name: object) -> str:
    """The name of a function of the source."""
    if not isinstance(name, str) or name not in SIGNATURES:
        raise BadInputError(f"{path}: {key}: no function {name!r}; expected {', '.join(SIGNATURES)}")
    return name


def _number(path: Path, key: str, number: object, *, zero: bool = False) -> float:
    """A number above 0, or 0 where that is allowed."""
    if isinstance(number, bool) or not isinstance(number, int | float) or not (0 if zero else 1e-15) <= number < math.inf:
        raise BadInputError(f"{path}: {key}: expected a number {'from 0' if zero else 'above 0'}")
    return float(number)
