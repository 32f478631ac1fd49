"""Keys that the player chooses: what they take, what stays, what a file may say."""

import os

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.input import key_names
from game.input.actions import Action, OwnKeys
from game.input.keys import BINDINGS, KEYS
from game.input.rebinding import FIXED_KEYS, NEEDED, Refused, bindings, checked, cleared, rebound, with_keys
from game.input.scancodes import US_CODES, code_at

P, M, UP, W = pygame.KSCAN_P, pygame.KSCAN_M, pygame.KSCAN_UP, pygame.KSCAN_W


@pytest.fixture(autouse=True)
def default_keys():
    """The keys of a new player, before and after."""
    pygame.quit()
    yield
    KEYS.change(BINDINGS)


def in_use():
    """Every action's keys."""
    return {action: key_names.positions_in_use(action) for action in Action}


def hold(own):
    """Let choices hold."""
    KEYS.change(bindings(checked(own)))


def test_a_key_that_is_given_away_is_taken_from_the_other_action():
    """M pauses and mutes no more; the help names what is left, or that there is nothing."""
    given_m = rebound(in_use(), FIXED_KEYS, Action.PAUSE, 0, M)
    assert given_m.taken_from is Action.MUTE
    own = with_keys(OwnKeys(), given_m.controls)
    hold(own)
    assert KEYS.action(M, pygame.K_m) is Action.PAUSE
    assert KEYS.action(P, pygame.K_p) is None
    assert key_names.key_names(Action.PAUSE) == ("M", "Pause")
    assert key_names.key_name(Action.MUTE) == key_names.NO_KEY
    back = rebound(in_use(), FIXED_KEYS, Action.MUTE, 0, M)
    assert back.taken_from is Action.PAUSE
    hold(with_keys(own, back.controls))
    assert KEYS.action(M, pygame.K_m) is Action.MUTE
    assert key_names.key_names(Action.PAUSE) == ("Pause",)


def test_a_chosen_key_is_physical(monkeypatch):
    """Where the layout writes something else on it, it means the same, and has the name that is written there."""
    hold(OwnKeys(((Action.PAUSE, (pygame.KSCAN_Q,)),)))
    monkeypatch.setattr(key_names, "_layout", dict(US_CODES) | {pygame.KSCAN_Q: ord("й")})
    assert KEYS.action(pygame.KSCAN_Q, ord("й")) is Action.PAUSE
    assert key_names.key_names(Action.PAUSE) == ("Й",)


@pytest.mark.parametrize("control", list(FIXED_KEYS))
def test_what_accepts_and_goes_back_stays(control):
    """Enter and Esc are given to nothing else and taken from nobody; the last key of a direction is not taken either."""
    keys = in_use()
    with pytest.raises(Refused):
        rebound(keys, FIXED_KEYS, Action.PAUSE, 0, control)
    slot = keys[FIXED_KEYS[control]].index(control)
    with pytest.raises(Refused):
        rebound(keys, FIXED_KEYS, FIXED_KEYS[control], slot, M)
    with pytest.raises(Refused):
        cleared(keys, FIXED_KEYS, FIXED_KEYS[control], slot)
    one_left = keys | rebound(keys, FIXED_KEYS, Action.PAUSE, 0, W).controls
    assert one_left[Action.UP] == (UP,)
    with pytest.raises(Refused):
        rebound(one_left, FIXED_KEYS, Action.PAUSE, 1, UP)
    with pytest.raises(Refused):
        cleared(one_left, FIXED_KEYS, Action.UP, 0)


numbers = st.lists(st.sampled_from([0, 1, *FIXED_KEYS, P, M, UP, W, pygame.KSCAN_LEFT, pygame.KSCAN_A, 511, 512]), max_size=3)


@settings(max_examples=40)
@given(
    st.dictionaries(st.sampled_from(Action), numbers.map(tuple)), st.dictionaries(st.sampled_from(Action), numbers.map(tuple))
)
def test_no_file_locks_the_player_out(keys, buttons):
    """Whatever it says: Enter accepts, Esc goes back, every direction has a key and a button, and so has the way back."""
    pygame.quit()
    hold(OwnKeys(tuple(keys.items()), tuple(buttons.items())))
    for position, action in FIXED_KEYS.items():
        assert KEYS.action(position, code_at(position)) is action
    for action in NEEDED:
        assert key_names.positions_in_use(action)
    directions = {KEYS.button_action(button) for button in range(32)}
    assert directions >= NEEDED
    assert KEYS.button_action(pygame.CONTROLLER_BUTTON_A) is Action.SERVE
    assert KEYS.button_action(pygame.CONTROLLER_BUTTON_B) is Action.BACK
