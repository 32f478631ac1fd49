"""Saved cases: share lines, one a line, that `pytest` opens and whose claims it asserts.

In a checkout they are in `tests/lab_cases.txt`; else in the user's data folder.
"""

from pathlib import Path

import platformdirs

import game
from game.system.errors import BadInputError
from game.system.wording import quoted_path

_CHECKOUT = Path(game.__file__).parent.parent / "tests" / "lab_cases.txt"
_COMMENT = "#"


def case_file() -> Path:
    """Where cases are saved."""
    if _CHECKOUT.exists():
        return _CHECKOUT
    return platformdirs.user_data_path("polar-breakout", appauthor=False) / "lab-cases.txt"


def saved_cases(path: Path) -> list[str]:
    """The lines of a file of cases; none where there is no file."""
    if not path.exists():
        return []
    lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
    return [line for line in lines if line and not line.startswith(_COMMENT)]


def save_case(line: str, path: Path) -> str:
    """Append a line to the cases, unless it is there; returns a sentence that says so. BadInputError on a failure to write."""
    try:
        if line in saved_cases(path):
            return f"already in {path}"
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as file:
            file.write(f"{line}\n")
    except (OSError, ValueError) as error:  # ValueError: what is there already is not UTF-8
        reason = getattr(error, "strerror", None) or error
        raise BadInputError(f"lab: case not saved: {quoted_path(path)}: {reason}") from None
    return f"saved in {path}"
