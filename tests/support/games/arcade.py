"""Levels and games for tests of the arcade rules."""

from game.levels import parse
from game.rules import Controls, EventKind, Phase, Ruleset, new_game, tick
from physics import Ball, length
from tests.support.level_text import GOOD, changed

LEVEL = parse(GOOD, "good")
IDLE = Controls()
SERVE = Controls(serve=True)
EVERYTHING = parse(
    GOOD
    + b"""
[[rings]]
radius = 4.4
half_width = 0.25
half_angle = 20.0
count = 6
layers = [2, 2, 0, 2, 2, 0]
spin = 25.0
reverse = 3.0
[[rings]]
radius = 1.6
half_width = 0.3
half_angle = 25.0
count = 4
layers = -1
bumper = true
[[rings]]
radius = 5.6
half_width = 0.25
half_angle = 8.0
count = 18
regrow = 2.0
[[wells]]
distance = 7.0
angle = 40.0
strength = 20.0
reach = 2.0
[[wells]]
distance = 7.0
angle = 200.0
strength = -25.0
reach = 2.0
[drops]
chance = 0.8
""",
    "everything",
)
"""A level with all that the arcade rules know."""


def arcade(level=LEVEL, seed=1, ruleset=None):
    """A game at one level under the arcade rules."""
    return new_game((level,), seed, ruleset or Ruleset())


def with_balls(game, *flights):
    """The game in play, with balls placed and sent by hand: pairs of a position and a direction."""
    radius = game.level.ball.radius
    balls = [Ball(position, velocity * (game.speed / length(velocity)), radius) for position, velocity in flights]
    return game._replace(phase=Phase.PLAYING, phase_tick=0, arena=game.arena._replace(balls=tuple(balls)))


def after(game, ticks, controls=IDLE):
    """The game some ticks later, and all events on the way."""
    events = []
    for _ in range(ticks):
        done = tick(game, controls)
        game = done.game
        events.extend(done.events)
    return game, events


def kinds(events):
    """The events' kinds, in order."""
    return [event.kind for event in events]


def until(game, kind, ticks, controls=IDLE):
    """The tick in which an event of a kind happens, within so many ticks."""
    for _ in range(ticks):
        done = tick(game, controls)
        if kind in kinds(done.events):
            return done
        game = done.game
    raise AssertionError(f"no {EventKind(kind).name} within {ticks} ticks")


__all__ = ["EVERYTHING", "GOOD", "IDLE", "LEVEL", "SERVE", "after", "arcade", "changed", "kinds", "until", "with_balls"]
