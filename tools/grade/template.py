"""The file that a student begins with, written where he wants it."""

from pathlib import Path

from game.student.template import TEMPLATE
from game.system.errors import BadInputError
from game.system.files import write_text
from game.system.output import print_line


def write_template(path: Path) -> None:
    """Write the file, and say what to do with it; BadInputError where there is one already, or none can be written."""
    if path.exists():
        raise BadInputError(f"--template {path}: there is such a file already")
    write_text(path, TEMPLATE)
    print_line(f"written: {path}; its first lines say how it is graded, seen and flown")
