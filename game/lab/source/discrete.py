"""The source's own loop at any frame rate: everything moves by a whole frame, then the ball's overlap is tested once."""

from collections.abc import Sequence
from typing import NamedTuple

from physics import Ball, Outcome, Ring, broad_phase_outcome
from physics.source_mode import nearest_living, normal_at, slides_response


class SourceBall(NamedTuple):
    """A ball between two frames.

    velocity: None once the response has divided 0 by 0.
    """

    position: complex
    velocity: complex | None


class SourceGame(NamedTuple):
    """The source's game between two frames: one ball, a ring of paddles, and a wall of bricks.

    layers: left in each slot of the bricks, 0 for an empty one. over: whether the ball has left the ground.
    """

    ball: SourceBall
    paddles: Ring
    bricks: Ring
    layers: tuple[int, ...]
    over: bool = False


def frame(ball: SourceBall, ball_radius: float, rings: Sequence[Ring], dt: float, speed: float) -> SourceBall:
    """The ball one frame later. rings: as they stand at the end of the frame. dt: seconds. speed: the ball's fixed speed."""
    if ball.velocity is None:
        return ball
    moved = Ball(ball.position, ball.velocity, ball_radius).moved(dt)
    for ring in rings:
        n = normal_at(moved, ring, (1,) * ring.count)
        if n is not None:
            return _answered(moved, n, ring, speed)
    return SourceBall(moved.position, moved.velocity)


def game_frame(game: SourceGame, ball_radius: float, ground_radius: float, dt: float, speed: float) -> SourceGame:
    """The whole game one frame later, by the outcome of the broad phase at the end of the frame."""
    paddles, bricks, (p, v) = game.paddles.turned(dt), game.bricks.turned(dt), game.ball
    if v is None or game.over:
        return game._replace(paddles=paddles, bricks=bricks)
    ball = Ball(p + v * dt, v, ball_radius)
    moved = game._replace(ball=SourceBall(ball.position, v), paddles=paddles, bricks=bricks)
    match broad_phase_outcome(ball.position, ball_radius, ground_radius, paddles, [bricks]):
        case Outcome.GAME_OVER:
            return moved._replace(over=True)
        case Outcome.PADDLES:
            n = normal_at(ball, paddles, (1,) * paddles.count)
            return moved if n is None else moved._replace(ball=_answered(ball, n, paddles, speed))
        case Outcome.BRICKS:
            return _after_bricks(moved, ball, speed)
    return moved


def _after_bricks(game: SourceGame, ball: Ball, speed: float) -> SourceGame:
    """The game after the brick nearest in angle, of those that are left, was tested: one that is hit loses a layer."""
    slot, n = nearest_living(ball.position, game.bricks, game.layers), normal_at(ball, game.bricks, game.layers)
    if n is None:
        return game
    after = _answered(ball, n, game.bricks, speed)
    hit = after.velocity != ball.velocity and slot is not None and game.layers[slot] > 0
    layers = tuple([count - (hit and index == slot) for index, count in enumerate(game.layers)])
    return game._replace(ball=after, layers=layers)


def _answered(ball: Ball, n: complex, ring: Ring, speed: float) -> SourceBall:
    """The ball after the collision response to a contact with a ring."""
    p, v, _ = ball
    return SourceBall(p, slides_response(v, n, ring.surface_velocity(p), ring.friction, speed))
