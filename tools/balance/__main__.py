"""The levels' difficulty, measured: `python -m tools.balance`."""

import sys

from game.system.start import prepare

PROGRAM = "python -m tools.balance"


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    # Imported after `prepare`, so that Ctrl+C during the slow load is handled.
    from game.system.command_line import run  # noqa: PLC0415
    from tools.balance.commands import app  # noqa: PLC0415

    sys.exit(run(app, PROGRAM))


if __name__ == "__main__":
    main()
