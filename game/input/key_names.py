"""What the keys are called on the player's own keyboard layout, and the help that is written with these names."""

from collections.abc import Iterable, Mapping
from functools import cache

import pygame

from game.input.keys import KEYS, NAMED_KEY, US_CODES, Action, position_of

_CHARACTERS = range(ord("!"), 0x600)
"""Codes of keys with a character: Latin, Greek, Cyrillic, Armenian, Hebrew."""
_WORDS = {"return": "Enter", "escape": "Esc", "space": "Space"}


def key_names(action: Action) -> tuple[str, ...]:
    """The names of an action's keys as this layout writes them, the keypad's left out; the first is the usual one."""
    binding = KEYS.binding(action)
    return _without_keypad(
        [*[_name_at(position) for position in binding.positions], *[_name_of(code) for code in binding.codes]]
    )


def code_names(codes: Iterable[int]) -> tuple[str, ...]:
    """The names of the keys that mean some codes, as this layout writes them, the keypad's left out."""
    return _without_keypad([_name_of(code) for code in codes])


def key_name(action: Action) -> str:
    """The name of an action's usual key as this layout writes it."""
    return key_names(action)[0]


def layout_changed() -> None:
    """Forget the layout: the player has switched to another."""
    _present_codes.cache_clear()


def play_help() -> tuple[tuple[str, str], ...]:
    """Pairs of keys and what they do in a game."""
    left, right = key_names(Action.LEFT), key_names(Action.RIGHT)
    return (
        (f"{left[0]}, {right[0]}   {left[-1]} {right[-1]}", "turn the paddles"),
        ("Mouse", "the nearest paddle follows"),
        (f"{key_name(Action.SERVE)}   Click", "serve along the arrow; go on"),
        (_all(Action.PAUSE, Action.BACK), "pause; leave through the menu there"),
        (_all(Action.RESTART), "restart (asks first)"),
        (_all(Action.GIVE_UP), "give up a ball that no paddle reaches"),
        (_all(Action.TIP, Action.FLAT, Action.SOLID), "tip the camera; from above; in 3D"),
        ("Right drag   Wheel", "in 3D: orbit and tilt; zoom"),
        (_all(Action.FULL_SCREEN), "full screen"),
        (_all(Action.MUTE, Action.LESS, Action.MORE), "sound off / on; softer; louder"),
        (_all(Action.THEME, Action.EFFECTS), "dark / light colours; effects off / on"),
        (_all(Action.SETTINGS), "settings: every effect, reduced motion"),
        (_all(Action.NORMALS), "normals: ours thick, pymunk's thin"),
        (_all(Action.LAB), "the lab: the collision detection to touch"),
        ("   ".join(key_names(Action.HELP)), "this help"),
    )


def watch_help() -> tuple[tuple[str, str], ...]:
    """Pairs of keys and what they do while a recorded game is watched."""
    others = _all(Action.FULL_SCREEN, Action.MUTE, Action.THEME, Action.EFFECTS, Action.SETTINGS)
    return (
        (_all(Action.SERVE, Action.PAUSE), "play / stop"),
        (_all(Action.STEP, Action.STEP_BACK), "one tick forward / back"),
        (_all(Action.LEFT, Action.RIGHT), "5 seconds back / forward"),
        (_all(Action.MORE, Action.LESS), "faster / slower, 1/8 to 8 times"),
        (_all(Action.START, Action.END), "to the beginning / the end"),
        ("Mouse", "click or drag on the timeline"),
        (_all(Action.TIP, Action.FLAT, Action.SOLID), "tip the camera; from above; in 3D"),
        (others, "full screen, sound, colours, effects, settings"),
        (_all(Action.NORMALS), "normals: ours thick, pymunk's thin"),
        (_all(Action.LAB), "the lab: the collision detection to touch"),
        (_all(Action.BACK), "leave"),
        ("   ".join(key_names(Action.HELP)), "this help"),
    )


def _without_keypad(names: Iterable[str]) -> tuple[str, ...]:
    """The names, each once, but for those of the keypad: they are in brackets."""
    return tuple(dict.fromkeys([name for name in names if len(name) == 1 or not name.startswith("[")]))


def _all(*actions: Action) -> str:
    """The usual keys of some actions, in one cell of the help."""
    return "   ".join([key_name(action) for action in actions])


def _name_at(position: int) -> str:
    """What the layout calls the key at a position."""
    return _said(_codes_by_position().get(position, position | NAMED_KEY))


def _name_of(code: int) -> str:
    """What the layout calls the key that means a code: the code itself, or what is written where the US layout has it."""
    if code & NAMED_KEY or code < _CHARACTERS.start or code in _codes_by_position().values():
        return _said(code)
    return _name_at(position_of(code)) or _said(code)


def _said(code: int) -> str:
    """The name of a code, as keys are labelled."""
    if code in _CHARACTERS:
        return chr(code).upper()
    name = pygame.key.name(code)
    return _WORDS.get(name, name.capitalize())


def _codes_by_position() -> Mapping[int, int]:
    """Code of every printing key of the present layout; of the US layout before there is a display."""
    return _present_codes() if pygame.display.get_init() else US_CODES


@cache
def _present_codes() -> Mapping[int, int]:
    """The same, asked of the system.

    The library gives positions for codes only: a table of key states takes a code for an index and looks at its position.
    """
    positions = pygame.key.ScancodeWrapper(range(len(pygame.key.get_pressed())))  # type: ignore[arg-type]
    found = {int(positions[code]): code for code in reversed(_CHARACTERS)}
    found.pop(0, None)
    return found
