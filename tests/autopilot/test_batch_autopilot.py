"""The compiled autopilot steers as the game's own: controls and every bit of the state are compared after every tick."""

import pytest

pytestmark = pytest.mark.deep


@pytest.mark.parametrize("level", ["1", "Sunflower"])
def test_a_batch_is_steered_as_a_game(level):
    """x."""
