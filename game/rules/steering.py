"""The paddles' spin in a tick: towards full speed by keys, straight to the pointer by mouse.

The functions of numbers alone are compiled, too, as they stand (`tools.environments`); so are those of the serve, of nudging
and of points.
"""

import math

from game.rules.speed import fastest_spin
from game.rules.state import PADDLES, POINTER_STEPS, TICK, Controls, Game, paddle_ring
from physics import Arena, Ring, signed_difference


def steered(game: Game, controls: Controls) -> Arena:
    """The arena with the paddles' spin set for this tick. Keys go before pointers, the first player before the second."""
    paddles, spec = paddle_ring(game), game.level.paddles
    top = top_spin(game)
    turn, pointer = controls.turn, controls.pointer
    if turn == 0:
        turn = controls.second_turn
        pointer = controls.second_pointer if pointer is None else pointer
    if turn == 0 and pointer is not None:
        spin = spin_to_pointer(paddles, pointer, top)
    else:
        spin = keyed_spin(paddles.spin, turn, top, math.radians(spec.acceleration) * TICK)
        if game.ruleset.arcade:
            spin = min(max(spin, -top), top)  # the balls may have become slower
    if spin == paddles.spin:
        return game.arena
    return game.arena._replace(rings=(paddles.steered(spin), *game.arena.rings[PADDLES + 1 :]))


def top_spin(game: Game) -> float:
    """The paddles' top speed, rad/s. Under the arcade rules it follows the balls' speed, and stays below it."""
    top = math.radians(game.level.paddles.top_speed)
    return min(top * (game.speed / game.level.ball.speed), fastest_spin(game)) if game.ruleset.arcade else top


def keyed_spin(spin: float, turn: int, top: float, change: float) -> float:
    """The paddles' spin after a tick of keys: towards full speed, by `change` at most. All in rad/s. turn: -1, 0 or +1."""
    wanted = top * turn
    return min(max(wanted, spin - change), spin + change)


def spin_to_pointer(paddles: Ring, pointer: int, top: float) -> float:
    """Spin that brings the nearest paddle to the pointer within one tick, no faster than the top speed. rad/s."""
    wanted = pointer * (math.tau / POINTER_STEPS)
    nearest = signed_difference(wanted, paddles.angle(0))
    for slot in range(1, paddles.count):
        offset = signed_difference(wanted, paddles.angle(slot))
        if abs(offset) < abs(nearest):
            nearest = offset
    return min(max(nearest / TICK, -top), top)
