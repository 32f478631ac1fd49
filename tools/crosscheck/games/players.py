"""Players that are not as good as the autopilot: they meet the ball with any part of a paddle, and miss it."""

import math
import random
from typing import Protocol

from game.autopilot import Autopilot
from game.rules import POINTER_STEPS, Controls, Game, Phase, paddle_ring
from physics import angle_of, cross, dot, signed_difference

_POINTER_TICKS = 12
"""Between two moves of the hand."""
_SHAKE = 0.7
"""Of the paddle's half angle, to either side: how far from the ball the pointer may be."""
_WRONG_KEY = 0.04
_LONGEST_PAUSE = 120
"""Ticks before a serve."""


class Player(Protocol):
    """Sees the game and answers with controls."""

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""


class MousePlayer:
    """Moves the pointer after the ball, late, shakily and in jumps.

    longest_pause: ticks before a serve, at most.
    """

    longest_pause = _LONGEST_PAUSE

    def __init__(self, seed: int) -> None:
        """The same seed makes the same moves."""
        self._chance = random.Random(seed)
        self._pointer: int | None = None
        self._serve_at = 0

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.tick % _POINTER_TICKS == 0 and game.arena.balls:
            shake = (2.0 * self._chance.random() - 1.0) * self.most_shake(game)
            self._pointer = int(((_bearing_ahead(game) + shake) / math.tau % 1.0) * POINTER_STEPS) % POINTER_STEPS
        if game.phase_tick == 0:
            self._serve_at = int(self._chance.random() * self.longest_pause)
        return Controls(pointer=self._pointer, serve=game.phase != Phase.PLAYING and game.phase_tick >= self._serve_at)

    def most_shake(self, game: Game) -> float:
        """Radians that the pointer is beside the ball, at most, to either side."""
        return _SHAKE * paddle_ring(game).half_angle


class KeyPlayer:
    """Presses the arrow keys towards the ball, with a reaction time, and now and then the wrong one."""

    def __init__(self, seed: int) -> None:
        """The same seed makes the same moves."""
        self._chance = random.Random(seed)
        self._turn = 0
        self._until = 0

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.tick >= self._until and game.arena.balls:
            paddles = paddle_ring(game)
            offsets = [signed_difference(_bearing_ahead(game), paddles.angle(slot)) for slot in range(paddles.count)]
            offset = min(offsets, key=abs)
            self._turn = 0 if abs(offset) < 0.1 else (1 if offset > 0 else -1)
            if self._chance.random() < _WRONG_KEY:
                self._turn = -self._turn
            self._until = game.tick + 10 + int(self._chance.random() * 20)
        return Controls(turn=self._turn, serve=game.tick % _LONGEST_PAUSE == 0)


def player(name: str, seed: int) -> Player:
    """The player of that name."""
    if name == "mouse":
        return MousePlayer(seed)
    return KeyPlayer(seed) if name == "keys" else Autopilot()


def _bearing_ahead(game: Game) -> float:
    """Where the ball would come to the paddles' track, were there no bricks."""
    p, v, _ = game.arena.balls[0]
    track = paddle_ring(game).inner_radius
    root = max(dot(v, v) * track * track - cross(p, v) * cross(p, v), 0.0)
    return angle_of(p + v * ((math.sqrt(root) - dot(p, v)) / dot(v, v)))
