"""The autopilot of games under the source's rules: one ball, steered by the motion of the paddle that returns it."""

import math
from typing import NamedTuple

from game.autopilot.prediction import LOOK, crossing, pointer_to, without_paddles
from game.rules import TICK, Controls, Game, Phase, paddle_ring
from game.rules.state import PLAYING
from physics import Arena, Ball, angle_of, collision_response, direction, length, normalize_angle, signed_difference

_CUT_TIME = 0.35
"""Seconds of steady paddle motion before a hit, so that its friction turns the ball."""
_CUTS = (0.0, 0.9, -0.9, 0.5, -0.5)
"""Paddle motions to choose from, as fractions of the top speed."""
SERVE_WAIT = 30
_SERVE_SPREAD = 450
_COVER = 0.7
"""Fraction of a paddle's half angle within which a hit counts as safe."""


class _Plan(NamedTuple):
    """Where and when the ball meets the paddles' track, and how the paddle shall move then."""

    tick: int
    bearing: float
    spin: float


class SourcePilot:
    """Predicts where the ball crosses the paddles' track, and meets it there with the motion that breaks most bricks next.

    Keeps its plan until the ball's velocity changes; the same game seen from its start gets the same controls.
    """

    def __init__(self) -> None:
        """Start without a plan."""
        self._velocity: complex | None = None
        self._plan: _Plan | None = None
        self._angle = math.nan
        self._controls = Controls()

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.phase is not PLAYING:
            self._velocity = None
            return Controls(serve=game.phase != Phase.SERVING or game.phase_tick >= SERVE_WAIT + serve_delay(game))
        balls = game.arena.balls
        ball = balls[0] if len(balls) == 1 else _outermost(balls)
        if ball.velocity != self._velocity:
            self._velocity = ball.velocity
            self._plan = _plan(game, ball)
        plan = self._plan
        if plan is None:
            return Controls()
        angle = plan.bearing
        if plan.spin != 0.0:
            angle -= plan.spin * min(max(0.0, (plan.tick - game.tick) * TICK), _CUT_TIME)
        if angle != self._angle:
            self._angle, self._controls = angle, Controls(pointer=pointer_to(angle))
        return self._controls


def serve_delay(game: Game) -> int:
    """Ticks to wait before a serve: differs from seed to seed and serve to serve."""
    return (game.seed * 97 + game.lives * 41 + game.number * 23 + game.score) % _SERVE_SPREAD


def _outermost(balls: tuple[Ball, ...]) -> Ball:
    """The ball nearest to the rim."""
    return max(balls, key=lambda ball: length(ball.position))


def _plan(game: Game, ball: Ball) -> _Plan | None:
    """How to meet the ball when it next comes to the paddles' track; None if it does not within the horizon."""
    paddles = paddle_ring(game)
    track = paddles.inner_radius - ball.radius
    found = crossing(without_paddles(game.arena, ball), track, game.speed)
    if found is None:
        return None
    time, arena, broken = found
    arrived = arena.balls[0]
    bearing = angle_of(arrived.position)
    meeting = game.tick + int(time / TICK)
    if broken:
        return _Plan(meeting, bearing, 0.0)  # the ball turns before it comes; there will be a better plan then
    top = math.radians(game.level.paddles.top_speed)
    spins = [cut * top for cut in _CUTS if _reachable(game, bearing, cut * top, top, time)]
    if not spins:
        return _Plan(meeting, bearing, 0.0)
    return _Plan(meeting, bearing, max(spins, key=lambda spin: _worth(game, arena, spin, top)))


def _reachable(game: Game, bearing: float, spin: float, top: float, time: float) -> bool:
    """Whether a paddle can be where its steady motion towards the bearing has to start."""
    paddles = paddle_ring(game)
    lead = min(time, _CUT_TIME)
    start = normalize_angle(bearing - spin * lead)
    away = min([abs(signed_difference(start, paddles.angle(slot))) for slot in range(paddles.count)])
    slack = _COVER * paddles.half_angle if spin == 0.0 else 0.0
    return away <= top * (time - lead) + slack


def _worth(game: Game, arena: Arena, spin: float, top: float) -> float:
    """How good a return is: bricks it breaks, less what the next catch asks of the paddles beyond their reach."""
    speed = game.speed
    paddles = paddle_ring(game)
    ball = arena.balls[0]
    normal = direction(angle_of(ball.position) + math.pi)
    surface = paddles.steered(spin).surface_velocity(ball.position)
    velocity = collision_response(ball.velocity, normal, surface, paddles.friction, speed)
    inside = Ball(ball.position + normal * (LOOK * speed * 0.01), velocity, ball.radius)
    track = paddles.inner_radius - ball.radius
    returned = crossing(arena._replace(balls=(inside,)), track, speed)
    if returned is None:
        return 0.0
    time, later, broken = returned
    turn = abs(signed_difference(angle_of(later.balls[0].position), angle_of(ball.position)))
    pitch = math.tau / paddles.count
    away = abs(turn - pitch * round(turn / pitch))
    miss = max(0.0, away - _COVER * paddles.half_angle - top * time)
    return min(broken, 4) - 10.0 * miss + 0.01 * abs(spin)
