"""Many environments that are played together, by Gymnasium's `VectorEnv`."""

from collections.abc import Sequence
from numbers import Integral
from pathlib import Path
from typing import Any, SupportsInt, TypeGuard

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from game.rules import Game
from tools.environments.many import Actions, EnvironmentOptions, ManyEnvironments, Observation, State, base_seed
from tools.environments.spaces import action_space, frame, observation_space

Array = npt.NDArray[Any]


class PolarBreakoutVectorEnv(gymnasium.vector.VectorEnv[Array, Array, Array]):
    """Games on one level, each as a `PolarBreakoutEnv` plays it.

    autoreset_mode: NEXT_STEP, SAME_STEP (then `final_obs` and `final_info` are in the info), or DISABLED (then `reset` takes
    `options={"reset_mask": mask}`). recorded: the environments whose games `record` can write. copy: whether every step returns
    a new array of observations of the kind "state"; if not, the next step overwrites what has changed in it, so callers must
    not write to it. The other arguments are those of `tools.environments.many.EnvironmentOptions`.
    """

    def __init__(
        self,
        num_envs: int = 1,
        level: str = "1",
        observation: Observation = "state",
        actions: Actions = "discrete",
        frame_skip: int = 4,
        repeat_action_probability: float = 0.0,
        max_ticks: int = 72_000,
        render_mode: str | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        recorded: Sequence[int] = (),
        *,
        copy: bool = True,
    ) -> None:
        self._mode = AutoresetMode(autoreset_mode)
        options = EnvironmentOptions(level, observation, actions, frame_skip, repeat_action_probability, max_ticks)
        self._environments = ManyEnvironments(num_envs, options, recorded, resets=self._mode is AutoresetMode.NEXT_STEP)
        self.num_envs = num_envs
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": 60, "autoreset_mode": self._mode}
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise ValueError(f"render_mode must be one of {self.metadata['render_modes']} or None, not {render_mode!r}")
        self.render_mode = render_mode
        self._copy = copy
        self.single_action_space = action_space(self._environments)
        self.single_observation_space = observation_space(self._environments)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._all = np.ones(num_envs, np.bool_)
        everywhere = np.ones(num_envs, np.bool_)
        everywhere.flags.writeable = False
        self._everywhere = {f"_{name}": everywhere for name in _INFO}

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """Begin the next episode in every environment, or in those of `options["reset_mask"]`.

        seed: environment i gets the seed that follows from it and i; or one for every environment, which then plays as a
        `PolarBreakoutEnv` with that seed, None to go on with the one before. Raises ValueError, naming the argument.
        """
        mask = self._mask(options)
        if _is_seed(seed):
            super().reset(seed=int(seed))
            self._environments.seed([base_seed(int(seed), index) for index in range(self.num_envs)], mask)
        elif seed is not None:
            seeds: Any = seed.tolist() if isinstance(seed, np.ndarray) else seed
            if not isinstance(seeds, Sequence) or len(seeds) != self.num_envs:
                raise ValueError(f"seed must be one whole number, or {self.num_envs} of them, not {seed!r}")
            wrong = [one for one in seeds if one is not None and not _is_seed(one)]
            if wrong:
                raise ValueError(f"seed must be whole numbers from 0 up, or None, not {wrong[0]!r}")
            given = np.array([one is not None for one in seeds])
            self._environments.seed([0 if one is None else base_seed(int(one), 0) for one in seeds], mask & given)
        elif not self._environments.begun:
            self._environments.seed([base_seed(self.np_random_seed or 0, index) for index in range(self.num_envs)], mask)
        self._environments.begin(mask)
        return self._observations(), self._info(mask)

    def step(self, actions: Array) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Take an action in every environment. Raises ValueError for wrong actions; then nothing is changed."""
        environments = self._environments
        if not environments.begun or (self._mode is AutoresetMode.DISABLED and environments.episodes["ended"].any()):
            raise ResetNeeded("an episode is over, or none has begun: call reset")
        rewards, over, cut_off, *counts = environments.step(actions)
        info: dict[str, Any] = {}
        if self._mode is AutoresetMode.SAME_STEP:
            ended = over | cut_off
            if ended.any():
                info = self._final(ended)
                environments.begin(ended)
                counts = [environments.episodes[name].copy() for name in ("score", "lives", "tick")]
        info |= zip(_INFO, counts, strict=True)
        info |= self._everywhere
        return self._observations(), rewards, over, cut_off, info

    def render(self) -> tuple[npt.NDArray[np.uint8], ...] | None:
        """A picture for each environment, where `render_mode` is "rgb_array"."""
        return None if self.render_mode is None else tuple([frame(self._environments, i) for i in range(self.num_envs)])

    def get_state(self) -> State:
        """Everything that decides how the games go on, as a copy."""
        return self._environments.state()

    def set_state(self, state: State) -> Array:
        """Go on from a state that `get_state` returned: its observations."""
        self._environments.set_state(state)
        return self._observations()

    def game(self, index: int) -> Game:
        """The game of one environment as `game.rules.tick` takes it."""
        return self._environments.game(index)

    def record(self, index: int, path: str | Path) -> None:
        """Write the game of one of the `recorded` environments as a replay: as `PolarBreakoutEnv.record` does."""
        self._environments.record(index, Path(path))

    def _observations(self) -> Array:
        """What the agents see."""
        return self._environments.observations(copy=self._copy)

    def _info(self, mask: npt.NDArray[np.bool_]) -> dict[str, Any]:
        """Score, lives and ticks of the episodes in the environments of a mask."""
        episodes = self._environments.episodes
        info: dict[str, Any] = {}
        for name, field in _INFO.items():
            info[name] = episodes[field].copy() if mask is self._all else np.where(mask, episodes[field], 0)
            info[f"_{name}"] = mask.copy()
        return info

    def _final(self, ended: npt.NDArray[np.bool_]) -> dict[str, Any]:
        """The last observations and infos of the episodes that have ended."""
        last = np.full(self.num_envs, None, dtype=object)
        which = np.flatnonzero(ended)
        for index, observation in zip(which, self._environments.observations(which), strict=True):
            last[index] = observation
        return {"final_obs": last, "_final_obs": ended, "final_info": self._info(ended), "_final_info": ended.copy()}

    def _mask(self, options: dict[str, Any] | None) -> npt.NDArray[np.bool_]:
        """The environments to reset; ValueError for what is no mask."""
        mask = None if options is None else options.get("reset_mask")
        if mask is None:
            return self._all
        if not isinstance(mask, np.ndarray) or mask.dtype != np.bool_ or mask.shape != (self.num_envs,) or not mask.any():
            said = f"{mask.dtype} of shape {mask.shape}" if isinstance(mask, np.ndarray) else type(mask).__name__
            raise ValueError(f"options['reset_mask'] must be bools of shape {(self.num_envs,)}, one of them True, not {said}")
        return mask


def _is_seed(value: Any) -> TypeGuard[SupportsInt]:
    """Whether a value is a whole number from 0 up, of Python or numpy."""
    return isinstance(value, Integral) and not isinstance(value, bool) and int(value) >= 0


_INFO = {"score": "score", "lives": "lives", "ticks": "tick"}
"""The infos, and where they are in an episode."""
