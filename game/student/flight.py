"""Which balls bounce by a student's functions: broad phase, narrow phase, response, as on the slides. For the child process.

Arguments are what JSON has. A ball: x, y, the velocity's x and y, radius. A ring: the fields of `physics.Ring`, in their order.
layers: for every ring, for every slot, the bricks stacked there; 0 empty, below 0 unbreakable.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from game.student.own_functions import OwnFunctions, checked_result, plain, wrong_result

_ENDLESS = 1e9
"""World units, the ground's radius: whether a ball has left the ground is asked by the rules of the game."""


class PlainRing(NamedTuple):
    """A ring as a student's `advance` gets it; the fields are those of `physics.Ring`."""

    radius: float
    half_width: float
    half_angle: float
    sectors: int
    phase: float
    spin: float
    friction: float


class _Bounce(NamedTuple):
    """The sector that a ball bounces off, the normal, and the ball's velocity afterwards."""

    ring: int
    slot: int
    normal: complex
    after: complex


def bounces(
    functions: OwnFunctions,
    balls: Sequence[Sequence[float]],
    rings: Sequence[Sequence[Any]],
    layers: Sequence[Sequence[int]],
    v_0: float,
) -> list[list[float]]:
    """For every ball that bounces: its index, ring, slot, the normal's x and y, and its velocity's x and y afterwards.

    Balls are asked about in their order; one that breaks a brick leaves the next one a gap.
    """
    left = [list(row) for row in layers]
    found = []
    for index, (x, y, v_x, v_y, radius) in enumerate(balls):
        bounce = _bounce(functions, (complex(x, y), complex(v_x, v_y), radius), [PlainRing(*ring) for ring in rings], left, v_0)
        if bounce is not None:
            ring, slot, n, after = bounce
            left[ring][slot] -= left[ring][slot] > 0
            found.append([index, ring, slot, n.real, n.imag, after.real, after.imag])
    return found


def own_advance(
    advance: Callable[..., Any],
    functions: OwnFunctions,
    balls: Sequence[Sequence[float]],
    rings: Sequence[Sequence[Any]],
    layers: Sequence[Sequence[int]],
    dt: float,
    v_0: float,
) -> list[Any]:
    """What the student's own `advance` makes of one tick: [p's x and y, v's x and y] of every ball, and the hits.

    A hit is a ball's index, ring, slot, and the normal's x and y.
    """
    point = functions.make_point
    given = [(point(x, y), point(v_x, v_y), radius) for x, y, v_x, v_y, radius in balls]
    result = advance(given, [PlainRing(*ring) for ring in rings], [list(row) for row in layers], dt, v_0)
    expected = f"a list of {len(balls)} pairs (p, v), and a list of hits (ball, ring, slot, n)"
    try:
        moved, hits = result
        states = [[checked_result(part, "point", advance) for part in (p, v)] for p, v in moved]
        answered = [(int(ball), int(ring), int(slot), checked_result(n, "point", advance)) for ball, ring, slot, n in hits]
        known = all([min(one[:3]) >= 0 and one[0] < len(balls) and layers[one[1]][one[2]] != 0 for one in answered])
    except (TypeError, ValueError, IndexError):
        raise wrong_result(advance, result, expected) from None
    if len(states) != len(balls) or not known:
        raise wrong_result(advance, result, expected)
    return [
        [[*plain(p), *plain(v)] for p, v in states],
        [[ball, ring, slot, n.real, n.imag] for ball, ring, slot, n in answered],
    ]


def _bounce(
    functions: OwnFunctions,
    ball: tuple[complex, complex, float],
    rings: Sequence[PlainRing],
    layers: Sequence[Sequence[int]],
    v_0: float,
) -> _Bounce | None:
    """The bounce of one ball; None if the slides find none."""
    p, v, r = ball
    touched = _ring_in_reach(functions, p, r, rings)
    if touched is None:
        return None
    ring, turn = rings[touched], math.tau / rings[touched].sectors
    slots = [slot for slot in range(ring.sectors) if layers[touched][slot] != 0]
    if not slots:
        return None
    theta = functions.to_polar(p)[1]
    angles = {slot: functions.add_angles(ring.phase, slot * turn) for slot in slots}
    positions = [(ring.radius, angle) for angle in angles.values()]
    n = functions.broad_phase(p, r, theta, ring.half_width, ring.half_angle, positions)
    if n is None:
        return None
    slot = min(slots, key=lambda slot: functions.min_difference(theta, angles[slot]))
    v_p = 1j * functions.to_cartesian(ring.radius, angles[slot]) * ring.spin
    after = functions.collision_response(v, n, v_p, ring.friction, v_0)
    return None if after == v else _Bounce(touched, slot, n, after)


def _ring_in_reach(functions: OwnFunctions, p: complex, r: float, rings: Sequence[PlainRing]) -> int | None:
    """The ring that the broad phase's outcome names (slide 2): the paddles, which are the first ring, or a ring of bricks."""
    paddles = rings[0]
    for number in range(1, len(rings)) or (0,):
        bricks = rings[number]
        outcome = functions.broad_phase_outcome(
            p, r, _ENDLESS, paddles.radius, paddles.half_width, bricks.radius, bricks.half_width
        )
        if outcome == "paddles":
            return 0
        if outcome == "bricks":
            return number
    return None
