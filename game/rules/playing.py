"""A tick with balls in play: the physics, then what its hits mean, then who has left."""

import math

from game.rules.crumbling import crumbled
from game.rules.drops import drifted
from game.rules.meeting import met
from game.rules.nudging import IDLE_CONTACTS, nudged
from game.rules.pierce import is_piercing, pierced, with_bricks, without_bricks
from game.rules.powers import one_tick_later, with_caught
from game.rules.regrow import regrown, reversed_rings
from game.rules.scoring import credited, with_extra_lives, with_result
from game.rules.serving import before_serve
from game.rules.shape import shaped
from game.rules.speed import with_speed_now
from game.rules.state import (
    PADDLES,
    POINTER_STEPS,
    TICK,
    Advance,
    Controls,
    Event,
    EventKind,
    Game,
    Phase,
    Ticked,
    counted,
    held_balls,
    in_phase,
    one_tick_on,
    wall_layers,
)
from game.rules.turn import paddle_hits_answered, released
from game.rules.versus import with_lost_ball
from game.rules.wells import pulled
from physics import Arena, Ball, Step, broad_phase_outcome
from physics.broad_phase import GAME_OVER
from physics.shapes import unchecked


def played(game: Game, moving: Arena, controls: Controls, advance: Advance) -> Ticked:
    """A tick with balls in play. moving: the arena with the paddles' new spin."""
    arcade, speed, score = game.ruleset.arcade, game.speed, game.score
    piercing = arcade and is_piercing(game)
    flown = without_bricks(moving) if piercing else moving
    step = advance(flown, TICK, speed, game.flight)
    arena, hits, _, _, flight = step
    if piercing:
        arena = with_bricks(arena, moving)
    game = one_tick_on(game, arena, flight, game.waited + 1 if arcade else 0)
    events: list[Event] = []
    for hit in hits:
        game = credited(game, hit, events)
    if arcade:
        game = _by_arcade_rules(game, controls, step, flown, events)
        game = with_extra_lives(game, score, events)
    if game.idle >= IDLE_CONTACTS:
        game = nudged(game, events)
    if (hits or arcade) and game.arena.layers is not moving.layers and _all_broken(game):
        game = _level_cleared(game, events)
    else:
        game = _without_lost_balls(game, events, controls)
    return unchecked(Ticked, (game, tuple(events), step, flown, speed))


def _by_arcade_rules(game: Game, controls: Controls, step: Step, flown: Arena, events: list[Event]) -> Game:
    """What the arcade rules do after the flight of a tick, in this order. flown: the arena before it, as the physics had it."""
    if is_piercing(game):
        game = pierced(game, events)
    held = game.held
    if step.hits:
        game = paddle_hits_answered(game, flown, step, events)
    if held:
        aim = None if controls.aim is None else controls.aim * (math.tau / POINTER_STEPS)
        game = released(game, events, serve=controls.serve, aim=aim)
    game = met(pulled(game), events)
    game, caught = drifted(game, events)
    game = with_caught(game, caught, events)
    game = one_tick_later(game, events)
    game = reversed_rings(regrown(shaped(game), events))
    game = crumbled(game, events)
    return with_speed_now(game, events)


def _all_broken(game: Game) -> bool:
    """Whether no brick of the level is left."""
    return not any([layers > 0 for ring in wall_layers(game) for layers in ring])


def _level_cleared(game: Game, events: list[Event]) -> Game:
    """The game after the last brick of a level."""
    before = game.score
    game = with_result(game, events)._replace(drops=(), held=())
    if game.ruleset.arcade:
        game = with_extra_lives(game, before, events)
    if game.number + 1 < len(game.levels):
        return in_phase(game, Phase.CLEARED)
    events.append(Event(EventKind.GAME_WON))
    return in_phase(game, Phase.WON)


def _without_lost_balls(game: Game, events: list[Event], controls: Controls) -> Game:
    """The game without the balls that left the ground or are given up: the last costs a life, the last life the game.

    The source's broad phase says whether a ball has left, and if not, what it may touch where it is.
    """
    balls, rings, _ = game.arena
    paddles, bricks, ground_radius = rings[PADDLES], rings[PADDLES + 1 :], game.levels[game.number].ground_radius
    lost: tuple[Ball, ...] = ()
    for ball in balls:
        if broad_phase_outcome(ball[0], ball[2], ground_radius, paddles, bricks) is GAME_OVER:
            lost += (ball,)
    if controls.give_up:
        lost = (*balls, *held_balls(game))
    if not lost:
        return game
    staying = tuple([ball for ball in balls if ball not in lost])
    events.extend([Event(EventKind.BALL_LOST, position=ball.position) for ball in lost])
    game = game._replace(arena=game.arena._replace(balls=staying), held=() if controls.give_up else game.held)
    if staying or game.held:
        return game
    game = counted(game._replace(combo=0, idle=0), balls_lost=1)
    game = with_lost_ball(game, lost[-1].position) if game.sides else game._replace(lives=game.lives - 1)
    if game.lives == 0:
        events.append(Event(EventKind.GAME_OVER))
        return in_phase(game._replace(drops=()), Phase.OVER)
    return before_serve(game)
