"""The player's keys and buttons in the settings' file: by action, lists of numbers."""

from typing import Any

from game.input.actions import Action, Choice, OwnKeys

_LARGEST = 511
"""Of scancodes and buttons."""


def encoded_keys(own: OwnKeys) -> dict[str, dict[str, list[int]]]:
    """As the file has them."""
    return {kind: {action.name.lower(): list(controls) for action, controls in one} for kind, one in own._asdict().items()}


def decoded_keys(stored: Any) -> OwnKeys:
    """As they are in a file, without what makes no sense; whether they leave what must stay is seen when they are applied."""
    if not isinstance(stored, dict):
        return OwnKeys()
    return OwnKeys(_choices(stored.get("keys")), _choices(stored.get("buttons")))


def _choices(stored: Any) -> tuple[Choice, ...]:
    """Choices by action, in the order of actions."""
    if not isinstance(stored, dict):
        return ()
    found = []
    for action in Action:
        controls = stored.get(action.name.lower())
        if isinstance(controls, list) and all([type(one) is int and 0 <= one <= _LARGEST for one in controls]):
            found.append((action, tuple(controls)))
    return tuple(found)
