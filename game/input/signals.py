"""From keys and the mouse to what the player means.

One table binds keys to actions; the help panel reads the same table. `translated` turns a window's event into a signal, and
`Hands` remembers what is held, so that every tick can be given its `Controls`.
"""

import math
from enum import Enum, auto
from typing import NamedTuple

import pygame

from game.drawing.camera import Camera, bearing
from game.rules import POINTER_STEPS, Controls


class Action(Enum):
    """What a key means."""

    LEFT = auto()
    RIGHT = auto()
    UP = auto()
    DOWN = auto()
    SERVE = auto()
    CONFIRM = auto()
    PAUSE = auto()
    RESTART = auto()
    BACK = auto()
    HELP = auto()
    FULL_SCREEN = auto()
    MUTE = auto()
    THEME = auto()
    EFFECTS = auto()
    SETTINGS = auto()
    NORMALS = auto()
    STEP_BACK = auto()
    STEP = auto()
    LESS = auto()
    MORE = auto()
    START = auto()
    END = auto()
    TIP = auto()
    TOP = auto()
    SOLID = auto()
    LAB = auto()


KEYS: dict[int, Action] = {
    pygame.K_LEFT: Action.LEFT,
    pygame.K_a: Action.LEFT,
    pygame.K_RIGHT: Action.RIGHT,
    pygame.K_d: Action.RIGHT,
    pygame.K_UP: Action.UP,
    pygame.K_w: Action.UP,
    pygame.K_DOWN: Action.DOWN,
    pygame.K_s: Action.DOWN,
    pygame.K_SPACE: Action.SERVE,
    pygame.K_RETURN: Action.CONFIRM,
    pygame.K_KP_ENTER: Action.CONFIRM,
    pygame.K_p: Action.PAUSE,
    pygame.K_PAUSE: Action.PAUSE,
    pygame.K_r: Action.RESTART,
    pygame.K_ESCAPE: Action.BACK,
    pygame.K_F1: Action.HELP,
    pygame.K_h: Action.HELP,
    pygame.K_F11: Action.FULL_SCREEN,
    pygame.K_m: Action.MUTE,
    pygame.K_t: Action.THEME,
    pygame.K_e: Action.EFFECTS,
    pygame.K_o: Action.SETTINGS,
    pygame.K_n: Action.NORMALS,
    pygame.K_l: Action.LAB,
    pygame.K_COMMA: Action.STEP_BACK,
    pygame.K_PERIOD: Action.STEP,
    pygame.K_MINUS: Action.LESS,
    pygame.K_KP_MINUS: Action.LESS,
    pygame.K_PLUS: Action.MORE,
    pygame.K_EQUALS: Action.MORE,
    pygame.K_KP_PLUS: Action.MORE,
    pygame.K_HOME: Action.START,
    pygame.K_END: Action.END,
    pygame.K_TAB: Action.TIP,
    pygame.K_1: Action.TOP,
    pygame.K_KP_1: Action.TOP,
    pygame.K_2: Action.SOLID,
    pygame.K_KP_2: Action.SOLID,
}

PLAY_HELP: tuple[tuple[str, str], ...] = (
    ("Arrows   A D", "turn the paddles"),
    ("Mouse", "the nearest paddle follows"),
    ("Space   Click", "serve along the arrow; go on"),
    ("P   Esc", "pause; leave through the menu there"),
    ("R", "restart (asks first)"),
    ("Tab   1   2", "tip the camera; from above; in 3D"),
    ("Right drag   Wheel", "in 3D: orbit and tilt; zoom"),
    ("F11", "full screen"),
    ("M   -   =", "sound off / on; softer; louder"),
    ("T   E", "dark / light colours; effects off / on"),
    ("O", "settings: every effect, reduced motion"),
    ("N", "normals: ours thick, pymunk's thin"),
    ("L", "the lab: the collision detection to touch"),
    ("H   F1", "this help"),
)

WATCH_HELP: tuple[tuple[str, str], ...] = (
    ("Space   P", "play / stop"),
    (".   ,", "one tick forward / back"),
    ("Left  Right", "5 seconds back / forward"),
    ("+   -", "faster / slower, 1/8 to 8 times"),
    ("Home  End", "to the beginning / the end"),
    ("Mouse", "click or drag on the timeline"),
    ("Tab   1   2", "tip the camera; from above; in 3D"),
    ("F11   M   T   E   O", "full screen, sound, colours, effects, settings"),
    ("N", "normals: ours thick, pymunk's thin"),
    ("L", "the lab: the collision detection to touch"),
    ("Esc", "leave"),
    ("H   F1", "this help"),
)


class Pressed(NamedTuple):
    """A key went down."""

    action: Action


class Released(NamedTuple):
    """A key came up."""

    action: Action


class Moved(NamedTuple):
    """The mouse moved, with or without its button held."""

    place: complex  # pixels of the drawn surface
    held: bool


class Clicked(NamedTuple):
    """The main mouse button went down."""

    place: complex


class Dragged(NamedTuple):
    """The mouse moved with its right button held."""

    way: complex  # pixels, right and down


class Zoomed(NamedTuple):
    """The wheel turned."""

    steps: float  # above 0 away from the player


class FocusLost(NamedTuple):
    """The player went to another window; keys that were held will not be heard coming up."""


Signal = Pressed | Released | Moved | Clicked | Dragged | Zoomed | FocusLost


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


def _key(event: pygame.Event) -> Signal | None:
    """A key that went down or up. Alt with Enter is the full screen; Alt with Tab is the desktop's."""
    action, alt = KEYS.get(event.key), event.mod & pygame.KMOD_ALT
    if action is Action.CONFIRM and alt:
        action = Action.FULL_SCREEN
    if action is None or (action is Action.TIP and alt):
        return None
    return Pressed(action) if event.type == pygame.KEYDOWN else Released(action)


def _moved(event: pygame.Event, pixels_per_point: complex) -> Signal:
    """The mouse's motion: with the right button held it is the camera's."""
    if event.buttons[2]:
        return Dragged(_pixel(event.rel, pixels_per_point))
    return Moved(_pixel(event.pos, pixels_per_point), bool(event.buttons[0]))


class Hands(NamedTuple):
    """What the player holds down, and where the mouse last took over."""

    turns: tuple[Action, ...] = ()  # LEFT and RIGHT, in the order they were pressed
    pointer: complex | None = None  # pixels; None while the keyboard has the paddles
    serve: bool = False  # pressed since the last tick

    def after(self, signal: Signal) -> "Hands":
        """What is held after one more signal.

        A turning key takes the paddles from the mouse; the mouse takes them back when it moves and no such key is held.
        """
        match signal:
            case Pressed(action) if action in (Action.LEFT, Action.RIGHT):
                return self._replace(turns=(*_without(self.turns, action), action), pointer=None)
            case Released(action):
                return self._replace(turns=_without(self.turns, action))
            case Pressed(Action.SERVE) | Clicked():
                return self._replace(serve=True)
            case Moved(place) if not self.turns:
                return self._replace(pointer=place)
            case FocusLost():
                return Hands()
            case _:
                return self

    def controls(self, camera: Camera) -> Controls:
        """The controls of the next tick. The last turning key pressed wins."""
        if self.turns:
            return Controls(1 if self.turns[-1] is Action.RIGHT else -1, None, self.serve)
        return Controls(0, _steps(self.pointer, camera), self.serve)


def _without(turns: tuple[Action, ...], action: Action) -> tuple[Action, ...]:
    """The held keys but one."""
    return tuple([held for held in turns if held is not action])


def _steps(pointer: complex | None, camera: Camera) -> int | None:
    """The pointer's bearing as the rules count it."""
    angle = None if pointer is None else bearing(camera, pointer)
    return None if angle is None else int(angle % math.tau / math.tau * POINTER_STEPS) % POINTER_STEPS


def _pixel(place: tuple[int, int], pixels_per_point: complex) -> complex:
    """The pixel at a place given in the mouse's coordinates."""
    return complex(place[0] * pixels_per_point.real, place[1] * pixels_per_point.imag)
