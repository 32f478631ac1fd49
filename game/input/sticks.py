"""What the sticks and triggers of a gamepad mean. Needs no pygame."""

_PUSHED, _LET_GO = 0.6, 0.4
"""Shares of a stick's reach: it means something from the first on, until it is below the second."""
_SLACK = 0.08
"""Share of a trigger's travel that does nothing: few triggers come back to 0."""


def is_pushed(offset: complex, *, before: bool) -> bool:
    """Whether a stick is pushed far enough to mean something. offset: in shares of its reach. before: whether it was."""
    return abs(offset) >= (_LET_GO if before else _PUSHED)


def beyond_slack(travel: float) -> float:
    """How far a trigger is pulled, 0 to 1, where the slack at the beginning of its travel counts as 0."""
    return max(travel - _SLACK, 0.0) / (1.0 - _SLACK)
