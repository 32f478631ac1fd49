"""The first thing every command does, before anything that takes time to load. Imports the standard library only."""

from game.system.ending import watch_signals
from game.system.output import open_output


def prepare(program: str) -> None:
    """Make ready for whatever happens to this process. program: its name in messages.

    From here on its output cannot fail, and a signal ends it with one line: also Ctrl-C while libraries are loaded.
    """
    watch_signals(program)
    open_output()
