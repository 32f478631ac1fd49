"""The editor by keys alone and by gamepad alone: what a pointer can do, they can."""

import pygame
import pytest

from game.editor.command import editing_session
from game.editor.file_watch import WatchedFile
from game.editor.window.help import EditorHelp, hint
from game.editor.window.layout import editor_layout
from game.editor.window.play_test import PlayTest
from game.editor.window.screen import Editor
from game.editor.window.targets import box_of
from game.input.repeat import FIRST, NEXT
from game.levels import load_file
from tests.support.dummy_window import FRAME, Desk, shared
from tests.support.pad_desk import PadDesk

UP, DOWN, LEFT, RIGHT = pygame.K_UP, pygame.K_DOWN, pygame.K_LEFT, pygame.K_RIGHT
SPACE, TAB = pygame.K_SPACE, pygame.K_TAB
CTRL, SHIFT = pygame.KMOD_CTRL, pygame.KMOD_SHIFT


def opened(kind, tmp_path):
    """A desk with the editor on a new file."""
    state = shared()
    file = WatchedFile(tmp_path / "mine.toml")
    return kind(state, Editor(state, editing_session(file), file), (640, 400))


@pytest.fixture
def keys(tmp_path):
    """The editor, used with a keyboard."""
    desk = opened(Desk, tmp_path)
    yield desk
    desk.close()


@pytest.fixture
def pad(tmp_path):
    """The editor, used with a gamepad."""
    desk = opened(PadDesk, tmp_path)
    yield desk
    desk.close()


def slots(desk, ring=0):
    """The layers of a ring."""
    return desk.screen.session.document.level.rings[ring].slots()


def choose(desk, name):
    """Go down the panel, into which Tab leads, to a number or a command."""
    if not desk.screen._in_panel:
        desk.press(TAB)
    for _ in range(40):
        seen = desk.screen._target, editor_layout(desk.window.size, desk.screen.session)
        box = box_of(*seen)
        if any([name in (row.name, "") and box == own for row, own in seen[1].rows]):
            return
        found = [button.name for button, own in seen[1].buttons if own.top == box.top]
        if name in found:
            if not any([button.name == name and own == box for button, own in seen[1].buttons]):
                desk.press(RIGHT)
            return
        desk.press(DOWN)
    raise AssertionError(f"{name} cannot be reached")


def test_keys_paint_erase_copy_and_paste(keys):
    """A key that is held while the cursor moves paints on, which is undone as a whole."""
    before = keys.screen.session.document
    count = len(slots(keys))
    keys.press(pygame.K_3)
    keys.hold(SPACE)
    keys.press(RIGHT, RIGHT)
    keys.release(SPACE)
    keys.wait(FRAME)
    keys.press(RIGHT, pygame.K_BACKSPACE)
    assert slots(keys) == (3, 3, 3, 0, *[1] * (count - 4))
    keys.press(pygame.K_z, pygame.K_z, mod=CTRL)
    assert keys.screen.session.document == before
    keys.press(pygame.K_y, pygame.K_y, mod=CTRL)
    keys.press(LEFT, LEFT, LEFT, pygame.K_INSERT)
    keys.press(pygame.K_0, pygame.K_f, RIGHT)
    keys.press(pygame.K_PAGEDOWN, LEFT)
    keys.press(pygame.K_c, mod=CTRL)
    keys.press(UP, RIGHT)
    keys.press(pygame.K_v, mod=CTRL)
    assert slots(keys, 1) == (1, 3, 3, 3, 0, *[1] * (count - 5))
    keys.press(DOWN, RIGHT, pygame.K_p)
    assert keys.screen.session.brush == 3
    before = keys.screen.session.slot
    keys.hold(RIGHT)
    keys.wait(FIRST + 4.0 * NEXT)
    keys.release(RIGHT)
    keys.wait(FRAME)
    moved = keys.screen.session.slot
    assert 3 <= (moved - before) % count <= 6
    keys.wait(2.0 * NEXT)
    assert keys.screen.session.slot == moved


def test_keys_change_numbers_and_give_every_command(keys, tmp_path):
    """In the panel, which Tab leads into; numbers by steps and typed; play-test, save, help and the way out."""
    choose(keys, "spin")
    keys.press(RIGHT)
    keys.press(RIGHT, mod=SHIFT)
    assert keys.screen.session.document.level.rings[0].spin == 11.0
    keys.press(pygame.K_RETURN)
    keys.type("7")
    keys.press(pygame.K_RETURN)
    assert keys.screen.session.document.level.rings[0].spin == 7.0
    choose(keys, "add")
    keys.press(UP, RIGHT, UP, RIGHT)
    assert (keys.screen.session.brush, keys.screen.session.symmetry.fold) == (2, 2)
    choose(keys, "help")
    keys.press(SPACE)
    assert isinstance(keys.screen, EditorHelp)
    keys.press(pygame.K_ESCAPE)
    choose(keys, "test")
    keys.press(SPACE)
    assert isinstance(keys.screen, PlayTest)
    keys.screen = keys.screen._editor
    choose(keys, "save")
    keys.press(SPACE)
    assert load_file(tmp_path / "mine.toml").rings[0].spin == 7.0
    choose(keys, "leave")
    keys.press(SPACE)
    assert keys.screen is None


def test_a_gamepad_alone_makes_a_level(pad, tmp_path):
    """Paint on while a button is held, take away, another brush, a number by ten, copy and paste, undo; save; play; leave."""
    count = len(slots(pad))
    pad.press(pygame.K_PERIOD)
    pad.pad.press(pygame.CONTROLLER_BUTTON_A)
    pad.wait(2 * FRAME)
    pad.press(RIGHT)
    pad.pad.release(pygame.CONTROLLER_BUTTON_A)
    pad.wait(2 * FRAME)
    pad.pad.push(pygame.CONTROLLER_AXIS_LEFTX, 1.0)
    pad.wait(2 * FRAME)
    pad.pad.push(pygame.CONTROLLER_AXIS_LEFTX, 0.0)
    pad.wait(2 * FRAME)
    pad.press(pygame.K_g)
    assert slots(pad) == (2, 2, 0, *[1] * (count - 3))
    choose(pad, "copy")
    pad.press(SPACE, TAB, RIGHT)
    choose(pad, "paste")
    pad.press(SPACE)
    assert slots(pad) == (1, 2, 2, 0, *[1] * (count - 4))
    choose(pad, "undo")
    pad.press(SPACE)
    assert slots(pad) == (2, 2, 0, *[1] * (count - 3))
    choose(pad, "phase")
    pad.press(pygame.K_PERIOD, LEFT, SPACE)
    assert pad.screen.session.document.level.rings[0].phase == 9.0
    assert hint(pad.screen._hand, in_panel=True).startswith("Up, down")
    choose(pad, "save")
    pad.press(SPACE)
    assert load_file(tmp_path / "mine.toml").rings[0].phase == 9.0
    pad.press(pygame.K_p)
    assert isinstance(pad.screen, PlayTest)
    pad.screen = pad.screen._editor
    pad.press(pygame.K_h)
    assert isinstance(pad.screen, EditorHelp)
    pad.press(pygame.K_ESCAPE, pygame.K_ESCAPE)
    pad.pad.press(pygame.CONTROLLER_BUTTON_DPAD_LEFT)
    pad.wait(2 * FRAME)
    pad.pad.pull_out()
    pad.wait(2 * FRAME)
    slot = pad.screen.session.slot
    pad.wait(FIRST + 2.0 * NEXT)
    assert pad.screen.session.slot == slot
    pad.post(pygame.QUIT)
    assert pad.screen is None
