"""A touch screen alone: from the title through a level and back, with one finger."""

import math

import pygame
import pytest

from game.drawing.camera import layout
from game.input.view import SOLID
from game.rules import Phase, paddle_ring
from game.screens.menus.settings.panel import SettingsPanel
from game.screens.play import buttons as play_buttons
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.items.slider import Slider
from tests.support.windows.dummy_window import FRAME, Desk, shared

SIZE = (480, 300)


@pytest.fixture
def desk():
    """The app at its title."""
    state = shared()
    found = Desk(state, Title(state), SIZE)
    found.wait(FRAME)
    yield found
    found.close()


def finger(desk, kind, pixel):
    """One event of the finger, at a pixel."""
    x, y = pixel[0] / SIZE[0], pixel[1] / SIZE[1]
    pygame.event.post(pygame.Event(kind, touch_id=3, finger_id=0, x=x, y=y, dx=0.0, dy=0.0))
    desk.wait(FRAME)


def tap(desk, pixel):
    """Touch and lift."""
    finger(desk, pygame.FINGERDOWN, pixel)
    finger(desk, pygame.FINGERUP, pixel)


def positioned(desk, label):
    """The item with a label, of what is on the panel."""
    items = desk.screen._form_layout(SIZE).items
    return next(one for one in items if getattr(one.item, "label", "") == label)


def test_one_finger_plays_sets_and_leaves(desk):
    """A drag moves the paddle and serves nothing; a tap serves; the signs beside the arena are tapped, a slider is dragged."""
    tap(desk, positioned(desk, "Play").box.center)
    assert isinstance(desk.screen, PlayScreen)
    game = desk.screen._ticked.game
    camera = layout(SIZE, game.level.ground_radius).camera
    at = [camera.project(0.93 * game.level.ground_radius * 1j * turn) for turn in (-1, -1 + 0.4j)]
    finger(desk, pygame.FINGERDOWN, (at[0].real, at[0].imag))
    finger(desk, pygame.FINGERMOTION, (at[1].real, at[1].imag))
    desk.wait(0.8)
    finger(desk, pygame.FINGERUP, (at[1].real, at[1].imag))
    game = desk.screen._ticked.game
    wanted = math.atan2(-1.0, -0.4)
    paddles = paddle_ring(game)
    assert min(abs(math.remainder(paddles.angle(k) - wanted, math.tau)) for k in range(paddles.count)) < 0.02
    assert game.phase == Phase.SERVING
    tap(desk, (SIZE[0] // 2, SIZE[1] // 2))
    assert desk.screen._ticked.game.phase == Phase.PLAYING
    play = desk.screen
    tap(desk, play_buttons.button_boxes(play._layout(SIZE))[2].center)
    assert isinstance(desk.screen, SettingsPanel)
    desk.screen.open_tab(2)
    desk.wait(FRAME)
    volume = next(one for one in desk.screen._form_layout(SIZE).items if isinstance(one.item, Slider))
    bar = volume.item.bar(volume.box, desk.screen.unit(SIZE))
    finger(desk, pygame.FINGERDOWN, (bar.right, bar.centery))
    finger(desk, pygame.FINGERMOTION, (bar.left + 1, bar.centery))
    finger(desk, pygame.FINGERUP, (bar.left + 1, bar.centery))
    assert volume.item.level > 0.1
    changed = next(one for one in desk.screen._form_layout(SIZE).items if isinstance(one.item, Slider))
    assert changed.item.level == pytest.approx(0.0, abs=0.1)
    tap(desk, desk.screen._form_layout(SIZE).close.center)
    assert desk.screen is play
    tap(desk, play_buttons.button_boxes(play._layout(SIZE))[0].center)
    tap(desk, positioned(desk, "Main menu").box.center)
    tap(desk, positioned(desk, "Quit").box.center)
    assert desk.screen is None


@pytest.mark.parametrize("size", [(800, 600), (1280, 800), (3840, 2160), (600, 800)])
@pytest.mark.parametrize("buttons", [play_buttons.PLAYING, play_buttons.WATCHING])
def test_the_buttons_hide_nothing_of_the_arena(size, buttons):
    """Neither from above nor in 3D do they cover the ground on which the paddles turn."""
    flat = layout(size, 10.0)
    for seen in (flat, SOLID.seen(flat)):
        for box in play_buttons.button_boxes(seen, buttons):
            corners = [complex(x, y) for x in (box.left, box.right) for y in (box.top, box.bottom)]
            assert min([abs(seen.camera.unproject(corner)) for corner in corners]) > 10.0
