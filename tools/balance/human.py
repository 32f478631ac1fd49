"""A simulated human with a mouse: it sees the game late, aims with an error, and moves the pointer there.

The model is the simplest that loses balls as people do. It looks at the game as it was one reaction time ago. A ball that
flies outward beyond the bricks is aimed at where its straight path meets the paddles' track, with one error for the whole
flight, drawn from a normal distribution. A ball that flies inward or among the bricks is not predicted; the pointer follows
its bearing, since a ball that bounces off a ring comes back on the same side. A power-up is gone for where no ball is due
before it, and harmful ones are let go. A ball that sticks to a paddle is served after a moment.
"""

import math
import random
from collections import deque
from typing import NamedTuple

from game.rules import HARMFUL, PADDLES, POINTER_STEPS, TICK, Controls, Game, Phase, paddle_ring
from game.rules.state import wall_layers
from physics import Ball, angle_of, cross, dot, length, normalize_angle

_SERVE_WAIT = (0.4, 1.2)
"""Seconds that the player takes before a serve: from, to."""
_TO_AND_FRO = 0.5
"""Seconds that a player allows for coming back from a power-up to a ball."""
_NEAR = 1.0
"""Seconds: a power-up that takes longer to the track is not gone for yet."""


class Skill(NamedTuple):
    """How good a player is.

    reaction: seconds from what happens to the hand's answer.
    noise: standard deviation of the aim at the paddles' track, degrees.
    """

    reaction: float
    noise: float


AVERAGE = Skill(0.22, 5.0)
GOOD = Skill(0.15, 2.0)
SLOW = Skill(0.30, 10.0)


class Human:
    """Plays by pointer; the same seed and game give the same controls."""

    def __init__(self, skill: Skill, seed: int) -> None:
        """seed: of the errors of the aim and of the pauses before serves."""
        self._skill = skill
        self._chance = random.Random(seed)
        self._seen: deque[Game] = deque(maxlen=max(round(skill.reaction / TICK), 1))
        self._velocity = 0j
        self._error = 0.0
        self._pointer: int | None = None
        self._serve_tick = -1

    def controls(self, game: Game) -> Controls:
        """What the player does in this tick."""
        self._seen.append(game)
        if game.held and not game.arena.balls:
            return Controls(pointer=self._pointer, serve=game.held[0].ticks * TICK >= _SERVE_WAIT[0])
        if game.phase != Phase.PLAYING:
            return Controls(pointer=self._pointer, serve=self._serves(game))
        bearing = self._aimed(self._seen[0])
        if bearing is not None:
            self._pointer = int(normalize_angle(bearing) / math.tau * POINTER_STEPS) % POINTER_STEPS
        return Controls(pointer=self._pointer)

    def _serves(self, game: Game) -> bool:
        """Whether the player serves in this tick: a moment after being asked to."""
        if game.phase_tick <= 1:
            first, last = _SERVE_WAIT
            self._serve_tick = game.tick + round((first + (last - first) * self._chance.random()) / TICK)
        return game.tick >= self._serve_tick

    def _aimed(self, game: Game) -> float | None:
        """The angle that the player means to bring a paddle to, radians; None where there is no ball in play."""
        if game.phase != Phase.PLAYING or not game.arena.balls:
            return None
        coming = [ball for ball in game.arena.balls if _is_coming(game, ball)]
        drop = _next_drop(game)
        if drop is not None and all([_time_to_track(game, ball) > drop.seconds + _TO_AND_FRO for ball in coming]):
            return drop.bearing
        if not coming:
            return angle_of(max(game.arena.balls, key=lambda ball: length(ball.position)).position)
        ball = min(coming, key=lambda ball: _time_to_track(game, ball))
        if ball.velocity != self._velocity:
            self._velocity = ball.velocity
            self._error = self._chance.gauss(0.0, math.radians(self._skill.noise))
        return angle_of(ball.position + ball.velocity * _time_to_track(game, ball)) + self._error


class _Coming(NamedTuple):
    """A power-up on its way to the paddles' track. seconds: until it is there; bearing: where, radians."""

    seconds: float
    bearing: float


def _next_drop(game: Game) -> _Coming | None:
    """The next power-up that a player would like to catch."""
    track = paddle_ring(game).inner_radius
    wanted = [drop for drop in game.drops if drop.kind not in HARMFUL and length(drop.position) < track]
    coming = [_Coming((track - length(drop.position)) / length(drop.velocity), angle_of(drop.position)) for drop in wanted]
    near = [one for one in coming if one.seconds < _NEAR]
    return min(near, default=None)


def _is_coming(game: Game, ball: Ball) -> bool:
    """Whether a ball flies outward with no bricks before it."""
    walls = zip(game.arena.rings[PADDLES + 1 :], wall_layers(game), strict=False)
    standing = [ring.outer_radius for ring, layers in walls if any(layers)]
    return dot(ball.position, ball.velocity) > 0.0 and length(ball.position) >= max(standing, default=0.0)


def _time_to_track(game: Game, ball: Ball) -> float:
    """Seconds until the ball's centre is a radius from the paddles' inner faces, on a straight path from inside it."""
    track = paddle_ring(game).inner_radius - ball.radius
    p, v = ball.position, ball.velocity
    square = dot(v, v)
    root = square * track * track - cross(p, v) * cross(p, v)
    return max((math.sqrt(max(root, 0.0)) - dot(p, v)) / square, 0.0)
