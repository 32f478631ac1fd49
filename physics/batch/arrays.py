"""The state of many games of one shape, as arrays: made of arenas, and turned back into one."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from physics.shapes import Arena, Ball, Ring

Floats = npt.NDArray[np.float64]
Complexes = npt.NDArray[np.complex128]
Integers = npt.NDArray[np.int64]
Layers = npt.NDArray[np.int8]
MOST_LAYERS = 127
"""In one slot: as many as a byte holds, so that the bricks of many games fit into the processor's cache."""


class Games(NamedTuple):
    """The state of G games of B balls, K rings and at most S slots a ring; the fields of `Ball` and `Ring`, as arrays.

    Attributes:
        positions: (G, B), world units.
        velocities: (G, B), world units per second.
        ball_radii: (G, B), world units.
        phases: (G, K), radians.
        spins: (G, K), rad/s.
        layers: (G, K, S); what is beyond a ring's count is 0 and never read.
        ring_radii: (K,), world units; this and the following are the same in all games.
        half_widths: (K,), world units.
        half_angles: (K,), radians.
        counts: (K,).
        frictions: (K,).
        steered: (K,), 0 where a ring was never given another spin in any game; 1 where it was, and the free flight allows for
            another at any time; -1 where it was, and the flights of other games do not allow for it yet.
        known: (G,), one of the values in `physics.batch.games`.
        free: (G,), ticks in which no ball touches anything; 0 where nothing is known.
        played: (G,), ticks of the present call that are done.
        dropped: (G,), balls that used up MAX_IMPACTS since this was set to 0.
        freed: (G,), balls moved out of material since this was set to 0.
    """

    positions: Complexes
    velocities: Complexes
    ball_radii: Floats
    phases: Floats
    spins: Floats
    layers: Layers
    ring_radii: Floats
    half_widths: Floats
    half_angles: Floats
    counts: Integers
    frictions: Floats
    steered: Integers
    known: Integers
    free: Integers
    played: Integers
    dropped: Integers
    freed: Integers


def arrays_of(arenas: Sequence[Arena]) -> Games:
    """The arrays of these arenas, which have one shape."""
    rings = arenas[0].rings
    shape, balls = (len(arenas), len(rings)), (len(arenas), len(arenas[0].balls))
    layers = np.zeros((*shape, max([ring.count for ring in rings], default=0)), np.int8)
    for g, arena in enumerate(arenas):
        for k, row in enumerate(arena.layers):
            layers[g, k, : len(row)] = row
    return Games(
        np.array([[ball.position for ball in arena.balls] for arena in arenas], np.complex128).reshape(balls),
        np.array([[ball.velocity for ball in arena.balls] for arena in arenas], np.complex128).reshape(balls),
        np.array([[ball.radius for ball in arena.balls] for arena in arenas], np.float64).reshape(balls),
        np.array([[ring.phase for ring in arena.rings] for arena in arenas], np.float64).reshape(shape),
        np.array([[ring.spin for ring in arena.rings] for arena in arenas], np.float64).reshape(shape),
        layers,
        np.array([ring.radius for ring in rings], np.float64),
        np.array([ring.half_width for ring in rings], np.float64),
        np.array([ring.half_angle for ring in rings], np.float64),
        np.array([ring.count for ring in rings], np.int64),
        np.array([ring.friction for ring in rings], np.float64),
        np.zeros(len(rings), np.int64),
        np.zeros(len(arenas), np.int64),
        np.zeros(len(arenas), np.int64),
        np.zeros(len(arenas), np.int64),
        np.zeros(len(arenas), np.int64),
        np.zeros(len(arenas), np.int64),
    )


def no_games() -> Games:
    """The arrays of no game at all: the types to compile for."""
    real, integer = np.empty((0, 0)), np.empty(0, np.int64)
    plane, row = np.empty((0, 0), np.complex128), np.empty(0)
    layers = np.empty((0, 0, 0), np.int8)
    return Games(plane, plane, real, real, real, layers, row, row, row, integer, row, *[integer] * 6)


def arena_of(games: Games, rings: Sequence[Ring], game: int) -> Arena:
    """One game as the arena that `physics.advance` takes. rings: of any game, for what is the same in all."""
    balls = tuple(
        [
            Ball(complex(p), complex(v), float(r))
            for p, v, r in zip(games.positions[game], games.velocities[game], games.ball_radii[game], strict=True)
        ]
    )
    turned = tuple(
        [
            ring._replace(phase=float(phase), spin=float(spin))
            for ring, phase, spin in zip(rings, games.phases[game], games.spins[game], strict=True)
        ]
    )
    layers = tuple([tuple(row[: ring.count].tolist()) for ring, row in zip(rings, games.layers[game], strict=True)])
    return Arena(balls, turned, layers)
