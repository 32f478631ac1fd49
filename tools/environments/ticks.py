"""The loop over environments and their ticks: what is compiled besides the physics and the rules' own functions.

A tick here is one of `game.rules.tick` under the source's rules, in the same order: the paddles are steered, the ball flies or
is held, hits are scored, a looping ball is nudged, and a cleared level or a lost ball ends what it ends.
`tests/environments/test_same_games.py` compares the whole game after every tick.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

from game.rules import LIVES, PADDLES, TICK, Phase
from game.rules.nudging import IDLE_AFTER_NUDGE, IDLE_CONTACTS, nudged_ball
from game.rules.scoring import POINTS_PER_LIFE, layer_points
from game.rules.serving import served_ball, swung_aim
from game.rules.steering import keyed_spin, spin_to_pointer
from physics.batch.arrays import Floats, Games, Integers
from physics.batch.games import UNKNOWN, play_one_tick, ring_of, startable, with_turn, workspace
from physics.batch.hits import Rows
from physics.broad_phase import has_left
from physics.free_flight import may_be_steered
from physics.shapes import PERMANENT, Ball, Ring
from physics.vectors import dot
from tools.environments.numbers import LevelNumbers
from tools.environments.observation import FIXED_NUMBERS, fixed_numbers, write_rest

_SERVING, _PLAYING, _WON, _OVER = int(Phase.SERVING), int(Phase.PLAYING), int(Phase.WON), int(Phase.OVER)
_LONGEST_WAIT = 240
"""Ticks before a serve, at most: the aim swings from one side to the other in them."""
_STEP = np.uint64(0x9E3779B97F4A7C15)
_FIRST, _SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
"""Of SplitMix64 (Steele, Lea, Flood 2014), a generator that is a function of its counter."""


def step(  # noqa: C901, PLR0912, PLR0915  # in pieces that are given the arrays it is half as fast
    numbers: LevelNumbers,
    games: Games,
    episodes: Any,
    actions: Integers,
    pointers: Integers,
    rewards: Floats,
    ended: npt.NDArray[np.bool_],
    states: npt.NDArray[np.float32],
    rows: Rows,
    first: int,
) -> int:
    """One action of every environment from `first` on; the number to go on with, where a chance must be drawn first.

    games: one more than there are environments; the last is as every episode begins.
    actions: 0 to rest, 1 to turn counter-clockwise, 2 clockwise. pointers: as in `game.rules.Controls`; -1 is none.
    rewards: (environments,), written: the points scored. ended: (2, environments), written: won or over, and cut off.
    states: rows of `observation.write_row`, written, unless they have no columns. rows: room for the hits of one tick.
    """
    positions, velocities, phases, spins = games.positions, games.velocities, games.phases, games.spins
    known, free, model, room = games.known, games.free, ring_of(games, 0, PADDLES), workspace(games)
    turning = 0
    for k in range(PADDLES + 1, spins.shape[1]):
        turning += 1 if spins[len(episodes), k] != 0.0 else 0
    for g in range(first, len(episodes)):
        e = episodes[g]
        if e.waiting == 0:
            if e.ended != 0:
                if numbers.resets != 0:
                    begin(numbers, games, episodes, g)
                e.before, e.played = e.score, numbers.frame_skip
            else:
                _act(numbers, e, (actions[g] & 1) - (actions[g] >> 1), pointers[g])
        while e.ended == 0 and e.played < numbers.frame_skip:
            if e.waiting == 0:
                paddles = with_turn(model, phases[g, PADDLES], spins[g, PADDLES])
                ball = Ball(positions[g, 0], velocities[g, 0], numbers.ball_radius)
                spin = _steered_spin(numbers, e, paddles)
                if spin != paddles.spin:
                    if not may_be_steered(startable(paddles), with_turn(paddles, paddles.phase, spin), (ball,)):
                        known[g], free[g] = UNKNOWN, 0
                    spins[g, PADDLES] = spin
                e.tick += 1
                e.phase_tick += 1
                if e.phase == _PLAYING and free[g] == 0:
                    play_one_tick(games, g, TICK, numbers.speed, rows, room)
                    _credit(e, rows)
                else:
                    for k in range(spins.shape[1]):
                        if spins[g, k] != 0.0:
                            phases[g, k] = with_turn(model, phases[g, k], spins[g, k]).turned(TICK).phase
                    if e.phase == _PLAYING:
                        free[g] -= 1
                        positions[g, 0] = ball.moved(TICK).position
                    else:
                        ball = _serving(numbers, e, with_turn(paddles, phases[g, PADDLES], spin))
                        positions[g, 0], velocities[g, 0] = ball.position, ball.velocity
            if e.waiting != 0:
                if e.drawn == 0:
                    return g
                _nudge(games, e, g)
            if e.phase == _PLAYING:
                _end(numbers, e, positions[g, 0])
                if e.phase == _SERVING:
                    _hold(numbers, games, e, g)
            e.played += 1
            if e.tick >= numbers.longest:
                e.ended = 1
        rewards[g] = e.score - e.before
        ended[0, g] = e.phase == _WON or e.phase == _OVER  # noqa: PLR1714  # what compiles
        ended[1, g] = e.ended != 0 and not ended[0, g]
        if states.shape[1] > 0:
            phase, spin = phases[g, PADDLES], spins[g, PADDLES]
            fixed = fixed_numbers(numbers, e, positions[g, 0], velocities[g, 0], phase, spin)
            for n in range(FIXED_NUMBERS):
                states[g, n] = fixed[n]
            if e.changed != 0 or turning > 0:
                write_rest(games, e, states, g)
    return len(episodes)


def begin(numbers: LevelNumbers, games: Games, episodes: Any, g: int) -> None:
    """The next episode of an environment: the ball on its paddle, no tick played."""
    e, start = episodes[g], len(episodes)
    e.number += 1
    e.seed = np.int64(mixed(e.base + np.uint64(e.number) * _STEP) >> np.uint64(1))
    e.tick, e.phase, e.phase_tick = 0, _SERVING, 0
    e.score, e.lives, e.combo, e.idle, e.draws, e.left = 0, LIVES, 0, 0, 0, numbers.bricks
    e.waiting, e.drawn, e.turn, e.pointer, e.ended, e.changed, e.played, e.served = 0, 0, 0, -1, 0, 1, 0, -1
    for k in range(games.spins.shape[1]):
        games.phases[g, k], games.spins[g, k] = games.phases[start, k], games.spins[start, k]
        for slot in range(games.layers.shape[2]):
            games.layers[g, k, slot] = games.layers[start, k, slot]
    games.ball_radii[g, 0] = numbers.ball_radius
    _hold(numbers, games, e, g)


def mixed(counter: np.uint64) -> np.uint64:
    """SplitMix64's number for a counter. Only compiled code wraps around in silence."""
    counter = (counter ^ (counter >> np.uint64(30))) * _FIRST
    counter = (counter ^ (counter >> np.uint64(27))) * _SECOND
    return counter ^ (counter >> np.uint64(31))


def _act(numbers: LevelNumbers, e: Any, turn: int, pointer: int) -> None:
    """Take an action, or hold the one before it, by chance."""
    e.before, e.played, e.served = e.score, 0, -1
    e.actions += 1
    if numbers.repeat > 0.0:
        number = mixed(mixed(e.base ^ _FIRST) + np.uint64(e.actions) * _STEP)
        if np.float64(number >> np.uint64(11)) * 2.0**-53 < numbers.repeat:
            return
    e.turn, e.pointer = turn, pointer


def _steered_spin(numbers: LevelNumbers, e: Any, paddles: Ring) -> float:
    """The paddles' spin for this tick."""
    if e.turn == 0 and e.pointer >= 0:
        return spin_to_pointer(paddles, e.pointer, numbers.top)
    return keyed_spin(paddles.spin, e.turn, numbers.top, numbers.change)


def _serving(numbers: LevelNumbers, e: Any, paddles: Ring) -> Ball:
    """The ball that follows its paddle until it is served. paddles: after the tick."""
    ball = served_ball(paddles, numbers.ball_radius, numbers.speed, swung_aim(e.phase_tick))
    if e.phase_tick > e.serve_at:
        e.phase, e.phase_tick, e.idle, e.combo, e.served = _PLAYING, 0, 0, 0, e.played
    return ball


def _credit(e: Any, rows: Rows) -> None:
    """Score the hits of a tick."""
    for n in range(rows.now[0]):
        ring, layers = rows.hits[n]["ring"], rows.hits[n]["layers"]
        if ring == PADDLES:
            e.combo, e.idle = 0, e.idle + 1
        elif layers == PERMANENT:
            e.idle += 1
        else:
            e.combo, e.idle, e.changed = e.combo + 1, 0, 1
            e.score += layer_points(e.combo)
            e.left -= 1 if layers == 0 else 0
    if e.idle >= IDLE_CONTACTS:
        e.waiting = 1


def _nudge(games: Games, e: Any, g: int) -> None:
    """Turn the ball by the chance that was drawn."""
    ball = nudged_ball(Ball(games.positions[g, 0], games.velocities[g, 0], games.ball_radii[g, 0]), e.chance)
    games.velocities[g, 0] = ball.velocity
    games.known[g], games.free[g] = UNKNOWN, 0
    e.draws, e.idle, e.waiting, e.drawn = e.draws + 1, IDLE_AFTER_NUDGE, 0, 0


def _end(numbers: LevelNumbers, e: Any, position: complex) -> None:
    """What ends with a tick: the level with its last brick, else a life with its ball, the game with its last life."""
    if e.left == 0:
        e.score += POINTS_PER_LIFE * e.lives
        e.phase, e.phase_tick, e.ended = _WON, 0, 1
    elif dot(position, position) > numbers.ground_radius * numbers.ground_radius and has_left(  # the root is seldom needed
        position, numbers.ball_radius, numbers.ground_radius
    ):
        e.lives, e.combo, e.idle, e.phase_tick = e.lives - 1, 0, 0, 0
        e.ended = 1 if e.lives == 0 else 0
        e.phase = _OVER if e.lives == 0 else _SERVING


def _hold(numbers: LevelNumbers, games: Games, e: Any, g: int) -> None:
    """A new ball on its paddle, to be served after a number of ticks that the game's seed and its lives decide."""
    e.serve_at = np.int64(mixed(np.uint64(e.seed) * _FIRST + np.uint64(e.lives) * _STEP) >> np.uint64(1)) % _LONGEST_WAIT
    games.known[g], games.free[g] = UNKNOWN, 0
    ball = served_ball(ring_of(games, g, PADDLES), numbers.ball_radius, numbers.speed, swung_aim(e.phase_tick))
    games.positions[g, 0], games.velocities[g, 0] = ball.position, ball.velocity
