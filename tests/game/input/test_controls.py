"""Keys and mouse to controls."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.drawing.camera import Camera
from game.input.signals import KEYS, Action, Clicked, FocusLost, Hands, Moved, Pressed, Released, translated
from game.rules import POINTER_STEPS, Controls

CAMERA = Camera(400 + 300j, 30.0)
ONE = 1 + 1j


def key(code, kind=pygame.KEYDOWN, mod=0):
    """A key's event."""
    return pygame.Event(kind, key=code, mod=mod)


def after(*signals):
    """Hands after some signals."""
    hands = Hands()
    for signal in signals:
        hands = hands.after(signal)
    return hands


@pytest.mark.parametrize("code", [pygame.K_LEFT, pygame.K_a])
def test_left_turns_clockwise(code):
    """The paddle at the bottom goes to the left."""
    assert after(translated(key(code), ONE)).controls(CAMERA) == Controls(turn=-1)


@pytest.mark.parametrize("code", [pygame.K_RIGHT, pygame.K_d])
def test_right_turns_counter_clockwise(code):
    """The paddle at the bottom goes to the right."""
    assert after(translated(key(code), ONE)).controls(CAMERA) == Controls(turn=1)


def test_the_last_key_pressed_wins_until_it_is_released():
    """Both directions held: the newer counts; released, the older counts again."""
    both = after(Pressed(Action.LEFT), Pressed(Action.RIGHT))
    assert both.controls(CAMERA).turn == 1
    assert both.after(Released(Action.RIGHT)).controls(CAMERA).turn == -1
    assert both.after(Released(Action.LEFT)).controls(CAMERA).turn == 1
    assert both.after(Released(Action.RIGHT)).after(Released(Action.LEFT)).controls(CAMERA) == Controls()


@pytest.mark.parametrize(("place", "turn"), [(500 + 300j, 0.0), (400 + 200j, 0.25), (300 + 300j, 0.5), (400 + 400j, 0.75)])
def test_the_pointer_is_a_bearing(place, turn):
    """Right, up, left, down of the centre are the four quarters of a turn."""
    assert after(Moved(place, held=False)).controls(CAMERA) == Controls(pointer=int(turn * POINTER_STEPS))


def test_keys_take_over_from_the_mouse_until_it_moves_again():
    """A turning key silences the pointer, also after its release; the next motion brings it back."""
    hands = after(Moved(500 + 300j, held=False), Pressed(Action.LEFT))
    assert hands.controls(CAMERA) == Controls(turn=-1)
    assert hands.after(Moved(400 + 200j, held=False)).controls(CAMERA) == Controls(turn=-1)
    released = hands.after(Released(Action.LEFT))
    assert released.controls(CAMERA) == Controls()
    assert released.after(Moved(500 + 300j, held=False)).controls(CAMERA) == Controls(pointer=0)


def test_a_pointer_on_the_centre_points_nowhere():
    """There every bearing is as good as another."""
    assert after(Moved(CAMERA.centre, held=False)).controls(CAMERA) == Controls()


@pytest.mark.parametrize("signal", [Pressed(Action.SERVE), Clicked(10 + 10j)])
def test_space_and_click_serve(signal):
    """Either asks for the serve."""
    assert after(signal).controls(CAMERA).serve


def test_losing_the_focus_lets_everything_go():
    """Keys whose release will not be heard count as released."""
    assert after(Pressed(Action.LEFT), Pressed(Action.SERVE), FocusLost()) == Hands()


def test_events_become_signals():
    """Keys by the table, the mouse in pixels of the surface, focus; everything else means nothing."""
    assert translated(key(pygame.K_p), ONE) == Pressed(Action.PAUSE)
    assert translated(key(pygame.K_p, pygame.KEYUP), ONE) == Released(Action.PAUSE)
    assert translated(key(pygame.K_RETURN, mod=pygame.KMOD_LALT), ONE) == Pressed(Action.FULL_SCREEN)
    assert translated(key(pygame.K_F5), ONE) is None
    motion = pygame.Event(pygame.MOUSEMOTION, pos=(10, 20), rel=(1, 0), buttons=(1, 0, 0))
    assert translated(motion, 2 + 3j) == Moved(20 + 60j, held=True)
    assert translated(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(1, 2), button=1), ONE) == Clicked(1 + 2j)
    assert translated(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(1, 2), button=3), ONE) is None
    assert translated(pygame.Event(pygame.WINDOWFOCUSLOST), ONE) == FocusLost()
    assert translated(pygame.Event(pygame.WINDOWSHOWN), ONE) is None


def test_every_action_has_a_key():
    """Nothing can only be done by nobody."""
    assert set(KEYS.values()) == set(Action)
