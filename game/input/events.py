"""A window's events as signals: an event of keyboard or mouse becomes a signal, or nothing.

Gamepads and fingers have to be followed from event to event: game/input/pads.py, game/input/fingers.py.
"""

from collections.abc import Iterable, Mapping
from itertools import compress

import pygame

from game.input.key_names import CHARACTERS
from game.input.keys import KEYS, Action
from game.input.scancodes import US_CODES, position_of
from game.input.signals import Clicked, Dragged, FocusLost, KeyboardState, Moved, Pressed, Released, Signal, Zoomed


def translated(event: pygame.Event, pixels_per_point: complex) -> Signal | None:
    """What a window's event means; None for those that mean nothing here.

    pixels_per_point: how many pixels of the surface a unit of the mouse's coordinates spans, across and down.
    """
    if event.type in (pygame.KEYDOWN, pygame.KEYUP):
        return _key(event)
    if event.type == pygame.MOUSEMOTION:
        return _moved(event, pixels_per_point)
    if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
        return Clicked(_pixel(event.pos, pixels_per_point))
    if event.type == pygame.MOUSEWHEEL:
        return Zoomed(float(event.precise_y))
    return FocusLost() if event.type in (pygame.WINDOWFOCUSLOST, pygame.WINDOWMINIMIZED) else None


def keyboard_state() -> KeyboardState:
    """Which keys are down now, asked of the system: when too many events come at once, some are lost."""
    pressed = pygame.key.get_pressed()  # its own [] takes codes; the tuple below it is in the order of positions
    return KeyboardState(frozenset(compress(range(len(pressed)), tuple.__iter__(pressed))))


def position_in(event: pygame.Event) -> int:
    """The position of a key event; 0 where it is not known. An event that was not made by SDL may have none."""
    return int(getattr(event, "scancode", 0)) or position_of(event.key)


def code_among(event: pygame.Event, known: Iterable[int]) -> int:
    """The code of a key event, or what the US layout has at its position where the own one is not known."""
    code = int(event.key)
    return code if code in known else US_CODES.get(position_in(event), code)


def system_layout() -> Mapping[int, int]:
    """Code of every key with a character on the system's present layout, by position. Needs a display.

    The library gives positions for codes only: a table of key states takes a code for an index and looks at its position.
    """
    positions = pygame.key.ScancodeWrapper(range(len(pygame.key.get_pressed())))  # type: ignore[arg-type]
    found = {int(positions[code]): code for code in reversed(CHARACTERS)}
    found.pop(0, None)
    return found


def _key(event: pygame.Event) -> Signal | None:
    """A key that went down or up. Alt with Enter is the full screen; Alt with Tab is the desktop's."""
    position = position_in(event)
    action, alt = KEYS.action(position, event.key), event.mod & pygame.KMOD_ALT
    if action is Action.CONFIRM and alt:
        action = Action.FULL_SCREEN
    if action is None or (action is Action.TIP and alt):
        return None
    return Pressed(action, position) if event.type == pygame.KEYDOWN else Released(action, position)


def _moved(event: pygame.Event, pixels_per_point: complex) -> Signal:
    """The mouse's motion: with the right button held it is the camera's."""
    if event.buttons[2]:
        return Dragged(_pixel(event.rel, pixels_per_point))
    return Moved(_pixel(event.pos, pixels_per_point), bool(event.buttons[0]))


def _pixel(point: tuple[int, int], pixels_per_point: complex) -> complex:
    """The pixel at a point given in the mouse's coordinates."""
    return complex(point[0] * pixels_per_point.real, point[1] * pixels_per_point.imag)
