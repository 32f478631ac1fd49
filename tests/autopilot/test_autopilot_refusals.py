"""What the autopilot of a batch refuses in one line that names the argument; nothing is compiled."""

import numpy as np
import pytest

from game.levels import chosen
from game.rules import TICK, new_game
from physics.batch import Batch, batch
from tools.autopilot import BatchAutopilot, batch_autopilot

COUNT = 3
LEVEL = chosen("Three Rings")[0]
ARENA = new_game((LEVEL,), 1).arena


@pytest.fixture(autouse=True)
def nothing_is_compiled(monkeypatch):
    """The compiled functions are not called where an argument is refused."""
    monkeypatch.setattr(batch, "compiled", lambda: None)
    monkeypatch.setattr(batch_autopilot, "compiled_autopilot", lambda: BatchAutopilot)


@pytest.fixture
def games():
    """A batch that is never stepped."""
    return Batch([ARENA] * COUNT, dt=TICK, speed=LEVEL.ball.speed, ground_radius=LEVEL.ground_radius)


@pytest.mark.parametrize("wrong", [0, -1, 1.5, True, "8", 2**62, None])
def test_a_number_of_games_is_whole_and_above_0(wrong):
    """numpy's own messages name no argument."""
    with pytest.raises(ValueError, match="games must be a whole number from 1 to"):
        BatchAutopilot(LEVEL, wrong)


def test_a_level_is_no_name_and_no_list_of_levels():
    """`chosen` returns several levels: one of them is wanted."""
    for wrong in ("Three Rings", (LEVEL,), None):
        with pytest.raises(ValueError, match="level must be one of"):
            BatchAutopilot(wrong, COUNT)


@pytest.mark.parametrize("wrong", [COUNT, "a", 1.5, np.ones(COUNT + 1, np.bool_)])
def test_forgotten_games_are_games_of_the_autopilot(wrong):
    """A number, numbers or a mask of another size."""
    with pytest.raises(ValueError, match=f"games must be an index of {COUNT} games"):
        BatchAutopilot(LEVEL, COUNT).forget(wrong)


def test_a_step_refuses_what_cannot_steer(games):
    """No flag, no class in place of an object, no autopilot of another batch."""
    for wrong in ("yes", True, BatchAutopilot):
        with pytest.raises(ValueError, match="autopilot must be as BatchAutopilot"):
            games.step(autopilot=wrong)
    with pytest.raises(ValueError, match=f"autopilot must be one of {COUNT} games, not of 1"):
        games.step(autopilot=BatchAutopilot(LEVEL, 1))
