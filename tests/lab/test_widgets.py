"""The lab's sliders, fields, boxes, buttons and lists, worked by posted events on the dummy driver."""

import pygame
import pygame_gui
import pytest

from game.drawing.palette import DARK
from game.lab.kit.parameters import written
from game.lab.kit.picture import Toggle
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.session.commands import Command
from game.lab.window.layout import layout_of
from game.lab.window.widgets import Side
from tests.support.dummy_window import FRAME, Desk, shared
from tests.support.lab_desk import SIZE


def test_a_number_is_typed_exactly(desk):
    """A typed number is set with every digit; letters are refused; a number out of range is set to the border."""
    field = desk.row("half_angle").field
    desk.type_into(field, "33.123456789012")
    assert desk.values.number("half_angle") == 33.123456789012
    desk.type_into(field, "abc")
    assert desk.values.number("half_angle") == 33.123456789012
    assert desk.session.notes == ("φ_p: 'abc' is not a number",)
    desk.type_into(field, "nan")
    assert desk.session.notes == ("φ_p cannot be nan°: it stays 33.123456789012°",)
    desk.type_into(field, "999")
    assert desk.values.number("half_angle") == 180.0
    assert desk.session.notes == ("φ_p = 999° is beyond its range: set to 180°",)
    desk.type_into(desk.row("ball", 1).field, "1.25")
    assert desk.values.point("ball") == 9.4 + 1.25j


def test_keys_belong_to_the_field_that_is_typed_into(desk):
    """While a field is typed into, letters are no commands, and the first Esc only leaves the field."""
    theme = desk.shared.theme
    pixel = desk.row("r").field.rect.center
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=1))
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=pixel, button=1))
    desk.wait(FRAME)
    desk.press(pygame.K_t, pygame.K_ESCAPE)
    assert desk.shared.theme is theme
    assert desk.screen is not None
    desk.press(pygame.K_t)
    assert desk.shared.theme is not theme
    desk.press(pygame.K_ESCAPE)
    assert desk.screen is None


def test_sliders_follow_the_values_and_move_them(desk):
    """A dragged slider's value is rounded to the parameter's step."""
    row = desk.row("half_angle")
    desk.type_into(row.field, "90")
    assert row.slider.get_current_value() == 90.0
    row.slider.set_current_value(45.13)
    pygame.event.post(pygame.Event(pygame_gui.UI_HORIZONTAL_SLIDER_MOVED, ui_element=row.slider))
    desk.wait(2 * FRAME)
    assert desk.values.number("half_angle") == 45.0
    assert row.field.get_text() == "45"


@pytest.mark.parametrize("share", [0.03, 0.2, 0.5, 0.97])
def test_a_press_beside_a_sliders_knob_brings_it_there(desk, share):
    """A press beside the knob moves it to the pointer and takes hold of it; a press on the knob moves nothing."""
    row = desk.row("half_angle")
    desk.type_into(row.field, "70" if share < 0.5 else "20")
    slider = row.slider
    pixel = slider.rect.left + round(share * slider.rect.width), slider.rect.centery
    assert not slider.sliding_button.rect.collidepoint(pixel)
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=1))
    desk.wait(FRAME)
    assert slider.sliding_button.held
    pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=pixel, button=1))
    desk.wait(2 * FRAME)
    knob, now = slider.sliding_button.rect, desk.values.number("half_angle")
    half = knob.width // 2
    assert abs(knob.centerx - min(max(pixel[0], slider.rect.left + half), slider.rect.right - half)) <= 3
    assert slider.current_value == now
    desk.click_on(slider.sliding_button)
    assert desk.values.number("half_angle") == now


def test_an_open_list_keeps_what_is_below_it_from_moving(desk):
    """A press on a line of an open list does not move a slider under it."""
    widgets = desk.screen._widgets(SIZE)
    desk.click_on(widgets._list.current_state.open_button)
    assert widgets.busy
    before = dict(desk.session.given.values)
    for row in widgets._rows:
        track, knob = row.slider.rect, row.slider.sliding_button.rect
        pixel = track.right - 3 if knob.centerx < track.centerx else track.left + 3, track.centery
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=pixel, button=1))
    desk.wait(FRAME)
    assert dict(desk.session.given.values) == before


def test_toggles_by_key_and_by_box(desk):
    """A key and a click each change a toggle once, and the check box shows it."""
    box = next(box for box, toggle in desk.screen._widgets(SIZE)._boxes.items() if toggle is Toggle.PYMUNK)
    for on in (True, False, True):
        desk.press(pygame.K_7)
        desk.wait(5 * FRAME)
        assert (Toggle.PYMUNK in desk.screen._shown) is on
        assert box.get_state() is on
    for shown in (False, True):
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=box.rect.center, button=1))
        pygame.event.post(pygame.Event(pygame.MOUSEBUTTONUP, pos=box.rect.center, button=1))
        desk.wait(5 * FRAME)
        assert (Toggle.PYMUNK in desk.screen._shown) is shown


def test_buttons_do_what_their_keys_do(desk):
    """The button for the next scene opens another scene, as its key does."""
    side = desk.screen._widgets(SIZE)
    button = next(button for button, command in side._commands.items() if command is Command.NEXT)
    before = desk.session.scene.name
    side._manager.mouse_position = button.rect.center
    desk.click_on(button)
    assert desk.session.scene.name != before


@pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)
@pytest.mark.parametrize("size", [(640, 480), (800, 600), (1280, 800), (3840, 2160), (900, 1600)])
def test_the_widgets_fit_their_side(scene, size):
    """In every common window the widgets end above the small print, and no parameter's meaning is cut off."""
    app = shared()
    found = Desk(app, None, (320, 240))
    layout = layout_of(size)
    side = Side(layout, DARK, app.type, session.fresh(scene, None))
    assert side.bottom + layout.unit * 4.0 < max(size[1], 480) or size == (640, 480)
    for parameter, box in side._names if size != (640, 480) else ():
        value = f"{parameter.label} = {written(parameter, parameter.default)}"
        letters = [app.type.rendered(text, layout.unit * 0.95, (0, 0, 0)).get_width() for text in (value, parameter.meaning)]
        assert sum(letters) + layout.unit * 0.7 <= box.width, parameter.meaning
    found.close()
