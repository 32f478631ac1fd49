"""The paddles' spin in a tick: towards full speed by keys, straight to the pointer by mouse.

The functions of numbers alone are compiled, too, as they stand (`tools.environments`); so are those of the serve, of nudging
and of points.
"""

import math

from game.rules.speed import fastest_spin
from game.rules.state import PADDLES, POINTER_STEPS, TICK, Controls, Game, paddle_rings
from game.rules.versus import spin_within
from physics import Arena, Ring, nearest_slot, signed_difference

_RADIANS_PER_STEP = math.tau / POINTER_STEPS
_HALFWAY = 1e-9
"""Radians. A pointer so near to the middle between two paddles is compared with each: far above rounding."""


def steered(game: Game, controls: Controls) -> Arena:
    """The arena with the paddles' spin set for this tick; the arena itself where they have it already.

    Keys go before pointers, the first player before the second.
    """
    if game.ruleset.versus:
        return _both_steered(game, controls)
    turn, pointer, _, _, _, second_turn, second_pointer = controls
    if turn == 0:
        turn = second_turn
        pointer = second_pointer if pointer is None else pointer
    arena = game.arena
    paddles = arena.rings[PADDLES]
    spin = _spin(game, paddles, turn, pointer)
    return arena if spin == paddles.spin else _with_spin(arena, PADDLES, spin)


def _both_steered(game: Game, controls: Controls) -> Arena:
    """The arena with the spin of each player's paddle, which stays in its half."""
    arena = game.arena
    asked = (controls.turn, controls.pointer), (controls.second_turn, controls.second_pointer)
    for player, (k, (turn, pointer)) in enumerate(zip(paddle_rings(game), asked, strict=True)):
        spin = spin_within(arena.rings[k], player, _spin(game, arena.rings[k], turn, pointer))
        if spin != arena.rings[k].spin:
            arena = _with_spin(arena, k, spin)
    return arena


def _with_spin(arena: Arena, k: int, spin: float) -> Arena:
    """The arena with another spin of a ring."""
    rings = [*arena.rings]
    rings[k] = rings[k].steered(spin)
    return Arena(arena.balls, tuple(rings), arena.layers)


def _spin(game: Game, paddles: Ring, turn: int, pointer: int | None) -> float:
    """The spin that a player's controls give paddles in this tick, rad/s."""
    top = top_spin(game)
    if turn == 0 and pointer is not None:
        return spin_to_pointer(paddles, pointer, top)
    spin = keyed_spin(paddles.spin, turn, top, math.radians(game.level.paddles.acceleration) * TICK)
    return min(max(spin, -top), top) if game.ruleset.arcade else spin  # the balls may have become slower


def top_spin(game: Game) -> float:
    """The paddles' top speed, rad/s. Under the arcade rules it follows the balls' speed, and stays below it."""
    level = game.levels[game.number]
    top = math.radians(level.paddles.top_speed)
    if not game.ruleset.arcade:
        return top
    return min(top * (game.speed / level.ball.speed), fastest_spin(game))


def keyed_spin(spin: float, turn: int, top: float, change: float) -> float:
    """The paddles' spin after a tick of keys: towards full speed, by `change` at most. All in rad/s. turn: -1, 0 or +1."""
    wanted = top * turn
    return min(max(wanted, spin - change), spin + change)


def spin_to_pointer(paddles: Ring, pointer: int, top: float) -> float:
    """Spin that brings the nearest paddle to the pointer within one tick, no faster than the top speed. rad/s."""
    wanted = pointer * _RADIANS_PER_STEP
    nearest = signed_difference(wanted, paddles.angle(nearest_slot(paddles, wanted)))
    if abs(nearest) > math.pi / paddles.count - _HALFWAY:  # rounding may have chosen between two equally near
        nearest = signed_difference(wanted, paddles.angle(0))
        for slot in range(1, paddles.count):
            offset = signed_difference(wanted, paddles.angle(slot))
            if abs(offset) < abs(nearest):
                nearest = offset
    spin = nearest / TICK
    return spin if -top <= spin <= top else math.copysign(top, spin)
