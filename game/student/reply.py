"""Answers of a student's functions, as the line protocol has them (docs/grading.md)."""

import json
from collections.abc import Sequence
from typing import NamedTuple, Protocol

from game.system.errors import BadInputError

_SHOWN = 80
"""Characters of an unusable answer that a report quotes."""


class Reply(NamedTuple):
    """An answer to a question.

    result: what JSON made of it. problem: why there is none. defined: False where the program lacks the function. ended:
    whether the program had to be ended, or had ended by itself.
    """

    result: object = None
    problem: str | None = None
    defined: bool = True
    ended: bool = False


class AskedFunctions(Protocol):
    """Whatever answers calls of the source's functions, one at a time."""

    def ask(self, function: str, arguments: Sequence[object]) -> Reply:
        """The answer. Whatever goes wrong is in the reply."""


def parsed_answer(answer: object) -> Reply:
    """The reply that an object of the line protocol means; `ended` where it is none of them."""
    key, value = next(iter(answer.items())) if isinstance(answer, dict) and len(answer) == 1 else ("", None)
    match key:
        case "unusable":
            raise BadInputError(str(value))
        case "undefined":
            return Reply(defined=False)
        case "error":
            return Reply(problem=str(value))
        case "result":
            return Reply(value)
    return Reply(problem=f"not an answer: {shown_text(json.dumps(answer))}", ended=True)


def shown_text(text: str) -> str:
    """A text short enough for a report, without control characters."""
    shown = "".join([letter if letter.isprintable() else "?" for letter in text[: _SHOWN + 1]])
    return shown if len(shown) <= _SHOWN else f"{shown[:_SHOWN]}..."
