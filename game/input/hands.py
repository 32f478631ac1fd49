"""What the player holds down, so that every tick can be given its controls."""

import cmath
import math
from typing import NamedTuple

from game.drawing.camera import Camera, bearing
from game.input.actions import Action
from game.input.signals import (
    PAD_POSITIONS,
    Clicked,
    FocusLost,
    KeyboardState,
    Moved,
    Pointed,
    Pressed,
    Released,
    Signal,
    Squeezed,
    of_stick,
)
from game.rules import POINTER_STEPS, TICK, Controls, Game, Phase, paddle_ring

_TURNS = (Action.LEFT, Action.RIGHT)
_ANY_BUTTON = frozenset({*_TURNS, Action.UP, Action.DOWN, Action.SERVE, Action.CONFIRM})
"""What a player with one button may have bound it to."""
_ONE_BUTTON_SPIN = 0.6
"""Share of their top speed at which the paddles turn by themselves: who reacts late loses fewer balls than at all of it."""
_AIMING_SHARE = 0.8
"""Before the serve the mouse aims within this share of the paddles' inner radius; beyond it, it moves them."""
_STICK_PIXELS = 100.0
"""From the arena's centre to the pixel that a stick points to: any distance has the same bearing."""


class Hands(NamedTuple):
    """What the player holds down, and where the mouse or a stick last took over.

    held: the steering keys that are down, in the order in which they were pressed. Keys, not actions: two keys can mean the
    same, and one of them may come up while the other stays down.
    pointer: pixels; None while something else has the paddles.
    stick: direction that a gamepad's left stick points to, of length 1, to the right and up; 0 for none. aiming: that of
    the right stick.
    spin: asked for by triggers, -1.0 to 1.0 of the paddles' top speed.
    serve, give_up: whether that was asked for since the last tick.
    turned: +1 or -1, the other one after every press of a key, a button, or on the screen; pressed: whether there was one since
    the last tick. They are what counts for a player with one button.
    """

    held: tuple[Pressed, ...] = ()
    pointer: complex | None = None
    stick: complex = 0j
    aiming: complex = 0j
    spin: float = 0.0
    serve: bool = False
    give_up: bool = False
    turned: int = 1
    pressed: bool = False

    def after(self, signal: Signal) -> "Hands":
        """What is held after one more signal.

        A turning key takes the paddles from the mouse; the mouse takes them back when it moves and no such key is held, nor
        a stick or a trigger. Keys come before triggers, triggers before the stick, the stick before the mouse.
        """
        hands = self
        match signal:
            case Pressed(action, position) if of_stick(position) and action in _TURNS:
                pass  # its angle steers
            case Pressed(action) if action in _TURNS:
                hands = self._replace(held=(*self._without(signal.position), signal), pointer=None)
            case Released(_, position):
                hands = self._replace(held=self._without(position))
            case KeyboardState(down):
                hands = self._replace(
                    held=tuple([key for key in self.held if key.position in down or key.position >= PAD_POSITIONS])
                )
            case Pressed(Action.SERVE) | Clicked():
                hands = self._replace(serve=True)
            case Pressed(Action.GIVE_UP):
                hands = self._replace(give_up=True)
            case Moved() | Pointed() | Squeezed():
                hands = self._pointed(signal)
            case FocusLost():
                return Hands(turned=self.turned)
        return hands._replace(turned=-hands.turned, pressed=True) if _is_press(signal) else hands

    def controls(self, camera: Camera, game: Game, *, aims: bool = True) -> Controls:
        """The controls of the next tick. The last turning key pressed wins. aims: whether the mouse may aim the serve."""
        turn, pointer, aim = 0, None, self._aim(camera, game) if aims else None
        if self.held:
            turn = 1 if self.held[-1].action is Action.RIGHT else -1
        elif self.spin:
            pointer = _spun(game, self.spin)
        elif self.stick:
            pointer = _bearing_steps(_pixel_of(self.stick, camera), camera)
        elif aim is None:
            pointer = _bearing_steps(self.pointer, camera)
        return Controls(turn, pointer, self.serve, self.give_up, aim)

    def one_button_controls(self, game: Game) -> Controls:
        """The controls of the next tick for a player with one button: a press serves, and reverses the paddles in play."""
        pointer = _spun(game, self.turned * _ONE_BUTTON_SPIN) if game.phase == Phase.PLAYING else None
        return Controls(0, pointer, self.pressed, self.give_up)

    def after_tick(self) -> "Hands":
        """What is still held once a tick has been given its controls: what is asked for once is asked for no more."""
        return self._replace(serve=False, give_up=False, pressed=False)

    def _pointed(self, signal: Moved | Pointed | Squeezed) -> "Hands":
        """What is held after the mouse, a stick or a trigger has moved."""
        match signal:
            case Moved(pixel):
                return self if self.held or self.stick or self.spin else self._replace(pointer=pixel)
            case Pointed(direction, True):
                return self._replace(aiming=direction)
            case Pointed(direction):
                return self._replace(stick=direction, pointer=None)
            case Squeezed(spin):
                return self._replace(spin=spin, pointer=None)

    def _aim(self, camera: Camera, game: Game) -> int | None:
        """Where the ball shall be served to: where the right stick points, or to the mouse if that is well inside."""
        if game.phase != Phase.SERVING or not game.arena.balls:
            return None
        if self.aiming:
            return _bearing_steps(_pixel_of(self.aiming, camera), camera)
        if self.pointer is None:
            return None
        target = camera.unproject(self.pointer)
        if abs(target) > _AIMING_SHARE * paddle_ring(game).inner_radius:
            return None
        return _steps(cmath.phase(target - game.arena.balls[0].position))

    def _without(self, position: int) -> tuple[Pressed, ...]:
        """The held keys but one."""
        return tuple([key for key in self.held if key.position != position])


def controls_of_two(first: Hands, second: Hands, camera: Camera, game: Game) -> Controls:
    """The controls of the next tick of two players. Either serves; who has the ball on the own paddle aims."""
    one, other = (hands.controls(camera, game, aims=game.server == player) for player, hands in enumerate((first, second)))
    aim = one.aim if other.aim is None else other.aim
    one = one._replace(serve=one.serve or other.serve, aim=aim)
    return one._replace(second_turn=other.turn, second_pointer=other.pointer)


def _is_press(signal: Signal) -> bool:
    """Whether a player with one button may have meant that one."""
    match signal:
        case Pressed(action, position):
            return action in _ANY_BUTTON and not of_stick(position)
        case _:
            return isinstance(signal, Clicked)


def _pixel_of(direction: complex, camera: Camera) -> complex:
    """A pixel in a direction from the arena's centre."""
    return camera.centre + direction.conjugate() * _STICK_PIXELS


def _bearing_steps(pixel: complex | None, camera: Camera) -> int | None:
    """A pixel's bearing as the rules count it."""
    angle = None if pixel is None else bearing(camera, pixel)
    return None if angle is None else _steps(angle)


def _spun(game: Game, share: float) -> int:
    """Where a paddle is a tick from now that turns with a share of its top speed: the rules take it there by that spin.

    A tick's turn is a few dozen steps and seldom whole; taken from the game's ticks, what is left of a step is not lost.
    """
    turn = share * math.radians(game.level.paddles.top_speed) * TICK / math.tau * POINTER_STEPS
    whole = math.floor((game.tick + 1) * turn) - math.floor(game.tick * turn)
    return (_steps(paddle_ring(game).angle(0)) + whole) % POINTER_STEPS


def _steps(angle: float) -> int:
    """An angle as the rules count it, the nearest step."""
    return round(angle % math.tau / math.tau * POINTER_STEPS) % POINTER_STEPS
