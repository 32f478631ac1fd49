"""A clock for tests that must not wait."""


class Clock:
    """Stands still until `now` is set."""

    now = 0.0

    def __call__(self):
        return self.now
