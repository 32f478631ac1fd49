"""Run a typer application so that every failure is one line on stderr and an exit code."""

import os
import sys

import typer
from typer.exceptions import TyperException

from game.system.errors import BadInputError, CheckFailedError, DisplayLostError, EnvironmentMissingError

_INTERRUPTED = 130
_EXIT_CODES = {BadInputError: 2, CheckFailedError: 1, EnvironmentMissingError: 3, DisplayLostError: 3}


def run(app: typer.Typer, program: str, arguments: list[str] | None = None) -> int:
    """Exit code of the application: 0 fine, 1 a check failed, 2 bad input, 3 the machine lacks something, 130 Ctrl-C.

    arguments: those of the process unless given.
    """
    try:
        code = app(args=arguments, prog_name=program, standalone_mode=False)
        sys.stdout.flush()
    except TyperException as error:
        say(f"{program}: {error.format_message().replace(chr(10), ' ')} (--help lists the options)")
        return 2
    except tuple(_EXIT_CODES) as error:
        say(f"{program}: {error}")
        return _EXIT_CODES[type(error)]
    except (KeyboardInterrupt, typer.Abort):
        code = _INTERRUPTED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    if code == _INTERRUPTED:  # typer, too, reports Ctrl-C so
        say(f"{program}: interrupted")
    return code if isinstance(code, int) else 0


def say(line: str) -> None:
    """One line on stderr, whatever characters a path may hold."""
    print(line.encode(errors="backslashreplace").decode(), file=sys.stderr)
