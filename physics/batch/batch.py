"""Many games of one shape, advanced together."""

import math
import sys
import threading
from collections.abc import Sequence
from numbers import Integral, Real
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt

from physics.batch.arrays import MOST_LAYERS, Complexes, Floats, Games, Integers, Layers, arena_of, arrays_of
from physics.batch.compilation import check_subnormals, compiled
from physics.batch.games import CLEAR, UNKNOWN
from physics.batch.hits import Rows, joined, new_rows
from physics.batch.threads import shared
from physics.shapes import PERMANENT, Arena, Ring
from physics.tolerances import LARGEST, MAX_IMPACTS, SMALLEST

_ROWS = 4096
"""Rows for hits that a step begins with, beside those that one tick may need; more are made as they are needed."""
_LARGEST_WHOLE = 2**63 - 1
"""That compiled code takes."""
_PIECES, _LEAST = 4, 1024
"""Pieces for each thread, so that others can help a slow one; and least games in a piece, since each piece has a fixed cost."""


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


@runtime_checkable
class BatchSteering(Protocol):
    """What gives a ring its spin before every tick: `tools.autopilot.BatchAutopilot`, or another compiled loop."""

    @property
    def ring(self) -> int:
        """Index of the ring that is steered."""

    def check(self, games: int, rings: int, dt: float) -> None:
        """Raise ValueError unless it can steer a batch of so many games and rings in ticks of `dt` seconds."""

    def step(
        self,
        games: Games,
        first: int,
        last: int,
        begun: int,
        ticks: int,
        dt: float,
        speed: float,
        ground_radius: float,
        rows: Rows,
        lost: npt.NDArray[np.bool_],
    ) -> int:
        """Do what `physics.batch.games.step` does, and steer. Called by several threads, each for other games."""


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
        self._ground_radius = _positive("ground_radius", ground_radius, math.inf)
        _check_list("arenas", arenas)
        for g, arena in enumerate(arenas):
            _check_shape(f"arenas[{g}]", arena, arenas[0])
        self._model = arenas[0]
        check_subnormals()
        self._compiled = compiled()
        self._games = arrays_of(arenas)
        self._rows: list[Rows] = []  # one for each piece of a step

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

    def step(
        self, spins: Floats | None = None, ticks: int = 1, threads: int = 1, autopilot: BatchSteering | None = None
    ) -> Steps:
        """Advance every game by some ticks.

        spins: (games, rings), rad/s, float64, finite, for all of these ticks; None to leave them. ticks: from 0 to 2**63 - 1.
        threads: at least 1; the result does not depend on it. autopilot: steers one of the rings before every tick, whatever
        `spins` says of it; None for nothing. Raises ValueError, naming the argument; then nothing is changed.
        """
        ticks, threads = _whole("ticks", ticks, 0), _whole("threads", threads, 1)
        if autopilot is not None:
            _check_steering("autopilot", autopilot)
            autopilot.check(len(self), len(self._model.rings), self._dt)
        steered = None if spins is None else _checked_spins(spins, self._games.spins.shape)
        parts = min(threads, len(self))
        games = self._games = self._games._replace(dropped=np.zeros(len(self), np.int64), freed=np.zeros(len(self), np.int64))
        if autopilot is not None:
            games.steered[autopilot.ring] = games.steered[autopilot.ring] or -1
            if steered is not None:
                steered = steered.copy()
                steered[:, autopilot.ring] = games.spins[:, autopilot.ring]
        if (games.steered < 0).any():
            games.steered[games.steered < 0] = 1
            games.free[:] = 0
            np.minimum(games.known, CLEAR, out=games.known)
        pieces = 1 if parts == 1 else max(parts, min(parts * _PIECES, len(self) // _LEAST))
        while len(self._rows) < pieces:
            self._rows.append(new_rows(_ROWS + 2 * MAX_IMPACTS * games.positions.shape[1]))
        bounds = [len(self) * piece // pieces for piece in range(pieces + 1)]
        lost = np.empty(games.positions.shape, np.bool_)
        interrupted = threading.Event()

        def advance(n: int) -> npt.NDArray[Any]:
            return self._piece(n, steered, bounds[n], bounds[n + 1], ticks, lost, autopilot, interrupted)

        hits = shared(advance, pieces, parts, interrupted)
        return Steps(joined(hits), lost, games.dropped, games.freed)

    def arena(self, game: int) -> Arena:
        """One game as the arena that `physics.advance` takes. ValueError where there is no game of this number."""
        self._check_game(game)
        return arena_of(self._games, self._model.rings, game)

    def put(self, game: int, arena: Arena) -> None:
        """Replace one game: a lost ball comes back, bricks are laid anew. Raises ValueError, naming the argument."""
        self._check_game(game)
        _check_shape("arena", arena, self._model)
        mine, new = self._games, arrays_of([arena])
        mine.positions[game], mine.velocities[game], mine.ball_radii[game] = new.positions, new.velocities, new.ball_radii
        mine.phases[game], mine.spins[game], mine.layers[game] = new.phases, new.spins, new.layers
        mine.known[game], mine.free[game] = UNKNOWN, 0

    def serve(
        self,
        games: Integers,
        positions: Complexes,
        velocities: Complexes,
        layers: Layers | None = None,
    ) -> None:
        """Put the balls of some games elsewhere, at once: `put` for many, where rings and spins are left as they are.

        games: (n,), their numbers, int64. positions, velocities: (n, balls), world units (per second), complex128, as `Ball`
        takes them. layers: (rings, slots of the fullest ring), int8, what is laid in each of these games, as one of those in
        `layers`; None to leave their bricks. Raises ValueError, naming the argument; then nothing is changed.
        """
        mine = self._games
        shape = (np.size(games), mine.positions.shape[1])
        _check_array("games", games, np.dtype(np.int64), shape[:1])
        if not ((games >= 0) & (games < len(self))).all():
            raise ValueError(f"games must be from 0 to {len(self) - 1}, not {games.min()} to {games.max()}")
        for name, array in (("positions", positions), ("velocities", velocities)):
            _check_array(name, array, np.dtype(np.complex128), shape)
        if not (np.abs(positions) <= LARGEST).all():
            raise ValueError(f"positions must be finite and at most {LARGEST:g} from the origin")
        size = np.abs(velocities)
        if not ((size == 0.0) | ((size >= SMALLEST) & (size <= LARGEST))).all():
            raise ValueError(f"velocities must be 0 or from {SMALLEST:g} to {LARGEST:g} long")
        if layers is not None:
            _check_array("layers", layers, np.dtype(np.int8), mine.layers.shape[1:])
            if (layers < PERMANENT).any():
                raise ValueError(f"layers must be from {PERMANENT} up, not {layers.min()}")
            mine.layers[games] = layers
        mine.positions[games], mine.velocities[games] = positions, velocities
        mine.known[games], mine.free[games] = UNKNOWN, 0

    def _check_game(self, game: Any) -> None:
        """Refuse what is no game's number."""
        if not isinstance(game, Integral) or isinstance(game, bool) or not 0 <= int(game) < len(self):
            raise ValueError(f"game must be a whole number from 0 to {len(self) - 1}, not {game!r}")

    def _piece(
        self,
        number: int,
        spins: Floats | None,
        first: int,
        last: int,
        ticks: int,
        lost: npt.NDArray[np.bool_],
        autopilot: BatchSteering | None,
        interrupted: threading.Event,
    ) -> npt.NDArray[Any]:
        """Advance some of the games. Returns their hits, valid until the next step.

        number: of the piece. lost: written. interrupted: set where nobody wants the rest any more.
        """
        check_subnormals()
        games, rows = self._games, self._rows[number]
        if spins is not None:
            self._compiled.steer(games, spins, first, last)
        rows.now[0] = 0
        step = self._compiled.step if autopilot is None else autopilot.step
        game = -1
        while True:
            game = step(games, first, last, game, ticks, self._dt, self._speed, self._ground_radius, rows, lost)
            if game == last or interrupted.is_set():
                return rows.hits[: rows.now[0]]
            rows = self._rows[number] = Rows(joined([rows.hits, np.empty_like(rows.hits)]), rows.now)


def _seen(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """A view that cannot be written to."""
    view = array.view()
    view.flags.writeable = False
    return view


def _positive(name: str, value: Any, most: float = sys.float_info.max) -> float:
    """A number above 0, and finite unless `most` is not; ValueError for anything else."""
    if not (isinstance(value, Real) and 0.0 < float(value) <= most):
        raise ValueError(f"{name} must be {'' if most == math.inf else 'finite and '}> 0, not {value!r}")
    return float(value)


def _check_list(name: str, arenas: Any) -> None:
    """Refuse what is no sequence with something in it. One arena is a tuple, too, but no list of arenas."""
    if isinstance(arenas, Arena) or not isinstance(arenas, Sequence):
        raise ValueError(f"{name} must be a list of arenas, not {_type_name(arenas)}")  # noqa: TRY004  # as every wrong argument
    if len(arenas) == 0:
        raise ValueError(f"{name} must be at least one, not none")


def _whole(name: str, value: Any, least: int) -> int:
    """A whole number of Python or numpy from `least` up; ValueError for anything else, or what does not fit into 64 bits."""
    if not isinstance(value, Integral) or isinstance(value, bool) or int(value) < least:
        raise ValueError(f"{name} must be a whole number from {least} up, not {value!r}")
    if int(value) > _LARGEST_WHOLE:
        raise ValueError(f"{name} must be at most {_LARGEST_WHOLE}, not {value}")
    return int(value)


def _check_steering(name: str, value: Any) -> None:
    """Refuse what cannot steer."""
    if isinstance(value, type) or not isinstance(value, BatchSteering):
        raise ValueError(f"{name} must be as BatchAutopilot(level, games) makes it, not {_type_name(value)}")  # noqa: TRY004


def _type_name(value: object) -> str:
    """What a value is, in a message."""
    return f"the class {value.__name__}" if isinstance(value, type) else type(value).__name__


def _checked_spins(spins: Floats, shape: tuple[int, ...]) -> Floats:
    """The spins as a contiguous array; ValueError unless they have the shape and can be stored."""
    _check_array("spins", spins, np.dtype(np.float64), shape)
    size = np.abs(spins)
    if spins.size > 0 and not size.max() <= LARGEST:
        game, ring = np.argwhere(~(size <= LARGEST))[0]
        raise ValueError(f"spins must be finite and at most {LARGEST:g}, not {spins[game, ring]} at game {game}, ring {ring}")
    return np.ascontiguousarray(spins)


def _check_array(name: str, array: npt.NDArray[Any], dtype: np.dtype[Any], shape: tuple[int, ...]) -> None:
    """Refuse what is no array of this type and shape."""
    if not isinstance(array, np.ndarray) or array.dtype != dtype or array.shape != shape:
        said = f"{array.dtype} of shape {array.shape}" if isinstance(array, np.ndarray) else type(array).__name__
        raise ValueError(f"{name} must be a {dtype} array of shape {shape}, not {said}")


def _check_shape(name: str, arena: Any, model: Arena) -> None:
    """Refuse what is no arena, or one with other rings than the model's, other numbers of balls or layers."""
    if not isinstance(arena, Arena):
        raise ValueError(f"{name} must be an arena, not {_type_name(arena)}")  # noqa: TRY004  # as for every wrong argument
    if len(arena.balls) != len(model.balls):
        raise ValueError(f"{name} must have {len(model.balls)} balls, as the first, not {len(arena.balls)}")
    if len(arena.rings) != len(model.rings) or len(arena.layers) != len(model.rings):
        raise ValueError(f"{name} must have {len(model.rings)} rings and their layers, as the first")
    for k, (ring, same, layers) in enumerate(zip(arena.rings, model.rings, arena.layers, strict=True)):
        if _fixed(ring) != _fixed(same):
            raise ValueError(f"{name}.rings[{k}] must be the first arena's but for phase and spin, not {ring}")
        if arena is not model and layers is model.layers[k]:
            continue
        _check_row(f"{name}.layers[{k}]", layers, ring)


def _check_row(name: str, row: Sequence[int], ring: Ring) -> None:
    """Refuse what are no layers of a ring."""
    if len(row) != ring.count:
        raise ValueError(f"{name} must have {ring.count} entries, not {len(row)}")
    for left in row:
        if not (isinstance(left, int) and PERMANENT <= left <= MOST_LAYERS):
            raise ValueError(f"{name} must be whole numbers from {PERMANENT} to {MOST_LAYERS}, not {left}")


def _fixed(ring: Ring) -> tuple[float, ...]:
    """What is the same in all games."""
    return ring.radius, ring.half_width, ring.half_angle, ring.count, ring.friction
