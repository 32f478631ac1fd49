"""Where each ball has just been."""

from game.rules import Phase, Ticked

Trail = tuple[complex, ...]
"""Positions of a ball, from old to new; the ball's own position is not part of it."""

_LENGTH = 17
"""Positions at most."""
_EVERY = 4
"""Ticks from one position to the next."""


def after_tick(trails: tuple[Trail, ...], ticked: Ticked) -> tuple[Trail, ...]:
    """A trail for each ball in play; it begins anew when the number of balls changes."""
    game = ticked.game
    if game.phase != Phase.PLAYING:
        return ()
    balls = game.arena.balls
    if len(trails) != len(balls):
        return tuple([(ball.position,) for ball in balls])
    if game.tick % _EVERY and not ticked.step.hits:
        return trails
    return tuple([(*trail[1 - _LENGTH :], ball.position) for trail, ball in zip(trails, balls, strict=True)])
