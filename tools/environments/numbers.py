"""What the compiled ticks are given: a level's numbers, and an episode as one row of an array."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

FINISHED, CUT_OFF = 1, 2
"""How an episode has ended: won or over; after its last tick."""

PLAY, BRICKS = 1, 2
"""Which observations have to be written besides the ball's position: velocity and lives; bricks as well."""

EPISODE = np.dtype(
    [
        ("turn", np.int64),
        ("pointer", np.int64),
        ("played", np.int64),
        ("tick", np.int64),
        ("ended", np.int64),
        ("waiting", np.int64),
        ("score", np.int64),
        ("lives", np.int64),
        ("phase", np.int64),
        ("phase_start", np.int64),
        ("combo", np.int64),
        ("idle", np.int64),
        ("left", np.int64),
        ("changed", np.int64),
        ("serve_at", np.int64),
        ("served", np.int64),
        ("draws", np.int64),
        ("chance", np.float64),
        ("number", np.int64),
        ("seed", np.int64),
        ("base", np.uint64),
        ("actions", np.int64),
    ],
    align=True,
)
"""One environment and the episode that it is in.

What a tick without a hit needs comes first: it is one line of the processor's cache.
turn, pointer: the controls that are held; a pointer of -1 is none. played: ticks of the step.
tick, score, lives, phase, combo, idle, draws, seed: as in `game.rules.Game`. phase_start: the tick in which the phase began.
ended: 0, FINISHED, CUT_OFF. waiting: 1 where the tick goes on with a nudge, for which `chance` is wanted.
left: slots with bricks. changed: 0, PLAY, BRICKS: what is not yet observed.
serve_at: tick of the phase in which it serves. served: the last tick that served, from 1; 0 before the first.
number: of the episode, from 1; 0 before the first. base: what the seeds of its games are made of. actions: taken since the
seed, where some are not taken by chance.
"""


class StepResults(NamedTuple):
    """The results of a step, each an array with a number for every environment.

    Attributes:
        rewards: the points that were scored.
        over: whether the episode is won or lost.
        cut_off: whether it has reached `max_ticks`.
        score: of the episode.
        lives: left.
        ticks: of the episode.
    """

    rewards: npt.NDArray[np.float64]
    over: npt.NDArray[np.bool_]
    cut_off: npt.NDArray[np.bool_]
    score: npt.NDArray[np.int64]
    lives: npt.NDArray[np.int64]
    ticks: npt.NDArray[np.int64]


def new_results(count: int) -> StepResults:
    """Arrays for the results of `count` environments."""
    flags, numbers = np.empty((2, count), np.bool_), np.empty((3, count), np.int64)
    return StepResults(np.empty(count), *flags, *numbers)


class LevelConstants(NamedTuple):
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
        autopilot: 1 where the autopilot plays, and not the actions.
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
    autopilot: int
    resets: int
    near: float
    pace: float
    turn: float
