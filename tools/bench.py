"""`python -m tools.bench`: the cost of a tick beside pymunk's (tools/measure/tick.py)."""

from game.system.start import prepare


def main() -> None:
    """Run the command line and exit."""
    prepare("python -m tools.bench")
    from tools.measure.tick import main as bench  # noqa: PLC0415  # takes time to load, in which a signal may come

    bench()


if __name__ == "__main__":
    main()
