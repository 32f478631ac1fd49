"""A job that has no result."""

from typing import NamedTuple


class Lost(NamedTuple):
    """A job whose process died twice, took too long, or that raised an exception.

    why: in words. error: the exception.
    """

    why: str
    error: Exception | None = None


def raised(error: Exception) -> Lost:
    """The job that raised an exception."""
    return Lost(f"{type(error).__name__}: {error}", error)
