"""The simplest wrong answer of each function as a picture of the lab, drawn by the lab's own command line."""

import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

from game.system.errors import BadInputError
from game.system.wording import quoted_path
from tools.grade.findings import FunctionFindings

_ROOT = Path(__file__).resolve().parents[2]
"""The folder in which the packages are found."""
_SIZE = "1280x800"


def drawn(findings: Mapping[str, FunctionFindings], folder: Path, file: Path | None) -> Iterator[Path]:
    """A PNG file for each wrong function that the lab can show, named after it.

    file: the Python file that was graded, whose answer is shown beside ours; None for a program in another language.
    BadInputError where the folder cannot be made, or a picture not be drawn.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadInputError(f"--pictures {quoted_path(folder)}: cannot be made; {error.strerror}") from None
    for name, found in findings.items():
        if found.lab_line is None:
            continue
        path = (folder / f"{name}.png").resolve()
        command = [sys.executable, "-m", "game", "lab", found.lab_line, "--screenshot", str(path), "--size", _SIZE]
        command += [] if file is None else ["--with", str(file)]
        done = subprocess.run(command, cwd=_ROOT, capture_output=True, text=True, check=False)  # noqa: S603  # our own
        if done.returncode != 0:
            raise BadInputError(f"--pictures {quoted_path(path)}: {done.stderr.strip()}")
        yield path
