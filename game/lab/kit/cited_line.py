"""The line that decides: of the source, or of a function here, read from the function itself so that it cannot drift."""

import inspect
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import physics

_ROOT = Path(physics.__file__).parent.parent


class Deciding(NamedTuple):
    """A line and where it stands."""

    where: str
    text: str


def source(page: str, text: str) -> Deciding:
    """A line of the source. page: the heading it stands under."""
    return Deciding(f"the source, {page}", text)


@cache
def code(function: Callable[..., Any], part: str) -> Deciding:
    """The line of a function that holds `part`; ValueError unless there is exactly one."""
    lines, first = inspect.getsourcelines(function)
    found = [(number, line.strip()) for number, line in enumerate(lines, first) if part in line]
    if len(found) != 1:
        raise ValueError(f"{function.__qualname__} has {len(found)} lines with {part!r}, not one")
    number, text = found[0]
    path = Path(inspect.getfile(function)).relative_to(_ROOT).as_posix()
    return Deciding(f"{path}:{number} {function.__name__}", text)
