"""Points, ranks, lives and statistics under the arcade rules."""

import math

import pytest

from game.levels import parse
from game.rules import (
    EXTRA_LIFE_POINTS,
    SOURCE_RULES,
    ActivePower,
    Controls,
    Difficulty,
    Drop,
    EventKind,
    HeldBall,
    Phase,
    PowerUp,
    Rank,
    Ruleset,
    Tally,
    continued,
    new_game,
    par,
    rank_of,
)
from tests.support.games.arcade import GOOD, LEVEL, SERVE, after, arcade, kinds, until, with_balls

SECOND = 240


def last_brick(game):
    """The game with one brick left and a ball on its way to it."""
    layers = (game.arena.layers[0], (1, *[0] * 11), *game.arena.layers[2:])
    game = game._replace(arena=game.arena._replace(layers=layers))
    return with_balls(game, (5.0 + 0j, -1.0 + 0j))


def test_par_is_fifteen_seconds_and_one_and_a_half_for_every_layer():
    """Unbreakable sectors count nothing."""
    assert par(LEVEL) == 15.0 + 1.5 * 12
    assert par(parse(GOOD.replace(b"count = 12", b"count = 12\nlayers = [3, -1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0]"), "x")) == 33.0


@pytest.mark.parametrize(
    ("lost", "seconds", "combo", "rank"),
    [
        (0, 33, 8, Rank.S),
        (0, 33, 7, Rank.A),
        (0, 34, 8, Rank.A),
        (1, 33, 8, Rank.A),
        (1, 33, 0, Rank.B),
        (0, 67, 0, Rank.B),
        (1, 66, 0, Rank.B),
        (1, 67, 0, Rank.C),
        (5, 67, 8, Rank.C),
    ],
)
def test_a_rank_is_the_sum_of_its_marks(lost, seconds, combo, rank):
    """Lives, time and combo, as documented."""
    assert rank_of(LEVEL, Tally(best_combo=combo, balls_lost=lost, ticks=seconds * SECOND)) == rank


def test_a_cleared_level_gives_its_bonuses_and_a_result():
    """A hundred for a life, ten for every second below par, five hundred for no lost life."""
    game = last_brick(arcade())._replace(phase_tick=10 * SECOND)
    done = until(game, EventKind.LEVEL_CLEARED, 60)
    (result,) = done.game.results
    seconds = (10 * SECOND + 1) / SECOND
    assert result.time_bonus == 10 * int(33.0 - result.ticks / SECOND)
    assert result.ticks >= seconds * SECOND
    assert (result.loss_bonus, result.balls_lost, result.level) == (500, 0, 0)
    assert result.score == done.game.score == 10 + 300 + 500 + result.time_bonus
    assert done.events[-2].points == 800 + result.time_bonus
    assert result.rank == rank_of(LEVEL, done.game.statistics.level)


def test_a_cleared_level_leaves_nothing_behind():
    """No drop is on its way, no ball sticks to a paddle while the next level is waited for; then no power lasts."""
    start = last_brick(new_game((LEVEL, LEVEL), 1, Ruleset()))
    start = start._replace(drops=(Drop(PowerUp.WIDE, 7j, 1j),), held=(HeldBall(0, 0.0, 0.25, 1),))
    done = until(start._replace(powers=(ActivePower(PowerUp.WIDE, 5000, 5000),)), EventKind.LEVEL_CLEARED, 60)
    assert (done.game.drops, done.game.held) == ((), ())
    later = until(done.game, EventKind.LEVEL_STARTED, 600, SERVE).game
    assert (later.powers, later.arena.rings[0].half_angle) == ((), pytest.approx(math.radians(20.0)))


def test_a_lost_life_costs_the_bonus_of_none():
    """And stands in the result."""
    game, _ = after(with_balls(arcade(), (6j, 1.0)), 1, Controls(give_up=True))
    done = until(last_brick(game), EventKind.LEVEL_CLEARED, 60)
    (result,) = done.game.results
    assert (result.loss_bonus, result.balls_lost) == (0, 1)
    assert done.game.statistics.level.balls_lost == done.game.statistics.game.balls_lost == 1


def test_the_sources_rules_give_no_new_points():
    """A level's result says how it went all the same."""
    done = until(last_brick(new_game((LEVEL,), 1, SOURCE_RULES)._replace()), EventKind.LEVEL_CLEARED, 60)
    assert done.game.score == 10 + 300
    (result,) = done.game.results
    assert (result.score, result.time_bonus, result.loss_bonus, result.rank) == (310, 0, 0, Rank.A)


def test_every_ten_thousand_points_are_a_life():
    """One for each multiple that is passed, not again for the same."""
    game = last_brick(arcade(level=parse(GOOD.replace(b"count = 12", b"count = 12\nlayers = 2"), "x")))
    done = until(game._replace(score=EXTRA_LIFE_POINTS - 5), EventKind.BRICK_HIT, 60)
    assert EventKind.LIFE_GAINED in kinds(done.events)
    assert done.game.lives == 4
    done = until(game._replace(score=EXTRA_LIFE_POINTS), EventKind.BRICK_HIT, 60)
    assert done.game.lives == 3


def test_a_bonus_that_passes_ten_thousand_is_a_life_too():
    """Of the level's end."""
    done = until(last_brick(arcade())._replace(score=EXTRA_LIFE_POINTS - 100), EventKind.LEVEL_CLEARED, 60)
    assert done.game.lives == 4


@pytest.mark.parametrize("difficulty", Difficulty)
def test_a_level_begins_with_the_lives_of_a_game_at_least(difficulty):
    """Fewer are topped up, more are kept; its own numbers are counted from 0, those of the game go on."""
    ruleset = Ruleset(difficulty)
    lives = ruleset.handicap.lives
    for before, now in ((1, lives), (8, 8)):
        game = last_brick(new_game((LEVEL, LEVEL), 1, ruleset))._replace(lives=before)
        done = until(game, EventKind.LEVEL_CLEARED, 60)
        later = until(done.game, EventKind.LEVEL_STARTED, 600, SERVE).game
        assert (later.lives, later.number, later.phase) == (now, 1, Phase.SERVING)
        assert later.statistics.level == Tally()
        assert later.statistics.game.bricks == 1
        assert later.score_before == later.score


def test_a_lost_game_is_taken_up_at_its_level():
    """Without its points, with all lives, by the same rules."""
    ruleset = Ruleset(Difficulty.EASY)
    game = new_game((LEVEL, LEVEL, LEVEL), 1, ruleset)._replace(number=1, score=500, lives=1)
    again = continued(game)
    assert (again.levels, again.score, again.lives, again.ruleset) == ((LEVEL, LEVEL), 0, 5, ruleset)


def test_statistics_count_what_happened():
    """Bricks, the best row of them, and hits of paddles."""
    game, _ = after(with_balls(arcade(), (-8.0j, -1.0j)), 40)
    assert game.statistics.level.paddle_hits == 1
    layers = ((-1,) * 3, (1,) * 12, (0,))
    game = with_balls(game._replace(arena=game.arena._replace(layers=layers)), (5.0 + 0j, -1.0), (-5.0 + 0j, 1.0))
    game, _ = after(game, 60)
    assert (game.statistics.level.bricks, game.statistics.level.best_combo) == (2, 2)
    game, _ = after(with_balls(game._replace(combo=0), (5.0j, -1.0j)), 60)
    assert (game.statistics.level.bricks, game.statistics.game.best_combo) == (3, 2)
