"""A player for headless games and demonstrations: it sees the game and answers with controls, like anybody else."""

import math
from typing import NamedTuple

from game.rules import PADDLES, POINTER_STEPS, TICK, Controls, Game, Phase, paddle_ring
from physics import (
    Arena,
    Ball,
    FreeFlight,
    advance,
    angle_of,
    collision_response,
    cross,
    direction,
    dot,
    length,
    normalize_angle,
    signed_difference,
)

_LOOK = 1.0 / 20.0
"""Seconds per step when looking ahead; the physics is exact for any step."""
_HORIZON = 60
_CUT_TIME = 0.35
"""Seconds of steady paddle motion before a hit, so that its friction turns the ball."""
_CUTS = (0.0, 0.9, -0.9, 0.5, -0.5)
"""Paddle motions to choose from, as fractions of the top speed."""
_SERVE_WAIT = 30
_SERVE_SPREAD = 450
_COVER = 0.7
"""Fraction of a paddle's half angle within which a hit counts as safe."""


class _Plan(NamedTuple):
    """Where and when the ball meets the paddles' track, and how the paddle shall move then."""

    tick: int
    bearing: float
    spin: float


class Autopilot:
    """Predicts where the ball crosses the paddles' track, and meets it there with the motion that breaks most bricks next.

    Keeps its plan until the ball's velocity changes; the same game seen from its start gets the same controls.
    """

    def __init__(self) -> None:
        """Start without a plan."""
        self._velocity: complex | None = None
        self._plan: _Plan | None = None

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.phase == Phase.SERVING:
            self._velocity = None
            return Controls(serve=game.phase_tick >= _SERVE_WAIT + _serve_delay(game))
        if game.phase != Phase.PLAYING:
            return Controls(serve=True)
        if not game.arena.balls:
            return Controls(serve=True)  # every ball sticks to a paddle
        ball = _outermost(game.arena.balls)
        if ball.velocity != self._velocity:
            self._velocity = ball.velocity
            self._plan = _plan(game, ball)
        if self._plan is None:
            return Controls()
        left = max(0.0, (self._plan.tick - game.tick) * TICK)
        angle = self._plan.bearing - self._plan.spin * min(left, _CUT_TIME)
        return Controls(pointer=_pointer(angle))


def _serve_delay(game: Game) -> int:
    """Ticks to wait before a serve: differs from seed to seed and serve to serve."""
    return (game.seed * 97 + game.lives * 41 + game.number * 23 + game.score) % _SERVE_SPREAD


def _pointer(angle: float) -> int:
    """An angle in pointer steps."""
    return int(normalize_angle(angle) / math.tau * POINTER_STEPS) % POINTER_STEPS


def _outermost(balls: tuple[Ball, ...]) -> Ball:
    """The ball nearest to the rim."""
    return max(balls, key=lambda ball: length(ball.position))


def _plan(game: Game, ball: Ball) -> _Plan | None:
    """How to meet the ball when it next comes to the paddles' track; None if it does not within the horizon."""
    paddles = paddle_ring(game)
    track = paddles.inner_radius - ball.radius
    crossing = _crossing(_without_paddles(game.arena, ball), track, game.speed)
    if crossing is None:
        return None
    time, arena, broken = crossing
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


def _without_paddles(arena: Arena, ball: Ball) -> Arena:
    """One ball and the bricks."""
    return Arena((ball,), arena.rings[PADDLES + 1 :], arena.layers[PADDLES + 1 :])


def _crossing(arena: Arena, track: float, speed: float) -> tuple[float, Arena, int] | None:
    """Time, arena and bricks hit when the ball's centre comes to the track from inside; None beyond the horizon."""
    hits = 0
    flight: FreeFlight | None = None
    for step in range(_HORIZON):
        ball = arena.balls[0]
        left = _time_to_radius(ball, track)
        if left <= _LOOK:
            reached = advance(arena, max(left, 0.0), speed, flight)
            if not reached.hits:
                return step * _LOOK + left, reached.arena, hits
        done = advance(arena, _LOOK, speed, flight)
        hits += len(done.hits)
        arena, flight = done.arena, done.flight
    return None


def _time_to_radius(ball: Ball, radius: float) -> float:
    """Seconds of free flight until the centre crosses a radius outward: the later root of |p + v t| = radius."""
    p, v, _ = ball
    square = dot(v, v)
    root = square * radius * radius - cross(p, v) * cross(p, v)
    return (math.sqrt(root) - dot(p, v)) / square if root > 0.0 else 0.0


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
    inside = Ball(ball.position + normal * (_LOOK * speed * 0.01), velocity, ball.radius)
    track = paddles.inner_radius - ball.radius
    returned = _crossing(arena._replace(balls=(inside,)), track, speed)
    if returned is None:
        return 0.0
    time, later, broken = returned
    turn = abs(signed_difference(angle_of(later.balls[0].position), angle_of(ball.position)))
    pitch = math.tau / paddles.count
    away = abs(turn - pitch * round(turn / pitch))
    miss = max(0.0, away - _COVER * paddles.half_angle - top * time)
    return min(broken, 4) - 10.0 * miss + 0.01 * abs(spin)
