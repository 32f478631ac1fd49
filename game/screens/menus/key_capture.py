"""The question for a key or a button: the next one that is pressed is given to an action."""

from typing import NamedTuple

import pygame

from game.input.action_names import action_names
from game.input.actions import Action, OwnKeys
from game.input.events import position_in
from game.input.key_names import button_name, position_name, positions_in_use
from game.input.keys import KEYS
from game.input.rebinding import FIXED_BUTTONS, FIXED_KEYS, Refused, cleared, rebound, with_buttons, with_keys
from game.language import tr
from game.overlay.toast import Toast
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.items import TextItem
from game.screens.toolkit.layout import Content
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel

_TOLD_SECONDS = 4.0


class Wanted(NamedTuple):
    """What is asked for. name: of the action, in the player's language. slot: index of the key. of_pad: a gamepad's button."""

    action: Action
    name: str
    slot: int
    of_pad: bool


class KeyCapture(Panel):
    """Waits for a key or a button. Esc, and B on a gamepad, lead back; so does a click."""

    def __init__(self, state: AppState, under: Screen, wanted: Wanted) -> None:
        """Open over the settings."""
        super().__init__(state, under)
        self._wanted = wanted
        self._answered = False

    def content(self) -> Content:
        """The question."""
        asked = tr("Press a button of the gamepad.") if self._wanted.of_pad else tr("Press a key.")
        lines = (asked, tr("Esc, or B on a gamepad: change nothing."))
        rows = tuple([(TextItem(line, 1.1, faint=index > 0, centred=True),) for index, line in enumerate(lines)])
        return Content(self._wanted.name, rows, back_row(tr("Back"), self.back), width=28.0, centred=True)

    def typed(self, event: pygame.Event) -> bool:
        """Take a key or a button before it means anything; whether the event is one."""
        if event.type not in (pygame.KEYDOWN, pygame.CONTROLLERBUTTONDOWN):
            return False
        if not self._answered:
            self._hear(event)
        return True

    def advance(self, seconds: float, size: tuple[int, int]) -> Screen | None:
        """Lead back once it is answered."""
        return self.back() if self._answered else super().advance(seconds, size)

    def _hear(self, event: pygame.Event) -> None:
        """A key or a button went down."""
        of_pad = event.type == pygame.CONTROLLERBUTTONDOWN
        control = int(event.button) if of_pad else position_in(event)
        leaves = control == (pygame.CONTROLLER_BUTTON_B if of_pad else pygame.KSCAN_ESCAPE)
        if leaves:
            self._answered = True
        elif of_pad is self._wanted.of_pad and (of_pad or control):
            self._give(control)

    def _give(self, control: int) -> None:
        """Give the action its key, and say what that did."""
        wanted, of_pad = self._wanted, self._wanted.of_pad
        in_use = _in_use(of_pad=of_pad)
        fixed = FIXED_BUTTONS if of_pad else FIXED_KEYS
        name = button_name(control) if of_pad else position_name(control)
        own = in_use[wanted.action]
        try:
            if wanted.slot < len(own) and own[wanted.slot] == control:
                changed, told = cleared(in_use, fixed, wanted.action, wanted.slot), tr("{action}: key removed")
                taken = None
            else:
                changed, taken = rebound(in_use, fixed, wanted.action, wanted.slot, control)
                told = tr("{action}: {key}") if taken is None else tr("{action}: {key}, no longer {other}")
        except Refused as refused:
            taken = refused.action
            always, last = tr("{key} is reserved: {other}"), tr("{key} stays: {other} has no other key")
            changed, told = {}, always if refused.fixed else last
        other = "" if taken is None else action_names()[taken]
        settings, with_them = self.state.settings, with_buttons if of_pad else with_keys
        own_keys: OwnKeys = with_them(settings.own_keys, changed)
        words = told.format(action=wanted.name, key=name, other=other)
        self.state.change(settings._replace(own_keys=own_keys), Toast(words, None, _TOLD_SECONDS))
        self._answered = True


def _in_use(*, of_pad: bool) -> dict[Action, tuple[int, ...]]:
    """What every action has now."""
    return {action: KEYS.binding(action).buttons if of_pad else positions_in_use(action) for action in Action}
