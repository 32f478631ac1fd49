"""The nudge: a ball that repeats a path without a brick is turned a little."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import ring_marks
from game.lab.kit.parameters import Count, Given, Number
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, PointMark, Role, Stroke, Toggle
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.levels import BallSpec, Level, PaddleSpec, RingSpec
from game.rules import TICK, Controls, EventKind, Game, Phase, new_game, tick
from game.rules.playing import played
from physics import Arena, Ball, advance, cross, dot, length, to_cartesian

_GROUND, _RADIUS, _SCALE = 5.0, 0.3, 0.06
_BEFORE, _LEAST, _MOST = 12, math.radians(5.0), math.radians(20.0)
_TRAIL = 480
_RUN = 700


class _NudgedGame(NamedTuple):
    """An arena without nudges, our game, and what was counted.

    bounces: of the ball without nudges. contacts: of ours before the first nudge. nudges: so far.
    turn: radians, by the last nudge. trail, their_trail: the last positions of our ball and of the other one.
    """

    theirs: Arena
    game: Game
    bounces: int
    contacts: int
    nudges: int
    turn: float
    trail: tuple[complex, ...]
    their_trail: tuple[complex, ...]


def _start(given: Given) -> _NudgedGame:
    """Two paddles opposite each other, and bricks that the path between them does not meet."""
    level = Level(
        "loop",
        _GROUND,
        BallSpec(_RADIUS, given.number("speed")),
        PaddleSpec(4.4, 0.2, 60.0, 90.0, 360.0, given.number("mu"), 2, 90.0),
        [RingSpec(2.4, 0.4, 16.0, 6, [9, 0, 0, 9, 0, 0])],
    )
    game = new_game((level,), given.count("seed"))
    ball = Ball(complex(given.number("x"), 0.0), to_cartesian(given.number("speed"), given.angle("heading")), _RADIUS)
    game = game._replace(phase=Phase.PLAYING, arena=game.arena._replace(balls=(ball,)))
    return _NudgedGame(game.arena, game, 0, 0, 0, 0.0, (ball.position,), (ball.position,))


def _step(given: Given, state: _NudgedGame) -> _NudgedGame:
    """A tick later."""
    step = advance(state.theirs, TICK, given.number("speed"))
    done = tick(state.game, Controls())
    balls, hits = done.game.arena.balls, done.step.hits
    nudged = [event.kind for event in done.events].count(EventKind.NUDGED)
    turn = _angle(done.step.arena.balls[0].velocity, balls[0].velocity) if nudged and balls else state.turn
    playing = done.game.phase == Phase.PLAYING
    return _NudgedGame(
        step.arena,
        done.game,
        state.bounces + len(step.hits),
        state.contacts + (0 if state.nudges else len(hits)),
        state.nudges + nudged,
        turn,
        (*state.trail, balls[0].position)[-_TRAIL:] if playing and balls else state.trail,
        (*state.their_trail, step.arena.balls[0].position)[-_TRAIL:],
    )


def _angle(before: complex, after: complex) -> float:
    """The angle between two velocities, radians."""
    return abs(math.atan2(cross(before, after), dot(before, after)))


def _picture(given: Given, state: _NudgedGame) -> Picture:
    """The ball without nudges at the left, the game at the right."""
    theirs = _marks(state.theirs, state.their_trail, Role.SOURCE)
    ours = _marks(state.game.arena, state.trail, Role.OURS)
    panes = (
        Pane(theirs, f"without a nudge:   {state.bounces} bounces"),
        Pane(ours, f"here:   nudged {state.nudges} times"),
    )
    return Picture(panes, _formula(given, state), _cited(state), _note(state))


def _marks(arena: Arena, trail: tuple[complex, ...], role: Role) -> tuple[Mark, ...]:
    """The ground, the rings, the ball and its path."""
    marks: list[Mark] = [Circle(0j, _GROUND, Role.FAINT), *ring_marks(arena.rings[0])]
    marks += ring_marks(arena.rings[1], arena.layers[1], nearest=-1)
    marks.append(Line(trail, role, Toggle.SWEPT))
    for ball in arena.balls:
        marks += [Disc(ball.position, ball.radius, Role.BALL), PointMark(ball.position, role)]
        marks.append(Arrow(ball.position, ball.velocity * _SCALE, Role.PLAIN, None, Stroke.SOLID))
    return tuple(marks)


def _formula(given: Given, state: _NudgedGame) -> tuple[str, ...]:
    """The count that decides, and the random numbers."""
    return (
        f"contacts since a brick was hit:   {state.game.idle} of {_BEFORE}",
        f"seed {given.count('seed')},   random numbers used: {state.game.draws}",
        _last_nudge(state),
    )


def _last_nudge(state: _NudgedGame) -> str:
    """By how much the last nudge turned the ball, and between which bounds."""
    bounds = "a nudge turns v by 5° to 20°, to a random side"
    return f"{bounds};   the last one by {math.degrees(state.turn):.2f}°" if state.nudges else f"{bounds};   none so far"


def _cited(state: _NudgedGame) -> CitedLine:
    """The line that nudges; before the first nudge, the source's friction, which changes nothing here."""
    if state.nudges:
        return code_line(played, "game = nudged(game, events)")
    return source_line("Collision response", "Δv'_t = -μ_p min{|Δv_n|, |Δv_t|} Δv_t / |Δv_t|")


def _note(state: _NudgedGame) -> str:
    """What is happening."""
    if state.game.phase != Phase.PLAYING:
        return "The ball has left the ground between the paddles, so the loop is over."
    if state.nudges:
        return "After twelve contacts without a brick the ball is turned a little. The seed decides, so a replay does the same."
    return "The ball repeats this path for ever: nothing slides, so friction does nothing, and there is no brick on the path."


def _check(given: Given) -> tuple[Claim, ...]:
    """About three seconds of the game, played twice."""
    state, again = _start(given), _start(given)
    in_range = True
    for _ in range(_RUN):
        after = _step(given, state)
        if after.nudges > state.nudges:
            in_range &= _LEAST - 1e-9 <= after.turn <= _MOST + 1e-9
        state = after
    for _ in range(_RUN):
        again = _step(given, again)
    speed = given.number("speed")
    met = any([layers not in {0, 9, -1} for ring in state.game.arena.layers for layers in ring])
    straight = given.number("x") == 0.0 and given.number("heading") in {90.0, 270.0}
    position = state.theirs.balls[0].position
    return (
        Claim("the first nudge comes with the twelfth contact", met or not state.nudges or state.contacts == _BEFORE),
        Claim("a nudge turns the ball by 5° to 20°", in_range),
        Claim(
            "the nudge does not change the speed", all([abs(length(b.velocity) - speed) < 1e-9 for b in state.game.arena.balls])
        ),
        Claim("the same seed gives the same game to the last bit", state == again),
        Claim(
            "straight through the centre, the ball without a nudge stays on its line", not straight or abs(position.real) < 1e-9
        ),
    )


SCENE = LabScene(
    name="nudge",
    title="The nudge",
    idea="A ball that bounces on without meeting a brick is turned a little, by the game's seeded random numbers.",
    functions=("collision_response",),
    parameters=(
        Count("seed", "seed", 0, 999, 1, "of the random numbers"),
        Number("x", "p_x", "", -1.5, 1.5, 0.0, 0.05, "where the ball starts"),
        Number("heading", "ψ", "°", 60.0, 120.0, 90.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 5.0, 60.0, 40.0, 1.0, "the ball's fixed speed"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "the paddles' friction"),
    ),
    handles=(
        handles.Handle(
            "velocity",
            lambda given: given.number("x") + to_cartesian(given.number("speed") * _SCALE, given.angle("heading")),
            lambda given, position: {"heading": math.degrees(math.atan2(position.imag, position.real - given.number("x")))},
        ),
        handles.Handle("ball", lambda given: complex(given.number("x"), 0.0), lambda _, position: {"x": position.real}),
    ),
    view_box=ViewBox(0j, 5.6 + 5.6j),
    shows=Motion(_start, _step, _picture, ticks=960),
    check=_check,
    rows=(10,),
    presets=(
        Preset("through the centre for ever", "x=0"),
        Preset("another seed", "seed=2"),
        Preset("slanting, rough paddles", "heading=80&mu=1"),
        Preset("slower", "speed=30"),
    ),
)
