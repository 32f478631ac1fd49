"""The source's whole game, one test a frame, beside the game with exact times of impact."""

import math
from typing import NamedTuple

from game.lab import source
from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line, source_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Pane, Picture, Role, Stroke, Toggle
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, contact, has_left, length, to_cartesian
from physics.time_of_impact import first_impact

_TICKS_PER_SECOND = round(1.0 / TICK)
_GROUND = 10.0
_LAYERS = 2
_BRICKS = Ring(4.0, 0.4, 0.26, 10, 0.15)
_TRAIL = 480
_RUN = 240
_SCALE = VELOCITY_SCALE / 2.0


class _BothGames(NamedTuple):
    """The same game twice.

    frames: of the source's game so far. theirs: the source's game. deepest: the largest overlap at one of its tests, world
    units. trail: the last positions of its ball, frame by frame.
    ours: the swept game. over: whether its ball has left. hits: its bounces. path: the last positions of its ball.
    """

    tick: int
    frames: int
    theirs: source.SourceGame
    deepest: float
    trail: tuple[complex, ...]
    ours: Arena
    over: bool
    hits: int
    path: tuple[complex, ...]


def _start(given: Given) -> _BothGames:
    """Three turning paddles, a ring of bricks, and the ball between them."""
    ball = Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), given.number("r"))
    paddles = Ring(8.6, 0.3, given.angle("half_angle"), 3, 0.4, given.number("spin"), given.number("mu"))
    layers, here = (_LAYERS,) * _BRICKS.count, (ball.position,)
    theirs = source.SourceGame(source.SourceBall(ball.position, ball.velocity), paddles, _BRICKS, layers)
    ours = Arena((ball,), (paddles, _BRICKS), ((PERMANENT,) * paddles.count, layers))
    return _BothGames(0, 0, theirs, 0.0, here, ours, False, 0, here)


def _step(given: Given, state: _BothGames) -> _BothGames:
    """A tick of our game later, and the next frame of the source's, when it is due."""
    state = _our_tick(given, state)._replace(tick=state.tick + 1)
    due = state.tick * given.count("rate") // _TICKS_PER_SECOND > state.frames
    return _their_frame(given, state) if due else state


def _our_tick(given: Given, state: _BothGames) -> _BothGames:
    """Our game one tick later; it stands still once the ball has left."""
    if state.over:
        return state
    step = advance(state.ours, TICK, given.number("speed"))
    ball = step.arena.balls[0]
    bounces = [hit.contact.point + hit.contact.normal * ball.radius for hit in step.hits]
    return state._replace(
        ours=step.arena,
        over=has_left(ball.position, ball.radius, _GROUND),
        hits=state.hits + len(step.hits),
        path=(*state.path, *bounces, ball.position)[-_TRAIL:],
    )


def _their_frame(given: Given, state: _BothGames) -> _BothGames:
    """The source's game one frame later."""
    r = given.number("r")
    after = source.game_frame(state.theirs, r, _GROUND, 1.0 / given.count("rate"), given.number("speed"))
    return state._replace(
        frames=state.frames + 1,
        theirs=after,
        deepest=max(state.deepest, -_least_gap(after.ball.position, r, after.paddles, after.layers)),
        trail=(*state.trail, after.ball.position)[-_TRAIL:],
    )


def _least_gap(p: complex, r: float, paddles: Ring, layers: tuple[int, ...]) -> float:
    """Between a ball and the nearest paddle or brick."""
    ball = Ball(p, 0j, r)
    gaps = [contact(ball, paddles, slot).gap for slot in range(paddles.count)]
    return min([*gaps, *[contact(ball, _BRICKS, slot).gap for slot in range(_BRICKS.count) if layers[slot]]])


def _picture(given: Given, state: _BothGames) -> Picture:
    """The source's game at the left, ours at the right."""
    theirs, ours = state.theirs, state.ours
    their_path = Line(state.trail, Role.SOURCE, Toggle.SWEPT, Stroke.DASHED)
    left = _marks(theirs.paddles, theirs.layers, Ball(theirs.ball.position, 0j, given.number("r")), their_path)
    right = _marks(ours.rings[0], ours.layers[1], ours.balls[0], Line(state.path, Role.OURS, Toggle.SWEPT))
    if state.tick == 0:
        start = Arrow(ours.balls[0].position, ours.balls[0].velocity * _SCALE, Role.PLAIN, label="v")
        left, right = (*left, start), (*right, start)
    rate = given.count("rate")
    panes = (
        Pane(left, f"the source, {rate} tests a second:   {_score(theirs.layers, over=theirs.over)}"),
        Pane(right, f"here:   {_score(ours.layers[1], over=state.over)}"),
    )
    return Picture(panes, _formula(given, state), _cited(state), _note(given, state))


def _marks(paddles: Ring, layers: tuple[int, ...], ball: Ball, path: Line) -> tuple[Mark, ...]:
    """The ground, the rings, the ball and its path."""
    return (
        Circle(0j, _GROUND, Role.FAINT),
        *ring_marks(paddles),
        *ring_marks(_BRICKS, layers, nearest=-1),
        path,
        Disc(ball.position, ball.radius, Role.BALL),
    )


def _score(layers: tuple[int, ...], *, over: bool) -> str:
    """The layers that are left, and whether the game is over."""
    return f"{sum(layers)} layers left{', game over' if over else ''}"


def _formula(given: Given, state: _BothGames) -> tuple[str, ...]:
    """How far the ball flies in a frame, and what both games have found so far."""
    r, speed, rate = given.number("r"), given.number("speed"), given.count("rate")
    return (
        f"a frame's flight:   v_0 / f = {speed:g} / {rate} = {speed / rate:.3f},   r = {r:g}",
        f"the source:   frame {state.frames},   deepest overlap at a test {state.deepest:.3f}",
        f"here:   bounces {state.hits},   no overlap at the end of any tick",
    )


def _cited(state: _BothGames) -> CitedLine:
    """The source's test, once it has found an overlap; before that, the sweep."""
    if state.deepest > 0.0:
        return source_line("Broad phase", "|p| + r ≥ r_p - w_p and |p| - r ≤ r_p + w_p")
    return code_line(first_impact, "impact = None if inward is None else _first_touch(ball, ring, inward, alive)")


def _note(given: Given, state: _BothGames) -> str:
    """What is happening."""
    if state.theirs.ball.velocity is None:
        return "The source's response has divided 0 by 0: its ball has no velocity any more."
    if state.theirs.over and not state.over:
        return "The source's game is over, ours goes on: the same start, but late bounces lead elsewhere."
    if state.deepest > given.number("r"):
        return "At a test the source's ball was deeper in a sector than its own radius: case 1 may then take the wrong face."
    if state.deepest > 0.0:
        return "The source finds a contact up to a frame late, when the ball overlaps. From there on the two games differ."
    return "Until the first contact both games are the same."


def _check(given: Given) -> tuple[Claim, ...]:
    """A second of both games."""
    state = _start(given)
    free = _least_gap(given.point("ball"), given.number("r"), state.theirs.paddles, state.theirs.layers) > 1e-6
    apart, still, single = math.inf, True, True
    for _ in range(_RUN):
        after = _step(given, state)
        if not after.over:
            ball = after.ours.balls[0]
            apart = min(apart, _least_gap(ball.position, ball.radius, after.ours.rings[0], after.ours.layers[1]))
        single &= 0 <= sum(state.theirs.layers) - sum(after.theirs.layers) <= 1
        still &= not state.theirs.over or after.theirs.ball == state.theirs.ball
        state = after
    speed = given.number("speed")
    velocity = state.theirs.ball.velocity
    return (
        Claim("our ball overlaps nothing at the end of any tick", not free or apart > -1e-9),
        Claim("our ball has the speed v_0", abs(length(state.ours.balls[0].velocity) - speed) < 1e-9),
        Claim(
            "the source's ball has the speed v_0, unless it divided 0 by 0",
            velocity is None or abs(length(velocity) - speed) < 1e-9,
        ),
        Claim("in a frame the source's ball breaks at most one layer", single),
        Claim("after game over the source's ball does not move", still),
    )


def _same(one: float, other: float) -> bool:
    """Equal but for rounding."""
    return abs(one - other) < 1e-9


SCENE = LabScene(
    name="source-game",
    title="The source's whole game against the swept one",
    idea="One test a frame finds every contact late, in an overlap, or not at all. Exact times of impact need no overlap.",
    functions=("broad_phase", "narrow_phase_case_1", "narrow_phase_case_2", "collision_response", "advance"),
    parameters=(
        Count("rate", "f", 5, 240, 30, "frames per second of the source's game"),
        Number("speed", "v_0", "", 1.0, 40.0, 16.0, 0.5, "the ball's fixed speed"),
        Point("ball", "p", -7.0, 7.0, 6.0 + 1.0j, meaning="the ball's centre at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 165.0, 0.5, "direction of v"),
        Number("r", "r", "", 0.1, 0.8, 0.35, 0.05, "the ball's radius"),
        Number("half_angle", "φ_p", "°", 5.0, 58.0, 35.0, 0.5, "half angle of the paddles"),
        Number("spin", "ω", "rad/s", -0.4, 0.4, 0.3, 0.05, "the paddles' spin"),
        Number("mu", "μ_p", "", 0.0, 1.0, 0.3, 0.05, "the paddles' friction"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), _SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
    ),
    view_box=ViewBox(0j, 10.8 + 10.8j),
    shows=Motion(_start, _step, _picture, ticks=960),
    check=_check,
    rows=(6,),
    presets=(
        Preset("30 tests a second", "rate=30"),
        Preset("60 tests a second", "rate=60"),
        Preset("240 tests a second", "rate=240"),
        Preset("fast and small: through the bricks", "rate=20&speed=40&r=0.1"),
        Preset("wide paddles", "half_angle=55&mu=1"),
    ),
)
