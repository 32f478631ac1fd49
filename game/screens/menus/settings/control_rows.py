"""The settings of the controls: a row for every action, with two keys and a gamepad's button."""

from collections.abc import Callable

from game.input.action_names import action_groups
from game.input.actions import DEFAULT_KEYS, Action
from game.input.key_choice import CaptureTarget, wanted
from game.language import tr
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.menus.settings.key_capture import KeyCapture
from game.screens.toolkit.items.basic import ButtonItem, Heading, Item, TableRow
from game.screens.toolkit.layout import Row

WIDE_TEXT = 1.3
"""Above so many times its usual size text has no room for columns."""
_KEY_SHARE = 0.62
"""Of the width of an action's name."""


def control_rows(state: AppState, panel: Screen) -> tuple[Row, ...]:
    """All rows of the tab, grouped by purpose."""
    rows: list[Row] = [(ButtonItem(tr("Reset all keys and buttons"), _reset(state, panel), centred=True),)]
    for title, actions in action_groups():
        rows.append((Heading(title, "" if len(rows) > 1 else tr("keys, gamepad")),))
        for action, name in actions.items():
            label: Item = TableRow(((name, 1.0, "left"),))
            keys = _keys(state, panel, action, name)
            rows += [(label,), keys] if state.text_scale > WIDE_TEXT else [(label, *keys)]
    return tuple(rows)


def _keys(state: AppState, panel: Screen, action: Action, name: str) -> Row:
    """The row of an action: two keys and a button; each opens the question for another one. name: of the action."""
    tip = tr("Enter: choose another key. Pressing the same one again removes it.")
    return tuple(
        [
            ButtonItem(one.shown, _capture(state, panel, one), tip=tip, centred=True, share=_KEY_SHARE)
            for one in wanted(action, name)
        ]
    )


def _capture(state: AppState, panel: Screen, asked: CaptureTarget) -> Callable[[], Screen | None]:
    """A function that opens the question for a key."""
    return lambda: KeyCapture(state, panel, asked)


def _reset(state: AppState, panel: Screen) -> Callable[[], Screen | None]:
    """A function that restores the default keys."""

    def done() -> Screen | None:
        state.change(state.settings._replace(own_keys=DEFAULT_KEYS))
        return panel

    return done
