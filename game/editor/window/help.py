"""The editor's help: what keys, mouse and gamepad do; and the line that says how to go on."""

from enum import Enum, auto

from game.input.key_names import button_names
from game.input.keys import Action
from game.language import tr, tr_noop
from game.screens.toolkit.focus import Focus
from game.screens.toolkit.items import Cells, Item, TextItem
from game.screens.toolkit.layout import Content, Row
from game.screens.toolkit.menu import back_row
from game.screens.toolkit.panel import Panel


class Hand(Enum):
    """What the player used last."""

    KEYS = auto()
    MOUSE = auto()
    PAD = auto()


KEYS = (
    (tr_noop("Left, right"), tr_noop("move the cursor along the ring; hold Space meanwhile to paint on")),
    (tr_noop("Up, down"), tr_noop("move it to the next ring outward or inward")),
    (tr_noop("Space or Enter"), tr_noop("paint bricks with the brush")),
    (tr_noop("Backspace"), tr_noop("take bricks away")),
    ("1-9, 0, -", tr_noop("brush: layers of a stack, a gap, unbreakable")),
    ("P", tr_noop("brush: what is under the cursor")),
    ("Ctrl+C, Ctrl+V", tr_noop("copy the ring's bricks, paste them; both from the cursor on")),
    ("R, M", tr_noop("repeat a stroke around the ring; mirror it")),
    ("F", tr_noop("fill the chosen ring with the brush")),
    ("C or Ins, Del", tr_noop("copy the chosen ring outward; remove it")),
    (tr_noop("Page up, Page down"), tr_noop("choose the next ring outward or inward")),
    ("Tab", tr_noop("between the arena and the panel")),
    (tr_noop("In the panel"), tr_noop("up, down: choose; left, right: change, with Shift ten steps at once")),
    (tr_noop("Enter there"), tr_noop("type a number, Enter again takes it over; or press a button")),
    ("Ctrl+Z, Ctrl+Y", tr_noop("undo, redo")),
    ("F5", tr_noop("play the level; Esc there comes back")),
    ("Ctrl+S", tr_noop("save; comments in the file stay")),
    ("Esc", tr_noop("leave; asks where changes are not saved")),
)
"""Keys, and what they do."""
MOUSE = (
    (tr_noop("Left button"), tr_noop("paint bricks with the brush, also by dragging")),
    (tr_noop("Right button"), tr_noop("take bricks away")),
    (tr_noop("Wheel"), tr_noop("over the arena: the brush; over a number: the number")),
    (tr_noop("Click on a number"), tr_noop("type it; + and - beside it change it")),
    (tr_noop("Click on a button"), tr_noop("what it says")),
)
"""What the mouse does."""
_NOTE = tr_noop("A file that is changed in a text editor is taken over at once, and can be undone.")


def pad_lines() -> tuple[tuple[str, str], ...]:
    """What a gamepad does, by the names of the buttons that the player has chosen."""
    return (
        (tr("D-pad, left stick"), tr("move the cursor: left, right along the ring; up, down across rings")),
        (button_names(Action.SERVE), tr("paint bricks with the brush; hold it and move to paint on")),
        (button_names(Action.GIVE_UP), tr("take bricks away")),
        (button_names(Action.STEP_BACK, Action.STEP), tr("another brush; in the panel ten steps of a number")),
        (button_names(Action.TIP), tr("between the arena and the panel")),
        (tr("In the panel"), tr("up, down: choose; left, right: change; the buttons copy, paste, undo, save")),
        (button_names(Action.PAUSE), tr("play the level")),
        (button_names(Action.HELP), tr("this help")),
        (button_names(Action.BACK), tr("from the panel to the arena; from there leave")),
    )


def hint(hand: Hand, *, in_panel: bool) -> str:
    """How to go on, for who uses keys, mouse or gamepad."""
    if hand is Hand.MOUSE:
        return tr("Left button: paint; right button: take away; wheel: brush. Click a number to type it.")
    if hand is Hand.KEYS and in_panel:
        return tr("Up, down: choose; left, right: change; Enter: type or press; Tab: to the arena.")
    if hand is Hand.KEYS:
        return tr("Arrows: move; Space: paint; Backspace: take away; Tab: to the panel; F1: help.")
    other, paint, remove = (button_names(action) for action in (Action.TIP, Action.SERVE, Action.GIVE_UP))
    if in_panel:
        return tr("Up, down: choose; left, right: change; {press}: press; {other}: to the arena.").format(
            press=paint, other=other
        )
    words = tr("{paint}: paint; {remove}: take away; {other}: to the panel; {help}: help.")
    return words.format(paint=paint, remove=remove, other=other, help=button_names(Action.HELP))


class EditorHelp(Panel):
    """A panel with a part for each of keys, mouse and gamepad."""

    def content(self) -> Content:
        """The part that is shown."""
        lines = (_translated(KEYS), _translated(MOUSE), pad_lines())[self._tab]
        rows: list[Row] = [(Cells(((names, 1.0, "left"), (meaning, 2.6, "left"))),) for names, meaning in lines]
        rows += [(Item(),), (TextItem(tr(_NOTE), 1.0, faint=True),)]
        names = (tr("Keys"), tr("Mouse"), tr("Gamepad"))
        return Content(tr("The editor"), tuple(rows), back_row(tr("Back"), self.back), names, self._tab, 44.0)

    def first(self) -> Focus | None:
        """The button that closes it."""
        return Focus(len(self.content().body), 1)


def _translated(lines: tuple[tuple[str, str], ...]) -> tuple[tuple[str, str], ...]:
    """Lines in the player's language."""
    return tuple([(tr(names), tr(meaning)) for names, meaning in lines])
