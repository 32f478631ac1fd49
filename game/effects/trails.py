"""Where each ball has just been."""

from game.rules import TICK, Phase, Ticked
from physics import Ball

Trail = tuple[complex, ...]
"""Positions of a ball, from old to new; the ball's own position is not part of it."""

_LENGTH = 17
"""Positions at most."""
_EVERY = 4
"""Ticks from one position to the next."""


def after_tick(trails: tuple[Trail, ...], ticked: Ticked) -> tuple[Trail, ...]:
    """A trail for each ball in play; when their number changes, each goes on with the trail that ends where it is."""
    game = ticked.game
    if game.phase != Phase.PLAYING:
        return ()
    balls = game.arena.balls
    if len(trails) != len(balls):
        return tuple([_continued(trails, ball, game.speed) for ball in balls])
    if game.tick % _EVERY and not ticked.step.hits:
        return trails
    return tuple([(*trail[1 - _LENGTH :], ball.position) for trail, ball in zip(trails, balls, strict=True)])


def _continued(trails: tuple[Trail, ...], ball: Ball, speed: float) -> Trail:
    """The trail whose end a ball can have come from since; a new one where there is none."""
    near = [trail for trail in trails if abs(trail[-1] - ball.position) <= speed * TICK * (_EVERY + 1)]
    return min(near, key=lambda trail: abs(trail[-1] - ball.position), default=(ball.position,))
