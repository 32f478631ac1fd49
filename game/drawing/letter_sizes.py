"""Sizes of letters that change from frame to frame."""


def stepped(size: float) -> float:
    """A size rounded to quarters, for words whose size changes from frame to frame: every size costs a font and a picture."""
    return round(4.0 * size) / 4.0
