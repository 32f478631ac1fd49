"""Keys and buttons that the player gives to actions: what they take from others, and what cannot be taken.

What is chosen is a physical key, whatever is written on it. Enter and Esc, and on a gamepad A and B, always accept and go back;
directions keep at least one key and one button: nobody locks themselves out of the menus.
"""

from collections.abc import Mapping
from typing import NamedTuple

from game.input.actions import Action, Choice, OwnKeys
from game.input.keys import BINDINGS, Binding, PadButton
from game.input.scancodes import SCANCODES, position_of

FIXED_KEYS: Mapping[int, Action] = {
    SCANCODES["Enter"]: Action.CONFIRM,
    SCANCODES["NumpadEnter"]: Action.CONFIRM,
    SCANCODES["Escape"]: Action.BACK,
}
"""Keys that always mean the same."""
FIXED_BUTTONS: Mapping[int, Action] = {PadButton.A: Action.SERVE, PadButton.B: Action.BACK}
NEEDED = frozenset({Action.LEFT, Action.RIGHT, Action.UP, Action.DOWN})
"""Actions that never lose their last key, nor their last button."""
MOST_POSITIONS = 512
"""Scancodes are below this."""
MOST_BUTTONS = 32
"""Gamepads' buttons are below this."""

Controls = Mapping[Action, tuple[int, ...]]
"""Keys, or buttons, of actions: the usual one first."""


class Rebound(NamedTuple):
    """What giving a key to an action did. controls: of the actions that changed. taken_from: who had the key before."""

    controls: Controls
    taken_from: Action | None


class Refused(Exception):  # noqa: N818  # the answer to a wish, not an error
    """A key cannot be given away. control: the key, or the button. action: whose it stays."""

    def __init__(self, control: int, action: Action, *, fixed: bool) -> None:
        """fixed: it always means that; else it is the last key of an action that needs one."""
        super().__init__(action.name)
        self.control, self.action, self.fixed = control, action, fixed


def rebound(in_use: Controls, fixed: Mapping[int, Action], action: Action, slot: int, control: int) -> Rebound:
    """Give a key or button to an action.

    in_use: what actions have now. fixed: what cannot be changed. slot: index of the key that it replaces; beyond the last, it
    is one more. control: the new key. Raises Refused.
    """
    if fixed.get(control, action) is not action:
        raise Refused(control, fixed[control], fixed=True)
    own = list(in_use.get(action, ()))
    replaced = own[slot] if slot < len(own) else None
    if replaced is not None and replaced in fixed and replaced != control:
        raise Refused(replaced, action, fixed=True)
    if control in own:  # it changes its position among them
        other = own.index(control)
        if replaced is not None:
            own[slot], own[other] = own[other], own[slot]
        return Rebound({action: tuple(own)}, None)
    own[slot : slot + 1] = [control]
    loser = next((one for one, controls in in_use.items() if control in controls), None)
    if loser is None:
        return Rebound({action: tuple(own)}, None)
    left = tuple([one for one in in_use[loser] if one != control])
    if not left and loser in NEEDED:
        raise Refused(control, loser, fixed=False)
    return Rebound({action: tuple(own), loser: left}, loser)


def cleared(in_use: Controls, fixed: Mapping[int, Action], action: Action, slot: int) -> Controls:
    """Take a key or button away from an action; nothing changes where it has none in that slot. Raises Refused."""
    own = list(in_use.get(action, ()))
    if slot >= len(own):
        return {}
    if own[slot] in fixed:
        raise Refused(own[slot], action, fixed=True)
    if len(own) == 1 and action in NEEDED:
        raise Refused(own[slot], action, fixed=False)
    del own[slot]
    return {action: tuple(own)}


def with_keys(own: OwnKeys, changed: Controls) -> OwnKeys:
    """The choices with other keys for some actions."""
    return own._replace(keys=_merged(own.keys, changed))


def with_buttons(own: OwnKeys, changed: Controls) -> OwnKeys:
    """The choices with other buttons for some actions."""
    return own._replace(buttons=_merged(own.buttons, changed))


def bindings(own: OwnKeys) -> tuple[Binding, ...]:
    """The bindings that hold with the player's choices; a key that is chosen for one action is no other's any more."""
    keys, buttons = dict(own.keys), dict(own.buttons)
    taken_keys, taken_buttons = _all(own.keys), _all(own.buttons)
    found = []
    for default in BINDINGS:
        one = default
        if one.action in keys:
            one = one._replace(codes=(), positions=keys[one.action])
        else:
            one = one._replace(positions=tuple([key for key in one.positions if key not in taken_keys]))
        free = tuple([button for button in one.buttons if button not in taken_buttons])
        found.append(one._replace(buttons=buttons.get(one.action, free)))
    return tuple(found)


def checked(own: OwnKeys) -> OwnKeys:
    """The choices as they can be; none where they would take away what must stay. own: read from a file, of any content."""
    keys = {one.action: (*one.positions, *[position_of(code) for code in one.codes]) for one in BINDINGS}
    buttons = {one.action: one.buttons for one in BINDINGS}
    return OwnKeys(
        _merged((), dict(own.keys)) if _is_sound(own.keys, keys, FIXED_KEYS, range(1, MOST_POSITIONS)) else (),
        _merged((), dict(own.buttons)) if _is_sound(own.buttons, buttons, FIXED_BUTTONS, range(MOST_BUTTONS)) else (),
    )


def _is_sound(chosen: tuple[Choice, ...], default: Controls, fixed: Mapping[int, Action], known: range) -> bool:
    """Whether choices leave what must stay. default: what actions have of themselves. known: the controls that there are."""
    controls = dict(chosen)
    flat = [control for one in controls.values() for control in one]
    if len(flat) != len(set(flat)) or not all([control in known for control in flat]):
        return False
    whose = {control: action for action, own in controls.items() for control in own}
    if any([whose.get(control, action) is not action for control, action in fixed.items()]):
        return False
    if any([action in controls and control not in controls[action] for control, action in fixed.items()]):
        return False
    left = {action: set(default[action]) - set(flat) for action in NEEDED if action not in controls}
    return all([controls[action] if action in controls else left[action] for action in NEEDED])


def _merged(own: tuple[Choice, ...], changed: Controls) -> tuple[Choice, ...]:
    """Choices with others in their place, in the order of actions: the same choices are the same value."""
    return tuple(sorted((dict(own) | dict(changed)).items(), key=lambda choice: choice[0].value))


def _all(chosen: tuple[Choice, ...]) -> frozenset[int]:
    """Every key, or button, that was chosen for anything."""
    return frozenset([control for _, controls in chosen for control in controls])
