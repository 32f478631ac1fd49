"""What the compiled ticks are given: a level's numbers, and an episode as one row of an array."""

from typing import NamedTuple

import numpy as np

EPISODE = np.dtype(
    [
        ("base", np.uint64),
        ("number", np.int64),
        ("seed", np.int64),
        ("tick", np.int64),
        ("phase", np.int64),
        ("phase_tick", np.int64),
        ("score", np.int64),
        ("lives", np.int64),
        ("combo", np.int64),
        ("idle", np.int64),
        ("draws", np.int64),
        ("left", np.int64),
        ("serve_at", np.int64),
        ("waiting", np.int64),
        ("drawn", np.int64),
        ("chance", np.float64),
        ("turn", np.int64),
        ("pointer", np.int64),
        ("actions", np.int64),
        ("before", np.int64),
        ("ended", np.int64),
        ("changed", np.int64),
        ("played", np.int64),
        ("served", np.int64),
    ],
    align=True,
)
"""One environment and the episode that it is in.

base: what the seeds of its games are made of. number: of the episode, from 1; 0 before the first.
seed, tick, phase, phase_tick, score, lives, combo, idle, draws: as in `game.rules.Game`. left: slots with bricks.
serve_at: tick of the phase in which it serves. waiting: 1 where the tick goes on with a nudge, for which `chance` is wanted;
drawn: 1 where it is there. turn, pointer: the controls that are held; a pointer of -1 is none. actions: taken since the seed.
before: score at the step's start. ended: 1 after the last tick of an episode. changed: 1 where bricks are not yet observed.
played, served: ticks of the step, and the one, from 0, that served; -1 for none.
"""


class LevelNumbers(NamedTuple):
    """What is the same in all environments.

    Attributes:
        top: rad/s, of the paddles at most.
        change: rad/s, of the paddles' spin in one tick at most, by keys.
        ball_radius: world units.
        speed: of the ball, world units per second.
        ground_radius: world units.
        bricks: slots with bricks at the start.
        frame_skip: ticks that an action is held.
        longest: ticks of an episode at most.
        repeat: probability that an action is not taken, and the one before it held.
        resets: 1 where the step after an episode's end begins the next one.
        near, pace, turn: what positions, velocities and spins are multiplied by to lie in [-1, 1].
    """

    top: float
    change: float
    ball_radius: float
    speed: float
    ground_radius: float
    bricks: int
    frame_skip: int
    longest: int
    repeat: float
    resets: int
    near: float
    pace: float
    turn: float
