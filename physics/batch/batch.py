"""Many games of one shape, advanced together."""

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from physics.batch.arrays import MOST_LAYERS, Complexes, Floats, Integers, Layers, arena_of, arrays_of
from physics.batch.compilation import check_subnormals, compiled
from physics.batch.games import CLEAR, UNKNOWN
from physics.batch.hits import Rows, new_rows
from physics.shapes import PERMANENT, Arena, Ring
from physics.tolerances import LARGEST, MAX_IMPACTS, SMALLEST

_ROWS = 4096
"""Rows for hits that a step begins with, beside those that one tick may need; more are made as they are needed."""


class Steps(NamedTuple):
    """What the ticks of one call did.

    Attributes:
        hits: rows of `HIT`, in the order of game, tick, time, ball, ring, slot.
        lost: (games, balls), True where the whole ball is outside the ground after the last tick.
        dropped: (games,), how many balls used up MAX_IMPACTS in a tick and rested for what was left of it.
        freed: (games,), how many balls overlapped material and were put outside it.
    """

    hits: npt.NDArray[Any]
    lost: npt.NDArray[np.bool_]
    dropped: Integers
    freed: Integers


class Batch:
    """Independent games of one shape: the same rings but for their phases and spins, equally many balls, any layers.

    Every tick of every game has the bits of `physics.advance`. A ball that is lost flies on, until `put` brings it back.

    arenas: at least one. dt: seconds a tick, finite and > 0. speed: every ball's speed after a bounce, world units per second,
    > 0. ground_radius: world units, > 0.
    Raises ValueError, naming the argument; ImportError, naming the extra, without numba; RuntimeError where subnormal floats
    count as 0. The first batch of a machine takes the time to compile (`physics.batch.compilation`).
    """

    def __init__(self, arenas: Sequence[Arena], *, dt: float, speed: float, ground_radius: float = math.inf) -> None:
        self._dt = _positive("dt", dt)
        self._speed = _positive("speed", speed)
        if not ground_radius > 0.0:
            raise ValueError(f"ground_radius must be > 0, not {ground_radius}")
        self._ground_radius = float(ground_radius)
        if len(arenas) == 0:
            raise ValueError("arenas must be at least one, not none")
        for g, arena in enumerate(arenas):
            _check_shape(f"arenas[{g}]", arena, arenas[0])
        self._rings = arenas[0].rings
        check_subnormals()
        self._compiled = compiled()
        self._games = arrays_of(arenas)

    def __len__(self) -> int:
        """How many games there are."""
        return len(self._games.known)

    @property
    def positions(self) -> Complexes:
        """(games, balls), world units; read-only, and changed by every step."""
        return _seen(self._games.positions)

    @property
    def velocities(self) -> Complexes:
        """(games, balls), world units per second; read-only, and changed by every step."""
        return _seen(self._games.velocities)

    @property
    def phases(self) -> Floats:
        """(games, rings), radians; read-only, and changed by every step."""
        return _seen(self._games.phases)

    @property
    def spins(self) -> Floats:
        """(games, rings), rad/s; read-only, and changed by every step."""
        return _seen(self._games.spins)

    @property
    def layers(self) -> Layers:
        """(games, rings, slots of the fullest ring); 0 beyond a ring's count. Read-only, and changed by every step."""
        return _seen(self._games.layers)

    def step(self, spins: Floats | None = None, ticks: int = 1, threads: int = 1) -> Steps:
        """Advance every game by some ticks.

        spins: (games, rings), rad/s, float64, finite, for all of these ticks; None to leave them. ticks: at least 0.
        threads: at least 1; the result does not depend on it. Raises ValueError, naming the argument; then nothing is changed.
        """
        _whole("ticks", ticks, 0)
        _whole("threads", threads, 1)
        steered = None if spins is None else _checked_spins(spins, self._games.spins.shape)
        games, parts = self._games, min(threads, len(self))
        games.dropped[:] = 0
        games.freed[:] = 0
        if (games.steered < 0).any():
            games.steered[games.steered < 0] = 1
            games.free[:] = 0
            np.minimum(games.known, CLEAR, out=games.known)
        bounds = [len(self) * part // parts for part in range(parts + 1)]
        if parts == 1:
            hits = self._part(steered, 0, len(self), ticks)
        else:
            with ThreadPoolExecutor(parts) as pool:
                jobs = [pool.submit(self._part, steered, bounds[k], bounds[k + 1], ticks) for k in range(parts)]
                hits = np.concatenate([job.result() for job in jobs])
        distance = np.sqrt(games.positions.real**2 + games.positions.imag**2)
        lost = distance - games.ball_radii > self._ground_radius
        return Steps(hits, lost, games.dropped.copy(), games.freed.copy())

    def arena(self, game: int) -> Arena:
        """One game as the arena that `physics.advance` takes."""
        return arena_of(self._games, self._rings, game)

    def put(self, game: int, arena: Arena) -> None:
        """Replace one game: a lost ball comes back, bricks are laid anew. ValueError where the arena has another shape."""
        _check_shape("arena", arena, self.arena(game))
        mine, new = self._games, arrays_of([arena])
        mine.positions[game], mine.velocities[game], mine.ball_radii[game] = new.positions, new.velocities, new.ball_radii
        mine.phases[game], mine.spins[game], mine.layers[game] = new.phases, new.spins, new.layers
        mine.known[game], mine.free[game] = UNKNOWN, 0

    def _part(self, spins: Floats | None, first: int, last: int, ticks: int) -> npt.NDArray[Any]:
        """The hits of some of the games, these advanced."""
        check_subnormals()
        games = self._games
        if spins is not None:
            self._compiled.steer(games, spins, first, last)
        rows = new_rows(_ROWS + 2 * MAX_IMPACTS * games.positions.shape[1])
        game, tick = first, 0
        while True:
            game, tick = self._compiled.play(games, game, last, tick, ticks, self._dt, self._speed, rows)
            if game == last:
                return rows.hits[: rows.now[0]].copy()
            rows = Rows(np.concatenate([rows.hits, np.empty_like(rows.hits)]), rows.now)


def _seen(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """A view that cannot be written to."""
    view = array.view()
    view.flags.writeable = False
    return view


def _positive(name: str, value: float) -> float:
    """A finite number above 0."""
    if not 0.0 < value < math.inf:
        raise ValueError(f"{name} must be finite and > 0, not {value}")
    return float(value)


def _whole(name: str, value: int, least: int) -> None:
    """Refuse what is not a whole number from `least` up."""
    if not isinstance(value, int) or isinstance(value, bool) or value < least:
        raise ValueError(f"{name} must be a whole number from {least} up, not {value!r}")


def _checked_spins(spins: Floats, shape: tuple[int, ...]) -> Floats:
    """Spins as they are stored: those below SMALLEST are 0."""
    if not isinstance(spins, np.ndarray) or spins.dtype != np.float64 or spins.shape != shape:
        said = f"{spins.dtype} of shape {spins.shape}" if isinstance(spins, np.ndarray) else type(spins).__name__
        raise ValueError(f"spins must be a float64 array of shape {shape}, not {said}")
    if not (np.abs(spins) <= LARGEST).all():
        game, ring = np.argwhere(~(np.abs(spins) <= LARGEST))[0]
        raise ValueError(f"spins must be finite and at most {LARGEST:g}, not {spins[game, ring]} at game {game}, ring {ring}")
    return np.ascontiguousarray(np.where(np.abs(spins) >= SMALLEST, spins, 0.0))


def _check_shape(name: str, arena: Arena, model: Arena) -> None:
    """Refuse an arena with other rings than the model's, other numbers of balls or layers."""
    if len(arena.balls) != len(model.balls):
        raise ValueError(f"{name} must have {len(model.balls)} balls, as the first, not {len(arena.balls)}")
    if len(arena.rings) != len(model.rings) or len(arena.layers) != len(model.rings):
        raise ValueError(f"{name} must have {len(model.rings)} rings and their layers, as the first")
    for k, (ring, same, layers) in enumerate(zip(arena.rings, model.rings, arena.layers, strict=True)):
        if _fixed(ring) != _fixed(same):
            raise ValueError(f"{name}.rings[{k}] must be the first arena's but for phase and spin, not {ring}")
        if arena is not model and layers is model.layers[k]:
            continue
        if len(layers) != ring.count:
            raise ValueError(f"{name}.layers[{k}] must have {ring.count} entries, not {len(layers)}")
        for left in layers:
            if not (isinstance(left, int) and PERMANENT <= left <= MOST_LAYERS):
                raise ValueError(f"{name}.layers[{k}] must be whole numbers from {PERMANENT} to {MOST_LAYERS}, not {left}")


def _fixed(ring: Ring) -> tuple[float, ...]:
    """What is the same in all games."""
    return ring.radius, ring.half_width, ring.half_angle, ring.count, ring.friction
