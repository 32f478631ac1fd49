"""What the arcade rules make of a paddle's hit: the ball is turned by where it met the paddle, or sticks to it.

The source's response stays the physics. After it, at the end of the tick, the ball's velocity is turned by at most the level's
`paddles.turn`: towards the side of the paddle that was hit, most at its end. A ball never turns back into the paddle.
"""

import math

from game.rules.closing import closing_turn
from game.rules.power_up import PowerUp
from game.rules.state import PADDLES, Event, EventKind, Game, HeldBall, held_balls, paddle_rings
from physics import Arena, Ball, Feature, Hit, Step, angle_of, direction, normalize_angle, signed_difference

MOST_LEANING = math.radians(75.0)
"""Radians from the straight line to the centre that no turn exceeds; a flatter bounce stays as it is."""
_LONGEST_HOLD = 480
"""Ticks after which a paddle lets go of a ball by itself."""


def paddle_hits_answered(game: Game, moving: Arena, step: Step, events: list[Event]) -> Game:
    """The game after balls whose last bounce of the tick was off a paddle's inner face are turned, or held by it."""
    last: dict[int, Hit] = {}
    for hit in step.hits:
        last[hit.ball] = hit
    paddles = paddle_rings(game)
    sticky = [game.power(PowerUp.STICKY, player) is not None for player in range(len(paddles))]
    balls: list[Ball] = []
    held: list[HeldBall] = []
    changed = False
    for index, ball in enumerate(game.arena.balls):
        found = last.get(index)
        if found is None or found.ring not in paddles or found.contact.feature != Feature.INNER_FACE:
            balls.append(ball)
            continue
        changed = True
        if sticky[paddles.index(found.ring)]:
            held.append(HeldBall(found.slot, hit_offset(found, moving), ball.radius, 0, found.ring))
            events.append(Event(EventKind.BALL_CAUGHT, found, position=found.contact.point))
        else:
            balls.append(_returned(game, ball, found, moving, events))
    if not changed:
        return game
    return game._replace(arena=game.arena._replace(balls=tuple(balls)), held=(*game.held, *held))


def hit_offset(hit: Hit, moving: Arena) -> float:
    """How far from the middle of its paddle a hit is, radians, counter-clockwise. moving: the arena at the tick's start."""
    paddles = moving.rings[hit.ring].turned(hit.time)
    return signed_difference(angle_of(hit.contact.point), paddles.angle(hit.slot))


def most_turn(game: Game) -> float:
    """The most that the position of a hit turns a ball, radians: the level's number times the difficulty's."""
    return math.radians(game.level.paddles.turn) * game.ruleset.handicap.turn


def turned(velocity: complex, inward: complex, turn: float, speed: float) -> complex:
    """A velocity turned counter-clockwise by an angle, but no further from the inward normal than MOST_LEANING.

    inward: unit. turn: radians. A velocity that leans further already keeps its angle at most. The result has the speed given.
    """
    normal = angle_of(inward)
    leaning = signed_difference(angle_of(velocity), normal)
    most = max(MOST_LEANING, abs(leaning))
    return direction(normal + min(max(leaning + turn, -most), most)) * speed


def place_turn(game: Game, offset: float, ring: int = PADDLES) -> float:
    """Radians by which a hit at an offset from the middle of a ring's paddle turns a ball that flies inward, counter-clockwise.

    A ball that meets the counter-clockwise half leaves further to that side; seen along its flight, which is inward, that is
    clockwise.
    """
    share = min(max(offset / game.arena.rings[ring].half_angle, -1.0), 1.0)
    return -share * most_turn(game)


def _returned(game: Game, ball: Ball, hit: Hit, moving: Arena, events: list[Event]) -> Ball:
    """A ball after its bounce off a paddle, turned by the position of the hit, and helped after a long wait."""
    inward = hit.contact.normal
    velocity = turned(ball.velocity, inward, place_turn(game, hit_offset(hit, moving), hit.ring), game.speed)
    return _helped(game, Ball(ball.position, velocity, ball.radius), inward, events, hit)


def _helped(game: Game, ball: Ball, inward: complex, events: list[Event], hit: Hit | None = None) -> Ball:
    """A ball that leaves a paddle, turned towards a brick after a long wait. hit: with which it came, if it did not stick."""
    closing = closing_turn(game, ball, inward)
    if closing == 0.0:
        return ball
    events.append(Event(EventKind.AIMED, hit, position=ball.position))
    return Ball(ball.position, turned(ball.velocity, inward, closing, game.speed), ball.radius)


def released(game: Game, events: list[Event], *, serve: bool, aim: float | None) -> Game:
    """The game after paddles have let go of balls: all of them at a serve, and each that they have held for long enough.

    A ball leaves straight inward, turned by where it sticks, or along the aim, radians, if there is one.
    """
    if not game.held:
        return game
    held: list[HeldBall] = []
    balls = list(game.arena.balls)
    for stuck, ball in zip(game.held, held_balls(game), strict=True):
        if not serve and stuck.ticks < _LONGEST_HOLD:
            held.append(stuck._replace(ticks=stuck.ticks + 1))
            continue
        inward = direction(angle_of(ball.position) + math.pi)
        if serve and aim is not None:
            turn = signed_difference(normalize_angle(aim), angle_of(inward))
            balls.append(Ball(ball.position, turned(inward, inward, turn, game.speed), ball.radius))
        else:
            velocity = turned(inward, inward, place_turn(game, stuck.offset, stuck.ring), game.speed)
            balls.append(_helped(game, Ball(ball.position, velocity, ball.radius), inward, events))
        events.append(Event(EventKind.BALL_RELEASED, position=ball.position))
    return game._replace(held=tuple(held), arena=game.arena._replace(balls=tuple(balls)))
