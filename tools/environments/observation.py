"""What an agent sees, as compiled functions: the state's numbers, or cells of a picture."""

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from game.rules import LIVES, PADDLES, Phase
from physics.batch.arrays import Floats, Games, Integers
from physics.shapes import PERMANENT
from tools.environments.numbers import BRICKS, LevelConstants

FIXED_NUMBERS = 9
"""Numbers of the state before those of turning rings and bricks."""
MOST_LAYERS = 9
"""Layers of a brick at most, by the format of levels."""

_PLAYING = int(Phase.PLAYING)
_BALL, _PADDLE, _WALL, _BRICK, _LAYER = 255, 200, 160, 60, 8
"""Grey values; a brick's grows with its layers."""


class Cells(NamedTuple):
    """The points at which a picture is sampled, each in the middle of its cell.

    Attributes:
        positions: world units.
        angles: radians, in [0, 2 pi).
        rings: the ring in whose band the point is; -1 for none.
        reaches: world units, from the point to its cell's corners: a ball as near as that is seen, however small it is.
    """

    positions: npt.NDArray[np.complex128]
    angles: Floats
    rings: Integers
    reaches: Floats


def numbers_of_state(start: Games) -> int:
    """How many numbers `write_row` writes for a game."""
    turning = [k for k in range(1, start.spins.shape[1]) if start.spins[0, k] != 0.0]
    return FIXED_NUMBERS + 2 * len(turning) + int(start.counts[PADDLES + 1 :].sum())


def write_states(numbers: LevelConstants, games: Games, episodes: Any, states: npt.NDArray[np.float32]) -> None:
    """The state of every game in its row, in [-1, 1], unless the rows have no columns.

    Position (2) and velocity (2) of the ball; cosine and sine of the angle of paddle 0, their spin; 1 with the ball in play, 0
    while it is held; lives left; cosine and sine of the phase of every turning ring of bricks; layers, of every slot of every
    ring of bricks, in ninths; negative where unbreakable.
    """
    if states.shape[1] == 0:
        return
    for g in range(len(episodes)):
        position = games.positions[g, 0]
        states[g, 0], states[g, 1] = _within(position.real * numbers.near), _within(position.imag * numbers.near)
        states[g, 4], states[g, 5] = cosine_and_sine(games.phases[g, PADDLES])
        states[g, 6] = games.spins[g, PADDLES] * numbers.turn
    turning = bricks_turn(games)
    for g in range(len(episodes)):
        if turning or episodes[g].changed != 0:
            _write_rest(numbers, games, episodes[g], states, g)


def bricks_turn(games: Games) -> bool:
    """Whether any ring of bricks turns."""
    turning = 0
    for k in range(PADDLES + 1, games.spins.shape[1]):
        turning += 1 if games.spins[0, k] != 0.0 else 0
    return turning > 0


def _write_rest(numbers: LevelConstants, games: Games, e: Any, states: npt.NDArray[np.float32], g: int) -> None:
    """Write the numbers that do not change in every tick, if they have changed."""
    velocity = games.velocities[g, 0]
    states[g, 2], states[g, 3] = _within(velocity.real * numbers.pace), _within(velocity.imag * numbers.pace)
    states[g, 7], states[g, 8] = 1.0 if e.phase == _PLAYING else 0.0, e.lives * (1.0 / LIVES)
    n = FIXED_NUMBERS
    for k in range(PADDLES + 1, games.spins.shape[1]):
        if games.spins[g, k] != 0.0:
            states[g, n], states[g, n + 1] = cosine_and_sine(games.phases[g, k])
            n += 2
    if e.changed == BRICKS:
        for k in range(PADDLES + 1, games.spins.shape[1]):
            for slot in range(games.counts[k]):
                states[g, n] = games.layers[g, k, slot] * (1.0 / MOST_LAYERS)
                n += 1
    e.changed = 0


def cosine_and_sine(angle: float) -> tuple[float, float]:
    """Cosine and sine, off by less than 4e-8: as precise as the observations' floats. angle: radians, in [0, 2 pi].

    Without a branch on the quadrant, which the processor would guess wrong in most games: a third of `physics.direction`.
    """
    quarters = math.floor(angle * (2.0 / math.pi) + 0.5)
    rest = angle - quarters * (math.pi / 2.0)
    s = rest * rest
    t = s * s  # each sum is split into two parts that the processor adds at the same time
    cosine = 1.0 - s * (1 / 2) + t * ((1 / 24 - s * (1 / 720)) + t * (1 / 40320))
    sine = rest + rest * s * ((s * (1 / 120) - 1 / 6) + t * (s * (1 / 362880) - 1 / 5040))
    odd, backward, below = quarters & 1, (quarters + 1) & 2, quarters & 2
    x, y = (sine, cosine) if odd else (cosine, sine)
    return -x if backward else x, -y if below else y


def _within(number: float) -> float:
    """The number, in [-1, 1]: a rounding error may lead beyond."""
    return min(max(number, -1.0), 1.0)


def paint(games: Games, cells: Cells, only: Integers, pictures: npt.NDArray[np.uint8]) -> None:
    """Grey pictures of some games: black ground; bricks, brighter by their layers; walls, paddles; the ball is white.

    only: the games' numbers. pictures: (len(only), cells), written.
    """
    for n in range(len(only)):
        g = only[n]
        p, radius = games.positions[g, 0], games.ball_radii[g, 0]
        for c in range(len(cells.angles)):
            grey, k = 0, cells.rings[c]
            if k >= 0:
                pitch = math.tau / games.counts[k]
                turns = (cells.angles[c] - games.phases[g, k]) / pitch
                slot = math.floor(turns + 0.5)
                if abs(turns - slot) * pitch <= games.half_angles[k]:
                    grey = _grey(k, games.layers[g, k, slot % games.counts[k]])
            d = cells.positions[c] - p
            reach = max(radius, cells.reaches[c])
            if d.real * d.real + d.imag * d.imag <= reach * reach:
                grey = _BALL
            pictures[n, c] = grey


def _grey(ring: int, layers: int) -> int:
    """The grey value of a slot."""
    if layers == 0:
        return 0
    if ring == PADDLES:
        return _PADDLE
    return _WALL if layers == PERMANENT else _BRICK + _LAYER * layers


def square_cells(start: Games, ground_radius: float, size: int) -> Cells:
    """The cells of a square picture of the ground, seen from above: row by row, from the top."""
    across = ((np.arange(size) + 0.5) / size * 2.0 - 1.0) * ground_radius
    positions = (across[np.newaxis, :] - 1j * across[:, np.newaxis]).ravel()
    return _cells(start, positions, np.full(size * size, math.sqrt(2.0) * ground_radius / size))


def unrolled_cells(start: Games, ground_radius: float, rows: int, columns: int) -> Cells:
    """The cells of the ground unrolled: rows are distances from the centre, growing; columns are angles, counter-clockwise."""
    radii = (np.arange(rows) + 0.5) / rows * ground_radius
    angles = (np.arange(columns) + 0.5) / columns * math.tau
    positions = (radii[:, np.newaxis] * np.exp(1j * angles)[np.newaxis, :]).ravel()
    return _cells(
        start,
        positions,
        np.hypot(ground_radius / rows / 2.0, (np.abs(positions) + ground_radius / rows / 2.0) * math.pi / columns),
    )


def _cells(start: Games, positions: npt.NDArray[np.complex128], reaches: Floats) -> Cells:
    """The cells with these middles."""
    distances = np.abs(positions)
    rings = np.full(len(positions), -1, np.int64)
    for k, (radius, half_width) in enumerate(zip(start.ring_radii, start.half_widths, strict=True)):
        rings[np.abs(distances - radius) <= half_width] = k
    return Cells(positions, np.angle(positions) % math.tau, rings, reaches)
