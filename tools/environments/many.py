"""Many environments as arrays: what a step, a reset and a picture are, before Gymnasium's words for them."""

import hashlib
import math
from collections.abc import Sequence
from numbers import Integral
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt

from game.levels import Level, chosen
from game.rules import PADDLES, POINTER_STEPS, SOURCE_RULES, TICK, Game, Phase
from game.rules.chance import chance_number
from game.system.errors import BadInputError
from physics.batch.arrays import Games, arena_of, arrays_of
from physics.batch.compilation import check_subnormals
from physics.batch.hits import new_rows
from physics.shapes import Ball
from physics.tolerances import MAX_IMPACTS
from tools.autopilot.plans import PLAN
from tools.environments.compilation import compiled_loops
from tools.environments.history import History
from tools.environments.numbers import BRICKS, EPISODE, LevelConstants, StepResults, new_results
from tools.environments.observation import Cells, numbers_of_state, square_cells, unrolled_cells

Observation = Literal["state", "rings", "pixels"]
Actions = Literal["discrete", "continuous", "autopilot"]

_LARGEST_NUMBER = 2**31 - 1
"""Of environments and ticks: the compiled loops add such numbers in 64 bits."""
_PIXELS = 84
_RING_ROWS, _RING_COLUMNS = 48, 96
PICTURE_SHAPES = {"rings": (_RING_ROWS, _RING_COLUMNS), "pixels": (_PIXELS, _PIXELS)}
"""Rows and columns of the observations that are pictures: distance from the centre and angle, or the ground from above."""
DISCRETE_ACTIONS = 3
"""To rest, to turn counter-clockwise, clockwise."""


class EnvironmentOptions(NamedTuple):
    """How environments are played.

    Attributes:
        level: number, name or TOML file, as the command line takes it.
        observation: "state", "rings" or "pixels".
        actions: "discrete"; "continuous"; "autopilot": the game's own autopilot plays, and serves, whatever the actions.
        frame_skip: ticks of 1/240 s that an action is held, from 1 up.
        repeat_action_probability: that an action is not taken and the one before it held, in [0, 1].
        max_ticks: after which an episode is cut off, from 1 up.
    """

    level: str = "1"
    observation: Observation = "state"
    actions: Actions = "discrete"
    frame_skip: int = 4
    repeat_action_probability: float = 0.0
    max_ticks: int = 72_000


class State(NamedTuple):
    """Everything that decides how environments go on, opaque; `ManyEnvironments.set_state` takes it back."""

    level: str
    games: Games
    episodes: npt.NDArray[Any]
    plans: npt.NDArray[Any]
    histories: dict[int, History]


class ManyEnvironments:
    """Environments of one level, each with a game of its own under the source's rules.

    count: from 1 up. recorded: the environments whose games can be written as replays. resets: whether the step after an
    episode's end begins the next. Raises ValueError, naming the argument; ImportError, naming the extra, without numba.
    """

    def __init__(self, count: int, options: EnvironmentOptions, recorded: Sequence[int] = (), *, resets: bool = False) -> None:
        _check(count, options, recorded)
        self.options, self.level = options, _level(options.level)
        check_subnormals()
        self._loops = compiled_loops()
        arena = self.level.arena()
        resting = Ball(0j, complex(self.level.ball.speed, 0.0), self.level.ball.radius)
        arena = arena._replace(balls=(resting,))
        self._rings, self._start = arena.rings, arrays_of([arena])
        self._games = arrays_of([arena] * (count + 1))  # the last is as every episode begins
        self._games.steered[PADDLES] = 1
        self._episodes: npt.NDArray[Any] = np.zeros(count, EPISODE)
        self._plans: npt.NDArray[Any] = np.zeros(count, PLAN)
        self._numbers = _numbers(self.level, options, resets=resets)
        columns = numbers_of_state(self._start) if options.observation == "state" else 0
        self._states = np.zeros((count, columns), np.float32)
        self._rows = new_rows(2 * MAX_IMPACTS)
        self._busy = np.zeros(count + 1, np.int64)
        self._cells = _cells(self._start, self.level.ground_radius, options.observation)
        self._histories = {index: History(autopilot=options.actions == "autopilot") for index in recorded}
        self._begun = False
        self._no_pointers, self._no_turns = np.full(count, -1, np.int64), np.zeros(count, np.int64)

    @property
    def begun(self) -> bool:
        """Whether every environment has had its first episode."""
        self._begun = self._begun or bool(self._episodes["number"].all())
        return self._begun

    @property
    def state_size(self) -> int:
        """How many numbers the observation `state` has."""
        return numbers_of_state(self._start)

    def __len__(self) -> int:
        """How many environments there are."""
        return len(self._episodes)

    @property
    def episodes(self) -> npt.NDArray[Any]:
        """Rows of `EPISODE`, read-only."""
        view = self._episodes.view()
        view.flags.writeable = False
        return view

    def seed(self, bases: Sequence[int], mask: npt.NDArray[np.bool_]) -> None:
        """Set what the seeds of the next games are made of, in the environments of a mask. bases: from `base_seed`."""
        self._episodes["base"][mask] = np.array(bases, np.uint64)[mask]
        self._episodes["number"][mask] = 0
        self._episodes["actions"][mask] = 0
        self._begun = False

    def begin(self, mask: npt.NDArray[np.bool_]) -> None:
        """Begin the next episode in the environments of a mask."""
        self._loops.begin(self._numbers, self._games, self._episodes, self._states, mask)
        for index, history in self._histories.items():
            if mask[index]:
                history.begin()

    def step(self, actions: npt.NDArray[Any]) -> StepResults:
        """Take one action in every environment."""
        discrete, pointers = self._controls(actions)
        results = new_results(len(self))
        fresh = [index for index in self._histories if self._episodes["ended"][index]]
        number = -1
        while True:
            number = self._loops.step(
                self._numbers,
                self._games,
                self._episodes,
                self._plans,
                discrete,
                pointers,
                results,
                self._states,
                self._rows,
                self._busy,
                number,
            )
            if number == -1:
                break
            if number < 0:
                raise ValueError(f"actions must be from 0 to {DISCRETE_ACTIONS - 1}, not {actions.min()} to {actions.max()}")
            e = self._episodes[self._busy[number]]
            e["chance"] = chance_number(int(e["seed"]), int(e["draws"]))
        for index, history in self._histories.items():
            if index in fresh:
                if self._numbers.resets:
                    history.begin()
            else:
                history.add(self._episodes[index])
        return results

    def observations(self, only: npt.NDArray[np.int64] | None = None, *, copy: bool = True) -> npt.NDArray[Any]:
        """What the agents see: one row or picture for each environment, or for those of `only`.

        copy: whether the rows are a new array; else the next step writes over them. Pictures are always new.
        """
        if self._cells is None:
            return self._states[only] if only is not None else self._states.copy() if copy else self._states
        only = np.arange(len(self)) if only is None else only
        return self._pictures(self._cells, only).reshape(len(only), *PICTURE_SHAPES[self.options.observation], 1)

    def picture(self, index: int, size: int) -> npt.NDArray[np.uint8]:
        """(size, size) grey values: one environment, seen from above."""
        cells = square_cells(self._start, self.level.ground_radius, size)
        return self._pictures(cells, np.array([index])).reshape(size, size)

    def game(self, index: int) -> Game:
        """The game of one environment, as `game.rules.tick` takes it, but for what it counts (`statistics`, `results`)."""
        e = self._episodes[index]
        arena = arena_of(self._games, self._rings, index)
        phase = Phase(int(e["phase"]))
        names = ("draws", "tick", "phase_start", "score", "lives", "combo", "idle")
        draws, tick, phase_start, score, lives, combo, idle = (int(e[name]) for name in names)
        arena = arena._replace(balls=()) if phase == Phase.OVER else arena
        game = Game((self.level,), 0, int(e["seed"]), draws, tick, phase, tick - phase_start, arena, score, lives, combo, idle)
        return game._replace(ruleset=SOURCE_RULES, speed=self.level.ball.speed)

    def state(self) -> State:
        """A copy of everything that decides how the environments go on."""
        histories = {index: history.copy() for index, history in self._histories.items()}
        games = _copied(self._games)
        return State(self.level.content_hash(), games, self._episodes.copy(), self._plans.copy(), histories)

    def set_state(self, state: State) -> None:
        """Go on from a state. ValueError where it is of another level or another number of environments."""
        if not isinstance(state, State):
            raise ValueError(f"state must be one that get_state returned, not {type(state).__name__}")  # noqa: TRY004
        if state.level != self.level.content_hash():
            raise ValueError(f"state must be of the level {self.level.name!r}, not of another")
        if len(state.episodes) != len(self) or state.histories.keys() != self._histories.keys():
            raise ValueError(f"state must be of {len(self)} environments, {sorted(self._histories)} of them recorded")
        self._games = _copied(state.games)
        self._episodes[:], self._plans[:] = state.episodes, state.plans
        self._begun = False
        self._episodes["changed"] = BRICKS
        self._loops.write_states(self._numbers, self._games, self._episodes, self._states)
        self._histories = {index: history.copy() for index, history in state.histories.items()}

    def record(self, index: int, path: Path) -> None:
        """Write the game of one environment as a replay: the one that is played, or, where it has just begun, the one before.

        ValueError for an environment that is not recorded, or that has played nothing; BadInputError where the file cannot be
        written. The replay is made by playing the controls again by `game.rules`; AssertionError should that give another game.
        """
        if index not in self._histories:
            raise ValueError(f"index must be one of the recorded environments {sorted(self._histories)}, not {index}")
        self._histories[index].save(path, self.level, self.game(index))

    def _controls(self, actions: npt.NDArray[Any]) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """The discrete actions and the pointers of actions; ValueError for what is none."""
        if self.options.actions != "continuous":
            if not isinstance(actions, np.ndarray) or actions.dtype.kind not in "iu" or actions.shape != (len(self),):
                raise ValueError(f"actions must be whole numbers of shape {(len(self),)}, not {_said(actions)}")
            if self.options.actions == "autopilot" and actions.any():
                raise ValueError(f"actions must be 0 where the autopilot plays, not {actions.min()} to {actions.max()}")
            return np.ascontiguousarray(actions, np.int64), self._no_pointers
        if not isinstance(actions, np.ndarray) or actions.dtype.kind != "f" or actions.shape != (len(self), 2):
            raise ValueError(f"actions must be floats of shape {(len(self), 2)}, not {_said(actions)}")
        if not np.isfinite(actions).all():
            raise ValueError("actions must be finite")
        angles = np.arctan2(actions[:, 1], actions[:, 0]).astype(np.float64) / math.tau
        pointers = np.floor(angles * POINTER_STEPS).astype(np.int64) % POINTER_STEPS
        return self._no_turns, np.where((actions == 0.0).all(axis=1), -1, pointers)

    def _pictures(self, cells: Cells, only: npt.NDArray[np.int64]) -> npt.NDArray[np.uint8]:
        """Pictures of some games."""
        pictures = np.empty((len(only), len(cells.angles)), np.uint8)
        self._loops.paint(self._games, cells, only, pictures)
        return pictures


def base_seed(seed: int, index: int) -> int:
    """What the seeds of an environment's games are made of: 64 bits of SHA-256 over the seed and the environment's number."""
    return int.from_bytes(hashlib.sha256(f"{seed} {index}".encode()).digest()[:8], "little")


def _copied(games: Games) -> Games:
    """The same state in arrays of its own."""
    return Games._make([array.copy() for array in games])


def _cells(start: Games, ground_radius: float, observation: Observation) -> Cells | None:
    """The cells of an observation that is a picture."""
    if observation == "state":
        return None
    if observation == "pixels":
        return square_cells(start, ground_radius, _PIXELS)
    return unrolled_cells(start, ground_radius, _RING_ROWS, _RING_COLUMNS)


def _level(wanted: str) -> Level:
    """The level of an option; ValueError where there is none."""
    try:
        return chosen(str(wanted))[0]
    except BadInputError as error:
        raise ValueError(f"level: {error}") from None


def _numbers(level: Level, options: EnvironmentOptions, *, resets: bool) -> LevelConstants:
    """What the compiled loops are given."""
    bricks = sum([layers > 0 for ring in level.rings for layers in ring.slots()])
    top, change = math.radians(level.paddles.top_speed), math.radians(level.paddles.acceleration) * TICK
    return LevelConstants(
        top,
        change,
        level.ball.radius,
        level.ball.speed,
        level.ground_radius,
        bricks,
        options.frame_skip,
        options.max_ticks,
        float(options.repeat_action_probability),
        int(options.actions == "autopilot"),
        int(resets),
        1.0 / (level.ground_radius + level.ball.radius),
        1.0 / level.ball.speed,
        1.0 / top,
    )


def _check(count: int, options: EnvironmentOptions, recorded: Sequence[int]) -> None:
    """ValueError, naming the argument, for what makes no environments."""
    for name, value in (("num_envs", count), ("frame_skip", options.frame_skip), ("max_ticks", options.max_ticks)):
        if not isinstance(value, int) or isinstance(value, bool) or value < 1:
            raise ValueError(f"{name} must be a whole number from 1 up, not {value!r}")
        if value > _LARGEST_NUMBER:
            raise ValueError(f"{name} must be at most {_LARGEST_NUMBER}, not {value}")
    if options.observation not in {"state", *PICTURE_SHAPES}:
        raise ValueError(f"observation must be 'state', 'rings' or 'pixels', not {options.observation!r}")
    if options.actions not in {"discrete", "continuous", "autopilot"}:
        raise ValueError(f"actions must be 'discrete', 'continuous' or 'autopilot', not {options.actions!r}")
    if not 0.0 <= options.repeat_action_probability <= 1.0:
        raise ValueError(f"repeat_action_probability must lie in [0, 1], not be {options.repeat_action_probability}")
    if options.actions == "autopilot" and options.repeat_action_probability:
        raise ValueError("repeat_action_probability must be 0 where the autopilot plays: it takes no actions")
    for index in recorded:
        if not isinstance(index, Integral) or not 0 <= index < count:
            raise ValueError(f"recorded must be numbers of environments, from 0 to {count - 1}, not {index}")


def _said(value: Any) -> str:
    """What an argument is, for the message that refuses it."""
    return f"{value.dtype} of shape {value.shape}" if isinstance(value, np.ndarray) else type(value).__name__
