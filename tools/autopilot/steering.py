"""The batch's ticks with the autopilot at the paddles: the loop over games and ticks that is compiled."""

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
from tools.autopilot.plans import NOTHING, ONE_TICK, ArrayAhead, new_outlook, planned_pointer, replan


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


def step(
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
    outlook, room = new_outlook(games), workspace(games)
    balls = games.positions.shape[1]
    single = Rows(np.empty(ONE_TICK * balls, HIT), np.zeros(3, np.int64))
    most = len(rows.hits) - len(single.hits)
    if begun < 0:
        pilots.played[first:last] = 0
    for g in range(max(begun, first), last):
        while pilots.played[g] < ticks:
            if rows.now[0] > most:
                return g
            _decide(pilots, games, g, outlook, ground_radius, speed, top)
            _steer(games, g, pilots.pointers[g], top, change)
            if games.free[g] > 0:
                _fly(games, g)
            else:
                play_one_tick(games, g, TICK, speed, single, room)
                for n in range(single.now[0]):
                    rows.hits[rows.now[0]] = single.hits[n]
                    rows.hits[rows.now[0]]["tick"] = pilots.played[g]
                    rows.now[0] += 1
            pilots.ticks[g] += 1
            pilots.played[g] += 1
        for i in range(balls):
            lost[g, i] = has_left(games.positions[g, i], games.ball_radii[g, i], ground_radius)
    return last


def _decide(
    pilots: Pilots, games: Games, g: int, outlook: ArrayAhead, ground_radius: float, speed: float, top: float
) -> None:
    """Write where the autopilot wants a paddle in this tick: at the outermost of the balls that are not lost."""
    plan, found = pilots.plans[g], -1
    ball = Ball(0j, 0j, 1.0)
    for i in range(games.positions.shape[1]):
        other = Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i])
        if not has_left(other.position, other.radius, ground_radius):
            ball, found = other if found < 0 else outer(ball, other), i
    if found < 0:
        plan.state, pilots.pointers[g] = NOTHING, -1
        return
    if plan.state == NOTHING or plan.velocity != ball.velocity:
        replan(plan, games, g, ball, outlook, pilots.ticks[g], speed, top)
    pilots.pointers[g] = planned_pointer(plan, pilots.ticks[g])


def _steer(games: Games, g: int, pointer: int, top: float, change: float) -> None:
    """Give the paddles their spin for this tick; forget a free flight that this ends."""
    paddles = ring_of(games, g, PADDLES)
    spin = spin_to_pointer(paddles, pointer, top) if pointer >= 0 else keyed_spin(paddles.spin, 0, top, change)
    if spin != paddles.spin:
        games.spins[g, PADDLES] = spin
        if _outruns_a_ball(games, g, with_turn(paddles, paddles.phase, spin)):
            games.known[g], games.free[g] = UNKNOWN, 0


def _outruns_a_ball(games: Games, g: int, ring: Ring) -> bool:
    """Whether a ring's rim is faster than a ball, which free flights do not allow for."""
    for i in range(games.velocities.shape[1]):
        if abs(ring.spin) * ring.outer_radius > length(games.velocities[g, i]):
            return True
    return False


def _fly(games: Games, g: int) -> None:
    """One tick of a game in which nothing is touched."""
    for i in range(games.positions.shape[1]):
        ball = Ball(games.positions[g, i], games.velocities[g, i], games.ball_radii[g, i])
        games.positions[g, i] = ball.moved(TICK).position
    model = ring_of(games, g, PADDLES)
    for k in range(games.spins.shape[1]):
        if games.spins[g, k] != 0.0:
            games.phases[g, k] = with_turn(model, games.phases[g, k], games.spins[g, k]).turned(TICK).phase
    games.free[g] -= 1
