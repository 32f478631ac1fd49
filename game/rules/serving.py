"""The serve: where the ball rests, and where it will fly."""

import math

from game.rules.chance import drawn
from game.rules.power_up import ActivePower, PowerUp
from game.rules.shape import shaped
from game.rules.speed import with_speed_now
from game.rules.state import POINTER_STEPS, SERVE_GAP, Controls, Event, EventKind, Game, Phase, Ticked, in_phase
from game.rules.versus import served_from
from physics import Arena, Ball, Ring, Step, direction, normalize_angle, signed_difference

_AIM_RANGE = math.radians(55.0)
"""Radians: the most that a serve is aimed off the centre, to either side."""
_AIM_PERIOD = 480
"""Ticks of one full swing of the aim."""


def aim(game: Game) -> float:
    """Angle of the serve off the straight line to the centre, radians: swings to and fro; one full swing takes 2 s."""
    return swung_aim(game.phase_tick + game.aim_start)


def swung_aim(ticks: int) -> float:
    """`aim` after some ticks of its swing."""
    cycle = (ticks % _AIM_PERIOD) / _AIM_PERIOD
    return _AIM_RANGE * (4.0 * abs(cycle - 0.5) - 1.0) * -1.0


def with_served_ball(game: Game, arena: Arena, wanted: int | None = None) -> Arena:
    """The arena with the ball resting on a paddle, its velocity where the serve is aimed. wanted: as `Controls.aim`."""
    paddles = arena.rings[served_from(game)]
    ball = served_ball(paddles, game.level.ball.radius, game.speed, _aimed(game, paddles.angle(0), wanted))
    return arena._replace(balls=(ball,))


def served_ball(paddles: Ring, radius: float, speed: float, off: float) -> Ball:
    """The ball resting on paddle 0. off: angle of the serve off the straight line to the centre, radians."""
    angle = paddles.angle(0)
    distance = paddles.inner_radius - radius * (1.0 + SERVE_GAP)
    velocity = direction(angle + math.pi + off) * speed
    return Ball(direction(angle) * distance, velocity, radius)


def _aimed(game: Game, angle: float, wanted: int | None) -> float:
    """Angle of the serve off the straight line to the centre: the player's as far as it may go, or the swinging one."""
    if wanted is None:
        return aim(game)
    off = signed_difference(wanted * (math.tau / POINTER_STEPS), normalize_angle(angle + math.pi))
    return min(max(off, -_AIM_RANGE), _AIM_RANGE)


def before_serve(game: Game) -> Game:
    """The game waiting for a serve, the ball on its paddle. Under the arcade rules chance decides where the aim begins."""
    game = in_phase(game, Phase.SERVING)
    if game.ruleset.arcade:
        chance, game = drawn(game)
        game = game._replace(
            paddle_hits=0, waited=0, burst=0, drops=(), powers=_at_serve(game), aim_start=int(chance * _AIM_PERIOD)
        )
        game = shaped(game._replace(arena=game.arena._replace(balls=())))
    game = with_speed_now(game, [])
    return game._replace(arena=with_served_ball(game, game.arena))


def _at_serve(game: Game) -> tuple[ActivePower, ...]:
    """The power-ups that a serve begins with."""
    players = range(len(game.arena.layers[-1]) if game.ruleset.handicap.shielded else 0)
    return tuple([ActivePower(PowerUp.SHIELD, 0, 0, player) for player in players])


def serving(game: Game, controls: Controls, step: Step, moving: Arena) -> Ticked:
    """The ball follows its paddle until it is served."""
    arena = with_served_ball(game, game.arena, controls.aim)
    if not controls.serve:
        return Ticked(game._replace(arena=arena), (), step, moving, game.speed)
    served = Event(EventKind.SERVED, position=arena.balls[0].position)
    game = in_phase(game, Phase.PLAYING)._replace(arena=arena, idle=0, combo=0)
    return Ticked(game, (served,), step, moving, game.speed)
