"""A game under the arcade rules, as ticks to compare.

Between two ticks of the physics these rules change what it flies in: the balls' speed, the paddles' width, the shield,
bricks that grow again or that balls fly through, the direction of a ring. Every such change is taken as a new beginning:
the numbers of the arena are read anew, and hold until the next. A level's first numbers are those of its file.

What the rules do to a ball that a paddle returned is compared, too: `comparisons/hit_offset_turn.py`.
"""

import math
from collections.abc import Iterator

from game.levels import Level
from game.rules import EventKind, Ticked
from physics import Arena, Feature, Hit
from tools.crosscheck.comparisons.hit_frame import geometry_of
from tools.crosscheck.comparisons.rules import WIDEST
from tools.crosscheck.games.level_numbers import LevelNumbers, RingNumbers, numbers_of_level
from tools.crosscheck.games.trajectory import Answer, Tick

_PADDLES = 0
_OTHERWISE_TURNED = {
    EventKind.NUDGED,
    EventKind.BALLS_MET,
    EventKind.BALL_CAUGHT,
    EventKind.BALL_RELEASED,
    EventKind.BALL_LOST,
    EventKind.LEVEL_CLEARED,
}
"""In a tick with one of these a ball may fly elsewhere for another reason, or be another one by its index."""


def arcade_ticks(game_ticks: Iterator[Ticked], dt: float) -> Iterator[Tick]:
    """The ticks of a game under the arcade rules."""
    level: Level | None = None  # that the tick was played on: the next one begins with the tick after it
    numbers: LevelNumbers | None = None
    left: Arena | None = None
    for number, done in enumerate(game_ticks):
        if level is None:
            level = done.game.levels[0]
        moving, step = done.moving, done.step
        if numbers is None or left is None:
            numbers = _of_level(level, moving, done)
        elif _changed(left, moving, numbers, done.speed):
            numbers = _of_arena(level, moving, done)
        if len(step.arena.balls) != len(moving.balls):
            moving = moving._replace(balls=())
        yield Tick(number, moving, dt, step, numbers, _answers(done))
        left = step.arena
        if done.game.level is not level:
            level, left = done.game.level, None


def _changed(left: Arena, moving: Arena, numbers: LevelNumbers, speed: float) -> bool:
    """Whether the rules have changed the arena since the physics left it."""
    if speed != numbers.speed or moving.layers != left.layers:
        return True
    pairs = zip(left.rings, moving.rings, strict=True)
    return any([geometry_of(a) != geometry_of(b) or (k and a.spin != b.spin) for k, (a, b) in enumerate(pairs)])


def _of_level(level: Level, arena: Arena, done: Ticked) -> LevelNumbers:
    """The numbers of a level's file, its paddles as wide as the difficulty makes them, with the shield of the arena."""
    if done.game.ruleset.versus:  # its paddles are no level's
        return _of_arena(level, arena, done)
    numbers = numbers_of_level(level)
    paddles, *wall = numbers.rings
    own = paddles.geometry.half_angle
    wide = min(own * done.game.ruleset.handicap.paddle_width, max(own, WIDEST * math.pi / paddles.geometry.count))
    paddles = paddles._replace(geometry=paddles.geometry._replace(half_angle=wide))
    rings = (paddles, *wall, _ring_numbers(arena, len(arena.rings) - 1))
    return LevelNumbers(rings, numbers.ball_radius, done.speed, _turn(level, done))


def _of_arena(level: Level, arena: Arena, done: Ticked) -> LevelNumbers:
    """The numbers of the arena as it stands."""
    rings = tuple([_ring_numbers(arena, k) for k in range(len(arena.rings))])
    return LevelNumbers(rings, level.ball.radius, done.speed, _turn(level, done))


def _turn(level: Level, done: Ticked) -> float:
    """The most that the position of a hit turns a ball, radians."""
    return math.radians(level.paddles.turn) * done.game.ruleset.handicap.turn


def _ring_numbers(arena: Arena, k: int) -> RingNumbers:
    """One ring as it stands."""
    ring = arena.rings[k]
    return RingNumbers(geometry_of(ring), ring.phase, ring.spin if k else None, ring.friction, arena.layers[k])


def _answers(done: Ticked) -> tuple[Answer, ...]:
    """How each ball flies on that a paddle's inner face returned in its last bounce of the tick."""
    if not done.step.hits or done.game.level.wells or any([event.kind in _OTHERWISE_TURNED for event in done.events]):
        return ()
    last: dict[int, Hit] = {}
    for hit in done.step.hits:
        last[hit.ball] = hit
    aimed = {id(event.hit) for event in done.events if event.kind == EventKind.AIMED}
    balls = done.game.arena.balls
    return tuple(
        [
            Answer(hit, balls[hit.ball].velocity, id(hit) in aimed)
            for hit in last.values()
            if hit.ring == _PADDLES and hit.contact.feature == Feature.INNER_FACE
        ]
    )
