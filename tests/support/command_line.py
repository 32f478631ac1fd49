"""The game's command line, run in the tests' own process."""

from game.commands import app
from game.system.command_line import run


def polar(capsys, *arguments):
    """Exit code, stdout and stderr of one run of the command line."""
    code = run(app, "polar-breakout", [str(argument) for argument in arguments])
    out, err = capsys.readouterr()
    return code, out, err
