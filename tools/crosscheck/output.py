"""What the command prints: one text, at its end. A closed or full standard output is one line then, and no traceback."""

import io
import os
import sys
from typing import Any

from rich.console import Console

from game.system.errors import EnvironmentMissingError

_PLAIN_WIDTH = 80


def check_output() -> None:
    """Raise EnvironmentMissingError, before any work starts, where there is no standard output."""
    if sys.stdout is None:
        raise EnvironmentMissingError("the standard output is closed; send it to a file, or to /dev/null")


def text_console() -> tuple[Console, io.StringIO]:
    """A console as wide and as colourful as the terminal, and the text that it writes into."""
    real = Console()
    text = io.StringIO()
    width = real.width if real.is_terminal else _PLAIN_WIDTH
    colours: Any = real.color_system if real.is_terminal else None
    return Console(file=text, width=width, force_terminal=real.is_terminal, color_system=colours), text


def emit(text: str) -> None:
    """Print a text. A reader that has gone away misses it; EnvironmentMissingError where it cannot be written."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        _silence()
    except OSError as error:
        _silence()
        raise EnvironmentMissingError(f"cannot write to the standard output; {error.strerror}") from None


def _silence() -> None:
    """Let nothing more be written: Python would try again at its end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
