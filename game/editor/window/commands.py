"""The editor's commands: what each changes, and the keys and the gamepad's buttons that give it."""

from collections.abc import Callable
from typing import NamedTuple

import pygame

from game.editor import cursor, wells
from game.editor import session as editing
from game.editor.session import EditorSession
from game.editor.symmetry import FOLDS
from game.input.keys import Action
from game.language import tr_noop
from physics import PERMANENT

_ASCII = 128
LAYERS = (None, *range(1, 10), 0, PERMANENT)
TINTS = (None, *range(9))
"""Layers and colours of the brush to choose from; the first of each leaves a slot's own."""


class EditorCommand(NamedTuple):
    """What a button or a key does.

    label: of the button; "" if it is composed elsewhere. key: that does the same. tip: a sentence.
    """

    label: str
    key: str
    tip: str = ""


COMMANDS = {
    "fill": EditorCommand(tr_noop("Fill ring"), "F", tr_noop("Puts the brush into every slot of the chosen ring.")),
    "take": EditorCommand(tr_noop("Take brush"), "P", tr_noop("The brush becomes what is under the cursor.")),
    "copy": EditorCommand(
        tr_noop("Copy bricks"), tr_noop("Ctrl+C"), tr_noop("Remembers the ring's bricks, from the cursor on.")
    ),
    "paste": EditorCommand(
        tr_noop("Paste bricks"), tr_noop("Ctrl+V"), tr_noop("Puts them on the chosen ring, from the cursor on.")
    ),
    "add": EditorCommand(tr_noop("Copy ring"), "Ins", tr_noop("Another ring like this one, outside of all others.")),
    "remove": EditorCommand(tr_noop("Remove ring"), "Del"),
    "add-well": EditorCommand(tr_noop("Add well"), "Ins", tr_noop("A gravity well like the chosen one, further around.")),
    "remove-well": EditorCommand(tr_noop("Remove well"), "Del"),
    "undo": EditorCommand("", tr_noop("Ctrl+Z")),
    "redo": EditorCommand("", tr_noop("Ctrl+Y")),
    "test": EditorCommand(tr_noop("Play-test"), "F5", tr_noop("Plays the level; Esc there comes back.")),
    "save": EditorCommand(tr_noop("Save"), tr_noop("Ctrl+S"), tr_noop("Comments in the file stay.")),
    "help": EditorCommand(tr_noop("Help"), "F1", tr_noop("Every key and button.")),
    "leave": EditorCommand(tr_noop("Leave"), "Esc", tr_noop("Asks first where changes are not saved.")),
}


def _mirrored(session: EditorSession) -> EditorSession:
    """The session with mirror images switched on or off."""
    return session._replace(symmetry=session.symmetry._replace(mirrored=not session.symmetry.mirrored))


def _folded(session: EditorSession) -> EditorSession:
    """The session in which strokes are repeated the next possible number of times around the ring."""
    fold = FOLDS[(FOLDS.index(session.symmetry.fold) + 1) % len(FOLDS)]
    return session._replace(symmetry=session.symmetry._replace(fold=fold))


def relayered(session: EditorSession, steps: int) -> EditorSession:
    """The session whose brush has layers `steps` after the present ones; the first follows the last."""
    return editing.brushed(session, LAYERS[(LAYERS.index(session.brush.layers) + steps) % len(LAYERS)])


def recoloured(session: EditorSession, steps: int) -> EditorSession:
    """The session whose brush has the colour `steps` after the present one; the first follows the last."""
    return editing.tinted(session, TINTS[(TINTS.index(session.brush.tint) + steps) % len(TINTS)])


def layers_of(event: pygame.Event) -> int | None:
    """The brush that a key stands for, by what is written on it; None for other keys."""
    written = getattr(event, "unicode", "") or (chr(event.key) if event.key < _ASCII else "")
    if written == "-":
        return PERMANENT
    return int(written) if written in tuple("0123456789") else None


CHANGES: dict[str, Callable[[EditorSession], EditorSession]] = {
    "add": editing.with_ring_copied,
    "remove": editing.with_ring_removed,
    "fill": editing.filled,
    "undo": editing.undone,
    "redo": editing.redone,
    "mirror": _mirrored,
    "fold": _folded,
    "copy": cursor.with_bricks_copied,
    "paste": cursor.with_bricks_pasted,
    "take": cursor.with_brush_of_slot,
    "add-well": wells.with_well_added,
    "remove-well": wells.with_well_removed,
}
COMMAND_KEYS = {
    pygame.K_INSERT: "add",
    pygame.K_c: "add",
    pygame.K_DELETE: "remove",
    pygame.K_f: "fill",
    pygame.K_m: "mirror",
    pygame.K_r: "fold",
    pygame.K_p: "take",
    pygame.K_F5: "test",
    pygame.K_F1: "help",
    pygame.K_h: "help",
    pygame.K_ESCAPE: "leave",
}
OF_WELLS = {"add": "add-well", "remove": "remove-well"}
"""The commands that replace those for rings in the part for gravity wells."""
COLOUR_KEY = pygame.K_t
CONTROL_KEYS = {
    pygame.K_z: "undo",
    pygame.K_y: "redo",
    pygame.K_s: "save",
    pygame.K_c: "copy",
    pygame.K_v: "paste",
}
"""Keys that give a command together with Ctrl."""
COMMAND_ACTIONS = {
    Action.PAUSE: "test",
    Action.HELP: "help",
    Action.ZOOM_OUT: "undo",
    Action.ZOOM_IN: "redo",
    Action.BACK: "leave",
}
"""Commands that a gamepad gives."""
DIRECTIONS = {
    pygame.K_LEFT: Action.LEFT,
    pygame.K_RIGHT: Action.RIGHT,
    pygame.K_UP: Action.UP,
    pygame.K_DOWN: Action.DOWN,
}
PAGES = {pygame.K_PAGEUP: -1, pygame.K_PAGEDOWN: 1}
"""Keys that show another part of the panel; in the arena, the first one chooses the next ring outward."""
PAINTING_KEYS = (pygame.K_SPACE, pygame.K_RETURN, pygame.K_KP_ENTER)
ERASING_KEYS = (pygame.K_BACKSPACE,)
KNOWN_KEYS = frozenset({*COMMAND_KEYS, *CONTROL_KEYS, COLOUR_KEY})
"""Letter keys that keyboard layouts without these letters have at the same positions."""
