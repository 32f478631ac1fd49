"""What has to be done for a ball or a trail."""

from game.rules import Rank
from game.unlocks import BALLS, PLAIN_BALL, PLAIN_TRAIL, TRAILS, Feat, ball_names, trail_names, unlocked


def feats(count, score=100, rank=Rank.C):
    """Levels finished, each in the same way."""
    return [Feat(f"level {k}", score, rank) for k in range(count)]


def test_at_first_there_is_the_plain_one_alone():
    """Who has finished nothing has one ball and one trail."""
    assert unlocked(BALLS, []) == (PLAIN_BALL,)
    assert unlocked(TRAILS, []) == (PLAIN_TRAIL,)


def test_all_can_be_had_and_each_alone_has_its_price():
    """Twenty-four perfect levels open everything; of every condition one less is not enough."""
    assert unlocked(BALLS, feats(24, 3000, Rank.S)) == tuple(BALLS)
    assert unlocked(TRAILS, feats(24, 3000, Rank.S)) == tuple(TRAILS)
    for conditions in (BALLS, TRAILS):
        for name, condition in conditions.items():
            enough = (
                feats(max(condition.needed, 1), 1, Rank.S)
                if condition.needed < 100
                else [Feat("one", condition.needed, Rank.C)]
            )
            short = enough[:-1] if condition.needed < 100 else [Feat("one", condition.needed - 1, Rank.C)]
            assert name in unlocked(conditions, enough)
            assert name not in unlocked(conditions, short) or not condition.needed
            assert str(condition.needed) in condition.text.replace(",", "") or not condition.needed


def test_a_level_counts_once_with_its_best():
    """The same level at two difficulties is one level; its score and its rank are the better ones."""
    twice = [Feat("one", 100, Rank.S), Feat("one", 20_000, Rank.C)] * 30
    assert "ember" in unlocked(BALLS, twice)
    assert "marble" not in unlocked(BALLS, twice)


def test_everything_has_a_name():
    """Each ball and each trail is called something else."""
    assert set(ball_names()) == set(BALLS)
    assert set(trail_names()) == set(TRAILS)
    assert len({*ball_names().values(), *trail_names().values()}) == len(BALLS) + len(TRAILS)
