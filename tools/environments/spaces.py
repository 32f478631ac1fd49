"""The spaces of actions and observations, and pictures in colour."""

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.spaces import Box, Discrete

from tools.environments.many import DISCRETE_ACTIONS, PICTURE_SHAPES, ManyEnvironments

RENDER_SIZE = 336
"""Rows and columns of a rendered picture."""

_DARK, _BRIGHT = np.array([12.0, 14.0, 24.0]), np.array([255.0, 244.0, 220.0])
_COLOURS = (_DARK + np.linspace(0.0, 1.0, 256)[:, np.newaxis] * (_BRIGHT - _DARK)).astype(np.uint8)


def action_space(environments: ManyEnvironments) -> gymnasium.Space[Any]:
    """Of one environment.

    Rest, counter-clockwise, clockwise; x and y of the direction that the nearest paddle goes to; for the autopilot 0 alone.
    """
    if environments.options.actions == "autopilot":
        return Discrete(1)
    if environments.options.actions == "discrete":
        return Discrete(DISCRETE_ACTIONS)
    return Box(-1.0, 1.0, (2,), np.float32)


def observation_space(environments: ManyEnvironments) -> gymnasium.Space[Any]:
    """Of one environment."""
    if environments.options.observation == "state":
        return Box(-1.0, 1.0, (environments.state_size,), np.float32)
    return Box(0, 255, (*PICTURE_SHAPES[environments.options.observation], 1), np.uint8)


def frame(environments: ManyEnvironments, index: int) -> npt.NDArray[np.uint8]:
    """(RENDER_SIZE, RENDER_SIZE, 3): one environment in colour."""
    coloured: npt.NDArray[np.uint8] = _COLOURS[environments.picture(index, RENDER_SIZE)]
    return coloured
