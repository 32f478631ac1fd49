"""What a caught power-up does, and when it ends."""

import math

from game.rules.power_up import LASTING, OF_PADDLES, OPPOSITES, ActivePower, Drop, PowerUp
from game.rules.state import Event, EventKind, Game, counted, player_at
from game.rules.versus import with_lives
from physics import Ball, angle_of, direction

MOST_LIVES = 9
"""Lives that a player can have."""
MOST_BALLS = 9
"""Balls in play at most."""
_SPREAD = math.radians(25.0)
"""Radians from a ball's flight to those of the two that it is joined by."""


def with_caught(game: Game, drops: list[Drop], events: list[Event]) -> Game:
    """The game after some drops were caught, one after the other."""
    for drop in drops:
        game = counted(game, drops_caught=1)
        if drop.kind == PowerUp.MULTI_BALL:
            game = _with_more_balls(game)
        elif drop.kind == PowerUp.LIFE:
            game = with_life(game, drop.position, events)
        else:
            game = _with_power(game, drop, events)
    return game


def with_life(game: Game, position: complex, events: list[Event]) -> Game:
    """The game with one more life, up to MOST_LIVES."""
    lives = game.sides[player_at(position)].lives if game.sides else game.lives
    if lives >= MOST_LIVES:
        return game
    events.append(Event(EventKind.LIFE_GAINED, position=position))
    if game.sides:
        return with_lives(game, 1, player_at(position))
    return game._replace(lives=game.lives + 1)


def without_power(game: Game, kind: PowerUp, events: list[Event], player: int = 0) -> Game:
    """The game without a player's power-up that lasted, if it did. player: as in `ActivePower`."""
    if game.power(kind, player) is None:
        return game
    events.append(Event(EventKind.POWER_ENDED, power=kind))
    return game._replace(powers=_without(game, kind, player))


def _without(game: Game, kind: PowerUp, player: int) -> tuple[ActivePower, ...]:
    """The power-ups that last, but for one."""
    return tuple([power for power in game.powers if power.kind != kind or power.player != player])


def one_tick_later(game: Game, events: list[Event]) -> Game:
    """The game with a tick less of every power-up that lasts, and of a bumper's burst."""
    if game.burst > 0:
        game = game._replace(burst=game.burst - 1)
    if not game.powers:
        return game
    going: list[ActivePower] = []
    for power in game.powers:
        if power.ticks_total == 0 or power.ticks_left > 1:
            going.append(power._replace(ticks_left=max(power.ticks_left - 1, 0)))
        else:
            events.append(Event(EventKind.POWER_ENDED, power=power.kind))
    return game._replace(powers=tuple(going))


def _with_power(game: Game, drop: Drop, events: list[Event]) -> Game:
    """The game with a power-up that lasts: its opposite ends, and one of the same kind begins anew."""
    kind = drop.kind
    player = player_at(drop.position) if game.sides and kind in OF_PADDLES else 0
    opposite = OPPOSITES.get(kind)
    if opposite is not None and game.power(opposite, player) is not None:
        return without_power(game, opposite, events, player)
    ticks = LASTING[kind]
    return game._replace(powers=(*_without(game, kind, player), ActivePower(kind, ticks, ticks, player)))


def _with_more_balls(game: Game) -> Game:
    """The game with two more balls beside the first one in play, to its left and to its right."""
    if not game.arena.balls or len(game.arena.balls) + 2 > MOST_BALLS:
        return game
    ball = game.arena.balls[0]
    heading = angle_of(ball.velocity)
    more = [Ball(ball.position, direction(heading + turn) * game.speed, ball.radius) for turn in (_SPREAD, -_SPREAD)]
    return game._replace(arena=game.arena._replace(balls=(*game.arena.balls, *more)))
