"""The paddles' spin in a tick: towards full speed by keys, straight to the pointer by mouse."""

import math

from game.rules.speed import fastest_spin
from game.rules.state import PADDLES, POINTER_STEPS, TICK, Controls, Game, paddle_ring
from physics import Arena, Ring, signed_difference


def steered(game: Game, controls: Controls) -> Arena:
    """The arena with the paddles' spin set for this tick. Keys go before pointers, the first player before the second."""
    paddles, spec = paddle_ring(game), game.level.paddles
    top = math.radians(spec.top_speed)
    if game.ruleset.arcade:
        top = min(top, fastest_spin(game))
    turn, pointer = controls.turn, controls.pointer
    if turn == 0:
        turn = controls.second_turn
        pointer = controls.second_pointer if pointer is None else pointer
    if turn == 0 and pointer is not None:
        spin = _spin_to_pointer(paddles, pointer, top)
    else:
        change = math.radians(spec.acceleration) * TICK
        wanted = top * turn
        spin = min(max(wanted, paddles.spin - change), paddles.spin + change)
        if game.ruleset.arcade:
            spin = min(max(spin, -top), top)  # the balls may have become slower
    if spin == paddles.spin:
        return game.arena
    return game.arena._replace(rings=(paddles.steered(spin), *game.arena.rings[PADDLES + 1 :]))


def _spin_to_pointer(paddles: Ring, pointer: int, top: float) -> float:
    """Spin that brings the nearest paddle to the pointer within one tick, no faster than the top speed."""
    wanted = pointer * (math.tau / POINTER_STEPS)
    offsets = [signed_difference(wanted, paddles.angle(slot)) for slot in range(paddles.count)]
    offset = min(offsets, key=abs)
    return min(max(offset / TICK, -top), top)
