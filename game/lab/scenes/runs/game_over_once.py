"""Game over: the source's rule holds in every frame after the ball has left; here it counts once."""

from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, PointMark, Role, Stroke, Toggle
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.levels import BallSpec, Level, PaddleSpec, RingSpec
from game.rules import LIVES, PADDLES, TICK, Controls, EventKind, Game, Phase, new_game, tick
from physics import Ball, has_left, length, to_cartesian

_GROUND = 5.0
_SEED = 1
_TRAIL = 240
_RUN = 400


class _BothRules(NamedTuple):
    """The source's ball, our game, and what was counted.

    theirs: position of the source's ball. over: ticks in which the source's rule holds. lost: balls lost in our game.
    ended: times our game ended. trail: the last positions of our ball in this life.
    """

    theirs: complex
    over: int
    game: Game
    lost: int
    ended: int
    trail: tuple[complex, ...]


def _level(given: Given) -> Level:
    """One short paddle, and one brick that the ball hardly meets: every ball is lost in the end."""
    return Level(
        "lost",
        _GROUND,
        BallSpec(given.number("r"), given.number("speed")),
        PaddleSpec(4.4, 0.2, given.number("half_angle"), 90.0, 360.0, 0.0, 1, 270.0),
        [RingSpec(0.9, 0.2, 20.0, 4, [1, 0, 0, 0])],
    )


def _ball(given: Given) -> Ball:
    """The first ball."""
    return Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), given.number("r"))


def _start(given: Given) -> _BothRules:
    """A game with its first ball in flight."""
    game, ball = new_game((_level(given),), _SEED), _ball(given)
    game = game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(ball,)))
    return _BothRules(ball.position, 0, game, 0, 0, (ball.position,))


def _step(given: Given, state: _BothRules) -> _BothRules:
    """A tick later. After a lost ball the next one is served at once."""
    theirs = state.theirs + _ball(given).velocity * TICK
    before = state.game
    done = tick(before, Controls(serve=before.phase == Phase.SERVING))
    kinds = [event.kind for event in done.events]
    balls = done.game.arena.balls
    trail = (*state.trail, *[ball.position for ball in balls])[-_TRAIL:] if done.game.phase == Phase.PLAYING else ()
    return _BothRules(
        theirs,
        state.over + has_left(theirs, given.number("r"), _GROUND),
        done.game,
        state.lost + kinds.count(EventKind.BALL_LOST),
        state.ended + kinds.count(EventKind.GAME_OVER),
        trail,
    )


def _picture(given: Given, state: _BothRules) -> Picture:
    """The source's ball flies on; ours is replaced, as long as there are lives."""
    r, ball = given.number("r"), _ball(given)
    ground = Circle(0j, _GROUND, Role.PLAIN, None, Stroke.THICK)
    first = (
        Circle(ball.position, r, Role.GHOST, None, Stroke.DASHED),
        Arrow(ball.position, ball.velocity * VELOCITY_SCALE, Role.PLAIN, label="v"),
    )
    theirs: list[Mark] = [ground, *first, Line((ball.position, state.theirs), Role.SOURCE, Toggle.SWEPT, Stroke.DASHED)]
    theirs += [Disc(state.theirs, r, Role.BALL), PointMark(state.theirs, Role.SOURCE)]
    rings, layers = state.game.arena.rings, state.game.arena.layers
    ours: list[Mark] = [ground, *ring_marks(rings[PADDLES]), *ring_marks(rings[1], layers[1])]
    ours += [*first, Line(state.trail, Role.OURS, Toggle.SWEPT)]
    ours += [
        mark
        for one in state.game.arena.balls
        for mark in (Disc(one.position, r, Role.BALL), PointMark(one.position, Role.OURS))
    ]
    panes = (
        Pane(tuple(theirs), f"the source:   game over {state.over} times"),
        Pane(tuple(ours), f"here:   lives {state.game.lives},   game over {state.ended} times"),
    )
    return Picture(panes, _formula(given, state), _cited(state), _note(state))


def _formula(given: Given, state: _BothRules) -> tuple[str, ...]:
    """The rule with its numbers, and the counts."""
    distance, r = length(state.theirs), given.number("r")
    left, phase = distance - r > _GROUND, state.game.phase.name.lower()
    return (
        f"the source:   |p| - r = {distance:.3f} - {r:g} = {distance - r:.3f} {'>' if left else '≤'} r_g = {_GROUND:g}",
        f"here:   balls lost {state.lost},   lives {LIVES} - {state.lost} = {state.game.lives},   {phase}",
    )


def _cited(state: _BothRules) -> CitedLine:
    """The rule."""
    if state.lost:
        return code_line(has_left, "return length(p) - ball_radius > ground_radius")
    return source_line("Broad phase", "if |p| - r > r_g then GAME OVER")


def _note(state: _BothRules) -> str:
    """What is happening."""
    if state.ended:
        return "The last life is gone: the game has ended once, and no ball is left that could be lost."
    if state.over and not state.lost:
        return "The source's game is over. Ours goes on, since its paddle has hit the ball."
    if state.lost:
        return "A ball that has left is removed and costs one life. The source's rule holds again in every frame."
    return "Nothing has left the ground yet."


def _check(given: Given) -> tuple[Claim, ...]:
    """Five thirds of a second of the game."""
    state = _start(given)
    counted, lower, ends, moment = True, True, True, True
    for _ in range(_RUN):
        after = _step(given, state)
        counted &= after.game.lives + after.lost == LIVES
        lower &= state.game.lives - after.game.lives in {0, 1}
        ends &= (after.ended == 1) == (after.game.lives == 0) == (after.game.phase == Phase.OVER)
        if after.lost > state.lost:
            there = state.game.arena.balls[0].moved(TICK)
            moment &= length(there.position) - there.radius > _GROUND - 1e-9
        state = after
    return (
        Claim("every ball that is lost costs one life", counted),
        Claim("no tick costs two", lower),
        Claim("the game is over once, exactly when no life is left", ends),
        Claim("a ball is lost where |p| - r > r_g", moment),
        Claim("no ball in play is out of the ground", all([not _is_out(ball) for ball in state.game.arena.balls])),
    )


def _is_out(ball: Ball) -> bool:
    """Whether a whole ball is outside of the ground."""
    return length(ball.position) - ball.radius > _GROUND


SCENE = LabScene(
    name="game-over-once",
    title="Game over, once",
    idea="The source's rule holds in every frame after the ball has left. Here it costs one life; the last one ends the game.",
    functions=("has_left",),
    parameters=(
        Point("ball", "p", -4.0, 4.0, 1.5 + 1.0j, meaning="the first ball's centre"),
        Number("heading", "ψ", "°", 0.0, 360.0, 40.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 2.0, 30.0, 14.0, 0.5, "the ball's fixed speed"),
        Number("r", "r", "", 0.1, 0.6, 0.3, 0.05, "the ball's radius"),
        Number("half_angle", "φ_p", "°", 5.0, 60.0, 15.0, 0.5, "half angle of the only paddle"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), VELOCITY_SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
    ),
    view_box=ViewBox(0j, 6.8 + 6.8j),
    shows=Motion(_start, _step, _picture, ticks=480),
    check=_check,
    rows=(9,),
    presets=(
        Preset("out at once", "heading=40"),
        Preset("hit by the paddle", "ball=0.5,0&heading=268&half_angle=30"),
        Preset("a small fast ball", "speed=30&r=0.1"),
    ),
)
