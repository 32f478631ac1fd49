"""What there is to see at a moment between two ticks, in world units, whatever the view.

`alpha` says when: 0 just before the tick to 1 just after. Rings are turned to that moment; a ball is followed along its
path, around the bounces of the tick. Nothing here knows pixels: every camera draws the same scene.
"""

import cmath
import math
from typing import NamedTuple, TypedDict

from game.effects import Burst, EffectKind, Effects, FallingStack, Flash, Light, Pop, Recoil, Trail, Wave
from game.rules import BEST_COMBO, PADDLES, TICK, ActivePower, Drop, EventKind, Game, Phase, Ticked, held_balls, paddle_rings
from game.rules.turn import place_turn
from physics import Ball, Ring, Step, direction, signed_difference


class Aim(NamedTuple):
    """Where the ball to be served will go.

    origin: the ball's position. direction: unit.
    """

    origin: complex
    direction: complex


class Well(NamedTuple):
    """A gravity well.

    reach: how far it pulls, world units. strength: of its pull; below 0 it pushes.
    """

    position: complex
    reach: float
    strength: float


class Scene(NamedTuple):
    """Everything in the arena.

    ground_radius: world units. palette: name of the arena's colours. ground: name of its pattern.
    rings: all of them; ring 0 is the paddles.
    layers: per ring and slot, as in `physics.Arena`.
    tallest: per ring, layers of its highest stack when the level began.
    tints: per ring of bricks, as in `RingSpec.tints`.
    balls: those in play, or the one that waits for its serve.
    aim: of the ball that waits for its serve; else None.
    trails, flashes, pops, falling, bursts, recoils, waves: as in `Effects`.
    shaken: how far the picture is off, in ground radii, y upwards.
    heat: of the ball's trail: 0 to 1, by the bricks in a row.
    drops: power-ups on their way. powers: those that last now.
    shield: index of the shield's ring; None under rules without one. bumpers, growing: indices of rings that are bumpers, and
    of those that grow again.
    wells: of the level. core: share that is left of what a growing wall guards; None without such a wall.
    held_aims: where balls that stick to a paddle will go.
    clock: seconds, for what moves by itself; it stands still for players who want no such motion.
    lights, entry: as in `Effects`. shining: whether balls give light.
    second_paddle: index of the ring that is the second player's paddle, where two play against each other.
    """

    ground_radius: float
    palette: str
    ground: str
    rings: tuple[Ring, ...]
    layers: tuple[tuple[int, ...], ...]
    tallest: tuple[int, ...]
    balls: tuple[Ball, ...]
    trails: tuple[Trail, ...]
    aim: Aim | None
    flashes: tuple[Flash, ...]
    pops: tuple[Pop, ...]
    falling: tuple[FallingStack, ...]
    bursts: tuple[Burst, ...]
    recoils: tuple[Recoil, ...]
    waves: tuple[Wave, ...]
    shaken: complex
    heat: float
    drops: tuple[Drop, ...] = ()
    powers: tuple[ActivePower, ...] = ()
    shield: int | None = None
    bumpers: frozenset[int] = frozenset()
    growing: frozenset[int] = frozenset()
    wells: tuple[Well, ...] = ()
    core: float | None = None
    clock: float = 0.0
    held_aims: tuple[Aim, ...] = ()
    tints: tuple[tuple[int, ...], ...] = ()
    lights: tuple[Light, ...] = ()
    shining: bool = False
    entry: int | None = None
    second_paddle: int | None = None


def still(game: Game) -> Ticked:
    """A game as if a tick had just led to it: what is drawn before the first."""
    return Ticked(game, (), Step(game.arena, (), 0, 0), game.arena)


def scene_at(ticked: Ticked, alpha: float, effects: Effects) -> Scene:
    """The scene at a moment of the last tick. alpha: 0 before the tick to 1 after it."""
    game = ticked.game
    if _starts_afresh(ticked):
        rings, balls = game.arena.rings, game.arena.balls
    else:
        rings = _turned(ticked.moving.rings, game.arena.rings, alpha)
        balls = _balls_at(ticked, rings, alpha)
    return Scene(
        game.level.ground_radius,
        game.level.look.palette,
        game.level.look.ground,
        rings,
        game.arena.layers,
        _tallest(game),
        balls,
        effects.trails,
        _aim(game, balls),
        effects.flashes,
        effects.pops,
        effects.falling,
        effects.bursts,
        effects.recoils,
        effects.waves,
        0j if effects.shake is None else effects.shake.offset,
        min(game.combo / BEST_COMBO, 1.0),
        clock=(game.tick + alpha) * TICK if EffectKind.SWIRL in effects.steady else 0.0,
        lights=effects.lights,
        shining=EffectKind.LIGHTS in effects.steady,
        entry=effects.entry,
        tints=tuple([ring.tints() for ring in game.level.rings]),
        **_arcade(ticked, alpha),
    )


class _Arcade(TypedDict, total=False):
    """The fields of a scene that only the arcade rules fill."""

    drops: tuple[Drop, ...]
    powers: tuple[ActivePower, ...]
    shield: int
    bumpers: frozenset[int]
    growing: frozenset[int]
    wells: tuple[Well, ...]
    core: float | None
    held_aims: tuple[Aim, ...]
    second_paddle: int | None


def _arcade(ticked: Ticked, alpha: float) -> _Arcade:
    """What the arcade rules add to a scene."""
    game = ticked.game
    if not game.ruleset.arcade:
        return {}
    specs = game.level.rings
    growing = frozenset([k for k, spec in enumerate(specs, PADDLES + 1) if spec.regrow > 0.0])
    return {
        "drops": tuple([drop._replace(position=drop.position - drop.velocity * (1.0 - alpha) * TICK) for drop in game.drops]),
        "powers": game.powers,
        "shield": len(game.arena.rings) - 1,
        "bumpers": frozenset([k for k, spec in enumerate(specs, PADDLES + 1) if spec.bumper]),
        "growing": growing,
        "wells": tuple([Well(cmath.rect(w.distance, math.radians(w.angle)), w.reach, w.strength) for w in game.level.wells]),
        "core": _core(game, growing),
        "held_aims": _held_aims(game),
        "second_paddle": paddle_rings(game)[1] if game.ruleset.versus else None,
    }


def _held_aims(game: Game) -> tuple[Aim, ...]:
    """Where the balls that stick to a paddle will go: inward, turned by where they stick."""
    pairs = zip(game.held, held_balls(game), strict=True)
    aims = [(ball, direction(place_turn(game, held.offset, held.ring))) for held, ball in pairs]
    return tuple([Aim(ball.position, -ball.position / abs(ball.position) * turn) for ball, turn in aims])


def _core(game: Game, growing: frozenset[int]) -> float | None:
    """Share of the layers that is left of what growing walls guard; None where there is no such wall."""
    if not growing:
        return None
    guarded = [k for k in range(PADDLES + 1, len(game.level.rings) + 1) if k not in growing]
    full = sum([max(left, 0) for k in guarded for left in game.level.rings[k - 1].slots()])
    return sum([max(left, 0) for k in guarded for left in game.arena.layers[k]]) / max(full, 1)


def _tallest(game: Game) -> tuple[int, ...]:
    """Per ring, layers of its highest stack when the level began; paddles have none, the shield has one."""
    wall = [max(ring.slots()) for ring in game.level.rings]
    if not game.ruleset.arcade:
        return (0, *wall)
    return (0, *wall, 0, 1) if game.ruleset.versus else (0, *wall, 1)


def _starts_afresh(ticked: Ticked) -> bool:
    """Whether the moment before the tick is not to be shown: there is none, or it belongs to another level."""
    if ticked.game.tick == 0:
        return True
    return any([event.kind == EventKind.LEVEL_STARTED for event in ticked.events])


def _turned(before: tuple[Ring, ...], after: tuple[Ring, ...], alpha: float) -> tuple[Ring, ...]:
    """The rings at a moment of the tick; those at rest stay the very same values."""
    return tuple([old.turned(alpha * TICK) if old.spin else new for old, new in zip(before, after, strict=True)])


def _balls_at(ticked: Ticked, rings: tuple[Ring, ...], alpha: float) -> tuple[Ball, ...]:
    """The balls at a moment of the tick: on their paddle while they wait for the serve, else on their paths.

    rings: at that moment.
    """
    game = ticked.game

    def back(k: int) -> float:
        """How far a ring has still to turn until the tick's end, radians, clockwise."""
        return signed_difference(rings[k].phase, game.arena.rings[k].phase)

    if _rests(ticked):
        angle = back(paddle_rings(game)[game.server])
        return tuple([_about_origin(ball, angle) for ball in game.arena.balls])
    flying = [_on_its_path(ball, index, ticked, alpha) for index, ball in enumerate(ticked.moving.balls)]
    if not game.held:
        return tuple(flying)
    stuck = zip(game.held, held_balls(game), strict=True)
    on_paddles = [_about_origin(ball, back(held.ring)) for held, ball in stuck if held.ticks > 0]
    return (*flying, *on_paddles)  # one that was just caught is still seen flying


def _rests(ticked: Ticked) -> bool:
    """Whether the ball lay on its paddle at the end of the tick."""
    if ticked.game.phase == Phase.SERVING:
        return True
    return any([event.kind == EventKind.SERVED for event in ticked.events])


def _about_origin(ball: Ball, angle: float) -> Ball:
    """The ball and its velocity turned about the arena's centre."""
    turn = direction(angle)
    return Ball(ball.position * turn, ball.velocity * turn, ball.radius)


def _on_its_path(ball: Ball, index: int, ticked: Ticked, alpha: float) -> Ball:
    """A ball at a moment of the tick, after the bounces until then."""
    moment, clock = alpha * TICK, 0.0
    for hit in ticked.step.hits:
        if hit.ball != index or hit.time > moment:
            continue
        ball = Ball(ball.moved(hit.time - clock).position, hit.after, ball.radius)
        clock = hit.time
    return ball.moved(moment - clock)


def _aim(game: Game, balls: tuple[Ball, ...]) -> Aim | None:
    """The serve's direction while the ball waits for it."""
    if game.phase != Phase.SERVING or not balls:
        return None
    ball = balls[0]
    return Aim(ball.position, ball.velocity / abs(ball.velocity))
