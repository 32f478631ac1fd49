"""The balls' speed, and the paddles' with it."""

import math

import pytest

from game.levels import parse
from game.rules import Controls, Difficulty, EventKind, PowerUp, Ruleset, paddle_ring
from game.rules.power_up import ActivePower
from game.rules.speed import HITS_PER_STEP, speed_now
from physics import direction, length
from tests.support.games.arcade import EVERYTHING, GOOD, after, arcade, changed, kinds, until, with_balls


def lasting(*names):
    """Power-ups that last."""
    return tuple([ActivePower(kind, 1000, 1000) for kind in names])


def test_every_sixth_hit_of_a_paddle_makes_the_balls_faster():
    """By the level's growth of its speed, all of them at once; a serve begins anew."""
    game = arcade()._replace(paddle_hits=HITS_PER_STEP - 1)
    outward = direction(paddle_ring(game).angle(0))
    done = until(with_balls(game, (outward * 8.0, outward), (0.5j, 1.0)), EventKind.PADDLE_HIT, 60)
    assert kinds(done.events) == [EventKind.PADDLE_HIT, EventKind.SPEED_UP]
    assert [length(ball.velocity) for ball in done.game.arena.balls] == [pytest.approx(9.0 * 1.04)] * 2
    lost, _ = after(done.game, 1, Controls(give_up=True))
    assert (lost.speed, lost.paddle_hits) == (9.0, 0)


def test_the_growth_ends_at_the_top_speed():
    """The level's, or 1.4 times its speed."""
    for text, top in ((b"", 1.4 * 9.0), (b"top_speed = 9.9\n", 9.9)):
        level = parse(GOOD.replace(b"speed = 9.0\n", b"speed = 9.0\n" + text), "x")
        assert speed_now(arcade(level)._replace(paddle_hits=10_000)) == pytest.approx(top)


def test_a_difficulty_changes_the_speed():
    """Easy balls are slower, hard ones faster, at the start and at the top."""
    starts, tops = [], []
    for difficulty in Difficulty:
        game = arcade(ruleset=Ruleset(difficulty))
        starts.append(game.speed / 9.0)
        tops.append(speed_now(game._replace(paddle_hits=10_000)) / (1.4 * 9.0))
    assert starts == [pytest.approx(0.85), 1.0, pytest.approx(1.15)] == tops


def test_no_ball_is_slower_than_a_ring_or_than_its_floor():
    """A slow ball of an easy game in a level whose ring is nearly as fast as the ball: it is faster than the ring."""
    easy = Ruleset(Difficulty.EASY)
    slow = arcade(ruleset=easy)._replace(powers=lasting(PowerUp.SLOW))
    assert speed_now(slow) == pytest.approx(0.64 * 9.0)
    level = parse(changed("count = 12", "count = 12\nspin = 150.0"), "x")
    game = arcade(level, ruleset=easy)._replace(powers=lasting(PowerUp.SLOW))
    assert speed_now(game) > math.radians(150.0) * 3.4
    assert speed_now(game) <= 9.0


def test_fast_slow_and_a_bumper_are_factors():
    """Of the speed that there is without them."""
    game = arcade()
    for powers, burst, factor in (
        ((PowerUp.SLOW,), 0, 0.75),
        ((PowerUp.FAST,), 0, 1.25),
        ((), 1, 1.2),
        ((PowerUp.FAST,), 1, 1.5),
    ):
        assert speed_now(game._replace(powers=lasting(*powers), burst=burst)) == pytest.approx(9.0 * factor)


def test_a_bumper_gives_points_and_a_second_of_speed():
    """Its sectors are walls for the physics; afterwards the balls fly as before."""
    game = arcade(EVERYTHING)
    bumper = direction(game.arena.rings[3].angle(0))
    hit = until(with_balls(game, (bumper * 2.3, -bumper)), EventKind.BUMPER_HIT, 20)
    assert hit.game.score - game.score == 5
    assert hit.game.speed == pytest.approx(9.0 * 1.2)
    assert length(hit.game.arena.balls[0].velocity) == pytest.approx(9.0 * 1.2)
    later = hit.game
    for _ in range(240):
        later, _ = after(with_balls(later, (6.8j, 1.0)), 1)
    assert later.speed == 9.0


def test_paddles_are_as_much_faster_as_the_balls():
    """Until they would be as fast as a ball; and they slow down with it at once."""
    game = with_balls(arcade()._replace(powers=lasting(PowerUp.FAST)), (-6j, 1.0))
    game, _ = after(game, 1)
    fast, _ = after(with_balls(game, (-6j, 1.0)), 80, Controls(turn=1))
    assert paddle_ring(fast).spin == pytest.approx(min(math.radians(50.0) * 1.25, 0.95 * fast.speed / 9.2))
    served, _ = after(fast, 1, Controls(turn=1, give_up=True))
    assert served.speed == 9.0
    assert abs(paddle_ring(served).spin) * 9.2 <= 0.95 * 9.0 * (1.0 + 1e-12)
    slow, _ = after(fast._replace(powers=lasting(PowerUp.SLOW)), 1, Controls(turn=1))
    assert abs(paddle_ring(slow).spin) * 9.2 <= 0.95 * slow.speed * (1.0 + 1e-12)
    assert slow.speed == pytest.approx(0.75 * 9.0)
