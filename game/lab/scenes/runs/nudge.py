"""A ball caught in a loop that meets no brick is nudged."""

import math
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import Deciding, code, source
from game.lab.kit.marks import ring_marks
from game.lab.kit.parameters import Count, Given, Number
from game.lab.kit.picture import Arrow, Circle, Disc, Dot, Line, Mark, Pane, Picture, Stroke, Toggle, Tone
from game.lab.kit.scene import Chapter, Claim, Motion, Preset, Scene, View
from game.levels import BallSpec, Level, PaddleSpec, RingSpec
from game.rules import TICK, Controls, EventKind, Game, Phase, new_game, tick
from physics import Arena, Ball, advance, cross, dot, length, to_cartesian

_GROUND, _RADIUS, _SCALE = 5.0, 0.3, 0.06
_BEFORE, _LEAST, _MOST = 12, math.radians(5.0), math.radians(20.0)
_TRAIL = 480
_RUN = 700


class _State(NamedTuple):
    """The source's arena, our game, and what was counted."""

    theirs: Arena
    game: Game
    bounces: int  # of the source's ball
    contacts: int  # of ours before the first nudge
    nudges: int
    turn: float  # radians, by the last nudge
    trail: tuple[complex, ...]  # of our ball
    their_trail: tuple[complex, ...]


def _start(given: Given) -> _State:
    """Two paddles opposite each other, and a brick that the loop between them does not meet."""
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
    return _State(game.arena, game, 0, 0, 0, 0.0, (ball.position,), (ball.position,))


def _step(given: Given, state: _State) -> _State:
    """A tick later."""
    step = advance(state.theirs, TICK, given.number("speed"))
    done = tick(state.game, Controls())
    balls, hits = done.game.arena.balls, done.step.hits
    nudged = [event.kind for event in done.events].count(EventKind.NUDGED)
    turn = _angle(done.step.arena.balls[0].velocity, balls[0].velocity) if nudged and balls else state.turn
    playing = done.game.phase == Phase.PLAYING
    return _State(
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
    """By how much a velocity was turned, radians."""
    return abs(math.atan2(cross(before, after), dot(before, after)))


def _picture(given: Given, state: _State) -> Picture:
    """The ball without nudges at the left, the game at the right."""
    theirs = _marks(state.theirs, state.their_trail, Tone.SOURCE)
    ours = _marks(state.game.arena, state.trail, Tone.OURS)
    panes = (
        Pane(theirs, f"without a nudge:   {state.bounces} bounces"),
        Pane(ours, f"here:   nudged {state.nudges} times"),
    )
    return Picture(panes, _formula(given, state), _deciding(state), _note(state))


def _marks(arena: Arena, trail: tuple[complex, ...], tone: Tone) -> tuple[Mark, ...]:
    """The ground, the rings, the ball and its way."""
    marks: list[Mark] = [Circle(0j, _GROUND, Tone.FAINT), *ring_marks(arena.rings[0])]
    marks += ring_marks(arena.rings[1], arena.layers[1], nearest=-1)
    marks.append(Line(trail, tone, Toggle.SWEPT))
    for ball in arena.balls:
        marks += [Disc(ball.position, ball.radius, Tone.BALL), Dot(ball.position, tone)]
        marks.append(Arrow(ball.position, ball.velocity * _SCALE, Tone.PLAIN, None, Stroke.SOLID))
    return tuple(marks)


def _formula(given: Given, state: _State) -> tuple[str, ...]:
    """The count that decides, and the chance."""
    turned = f"{math.degrees(state.turn):.2f}°" if state.nudges else "not yet"
    return (
        f"contacts since a brick was hit:   {state.game.idle} of {_BEFORE}",
        f"seed {given.count('seed')},   random numbers used: {state.game.draws}",
        f"the last nudge turned v by {turned},   always from 5° to 20°, to a side that chance decides",
    )


def _deciding(state: _State) -> Deciding:
    """The count, or the source's friction, which alone changes nothing here."""
    if state.nudges:
        return code(tick, "return _played(game, arena, give_up=controls.give_up)")
    return source("Collision response", "Δv'_t = -μ_p min{|Δv_n|, |Δv_t|} Δv_t / |Δv_t|")


def _note(state: _State) -> str:
    """What is to be seen."""
    if state.game.phase != Phase.PLAYING:
        return "The ball has left the ground between the paddles; the loop is over in any case."
    if state.nudges:
        return "Twelve contacts without a brick: the ball is turned a little, by the game's own seed; a replay does the same."
    return "To and fro for ever: nothing slides, so friction does nothing, and the ball meets no brick."


def _check(given: Given) -> tuple[Claim, ...]:
    """Three seconds of the game, twice."""
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
    place = state.theirs.balls[0].position
    return (
        Claim("the first nudge comes with the twelfth contact", met or not state.nudges or state.contacts == _BEFORE),
        Claim("it turns the ball by 5° to 20°", in_range),
        Claim("and leaves its speed alone", all([abs(length(b.velocity) - speed) < 1e-9 for b in state.game.arena.balls])),
        Claim("the same seed gives the same game to the last bit", state == again),
        Claim(
            "straight through the centre, the ball without a nudge stays on its line", not straight or abs(place.real) < 1e-9
        ),
    )


SCENE = Scene(
    name="nudge",
    title="The nudge",
    idea="Friction is the source's; but a ball that bounces on without meeting a brick is turned a little, by a seeded chance.",
    chapter=Chapter.RUNS,
    place=70,
    functions=("collision_response",),
    parameters=(
        Count("seed", "seed", 0, 999, 1, "of the game's chance"),
        Number("x", "p_x", "", -1.5, 1.5, 0.0, 0.05, "where the ball starts"),
        Number("heading", "ψ", "°", 60.0, 120.0, 90.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 5.0, 60.0, 40.0, 1.0, "the ball's fixed speed"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.5, 0.01, "the paddles' friction"),
    ),
    handles=(
        handles.Handle(
            "velocity",
            lambda given: given.number("x") + to_cartesian(given.number("speed") * _SCALE, given.angle("heading")),
            lambda given, place: {"heading": math.degrees(math.atan2(place.imag, place.real - given.number("x")))},
        ),
        handles.Handle("ball", lambda given: complex(given.number("x"), 0.0), lambda _, place: {"x": place.real}),
    ),
    view=View(0j, 5.6 + 5.6j),
    shows=Motion(_start, _step, _picture, ticks=960),
    check=_check,
    rows=(10,),
    presets=(
        Preset("on one line for ever", "x=0"),
        Preset("another seed", "seed=2"),
        Preset("slanting, rough paddles", "heading=80&mu=1"),
        Preset("slower", "speed=30"),
    ),
)
