"""The values of the rules: what a player asks for, a game, and what happened in a tick."""

from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

from game.levels import Level
from game.rules.power_up import ActivePower, Drop, PowerUp
from game.rules.ruleset import SOURCE_RULES, Ruleset
from physics import Arena, Ball, FreeFlight, Hit, Ring, Step, direction
from physics.shapes import unchecked

TICK = 1.0 / 240.0
"""Seconds per tick."""
POINTER_STEPS = 65536
"""Steps of a full turn in `Controls.pointer` and `Controls.aim`."""
PADDLES = 0
"""Index of the paddles in `Arena.rings`; of the first player's, where two play against each other."""
BEST_COMBO = 8
"""Combo length from which the multiplier stops growing."""

Advance = Callable[[Arena, float, float, FreeFlight | None], Step]
"""A physics: the arena, seconds, the balls' speed, and what the step before said of this one, to a step."""


class Controls(NamedTuple):
    """What the player asks for in one tick.

    turn: -1 clockwise, 0, +1 counter-clockwise. pointer: where the nearest paddle shall go, in 1/POINTER_STEPS of a turn;
    `turn` has precedence. serve: launch the ball, let go those that stick to a paddle, or go on after a cleared level.
    give_up: gives up the balls in play: they count as lost. aim: where a ball that is served shall fly, in 1/POINTER_STEPS of
    a turn; None for the aim that swings by itself. second_turn, second_pointer: the same of a second player, who steers the
    same paddles whenever the first asks for nothing.
    """

    turn: int = 0
    pointer: int | None = None
    serve: bool = False
    give_up: bool = False
    aim: int | None = None
    second_turn: int = 0
    second_pointer: int | None = None


class Phase(IntEnum):
    """What the game is waiting for."""

    SERVING = 0
    PLAYING = 1
    CLEARED = 2
    WON = 3
    OVER = 4


PLAYING = Phase.PLAYING
"""The phase that every tick compares with. As a module constant it is found in a fifth of the time.

Python 3.11 calls a function for every member of an enumeration. Three names instead of them are 2 % of a headless game.
"""


class HeldBall(NamedTuple):
    """A ball that sticks to the inner face of a paddle.

    slot: of the paddle. offset: from the paddle's middle, radians, counter-clockwise. radius: world units. ticks: since it was
    caught. ring: of the paddle.
    """

    slot: int
    offset: float
    radius: float
    ticks: int
    ring: int = PADDLES


class Side(NamedTuple):
    """One of two players who play against each other."""

    score: int
    lives: int


class Tally(NamedTuple):
    """What has been counted.

    bricks: layers broken. best_combo: most of them without a paddle's hit between. balls_lost: those that cost a life.
    ticks: with balls in play, until the last serve.
    """

    bricks: int = 0
    best_combo: int = 0
    paddle_hits: int = 0
    balls_lost: int = 0
    ticks: int = 0
    drops_caught: int = 0


class Statistics(NamedTuple):
    """What has been counted in the level that is being played, and in the whole game."""

    level: Tally = Tally()
    game: Tally = Tally()


class Rank(IntEnum):
    """How well a level was played; `game.rules.scoring.rank_of` has the thresholds."""

    C = 0
    B = 1
    A = 2
    S = 3


class LevelResult(NamedTuple):
    """How a cleared level went.

    level: its index in `Game.levels`. score: points made in it, with the bonuses. ticks: with balls in play. balls_lost:
    those that cost a life. time_bonus, loss_bonus: points for speed, and for losing no ball; part of the score.
    """

    level: int
    score: int
    ticks: int
    balls_lost: int
    best_combo: int
    rank: Rank
    time_bonus: int = 0
    loss_bonus: int = 0


class Game(NamedTuple):
    """Everything that decides how the game goes on.

    number: of the level being played, from 0. draws: random numbers used so far. phase_tick: ticks since the phase began.
    arena: ring 0 is the paddles; under the arcade rules the last ring is the shield, with 0 layers while there is none. Balls
    that are held are not in it. combo: bricks hit since a paddle was. idle: contacts since a brick was hit. flight: of the
    physics' last step with balls in play; it spares the next one work. speed: of every ball in play, world units per second.
    drops: on their way outward. powers: that last, in the order in which they were caught. held: balls that stick to a
    paddle. results: of the levels cleared so far. paddle_hits: since the last serve; they make the balls faster. waited:
    ticks in play since a brick was hit. burst: ticks for which a bumper makes the balls faster. aim_start: where the swing of
    the aim begins, in ticks. score_before: at the level's start. sides: of two players who play against each other, else none;
    then `lives` are those of the one who has fewer. server: the player who serves. last_player: whose paddle was hit last.
    """

    levels: tuple[Level, ...]
    number: int
    seed: int
    draws: int
    tick: int
    phase: Phase
    phase_tick: int
    arena: Arena
    score: int
    lives: int
    combo: int
    idle: int
    flight: FreeFlight | None = None
    ruleset: Ruleset = SOURCE_RULES
    speed: float = 1.0
    drops: tuple[Drop, ...] = ()
    powers: tuple[ActivePower, ...] = ()
    held: tuple[HeldBall, ...] = ()
    statistics: Statistics = Statistics()
    results: tuple[LevelResult, ...] = ()
    paddle_hits: int = 0
    waited: int = 0
    burst: int = 0
    aim_start: int = 0
    score_before: int = 0
    sides: tuple[Side, ...] = ()
    server: int = 0
    last_player: int = 0

    @property
    def level(self) -> Level:
        """The level being played."""
        return self.levels[self.number]

    def power(self, kind: PowerUp, player: int = 0) -> ActivePower | None:
        """The power-up of a kind that lasts now. player: whose, as in `ActivePower`."""
        for power in self.powers:
            if power.kind == kind and power.player == player:
                return power
        return None


_TICK, _PHASE_TICK, _ARENA, _FLIGHT, _WAITED = map(Game._fields.index, ("tick", "phase_tick", "arena", "flight", "waited"))
"""Indices of the fields that every tick changes."""


class EventKind(IntEnum):
    """What happened, for drawing and sound.

    DROP_LOST: it left the ground. BALL_CAUGHT: it sticks to a paddle. BALL_RELEASED: it no longer does. SPEED_UP: balls got
    faster by the level's growth. CORE_BROKEN: a wall that would have grown again fell. AIMED: a ball was turned to a brick
    after a long wait. BRICK_CRUMBLED: a brick lost a layer by itself after a longer one.
    """

    SERVED = 0
    PADDLE_HIT = 1
    BRICK_HIT = 2
    WALL_HIT = 3
    NUDGED = 4
    BALL_LOST = 5
    LEVEL_CLEARED = 6
    LEVEL_STARTED = 7
    GAME_WON = 8
    GAME_OVER = 9
    DROP_RELEASED = 10
    DROP_CAUGHT = 11
    DROP_LOST = 12
    POWER_ENDED = 13
    LIFE_GAINED = 14
    BALLS_MET = 15
    BALL_CAUGHT = 16
    BALL_RELEASED = 17
    SPEED_UP = 18
    SHIELD_HIT = 19
    BUMPER_HIT = 20
    BRICK_REGROWN = 21
    CORE_BROKEN = 22
    AIMED = 23
    BRICK_CRUMBLED = 24


class Event(NamedTuple):
    """One thing that happened in a tick.

    hit: of PADDLE_HIT, BRICK_HIT, WALL_HIT, SHIELD_HIT, BUMPER_HIT and BALL_CAUGHT. power: of the events of drops and powers.
    points: made by it. position: where, in world units. sector: ring and slot of BRICK_CRUMBLED and BRICK_REGROWN.
    """

    kind: EventKind
    hit: Hit | None = None
    points: int = 0
    position: complex = 0j
    power: PowerUp | None = None
    sector: tuple[int, int] | None = None


class Ticked(NamedTuple):
    """What one tick of the game did.

    step: of the physics; while no ball is in play it advanced the rings of `moving` without balls. moving: the arena that the
    physics advanced: the one before the tick, with the paddles' new spin; outside PLAYING the step left out its balls. While
    balls pierce bricks, the bricks are left out of it. speed: the balls' speed in that step, world units per second.
    """

    game: Game
    events: tuple[Event, ...]
    step: Step
    moving: Arena
    speed: float = 0.0


def paddle_ring(game: Game) -> Ring:
    """The paddles."""
    return game.arena.rings[PADDLES]


def paddle_rings(game: Game) -> tuple[int, ...]:
    """Indices of the rings that are paddles: of the one, or of each of two players who play against each other."""
    return (PADDLES, len(game.arena.rings) - 2) if game.ruleset.versus else (PADDLES,)


def player_at(position: complex) -> int:
    """In whose half of the ring a position is: 0 below the centre, 1 above it."""
    return 0 if position.imag < 0.0 else 1


def layers_left(game: Game) -> int:
    """Layers still to be broken in the level."""
    return sum([layers for ring in wall_layers(game) for layers in ring if layers > 0])


def wall_layers(game: Game) -> tuple[tuple[int, ...], ...]:
    """Layers of the level's rings: without the paddles and the shield."""
    layers = game.arena.layers
    return layers[PADDLES + 1 : -1] if game.ruleset.arcade else layers[PADDLES + 1 :]


def held_balls(game: Game) -> tuple[Ball, ...]:
    """The balls that stick to a paddle, where they are, their velocities straight to the centre."""
    balls = []
    for held in game.held:
        paddles = game.arena.rings[held.ring]
        outward = direction(paddles.angle(held.slot) + held.offset)
        distance = paddles.inner_radius - held.radius * (1.0 + SERVE_GAP)
        balls.append(Ball(outward * distance, outward * -game.speed, held.radius))
    return tuple(balls)


def in_phase(game: Game, phase: Phase) -> Game:
    """The game at the beginning of a phase. The ticks of the one that ends are counted where balls were in play."""
    if game.phase == Phase.PLAYING:
        game = counted(game, ticks=game.phase_tick)
    return game._replace(phase=phase, phase_tick=0)


def one_tick_on(game: Game, arena: Arena, flight: FreeFlight | None, waited: int) -> Game:
    """The game one tick later, with these fields: the same as `_replace`, in a quarter of the time."""
    fields: list[Any] = [*game]
    fields[_TICK] += 1
    fields[_PHASE_TICK] += 1
    fields[_ARENA], fields[_FLIGHT], fields[_WAITED] = arena, flight, waited
    return unchecked(Game, fields)


def counted(game: Game, **more: int) -> Game:
    """The game with some numbers added to its tallies, by their names."""
    level, whole = game.statistics
    added = {name: getattr(level, name) + number for name, number in more.items()}
    added_whole = {name: getattr(whole, name) + number for name, number in more.items()}
    return game._replace(statistics=Statistics(level._replace(**added), whole._replace(**added_whole)))


SERVE_GAP = 1e-6
"""Between a ball that rests on its paddle and the paddle, in radii of the ball: it must not touch."""
