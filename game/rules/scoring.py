"""Points: for bricks and combos, for levels, and the rank that a level is left with."""

from game.level_format.specs import Level
from game.rules.drops import with_drop
from game.rules.power_up import PowerUp
from game.rules.powers import with_life, without_power
from game.rules.regrow import play_ticks
from game.rules.state import (
    BEST_COMBO,
    TICK,
    Event,
    EventKind,
    Game,
    LevelResult,
    Rank,
    Statistics,
    Tally,
    counted,
    paddle_rings,
)
from game.rules.versus import player_of, with_points
from physics import PERMANENT, Hit

EXTRA_LIFE_POINTS = 10_000
"""Every time the score passes a multiple of this, the arcade rules give a life."""
_POINTS_PER_BRICK = 10
"""Points for a layer, times the combo."""
POINTS_PER_LIFE = 100
"""Points for every life that is left when a level is cleared."""
_BUMPER_POINTS = 5
_BURST_TICKS = 240
"""Ticks for which a bumper makes the balls faster."""
_PAR_START, _PAR_PER_LAYER = 15.0, 1.5
"""Seconds: a level's par is the first, and the second for every layer."""
_POINTS_PER_SECOND = 10
"""Points for every whole second below par."""
_NO_LOSS_POINTS = 500
"""Points for a level without a lost life."""


def par(level: Level) -> float:
    """Seconds with balls in play in which a level is played well."""
    layers = sum([left for ring in level.rings for left in ring.slots() if left > 0])
    return _PAR_START + _PAR_PER_LAYER * layers


def rank_of(level: Level, tally: Tally) -> Rank:
    """The rank of a level that was cleared.

    Two marks for no lost life, one for a single one; two for a time within par, one within twice as much; one for a combo of
    BEST_COMBO. Five marks are an S, four an A, two or three a B.
    """
    seconds = tally.ticks * TICK
    marks = max(2 - tally.balls_lost, 0) + (seconds <= par(level)) + (seconds <= 2.0 * par(level))
    marks += tally.best_combo >= BEST_COMBO
    return {5: Rank.S, 4: Rank.A, 3: Rank.B, 2: Rank.B}.get(marks, Rank.C)


def credited(game: Game, hit: Hit, events: list[Event]) -> Game:
    """The game after one hit is scored."""
    where = hit.contact.point
    if hit.ring in paddle_rings(game):
        events.append(Event(EventKind.PADDLE_HIT, hit, position=where))
        game = counted(game, paddle_hits=1)._replace(last_player=player_of(hit.ring))
        return game._replace(combo=0, idle=game.idle + 1, paddle_hits=game.paddle_hits + 1)
    if game.ruleset.arcade and hit.ring == len(game.arena.rings) - 1:
        events.append(Event(EventKind.SHIELD_HIT, hit, position=where))
        return without_power(game, PowerUp.SHIELD, events, hit.slot)
    if hit.layers == PERMANENT:
        game = game._replace(idle=game.idle + 1)
        if game.ruleset.arcade and game.level.rings[hit.ring - 1].bumper:
            events.append(Event(EventKind.BUMPER_HIT, hit, _BUMPER_POINTS, where))
            return with_points(game._replace(score=game.score + _BUMPER_POINTS, burst=_BURST_TICKS), _BUMPER_POINTS)
        events.append(Event(EventKind.WALL_HIT, hit, position=where))
        return game
    return with_broken(game, hit, 1, events)


def with_broken(game: Game, hit: Hit, layers: int, events: list[Event]) -> Game:
    """The game after a hit broke some layers of a brick; the arena is left as it is. An empty slot may leave a power-up."""
    where = hit.contact.point
    combo = game.combo + layers
    points = sum([layer_points(game.combo + k) for k in range(1, layers + 1)])
    events.append(Event(EventKind.BRICK_HIT, hit, points, where))
    game = _with_combo(counted(game, bricks=layers), combo)
    game = with_points(game._replace(score=game.score + points, combo=combo, idle=0, waited=0), points)
    return with_drop(game, where, events) if hit.layers == 0 and game.ruleset.arcade else game


def layer_points(combo: int) -> int:
    """Points for a layer that makes a combo of so many."""
    return _POINTS_PER_BRICK * min(combo, BEST_COMBO)


def _with_combo(game: Game, combo: int) -> Game:
    """The game whose tallies know of a combo."""
    level, whole = game.statistics
    if combo <= level.best_combo and combo <= whole.best_combo:
        return game
    level = level._replace(best_combo=max(combo, level.best_combo))
    whole = whole._replace(best_combo=max(combo, whole.best_combo))
    return game._replace(statistics=Statistics(level, whole))


def with_extra_lives(game: Game, before: int, events: list[Event]) -> Game:
    """The game with a life for every multiple of EXTRA_LIFE_POINTS that the score of its player has passed since `before`."""
    if game.sides:
        return game
    for _ in range(game.score // EXTRA_LIFE_POINTS - before // EXTRA_LIFE_POINTS):
        game = with_life(game, 0j, events)
    return game


def with_result(game: Game, events: list[Event]) -> Game:
    """The game with the bonuses and the result of the level that has just been cleared."""
    tally = game.statistics.level._replace(ticks=play_ticks(game))
    time_bonus = loss_bonus = 0
    if game.ruleset.arcade and not game.sides:
        time_bonus = _POINTS_PER_SECOND * max(int(par(game.level) - tally.ticks * TICK), 0)
        loss_bonus = 0 if tally.balls_lost else _NO_LOSS_POINTS
    points = time_bonus + loss_bonus + (0 if game.sides else POINTS_PER_LIFE * game.lives)
    game = game._replace(score=game.score + points)
    events.append(Event(EventKind.LEVEL_CLEARED, points=points))
    result = LevelResult(
        game.number,
        game.score - game.score_before,
        tally.ticks,
        tally.balls_lost,
        tally.best_combo,
        rank_of(game.level, tally),
        time_bonus,
        loss_bonus,
    )
    return game._replace(results=(*game.results, result))
