"""Our ball and that of the second engine from the same start: when do their paths differ, and why?"""

import math
from itertools import pairwise
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Picture, PointMark, Role, Stroke, Toggle, Words, single
from game.lab.kit.scene import Claim, EngineUse, LabScene, Motion, Preset, ViewBox
from game.rules import TICK
from physics import PERMANENT, Arena, Ball, Ring, advance, contact, length, to_cartesian
from physics.time_of_impact import first_impact

_TICKS = 480
_RADIUS = 0.4
_RINGS = (Ring(10.0, 0.3, math.pi, 1), Ring(4.5, 0.7, 0.6, 3, 0.5))
_LAYERS = tuple([(PERMANENT,) * ring.count for ring in _RINGS])
_TRAIL = 240
_MOST = 4
_RUN = 120


class _BothEngines(NamedTuple):
    """Our arena, the second engine's whole flight, and how far apart both balls were after each bounce.

    theirs: the second engine's ball at each tick; empty without such an engine. trail: the last positions of ours.
    apart: distances at the end of the ticks of bounce 1, 2, ...
    """

    tick: int
    arena: Arena
    theirs: tuple[complex, ...]
    trail: tuple[complex, ...]
    bounces: int
    apart: tuple[float, ...]


def _ball(given: Given) -> Ball:
    """Where both begin."""
    return Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), _RADIUS)


def _start(given: Given) -> _BothEngines:
    """Both balls at the same position. The whole flight of the second engine is computed now."""
    return _BothEngines(0, _start_arena(given), _flight(given, _TICKS), (given.point("ball"),), 0, ())


def _start_arena(given: Given) -> Arena:
    """Where ours begins."""
    return Arena((_ball(given),), _RINGS, _LAYERS)


def _flight(given: Given, ticks: int) -> tuple[complex, ...]:
    """The second engine's ball at the end of every tick; empty without such an engine."""
    if given.engine is None:
        return ()
    steps = given.count("steps")
    positions = given.engine.flight(_ball(given), _RINGS, TICK / steps, ticks * steps, given.count("chords"))
    return positions[::steps]


def _step(given: Given, state: _BothEngines) -> _BothEngines:
    """A tick later."""
    step = advance(state.arena, TICK, given.number("speed"))
    ball, tick = step.arena.balls[0], state.tick + 1
    bounced = [hit.contact.point + hit.contact.normal * _RADIUS for hit in step.hits]
    apart = state.apart
    if step.hits and state.theirs:
        apart = (*apart, length(state.theirs[tick] - ball.position))
    trail = (*state.trail, *bounced, ball.position)[-_TRAIL:]
    return _BothEngines(tick, step.arena, state.theirs, trail, state.bounces + len(step.hits), apart)


def _picture(given: Given, state: _BothEngines) -> Picture:
    """Both balls and their paths."""
    ball = state.arena.balls[0]
    marks: list[Mark] = [*ring_marks(_RINGS[0], nearest=-1), *ring_marks(_RINGS[1])]
    marks.append(Circle(given.point("ball"), _RADIUS, Role.GHOST, None, Stroke.DASHED))
    if state.theirs:
        there = state.theirs[state.tick]
        marks.append(Line(state.theirs[max(0, state.tick - _TRAIL) : state.tick + 1], Role.PYMUNK, Toggle.SWEPT, Stroke.DASHED))
        marks += [Circle(there, _RADIUS, Role.PYMUNK, None, Stroke.THICK)]
    marks.append(Line(state.trail, Role.OURS, Toggle.SWEPT))
    marks += [Disc(ball.position, _RADIUS, Role.BALL), PointMark(ball.position, Role.OURS)]
    if state.theirs and length(state.theirs[state.tick] - ball.position) > 2.0 * _RADIUS:
        marks.append(Words(state.theirs[state.tick] + 0.8j, given.engine.name if given.engine else "", Role.PYMUNK))
        marks.append(Words(ball.position + 0.8j, "ours", Role.OURS))
    if state.tick == 0:
        marks.append(Arrow(ball.position, ball.velocity * VELOCITY_SCALE, Role.PLAIN, label="v"))
    return single(tuple(marks), _formula(given, state), _cited(), _note(given, state))


def _formula(given: Given, state: _BothEngines) -> tuple[str, ...]:
    """How far the balls are apart, and how inexact a step and a chord of the second engine are."""
    if given.engine is None or not state.theirs:
        return (f"tick {state.tick},   bounces {state.bounces}", "no second engine here: only our ball flies")
    name, steps, chords = given.engine.name, given.count("steps"), given.count("chords")
    deep = given.number("speed") * TICK / steps
    sagitta = _RINGS[0].inner_radius * (1.0 - math.cos(math.pi / chords))
    apart = length(state.theirs[state.tick] - state.arena.balls[0].position)
    after = ",   ".join([f"{one:.4f}" for one in state.apart[:_MOST]])
    return (
        f"bounces {state.bounces};   |p - p_{name}| = {apart:.6f}",
        f"after bounce 1, 2, ...:   {after or 'none yet'}",
        f"{name} finds a contact after its step, when the overlap is up to v_0 dt = {deep:.4f}",
        f"its wall has {chords} chords, each up to {sagitta:.4f} inside the arc",
    )


def _cited() -> CitedLine:
    """The line that computes the exact time, which the second engine does not."""
    return code_line(first_impact, "impact = None if inward is None else _first_touch(ball, ring, inward, alive)")


def _note(given: Given, state: _BothEngines) -> str:
    """When and why the paths differ."""
    if given.engine is None:
        return "The lab was opened without a second engine, so there is nothing to compare with."
    if min(_gaps(_start_arena(given))) < 0.0:
        return "The ball starts in the material: ours is put outside at once, the other one is pushed out step by step."
    if state.bounces == 0:
        return "In free flight both paths are the same."
    if state.theirs and length(state.theirs[state.tick] - state.arena.balls[0].position) > 1.0:
        return "Late contacts began the difference, and every bounce off a round surface makes it larger, in any engine."
    return (
        "The paths differ from the first bounce on: a discrete step reverses the ball only after it has entered the wall. "
        "There it overlaps several chords at once, so finer chords alone do not help."
    )


def _check(given: Given) -> tuple[Claim, ...]:
    """Half a second of our flight; the second engine's until the first bounce."""
    state, speed = _start(given)._replace(theirs=_flight(given, _RUN)), given.number("speed")
    clear = min(_gaps(state.arena)) > 1e-6
    least, before, first = math.inf, 0.0, 0.0
    for tick in range(1, _RUN + 1):
        after = _step(given, state)
        least = min(least, *_gaps(after.arena))
        apart = length(after.theirs[tick] - after.arena.balls[0].position) if after.theirs else 0.0
        if after.bounces == 0:
            before = max(before, apart)
        elif state.bounces == 0:
            first = apart
        state = after
    path = sum([abs(there - here) for here, there in pairwise(state.trail)])
    whole = clear and len(state.trail) < _TRAIL
    return (
        Claim("our path is v_0 dt long in every tick, bounces included", not whole or abs(path - speed * _RUN * TICK) < 1e-9),
        Claim("ours overlaps nothing at the end of any tick", least > -1e-9),
        Claim("our ball has the speed v_0", abs(length(state.arena.balls[0].velocity) - speed) < 1e-9),
        Claim("until the first bounce both paths are the same", not clear or before < 1e-9),
        Claim("in the tick of that bounce they differ by less than 2 v_0 dt", not clear or first < 2.0 * speed * TICK + 1e-6),
    )


def _gaps(arena: Arena) -> list[float]:
    """Between the ball and every sector."""
    return [contact(arena.balls[0], ring, slot).gap for ring in arena.rings for slot in range(ring.count)]


SCENE = LabScene(
    name="free-run",
    title="A free run beside pymunk",
    idea="Two engines agree until the first bounce, which the discrete steps of the second one find late.",
    functions=("advance", "time_of_impact"),
    parameters=(
        Count("steps", "k", 1, 8, 1, "pymunk's steps in a tick of 1/240 s"),
        Count("chords", "N", 24, 512, 64, "pymunk's chords for an arc"),
        Point("ball", "p", -9.0, 9.0, -6.5 + 3.0j, meaning="where both begin"),
        Number("heading", "ψ", "°", 0.0, 360.0, 300.0, 0.5, "direction of v"),
        Number("speed", "v_0", "", 1.0, 30.0, 14.0, 0.5, "the ball's speed"),
    ),
    handles=(
        handles.polar_vector("speed", "heading", lambda given: given.point("ball"), VELOCITY_SCALE, "velocity"),
        handles.point("ball", "ball"),
    ),
    view_box=ViewBox(0j, 10.6 + 10.6j),
    shows=Motion(_start, _step, _picture, ticks=_TICKS),
    check=_check,
    rows=(6,),
    presets=(
        Preset("one step a tick", "steps=1"),
        Preset("eight steps a tick: a smaller difference", "steps=8"),
        Preset("finer chords alone do not help", "chords=512"),
        Preset("head-on, found late", "ball=0,0&heading=35&speed=30"),
        Preset("along the wall: the difference stays small", "ball=7,-5&heading=80&steps=8&chords=256"),
    ),
    engine_use=EngineUse.ALWAYS,
)
