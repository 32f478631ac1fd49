"""Keys and mouse to controls."""

import cmath
import itertools
import math
import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest

from game.drawing.camera import Camera
from game.input.devices import Devices
from game.input.events import keyboard_state, translated
from game.input.hands import Hands, controls_of_two
from game.input.keys import BINDINGS, Action, Binding, KeyTable
from game.input.scancodes import position_of
from game.input.signals import (
    Clicked,
    Dragged,
    FocusLost,
    KeyboardState,
    Moved,
    PadChanged,
    Pointed,
    Pressed,
    Released,
    Signal,
    Squeezed,
    Zoomed,
)
from game.input.view import ZOOM_STEP
from game.levels import classic
from game.rules import POINTER_STEPS, Controls, Phase, Ruleset, new_game, paddle_ring, tick

CAMERA = Camera(400 + 300j, 30.0)
WAITING = new_game(classic(), 1)
GAME = WAITING._replace(phase=Phase.PLAYING)
ONE = 1 + 1j
ARROW_LEFT, ARROW_RIGHT = pygame.KSCAN_LEFT, pygame.KSCAN_RIGHT


def key(code, kind=pygame.KEYDOWN, mod=0, position=None):
    """A key's event. position: as on the US layout, unless given."""
    return pygame.Event(kind, key=code, mod=mod, scancode=position_of(code) if position is None else position)


def after(*signals):
    """Hands after some signals."""
    hands = Hands()
    for signal in signals:
        hands = hands.after(signal)
    return hands


@pytest.mark.parametrize("code", [pygame.K_LEFT, pygame.K_a])
def test_left_turns_clockwise(code):
    """The paddle at the bottom goes to the left."""
    assert after(translated(key(code), ONE)).controls(CAMERA, GAME) == Controls(turn=-1)


@pytest.mark.parametrize("code", [pygame.K_RIGHT, pygame.K_d])
def test_right_turns_counter_clockwise(code):
    """The paddle at the bottom goes to the right."""
    assert after(translated(key(code), ONE)).controls(CAMERA, GAME) == Controls(turn=1)


LAYOUTS = {
    "Russian": {"A": "ф", "D": "в", "P": "з", "H": "р", "O": "щ", "W": "ц", "S": "ы", ".": "ю"},  # noqa: RUF001
    "Greek": {"A": "α", "D": "δ", "P": "π", "H": "η", "O": "ο", "W": "ς", "S": "σ", ".": "."},  # noqa: RUF001
    "French": {"A": "q", "D": "d", "P": "p", "H": "h", "O": "o", "W": "z", "S": "s", "1": "&"},
}
MEANINGS = {
    "A": Action.LEFT,
    "D": Action.RIGHT,
    "P": Action.PAUSE,
    "H": Action.HELP,
    "O": Action.SETTINGS,
    "W": Action.UP,
    "S": Action.DOWN,
    ".": Action.STEP,
    "1": Action.FLAT,
}


@pytest.mark.parametrize(
    ("layout", "label"), [(layout, label) for layout, written in LAYOUTS.items() for label in written], ids=lambda x: x
)
def test_keys_mean_the_same_on_other_layouts(layout, label):
    """The key at the US layout's A steers whatever is written there, and where no Latin letter is, commands go by position."""
    position = position_of(ord(label.lower()))
    signal = translated(key(ord(LAYOUTS[layout][label]), position=position), ONE)
    assert signal == Pressed(MEANINGS[label], position)


def test_commands_go_by_what_is_written():
    """On a French keyboard the key with M on it mutes, the comma steps back, and A, where the US layout has Q, does nothing."""
    assert translated(key(pygame.K_m, position=pygame.KSCAN_SEMICOLON), ONE).action is Action.MUTE
    assert translated(key(pygame.K_COMMA, position=pygame.KSCAN_M), ONE).action is Action.STEP_BACK
    assert translated(key(pygame.K_a, position=pygame.KSCAN_Q), ONE) is None


def test_a_key_without_a_position_goes_by_its_code():
    """Where the system does not know where a key is, it is taken for the US layout's."""
    assert translated(key(pygame.K_a, position=0), ONE) == Pressed(Action.LEFT, pygame.KSCAN_A)
    bare = pygame.Event(pygame.KEYDOWN, key=pygame.K_p, mod=0)
    assert translated(bare, ONE) == Pressed(Action.PAUSE, pygame.KSCAN_P)


def test_another_table_has_other_keys():
    """Keys are rebound by giving the table other bindings."""
    table = KeyTable([*[one for one in BINDINGS if one.action is not Action.LEFT], Binding(Action.LEFT, (pygame.K_j,))])
    assert table.action(pygame.KSCAN_J, pygame.K_j) is Action.LEFT
    assert table.action(pygame.KSCAN_A, pygame.K_a) is None
    assert table.binding(Action.LEFT).codes == (pygame.K_j,)
    with pytest.raises(KeyError):
        KeyTable([]).binding(Action.LEFT)


def test_the_last_key_pressed_wins_until_it_is_released():
    """Both directions held: the newer counts; released, the older counts again."""
    left, right = (Action.LEFT, ARROW_LEFT), (Action.RIGHT, ARROW_RIGHT)
    both = after(Pressed(*left), Pressed(*right))
    assert both.controls(CAMERA, GAME).turn == 1
    assert both.after(Released(*right)).controls(CAMERA, GAME).turn == -1
    assert both.after(Released(*left)).controls(CAMERA, GAME).turn == 1
    assert both.after(Released(*right)).after(Released(*left)).controls(CAMERA, GAME) == Controls()


def test_of_two_keys_for_one_action_each_counts():
    """The left arrow held, A pressed and released: the paddles go on; the arrow released, they stop."""
    both = after(Pressed(Action.LEFT, ARROW_LEFT), Pressed(Action.LEFT, pygame.KSCAN_A))
    one = both.after(Released(Action.LEFT, pygame.KSCAN_A))
    assert one.controls(CAMERA, GAME).turn == -1
    assert one.after(Released(Action.LEFT, ARROW_LEFT)).controls(CAMERA, GAME).turn == 0


def test_a_release_that_was_lost_is_noticed():
    """A key that is held by the events but up by the keyboard's state is let go; one that is down stays held."""
    hands = after(Pressed(Action.LEFT, ARROW_LEFT), Pressed(Action.RIGHT, ARROW_RIGHT))
    assert hands.after(KeyboardState(frozenset({ARROW_LEFT, ARROW_RIGHT}))) == hands
    assert hands.after(KeyboardState(frozenset({ARROW_LEFT}))).controls(CAMERA, GAME).turn == -1
    assert hands.after(KeyboardState(frozenset())).controls(CAMERA, GAME).turn == 0


def test_the_keyboards_state_is_in_positions(monkeypatch):
    """Not in codes, which are what the library's own index takes."""
    down = {ARROW_LEFT, pygame.KSCAN_A, pygame.KSCAN_PERIOD}
    states = pygame.key.ScancodeWrapper(position in down for position in range(512))
    monkeypatch.setattr(pygame.key, "get_pressed", lambda: states)
    assert keyboard_state() == KeyboardState(frozenset(down))


@pytest.mark.parametrize(("pixel", "turn"), [(500 + 300j, 0.0), (400 + 200j, 0.25), (300 + 300j, 0.5), (400 + 400j, 0.75)])
def test_the_pointer_is_a_bearing(pixel, turn):
    """Right, up, left, down of the centre are the four quarters of a turn."""
    assert after(Moved(pixel, held=False)).controls(CAMERA, GAME) == Controls(pointer=int(turn * POINTER_STEPS))


def test_keys_take_over_from_the_mouse_until_it_moves_again():
    """A turning key silences the pointer, also after its release; the next motion brings it back."""
    hands = after(Moved(500 + 300j, held=False), Pressed(Action.LEFT))
    assert hands.controls(CAMERA, GAME) == Controls(turn=-1)
    assert hands.after(Moved(400 + 200j, held=False)).controls(CAMERA, GAME) == Controls(turn=-1)
    released = hands.after(Released(Action.LEFT))
    assert released.controls(CAMERA, GAME) == Controls()
    assert released.after(Moved(500 + 300j, held=False)).controls(CAMERA, GAME) == Controls(pointer=0)


def test_the_serve_is_aimed_at_the_mouse_or_by_the_right_stick():
    """Before the serve: the ball flies to where the mouse is, inside of the paddles, which it moves from beyond them."""
    ball = WAITING.arena.balls[0].position
    inside, outside = 3 + 1j, 9.9 + 0j
    aimed = after(Moved(CAMERA.project(inside), held=False)).controls(CAMERA, WAITING)
    assert aimed.pointer is None
    offset = cmath.phase((inside - ball) / cmath.rect(1.0, aimed.aim * math.tau / POINTER_STEPS))
    assert offset == pytest.approx(0.0, abs=math.tau / POINTER_STEPS)
    assert after(Moved(CAMERA.project(outside), held=False)).controls(CAMERA, WAITING) == Controls(pointer=0)
    both = after(Pointed(1 + 0j), Pointed(1j, aims=True))
    assert both.controls(CAMERA, WAITING) == Controls(pointer=0, aim=POINTER_STEPS // 4)
    assert both.controls(CAMERA, GAME) == Controls(pointer=0)
    assert after(Pressed(Action.LEFT, ARROW_LEFT)).controls(CAMERA, WAITING) == Controls(turn=-1)


def test_one_button_serves_and_reverses():
    """Any press: of a key, a button, on the screen; before the serve the paddles stand still."""
    hands, turns = Hands(), []
    assert hands.one_button_controls(WAITING) == Controls()
    presses = (Pressed(Action.SERVE), Clicked(1 + 1j), Pressed(Action.LEFT, ARROW_LEFT), Pressed(Action.UP, pygame.KSCAN_UP))
    for press in presses:
        hands = hands.after(press)
        assert hands.one_button_controls(WAITING).serve
        turns.append(math.copysign(1.0, paddle_ring(tick(GAME, hands.one_button_controls(GAME)).game).spin))
        hands = hands.after_tick()
        assert not hands.one_button_controls(WAITING).serve
    assert turns == [-1, 1, -1, 1]
    other = hands.after(Moved(3 + 3j, held=False)).after(Pressed(Action.MUTE))
    assert other.one_button_controls(GAME) == hands.one_button_controls(GAME)


def test_a_pointer_on_the_centre_points_nowhere():
    """There every bearing is as good as another."""
    assert after(Moved(CAMERA.centre, held=False)).controls(CAMERA, GAME) == Controls()


@pytest.mark.parametrize("signal", [Pressed(Action.SERVE), Clicked(10 + 10j)])
def test_space_and_click_serve(signal):
    """Either asks for the serve, once."""
    assert after(signal).controls(CAMERA, GAME).serve
    assert not after(signal).after_tick().controls(CAMERA, GAME).serve


def test_a_ball_is_given_up_once():
    """Whatever else is held."""
    for others in ((), (Pressed(Action.LEFT, ARROW_LEFT),)):
        hands = after(*others, Pressed(Action.GIVE_UP))
        assert hands.controls(CAMERA, GAME).give_up
        assert not hands.after_tick().controls(CAMERA, GAME).give_up


def test_losing_the_focus_lets_everything_go():
    """Keys whose release will not be heard count as released."""
    assert after(Pressed(Action.LEFT), Pressed(Action.SERVE), FocusLost()) == Hands()


def test_no_two_kinds_of_signal_are_equal():
    """Signals of different kinds differ, whatever they hold; of one kind they are equal when they hold the same."""
    action, one = Action.FULL_SCREEN, 1 + 0j
    signals = [
        Pressed(action),
        Released(action),
        KeyboardState(frozenset()),
        Moved(one, held=False),
        Clicked(one),
        Dragged(one),
        Zoomed(1.0),
        Pointed(one),
        Squeezed(1.0),
        PadChanged("one", there=True),
        FocusLost(),
    ]
    assert {type(signal) for signal in signals} == set(Signal.__args__)
    for first, second in itertools.combinations(signals, 2):
        assert first != second
    assert Pressed(action) == Pressed(action)
    assert Clicked(one) == Clicked(one)


def test_events_become_signals():
    """Keys by the table, the mouse in pixels of the surface, focus; everything else means nothing."""
    assert translated(key(pygame.K_p), ONE) == Pressed(Action.PAUSE, pygame.KSCAN_P)
    assert translated(key(pygame.K_p, pygame.KEYUP), ONE) == Released(Action.PAUSE, pygame.KSCAN_P)
    assert translated(key(pygame.K_RETURN, mod=pygame.KMOD_LALT), ONE).action is Action.FULL_SCREEN
    assert translated(key(pygame.K_F5), ONE) is None
    motion = pygame.Event(pygame.MOUSEMOTION, pos=(10, 20), rel=(1, 0), buttons=(1, 0, 0))
    assert translated(motion, 2 + 3j) == Moved(20 + 60j, held=True)
    assert translated(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(1, 2), button=1), ONE) == Clicked(1 + 2j)
    assert translated(pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(1, 2), button=3), ONE) is None
    assert translated(pygame.Event(pygame.WINDOWFOCUSLOST), ONE) == FocusLost()
    assert translated(pygame.Event(pygame.WINDOWSHOWN), ONE) is None


def finger(kind, at, number=1, device=5):
    """A finger's event. at: shares of the window's width and height."""
    return pygame.Event(kind, touch_id=device, finger_id=number, x=at[0], y=at[1], dx=0.0, dy=0.0)


def test_a_finger_points_and_clicks_where_it_stays():
    """It points as soon as it is down, clicks when it is lifted unless it moved, and of two fingers the newest points."""
    devices = Devices()

    def heard(*events):
        return [signal for event in events for signal in devices.signals(event, (800, 600), ONE)]

    down, motion, up = pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP
    assert heard(finger(down, (0.5, 0.5)), finger(motion, (0.505, 0.5))) == [
        Moved(400 + 300j, held=False),
        Moved(404 + 300j, held=False),
    ]
    assert heard(finger(up, (0.505, 0.5))) == [Clicked(404 + 300j)]
    heard(finger(down, (0.25, 0.5)))
    assert heard(finger(motion, (0.5, 0.5))) == [Moved(400 + 300j, held=True)]
    assert heard(finger(down, (0.75, 0.5), 2), finger(motion, (0.1, 0.1)), finger(up, (0.75, 0.5), 2)) == [
        Moved(600 + 300j, held=False),
        Clicked(600 + 300j),
    ]
    assert heard(finger(motion, (0.25, 0.5)), finger(up, (0.25, 0.5))) == [Moved(200 + 300j, held=True)]
    assert heard(finger(down, (0.5, 0.5), device=-1), finger(up, (0.5, 0.5), device=-1)) == []
    mouse = {"pos": (1, 1), "rel": (0, 0), "buttons": (1, 0, 0)}
    assert heard(pygame.Event(pygame.MOUSEMOTION, mouse, touch=True)) == []
    assert heard(pygame.Event(pygame.MOUSEMOTION, mouse, touch=False)) == [Moved(1 + 1j, held=True)]


def test_two_fingers_move_the_camera_where_there_is_one():
    """Together they drag it, apart they zoom; neither steers nor clicks meanwhile, and a third begins nothing."""
    devices = Devices()

    def heard(*events):
        return [signal for event in events for signal in devices.signals(event, (800, 600), ONE, orbits=True)]

    down, motion, up = pygame.FINGERDOWN, pygame.FINGERMOTION, pygame.FINGERUP
    assert heard(finger(down, (0.5, 0.5)), finger(down, (0.75, 0.5), 2)) == [Moved(400 + 300j, held=False)]
    (drag, zoom) = heard(finger(motion, (1.0, 0.5), 2))
    assert drag == Dragged(100 + 0j)
    assert ZOOM_STEP**zoom.steps == pytest.approx(2.0)
    (drag, zoom) = heard(finger(motion, (0.75, 0.5)))
    assert (drag, ZOOM_STEP**zoom.steps) == (Dragged(100 + 0j), pytest.approx(0.5))
    assert heard(finger(up, (1.0, 0.5), 2), finger(up, (0.75, 0.5))) == []
    assert heard(finger(down, (0.5, 0.5)), finger(up, (0.5, 0.5))) == [Moved(400 + 300j, held=False), Clicked(400 + 300j)]


def test_every_action_has_a_key():
    """Nothing can only be done by nobody, and no key does two things."""
    assert {one.action for one in BINDINGS} == set(Action)
    for kind in ("codes", "positions", "buttons"):
        claimed = [claim for one in BINDINGS for claim in getattr(one, kind)]
        assert len(claimed) == len(set(claimed))


def test_of_two_players_the_one_who_has_the_ball_aims():
    """The other one's mouse inside the ring of paddles moves a paddle meanwhile; either one's key serves."""
    game, camera = new_game(classic(), 1, Ruleset(versus=True)), Camera(400 + 300j, 30.0)
    first = Hands(pointer=camera.project(3 + 1j))
    second = Hands(aiming=1j, serve=True)
    for server, aims, moves in ((0, True, False), (1, True, True)):
        controls = controls_of_two(first, second, camera, game._replace(server=server))
        assert (controls.aim is not None, controls.pointer is not None, controls.serve) == (aims, moves, True)
    assert controls_of_two(first, Hands(), camera, game._replace(server=1)).aim is None
