"""Run a typer application so that every failure is one line on stderr and an exit code."""

from collections.abc import Callable
from functools import partial
from typing import Any

import typer
from typer.exceptions import TyperException
from typer.main import get_command

from game.system import ending
from game.system.errors import BadInputError, CheckFailedError, DisplayLostError, EnvironmentMissingError
from game.system.output import output_problem, print_error
from game.system.wording import quoted_message

_INTERRUPTED = 130
"""What commands return that were interrupted and have told so far what they had."""
_NO_OUTPUT = 3
_PYDANTIC = "Value error, "
"""What pydantic, which reads the options, writes before a message."""
_EXIT_CODES = {BadInputError: 2, CheckFailedError: 1, EnvironmentMissingError: 3, DisplayLostError: 3}


def run(app: typer.Typer, program: str, arguments: list[str] | None = None) -> int:
    """Run an application; its exit code.

    0 fine, 1 a check failed, 2 bad input, 3 the machine lacks something, or what was printed could not be written,
    128 + the signal's number when a signal ended it: 130 for Ctrl-C, 143 for SIGTERM, 129 for SIGHUP.
    arguments: those of the process unless given.
    """
    try:
        code = _code(app, program, arguments)
    except _Interrupted:
        code = _INTERRUPTED
    if code == _INTERRUPTED:
        print_error(f"{program}: {ending.signal_words()}")
        code = ending.exit_code()
    why = output_problem()
    if why is not None:
        print_error(f"{program}: cannot write output; {why}")
    return code or (0 if why is None else _NO_OUTPUT)


def _code(app: typer.Typer, program: str, arguments: list[str] | None) -> int:
    """The exit code, after one line about what went wrong."""
    command = get_command(app)
    command.invoke = partial(_invoked, command.invoke)  # type: ignore[method-assign]
    try:
        code = command.main(args=arguments, prog_name=program, standalone_mode=False)
    except TyperException as error:
        message = error.format_message().replace(_PYDANTIC, "", 1)
        print_error(f"{program}: {quoted_message(message)} (--help lists the options)")
        return 2
    except tuple(_EXIT_CODES) as error:
        print_error(f"{program}: {error}")
        return _EXIT_CODES[type(error)]
    return code if isinstance(code, int) else 0


class _Interrupted(BaseException):
    """KeyboardInterrupt by another name: typer makes an empty line of that."""


def _invoked(invoke: Callable[[typer.Context], Any], context: typer.Context) -> Any:
    """What a command answers, once its options are read. Signals interrupt it; before and after it they end the program."""
    try:
        with ending.working():
            return invoke(context)
    except KeyboardInterrupt:
        raise _Interrupted from None


def refuse_ignored(context: typer.Context, reason: str, *names: str) -> None:
    """Raise BadInputError for the first of some options that was given, as it would do nothing.

    names: of the command's parameters. reason: what the option needs, or what excludes it.
    """
    for parameter in context.command.params:
        source = context.get_parameter_source(parameter.name or "")
        if parameter.name in names and source is not None and source.name == "COMMANDLINE":
            raise BadInputError(f"{max(parameter.opts, key=len)}: {reason}")
