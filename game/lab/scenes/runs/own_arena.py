"""An arena of one's own: every number of its rings can be set, and a ball flies in it. It is saved as a level of the game."""

from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.arena_level import ARENA, rings_of, saved_arena
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.handles import Handle
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number, Parameter, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Picture, PointMark, Role, Toggle, single
from game.lab.kit.scene import Claim, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, has_left, length, to_cartesian

_TRAIL = 240
"""Ticks whose positions are drawn."""
_RUN = 40
"""Ticks that a check flies."""


class _OwnFlight(NamedTuple):
    """The arena, the ball's last positions, and what has happened so far.

    over: whether the ball has left the ground; it rests from then on.
    """

    arena: Arena
    trail: tuple[complex, ...]
    bounces: int
    broken: int
    over: bool


def _start(given: Given) -> _OwnFlight:
    """The ball at its start, every brick whole."""
    ball = Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), given.number("r"))
    rings = rings_of(given)
    layers = tuple([(PERMANENT if number == 0 else given.count(f"l_{number}"),) * ring.count for number, ring in rings.items()])
    return _OwnFlight(Arena((ball,), tuple(rings.values()), layers), (ball.position,), 0, 0, over=False)


def _step(given: Given, state: _OwnFlight) -> _OwnFlight:
    """A tick of the game's physics; the rules of paddles, lives and serves are left out."""
    if state.over:
        return state
    step = advance(state.arena, TICK, given.number("speed"))
    ball = step.arena.balls[0]
    broken = len([hit for hit in step.hits if hit.layers != PERMANENT])
    return _OwnFlight(
        step.arena,
        (*state.trail, ball.position)[-_TRAIL:],
        state.bounces + len(step.hits),
        state.broken + broken,
        over=has_left(ball.position, ball.radius, given.number("r_g")),
    )


def _picture(given: Given, state: _OwnFlight) -> Picture:
    """The ground, the rings with the bricks that are left, and the ball with its trail."""
    ball = state.arena.balls[0]
    marks: list[Mark] = [Circle(0j, given.number("r_g"), Role.PLAIN)]
    for number, (ring, layers) in enumerate(zip(state.arena.rings, state.arena.layers, strict=True)):
        marks += ring_marks(ring, layers, None if number == 0 else -1)
    marks += [Line(state.trail, Role.GHOST, Toggle.SWEPT), Disc(ball.position, ball.radius, Role.BALL)]
    marks += [PointMark(ball.position, Role.PLAIN), Arrow(ball.position, ball.velocity * VELOCITY_SCALE, Role.PLAIN, label="v")]
    left = sum([layer for ring in state.arena.layers for layer in ring if layer > 0])
    formula = (
        f"|p| = {length(ball.position):.3f},   r_g + r = {given.number('r_g') + ball.radius:g}",
        f"bounces: {state.bounces},   layers broken: {state.broken},   layers left: {left}",
    )
    return single(tuple(marks), formula, _cited(), _note(given, state))


def _cited() -> CitedLine:
    """The line that flies the ball."""
    return code_line(advance, "return _flown(free, _moved_balls(arena, free), dt, speed)")


def _note(given: Given, state: _OwnFlight) -> str:
    """Whether the game would take it as a level."""
    if state.over:
        return "The ball has left the ground."
    saved = saved_arena(given)
    return f"No level yet: {saved.problem}" if saved.problem else "W saves it as a level of the game."


def _check(given: Given) -> tuple[Claim, ...]:
    """A few ticks, and the level file."""
    state = _start(given)
    before = [sum(layers) for layers in state.arena.layers]
    for _ in range(_RUN):
        state = _step(given, state)
    after = [sum(layers) for layers in state.arena.layers]
    saved, rings = saved_arena(given), rings_of(given)
    same = saved.problem or [_sizes(ring) for ring in saved.rings] == [_sizes(ring) for ring in rings.values()]
    return (
        Claim("the ball has the speed v_0", abs(length(state.arena.balls[0].velocity) - given.number("speed")) < 1e-9),
        Claim("no layer grows", all([late <= early for early, late in zip(before, after, strict=True)])),
        Claim("the level file has the same rings, or a rule of levels says why there is none", bool(same)),
    )


def _sizes(ring: Ring) -> tuple[float, ...]:
    """What a level says of a ring, rounded: its file is in degrees."""
    return tuple([round(size, 9) for size in (ring.radius, ring.half_width, ring.half_angle, ring.count, ring.phase)])


def _radius(number: int, angle: float) -> Handle:
    """A ring's middle radius, dragged along a bearing."""
    name = "r_p" if number == 0 else f"r_{number}"
    return Handle(name, lambda given: to_cartesian(given.number(name), angle), lambda _, target: {name: length(target)})


def _ring_parameters(number: int, count: int, radius: float) -> tuple[Parameter, ...]:
    """The numbers of one ring of bricks."""
    return (
        Count(f"n_{number}", f"n_{number}", 0, 60, count, "bricks in this ring; 0: no ring"),
        Number(f"r_{number}", f"r_{number}", "", 1.0, 14.0, radius, 0.1, "its middle radius"),
        Number(f"w_{number}", f"w_{number}", "", 0.05, 2.0, 0.5, 0.05, "its half width"),
        Number(f"f_{number}", f"f_{number}", "", 0.05, 1.0, 0.9, 0.05, "share of it that is filled"),
        Number(f"s_{number}", f"ω_{number}", "°/s", -90.0, 90.0, 0.0, 1.0, "its spin"),
        Count(f"l_{number}", f"l_{number}", 1, 9, 1, "layers of each brick"),
    )


SCENE = LabScene(
    name=ARENA,
    title="An arena of your own",
    idea="Set the rings, let a ball fly, and save what you have built: the share line is the arena, W makes it a level.",
    functions=("advance",),
    parameters=(
        Number("r_g", "r_g", "", 5.0, 15.0, 12.0, 0.1, "the ground's radius"),
        Number("r", "r", "", 0.1, 1.5, 0.4, 0.05, "the ball's radius"),
        Number("speed", "v_0", "", 1.0, 20.0, 9.0, 0.5, "the ball's fixed speed"),
        Point("ball", "p", -14.0, 14.0, 0.5 - 8j, meaning="the ball's centre at first"),
        Number("heading", "ψ", "°", 0.0, 360.0, 80.0, 0.5, "direction of v at first"),
        Count("n_p", "n_p", 1, 12, 3, "paddles"),
        Number("r_p", "r_p", "", 2.0, 14.5, 11.0, 0.1, "their middle radius"),
        Number("w_p", "w_p", "", 0.05, 2.0, 0.3, 0.05, "their half width"),
        Number("h_p", "φ_p", "°", 1.0, 180.0, 40.0, 0.5, "half angle of one"),
        Number("s_p", "ω_p", "°/s", -90.0, 90.0, 20.0, 1.0, "their spin"),
        *_ring_parameters(1, 12, 5.0),
        *_ring_parameters(2, 8, 3.0),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), VELOCITY_SCALE, "velocity"),
        handles.point("ball", "ball", "r"),
        _radius(0, 0.35),
        _radius(1, 0.0),
        _radius(2, 0.0),
    ),
    view_box=ViewBox(0j, 13.0 + 12.6j),
    shows=Motion(_start, _step, _picture, ticks=2400),
    check=_check,
    presets=(
        Preset("two rings", "heading=80"),
        Preset("turning rings", "s_1=30&s_2=-40&l_1=2"),
        Preset("one closed ring", "n_1=1&f_1=1&l_1=9&n_2=0"),
        Preset("a wall of sixty", "n_1=60&r_1=6&w_1=0.4&f_1=0.8&n_2=30&r_2=4.5&w_2=0.4&f_2=0.8&r=0.25"),
        Preset("no ring at all", "n_1=0&n_2=0&s_p=0"),
    ),
)
