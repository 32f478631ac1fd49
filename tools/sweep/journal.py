"""What a sweep has done so far, row by row beside its table, so that it can go on where it was stopped or killed."""

import json
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TextIO

from game.system.errors import BadInputError
from game.system.wording import quoted_path
from tools.sweep.plan import Plan
from tools.sweep.play import Row


class Journal:
    """The rows of a plan, in the order of its games, in a file beside the table: its name and `.journal`."""

    def __init__(self, table: Path, plan: Plan) -> None:
        """Nothing is read or written yet."""
        self._path, self._head = table.with_name(f"{table.name}.journal"), plan.key()

    def rows(self) -> list[Row]:
        """The rows of an earlier run of the same plan, up to a line that was cut off; BadInputError where there are none."""
        try:
            head, *lines = self._path.read_text(encoding="utf-8").splitlines()
        except FileNotFoundError:
            raise BadInputError(f"--resume: there is no {quoted_path(self._path)}; nothing was stopped") from None
        except (OSError, ValueError) as error:
            raise BadInputError(f"--resume: {quoted_path(self._path)}: cannot be read; {error}") from None
        if head != self._head:
            raise BadInputError(f"--resume: {quoted_path(self._path)} is of other games; repeat the options of its run")
        rows = []
        with suppress(ValueError):
            for line in lines:
                rows.append(Row(*json.loads(line)))  # noqa: PERF401  # up to the first that is none
        return rows

    @contextmanager
    def written(self, known: list[Row]) -> Iterator[TextIO]:
        """The file, with the known rows in it; `add` adds one."""
        try:
            with self._path.open("w", encoding="utf-8") as file:
                file.write(f"{self._head}\n")
                for row in known:
                    add(file, row)
                yield file
        except OSError as error:
            raise BadInputError(f"{quoted_path(self._path)}: cannot be written; {error.strerror or error}") from None

    def remove(self) -> None:
        """The sweep is done."""
        self._path.unlink(missing_ok=True)


def add(file: TextIO, row: Row) -> None:
    """Add a row, at once."""
    file.write(json.dumps(row) + "\n")
    file.flush()
