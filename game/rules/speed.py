"""The balls' speed under the arcade rules: one for all of them, the same after every tick."""

from game.level_format.arcade_checks import SLOWEST
from game.rules.power_up import PowerUp
from game.rules.state import PADDLES, Event, EventKind, Game, paddle_ring, paddle_rings
from physics import Ball
from physics.vectors import unit

HITS_PER_STEP = 6
"""Hits of a paddle after which the balls get faster by the level's growth."""
USUAL_TOP = 1.4
"""Times `ball.speed`: where the growth ends, unless the level says."""
_SLOW, _FAST, _BURST = 0.75, 1.25, 1.2
"""Factors of a slow and a fast ball, and after a bumper."""
_RIM = 0.95
"""Share of the balls' speed that the paddles' outer rim may have: a ball can always leave a paddle."""
_RING_RIM = 1.02
"""Times the rim of the fastest ring of bricks: no ball is slower."""


def speed_now(game: Game) -> float:
    """The speed that the rules ask for, world units per second.

    It starts at the level's, grows with the hits of the paddles up to a cap, and power-ups and bumpers change it for a while.
    It is never below SLOWEST of the level's speed, nor below the rim of a ring of bricks.
    """
    spec, handicap = game.level.ball, game.ruleset.handicap
    if not game.ruleset.arcade:
        return spec.speed
    top = spec.top_speed if spec.top_speed is not None else USUAL_TOP * spec.speed
    speed = min(spec.speed * (1.0 + spec.growth * (game.paddle_hits // HITS_PER_STEP)), top) * handicap.ball_speed
    for power in game.powers:
        if power.kind == PowerUp.SLOW:
            speed *= _SLOW
        elif power.kind == PowerUp.FAST:
            speed *= _FAST
    if game.burst > 0:
        speed *= _BURST
    if speed >= spec.speed:
        return speed  # no bound below is higher
    wall = game.arena.rings[PADDLES + 1 : len(game.level.rings) + 1]
    rim = max([abs(ring.spin) * ring.outer_radius for ring in wall])
    return max(speed, SLOWEST * spec.speed, min(_RING_RIM * rim, spec.speed))


def fastest_spin(game: Game) -> float:
    """The most that the paddles may turn at the balls' speed, rad/s."""
    return _RIM * game.speed / paddle_ring(game).outer_radius


def at_speed(velocity: complex, speed: float) -> complex:
    """A velocity of that speed in the same direction."""
    return unit(velocity) * speed


def with_speed_now(game: Game, events: list[Event]) -> Game:
    """The game with the speed that the rules ask for: balls and paddles follow it at once."""
    speed = speed_now(game)
    if speed == game.speed:
        return game
    if speed > game.speed and game.paddle_hits and game.paddle_hits % HITS_PER_STEP == 0 and _just_hit(events):
        events.append(Event(EventKind.SPEED_UP))
    game = game._replace(speed=speed)
    balls, rings = game.arena.balls, game.arena.rings
    balls = tuple([Ball(ball.position, at_speed(ball.velocity, speed), ball.radius) for ball in balls])
    top = fastest_spin(game)
    for k in paddle_rings(game):
        spin = min(max(rings[k].spin, -top), top)
        if spin != rings[k].spin:
            rings = (*rings[:k], rings[k].steered(spin), *rings[k + 1 :])
    return game._replace(arena=game.arena._replace(balls=balls, rings=rings))


def _just_hit(events: list[Event]) -> bool:
    """Whether a paddle was hit in this tick."""
    return any([event.kind == EventKind.PADDLE_HIT for event in events])
