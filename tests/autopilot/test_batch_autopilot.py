"""The compiled autopilot steers as the game's own: controls and every bit of the state are compared after every tick."""

import pytest

from game.autopilot.source_pilot import SourcePilot
from game.levels import chosen
from game.rules import TICK, Phase, new_game, tick
from physics.batch import Batch
from tools.autopilot import BatchAutopilot

pytestmark = pytest.mark.deep


@pytest.mark.parametrize("level", ["1", "Sunflower"])
def test_a_batch_is_steered_as_a_game(level):
    """x."""
