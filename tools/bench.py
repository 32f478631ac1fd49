"""`python -m tools.bench`: the cost of a tick beside pymunk's (tools/measure/tick.py)."""

from tools.measure.tick import main

if __name__ == "__main__":
    main()
