"""The autopilot of games under the source's rules: one ball, steered by the motion of the paddle that returns it."""

import math
from functools import reduce

from game.autopilot.prediction import pointer_to, without_paddles
from game.autopilot.source_plan import Plan, outer, planned, serve_wait, wanted_angle
from game.rules import Controls, Game, Phase, paddle_ring
from game.rules.state import PLAYING


class SourcePilot:
    """Predicts where the ball crosses the paddles' track, and meets it there with the motion that breaks most bricks next.

    Keeps its plan until the ball's velocity changes; the same game seen from its start gets the same controls.
    """

    def __init__(self) -> None:
        """Start without a plan."""
        self._velocity: complex | None = None
        self._plan: Plan | None = None
        self._angle = math.nan
        self._controls = Controls()

    def controls(self, game: Game) -> Controls:
        """What to do in this tick."""
        if game.phase is not PLAYING:
            self._velocity = None
            return Controls(serve=game.phase != Phase.SERVING or game.phase_tick >= ticks_before_serve(game))
        balls = game.arena.balls
        ball = balls[0] if len(balls) == 1 else reduce(outer, balls)
        if ball.velocity != self._velocity:
            self._velocity = ball.velocity
            top = math.radians(game.level.paddles.top_speed)
            self._plan = planned(without_paddles(game.arena), paddle_ring(game), ball, game.tick, game.speed, top)
        plan = self._plan
        if plan is None:
            return Controls()
        angle = wanted_angle(plan, game.tick)
        if angle != self._angle:
            self._angle, self._controls = angle, Controls(pointer=pointer_to(angle))
        return self._controls


def ticks_before_serve(game: Game) -> int:
    """Ticks that the autopilot waits before a serve."""
    return serve_wait(game.seed, game.lives, game.number, game.score)
