"""Every level of the campaign can be won at normal difficulty, by the autopilot and by a simulated human (220 ms, 5 degrees).

The replays were recorded by playing each level alone: the autopilot with seeds 0, 1, 2 and so on until it had won, the human
with the seeds of the measured games, the shortest first, which keeps the files small. A level that is changed needs new ones.
"""

import pytest

from game.levels import campaign
from game.replays.file import load
from game.replays.verify import verified
from game.rules import Difficulty, Phase
from tests.support.paths import TESTS

pytestmark = pytest.mark.deep


@pytest.mark.parametrize("player", ["autopilot", "human"])
@pytest.mark.parametrize("number", range(1, len(campaign()) + 1))
def test_a_level_has_been_won(number, player):
    """The replay is of the level as it is now, verifies to the last hash, and ends with a win."""
    recording = load(TESTS / "golden" / "campaign" / f"{number:02}-{player}.polar")
    assert recording.levels == [campaign()[number - 1]]
    verdict = verified(recording)
    assert verdict.divergence is None
    assert verdict.game.phase == Phase.WON
    assert verdict.game.ruleset.difficulty == Difficulty.NORMAL
    assert verdict.game.lives > 0
