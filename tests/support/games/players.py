"""Players for recorded games: not as good as the autopilot, on purpose."""

import random

from game.rules import POINTER_STEPS, Controls, Game, Phase, paddle_ring
from physics import angle_of, cross, dot, signed_difference

TURN = 6.283185307179586


def bearing_ahead(game: Game) -> float:
    """Where the ball would come to the paddles' track, were there no bricks."""
    ball, track = game.arena.balls[0], paddle_ring(game).inner_radius
    p, v = ball.position, ball.velocity
    root = dot(v, v) * track * track - cross(p, v) ** 2
    time = (max(root, 0.0) ** 0.5 - dot(p, v)) / dot(v, v)
    return angle_of(p + v * time)


class MousePlayer:
    """Moves the pointer after the ball, late, shakily and in jumps, and serves when it feels like it."""

    def __init__(self, seed: int) -> None:
        self._chance = random.Random(seed)
        self._pointer: int | None = None
        self._serve_at = 0

    def controls(self, game: Game) -> Controls:
        if game.tick % 12 == 0 and game.arena.balls:
            shake = (self._chance.random() - 0.5) * 0.25
            self._pointer = int(((bearing_ahead(game) + shake) / TURN % 1.0) * POINTER_STEPS) % POINTER_STEPS
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
            paddles = paddle_ring(game)
            ways = [signed_difference(bearing_ahead(game), paddles.angle(slot)) for slot in range(paddles.count)]
            way = min(ways, key=abs)
            self._turn = 0 if abs(way) < 0.1 else (1 if way > 0 else -1)
            if self._chance.random() < 0.04:
                self._turn = -self._turn
            self._until = game.tick + 10 + int(self._chance.random() * 20)
        return Controls(turn=self._turn, serve=game.tick % 170 == 0)
