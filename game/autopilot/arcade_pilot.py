"""The autopilot of games under the arcade rules: several balls, aimed by where they meet the paddle, and drops to be caught."""

import math
from typing import NamedTuple

from game.autopilot.prediction import LOOK, Ahead, ball_of, crossing, pointer_to, without_paddles
from game.autopilot.source_pilot import ticks_before_serve
from game.rules import HARMFUL, TICK, Controls, Drop, Game, Phase, PowerUp, paddle_ring
from game.rules.pierce import without_bricks
from game.rules.state import player_at
from game.rules.steering import top_spin
from game.rules.turn import place_turn, turned
from physics import Ball, Ring, angle_of, direction, length, normalize_angle, signed_difference

_SHARES = (0.0, 0.4, -0.4, 0.75, -0.75)
"""Where on the paddle to meet the ball, in shares of its half angle from its middle."""
_COVER = 0.7
"""Share of a paddle's half angle within which a hit counts as safe."""
_STALE = 8
"""Ticks for which an arrival is believed while a gravity well turns the ball."""
_SOON = 1.5
"""Seconds after a ball within which the next ones count when a return is chosen."""
_HASTE = 0.85
"""Share of the time until a ball comes that a detour to a drop may take."""
_HOLD = 60
"""Ticks for which a ball that sticks to a paddle is kept at least."""
_CALM = 0.7
"""Seconds without a ball at the track in which one that sticks to a paddle is let go."""


class _Arrival(NamedTuple):
    """Where and when a ball comes to the paddles' track.

    time: seconds from when it was computed; tick: of the game. there: this ball and the bricks at that moment.
    broken: bricks that it hits before, after which it is another flight.
    """

    time: float
    tick: int
    bearing: float
    there: Ahead
    broken: int


class _Known(NamedTuple):
    """What was computed for a ball that had this velocity in that tick."""

    velocity: complex
    tick: int
    arrival: _Arrival | None


class ArcadePilot:
    """Meets the ball that comes first, where on the paddle its return breaks most and the next balls can be reached.

    On the way it catches the drops for which there is time.
    """

    def __init__(self) -> None:
        """Start without a plan."""
        self._known: dict[int, _Known] = {}
        self._chosen: tuple[complex, float] | None = None  # velocity of the ball to be met, and where the paddle shall be

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.phase == Phase.SERVING:
            self._known, self._chosen = {}, None
            return Controls(serve=game.phase_tick >= ticks_before_serve(game))
        if game.phase != Phase.PLAYING:
            return Controls(serve=True)
        coming = self._coming(game)
        if game.ruleset.versus:
            return _for_both(game, coming)
        first = coming[0][1] if coming else None
        left = math.inf if first is None else (first.tick - game.tick) * TICK
        serve = any([ball.ticks >= _HOLD for ball in game.held]) and left > _CALM
        target = None if first is None else self._target(game, coming)
        drop = _worthwhile_drop(game, left, target)
        if drop is not None:
            target = angle_of(drop.position)
        return Controls(pointer=None if target is None else pointer_to(target), serve=serve)

    def _coming(self, game: Game) -> list[tuple[int, _Arrival]]:
        """The balls that come to the track, by their index, the first to come first."""
        known: dict[int, _Known] = {}
        for index, ball in enumerate(game.arena.balls):
            before = self._known.get(index)
            if before is None or not _holds(before, ball, game):
                before = _Known(ball.velocity, game.tick, _arrival(game, ball))
            known[index] = before
        self._known = known
        found = [(index, one.arrival) for index, one in known.items() if one.arrival is not None]
        return sorted(found, key=lambda pair: (pair[1].tick, pair[0]))

    def _target(self, game: Game, coming: list[tuple[int, _Arrival]]) -> float:
        """Where the middle of a paddle shall be when the first ball comes: kept until another flight is the first."""
        index, first = coming[0]
        velocity = game.arena.balls[index].velocity
        if self._chosen is None or self._chosen[0] != velocity:
            self._chosen = velocity, _best_target(game, first, [one for _, one in coming[1:]])
        return self._chosen[1]


def _for_both(game: Game, coming: list[tuple[int, _Arrival]]) -> Controls:
    """Controls of both players: each meets the first ball that comes to the own half, off the paddle's middle by turns."""
    pointers: list[int | None] = [None, None]
    for _, arrival in reversed(coming):
        player = player_at(direction(arrival.bearing))
        share = _SHARES[game.paddle_hits % len(_SHARES)]
        pointers[player] = pointer_to(arrival.bearing - share * paddle_ring(game).half_angle)
    return Controls(pointer=pointers[0], serve=bool(game.held), second_pointer=pointers[1])


def _holds(known: _Known, ball: Ball, game: Game) -> bool:
    """Whether what is known of a ball is still true."""
    return known.velocity == ball.velocity or (bool(game.level.wells) and game.tick - known.tick < _STALE)


def _arrival(game: Game, ball: Ball) -> _Arrival | None:
    """When a ball comes to the track, wells left aside; None within the horizon."""
    arena = game.arena if game.power(PowerUp.PIERCE) is None else without_bricks(game.arena)
    found = crossing(without_paddles(arena), ball, paddle_ring(game).inner_radius - ball.radius, game.speed)
    if found is None:
        return None
    time, there, broken = found
    return _Arrival(time, game.tick + int(time / TICK), angle_of(ball_of(there).position), there, broken)


def _best_target(game: Game, first: _Arrival, others: list[_Arrival]) -> float:
    """The best of the targets that a paddle can reach; the ball's own bearing where it will fly elsewhere before."""
    if first.broken:
        return first.bearing
    paddles, top = paddle_ring(game), top_spin(game)
    best, best_worth = first.bearing, -math.inf
    for share in _SHARES:
        target = normalize_angle(first.bearing - share * paddles.half_angle)
        if share != 0.0 and abs(_way(paddles, target)) > top * first.time:
            continue
        worth = _worth(game, first, share, top) - _missed(game, target, first, others)
        if worth > best_worth:
            best, best_worth = target, worth
    return best


def _way(paddles: Ring, target: float) -> float:
    """Radians that the paddles turn to bring the nearest to a target."""
    return min([signed_difference(target, paddles.angle(slot)) for slot in range(paddles.count)], key=abs)


def _worth(game: Game, first: _Arrival, share: float, top: float) -> float:
    """How good a return is: bricks that it breaks, less what the catch after it asks of the paddles beyond their reach."""
    paddles, ball = paddle_ring(game), ball_of(first.there)
    outward = direction(first.bearing)
    speed = length(ball.velocity)
    across = complex(-outward.imag, outward.real)
    radial = ball.velocity.real * outward.real + ball.velocity.imag * outward.imag
    along = ball.velocity.real * across.real + ball.velocity.imag * across.imag
    mirrored = across * along - outward * radial
    velocity = turned(mirrored, -outward, place_turn(game, share * paddles.half_angle), speed)
    inside = Ball(ball.position - outward * (LOOK * speed * 0.01), velocity, ball.radius)
    returned = crossing(first.there, inside, paddles.inner_radius - ball.radius, speed)
    if returned is None:
        return 0.0
    time, later, broken = returned
    target = normalize_angle(first.bearing - share * paddles.half_angle)
    away = _away(paddles, target, angle_of(ball_of(later).position))
    return min(broken, 4) - 10.0 * max(0.0, away - top * time) - 0.02 * abs(share)


def _missed(game: Game, target: float, first: _Arrival, others: list[_Arrival]) -> float:
    """What the balls that come soon after the first ask of the paddles beyond their reach."""
    paddles, top = paddle_ring(game), top_spin(game)
    missed = 0.0
    for other in others:
        time = (other.tick - first.tick) * TICK
        if time < _SOON:
            missed += 10.0 * max(0.0, _away(paddles, target, other.bearing) - top * time)
    return missed


def _away(paddles: Ring, middle: float, bearing: float) -> float:
    """Radians that the paddles, one of them with its middle at an angle, must turn to meet a ball safely."""
    pitch = math.tau / paddles.count
    turn = abs(signed_difference(bearing, middle))
    return max(0.0, abs(turn - pitch * round(turn / pitch)) - _COVER * paddles.half_angle)


def _worthwhile_drop(game: Game, left: float, target: float | None) -> Drop | None:
    """The first drop to come for which there is time before a ball comes.

    left: seconds until then; target: where a paddle shall be then.
    """
    paddles, top = paddle_ring(game), top_spin(game)
    found: Drop | None = None
    earliest = math.inf
    for drop in game.drops:
        time = (paddles.radius - length(drop.position)) / length(drop.velocity)
        if drop.kind in HARMFUL or not 0.0 <= time < earliest:
            continue
        bearing = angle_of(drop.position)
        way = abs(_way(paddles, bearing))
        if way > top * time + _COVER * paddles.half_angle:
            continue
        back = 0.0 if target is None else _away(paddles, bearing, target)
        if target is None or back <= top * (left - time) * _HASTE:
            found, earliest = drop, time
    return found
