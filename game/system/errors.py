"""What the command line turns into one line on stderr and an exit code."""


class BadInputError(Exception):
    """A file or an option that cannot be used: exit code 2. The message names file, key and rule."""


class CheckFailedError(Exception):
    """A check that was asked for did not hold: exit code 1."""


class DisplayLostError(Exception):
    """The display went away in the middle of a game: exit code 3. The message says what became of the game."""


class EnvironmentMissingError(Exception):
    """The machine lacks what the command needs: exit code 3. The message says what to do instead."""
