"""Two players against each other on the screen: whose paddle, whose corner, whose serve."""

import pygame
import pytest

from game.drawing.camera import Camera, layout, unit_of
from game.drawing.canvas import Canvas
from game.drawing.palette import DARK
from game.drawing.text import Type
from game.effects import NOTHING
from game.overlay import hud
from game.overlay.notice_words import notice, who_steers
from game.overlay.readings import readings
from game.picture.slots.contents import ContentKind, slot_contents
from game.rules import ActivePower, Controls, EventKind, PowerUp, Ruleset, Side, paddle_rings, tick
from game.scene import scene_at, still
from physics import direction
from tests.support.games.arcade import after, arcade, kinds, with_balls

GAME = arcade(ruleset=Ruleset(versus=True))
SIZE = (800, 600)


def changed_box(first, second, size):
    """What the figures of two games differ in on the screen."""
    shots = []
    for game in (first, second):
        surface = pygame.Surface(size, 0, 32)
        hud.draw(Canvas(surface, Camera(0j, 1.0), DARK, Type(), unit_of(size)), readings(game), layout(size, 10.0))
        shots.append(surface)
    mask = pygame.mask.from_threshold(shots[0], (0, 0, 0), (1, 1, 1), shots[1])
    mask.invert()
    boxes = mask.get_bounding_rects()
    return boxes[0].unionall(boxes[1:])


@pytest.mark.parametrize("size", [SIZE, (700, 900)])
def test_each_player_has_the_corner_of_the_own_half(size):
    """Points, lives and who is ahead of the second player are in the upper left quarter, of the first in the lower left one."""
    pygame.font.init()
    for player, half in enumerate(
        (pygame.Rect(0, size[1] // 2, size[0] // 2, size[1] // 2), pygame.Rect(0, 0, size[0] // 2, size[1] // 2))
    ):
        sides = tuple([side._replace(score=9999, lives=1) if k == player else side for k, side in enumerate(GAME.sides)])
        assert half.contains(changed_box(GAME, GAME._replace(sides=sides), size))
    ahead = readings(GAME._replace(sides=(Side(10, 3), Side(20, 3)))).players
    assert [player.leads for player in ahead] == [False, True]


def test_glue_is_seen_on_the_paddle_that_has_it():
    """The second paddle has a look of its own, with and without."""
    game = GAME._replace(powers=(ActivePower(PowerUp.STICKY, 9, 9, 1),))
    seen = [slot_contents(scene_at(still(one), 1.0, NOTHING)) for one in (GAME, game)]
    kinds_of = [[contents[k][0].kind for k in paddle_rings(GAME)] for contents in seen]
    assert kinds_of == [
        [ContentKind.PADDLE, ContentKind.SECOND_PADDLE],
        [ContentKind.PADDLE, ContentKind.STICKY_SECOND_PADDLE],
    ]


def test_the_ball_of_the_second_player_stays_on_the_paddle_that_serves():
    """Between two ticks it turns with that paddle, not with the other one; the notice says who serves."""
    upwards = direction(1.0)
    game, events = after(with_balls(GAME, (upwards * 10.3, upwards)), 1)
    assert EventKind.BALL_LOST in kinds(events)
    assert notice(game, "Space").title == "Player 2 serves"
    game, _ = after(game, 30, Controls(second_turn=1))
    done = tick(game, Controls(second_turn=1))
    before, half = scene_at(still(game), 0.0, NOTHING), scene_at(done, 0.5, NOTHING)
    paddle = paddle_rings(GAME)[1]
    turned = half.rings[paddle].phase - before.rings[paddle].phase
    assert turned > 1e-4
    assert half.balls[0].position == pytest.approx(before.balls[0].position * direction(turned), abs=1e-9)


def test_before_the_first_serve_both_are_told_their_keys():
    """And not again later."""
    told = who_steers(GAME, "Left, Right", "A, D", "Space")
    assert told.hint == "Player 1: Left, Right. Player 2: A, D. Space: serve"
    played, _ = after(GAME, 1, Controls(serve=True))
    upwards = direction(1.0)
    second, _ = after(with_balls(played, (upwards * 10.3, upwards)), 1)
    assert [who_steers(game, "", "", "") for game in (played, second)] == [None, None]
