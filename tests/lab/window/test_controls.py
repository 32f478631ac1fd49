"""The lab's sliders, fields, switches, buttons and lists, worked by posted events on the dummy driver."""

import pygame
import pytest

from game.drawing.text import Type
from game.input.actions import Action
from game.input.signals import Released
from game.lab.kit.picture import Toggle
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.share import parsed
from game.lab.window.controls import LabControls
from game.lab.window.layout import layout_of
from game.lab.window.screen import SHOWN, Lab
from game.lab.window.side_panel import LabSidePanel
from game.lab.window.words import small_print_height
from game.screens.toolkit.form import focused_item
from game.screens.toolkit.items.basic import ButtonItem, Switch
from game.screens.toolkit.items.drop_down import OptionList
from game.screens.toolkit.items.label import LabelItem
from game.screens.toolkit.key_help import KeyHelp
from tests.support.windows.dummy_window import FRAME, shared
from tests.support.windows.lab_desk import SIZE, LabDesk


@pytest.mark.usefixtures("unseen")
def test_a_number_is_typed_exactly(desk):
    """A typed number is set with every digit; letters are refused; a number out of range is set to the border."""
    desk.type_into("half_angle", "33.123456789012")
    assert desk.values.number("half_angle") == 33.123456789012
    desk.type_into("half_angle", "abc")
    assert desk.values.number("half_angle") == 33.123456789012
    assert desk.session.notes == ("φ_p: 'abc' is not a number",)
    desk.type_into("half_angle", "nan")
    assert desk.session.notes == ("φ_p cannot be nan°: it stays 33.123456789012°",)
    desk.type_into("half_angle", "999")
    assert desk.values.number("half_angle") == 180.0
    assert desk.session.notes == ("φ_p = 999° is beyond its range: set to 180°",)
    desk.type_into("ball", "1.25", 1)
    assert desk.values.point("ball") == 9.4 + 1.25j


def test_keys_belong_to_the_field_that_is_typed_into(desk):
    """While a field is typed into, letters are no commands, and the first Esc only leaves the field as it was."""
    theme = desk.shared.theme
    desk.click(desk.slider("r").field.center)
    pygame.event.post(pygame.Event(pygame.TEXTINPUT, text="5"))
    desk.press(pygame.K_t, pygame.K_ESCAPE)
    assert desk.shared.theme is theme
    assert desk.screen is not None
    assert desk.values.number("r") == 0.9
    desk.press(pygame.K_t)
    assert desk.shared.theme is not theme
    desk.press(pygame.K_ESCAPE)
    assert desk.screen is None


def test_a_second_press_in_a_field_puts_the_caret_there_and_one_beside_it_leaves_the_field(desk):
    """Letters go in where the caret is; what was typed is forgotten when something else is pressed."""
    field = desk.slider("half_angle").field
    desk.click(field.center)
    pygame.event.post(pygame.Event(pygame.TEXTINPUT, text="30"))
    desk.click((field.left + 4, field.centery))
    pygame.event.post(pygame.Event(pygame.TEXTINPUT, text="1"))
    desk.press(pygame.K_RETURN)
    assert desk.values.number("half_angle") == 130.0
    desk.click(field.center)
    pygame.event.post(pygame.Event(pygame.TEXTINPUT, text="7"))
    desk.click(desk.slider("r").knob)
    desk.press(pygame.K_RETURN)
    assert desk.values.number("half_angle") == 130.0


@pytest.mark.parametrize("share", [0.03, 0.97])
@pytest.mark.usefixtures("unseen")
def test_a_slider_is_dragged(desk, share):
    """A press beside the knob brings it there, one on it moves nothing; the knob follows the mouse wherever that goes."""
    desk.type_into("half_angle", "33.123")
    desk.click(desk.slider("half_angle").knob)
    assert desk.values.number("half_angle") == 33.123, "a press on the knob"
    bar = desk.slider("half_angle").bar
    desk.click((bar.left + round(share * bar.width), bar.centery))
    assert desk.values.number("half_angle") == pytest.approx(share * 180.0, abs=1.0)
    assert desk.values.number("half_angle") % 0.5 == 0.0, "a multiple of its step"
    x, y = desk.slider("half_angle").knob
    desk.drag((x + 3, y), (bar.centerx + 3, 5))
    assert desk.slider("half_angle").knob[0] == pytest.approx(bar.centerx, abs=1)
    desk.move((bar.left, bar.centery))
    desk.wait(FRAME)
    assert desk.slider("half_angle").knob[0] == pytest.approx(bar.centerx, abs=1)
    desk.drag((bar.right, bar.centery), (5, 5))
    assert desk.values.number("half_angle") == 0.0
    assert desk.session.notes == ()
    desk.drag((5, 300), (bar.right, bar.centery))
    desk.drag(desk.slider("half_angle").field.center, (bar.right, bar.centery))
    assert desk.values.number("half_angle") == 0.0, "the picture was dragged, and the field"


def test_the_list_of_scenes_is_used_by_keys_and_by_mouse():
    """It opens at the present scene; a letter leads on, Enter chooses; a click chooses; Esc changes nothing; L is a letter."""
    desk = LabDesk("free-run")
    desk.shared.open_lab = lambda *_: None
    desk.click_on("free-run")
    assert isinstance(desk.screen, OptionList)
    layout = desk.screen._form_layout(SIZE)
    assert layout.body.contains(focused_item(layout, desk.screen._focus).box)
    desk.press(pygame.K_l, pygame.K_DOWN, pygame.K_ESCAPE)
    assert desk.session.scene.name == "free-run"
    assert desk.side._focus is None
    desk.click_on("free-run")
    desk.type("cc")
    desk.press(pygame.K_RETURN)
    assert desk.session.scene.name == "case-1"
    desk.click_on("case-1")
    layout = desk.screen._form_layout(SIZE)
    positioned = next(
        positioned
        for positioned in layout.items
        if positioned.item.focusable and layout.body.contains(positioned.box) and positioned.row > 3
    )
    desk.click(positioned.box.center)
    assert isinstance(desk.screen, Lab)
    assert desk.session.scene.name == positioned.item.cells[0][0]
    desk.close()


def test_a_preset_is_chosen(desk):
    """The list of presets sets the values that it shows."""
    preset = desk.session.scene.presets[-1]
    desk.click_on("Presets")
    desk.press(pygame.K_UP, pygame.K_RETURN)
    assert desk.values.values == parsed(f"case-2?{preset.line}").given.values


def test_toggles_by_key_and_by_switch(desk):
    """A key and a click each change a toggle once, and the switch shows it; one of marks that are not there cannot be used."""
    for on in (True, False, True):
        desk.press(pygame.K_7)
        assert (Toggle.PYMUNK in desk.screen._shown) is on
        assert desk.positioned("7  pymunk").item.on is on
    for shown in (False, True):
        desk.click_on("7  pymunk")
        assert (Toggle.PYMUNK in desk.screen._shown) is shown
    desk.click_on("4  bands")
    assert Toggle.BANDS in desk.screen._shown


@pytest.mark.usefixtures("unseen")
def test_all_controls_are_used_by_keys_alone(desk):
    """Tab goes through them and around; arrows step a slider, with Shift by ten; Enter types, presses, opens; Esc ends."""
    items = [positioned for positioned in desk.side._form_layout(SIZE).items if positioned.item.focusable]
    desk.press(pygame.K_RETURN)
    desk.press(pygame.K_TAB, mod=pygame.KMOD_LALT)
    assert desk.side._focus is None, "the keys are the scene's at first"
    seen = []
    for _ in items:
        desk.press(pygame.K_TAB)
        seen.append(desk.side._focus)
    assert seen == [(positioned.row, positioned.column) for positioned in items]
    desk.press(pygame.K_TAB)
    desk.press(pygame.K_TAB, mod=pygame.KMOD_LSHIFT)
    assert desk.side._focus == seen[-1]
    while desk.side._focus != next((positioned.row, positioned.column) for positioned in items if positioned.item.label == "r"):
        desk.press(pygame.K_UP)
    desk.press(pygame.K_RIGHT, pygame.K_RIGHT, pygame.K_LEFT)
    assert desk.values.number("r") == 0.95
    desk.press(pygame.K_RIGHT, mod=pygame.KMOD_LSHIFT)
    assert desk.values.number("r") == 1.45
    desk.press(pygame.K_RETURN)
    desk.type("2")
    desk.press(pygame.K_TAB, mod=pygame.KMOD_LALT)
    assert desk.values.number("r") == 1.45
    desk.press(pygame.K_TAB)
    desk.type("9")
    desk.press(pygame.K_RETURN)
    assert (desk.values.number("r"), desk.values.number("radius")) == (2.0, 9.0)
    desk.press(pygame.K_ESCAPE, pygame.K_RIGHT)
    assert desk.values.number("radius") == 9.0
    desk.press(pygame.K_DOWN, pygame.K_DOWN, pygame.K_UP, pygame.K_RETURN)
    assert isinstance(desk.screen, OptionList)
    desk.press(pygame.K_ESCAPE, pygame.K_TAB)
    assert desk.side._focus is not None
    desk.click((5, 300))
    assert desk.side._focus is None, "a click on the picture gives the keys back, too"


@pytest.mark.usefixtures("unseen")
def test_a_held_arrow_moves_a_slider_on(desk):
    """It repeats until it comes up; a slider that has reached the end of its range stays there, without a note."""
    while desk.side._focus is None or desk.positioned("half_width")[2:4] != desk.side._focus:
        desk.press(pygame.K_TAB)
    desk.hold(pygame.K_RIGHT)
    desk.wait(FRAME)
    assert desk.values.number("half_width") == 1.05
    for _ in range(40):
        desk.screen.advance(0.05, SIZE)
    assert desk.values.number("half_width") == 1.9
    assert desk.session.notes == ()
    desk.down.clear()  # its release is lost
    desk.wait(FRAME)
    desk.press(pygame.K_LEFT)
    for _ in range(40):
        desk.screen.advance(0.05, SIZE)
    assert desk.values.number("half_width") == 1.85


@pytest.mark.usefixtures("unseen")
def test_a_gamepad_uses_the_controls(desk):
    """The pad's cross moves the focus and steps, again and again while it is held; A accepts, B gives the keys back."""
    desk.pad(Action.DOWN, Action.DOWN, Action.DOWN)
    desk.press(pygame.K_LEFT, mod=pygame.KMOD_LSHIFT)
    desk.pad(Action.RIGHT)
    assert desk.values.point("ball").real == 9.31
    desk.pad(Action.RIGHT, held=True)
    for _ in range(20):
        desk.wait_once(0.1)
    moved = desk.values.point("ball")
    assert moved.real > 9.35
    desk.screen.answer(Released(Action.RIGHT, desk.side._held[0].position), SIZE)
    desk.wait_once(1.0)
    assert desk.values.point("ball") == moved
    desk.pad(Action.SERVE)
    desk.choose("7")
    desk.choose("Done")
    assert desk.values.point("ball").real == 7.0
    desk.pad(Action.UP, Action.UP, Action.UP)
    assert focused_item(desk.side._form_layout(SIZE), desk.side._focus).item.label == "Colours"
    theme = desk.shared.theme
    desk.pad(Action.SERVE)
    assert desk.shared.theme is not theme
    desk.pad(Action.TIP)
    assert focused_item(desk.side._form_layout(SIZE), desk.side._focus).item.label == "Help"
    desk.pad(Action.BACK)
    assert isinstance(desk.screen, Lab)
    assert desk.side._focus is None


@pytest.mark.usefixtures("unseen")
def test_a_gamepad_gives_commands(desk, run):
    """Left and right step, held they repeat; A runs and pauses, shoulders turn to another scene, View helps, B leaves."""
    desk.screen._session = session.toggled(run)
    desk.pad(Action.RIGHT, Action.RIGHT, Action.LEFT)
    assert desk.session.tick == 1
    desk.pad(Action.RIGHT, held=True)
    for _ in range(20):
        desk.wait_once(0.1)
    assert desk.session.tick > 10
    desk.pad(Action.SERVE)
    assert desk.session.playing
    desk.pad(Action.STEP)
    first = desk.session.scene.name
    desk.pad(Action.STEP, Action.STEP_BACK)
    assert desk.session.scene.name == first
    desk.pad(Action.HELP)
    assert isinstance(desk.screen, KeyHelp)
    desk.pad(Action.BACK)
    desk.screen.present()
    scale = desk.screen._scale
    desk.pad(Action.UP)
    assert desk.screen._scale == scale + 1
    desk.pad(Action.BACK)
    assert desk.screen is None


def test_buttons_do_what_their_keys_do_and_say_which(desk):
    """The button for the next scene opens another scene; while the mouse is on one, words name its key."""
    before = desk.session.scene.name
    desk.click_on(">")
    assert desk.session.scene.name != before
    positioned = desk.positioned("Help")
    assert positioned.item.tip.endswith("(H  F1)")
    desk.move(positioned.box.center)
    desk.wait(FRAME)
    assert desk.side.draw(desk.window.get_surface()) is None, "they stand where the small print was"
    desk.move((5, 300))
    desk.wait(FRAME)
    assert desk.side.draw(desk.window.get_surface()) is not None


def test_every_change_is_seen_at_once(desk):
    """The picture from memory is replaced whenever one that is drawn anew looks otherwise."""
    surface, before = desk.window.get_surface(), b""
    changes = (
        lambda: desk.type_into("r", "1.2"),
        lambda: desk.click(desk.slider("radius").field.center),
        lambda: desk.type("7"),
        lambda: desk.press(pygame.K_ESCAPE, pygame.K_7),
        lambda: desk.press(pygame.K_TAB),
        lambda: desk.press(pygame.K_TAB),
        lambda: desk.press(pygame.K_t),
        lambda: desk.press(pygame.K_RIGHTBRACKET),
    )
    for change in changes:
        change()
        shown = pygame.image.tobytes(surface, "RGB")
        desk.side._drawn = None
        desk.screen.draw(surface)
        assert shown == pygame.image.tobytes(surface, "RGB") != before
        before = shown


def test_what_does_not_fit_scrolls():
    """In a low window the wheel shows the numbers further down; the buttons stay."""
    desk = LabDesk("own-arena", (800, 600))
    items = [desk.positioned(name).box for name in ("r_g", "Help")]
    desk.wheel(items[0].center, -1)
    moved = [desk.positioned(name).box for name in ("r_g", "Help")]
    assert moved[0].top < items[0].top
    assert moved[1] == items[1]
    desk.wheel((100, 300), -1)
    assert desk.positioned("r_g").box == moved[0]
    while desk.side._focus is None or desk.positioned("r_g")[2:4] != desk.side._focus:
        desk.press(pygame.K_TAB)
    assert desk.side._scroll == 0.0, "what the first number means is seen, too"
    desk.shared.settings = desk.shared.settings._replace(text_size=200)
    desk.press(pygame.K_LEFTBRACKET)
    desk.wheel(items[0].center, -1)
    assert desk.side._scroll > 0.0
    desk.press(pygame.K_RIGHTBRACKET)
    assert desk.side._scroll == 0.0
    desk.close()


@pytest.mark.parametrize("text", [1.0, 2.0])
@pytest.mark.parametrize("size", [(640, 480), (800, 600), (1280, 800), (3840, 2160), (900, 1600)])
def test_the_controls_fit_their_side(size, text):
    """In every common window they end above the small print, some of what scrolls is seen, and no word is cut off.

    They are not pushed together too much. Words are written smaller where they would not fit: a little; in letters of twice
    the size by 43 % at most.
    """
    app, type_, layout = shared(), Type(), layout_of(size, text=text)
    app.settings = app.settings._replace(text_size=round(100 * text))
    smallest = 0.95 if text == 1.0 else 0.57
    shown = [LabControls(session.fresh(scene, None), SHOWN, frozenset()) for scene in scenes()]
    side = LabSidePanel(app, None, None, layout, shown[0])
    assert side.unit(size) == pytest.approx(0.87 * text * layout.unit)
    for seen in shown:
        side.show(layout, seen)
        form, unit = side._form_layout(size), side.unit(size)
        lines = "state hash", seen.session.line
        assert form.tip.top + small_print_height(type_, layout, lines) <= max(size[1], 480)
        assert form.over == 0 or form.body.height > 7.0 * unit
        assert all([positioned.box.height > 1.4 * unit for positioned in form.items if positioned.item.focusable])
        for positioned in form.items if size != (640, 480) else ():
            words, size_, taken = said(positioned.item, positioned.box.height / unit)
            wide = type_.rendered(words, unit * size_ * smallest, (0, 0, 0)).get_width() if words else 0
            assert wide + taken * unit <= positioned.box.width + 1, positioned.item


def said(item, height):
    """What an item says, in letters of which size, and how much of its width is taken otherwise, in units."""
    match item:
        case LabelItem() if height > 1.5:
            return max(item.text, item.note, key=len), 1.1, 0.0
        case LabelItem():
            return item.text + item.note, 1.1 * (0.95 if item.note else 1.0), 0.7 if item.note else 0.0
        case ButtonItem():
            return item.label, 1.15, 0.6
        case Switch():
            return item.label, 1.15, 0.7 + 0.6 + 1.9 + 0.7
    return "", 1.0, 0.0
