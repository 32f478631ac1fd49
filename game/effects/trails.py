"""Where each ball has just been."""

from game.rules import Phase, Ticked

Trail = tuple[complex, ...]
"""Places from old to new."""

_LENGTH = 17
_EVERY = 4
"""Ticks from one place to the next."""


def after_tick(trails: tuple[Trail, ...], ticked: Ticked) -> tuple[Trail, ...]:
    """A line of recent places behind each ball in play; it starts anew when the number of balls changes."""
    game = ticked.game
    if game.phase != Phase.PLAYING:
        return ()
    balls = game.arena.balls
    if len(trails) != len(balls):
        return tuple([(ball.position,) for ball in balls])
    if game.tick % _EVERY and not ticked.step.hits:
        return trails
    return tuple([(*trail[1 - _LENGTH :], ball.position) for trail, ball in zip(trails, balls, strict=True)])
