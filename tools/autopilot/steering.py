"""The batch's ticks with the autopilot at the paddles: the loop over games and ticks that is compiled."""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from game.autopilot.source_plan import outer
from game.rules import PADDLES, TICK
from game.rules.steering import keyed_spin, spin_to_pointer
from physics.batch.arrays import Games, Integers
from physics.batch.games import UNKNOWN, play_one_tick, ring_of, with_turn, workspace
from physics.batch.hits import HIT, Rows
from physics.broad_phase import has_left
from physics.shapes import Ball, Ring
from physics.vectors import length
from tools.autopilot.plans import NOTHING, ONE_TICK, is_outdated, planned_pointer, replan

_NO_BALL = Ball(0j, 0j, 1.0)
"""In place of a ball where all are lost."""


class Pilots(NamedTuple):
    """What the autopilot remembers of G games.

    Attributes:
        plans: (G,), rows of `PLAN`.
        ticks: (G,), that it has played.
        played: (G,), ticks of the present call that are done.
        pointers: (G,), where a paddle was wanted in the last tick, as in `game.rules.Controls`; -1 for nowhere.
    """

    plans: npt.NDArray[np.void]
    ticks: Integers
    played: Integers
    pointers: Integers


def step(  # noqa: C901, PLR0912  # given to functions, the arrays of the games are counted in and out
    pilots: Pilots,
    top: float,
    change: float,
    games: Games,
    first: int,
    last: int,
    begun: int,
    ticks: int,
    speed: float,
    ground_radius: float,
    rows: Rows,
    lost: npt.NDArray[np.bool_],
) -> int:
    """`physics.batch.games.step` in ticks of TICK, before each of which the autopilot gives the paddles their spin.

    top: of the paddles' spin, rad/s. change: of the spin in a tick at most, where they are wanted nowhere. The other arguments
    and the result are those of that function. The paddles count as steered (`Games.steered`).
    """
    room = workspace(games)
    plans, clocks, played, pointers = pilots
    positions, velocities, radii = games.positions, games.velocities, games.ball_radii
    phases, spins, free, balls = games.phases, games.spins, games.free, games.positions.shape[1]
    single = Rows(np.empty(ONE_TICK * balls, HIT), np.zeros(3, np.int64))
    most = len(rows.hits) - len(single.hits)
    model = ring_of(games, 0, PADDLES)
    if begun < 0:
        played[first:last] = 0
    for g in range(max(begun, first), last):
        while played[g] < ticks:
            if rows.now[0] > most:
                return g
            met, is_met, slowest = _NO_BALL, False, math.inf
            for i in range(balls):
                ball = Ball(positions[g, i], velocities[g, i], radii[g, i])
                slowest = min(slowest, length(ball.velocity))
                if not has_left(ball.position, ball.radius, ground_radius):
                    met, is_met = outer(met, ball) if is_met else ball, True
            if not is_met:
                plans[g].state = NOTHING
            elif is_outdated(plans[g], met.velocity):
                replan(plans[g], games, g, met, clocks[g], speed, top)
            pointers[g] = planned_pointer(plans[g], clocks[g])
            before = spins[g, PADDLES]
            spin = steered_spin(with_turn(model, phases[g, PADDLES], before), pointers[g], top, change)
            spins[g, PADDLES] = spin
            if abs(spin) > abs(before) and abs(spin) * model.outer_radius > slowest:  # free flights do not allow for that
                games.known[g], free[g] = UNKNOWN, 0
            if free[g] > 0:
                for i in range(balls):
                    positions[g, i] = Ball(positions[g, i], velocities[g, i], radii[g, i]).moved(TICK).position
                for k in range(spins.shape[1]):
                    if spins[g, k] != 0.0:
                        phases[g, k] = with_turn(model, phases[g, k], spins[g, k]).turned(TICK).phase
                free[g] -= 1
            else:
                play_one_tick(games, g, TICK, speed, single, room)
                for n in range(single.now[0]):
                    rows.hits[rows.now[0]] = single.hits[n]
                    rows.hits[rows.now[0]]["tick"] = played[g]
                    rows.now[0] += 1
            clocks[g] += 1
            played[g] += 1
        for i in range(balls):
            lost[g, i] = has_left(positions[g, i], radii[g, i], ground_radius)
    return last


def steered_spin(paddles: Ring, pointer: int, top: float, change: float) -> float:
    """The paddles' spin in a tick: to a pointer, or to rest where it is -1. top, change: as `step` takes them."""
    return spin_to_pointer(paddles, pointer, top) if pointer >= 0 else keyed_spin(paddles.spin, 0, top, change)
