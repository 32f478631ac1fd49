"""A paddle's hit: the ball is turned by where it meets the paddle, sticks to it, or is helped to a brick after a long wait."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.levels import parse
from game.rules import PADDLES, POINTER_STEPS, SOURCE_RULES, Controls, EventKind, Phase, new_game, paddle_ring, tick
from game.rules.closing import CLOSING_TICKS, closing_limit
from game.rules.power_up import ActivePower, PowerUp
from game.rules.turn import MOST_LEANING, paddle_hits_answered, turned
from physics import angle_of, direction, dot, length, normalize_angle, signed_difference
from tests.support.games.arcade import IDLE, SERVE, after, arcade, changed, kinds, until, with_balls

STICKY = ActivePower(PowerUp.STICKY, 5000, 5000)


def leaning(velocity, inward):
    """Radians from the way inward, counter-clockwise."""
    return signed_difference(angle_of(velocity), normalize_angle(inward))


def radial_shot(game, share):
    """The tick in which a ball that flies straight outward meets paddle 0 at a share of its half angle from its middle."""
    paddles = paddle_ring(game)
    outward = direction(paddles.angle(0) + share * paddles.half_angle)
    return until(with_balls(game, (outward * 8.0, outward)), EventKind.PADDLE_HIT, 60)


@pytest.mark.parametrize("share", [-0.9, -0.5, 0.0, 0.3, 0.95])
@pytest.mark.parametrize("most", [0, 20, 45])
def test_the_position_of_a_hit_turns_a_radial_shot(share, most):
    """By the level's number times the offset, to the side that was hit; under the source's rules it flies straight back."""
    level = parse(changed("acceleration = 400.0", f"acceleration = 400.0\nturn = {most}"), "x")
    for game, expected in ((arcade(level), -share * math.radians(most)), (new_game((level,), 1, SOURCE_RULES), 0.0)):
        bearing = paddle_ring(game).angle(0) + share * paddle_ring(game).half_angle
        ball = radial_shot(game, share).game.arena.balls[0]
        assert leaning(ball.velocity, bearing + math.pi) == pytest.approx(expected, abs=1e-9)


def test_a_hit_on_the_right_half_goes_to_the_right():
    """At the lowest paddle, a ball from the centre that meets it right of its middle passes the centre at the right."""
    game = arcade()
    assert math.degrees(paddle_ring(game).angle(0)) == pytest.approx(270.0)
    ball = radial_shot(game, 0.5).game.arena.balls[0]
    assert ball.position.real > 0.0
    nearest = ball.position - ball.velocity * (dot(ball.position, ball.velocity) / dot(ball.velocity, ball.velocity))
    assert nearest.real > 1.0


@given(st.floats(-1.5, 1.5), st.floats(-1.2, 1.2), st.floats(0.0, 6.28))
def test_no_turn_leads_back_into_the_paddle(leans, turn, bearing):
    """A ball that leaves inward still does, its speed kept, turned by no more than was asked for."""
    inward = direction(bearing)
    before = direction(bearing + leans) * 7.0
    now = turned(before, inward, turn, 7.0)
    assert length(now) == pytest.approx(7.0, rel=1e-14)
    assert dot(now, inward) > 0.0
    lean = signed_difference(angle_of(now), angle_of(inward))
    assert abs(lean) <= max(MOST_LEANING, abs(leans)) + 1e-9
    assert abs(lean - leans) <= abs(turn) + 1e-9


def test_an_end_of_a_paddle_turns_nothing():
    """A ball that meets the straight side of a paddle bounces by the source's response alone."""
    game = arcade()
    paddles = paddle_ring(game)
    beside = direction(paddles.angle(0) + paddles.half_angle + 0.12) * 9.0
    done = until(with_balls(game, (beside, beside * -1j)), EventKind.PADDLE_HIT, 60)
    assert done.game.arena.balls[0].velocity == done.step.arena.balls[0].velocity


def test_a_sticky_paddle_holds_a_ball_until_a_serve():
    """It goes where the paddle goes; a serve lets it go, turned by where it stuck."""
    game = arcade()._replace(powers=(STICKY,))
    done = radial_shot(game, 0.5)
    assert kinds(done.events) == [EventKind.PADDLE_HIT, EventKind.BALL_CAUGHT]
    game = done.game
    assert (len(game.held), game.arena.balls, game.phase) == (1, (), Phase.PLAYING)
    game, _ = after(game, 100, Controls(turn=1))
    assert game.held[0].offset == pytest.approx(0.5 * paddle_ring(game).half_angle, rel=1e-9)
    game, events = after(game, 1, SERVE)
    assert kinds(events) == [EventKind.BALL_RELEASED]
    bearing = angle_of(game.arena.balls[0].position)
    assert leaning(game.arena.balls[0].velocity, bearing + math.pi) == pytest.approx(-0.5 * math.radians(25.0), abs=1e-9)


def test_a_sticky_paddle_lets_go_by_itself():
    """After two seconds, at the balls' speed."""
    game = radial_shot(arcade()._replace(powers=(STICKY,)), 0.2).game
    game, events = after(game, 479)
    assert game.held
    game, events = after(game, 2)
    assert kinds(events) == [EventKind.BALL_RELEASED]
    assert length(game.arena.balls[0].velocity) == pytest.approx(game.speed)


def test_a_ball_that_sticks_is_in_play():
    """While there is one, a ball that is lost costs no life; who gives up loses it, too."""
    game = radial_shot(arcade()._replace(powers=(STICKY,)), 0.0).game
    outward = direction(math.radians(30.0))
    game, events = after(with_balls(game, (outward * 10.3, outward)), 1)
    assert (kinds(events), game.lives, game.phase) == ([EventKind.BALL_LOST], 3, Phase.PLAYING)
    game, events = after(game, 1, Controls(give_up=True))
    assert (kinds(events), game.lives, game.phase, game.held) == ([EventKind.BALL_LOST], 2, Phase.SERVING, ())


def test_a_ball_that_sticks_is_aimed():
    """A serve with an aim sends it there."""
    game = radial_shot(arcade()._replace(powers=(STICKY,)), 0.0).game
    game, _ = after(game, 1, Controls(serve=True, aim=int(0.3 * POINTER_STEPS)))
    assert angle_of(game.arena.balls[0].velocity) == pytest.approx(int(0.3 * POINTER_STEPS) / POINTER_STEPS * math.tau)


def one_brick_left(game, bearing):
    """The game with one brick, at about a bearing, and the angle of its middle."""
    slot = round(math.degrees(bearing) / 30.0) % 12
    layers = tuple([int(k == slot) for k in range(12)])
    game = game._replace(arena=game.arena._replace(layers=(game.arena.layers[0], layers, game.arena.layers[2])))
    return game, game.arena.rings[1].angle(slot)


def test_after_a_long_wait_a_hit_aims_at_the_brick():
    """Within its bound, and only then; the ball meets the brick without another bounce."""
    level = parse(changed("acceleration = 400.0", "acceleration = 400.0\nturn = 0"), "x")
    game, _ = one_brick_left(arcade(level), math.radians(210.0))
    waiting = radial_shot(game, 0.0)
    assert EventKind.AIMED not in kinds(waiting.events)
    done = radial_shot(game._replace(waited=CLOSING_TICKS + 100), 0.0)
    assert EventKind.AIMED in kinds(done.events)
    _, events = after(done.game, 240)
    assert kinds(events)[0] == EventKind.BRICK_HIT


def test_a_brick_ends_the_wait():
    """The help begins anew, some seconds after it."""
    game = with_balls(arcade()._replace(waited=1000), (5.0 + 0j, -1.0))
    done = until(game, EventKind.BRICK_HIT, 60)
    assert done.game.waited == 0
    assert after(done.game, 1)[0].waited == 1


def test_the_help_is_bounded():
    """A brick that needs a larger turn than the wait allows is not aimed at; no turn exceeds 60 degrees."""
    level = parse(changed("acceleration = 400.0", "acceleration = 400.0\nturn = 0"), "x")
    game, _ = one_brick_left(arcade(level), math.radians(180.0))
    for waited in (CLOSING_TICKS, CLOSING_TICKS + 400, CLOSING_TICKS + 1000):
        done = radial_shot(game._replace(waited=waited), 0.0)
        lean = abs(leaning(done.game.arena.balls[0].velocity, paddle_ring(game).angle(0) + math.pi))
        bound = math.radians(min(15.0 + 15.0 * (done.game.waited - CLOSING_TICKS) / 240.0, 60.0))
        assert lean <= bound + 1e-9


def test_no_help_is_given_where_a_brick_is_met_anyway():
    """The wall stands before the ball: its flight is left alone."""
    for share in (0.0, 0.3, -0.4):
        assert EventKind.AIMED not in kinds(radial_shot(arcade()._replace(waited=CLOSING_TICKS + 1000), share).events)


def test_a_brick_behind_steel_is_not_aimed_at():
    """The ball would meet the steel; one beside it, which takes a larger turn, is aimed at instead."""
    level = parse(changed("acceleration = 400.0", "acceleration = 400.0\nturn = 0"), "x")
    game = arcade(level)._replace(waited=CLOSING_TICKS + 1000)
    for open_slots, aimed in (((), False), ((11,), True)):
        slots = [-1 if slot == 9 else int(slot == 4 or slot in open_slots) for slot in range(12)]
        layers = (game.arena.layers[0], tuple(slots), game.arena.layers[2])
        done = radial_shot(game._replace(arena=game.arena._replace(layers=layers)), 0.0)
        assert (EventKind.AIMED in kinds(done.events)) is aimed
        if aimed:
            (hit,) = [event.hit for event in until(done.game, EventKind.BRICK_HIT, 300).events]
            assert hit.slot == 11


def test_the_last_bounce_of_a_tick_decides():
    """A ball that met a paddle and then something else in the same tick is not turned."""
    game = arcade()
    done = radial_shot(game, 0.5)
    (hit,) = done.step.hits
    flown = game._replace(arena=done.step.arena)
    assert hit.ring == PADDLES
    assert paddle_hits_answered(flown, done.moving, done.step, []) != flown
    later = done.step._replace(hits=(hit, hit._replace(ring=1, layers=0)))
    assert paddle_hits_answered(flown, done.moving, later, []) is flown


def test_a_serve_goes_where_the_player_aims():
    """As far as 55 degrees off the centre; the arrow follows at once, and without an aim it swings."""
    game = arcade()
    straight = paddle_ring(game).angle(0) + math.pi
    for off, expected in ((0.3, 0.3), (-0.8, -0.8), (1.5, math.radians(55.0)), (-3.0, -math.radians(55.0))):
        aim = round(normalize_angle(straight + off) / math.tau * POINTER_STEPS)
        aimed = tick(game, Controls(aim=aim)).game
        assert leaning(aimed.arena.balls[0].velocity, straight) == pytest.approx(expected, abs=2e-4)
        served = tick(game, Controls(aim=aim, serve=True)).game
        assert leaning(served.arena.balls[0].velocity, straight) == pytest.approx(expected, abs=2e-4)
    swinging = [tick(game._replace(phase_tick=at), IDLE).game.arena.balls[0].velocity for at in (0, 60)]
    assert swinging[0] != swinging[1]


def test_the_seed_decides_where_the_aim_begins():
    """So the same seconds of waiting are another serve in another game."""
    starts = {arcade(seed=seed).aim_start for seed in range(20)}
    assert len(starts) > 10
    assert arcade(seed=3).aim_start == arcade(seed=3).aim_start


def test_a_second_player_steers_when_the_first_does_not():
    """Keys go before pointers, and the first player before the second."""
    game = arcade()
    for controls, sign in (
        (Controls(second_turn=1), 1),
        (Controls(turn=-1, second_turn=1), -1),
        (Controls(pointer=0, second_turn=1), 1),
        (Controls(second_pointer=int(0.8 * POINTER_STEPS)), 1),
        (Controls(pointer=int(0.7 * POINTER_STEPS), second_pointer=int(0.8 * POINTER_STEPS)), -1),
    ):
        spin = paddle_ring(after(game, 5, controls)[0]).spin
        assert spin * sign > 0.0, controls


def test_the_help_grows_to_sixty_degrees():
    """From 15, by 15 a second, after three and a half seconds without a brick."""
    for seconds, degrees in ((3.4, 0.0), (3.5, 15.0), (4.5, 30.0), (6.5, 60.0), (1000.0, 60.0)):
        assert math.degrees(closing_limit(arcade()._replace(waited=round(seconds * 240)))) == pytest.approx(degrees)
