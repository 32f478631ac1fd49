"""A gamepad, as a player has it in hand: SDL's own virtual one."""

import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.input.hands import Hands
from game.input.players import Players
from game.input.view import SOLID
from game.lab.registry import scenes
from game.lab.session import session
from game.lab.window.screen import Lab
from game.rules import Phase, paddle_ring
from game.screens.play.screen import PlayScreen
from game.screens.title import Title
from game.screens.toolkit.menu import Menu
from tests.support.windows.dummy_window import FRAME, Desk, shared
from tests.support.windows.virtual_pad import VirtualPad, library

X, Y = pygame.CONTROLLER_AXIS_LEFTX, pygame.CONTROLLER_AXIS_LEFTY
SDL = library()
pytestmark = pytest.mark.skipif(SDL is None, reason="no SDL library to plug a virtual gamepad into")


@pytest.fixture
def desk():
    """The app at its title, its gamepads heard."""
    state = shared()
    found = Desk(state, Title(state), (240, 150))
    state.devices.pads.listen()
    found.wait(FRAME)
    yield found
    state.devices.pads.close()
    found.close()


@pytest.fixture
def pad(desk):
    """A gamepad, plugged in while the game runs."""
    found = VirtualPad(SDL)
    desk.wait(3 * FRAME)
    yield found
    found.pull_out()


def tap(desk, pad, button):
    """Press and release a button, frames apart."""
    pad.press(button)
    desk.wait(2 * FRAME)
    pad.release(button)
    desk.wait(2 * FRAME)


def choose(desk, pad, label):
    """Go down to a button and accept it."""
    for _ in range(20):
        items = desk.screen._form_layout(desk.window.size).items
        if any(
            (positioned.row, positioned.column) == desk.screen._focus and positioned.item.label == label for positioned in items
        ):
            break
        tap(desk, pad, pygame.CONTROLLER_BUTTON_DPAD_DOWN)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)


def game_of(desk):
    """The game being played."""
    assert isinstance(desk.screen, PlayScreen)
    return desk.screen._ticked.game


def test_a_gamepad_alone_chooses_serves_steers_pauses_and_leaves(desk, pad):
    """The paddle stands where the stick points, from the title through a game and its pause menu to the title and out."""
    assert "Gamepad" in desk.shared.toast.text
    tap(desk, pad, pygame.CONTROLLER_BUTTON_DPAD_DOWN)
    assert desk.screen._focus.row == 1
    pad.push(Y, -1.0)
    desk.wait(3 * FRAME)
    pad.push(Y, 0.0)
    desk.wait(3 * FRAME)
    assert desk.screen._focus.row == 0
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    for angle in (30.0, 135.0, 260.0):
        pad.push(X, math.cos(math.radians(angle)))
        pad.push(Y, -math.sin(math.radians(angle)))
        desk.wait(1.2)
        paddles = paddle_ring(game_of(desk))
        apart = [abs(math.remainder(paddles.angle(slot) - math.radians(angle), math.tau)) for slot in range(paddles.count)]
        assert min(apart) < math.radians(0.1)
    pad.push(X, 0.0)
    pad.push(Y, 0.0)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    assert game_of(desk).phase == Phase.PLAYING
    tap(desk, pad, pygame.CONTROLLER_BUTTON_START)
    assert isinstance(desk.screen, Menu)
    choose(desk, pad, "Main menu")
    assert isinstance(desk.screen, Title)
    choose(desk, pad, "Quit")
    assert desk.screen is None


def test_triggers_turn_as_fast_as_they_are_squeezed(desk, pad):
    """The paddles' spin is the trigger's share of their top speed, to the right counter-clockwise; the keys' is all of it."""
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    top = math.radians(game_of(desk).level.paddles.top_speed)
    for axis, sign in ((pygame.CONTROLLER_AXIS_TRIGGERRIGHT, 1.0), (pygame.CONTROLLER_AXIS_TRIGGERLEFT, -1.0)):
        for share in (0.3, 0.6, 1.0):
            pad.push(axis, 2.0 * (0.08 + share * 0.92) - 1.0)
            desk.wait(2 * FRAME)
            before = paddle_ring(game_of(desk)).angle(0)
            desk.wait(0.5)
            turned = math.remainder(paddle_ring(game_of(desk)).angle(0) - before, math.tau)
            assert turned / 0.5 == pytest.approx(sign * share * top, rel=0.01)
        pad.push(axis, -1.0)
        desk.wait(0.3)
        assert paddle_ring(game_of(desk)).spin == 0.0


def test_a_gamepad_pulled_out_pauses_the_game_that_it_plays(desk, pad):
    """Nothing that was held on it is held any more; one that nobody plays with may go."""
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    pad.press(pygame.CONTROLLER_BUTTON_DPAD_LEFT)
    desk.wait(0.2)
    screen = desk.screen
    assert screen._hands.held
    pad.pull_out()
    desk.wait(3 * FRAME)
    assert isinstance(desk.screen, Menu)
    assert screen._hands._replace(turned=1) == Hands()
    other = VirtualPad(SDL)
    desk.wait(3 * FRAME)
    tap(desk, other, pygame.CONTROLLER_BUTTON_A)
    desk.press(pygame.K_SPACE)
    other.pull_out()
    desk.wait(3 * FRAME)
    assert isinstance(desk.screen, PlayScreen)


def test_a_second_gamepad_is_the_second_players(desk, pad):
    """Where two play together it steers whenever the first asks for nothing; its button serves, too."""
    desk.shared.players = Players.TOGETHER
    other = VirtualPad(SDL)
    desk.wait(3 * FRAME)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    other.push(pygame.CONTROLLER_AXIS_TRIGGERRIGHT, 1.0)
    desk.wait(0.2)
    assert paddle_ring(game_of(desk)).spin > 0.0
    assert desk.screen._hands.spin == 0.0
    pad.push(pygame.CONTROLLER_AXIS_TRIGGERLEFT, 1.0)
    desk.wait(0.2)
    assert paddle_ring(game_of(desk)).spin < 0.0
    pad.push(pygame.CONTROLLER_AXIS_TRIGGERLEFT, -1.0)
    other.push(pygame.CONTROLLER_AXIS_TRIGGERRIGHT, -1.0)
    tap(desk, other, pygame.CONTROLLER_BUTTON_A)
    assert game_of(desk).phase == Phase.PLAYING
    other.pull_out()


def test_a_gamepad_leaves_the_lab(desk, pad):
    """Its cross gives the keys to the lab's controls, B takes them back, and again B leaves the lab."""
    under = desk.screen
    desk.screen = Lab(desk.shared, session.fresh(scenes()[0], None), under)
    desk.wait(FRAME)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_DPAD_DOWN)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_B)
    assert isinstance(desk.screen, Lab)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_B)
    assert desk.screen is under


def test_the_right_stick_moves_the_camera_in_3d_but_while_it_aims(desk, pad):
    """Before the serve it aims; in play it orbits as long as it is pushed, and the stick's button brings the camera nearer."""
    desk.shared.view = SOLID
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    pad.push(pygame.CONTROLLER_AXIS_RIGHTX, 1.0)
    desk.wait(0.2)
    assert desk.screen._hands.aiming == 1.0
    assert desk.shared.view == SOLID
    pad.push(pygame.CONTROLLER_AXIS_RIGHTX, 0.0)
    tap(desk, pad, pygame.CONTROLLER_BUTTON_A)
    assert game_of(desk).phase == Phase.PLAYING
    pad.push(pygame.CONTROLLER_AXIS_RIGHTX, 1.0)
    pad.press(pygame.CONTROLLER_BUTTON_RIGHTSTICK)
    desk.wait(0.2)
    pad.push(pygame.CONTROLLER_AXIS_RIGHTX, 0.0)
    pad.release(pygame.CONTROLLER_BUTTON_RIGHTSTICK)
    desk.wait(3 * FRAME)
    turned = desk.shared.view
    assert turned.azimuth > math.radians(10.0)
    assert turned.zoom > 1.05
    desk.wait(0.2)
    assert desk.shared.view == turned
    pad.push(pygame.CONTROLLER_AXIS_RIGHTX, 1.0)
    desk.wait(2 * FRAME)
    desk.screen.went_on()  # from the results of a level, which have heard that the stick was let go
    turned = desk.shared.view
    desk.wait(0.2)
    assert desk.shared.view == turned
