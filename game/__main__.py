"""The command `polar-breakout`, or `python -m game`."""

import sys

from game.system.start import prepare

PROGRAM = "polar-breakout"


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    # Imported after `prepare`, so that Ctrl+C during the slow load is handled.
    from game.commands import app  # noqa: PLC0415
    from game.system.command_line import run  # noqa: PLC0415

    sys.exit(run(app, PROGRAM))


if __name__ == "__main__":
    main()
