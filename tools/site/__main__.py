"""The command `python -m tools.site`."""

import sys

from game.system.start import prepare

PROGRAM = "python -m tools.site"


def main() -> None:
    """Run the command line and exit."""
    prepare(PROGRAM)
    # Imported after `prepare`, so that Ctrl+C during the slow load is handled.
    from game.system.command_line import run  # noqa: PLC0415
    from tools.site.commands import app  # noqa: PLC0415

    sys.exit(run(app, PROGRAM))


if __name__ == "__main__":
    main()
