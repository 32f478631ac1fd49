"""A few words that say, for a moment, what a key has just changed. `game.picture.toast` shows them."""

from typing import NamedTuple

_SECONDS = 1.4


class Toast(NamedTuple):
    """What was changed.

    text: in words.
    level: how full a bar behind them is, 0 to 1; None for no bar.
    left: seconds that it is still shown.
    """

    text: str
    level: float | None = None
    left: float = _SECONDS


def later(toast: Toast | None, seconds: float) -> Toast | None:
    """The toast some time later; None once it has been shown for its time."""
    if toast is None or toast.left <= seconds:
        return None
    return toast._replace(left=toast.left - max(seconds, 0.0))
