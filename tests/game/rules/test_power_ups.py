"""Power-ups: how they come, how they are caught, and what each does."""

import math

import pytest

from game.levels import parse
from game.rules import LASTING, Difficulty, Drop, EventKind, Phase, PowerUp, Ruleset, paddle_ring, shield_layers, tick
from game.rules.drops import DROP_RADIUS, _kind_of, with_drop
from game.rules.power_up import OPPOSITES, ActivePower
from physics import PERMANENT, contact, direction, dot, in_band, length, min_difference
from tests.support.games.arcade import GOOD, IDLE, after, arcade, changed, kinds, until, with_balls

QUIET = ((-6.0j, 1.0 + 0.2j),)
"""A ball that meets nothing for the first ticks."""


def catching(game, *wanted):
    """The game after paddle 0 has caught power-ups, and the events."""
    on_paddle = direction(paddle_ring(game).angle(0)) * paddle_ring(game).radius
    return after(game._replace(drops=tuple([Drop(kind, on_paddle, on_paddle * 1e-9) for kind in wanted])), 1)


def playing(**level):
    """A game in play with nothing near its ball."""
    return with_balls(arcade(**level), *QUIET)


def always_dropping(*names):
    """A level whose every broken brick leaves one of these power-ups."""
    listed = ", ".join(f'"{name}"' for name in names)
    return parse(GOOD + f"[drops]\nchance = 1.0\nkinds = [{listed}]\n".encode(), "x")


def test_a_broken_brick_leaves_a_drop_that_drifts_outward():
    """From where the brick was hit, along its bearing, a fifth of the ground a second, until it is lost at the rim."""
    game = with_balls(arcade(always_dropping("wide")), (5.0 + 0j, -1.0 + 0j))
    done = until(game, EventKind.DROP_RELEASED, 60)
    (drop,) = done.game.drops
    released = done.events[kinds(done.events).index(EventKind.DROP_RELEASED)]
    assert (drop.kind, released.power) == (PowerUp.WIDE, PowerUp.WIDE)
    assert length(released.position) == pytest.approx(3.4)
    later = done.game._replace(arena=done.game.arena._replace(balls=()), held=())
    for _ in range(100):
        later, _ = after(with_balls(later, (0.5j, 1.0)), 1)
    moved = later.drops[0].position
    assert length(moved) - length(drop.position) == pytest.approx(0.2 * 10.0 * 100 / 240.0)
    assert min_difference(0.0, abs(math.atan2(moved.imag, moved.real))) < 1e-9
    game = later
    seen = []
    for _ in range(900):
        game, events = after(with_balls(game, (0.5j, 1.0)), 1)
        seen += events
    assert EventKind.DROP_LOST in kinds(seen)
    assert game.drops == ()


def test_a_drop_is_caught_where_it_touches_a_paddle():
    """As a disc: not beside the paddle, and not before it is at its track. It gives fifty points."""
    game = playing()
    paddles = paddle_ring(game)
    reach = DROP_RADIUS * 10.0
    for distance, angle, caught in (
        (8.8 - reach - 0.01, 0.0, False),
        (8.8 - reach + 0.01, 0.0, True),
        (9.0, paddles.half_angle + 0.03, True),
        (9.0, paddles.half_angle + 0.05, False),
    ):
        position = direction(paddles.angle(0) + angle) * distance
        later, events = after(game._replace(drops=(Drop(PowerUp.SLOW, position, position * 1e-9),)), 1)
        assert (EventKind.DROP_CAUGHT in kinds(events)) is caught, (distance, angle)
        assert later.score == (50 if caught else 0)
        assert later.statistics.level.drops_caught == later.statistics.game.drops_caught == caught


def test_how_often_and_which_is_the_seeds_and_the_levels():
    """A chance of nothing leaves nothing; the kinds are those that the level names, a life one time for three of another."""
    never = with_balls(arcade(parse(GOOD + b"[drops]\nchance = 0.0\n", "x")), (5.0 + 0j, -1.0 + 0j))
    assert EventKind.DROP_RELEASED not in kinds(after(never, 80)[1])
    drawn = [_kind_of(k / 1000.0, ["slow", "life", "wide"]) for k in range(1000)]
    assert [drawn.count(kind) for kind in (PowerUp.SLOW, PowerUp.LIFE, PowerUp.WIDE)] == [429, 143, 428]
    left = {
        until(with_balls(arcade(always_dropping("slow", "wide", "fast"), seed), (5.0 + 0j, -1.0)), EventKind.DROP_RELEASED, 60)
        .game.drops[0]
        .kind
        for seed in range(12)
    }
    assert left == {PowerUp.SLOW, PowerUp.WIDE, PowerUp.FAST}


def test_a_difficulty_changes_how_often():
    """Of a hundred bricks at a chance of a half, by the same seeds: more on easy, fewer on hard."""
    level = parse(GOOD + b"[drops]\nchance = 0.5\n", "x")
    counts = []
    for difficulty in Difficulty:
        games = [arcade(level, seed, Ruleset(difficulty)) for seed in range(100)]
        counts.append(sum([len(with_drop(game, 3j, []).drops) for game in games]))
    assert counts[0] > counts[1] + 10
    assert counts[1] > counts[2] + 5
    assert 35 < counts[1] < 65


def test_three_drops_are_on_their_way_at_most():
    """While there are three, a broken brick leaves none."""
    game = with_balls(arcade(always_dropping("wide")), (5.0 + 0j, -1.0 + 0j))
    position = 6.0j
    game, events = after(game._replace(drops=(Drop(PowerUp.SLOW, position, position * 1e-9),) * 3), 60)
    assert EventKind.BRICK_HIT in kinds(events)
    assert EventKind.DROP_RELEASED not in kinds(events)


def test_multi_ball_makes_three_of_one():
    """The two more fly 25 degrees to either side, at the same speed; a life is lost with the last of the three alone."""
    game, _ = catching(playing(), PowerUp.MULTI_BALL)
    first, *more = game.arena.balls
    assert len(more) == 2
    for ball in more:
        assert ball.position == first.position
        cosine = dot(ball.velocity, first.velocity) / (length(ball.velocity) * length(first.velocity))
        assert math.degrees(math.acos(cosine)) == pytest.approx(25.0)
    outward = direction(math.radians(30.0))
    for left in (2, 1):
        balls = [(outward * 10.3, outward), *[(1j * k, 1.0) for k in range(left)]]
        game, events = after(with_balls(game, *balls), 1)
        assert (len(game.arena.balls), game.lives, game.phase) == (left, 3, Phase.PLAYING)
        assert kinds(events) == [EventKind.BALL_LOST]
    game, events = after(with_balls(game, (outward * 10.3, outward)), 1)
    assert (game.lives, game.phase) == (2, Phase.SERVING)


def test_there_are_nine_balls_at_most():
    """A tenth is not made."""
    game = playing()
    for _ in range(6):
        game, _ = catching(game, PowerUp.MULTI_BALL)
    assert len(game.arena.balls) == 9


@pytest.mark.parametrize(("kind", "factor"), [(PowerUp.WIDE, 1.4), (PowerUp.NARROW, 0.7)])
def test_wide_and_narrow_change_the_paddles(kind, factor):
    """By their factor, for their time, then as before."""
    game = playing()
    before = paddle_ring(game).half_angle
    game, _ = catching(game, kind)
    assert paddle_ring(game).half_angle == pytest.approx(before * factor)
    game = game._replace(powers=tuple([power._replace(ticks_left=2) for power in game.powers]))
    game, events = after(game, 2)
    assert [event.power for event in events if event.kind == EventKind.POWER_ENDED] == [kind]
    assert paddle_ring(game).half_angle == before


def test_paddles_never_close_the_ring():
    """However wide the level's are: wide ones cover four fifths of the circle, or what they covered before."""
    for half_angle in (20.0, 40.0, 55.0):
        level = parse(changed("half_angle = 20.0", f"half_angle = {half_angle}"), "x")
        game, _ = catching(with_balls(arcade(level, ruleset=Ruleset(Difficulty.EASY)), *QUIET), PowerUp.WIDE)
        assert math.degrees(paddle_ring(game).half_angle) <= max(half_angle, 48.0) + 1e-9


def test_a_paddle_grows_only_where_no_ball_is_in_the_way():
    """A ball beside its end is not swallowed: the paddle waits until it has passed."""
    game = playing()
    paddles = paddle_ring(game)
    beside = direction(paddles.angle(0) + paddles.half_angle + 0.08) * 9.0
    game, _ = catching(with_balls(game, (beside, beside)), PowerUp.WIDE)
    assert paddle_ring(game).half_angle == paddles.half_angle
    assert game.power(PowerUp.WIDE) is not None
    game, _ = after(with_balls(game, *QUIET), 1)
    assert paddle_ring(game).half_angle > paddles.half_angle


@pytest.mark.parametrize("kind", OPPOSITES)
def test_opposites_end_each_other(kind):
    """Whoever has one and catches the other has neither."""
    game, _ = catching(playing(), OPPOSITES[kind])
    game, events = catching(game, kind)
    assert game.powers == ()
    assert EventKind.POWER_ENDED in kinds(events)


def test_the_same_again_lasts_anew():
    """There is one of a kind, with all its time."""
    game, _ = after(catching(playing(), PowerUp.STICKY)[0], 50)
    assert game.powers[0].ticks_left < LASTING[PowerUp.STICKY] - 45
    game, _ = catching(with_balls(game, *QUIET), PowerUp.STICKY)
    (power,) = game.powers
    assert power.ticks_left >= LASTING[PowerUp.STICKY] - 1
    assert power.share_left == pytest.approx(1.0, abs=1e-3)


def test_a_life_is_one_more_up_to_nine():
    """The tenth is not given."""
    game, events = catching(playing(), PowerUp.LIFE)
    assert game.lives == 4
    assert EventKind.LIFE_GAINED in kinds(events)
    game, events = catching(with_balls(game._replace(lives=9), *QUIET), PowerUp.LIFE)
    assert game.lives == 9
    assert EventKind.LIFE_GAINED not in kinds(events)


def test_the_shield_returns_one_ball():
    """A ball on its way out between two paddles comes back; the shield is gone, the next ball is lost. It is no brick."""
    game, _ = catching(playing(), PowerUp.SHIELD)
    assert shield_layers(game) == 1
    outward = direction(paddle_ring(game).angle(0) + math.pi / 3.0)
    shot = with_balls(game, (outward * 8.0, outward))
    done = until(shot, EventKind.SHIELD_HIT, 60)
    assert [event.power for event in done.events if event.kind == EventKind.POWER_ENDED] == [PowerUp.SHIELD]
    assert shield_layers(done.game) == 0
    assert (done.game.score, done.game.statistics.level.bricks) == (game.score, 0)
    back, _ = after(done.game, 40)
    assert length(back.arena.balls[0].position) < 8.0
    _, events = after(with_balls(back, (outward * 8.0, outward)), 120)
    assert EventKind.BALL_LOST in kinds(events)


def test_the_shield_waits_for_a_ball_that_is_where_it_will_be():
    """It stands as soon as the ball is gone, and lasts until it is hit."""
    game = playing()
    outward = direction(paddle_ring(game).angle(0) + math.pi / 3.0)
    shield = game.arena.rings[-1]
    game, _ = catching(with_balls(game, (outward * shield.radius, outward), (0.5j, 1.0)), PowerUp.SHIELD)
    assert shield_layers(game) == 0
    game, _ = after(with_balls(game, (0.5j, 1.0)), 3)
    assert shield_layers(game) == 1
    game, _ = after(with_balls(game, *QUIET), 50)
    assert game.powers == (ActivePower(PowerUp.SHIELD, 0, 0),)


def test_easy_serves_begin_with_a_shield():
    """And others do not."""
    for difficulty in Difficulty:
        assert shield_layers(arcade(ruleset=Ruleset(difficulty))) == (difficulty == Difficulty.EASY)


def test_a_piercing_ball_flies_through_bricks_and_breaks_them():
    """With all their layers and the points of each; its flight stays straight."""
    level = parse(changed("count = 12", "count = 12\nlayers = 3"), "x")
    game, _ = catching(with_balls(arcade(level), *QUIET), PowerUp.PIERCE)
    start = with_balls(game._replace(combo=0, score=0), (5.0 + 0j, -1.0 + 0j))
    later, events = after(start, 80)
    hits = [event for event in events if event.kind == EventKind.BRICK_HIT]
    assert [(event.hit.slot, event.hit.layers, event.points) for event in hits] == [(0, 0, 10 + 20 + 30)]
    assert (later.arena.layers[1][0], later.combo, later.statistics.level.bricks) == (0, 3, 3)
    assert later.arena.balls[0].velocity == start.arena.balls[0].velocity
    through, _ = after(later, 130)
    assert through.arena.layers[1][6] == 0


def test_a_piercing_ball_bounces_off_what_cannot_break():
    """And off paddles, and off the shield."""
    level = parse(changed("count = 12", "count = 12\nlayers = [-1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"), "x")
    game, _ = catching(with_balls(arcade(level), *QUIET), PowerUp.PIERCE, PowerUp.SHIELD)
    _, events = after(with_balls(game, (5.0 + 0j, -1.0 + 0j)), 60)
    assert kinds(events) == [EventKind.WALL_HIT]
    assert game.arena.layers[1][0] == PERMANENT
    assert EventKind.PADDLE_HIT in kinds(after(with_balls(game, (-8.0j, -1.0j)), 40)[1])
    outward = direction(paddle_ring(game).angle(0) + math.pi / 3.0)
    assert EventKind.SHIELD_HIT in kinds(after(with_balls(game, (outward * 8.0, outward)), 60)[1])


def test_what_a_piercing_ball_overlaps_is_what_is_touched():
    """Slot by slot, no brick that the ball is clear of breaks, and none that it overlaps stays."""
    level = parse(changed("half_angle = 10.0", "half_angle = 3.0").replace(b"count = 12", b"count = 60"), "x")
    for k in range(40):
        game = with_balls(
            arcade(level)._replace(powers=(ActivePower(PowerUp.PIERCE, 9, 9),)), (direction(k * 0.31) * (2.5 + 0.024 * k), 1j)
        )
        done = tick(game, IDLE).game
        (ball,), ring = done.arena.balls, done.arena.rings[1]
        assert in_band(length(ball.position), ball.radius, ring)
        for slot, left in enumerate(done.arena.layers[1]):
            assert (left == 0) is (contact(ball, ring, slot).gap < 0.0)


def test_a_lost_life_ends_all_of_it():
    """Drops, powers and balls that stick; the paddles are as wide as at the start."""
    game, _ = catching(playing(), PowerUp.WIDE, PowerUp.STICKY, PowerUp.SLOW)
    outward = direction(math.radians(30.0))
    game, events = after(with_balls(game._replace(drops=(Drop(PowerUp.FAST, 5j, 1j),)), (outward * 10.3, outward)), 1)
    assert EventKind.BALL_LOST in kinds(events)
    assert (game.phase, game.powers, game.drops, game.held) == (Phase.SERVING, (), (), ())
    assert paddle_ring(game).half_angle == math.radians(20.0)
    assert game.speed == 9.0
