"""The pymunk harness: `polar-crosscheck`, or `python -m tools.crosscheck`."""

import sys

from game.system.start import prepare

PROGRAM = "polar-crosscheck"


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    from game.system.command_line import run  # noqa: PLC0415
    from tools.crosscheck.commands import app  # noqa: PLC0415  # takes time to load, in which a signal may come

    sys.exit(run(app, PROGRAM))


if __name__ == "__main__":
    main()
