"""`python -m tools.translations`: the translations beside the texts in the code (check.py)."""

from game.system.start import prepare


def main() -> None:
    """Run the command line and exit."""
    prepare("python -m tools.translations")
    # Imported after `prepare`, so that Ctrl+C during the slow load is handled.
    from game.system.command_line import run  # noqa: PLC0415
    from tools.translations.check import app  # noqa: PLC0415

    raise SystemExit(run(app, "python -m tools.translations"))


if __name__ == "__main__":
    main()
