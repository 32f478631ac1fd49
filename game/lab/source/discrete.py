"""The source's own loop, taken literally: the ball moves by a whole frame, then its overlap is tested once."""

from collections.abc import Sequence
from typing import NamedTuple

from game.lab.source import functions
from game.lab.source.response_steps import response_steps
from physics import Outcome, Ring, broad_phase_outcome, in_band, length, min_difference, narrow_phase_case_1, to_polar
from physics.tolerances import STOPPED


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
    p, v = ball.position + ball.velocity * dt, ball.velocity
    for ring in rings:
        n = normal_at(p, ball_radius, ring)
        if n is not None:
            return _answered(SourceBall(p, v), n, ring, speed)
    return SourceBall(p, v)


def game_frame(game: SourceGame, ball_radius: float, ground_radius: float, dt: float, speed: float) -> SourceGame:
    """The whole game one frame later, by the outcome of the broad phase at the end of the frame."""
    paddles, bricks, (p, v) = game.paddles.turned(dt), game.bricks.turned(dt), game.ball
    if v is None or game.over:
        return game._replace(paddles=paddles, bricks=bricks)
    p = p + v * dt
    moved = game._replace(ball=SourceBall(p, v), paddles=paddles, bricks=bricks)
    match broad_phase_outcome(p, ball_radius, ground_radius, paddles, bricks):
        case Outcome.GAME_OVER:
            return moved._replace(over=True)
        case Outcome.PADDLES:
            n = normal_at(p, ball_radius, paddles)
            return moved if n is None else moved._replace(ball=_answered(moved.ball, n, paddles, speed))
        case Outcome.BRICKS if p != 0.0 and any(game.layers):
            return _after_bricks(moved, ball_radius, speed)
    return moved


def normal_at(p: complex, ball_radius: float, ring: Ring) -> complex | None:
    """The normal that the source finds for a ball at p: band, nearest sector, then case 1 or case 2; None without a contact."""
    if p == 0.0 or not in_band(p, ball_radius, ring):
        return None
    return _sector_normal(p, ball_radius, ring, _nearest(p, ring, range(ring.count)))


def _after_bricks(game: SourceGame, ball_radius: float, speed: float) -> SourceGame:
    """The game after the brick nearest in angle, of those that are left, was tested: one that is hit loses a layer."""
    p, v = game.ball
    slot = _nearest(p, game.bricks, [slot for slot in range(game.bricks.count) if game.layers[slot]])
    n = _sector_normal(p, ball_radius, game.bricks, slot)
    if n is None:
        return game
    after = _answered(game.ball, n, game.bricks, speed)
    hit = after.velocity != v and game.layers[slot] > 0
    layers = tuple([count - (hit and index == slot) for index, count in enumerate(game.layers)])
    return game._replace(ball=after, layers=layers)


def _nearest(p: complex, ring: Ring, slots: Sequence[int]) -> int:
    """Of some slots the first that is nearest in angle: the source's search."""
    theta = to_polar(p)[1]
    return min(slots, key=lambda slot: min_difference(theta, ring.angle(slot)))


def _sector_normal(p: complex, ball_radius: float, ring: Ring, slot: int) -> complex | None:
    """Case 1 or case 2 with one sector."""
    theta, angle = to_polar(p)[1], ring.angle(slot)
    if min_difference(theta, angle) <= ring.half_angle:
        return narrow_phase_case_1(p, ring.radius)
    end = angle + functions.end_sign(theta, angle, ring.half_angle) * ring.half_angle
    return functions.end_normal(p, ball_radius, *functions.end_points(ring.radius, ring.half_width, end))


def _answered(ball: SourceBall, n: complex, ring: Ring, speed: float) -> SourceBall:
    """The ball after the collision response to a contact with a ring."""
    p, v = ball
    if v is None:
        return ball
    steps = response_steps(v, n, ring.surface_velocity(p), ring.friction, speed)
    return SourceBall(p, reset(v, steps.before_reset, speed))


def reset(v: complex, before_reset: complex, speed: float) -> complex | None:
    """v := v_0 v_res / |v_res|, the source's last equation; v itself where there was no bounce.

    None for 0 / 0, also where v_res is 0 but for rounding.
    """
    if before_reset == v:
        return v
    size = length(before_reset)
    return None if size <= STOPPED * speed else before_reset * (speed / size)
