"""A key or a button that the player gives to an action: the question, and what the answer changes."""

from typing import NamedTuple

from game.input.action_names import action_names
from game.input.actions import Action, OwnKeys
from game.input.key_names import NO_KEY, button_name, position_name, positions_in_use
from game.input.keys import KEYS
from game.input.rebinding import FIXED_BUTTONS, FIXED_KEYS, Refused, cleared, rebound, with_buttons, with_keys
from game.language import tr

SLOTS = 2
"""Keys of an action that are shown."""


class CaptureTarget(NamedTuple):
    """What is asked for. name: of the action, in the player's language. slot: index of the key. of_pad: a gamepad's button."""

    action: Action
    name: str
    slot: int
    of_pad: bool

    @property
    def shown(self) -> str:
        """What the action has there now."""
        controls = KEYS.binding(self.action).buttons if self.of_pad else positions_in_use(self.action)
        if self.slot >= len(controls):
            return NO_KEY
        return button_name(controls[self.slot]) if self.of_pad else position_name(controls[self.slot])


def wanted(action: Action, name: str) -> tuple[CaptureTarget, ...]:
    """What can be asked for an action: its keys, and its button. name: what the action is called."""
    keys = [CaptureTarget(action, name, slot, of_pad=False) for slot in range(SLOTS)]
    return *keys, CaptureTarget(action, name, 0, of_pad=True)


def question(asked: CaptureTarget) -> tuple[str, str]:
    """What to do, and how to leave it."""
    words = tr("Press a button of the gamepad.") if asked.of_pad else tr("Press a key.")
    return words, tr("Esc, or B on a gamepad: change nothing.")


def given(own: OwnKeys, asked: CaptureTarget, control: int) -> tuple[OwnKeys, str]:
    """The choices with a key or a button given to what was asked for, and what that did, in words.

    control: the key's position, or the button. The choices stay where it is refused.
    """
    in_use = {action: KEYS.binding(action).buttons if asked.of_pad else positions_in_use(action) for action in Action}
    fixed = FIXED_BUTTONS if asked.of_pad else FIXED_KEYS
    mine = in_use[asked.action]
    try:
        if asked.slot < len(mine) and mine[asked.slot] == control:
            changed, words = cleared(in_use, fixed, asked.action, asked.slot), tr("{action}: key removed")
            taken = None
        else:
            changed, taken = rebound(in_use, fixed, asked.action, asked.slot, control)
            words = tr("{action}: {key}") if taken is None else tr("{action}: {key}, no longer {other}")
    except Refused as refused:
        control, taken = refused.control, refused.action
        changed = {}
        words = tr("{key} is reserved: {other}") if refused.fixed else tr("{key} stays: {other} has no other key")
    name = button_name(control) if asked.of_pad else position_name(control)
    other = "" if taken is None else action_names()[taken]
    with_them = with_buttons if asked.of_pad else with_keys
    return with_them(own, changed), words.format(action=asked.name, key=name, other=other)
