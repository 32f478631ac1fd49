"""A game from its first tick to its last: new, one tick later, the next level, and from its last level on."""

import physics
from game.levels import Level
from game.rules.playing import played
from game.rules.ruleset import SOURCE_RULES, Ruleset
from game.rules.serving import before_serve, serving
from game.rules.shape import arcade_arena
from game.rules.state import PLAYING, TICK, Advance, Controls, Event, EventKind, Game, Phase, Statistics, Tally, Ticked
from game.rules.steering import steered
from game.rules.versus import sides
from physics import Arena, Step

_CLEARED_TICKS = 480
"""Ticks after which the next level begins by itself."""
_CLEARED_LEAST = 60
"""Ticks before the player can go on to it."""


def new_game(levels: tuple[Level, ...], seed: int, ruleset: Ruleset = SOURCE_RULES) -> Game:
    """A game at the first of the levels, waiting for its first serve. seed: 0 <= seed < 2**63.

    Raises ValueError for two players under the source's rules.
    """
    if ruleset.versus and not ruleset.arcade:
        raise ValueError("two players need the arcade rules")
    lives = ruleset.handicap.lives
    start = levels[0].arena()
    game = Game(levels, 0, seed, 0, 0, Phase.SERVING, 0, start, 0, lives, 0, 0, ruleset=ruleset, sides=sides(ruleset))
    return before_serve(_in_own_arena(game))


def continued(game: Game) -> Game:
    """A new game that begins at the level of this one, without its points: a lost game is taken up where it was lost."""
    return new_game(game.levels[game.number :], game.seed, game.ruleset)


def tick(game: Game, controls: Controls, advance: Advance = physics.advance) -> Ticked:
    """The game one tick later. advance: the physics that is flown, any function of the shape of `physics.advance`."""
    arena = steered(game, controls)
    if game.phase is PLAYING:
        return played(game, arena, controls, advance)
    step = advance(arena._replace(balls=()), TICK, game.speed, None)
    later = game._replace(tick=game.tick + 1, phase_tick=game.phase_tick + 1, arena=step.arena)
    if game.phase == Phase.SERVING:
        return serving(later, controls, step, arena)
    if game.phase == Phase.CLEARED and game.phase_tick >= (_CLEARED_LEAST if controls.serve else _CLEARED_TICKS):
        return _next_level(later, step, arena)
    return Ticked(later, (), step, arena, game.speed)


def _next_level(game: Game, step: Step, moving: Arena) -> Ticked:
    """The first serve of the next level. Under the arcade rules it begins with as many lives as a game does, or with more."""
    lives = max(game.lives, game.ruleset.handicap.lives) if game.ruleset.arcade else game.lives
    statistics = Statistics(Tally(), game.statistics.game)
    speed = game.speed
    both = tuple([side._replace(lives=max(side.lives, game.ruleset.handicap.lives)) for side in game.sides])
    game = game._replace(number=game.number + 1, lives=lives, statistics=statistics, score_before=game.score)
    game = game._replace(powers=(), sides=both)
    return Ticked(before_serve(_in_own_arena(game)), (Event(EventKind.LEVEL_STARTED),), step, moving, speed)


def _in_own_arena(game: Game) -> Game:
    """The game in the arena of its level, before its first serve."""
    return game._replace(arena=arcade_arena(game) if game.ruleset.arcade else game.level.arena(), flight=None)
