"""The editor's commands: what each changes, and the keys and the gamepad's buttons that give it."""

from collections.abc import Callable

import pygame

from game.editor import cursor
from game.editor import session as editing
from game.editor.session import EditorSession
from game.editor.symmetry import FOLDS
from game.input.keys import Action
from physics import PERMANENT

_ASCII = 128


def _mirrored(session: EditorSession) -> EditorSession:
    """The session with mirror images switched on or off."""
    return session._replace(symmetry=session.symmetry._replace(mirrored=not session.symmetry.mirrored))


def folded(session: EditorSession, steps: int = 1) -> EditorSession:
    """The session with the next number of rotations, or the one before."""
    fold = next_of(FOLDS, session.symmetry.fold, steps)
    return session._replace(symmetry=session.symmetry._replace(fold=fold))


def next_of(choices: tuple[int, ...], present: int, steps: int) -> int:
    """The choice some steps further, round at the end."""
    return choices[(choices.index(present) + steps) % len(choices)]


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
    "fold": folded,
    "copy": cursor.with_bricks_copied,
    "paste": cursor.with_bricks_pasted,
    "take": cursor.with_brush_of_slot,
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
CONTROL_KEYS = {pygame.K_z: "undo", pygame.K_s: "save", pygame.K_c: "copy", pygame.K_v: "paste"}
"""Keys that give a command together with Ctrl."""
COMMAND_ACTIONS = {Action.PAUSE: "test", Action.HELP: "help", Action.BACK: "leave"}
"""Commands that a gamepad gives."""
DIRECTIONS = {
    pygame.K_LEFT: Action.LEFT,
    pygame.K_RIGHT: Action.RIGHT,
    pygame.K_UP: Action.UP,
    pygame.K_DOWN: Action.DOWN,
}
PAINTING_KEYS = (pygame.K_SPACE, pygame.K_RETURN, pygame.K_KP_ENTER)
ERASING_KEYS = (pygame.K_BACKSPACE,)
