"""Players for recorded games: not as good as the autopilot, on purpose."""

import random

from game.rules import POINTER_STEPS, Controls, Game, Phase, paddle_ring
from physics import angle_of, length, signed_difference

TURN = 6.283185307179586


class MousePlayer:
    """Moves the pointer after the ball, late, shakily and in jumps, and serves when it feels like it."""

    def __init__(self, seed: int) -> None:
        self._chance = random.Random(seed)
        self._pointer: int | None = None
        self._serve_at = 0

    def controls(self, game: Game) -> Controls:
        if game.tick % 12 == 0 and game.arena.balls:
            ball = game.arena.balls[0]
            ahead = ball.position + ball.velocity * (9.0 - length(ball.position)) / 9.0
            shake = (self._chance.random() - 0.5) * 0.25
            self._pointer = int(((angle_of(ahead) + shake) / TURN % 1.0) * POINTER_STEPS) % POINTER_STEPS
        if game.phase_tick == 0:
            self._serve_at = int(self._chance.random() * 600)
        return Controls(pointer=self._pointer, serve=game.phase_tick >= self._serve_at and game.phase != Phase.PLAYING)


class KeyPlayer:
    """Presses the arrow keys towards the ball, with a reaction time, and now and then the wrong one."""

    def __init__(self, seed: int) -> None:
        self._chance = random.Random(seed)
        self._turn = 0
        self._until = 0

    def controls(self, game: Game) -> Controls:
        if game.tick >= self._until and game.arena.balls:
            ball = game.arena.balls[0]
            ahead = angle_of(ball.position + ball.velocity * 0.5)
            paddles = paddle_ring(game)
            ways = [signed_difference(ahead, paddles.angle(slot)) for slot in range(paddles.count)]
            way = min(ways, key=abs)
            self._turn = 0 if abs(way) < 0.1 else (1 if way > 0 else -1)
            if self._chance.random() < 0.08:
                self._turn = -self._turn
            self._until = game.tick + 10 + int(self._chance.random() * 40)
        return Controls(turn=self._turn, serve=game.tick % 170 == 0)
