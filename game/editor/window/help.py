"""The editor's help: what keys, mouse and gamepad do; and the line that says how to go on."""

from enum import Enum, auto

from game.editor.fields import PanelPart
from game.input.key_names import button_names
from game.input.keys import Action
from game.language import tr, tr_noop
from game.screens.app_state import AppState
from game.screens.base import Screen
from game.screens.toolkit.key_help import HelpWords, KeyHelp, Lines


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
    ("1-9, 0, -", tr_noop("brush: layers of a stack, a gap, never breaks")),
    ("T", tr_noop("brush: another colour; with Shift the one before")),
    ("P", tr_noop("brush: what is under the cursor")),
    ("R, M", tr_noop("repeat a stroke around the ring; mirror it")),
    ("F", tr_noop("fill the chosen ring with the brush")),
    (tr_noop("Ctrl+C, Ctrl+V"), tr_noop("copy the ring's bricks, paste them; both from the cursor on")),
    (tr_noop("C, Ins; Del"), tr_noop("copy the chosen ring outward; remove it")),
    (
        tr_noop("In the part Wells"),
        tr_noop("arrows move the well, with Shift ten steps; Space, Ins: add; Backspace, Del: remove"),
    ),
    (
        tr_noop("Page up, Page down"),
        tr_noop("the next ring outward or inward, or another well; with Ctrl another part of the panel"),
    ),
    ("Tab, Esc", tr_noop("into the panel, and on in it; back to the arena")),
    (
        tr_noop("In the panel"),
        tr_noop("up, down: choose; left, right: change, with Shift ten steps at once; Page up, Page down: another part"),
    ),
    (tr_noop("Enter there"), tr_noop("type a number, Enter again takes it over; or press a button")),
    (tr_noop("Ctrl+Z, Ctrl+Y"), tr_noop("undo, redo")),
    ("F5", tr_noop("play the level; Esc there comes back")),
    (tr_noop("Ctrl+S"), tr_noop("save; comments in the file stay")),
    ("Esc", tr_noop("leave; asks where changes are not saved")),
)
"""Keys, and what they do."""
MOUSE = (
    (tr_noop("Left button"), tr_noop("paint bricks with the brush, also by dragging")),
    (tr_noop("Right button"), tr_noop("take bricks away")),
    (tr_noop("Wheel"), tr_noop("over the arena: the brush, or another ring or well; over the panel: scroll")),
    (tr_noop("In the part Ring"), tr_noop("click on a ring to choose it, drag it to change its radius")),
    (tr_noop("In the part Wells"), tr_noop("click to add a well, drag it; the right button removes it")),
    (tr_noop("Click on a number"), tr_noop("type it; the arrow heads beside it change it, held again and again")),
    (tr_noop("Click on a button"), tr_noop("what it says")),
    (tr_noop("Touch"), tr_noop("like the left button; a number is entered on a panel; the brush 0 takes away")),
)
"""What the mouse does."""
_NOTE = tr_noop("A file that is changed in a text editor is taken over at once, and can be undone.")


def pad_lines() -> Lines:
    """What a gamepad does, by the names of the buttons that the player has chosen."""
    panel = tr("up, down: choose; left, right: change; {press}: enter a number, press a button")
    return (
        (tr("D-pad, left stick"), tr("move the cursor: left, right along the ring; up, down across rings")),
        (button_names(Action.SERVE), tr("paint bricks with the brush; hold it and move to paint on")),
        (button_names(Action.GIVE_UP), tr("take bricks away")),
        (button_names(Action.STEP_BACK, Action.STEP), tr("another brush, ring or well; in the panel another part")),
        (tr("In the part Wells"), tr("the D-pad moves the well; the same buttons add one and remove it")),
        (button_names(Action.ZOOM_OUT, Action.ZOOM_IN), tr("undo, redo")),
        (button_names(Action.TIP), tr("between the arena and the panel")),
        (tr("In the panel"), panel.format(press=button_names(Action.SERVE))),
        (button_names(Action.PAUSE), tr("play the level")),
        (button_names(Action.HELP), tr("this help")),
        (button_names(Action.BACK), tr("from the panel to the arena; from there leave")),
    )


def hint(hand: Hand, part: PanelPart, *, in_panel: bool) -> str:
    """How to go on, for who uses keys, mouse or gamepad."""
    if hand is Hand.MOUSE:
        return _mouse_hint(part)
    if hand is Hand.KEYS and in_panel:
        return tr("Up, down: choose; left, right: change; Enter: type or press; Esc: to the arena.")
    if hand is Hand.KEYS and part is PanelPart.WELLS:
        return tr("Arrows: move the well; Space: add; Backspace: remove; Page up: another; Tab: to the panel; F1: help.")
    if hand is Hand.KEYS:
        return tr("Arrows: move; Space: paint; Backspace: take away; Tab: to the panel; F1: help.")
    other, paint, remove = (button_names(action) for action in (Action.TIP, Action.SERVE, Action.GIVE_UP))
    if in_panel:
        words = tr(
            "Up, down: choose; left, right: change; {press}: enter or press; {parts}: other part; {other}: to the arena."
        )
        return words.format(press=paint, other=other, parts=button_names(Action.STEP_BACK, Action.STEP))
    if part is PanelPart.WELLS:
        words = tr("D-pad: move the well; {paint}: add; {remove}: remove; {other}: to the panel; {help}: help.")
    else:
        words = tr("{paint}: paint; {remove}: take away; {other}: to the panel; {help}: help.")
    return words.format(paint=paint, remove=remove, other=other, help=button_names(Action.HELP))


def _mouse_hint(part: PanelPart) -> str:
    """What the mouse does in the arena."""
    if part is PanelPart.RING:
        return tr("Click on a ring to choose it; drag it to change its radius.")
    if part is PanelPart.WELLS:
        return tr("Click to add a well; drag it; right button: remove it.")
    return tr("Left button: paint; right button: take away; wheel: layers of the brush.")


def editor_help(state: AppState, under: Screen) -> KeyHelp:
    """The help panel over the editor, with a part each for keys, mouse and gamepad."""
    parts = ((tr("Keys"), _translated(KEYS)), (tr("Mouse"), _translated(MOUSE)), (tr("Gamepad"), pad_lines()))
    return KeyHelp(state, under, HelpWords(tr("The editor"), tr("Back"), tr(_NOTE)), parts)


def _translated(lines: Lines) -> Lines:
    """Lines in the player's language."""
    return tuple([(tr(names), tr(meaning)) for names, meaning in lines])
