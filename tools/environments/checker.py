"""A checker for vector environments: whether they do what Gymnasium's `SyncVectorEnv` does with single ones.

Gymnasium's own checker takes single environments only.
"""

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, SyncVectorEnv, VectorEnv

_COUNT = 3
_SEEDS = [11, 12, 13]
_FEW_STEPS = 60
"""Within which no episode ends, and the first balls are served."""
_FIELDS = ("observations", "rewards", "terminations", "truncations", "infos")


def check_vector_env(
    make_vector: Callable[[int, AutoresetMode], VectorEnv[Any, Any, Any]],
    make: Callable[[], gymnasium.Env[Any, Any]],
    steps: int,
) -> None:
    """Raise AssertionError, naming what differs, unless vector environments answer as single ones do, in all autoreset modes.

    make_vector: of a number of environments. make: one such environment, whose episodes end within `steps` steps.
    """
    for mode in AutoresetMode:
        ours, theirs = make_vector(_COUNT, mode), SyncVectorEnv([make] * _COUNT, autoreset_mode=mode)
        try:
            _check_spaces(ours, theirs)
            assert ours.metadata["autoreset_mode"] is mode, f"metadata['autoreset_mode'] is not {mode}"
            ended = _check_steps(ours, theirs, mode, steps)
            assert ended >= 2 * _COUNT, f"{mode}: only {ended} episodes ended in {steps} steps"
            _check_one_seed(ours)
        finally:
            ours.close()
            theirs.close()


def _check_spaces(ours: VectorEnv[Any, Any, Any], theirs: VectorEnv[Any, Any, Any]) -> None:
    """The spaces are those of so many single environments."""
    assert ours.num_envs == theirs.num_envs, "num_envs"
    for name in ("single_observation_space", "single_action_space", "observation_space", "action_space"):
        assert getattr(ours, name) == getattr(theirs, name), f"{name} is {getattr(ours, name)}, not {getattr(theirs, name)}"


def _check_steps(ours: VectorEnv[Any, Any, Any], theirs: VectorEnv[Any, Any, Any], mode: AutoresetMode, steps: int) -> int:
    """The answers are those of single environments with the same seeds and actions; how many episodes ended."""
    ours.action_space.seed(1)
    seeds: Any = _SEEDS  # the base class knows of one seed only
    _check_same("reset", ours.reset(seed=seeds), theirs.reset(seed=seeds), (_FIELDS[0], _FIELDS[-1]))
    ended, before = 0, None
    for number in range(steps):
        actions = ours.action_space.sample()
        mine: tuple[Any, ...] = ours.step(actions)
        _check_same(f"{mode}, step {number}", mine, theirs.step(actions), _FIELDS)
        assert mine[0] in ours.observation_space, f"step {number}: observations are not in the space"
        assert before is None or not np.shares_memory(mine[0], before), f"step {number}: observations are written over"
        before, over = mine[0], mine[2] | mine[3]
        ended += int(over.sum())
        if mode is AutoresetMode.DISABLED and over.any():
            options = {"reset_mask": over}
            mine, reference = ours.reset(options=options.copy()), theirs.reset(options=options.copy())
            _check_same(f"reset after step {number}", mine, reference, (_FIELDS[0], _FIELDS[-1]))
    return ended


def _check_one_seed(env: VectorEnv[Any, Any, Any]) -> None:
    """One seed gives every environment a game of its own, and the same ones again."""
    runs = []
    for _ in range(2):
        env.reset(seed=5)
        env.action_space.seed(5)
        actions = env.action_space.sample()
        actions[1:] = actions[0]
        runs.append([env.step(actions)[0] for _ in range(_FEW_STEPS)])
    assert all((a == b).all() for a, b in zip(*runs, strict=True)), "the same seed gives other games"
    assert any((seen[0] != seen[1]).any() for seen in runs[0]), "environments 0 and 1 play the same game"


def _check_same(where: str, ours: tuple[Any, ...], theirs: tuple[Any, ...], names: tuple[str, ...]) -> None:
    """Two answers have the same values, types and shapes."""
    for name, a, b in zip(names, ours, theirs, strict=True):
        assert _same(a, b), f"{where}: {name} {a!r}, of single environments {b!r}"


def _same(a: Any, b: Any) -> bool:
    """Whether two values of an answer are the same."""
    if isinstance(a, dict):
        return a.keys() == b.keys() and all(_same(a[key], b[key]) for key in a)
    if isinstance(a, np.ndarray) and a.dtype == object:
        return len(a) == len(b) and all(_same(x, y) for x, y in zip(a, b, strict=True))
    if isinstance(a, np.ndarray):
        return isinstance(b, np.ndarray) and a.dtype == b.dtype and a.shape == b.shape and bool((a == b).all())
    return type(a) is type(b) and a == b
