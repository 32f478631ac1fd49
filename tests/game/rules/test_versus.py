"""Two players against each other: halves, points, lives, serves."""

import math

import msgspec
import pytest

from game.autopilot import Autopilot
from game.replays.file import Recorder, decoded, encoded
from game.replays.verify import verified
from game.rules import (
    PADDLES,
    ActivePower,
    Controls,
    Difficulty,
    Drop,
    EventKind,
    Phase,
    PowerUp,
    Ruleset,
    Side,
    new_game,
    shield_layers,
    tick,
    winner,
)
from game.rules.state import paddle_rings
from game.system.errors import BadInputError
from physics import direction, length, signed_difference
from tests.game.rules.test_invariants import in_material
from tests.support.games.arcade import EVERYTHING, LEVEL, SERVE, after, arcade, kinds, with_balls

VERSUS = Ruleset(versus=True)
UPPER, LOWER = 0.5 * math.pi, 1.5 * math.pi


def paddles(game):
    """Both players' paddles."""
    return [game.arena.rings[k] for k in paddle_rings(game)]


def versus(**other):
    """A game of two players at the test's level."""
    return arcade(ruleset=VERSUS, **other)


def test_each_player_steers_one_paddle_in_one_half():
    """By keys and by pointer, up to the border, where it stops; the two never meet."""
    game = versus()
    assert [ring.count for ring in paddles(game)] == [1, 1]
    for controls in (
        Controls(turn=1, second_turn=1),
        Controls(turn=-1, second_turn=-1),
        Controls(pointer=0, second_pointer=32768),
    ):
        later, _ = after(game, 700, controls)
        for ring, middle in zip(paddles(later), (LOWER, UPPER), strict=True):
            reach = abs(signed_difference(ring.phase, middle)) + ring.half_angle
            assert math.pi / 2.0 - 1e-3 < reach < math.pi / 2.0
            assert ring.spin == pytest.approx(0.0, abs=1e-6)
    alone, _ = after(game, 60, Controls(turn=1))
    assert paddles(alone)[1].phase == paddles(game)[1].phase


def test_a_lost_ball_is_the_players_whose_half_it_leaves():
    """It costs that player a life, gives the other a hundred points, and the one who lost it serves."""
    game = versus()
    for angle, loser in ((1.0, 1), (-1.0, 0), (2.0, 1)):
        outward = direction(angle)
        before = game.sides
        game, events = after(with_balls(game, (outward * 10.3, outward)), 1)
        assert EventKind.BALL_LOST in kinds(events)
        assert game.sides[loser] == before[loser]._replace(lives=before[loser].lives - 1)
        assert game.sides[1 - loser] == before[1 - loser]._replace(score=before[1 - loser].score + 100)
        assert (game.phase, game.server) == (Phase.SERVING, loser)
        served = tick(game, SERVE).game
        assert (served.arena.balls[0].position.imag > 0.0) is (loser == 1)
    outward = direction(1.0)
    game, events = after(with_balls(game, (outward * 10.3, outward)), 1)
    assert EventKind.GAME_OVER in kinds(events)
    assert (game.phase, game.lives, winner(game)) == (Phase.OVER, 0, 0)


def test_points_are_the_players_who_hit_the_ball_last():
    """Bricks, bumpers and caught drops; the sum of both is the game's score."""
    game, player = new_game((EVERYTHING,) * 2, 7, VERSUS), Autopilot()
    for _ in range(3000):
        done = tick(game, player.controls(game))
        game = done.game
        assert sum(side.score for side in game.sides) == game.score
        assert min(side.lives for side in game.sides) == game.lives
        if game.phase == Phase.PLAYING:
            assert in_material(game) == []
    assert min(side.score for side in game.sides) > 0
    brick = with_balls(versus()._replace(last_player=1), (5.0 + 0j, -1.0))
    assert after(brick, 60)[0].sides == (Side(0, 3), Side(10, 3))


def test_a_paddle_grows_only_within_its_half():
    """At the border it waits until its player moves it away."""
    game, _ = after(versus(), 700, Controls(turn=1))
    both = tuple([ActivePower(PowerUp.WIDE, 900, 900, player) for player in range(2)])
    game = with_balls(game._replace(powers=both), (0.5j, 1.0))
    game, _ = after(game, 1)
    narrow, wide = [ring.half_angle for ring in paddles(game)]
    assert wide == pytest.approx(1.4 * narrow)
    game, _ = after(with_balls(game, (0.5j, 1.0)), 100, Controls(turn=-1))
    assert paddles(game)[PADDLES].half_angle == wide


@pytest.mark.parametrize(("position", "player"), [(8.8j, 1), (-8.8j, 0)])
def test_a_drop_acts_on_the_paddle_that_caught_it(position, player):
    """Its width and its glue are that player's alone; the opposite ends that player's power-up only; balls are everybody's."""
    game, others = versus(), tuple([ActivePower(PowerUp.NARROW, 900, 900, number) for number in range(2)])
    for kind, powers, left in (
        (PowerUp.WIDE, others, {(PowerUp.NARROW, 1 - player)}),
        (PowerUp.STICKY, others[:1], {(PowerUp.NARROW, 0), (PowerUp.STICKY, player)}),
        (PowerUp.SLOW, (), {(PowerUp.SLOW, 0)}),
    ):
        caught, _ = after(with_balls(game._replace(powers=powers, drops=(Drop(kind, position, position / 8),)), (0.5j, 1.0)), 1)
        assert {(power.kind, power.player) for power in caught.powers} == left
    wide, _ = after(with_balls(game._replace(drops=(Drop(PowerUp.WIDE, position, position / 8),)), (0.5j, 1.0)), 1)
    grown = [new.half_angle > old.half_angle for new, old in zip(paddles(wide), paddles(game), strict=True)]
    assert grown == [player == 0, player == 1]


@pytest.mark.parametrize("player", [0, 1])
def test_a_shield_guards_the_half_of_its_player(player):
    """It returns a ball there, once; in the other half balls leave. On easy both begin with one."""
    game = versus()._replace(powers=(ActivePower(PowerUp.SHIELD, 0, 0, player),))
    own, other = (direction(angle) for angle in ((-1.0, 1.0), (1.0, -1.0))[player])
    game, _ = after(with_balls(game, (0.5j, 1.0)), 1)
    assert [shield_layers(game, number) for number in range(2)] == [player == 0, player == 1]
    _, events = after(with_balls(game, (other * 9.3, other)), 60)
    assert EventKind.BALL_LOST in kinds(events)
    returned, events = after(with_balls(game, (own * 9.3, own)), 20)
    assert kinds(events) == [EventKind.SHIELD_HIT, EventKind.POWER_ENDED]
    assert (returned.powers, shield_layers(returned, player)) == ((), 0)
    easy = new_game((LEVEL,), 1, VERSUS._replace(difficulty=Difficulty.EASY))
    assert easy.arena.layers[-1] == (1, 1)


def test_a_ball_sticks_to_either_paddle():
    """And goes where that paddle goes."""
    sticky = tuple([ActivePower(PowerUp.STICKY, 900, 900, player) for player in range(2)])
    game = with_balls(versus()._replace(powers=sticky), (8.0j, 1j), (-8.0j, -1j))
    game, _ = after(game, 40)
    assert sorted(ball.ring for ball in game.held) == sorted(paddle_rings(game))
    game, _ = after(game, 30, Controls(second_turn=1))
    game, events = after(game, 1, SERVE)
    assert kinds(events) == [EventKind.BALL_RELEASED] * 2
    assert min([length(ball.position + 8.55j) for ball in game.arena.balls]) < 0.1


def test_a_game_of_two_is_recorded():
    """With the second player's controls."""
    game, player, recorder = new_game((LEVEL,), 2, VERSUS), Autopilot(), Recorder((LEVEL,), 2, VERSUS)
    for _ in range(1200):
        controls = player.controls(game)
        game = tick(game, controls).game
        recorder.add(controls, game)
    recording = decoded(encoded(recorder.recording()), "x")
    assert recording.ruleset == VERSUS
    assert verified(recording) == (game, None)


def test_the_sources_rules_have_one_player():
    """Two are refused, in a game and in a recording."""
    wrong = Ruleset(arcade=False, versus=True)
    with pytest.raises(ValueError, match="arcade"):
        new_game((LEVEL,), 1, wrong)
    recording = Recorder((LEVEL,), 1).recording()
    with pytest.raises(BadInputError, match="ruleset: two players"):
        decoded(encoded(msgspec.structs.replace(recording, ruleset=wrong)), "x")


def test_who_wins():
    """Who has lives left, then who has more points; nobody where both have as many, or where one plays alone."""
    game = versus()
    for sides, expected in (
        ((Side(0, 0), Side(50, 1)), 1),
        ((Side(90, 1), Side(50, 3)), 0),
        ((Side(50, 1), Side(50, 3)), None),
    ):
        assert winner(game._replace(sides=sides)) == expected
    assert winner(arcade()) is None
