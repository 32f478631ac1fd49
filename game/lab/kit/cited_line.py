"""The line that decides what a scene shows: a line of the source, or a line of a function of this project."""

import inspect
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple


class CitedLine(NamedTuple):
    """A line of text, and where it stands.

    where: the source's heading, or file, line number and function. The number is left out where Python has no source text.
    text: the line itself, or as much of it as decides.
    """

    where: str
    text: str


def source_line(heading: str, text: str) -> CitedLine:
    """A line of the source. heading: of the page that it stands on."""
    return CitedLine(f"the source, {heading}", text)


@cache
def code_line(function: Callable[..., Any], text: str) -> CitedLine:
    """A line of a function, or a part of a line.

    Where Python has the function's source text, the text must be found in exactly one of its lines, else ValueError: a citation
    cannot outlive the line that it cites. A frozen program has no source text; there the citation is shown as it was written.
    """
    number = _line_number(function, text)
    file = f"{function.__module__.replace('.', '/')}.py"
    return CitedLine(f"{file if number is None else f'{file}:{number}'} {function.__name__}", text)


def _line_number(function: Callable[..., Any], text: str) -> int | None:
    """The number of the one line of a function that holds a text; None without source text, ValueError without such a line."""
    try:
        lines, first = inspect.getsourcelines(function)
    except OSError:
        return None
    found = [number for number, line in enumerate(lines, first) if text in line]
    if len(found) != 1:
        raise ValueError(f"{function.__qualname__} has {len(found)} lines with {text!r}, not one")
    return found[0]
