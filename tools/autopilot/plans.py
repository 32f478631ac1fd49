"""The autopilot's plans of many games, and what it looks ahead with: compiled beside `game.autopilot`'s own functions.

`with_ball`, `flown` and the others do on arrays what the functions of these names in `game.autopilot.prediction` do on an
`Arena`; in compiled code they take their place.
"""

from typing import Any, NamedTuple

import numpy as np

from game.autopilot.prediction import LOOK, pointer_to
from game.autopilot.source_plan import Plan, planned, wanted_angle
from game.rules import PADDLES
from physics.batch.arrays import Games
from physics.batch.games import CLEAR, UNKNOWN, Workspace, lines_turned, play_one_tick, ring_of, turned, workspace
from physics.batch.hits import HIT, Rows
from physics.shapes import Ball
from physics.tolerances import MAX_IMPACTS

PLAN = np.dtype(
    [("state", np.int64), ("velocity", np.complex128), ("tick", np.int64), ("bearing", np.float64), ("spin", np.float64)],
    align=True,
)
"""What the autopilot intends in one game.

state: NOTHING, AWAY or MEETING. velocity: of the ball for which it was planned. The rest as in `source_plan.Plan`.
"""
NOTHING, AWAY, MEETING = 0, 1, 2
"""Nothing is planned; the ball does not come to the paddles within the horizon; it is met."""

_STATES = 5
"""Of a game that is looked ahead into: as it is; two in turn until the ball comes to the track; two until it comes again."""
ONE_TICK = 2 * MAX_IMPACTS
"""Hits of a ball in a tick, at most."""


class ArrayAhead(NamedTuple):
    """One ball and the bricks, at a moment that was looked ahead to: `game.autopilot.prediction.Ahead`, on arrays.

    Attributes:
        games: the states that are looked at, each a game of one ball without paddles.
        rows: memory for the hits of a step.
        room: memory for a game.
        now: number of the state that this one is.
        next: number of the state that a step is written to.
        hits: of the last step.
    """

    games: Games
    rows: Rows
    room: Workspace
    now: int
    next: int
    hits: int


def replan(plan: Any, games: Games, g: int, ball: Ball, tick: int, speed: float, top: float) -> None:
    """Plan anew how a ball of game g is met: `write_plan`. By it loops call what is compiled."""
    write_plan(plan, games, g, ball, tick, speed, top)


def write_plan(plan: Any, games: Games, g: int, ball: Ball, tick: int, speed: float, top: float) -> None:
    """Plan anew how a ball of game g is met. plan: a row of PLAN, written. The others as `source_plan.planned` takes them."""
    bricks = new_array_ahead(games)
    _copy_bricks(games, g, PADDLES + 1, bricks.games, 0)
    found = planned(bricks, ring_of(games, g, PADDLES), ball, tick, speed, top)  # type: ignore[arg-type]  # in place of an Ahead
    plan.velocity, plan.state = ball.velocity, AWAY
    if found is not None:
        plan.state, plan.tick, plan.bearing, plan.spin = MEETING, found.tick, found.bearing, found.spin


def is_outdated(plan: Any, velocity: complex) -> bool:
    """Whether a ball of this velocity needs another plan."""
    return bool(plan.state == NOTHING or plan.velocity != velocity)


def planned_pointer(plan: Any, tick: int) -> int:
    """Where the plan wants a paddle in a tick, as in `Controls.pointer`; -1 for nowhere."""
    return pointer_to(wanted_angle(Plan(plan.tick, plan.bearing, plan.spin), tick)) if plan.state == MEETING else -1


def new_array_ahead(games: Games) -> ArrayAhead:
    """Room to look ahead in any of these games."""
    rings, slots = games.layers.shape[1] - 1, games.layers.shape[2]
    states = Games(
        np.zeros((_STATES, 1), np.complex128),
        np.zeros((_STATES, 1), np.complex128),
        np.zeros((_STATES, 1), np.float64),
        np.zeros((_STATES, rings), np.float64),
        np.zeros((_STATES, rings), np.float64),
        np.zeros((_STATES, rings, slots), np.int8),
        games.ring_radii[PADDLES + 1 :].copy(),
        games.half_widths[PADDLES + 1 :].copy(),
        games.half_angles[PADDLES + 1 :].copy(),
        games.counts[PADDLES + 1 :].copy(),
        games.frictions[PADDLES + 1 :].copy(),
        np.zeros(rings, np.int64),
        np.zeros(_STATES, np.int64),
        np.zeros(_STATES, np.int64),
        np.zeros(_STATES, np.int64),
        np.zeros(_STATES, np.int64),
        np.zeros(_STATES, np.int64),
    )
    return ArrayAhead(states, Rows(np.empty(ONE_TICK, HIT), np.zeros(3, np.int64)), workspace(states), 0, 0, 0)


def with_ball(bricks: ArrayAhead, ball: Ball) -> ArrayAhead:
    """The ball among the bricks."""
    games, now = bricks.games, (bricks.now + 1) // 2 * 2 + 1
    _copy_bricks(games, bricks.now, 0, games, now)
    games.positions[now, 0], games.velocities[now, 0], games.ball_radii[now, 0] = ball.position, ball.velocity, ball.radius
    games.known[now], games.free[now] = UNKNOWN, 0
    return ArrayAhead(games, bricks.rows, bricks.room, now, now + 1, 0)


def ball_of(ahead: ArrayAhead) -> Ball:
    """The ball that is looked at."""
    games, g = ahead.games, ahead.now
    return Ball(games.positions[g, 0], games.velocities[g, 0], games.ball_radii[g, 0])


def flown(ahead: ArrayAhead, seconds: float, speed: float) -> ArrayAhead:
    """So much later. The state before is left as it is."""
    games, now, later = ahead.games, ahead.now, ahead.next
    _copy_bricks(games, now, 0, games, later)
    games.positions[later, 0], games.velocities[later, 0] = games.positions[now, 0], games.velocities[now, 0]
    games.ball_radii[later, 0] = games.ball_radii[now, 0]
    games.known[later], games.free[later] = games.known[now], games.free[now]
    if seconds != LOOK:  # what is known is known of ticks of LOOK
        games.known[later], games.free[later] = min(games.known[now], CLEAR), 0
    ahead.rows.now[0] = 0
    if seconds > 0.0:
        play_one_tick(games, later, seconds, speed, ahead.rows, ahead.room)
    return ArrayAhead(games, ahead.rows, ahead.room, later, now, ahead.rows.now[0])


def free_seconds(ahead: ArrayAhead) -> float:
    """For how long nothing is touched, as far as that is known."""
    ticks: int = ahead.games.free[ahead.now]
    return ticks * LOOK


def flown_freely(ahead: ArrayAhead, steps: int) -> ArrayAhead:
    """Some steps of LOOK later, in which nothing is touched. The state before is overwritten."""
    games, g = ahead.games, ahead.now
    ball = ball_of(ahead)
    for _ in range(steps):
        ball = ball.moved(LOOK)
    games.positions[g, 0] = ball.position
    for k in range(games.spins.shape[1]):
        if games.spins[g, k] != 0.0:
            games.phases[g, k] = turned(games.phases[g, k], lines_turned(games.spins[g, k], steps, LOOK))
    games.free[g] -= steps
    return ahead


def _copy_bricks(source: Games, g: int, first: int, target: Games, h: int) -> None:
    """Copy phases, spins and layers of game g's rings from `first` on to all rings of game h of the target."""
    for k in range(target.spins.shape[1]):
        target.phases[h, k], target.spins[h, k] = source.phases[g, first + k], source.spins[g, first + k]
        for slot in range(target.layers.shape[2]):
            target.layers[h, k, slot] = source.layers[g, first + k, slot]
