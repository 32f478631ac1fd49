"""The editor by keys alone, by mouse alone and by gamepad alone: a level with everything in it, saved, played and left."""

import pygame
import pytest

from game.editor.command import NEW, editing_session
from game.editor.fields import PanelPart
from game.editor.file_watch import WatchedFile
from game.editor.window.help import hint
from game.editor.window.play_test import PlayTest
from game.editor.window.screen import Editor
from game.input.repeat import FIRST, NEXT
from game.levels import load_file
from game.screens.toolkit.key_help import KeyHelp
from game.screens.toolkit.text_entry import TextEntry
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tests.support.windows.pad_desk import PadDesk

UP, DOWN, LEFT, RIGHT = pygame.K_UP, pygame.K_DOWN, pygame.K_LEFT, pygame.K_RIGHT
SPACE, TAB, ENTER, ESCAPE = pygame.K_SPACE, pygame.K_TAB, pygame.K_RETURN, pygame.K_ESCAPE
CTRL, SHIFT = pygame.KMOD_CTRL, pygame.KMOD_SHIFT


def opened(kind, tmp_path):
    """A desk with the editor on a new file."""
    state = shared()
    file = WatchedFile(tmp_path / "mine.toml")
    return kind(state, Editor(state, editing_session(file), file), (800, 600))


@pytest.fixture
def keys(tmp_path):
    """The editor, used with a keyboard or a mouse."""
    desk = opened(Desk, tmp_path)
    yield desk
    desk.close()


@pytest.fixture
def pad(tmp_path):
    """The editor, used with a gamepad."""
    desk = opened(PadDesk, tmp_path)
    yield desk
    desk.close()


def level(desk):
    """The level that is edited."""
    return desk.screen.session.document.level


def slots(desk, ring=0):
    """The layers of a ring."""
    return level(desk).rings[ring].slots()


def open_part(desk, part):
    """Go to a part of the panel by its keys; the panel must have the keys."""
    while desk.form.part is not part:
        desk.press(pygame.K_PERIOD if isinstance(desk, PadDesk) else pygame.K_PAGEDOWN)


def to_pixel(desk, point):
    """The pixel of a point of the world."""
    pixel = desk.screen.layout(desk.window.size).camera.project(point)
    return round(pixel.real), round(pixel.imag)


def drag(desk, start, end, button=1):
    """Press in the arena, move, release; the points are of the world."""
    held = tuple([int(button == one) for one in (1, 2, 3)])
    first, last = to_pixel(desk, start), to_pixel(desk, end)
    pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=first, rel=(0, 0), buttons=(0, 0, 0)))
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=first, button=button))
    pygame.event.post(pygame.Event(pygame.MOUSEMOTION, pos=last, rel=(0, 0), buttons=held))
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=last, button=button))
    desk.wait(2 * FRAME)


def let_go(desk):
    """Release the mouse button where the mouse is."""
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=(0, 0), button=1))
    desk.wait(FRAME)


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
    assert keys.shared.toast.text == "Undone: paint 3 bricks"
    assert keys.screen.session.document == before
    russian = {"key": 0x43D, "scancode": pygame.KSCAN_Y, "mod": CTRL, "unicode": "\u043d"}
    pygame.event.post(pygame.Event(pygame.KEYDOWN, **russian))
    keys.press(pygame.K_y, mod=CTRL)
    keys.press(LEFT, LEFT, LEFT, pygame.K_INSERT)
    keys.press(pygame.K_0, pygame.K_f, RIGHT)
    keys.press(pygame.K_PAGEDOWN, LEFT)
    keys.press(pygame.K_c, mod=CTRL)
    keys.press(UP, RIGHT)
    keys.press(pygame.K_v, mod=CTRL)
    assert slots(keys, 1) == (1, 3, 3, 3, 0, *[1] * (count - 5))
    keys.press(DOWN, RIGHT, pygame.K_p)
    assert keys.screen.session.brush == (3, 0)
    before = keys.screen.session.slot
    keys.hold(RIGHT)
    keys.wait(FIRST + 4.0 * NEXT)
    keys.release(RIGHT)
    keys.wait(FRAME)
    moved = keys.screen.session.slot
    assert 3 <= (moved - before) % count <= 6
    keys.wait(2.0 * NEXT)
    assert keys.screen.session.slot == moved


def test_keys_alone_make_a_level(keys, tmp_path):
    """Stepped and typed numbers, a name, colours, a well, power-ups, a look; play-test, save, help, leave."""
    keys.press(TAB)
    open_part(keys, PanelPart.RING)
    keys.focus("Spin")
    keys.press(RIGHT)
    keys.press(RIGHT, mod=SHIFT)
    assert level(keys).rings[0].spin == 11.0
    keys.type("7")
    keys.press(ENTER)
    assert level(keys).rings[0].spin == 7.0
    assert keys.form.part is PanelPart.RING, "a digit typed the number and was no brush"
    keys.choose("Bumper")
    open_part(keys, PanelPart.LEVEL)
    keys.choose("Chapter")
    assert isinstance(keys.screen, TextEntry)
    keys.type("Mine")
    keys.press(ENTER)
    keys.focus("Palette")
    keys.press(RIGHT)
    open_part(keys, PanelPart.DROPS)
    keys.choose("Extra life")
    open_part(keys, PanelPart.WELLS)
    keys.choose("Add well")
    keys.press(ESCAPE, RIGHT)
    keys.press(UP, mod=SHIFT)
    well = level(keys).wells[0]
    assert (well.distance, well.angle) == (6.0, 91.0)
    keys.press(SPACE, pygame.K_BACKSPACE, pygame.K_t, pygame.K_t, SPACE)
    assert (keys.form.part, level(keys).rings[0].tint_at(0)) == (PanelPart.BRICKS, 1)
    assert len(level(keys).wells) == 1
    keys.press(TAB)
    keys.press(pygame.K_z, mod=CTRL)
    keys.choose("Help")
    assert isinstance(keys.screen, KeyHelp)
    keys.press(ESCAPE)
    keys.press(pygame.K_s, mod=CTRL)
    assert not (tmp_path / "mine.toml").exists(), "a bumper's bricks never break"
    open_part(keys, PanelPart.RING)
    keys.choose("Bumper")
    keys.press(pygame.K_F5)
    assert isinstance(keys.screen, PlayTest)
    keys.screen = keys.screen._editor
    keys.choose("Save")
    saved = load_file(tmp_path / "mine.toml")
    assert (saved.chapter, saved.look.palette, saved.rings[0].spin) == ("Mine", "ember", 7.0)
    assert "life" not in saved.drops.kinds
    keys.press(ESCAPE, ESCAPE)
    assert keys.screen is None


def test_the_mouse_alone_makes_a_level(keys, tmp_path):
    """Chips, strokes, dragged rings and wells, numbers by their signs, a name letter by letter."""
    desk = keys
    chips = next(
        positioned
        for positioned in desk.form._form_layout((800, 600)).items
        if len(getattr(positioned.item, "chips", ())) == 12
    )
    desk.click(chips.item.boxes(chips.box, desk.form.unit((800, 600)))[5].center)
    drag(desk, 4 + 0j, 4 + 0.2j)
    drag(desk, 4 + 0j, 4 + 0.2j, button=3)
    assert desk.screen.session.brush.layers == 5
    assert slots(desk)[0] == 0
    desk.click_on("Undo: take 1 brick away")
    let_go(desk)
    assert slots(desk)[0] == 5
    parts = next(positioned for positioned in desk.form._form_layout((800, 600)).items if hasattr(positioned.item, "chips"))
    heads = parts.item.boxes(parts.box, desk.form.unit((800, 600)))
    desk.click(heads[1].center)
    before = slots(desk)
    drag(desk, 4.2 + 0j, 5.2 + 0j)
    assert (level(desk).rings[0].radius, slots(desk)) == (5.0, before)
    item = next(
        positioned for positioned in desk.form._form_layout((800, 600)).items if getattr(positioned.item, "label", "") == "Spin"
    )
    field = item.item.field_box(item.box, desk.form.unit((800, 600)))
    desk.click((field.right + 5, field.centery))
    assert level(desk).rings[0].spin == 1.0
    desk.wait(FIRST + 5.0 * NEXT)
    let_go(desk)
    spun = level(desk).rings[0].spin
    assert 4.0 <= spun <= 8.0, "held, it goes on"
    desk.wait(1.0)
    assert level(desk).rings[0].spin == spun
    desk.click_on("Undo: Spin: 0")
    assert level(desk).rings[0].spin == 0.0, "undone as a whole"
    desk.click(heads[2].center)
    let_go(desk)
    drag(desk, 2j, 3j)
    drag(desk, 3.1j, 1 + 3.1j)
    drag(desk, -2 + 0j, -2 + 0j)
    drag(desk, -2 + 0j, -2 + 0j, button=3)
    (well,) = level(desk).wells
    assert (well.distance, well.angle) == (3.16, 71.57)
    desk.click(heads[5].center)
    desk.click_on("Name")
    for letter in ("Erase",) * 8 + ("A", "abc", "b"):
        desk.click_on(letter)
    desk.click_on("Done")
    assert level(desk).name == "Ab"
    desk.click_on("Save")
    assert load_file(tmp_path / "mine.toml") == level(desk)
    desk.click_on("Play-test")
    assert isinstance(desk.screen, PlayTest)
    desk.screen = desk.screen._editor
    desk.click_on("Leave")
    assert desk.screen is None


def test_a_gamepad_alone_makes_a_level(pad, tmp_path):
    """Painting with a held button, removing, another brush, a number digit by digit, a well, undo; save, play, leave."""
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
    pad.press(pygame.K_g, TAB)
    assert slots(pad) == (2, 2, 0, *[1] * (count - 3))
    pad.choose("Copy bricks")
    pad.press(TAB, RIGHT, TAB)
    pad.choose("Paste bricks")
    assert slots(pad) == (1, 2, 2, 0, *[1] * (count - 4))
    pad.choose("Undo: paint 3 bricks")
    assert slots(pad) == (2, 2, 0, *[1] * (count - 3))
    open_part(pad, PanelPart.RING)
    pad.choose("Angle of slot 0")
    for key in ("-", "9", "0", "Erase", "Done"):
        pad.choose(key)
    assert level(pad).rings[0].phase == -9.0
    open_part(pad, PanelPart.WELLS)
    pad.press(TAB, SPACE, UP, SPACE, pygame.K_g)
    assert [well.distance for well in level(pad).wells] == [5.1]
    assert hint(pad.screen._hand, PanelPart.BRICKS, in_panel=True).startswith("Up, down")
    pad.press(TAB)
    pad.choose("Save")
    assert load_file(tmp_path / "mine.toml") == level(pad)
    pad.press(pygame.K_p)
    assert isinstance(pad.screen, PlayTest)
    pad.screen = pad.screen._editor
    pad.press(pygame.K_h)
    assert isinstance(pad.screen, KeyHelp)
    pad.press(ESCAPE, ESCAPE)
    pad.pad.press(pygame.CONTROLLER_BUTTON_DPAD_LEFT)
    pad.wait(2 * FRAME)
    pad.pad.pull_out()
    pad.wait(2 * FRAME)
    document = pad.screen.session.document
    pad.wait(FIRST + 2.0 * NEXT)
    assert pad.screen.session.document == document
    pad.post(pygame.QUIT)
    assert pad.screen is None


def test_a_number_that_the_file_leaves_out_is_usual_again_when_its_field_is_emptied(keys):
    """A step begins at the default; an empty field removes the key from the file; letters are refused."""
    keys.press(TAB)
    open_part(keys, PanelPart.PADDLES)
    keys.focus("Top speed")
    keys.press(RIGHT)
    assert level(keys).ball.top_speed == 11.3
    keys.press(ENTER, pygame.K_BACKSPACE, ENTER)
    assert keys.screen.session.document.text == NEW
    keys.press(ENTER)
    keys.type("x")
    keys.press(ENTER)
    assert keys.screen.session.message == "x: not a number"


def finger(desk, kind, pixel):
    """An event of a finger, and the event of a mouse that SDL makes of it."""
    (x, y), mouse = pixel, {pygame.FINGERDOWN: pygame.MOUSEBUTTONDOWN, pygame.FINGERUP: pygame.MOUSEBUTTONUP}
    held = {"rel": (0, 0), "buttons": (1, 0, 0), "button": 1, "pos": pixel, "touch": True}
    pygame.event.post(pygame.Event(mouse.get(kind, pygame.MOUSEMOTION), **held))
    pygame.event.post(pygame.Event(kind, touch_id=3, finger_id=0, x=x / 800, y=y / 600, dx=0.0, dy=0.0))
    desk.wait(FRAME)


def test_a_finger_alone_paints_scrolls_and_enters_numbers(keys):
    """In the arena it acts as a mouse; a control is used when the finger is lifted; a drag scrolls and uses nothing."""
    start, end = (to_pixel(keys, 4 * direction) for direction in (1 + 0j, 0.87 + 0.5j))
    keys.press(pygame.K_5)
    for kind, pixel in ((pygame.FINGERDOWN, start), (pygame.FINGERMOTION, end), (pygame.FINGERUP, end)):
        finger(keys, kind, pixel)
    assert slots(keys)[:3] == (5, 5, 1)
    keys.shared.change(keys.shared.settings._replace(text_size=150))
    keys.form.open_part(PanelPart.RING)
    box = keys.box("Spin")
    field = next(positioned for positioned in keys.form._form_layout((800, 600)).items if positioned.box == box).item.field_box(
        box, keys.form.unit((0, 0))
    )
    before = keys.screen.session
    above = (field.centerx, field.centery - 90)
    for kind, pixel in ((pygame.FINGERDOWN, field.center), (pygame.FINGERMOTION, above), (pygame.FINGERUP, above)):
        finger(keys, kind, pixel)
    assert keys.screen.session == before
    assert keys.form._scroll > 0.0
    keys.form._scroll = 0.0
    for kind in (pygame.FINGERDOWN, pygame.FINGERUP):
        finger(keys, kind, field.center)
    assert isinstance(keys.screen, TextEntry)
    keys.choose("5")
    keys.choose("Done")
    assert level(keys).rings[0].spin == 5.0
    keys.click(field.center)
    assert keys.form.is_typed_into, "with a mouse there is a keyboard"
