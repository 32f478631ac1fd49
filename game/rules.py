"""The rules: what a tick of the game does with the player's controls and the physics' hits.

Pure: a game and the controls of one tick in, the next game and its events out. Nothing here knows a window.
"""

import math
import random
from collections.abc import Callable
from enum import IntEnum
from typing import NamedTuple

import physics
from game.levels import Level
from physics import (
    PERMANENT,
    Arena,
    Ball,
    FreeFlight,
    Hit,
    Outcome,
    Ring,
    Step,
    broad_phase_outcome,
    direction,
    dot,
    signed_difference,
)

TICK = 1.0 / 240.0
"""Seconds per tick."""
LIVES = 3
POINTER_STEPS = 65536
"""Steps of a full turn in `Controls.pointer`."""
PADDLES = 0
"""Index of the paddles in `Arena.rings`."""
BEST_COMBO = 8
"""Combo length from which the multiplier stops growing."""

_POINTS_PER_BRICK = 10
"""Points for a layer, times the combo."""
_POINTS_PER_LIFE = 100
"""Points for every life that is left when a level is cleared."""
_AIM_RANGE = math.radians(55.0)
"""Radians: the most that a serve is aimed off the centre, to either side."""
_AIM_PERIOD = 480
"""Ticks of one full swing of the aim."""
_SERVE_GAP = 1e-6
"""Between the ball to be served and its paddle, in radii of the ball: it must not touch."""
_CLEARED_TICKS = 480
"""Ticks after which the next level begins by itself."""
_CLEARED_LEAST = 60
"""Ticks before the player can go on to it."""
_IDLE_CONTACTS = 12
"""Contacts without a brick after which the balls are nudged."""
_IDLE_STEP = 3
"""Further contacts without a brick until the next nudge."""
_NUDGE_LEAST = math.radians(5.0)
_NUDGE_MORE = math.radians(15.0)
"""Radians: a nudge turns the velocity by at least the first of them, and by up to the second more."""


Advance = Callable[[Arena, float, float, FreeFlight | None], Step]
"""A physics: the arena, seconds, the balls' speed, and what the step before said of this one, to a step."""


class Controls(NamedTuple):
    """What the player asks for in one tick."""

    turn: int = 0  # -1 clockwise, 0, +1 counter-clockwise
    pointer: int | None = None  # where the nearest paddle shall go, in 1/POINTER_STEPS of a turn; `turn` has precedence
    serve: bool = False  # launch the ball, or go on after a cleared level
    give_up: bool = False  # gives up the balls in play: they count as lost


class Phase(IntEnum):
    """What the game is waiting for."""

    SERVING = 0
    PLAYING = 1
    CLEARED = 2
    WON = 3
    OVER = 4


class Game(NamedTuple):
    """Everything that decides how the game goes on."""

    levels: tuple[Level, ...]
    number: int  # of the level being played, from 0
    seed: int
    draws: int  # random numbers used so far
    tick: int
    phase: Phase
    phase_tick: int  # ticks since the phase began
    arena: Arena  # ring 0 is the paddles
    score: int
    lives: int
    combo: int  # bricks hit since a paddle was
    idle: int  # contacts since a brick was hit
    flight: FreeFlight | None = None  # of the physics' last step with balls in play; it spares the next one work

    @property
    def level(self) -> Level:
        """The level being played."""
        return self.levels[self.number]


class EventKind(IntEnum):
    """What happened, for drawing and sound."""

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


class Event(NamedTuple):
    """One thing that happened in a tick."""

    kind: EventKind
    hit: Hit | None = None  # of PADDLE_HIT, BRICK_HIT and WALL_HIT
    points: int = 0
    position: complex = 0j  # where, in world units


class Ticked(NamedTuple):
    """What one tick of the game did."""

    game: Game
    events: tuple[Event, ...]
    step: Step  # of the physics; while no ball is in play it advanced the rings of `moving` without balls
    moving: Arena  # the arena before the tick, with the paddles' new spin; outside PLAYING the step left out its balls


def new_game(levels: tuple[Level, ...], seed: int) -> Game:
    """A game at the first of the levels, waiting for its first serve. seed: 0 <= seed < 2**63."""
    arena = levels[0].arena()
    game = Game(levels, 0, seed, 0, 0, Phase.SERVING, 0, arena, 0, LIVES, 0, 0)
    return game._replace(arena=_with_served_ball(game, arena))


def tick(game: Game, controls: Controls, advance: Advance = physics.advance) -> Ticked:
    """The game one tick later. advance: the physics that is flown, any function of the shape of `physics.advance`."""
    arena = _steered(game, controls)
    if game.phase == Phase.PLAYING:
        return _played(game, arena, advance, give_up=controls.give_up)
    step = advance(arena._replace(balls=()), TICK, game.level.ball.speed, None)
    later = game._replace(tick=game.tick + 1, phase_tick=game.phase_tick + 1, arena=step.arena)
    if game.phase == Phase.SERVING:
        return _serving(later, controls, step, arena)
    if game.phase == Phase.CLEARED and game.phase_tick >= (_CLEARED_LEAST if controls.serve else _CLEARED_TICKS):
        return _next_level(later, step, arena)
    return Ticked(later, (), step, arena)


def layers_left(game: Game) -> int:
    """Layers still to be broken in the level."""
    return sum([layers for ring in game.arena.layers for layers in ring if layers > 0])


def paddle_ring(game: Game) -> Ring:
    """The paddles."""
    return game.arena.rings[PADDLES]


def aim(game: Game) -> float:
    """Angle of the serve off the straight line to the centre, radians: swings to and fro; one full swing takes 2 s."""
    cycle = (game.phase_tick % _AIM_PERIOD) / _AIM_PERIOD
    return _AIM_RANGE * (4.0 * abs(cycle - 0.5) - 1.0) * -1.0


def _steered(game: Game, controls: Controls) -> Arena:
    """The arena with the paddles' spin set for this tick: towards full speed by keys, straight to the pointer by mouse."""
    paddles, spec = paddle_ring(game), game.level.paddles
    top = math.radians(spec.top_speed)
    if controls.turn == 0 and controls.pointer is not None:
        spin = _spin_to_pointer(paddles, controls.pointer, top)
    else:
        change = math.radians(spec.acceleration) * TICK
        wanted = top * controls.turn
        spin = min(max(wanted, paddles.spin - change), paddles.spin + change)
    if spin == paddles.spin:
        return game.arena
    return game.arena._replace(rings=(paddles.steered(spin), *game.arena.rings[1:]))


def _spin_to_pointer(paddles: Ring, pointer: int, top: float) -> float:
    """Spin that brings the nearest paddle to the pointer within one tick, no faster than the top speed."""
    wanted = pointer * (math.tau / POINTER_STEPS)
    offsets = [signed_difference(wanted, paddles.angle(slot)) for slot in range(paddles.count)]
    offset = min(offsets, key=abs)
    return min(max(offset / TICK, -top), top)


def _with_served_ball(game: Game, arena: Arena) -> Arena:
    """The arena with the ball resting on paddle 0, its velocity where the serve is aimed."""
    spec = game.level.ball
    paddles = arena.rings[PADDLES]
    angle = paddles.angle(0)
    distance = paddles.inner_radius - spec.radius * (1.0 + _SERVE_GAP)
    velocity = direction(angle + math.pi + aim(game)) * spec.speed
    return arena._replace(balls=(Ball(direction(angle) * distance, velocity, spec.radius),))


def _serving(game: Game, controls: Controls, step: Step, moving: Arena) -> Ticked:
    """The ball follows its paddle until it is served."""
    arena = _with_served_ball(game, game.arena)
    if not controls.serve:
        return Ticked(game._replace(arena=arena), (), step, moving)
    served = Event(EventKind.SERVED, position=arena.balls[0].position)
    return Ticked(_in_phase(game, Phase.PLAYING)._replace(arena=arena, idle=0, combo=0), (served,), step, moving)


def _next_level(game: Game, step: Step, moving: Arena) -> Ticked:
    """The first serve of the next level."""
    game = _in_phase(game, Phase.SERVING)._replace(number=game.number + 1)
    game = game._replace(arena=_with_served_ball(game, game.level.arena()))
    return Ticked(game, (Event(EventKind.LEVEL_STARTED),), step, moving)


def _played(game: Game, moving: Arena, advance: Advance, *, give_up: bool) -> Ticked:
    """A tick with balls in play: the physics, then what its hits mean, then who has left."""
    step = advance(moving, TICK, game.level.ball.speed, game.flight)
    game = game._replace(tick=game.tick + 1, phase_tick=game.phase_tick + 1, arena=step.arena, flight=step.flight)
    events: list[Event] = []
    for hit in step.hits:
        game = _credited(game, hit, events)
    if game.idle >= _IDLE_CONTACTS:
        game = _nudged(game, events)
    if not any([layers > 0 for ring in game.arena.layers for layers in ring]):
        game = _level_cleared(game, events)
    else:
        game = _without_lost_balls(game, events, give_up=give_up)
    return Ticked(game, tuple(events), step, moving)


def _credited(game: Game, hit: Hit, events: list[Event]) -> Game:
    """The game after one hit is scored."""
    where = hit.contact.point
    if hit.ring == PADDLES:
        events.append(Event(EventKind.PADDLE_HIT, hit, position=where))
        return game._replace(combo=0, idle=game.idle + 1)
    if hit.layers == PERMANENT:
        events.append(Event(EventKind.WALL_HIT, hit, position=where))
        return game._replace(idle=game.idle + 1)
    combo = game.combo + 1
    points = _POINTS_PER_BRICK * min(combo, BEST_COMBO)
    events.append(Event(EventKind.BRICK_HIT, hit, points, where))
    return game._replace(score=game.score + points, combo=combo, idle=0)


def _nudged(game: Game, events: list[Event]) -> Game:
    """The balls turned by a small random angle: they are caught in a loop that meets no brick."""
    chance = random.Random((game.seed << 32) + game.draws).random()  # draw number `draws` of this seed
    size = _NUDGE_LEAST + _NUDGE_MORE * abs(2.0 * chance - 1.0)
    turn = direction(size if chance >= 0.5 else -size)
    mirrored = turn.conjugate()
    balls = tuple(
        [
            Ball(
                ball.position,
                complex(dot(mirrored, ball.velocity), dot(complex(turn.imag, turn.real), ball.velocity)),
                ball.radius,
            )
            for ball in game.arena.balls
        ]
    )
    events.append(Event(EventKind.NUDGED, position=balls[0].position))
    arena = game.arena._replace(balls=balls)
    return game._replace(arena=arena, draws=game.draws + 1, idle=_IDLE_CONTACTS - _IDLE_STEP)


def _level_cleared(game: Game, events: list[Event]) -> Game:
    """The game after the last brick of a level."""
    game = game._replace(score=game.score + _POINTS_PER_LIFE * game.lives)
    events.append(Event(EventKind.LEVEL_CLEARED, points=_POINTS_PER_LIFE * game.lives))
    if game.number + 1 < len(game.levels):
        return _in_phase(game, Phase.CLEARED)
    events.append(Event(EventKind.GAME_WON))
    return _in_phase(game, Phase.WON)


def _without_lost_balls(game: Game, events: list[Event], *, give_up: bool) -> Game:
    """The game without the balls that left the ground or are given up: the last costs a life, the last life the game."""
    kept = [ball for ball in game.arena.balls if _outcome(game, ball) is not Outcome.GAME_OVER]
    staying = () if give_up else tuple(kept)
    if len(staying) == len(game.arena.balls):
        return game
    lost = [ball for ball in game.arena.balls if ball not in staying]
    events.extend([Event(EventKind.BALL_LOST, position=ball.position) for ball in lost])
    game = game._replace(arena=game.arena._replace(balls=staying))
    if staying:
        return game
    game = game._replace(lives=game.lives - 1, combo=0, idle=0)
    if game.lives == 0:
        events.append(Event(EventKind.GAME_OVER))
        return _in_phase(game, Phase.OVER)
    game = _in_phase(game, Phase.SERVING)
    return game._replace(arena=_with_served_ball(game, game.arena))


def _outcome(game: Game, ball: Ball) -> Outcome:
    """The source's broad phase: whether a ball has left the ground, and if not, what it may touch where it is."""
    rings = game.arena.rings
    return broad_phase_outcome(ball.position, ball.radius, game.level.ground_radius, rings[PADDLES], rings[PADDLES + 1 :])


def _in_phase(game: Game, phase: Phase) -> Game:
    """The game at the beginning of a phase."""
    return game._replace(phase=phase, phase_tick=0)
