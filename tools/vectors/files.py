"""The vectors as files: vectors.json and vectors.csv, which say the same."""

import csv
import io
import json
from collections.abc import Sequence

from game.student.signatures import OUTCOMES, SIGNATURES, Result
from tools.vectors.vector import DIGITS, ConformanceVector

FORMAT = "polar-breakout vectors 1"
"""Name and version of the format. The number rises when a reader of the old files could misread the new ones,
or when a result changes."""

COLUMNS = ("id", "function", "slide", "trap", "arguments", "defined", "expected", "tolerance", "also")


def json_text(vectors: Sequence[ConformanceVector], seed: int) -> str:
    """All vectors, a line each, with what describes the functions."""
    functions = {
        name: {"slide": found.slide, "arguments": list(found.numbers), "result": found.result}
        for name, found in SIGNATURES.items()
    }
    head = {"format": FORMAT, "seed": seed, "digits": DIGITS, "outcomes": list(OUTCOMES), "functions": functions}
    opening = json.dumps(head, indent=1).removesuffix("\n}")
    lines = ",\n".join([f"  {json.dumps(_record(vector))}" for vector in vectors])
    return f'{opening},\n "vectors": [\n{lines}\n ]\n}}\n'


def csv_text(vectors: Sequence[ConformanceVector]) -> str:
    """All vectors, a row each.

    Numbers are separated by spaces, "none" is no contact, and `also` is topic=result; topic=result.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for vector in vectors:
        record = _record(vector)
        also = "; ".join([f"{topic}={_cell(result)}" for topic, result in vector.also.items()])
        expected = _cell(vector.expected) if vector.defined else ""
        arguments = " ".join([repr(number) for number in vector.arguments])
        writer.writerow(
            [
                record["id"],
                vector.function,
                record["slide"],
                vector.trap,
                arguments,
                _cell(vector.defined),
                expected,
                vector.tolerance,
                also,
            ]
        )
    return text.getvalue()


def _record(vector: ConformanceVector) -> dict[str, object]:
    """A vector as JSON has it."""
    record: dict[str, object] = {
        "id": vector.name,
        "function": vector.function,
        "slide": SIGNATURES[vector.function].slide,
        "trap": vector.trap,
        "arguments": list(vector.arguments),
        "defined": vector.defined,
        "expected": vector.expected,
        "tolerance": vector.tolerance,
    }
    return record | ({"also": dict(vector.also)} if vector.also else {})


def _cell(result: Result) -> str:
    """A result in one cell."""
    if result is None:
        return "none"
    if isinstance(result, bool):
        return "true" if result else "false"
    if isinstance(result, list):
        return " ".join([repr(number) for number in result])
    return result if isinstance(result, str) else repr(result)
