"""What the player did, as values: an event of keyboard or mouse becomes a signal, or nothing.

Gamepads and fingers have to be followed from event to event: game/input/pads.py, game/input/fingers.py.
"""

from dataclasses import dataclass
from itertools import compress

import pygame

from game.input.keys import KEYS, Action, position_in


@dataclass(frozen=True)
class Pressed:
    """A key or a gamepad's button went down.

    position: of the key, a scancode; 0 where it is not known. Of a button, a number from PAD_POSITIONS on.
    """

    action: Action
    position: int = 0


@dataclass(frozen=True)
class Released:
    """A key or a button came up. position: as that of `Pressed`."""

    action: Action
    position: int = 0


@dataclass(frozen=True)
class KeyboardState:
    """The keys that are down after all events of a frame. down: their positions."""

    down: frozenset[int]


@dataclass(frozen=True)
class Moved:
    """The mouse moved. pixel: of the drawn surface; held: with the main button down."""

    pixel: complex
    held: bool


@dataclass(frozen=True)
class Clicked:
    """The main mouse button went down. pixel: of the drawn surface."""

    pixel: complex


@dataclass(frozen=True)
class Dragged:
    """The mouse moved with its right button held. offset: pixels, to the right and down."""

    offset: complex


@dataclass(frozen=True)
class Zoomed:
    """The wheel turned. steps: above 0 away from the player."""

    steps: float


@dataclass(frozen=True)
class Pointed:
    """A gamepad's stick points somewhere.

    direction: of length 1, to the right and up; 0 once the stick is let go. aims: it is the right stick, which aims the serve;
    the left one moves the paddles. pad: index of the gamepad, 0 for the one that was plugged in first.
    """

    direction: complex
    aims: bool = False
    pad: int = 0


@dataclass(frozen=True)
class Squeezed:
    """A gamepad's triggers moved.

    spin: -1.0 the left one all the way, 0.0 neither or both, +1.0 the right one. pad: as that of `Pointed`.
    """

    spin: float
    pad: int = 0


@dataclass(frozen=True)
class PadChanged:
    """A gamepad was plugged in or pulled out. name: what it calls itself."""

    name: str
    there: bool


@dataclass(frozen=True)
class FocusLost:
    """The player went to another window, or the gamepad is gone: what was held will not be heard coming up."""


Signal = Pressed | Released | KeyboardState | Moved | Clicked | Dragged | Zoomed | Pointed | Squeezed | PadChanged | FocusLost
"""Every kind is a class of its own, and a dataclass equals only its own class: no two kinds compare equal."""

PAD_POSITIONS, POSITIONS_PER_PAD = 1 << 10, 64
"""Positions from the first on are of gamepads: above every scancode, so many for each gamepad."""


def pad_of(signal: Signal) -> int | None:
    """Index of the gamepad that a signal comes from; None for one that comes from elsewhere."""
    match signal:
        case Pressed(_, position) | Released(_, position) if position >= PAD_POSITIONS:
            return (position - PAD_POSITIONS) // POSITIONS_PER_PAD
        case Pointed() | Squeezed():
            return signal.pad
        case _:
            return None


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
