"""`python -m tools.bench`: the cost of a tick beside pymunk's (tools/measure/tick.py)."""

from game.system.start import prepare


def main() -> None:
    """Run the command line and exit."""
    prepare("python -m tools.bench")
    # Imported after `prepare`, so that Ctrl+C during the slow load is handled.
    from tools.measure.tick import main as bench  # noqa: PLC0415

    bench()


if __name__ == "__main__":
    main()
