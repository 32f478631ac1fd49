"""One environment, by Gymnasium's `Env`."""

from pathlib import Path
from typing import Any, ClassVar

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.error import ResetNeeded

from game.rules import Game
from tools.environments.many import Actions, EnvironmentOptions, ManyEnvironments, Observation, State, base_seed
from tools.environments.spaces import action_space, frame, observation_space

_ONE = np.ones(1, np.bool_)


class PolarBreakoutEnv(gymnasium.Env[npt.NDArray[Any], Any]):
    """A game on one level, under the source's rules, with three lives. A step's reward is the points that it scored.

    The arguments are those of `tools.environments.many.EnvironmentOptions`. An episode ends with the last brick or the last
    life. The ball is served by itself, a second after a life began at the latest. The same seed gives the same game; without
    one, a game follows from the seed and the number of the episode.
    """

    metadata: ClassVar[dict[str, Any]] = {"render_modes": ["rgb_array"], "render_fps": 60}  # type: ignore[misc]

    def __init__(
        self,
        level: str = "1",
        observation: Observation = "state",
        actions: Actions = "discrete",
        frame_skip: int = 4,
        repeat_action_probability: float = 0.0,
        max_ticks: int = 72_000,
        render_mode: str | None = None,
    ) -> None:
        options = EnvironmentOptions(level, observation, actions, frame_skip, repeat_action_probability, max_ticks)
        self._environments = ManyEnvironments(1, options, recorded=[0])
        self.action_space = action_space(self._environments)
        self.observation_space = observation_space(self._environments)
        if render_mode is not None and render_mode not in self.metadata["render_modes"]:
            raise ValueError(f"render_mode must be one of {self.metadata['render_modes']} or None, not {render_mode!r}")
        self.render_mode = render_mode

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[npt.NDArray[Any], dict[str, Any]]:
        """Begin the next episode; the first of a seed, where one is given. options: none are known."""
        super().reset(seed=seed, options=options)
        if seed is not None or not self._environments.begun:
            self._environments.seed([base_seed(self.np_random_seed if seed is None else seed, 0)], _ONE)
        self._environments.begin(_ONE)
        return self._seen(), self._info()

    def step(self, action: Any) -> tuple[npt.NDArray[Any], float, bool, bool, dict[str, Any]]:
        """Take an action for `frame_skip` ticks. Raises ValueError for a wrong one; then nothing is changed."""
        if not self._environments.begun or self._environments.episodes["ended"][0]:
            raise ResetNeeded("the episode is over, or none has begun: call reset")
        taken = np.asarray(action)
        if self.action_space.shape != taken.shape:
            raise ValueError(f"action must be of shape {self.action_space.shape}, not {action!r}")
        done = self._environments.step(taken[np.newaxis])
        return self._seen(), float(done.rewards[0]), bool(done.over[0]), bool(done.cut_off[0]), self._info()

    def render(self) -> npt.NDArray[np.uint8] | None:
        """The picture, where `render_mode` is "rgb_array"."""
        return None if self.render_mode is None else frame(self._environments, 0)

    def get_state(self) -> State:
        """Everything that decides how the game goes on, as a copy."""
        return self._environments.state()

    def set_state(self, state: State) -> npt.NDArray[Any]:
        """Go on from a state that `get_state` returned: its observation."""
        self._environments.set_state(state)
        return self._seen()

    def game(self) -> Game:
        """The game as `game.rules.tick` takes it."""
        return self._environments.game(0)

    def record(self, path: str | Path) -> None:
        """Write the game that is played, or, where it has just begun, the one before, as a replay (.polar)."""
        self._environments.record(0, Path(path))

    def _seen(self) -> npt.NDArray[Any]:
        """What the agent sees."""
        seen: npt.NDArray[Any] = self._environments.observations()[0]
        return seen

    def _info(self) -> dict[str, Any]:
        """Score, lives and ticks of the episode."""
        episode = self._environments.episodes[0]
        return {"score": int(episode["score"]), "lives": int(episode["lives"]), "ticks": int(episode["tick"])}
