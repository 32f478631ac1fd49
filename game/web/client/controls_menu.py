"""The player's own keys and buttons on the page: a row for every action, as in the desktop's settings."""

from collections.abc import Callable, Iterable

from game.input.action_names import action_groups
from game.input.actions import DEFAULT_KEYS
from game.input.key_choice import CaptureTarget, given, question, wanted
from game.input.keys import PadButton
from game.input.scancodes import SCANCODES
from game.language import tr
from game.web.client.keys import BROWSERS_KEYS, BROWSERS_POSITIONS, NOT_ON_PAGES
from game.web.client.menu_screen import MenuScreen, Opened
from game.web.client.messages import PageItem
from game.web.client.state import PageScreen, PageState


def controls_menu(
    state: PageState, back: Callable[[], PageScreen], under: PageScreen | None = None, focus: str = ""
) -> MenuScreen:
    """Everything that can be pressed, by what it is for. focus: id of the control that has the keyboard at first."""

    def again(focus: str) -> MenuScreen:
        return controls_menu(state, back, under, focus)

    def contents(menu: MenuScreen) -> tuple[Iterable[str], Iterable[Opened]]:
        def reset(_value: str) -> PageScreen:
            state.change(state.settings._replace(own_keys=DEFAULT_KEYS))
            return menu

        items = [Opened(PageItem("reset", tr("Reset all keys and buttons")), reset)]
        for title, actions in action_groups():
            hint = tr("keys, gamepad") if len(items) == 1 else ""
            items.append(Opened(PageItem(f"heading-{len(items)}", title, "heading", hint=hint)))
            items += [
                _row(state, again, under, wanted(action, name))
                for action, name in actions.items()
                if action not in NOT_ON_PAGES
            ]
        tip = tr("Enter: choose another key. Pressing the same one again removes it.")
        return (tip, tr("Tab, Ctrl, Alt and F2 to F12 stay the browser's.")), items

    return MenuScreen(state, tr("Keys"), contents, back, under, focus=focus)


def _row(
    state: PageState, again: Callable[[str], MenuScreen], under: PageScreen | None, asked: tuple[CaptureTarget, ...]
) -> Opened:
    """An action's keys and its button; each leads to the question for another one. again: makes the menu anew."""
    name = asked[0].name
    spoken = [tr("{action}, gamepad") if one.of_pad else tr("{action}, key {number}") for one in asked]
    options = [
        (str(index), one.shown, f"{words.format(action=name, number=one.slot + 1)}: {one.shown}")
        for index, (one, words) in enumerate(zip(asked, spoken, strict=True))
    ]
    item = PageItem(f"key-{asked[0].action.name.lower()}", name, "buttons", options=tuple(options))

    def chosen(value: str) -> PageScreen:
        index = min(int(value), len(asked) - 1) if value.isascii() and value.isdecimal() else 0
        return KeyQuestion(state, asked[index], lambda: again(f"{item.id}-{index}"), under)

    return Opened(item, chosen)


class KeyQuestion(MenuScreen):
    """Waits for a key or a button. Esc, and B on a gamepad, lead back; so does the button."""

    def __init__(
        self, state: PageState, asked: CaptureTarget, back: Callable[[], PageScreen], under: PageScreen | None
    ) -> None:
        """asked: the key that is wanted. back: makes the screen that follows."""
        lines = question(asked)
        super().__init__(state, asked.name, lambda _menu: (lines, ()), back, under, uncaptured=BROWSERS_KEYS)
        self._asked, self._leave = asked, back
        state.announcements += lines

    def key(self, position: int) -> PageScreen:
        """The screen after a key was pressed."""
        if position == SCANCODES["Escape"]:
            return self._leave()
        return self if self._asked.of_pad or not position or position in BROWSERS_POSITIONS else self._give(position)

    def button(self, button: PadButton) -> PageScreen:
        """The screen after a gamepad's button was pressed."""
        if button == PadButton.B:
            return self._leave()
        return self._give(button) if self._asked.of_pad else self

    def _give(self, control: int) -> PageScreen:
        """Give the action its key, and say what that did."""
        settings = self.state.settings
        own_keys, words = given(settings.own_keys, self._asked, control)
        self.state.change(settings._replace(own_keys=own_keys))
        self.state.notifications.append(words)
        return self._leave()
