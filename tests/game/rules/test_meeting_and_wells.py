"""Balls that meet, and gravity wells: velocities turn, speeds stay."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.levels import parse
from game.rules import SOURCE_RULES, EventKind, new_game
from game.rules.meeting import met
from game.system.errors import BadInputError
from physics import collision_response, cross, direction, dot, length
from physics.vectors import unit
from tests.support.games.arcade import GOOD, after, arcade, kinds, with_balls

WELL = b"[[wells]]\ndistance = 6.0\nangle = 90.0\nstrength = 40.0\nreach = 2.5\n"


@given(st.floats(0.0, 6.28), st.floats(0.0, 6.28), st.floats(0.0, 6.28), st.floats(0.01, 0.49))
def test_two_balls_that_meet_separate(one, other, line, apart):
    """Each by the source's response to the other as a moving surface, both at the game's speed; exchanged, they do the same."""
    game = arcade()
    position = 6.0j
    flights = (position, direction(one)), (position + direction(line) * apart, direction(other))
    start = with_balls(game, *flights)
    a, b = start.arena.balls
    normal = unit(a.position - b.position)
    events = []
    after_meeting = met(start, events)
    if dot(a.velocity - b.velocity, normal) >= -1e-9:
        return
    c, d = after_meeting.arena.balls
    assert kinds(events) == [EventKind.BALLS_MET]
    assert length(c.velocity - collision_response(a.velocity, normal, b.velocity, 0.0, game.speed)) < 1e-9
    assert dot(c.velocity - d.velocity, normal) > 0.0
    assert [length(ball.velocity) for ball in (c, d)] == [pytest.approx(game.speed, rel=1e-14)] * 2
    assert (c.position, d.position) == (a.position, b.position)
    exchanged = met(with_balls(game, *reversed(flights)), [])
    assert length(exchanged.arena.balls[1].velocity - c.velocity) < 1e-12
    assert met(after_meeting, []) is after_meeting


def test_balls_apart_or_at_one_position_do_not_meet():
    """Two that were one a tick ago are at one position: they are let go."""
    game = arcade()
    for flights in (((6j, 1.0), (6j + 0.51, -1.0)), ((6j, 1.0), (6j, -1.0))):
        start = with_balls(game, *flights)
        assert met(start, []) is start


def test_head_on_both_go_back():
    """In the middle of a flight: the event is where they touch."""
    game, events = after(with_balls(arcade(), (6j - 1.0, 1.0), (6j + 1.0, -1.0)), 30)
    (event,) = [event for event in events if event.kind == EventKind.BALLS_MET]
    assert length(event.position - 6j) < 0.1
    assert [ball.velocity.real < 0.0 for ball in game.arena.balls] == [True, False]


def passed(well, start, heading, ticks=110):
    """A ball's velocity after it has passed a level's well, and before."""
    game = with_balls(arcade(parse(GOOD + well, "x")), (start, heading))
    before = game.arena.balls[0].velocity
    game, events = after(game, ticks)
    assert events == []
    assert length(game.arena.balls[0].velocity) == pytest.approx(game.speed, rel=1e-14)
    return before, game.arena.balls[0].velocity


def test_a_well_turns_a_ball_towards_itself():
    """And one with a strength below 0 away; out of reach the flight stays straight, in every bit."""
    before, now = passed(WELL, -3.0 + 5.0j, 1.0)
    assert cross(before, now) > 1.0  # the well is at its left
    before, now = passed(WELL.replace(b"40.0", b"-40.0"), -3.0 + 5.0j, 1.0)
    assert cross(before, now) < -1.0
    before, now = passed(WELL, -3.0 - 5.0j, 1.0)
    assert before == now


def test_the_sources_rules_know_no_well():
    """Nor bumpers, nor rings that grow again or reverse: the flight is the physics' alone."""
    game = with_balls(new_game((parse(GOOD + WELL, "x"),), 1, SOURCE_RULES), (-3.0 + 5.0j, 1.0))
    velocity = game.arena.balls[0].velocity
    game, _ = after(game, 110)
    assert game.arena.balls[0].velocity == velocity


@given(st.floats(0.0, 6.28), st.floats(0.01, 0.99), st.floats(0.0, 6.28))
def test_no_well_keeps_a_ball(bearing, share, heading):
    """The strongest that the format allows lets every ball out again: its distance has one minimum, and then it grows."""
    strength, reach = 4.0 * 0.949 * (0.64 * 9.0) ** 2 / 2.0, 2.0
    well = f"[[wells]]\ndistance = 6.0\nangle = 90.0\nstrength = {strength}\nreach = {reach}\n".encode()
    game = arcade(parse(GOOD + well, "x"))._replace(speed=0.64 * 9.0)
    position, velocity = direction(bearing) * (share * reach), direction(heading) * game.speed
    growing = False
    for _ in range(1500):
        pull = strength * (1.0 - length(position) / reach)
        velocity = velocity - position * (pull / 240.0 / length(position))
        velocity = velocity * (game.speed / length(velocity))
        further = length(position + velocity / 240.0) > length(position)
        assert further or not growing or length(position) < 0.2
        growing = further
        position += velocity / 240.0
        if length(position) >= reach:
            return
    raise AssertionError("the ball stays")


def test_a_well_that_could_keep_a_ball_is_refused():
    """And one beside the ground, by key and rule."""
    for changed, rule in (
        (WELL.replace(b"40.0", b"80.0"), r"wells\[0\].strength: could hold"),
        (WELL.replace(b"6.0", b"11.0"), r"wells\[0\].distance"),
    ):
        with pytest.raises(BadInputError, match=rule):
            parse(GOOD + changed, "x")
    assert math.isclose(40.0, parse(GOOD + WELL, "x").wells[0].strength)
