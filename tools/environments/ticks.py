"""The loop over environments and their ticks: what is compiled besides the physics and the rules' own functions.

A tick here is one of `game.rules.tick` under the source's rules, in the same order: the paddles are steered, the ball flies or
is held, hits are scored, a looping ball is nudged, and a cleared level or a lost ball ends what it ends.
`tests/environments/test_same_games.py` compares the whole game after every tick.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

from game.autopilot.source_plan import serve_wait
from game.rules import LIVES, PADDLES, TICK, Phase
from game.rules.nudging import IDLE_AFTER_NUDGE, IDLE_CONTACTS, nudged_ball
from game.rules.scoring import POINTS_PER_LIFE, layer_points
from game.rules.serving import served_ball, swung_aim
from game.rules.steering import keyed_spin, spin_to_pointer
from physics.batch.arrays import Games, Integers
from physics.batch.games import UNKNOWN, play_one_tick, ring_of, with_turn, workspace
from physics.batch.hits import Rows
from physics.broad_phase import has_left
from physics.shapes import PERMANENT, Ball, Ring
from physics.vectors import dot
from tools.autopilot.plans import NOTHING, is_outdated, planned_pointer, replan
from tools.environments.numbers import BRICKS, CUT_OFF, FINISHED, PLAY, LevelConstants, StepResults
from tools.environments.observation import bricks_turn, write_states

_SERVING, _PLAYING, _WON, _OVER = int(Phase.SERVING), int(Phase.PLAYING), int(Phase.WON), int(Phase.OVER)
_LONGEST_WAIT = 240
"""Ticks before a serve, at most: the aim swings from one side to the other in them."""
_STEP = np.uint64(0x9E3779B97F4A7C15)
_FIRST, _SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
"""Of SplitMix64 (Steele, Lea, Flood 2014), a generator that is a function of its counter."""


def step(
    numbers: LevelConstants,
    games: Games,
    episodes: Any,
    plans: Any,
    actions: Integers,
    pointers: Integers,
    results: StepResults,
    states: npt.NDArray[np.float32],
    rows: Rows,
    busy: Integers,
    begun: int,
) -> int:
    """One action of every environment. Returns -1 when all is done, -2 if an action is none of 0, 1, 2; then nothing was done.

    Any other result n means that the environment `busy[n]` needs a random number from Python; call again with `begun` = n to
    continue the step. The first call has `begun` = -1.
    games: one more than there are environments; the last one is the start of every episode.
    plans: (environments,), rows of `tools.autopilot.plans.PLAN`, for the autopilot.
    actions: 0 to rest, 1 to turn counter-clockwise, 2 clockwise. pointers: as in `game.rules.Controls`; -1 is none.
    results: written. states: rows of `observation.write_states`, written.
    rows: memory for the hits of one tick. busy: (environments + 1,), written: the environments with more than a free flight,
    and last their number.

    Busy environments come last, one after another. So the loop of free flights, which most ticks are, is short, and the
    processor works on several of them at once. In a single loop a step takes 5 % longer.
    """
    if begun < 0:
        if not _are_actions(actions):
            return -2
        _fly(numbers, games, episodes, plans, actions, pointers, results, busy)
    n = _play(numbers, games, episodes, plans, results, rows, busy, max(begun, 0))
    if n < 0:
        write_states(numbers, games, episodes, states)
    return n


def _fly(  # noqa: C901  # functions with arrays as arguments may not be called in it
    numbers: LevelConstants,
    games: Games,
    episodes: Any,
    plans: Any,
    actions: Integers,
    pointers: Integers,
    results: StepResults,
    busy: Integers,
) -> None:
    """Take the actions, and advance each environment until its ball may touch anything, or has to be served.

    A free flight is valid however the paddles are steered, since no level's paddles are faster than its ball.
    No function called here has an array as an argument: numba counts references to arrays at each call, which takes as long as
    the flight.
    """
    positions, velocities, phases, spins, free = games.positions, games.velocities, games.phases, games.spins, games.free
    model, turning, count = ring_of(games, 0, PADDLES), bricks_turn(games), 0
    for g in range(len(episodes)):
        e = episodes[g]
        results.rewards[g] = 0.0
        if e.ended != 0:
            busy[count] = g
            count += 1
            continue
        _act(numbers, e, (actions[g] & 1) - (actions[g] >> 1), pointers[g])
        while e.played < numbers.frame_skip and free[g] > 0 and e.tick < numbers.longest - 1:
            paddles = with_turn(model, phases[g, PADDLES], spins[g, PADDLES])
            ball = Ball(positions[g, 0], velocities[g, 0], numbers.ball_radius)
            if numbers.autopilot != 0:
                if is_outdated(plans[g], ball.velocity):
                    break
                e.pointer = planned_pointer(plans[g], e.tick)
            spin = _steered_spin(numbers, e, paddles)
            position = ball.moved(TICK).position
            if _may_have_left(numbers, position):
                break
            spins[g, PADDLES], phases[g, PADDLES] = spin, with_turn(model, paddles.phase, spin).turned(TICK).phase
            if turning:
                for k in range(PADDLES + 1, spins.shape[1]):
                    if spins[g, k] != 0.0:
                        phases[g, k] = with_turn(model, phases[g, k], spins[g, k]).turned(TICK).phase
            positions[g, 0] = position
            free[g] -= 1
            e.tick += 1
            e.played += 1
        if e.played < numbers.frame_skip:
            busy[count] = g
            count += 1
        results.over[g], results.cut_off[g] = False, False
        results.score[g], results.lives[g], results.ticks[g] = e.score, e.lives, e.tick
    busy[len(episodes)] = count


def _play(
    numbers: LevelConstants,
    games: Games,
    episodes: Any,
    plans: Any,
    results: StepResults,
    rows: Rows,
    busy: Integers,
    begun: int,
) -> int:
    """Finish the step of the busy environments from index `begun` on. Returns -1, or the index that needs a random number."""
    room = workspace(games)
    for n in range(begun, busy[len(episodes)]):
        g = busy[n]
        e, score = episodes[g], episodes[g].score
        if e.ended != 0:
            if numbers.resets != 0:
                begin(numbers, games, episodes, g)
            e.played, score = numbers.frame_skip, e.score
        e.changed = max(e.changed, PLAY)
        while e.ended == 0 and e.played < numbers.frame_skip:
            if e.waiting != 0:
                _nudge(games, e, g)
            else:
                if numbers.autopilot != 0:
                    _decide(numbers, games, e, plans[g], g)
                _steer(numbers, games, e, g)
                e.tick += 1
                if e.phase == _PLAYING:
                    play_one_tick(games, g, TICK, numbers.speed, rows, room)
                    _credit(e, rows)
                else:
                    _serve(numbers, games, e, g)
            if e.waiting != 0:
                results.rewards[g] += e.score - score
                return n
            _end(numbers, games, e, g)
        results.rewards[g] += e.score - score
        results.over[g], results.cut_off[g] = e.ended == FINISHED, e.ended == CUT_OFF
        results.score[g], results.lives[g], results.ticks[g] = e.score, e.lives, e.tick
    return -1


def begin(numbers: LevelConstants, games: Games, episodes: Any, g: int) -> None:
    """The next episode of an environment: the ball on its paddle, no tick played."""
    e, start = episodes[g], len(episodes)
    e.number += 1
    e.seed = np.int64(mixed(e.base + np.uint64(e.number) * _STEP) >> np.uint64(1))
    e.tick, e.phase, e.phase_start = 0, _SERVING, 0
    e.score, e.lives, e.combo, e.idle, e.draws, e.left = 0, LIVES, 0, 0, 0, numbers.bricks
    e.waiting, e.turn, e.pointer, e.ended, e.changed, e.played, e.served = 0, 0, -1, 0, BRICKS, 0, 0
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


def _are_actions(actions: Integers) -> bool:
    """Whether all actions are 0, 1, or 2."""
    wrong = 0
    for action in actions:
        wrong |= (action < 0) | (action > 2)
    return wrong == 0


def _act(numbers: LevelConstants, e: Any, turn: int, pointer: int) -> None:
    """Take an action, or hold the one before it, by chance."""
    e.played = 0
    if numbers.repeat > 0.0:
        e.actions += 1
        number = mixed(mixed(e.base ^ _FIRST) + np.uint64(e.actions) * _STEP)
        if np.float64(number >> np.uint64(11)) * 2.0**-53 < numbers.repeat:
            return
    e.turn, e.pointer = turn, pointer


def _steered_spin(numbers: LevelConstants, e: Any, paddles: Ring) -> float:
    """The paddles' spin for this tick."""
    if e.pointer >= 0 and e.turn == 0:  # the first is the same in all games, so it is predicted
        return spin_to_pointer(paddles, e.pointer, numbers.top)
    return keyed_spin(paddles.spin, e.turn, numbers.top, numbers.change)


def _may_have_left(numbers: LevelConstants, position: complex) -> bool:
    """Whether the ball's centre is outside of the ground, computed without a square root."""
    return dot(position, position) > numbers.ground_radius * numbers.ground_radius


def _steer(numbers: LevelConstants, games: Games, e: Any, g: int) -> None:
    """Give the paddles their spin for this tick."""
    games.spins[g, PADDLES] = _steered_spin(numbers, e, ring_of(games, g, PADDLES))


def _decide(numbers: LevelConstants, games: Games, e: Any, plan: Any, g: int) -> None:
    """Ask the autopilot where it wants a paddle in this tick."""
    e.pointer = -1
    if e.phase != _PLAYING:
        plan.state = NOTHING
        return
    if is_outdated(plan, games.velocities[g, 0]):
        ball = Ball(games.positions[g, 0], games.velocities[g, 0], numbers.ball_radius)
        replan(plan, games, g, ball, e.tick, numbers.speed, numbers.top)
    e.pointer = planned_pointer(plan, e.tick)


def _serve(numbers: LevelConstants, games: Games, e: Any, g: int) -> None:
    """A tick before the serve: rings turn, and the ball follows its paddle until it is served."""
    for k in range(games.spins.shape[1]):
        games.phases[g, k] = ring_of(games, g, k).turned(TICK).phase
    waited = e.tick - e.phase_start
    ball = served_ball(ring_of(games, g, PADDLES), numbers.ball_radius, numbers.speed, swung_aim(waited))
    games.positions[g, 0], games.velocities[g, 0] = ball.position, ball.velocity
    if waited > e.serve_at:
        e.phase, e.phase_start, e.idle, e.combo, e.served = _PLAYING, e.tick, 0, 0, e.tick


def _credit(e: Any, rows: Rows) -> None:
    """Score the hits of a tick."""
    for n in range(rows.now[0]):
        ring, layers = rows.hits[n]["ring"], rows.hits[n]["layers"]
        if ring == PADDLES:
            e.combo, e.idle = 0, e.idle + 1
        elif layers == PERMANENT:
            e.idle += 1
        else:
            e.combo, e.idle, e.changed = e.combo + 1, 0, BRICKS
            e.score += layer_points(e.combo)
            e.left -= 1 if layers == 0 else 0
    if e.idle >= IDLE_CONTACTS:
        e.waiting = 1


def _nudge(games: Games, e: Any, g: int) -> None:
    """Turn the ball by the chance that was drawn."""
    ball = nudged_ball(Ball(games.positions[g, 0], games.velocities[g, 0], games.ball_radii[g, 0]), e.chance)
    games.velocities[g, 0] = ball.velocity
    games.known[g], games.free[g] = UNKNOWN, 0
    e.draws, e.idle, e.waiting = e.draws + 1, IDLE_AFTER_NUDGE, 0


def _end(numbers: LevelConstants, games: Games, e: Any, g: int) -> None:
    """What ends with a tick: the level with its last brick, else a life with its ball, the game with its last life."""
    if e.phase == _PLAYING:
        if e.left == 0:
            e.score += POINTS_PER_LIFE * e.lives
            e.phase, e.phase_start, e.ended = _WON, e.tick, FINISHED
        elif has_left(games.positions[g, 0], numbers.ball_radius, numbers.ground_radius):
            e.lives, e.combo, e.idle, e.phase_start = e.lives - 1, 0, 0, e.tick
            if e.lives == 0:
                e.phase, e.ended = _OVER, FINISHED
            else:
                e.phase = _SERVING
                _hold(numbers, games, e, g)
    e.played += 1
    if e.tick >= numbers.longest and e.ended == 0:
        e.ended = CUT_OFF


def _hold(numbers: LevelConstants, games: Games, e: Any, g: int) -> None:
    """A new ball on its paddle, to be served after a number of ticks that the game's seed and its lives decide."""
    if numbers.autopilot != 0:
        e.serve_at = serve_wait(e.seed, e.lives, 0, e.score)
    else:
        e.serve_at = np.int64(mixed(np.uint64(e.seed) * _FIRST + np.uint64(e.lives) * _STEP) >> np.uint64(1)) % _LONGEST_WAIT
    games.known[g], games.free[g] = UNKNOWN, 0
    ball = served_ball(ring_of(games, g, PADDLES), numbers.ball_radius, numbers.speed, swung_aim(e.tick - e.phase_start))
    games.positions[g, 0], games.velocities[g, 0] = ball.position, ball.velocity
