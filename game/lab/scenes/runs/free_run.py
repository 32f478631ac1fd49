"""Ours and another engine's ball from the same start: where do they part, and why?"""

import math
from itertools import pairwise
from typing import NamedTuple

from game.lab.kit import handles
from game.lab.kit.cited_line import CitedLine, code_line
from game.lab.kit.marks import VELOCITY_SCALE, ring_marks
from game.lab.kit.parameters import Count, Given, Number, Point
from game.lab.kit.picture import Arrow, Circle, Disc, Line, Mark, Picture, PointMark, Role, Stroke, Toggle, Words, single
from game.lab.kit.scene import Claim, Motion, Preset, Scene, ViewBox
from physics import PERMANENT, Arena, Ball, Ring, advance, contact, length, time_of_impact, to_cartesian

_TICK = 1.0 / 240.0
_TICKS = 480
_RADIUS = 0.4
_RINGS = (Ring(10.0, 0.3, math.pi, 1), Ring(4.5, 0.7, 0.6, 3, 0.5))
_LAYERS = tuple([(PERMANENT,) * ring.count for ring in _RINGS])
_TRAIL = 240
_MOST = 4
_RUN = 120


class _BothEngines(NamedTuple):
    """Our arena, the other engine's whole flight, and how far apart the two were after each bounce."""

    tick: int
    arena: Arena
    theirs: tuple[complex, ...]  # its ball tick by tick; empty without another engine
    trail: tuple[complex, ...]
    bounces: int
    apart: tuple[float, ...]  # at the end of the tick of bounce 1, 2, ...


def _ball(given: Given) -> Ball:
    """Where both begin."""
    return Ball(given.point("ball"), to_cartesian(given.number("speed"), given.angle("heading")), _RADIUS)


def _start(given: Given) -> _BothEngines:
    """Both engines at the same position; the other's flight is asked for at once."""
    return _BothEngines(0, _start_arena(given), _flight(given, _TICKS), (given.point("ball"),), 0, ())


def _start_arena(given: Given) -> Arena:
    """Where ours begins."""
    return Arena((_ball(given),), _RINGS, _LAYERS)


def _flight(given: Given, ticks: int) -> tuple[complex, ...]:
    """The other engine's ball at the end of every tick; nothing without one."""
    if given.engine is None:
        return ()
    steps = given.count("steps")
    positions = given.engine.flight(_ball(given), _RINGS, _TICK / steps, ticks * steps, given.count("chords"))
    return positions[::steps]


def _step(given: Given, state: _BothEngines) -> _BothEngines:
    """A tick later."""
    step = advance(state.arena, _TICK, given.number("speed"))
    ball, tick = step.arena.balls[0], state.tick + 1
    bounced = [hit.contact.point + hit.contact.normal * _RADIUS for hit in step.hits]
    apart = state.apart
    if step.hits and state.theirs:
        apart = (*apart, length(state.theirs[tick] - ball.position))
    trail = (*state.trail, *bounced, ball.position)[-_TRAIL:]
    return _BothEngines(tick, step.arena, state.theirs, trail, state.bounces + len(step.hits), apart)


def _picture(given: Given, state: _BothEngines) -> Picture:
    """Both balls and their ways."""
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
    """How far they are apart, and what a step of the other engine misses."""
    if given.engine is None or not state.theirs:
        return (f"tick {state.tick},   bounces {state.bounces}", "no second engine here: ours flies alone")
    name, steps, chords = given.engine.name, given.count("steps"), given.count("chords")
    deep = given.number("speed") * _TICK / steps
    sagitta = _RINGS[0].inner_radius * (1.0 - math.cos(math.pi / chords))
    apart = length(state.theirs[state.tick] - state.arena.balls[0].position)
    after = ",   ".join([f"{one:.4f}" for one in state.apart[:_MOST]])
    return (
        f"bounces {state.bounces};   |p - p_{name}| = {apart:.6f}",
        f"after bounce 1, 2, ...:   {after or 'none yet'}",
        f"{name} finds a contact after its step, up to v_0 dt = {deep:.4f} deep",
        f"its wall has {chords} chords, each up to {sagitta:.4f} inside of the arc",
    )


def _cited() -> CitedLine:
    """The exact moment, which the other engine does not look for."""
    return code_line(time_of_impact, "impact = _first_touch(ball, ring, stretch, alive)")


def _note(given: Given, state: _BothEngines) -> str:
    """Where and why they part."""
    if given.engine is None:
        return "There is no second engine in this lab, so there is nothing to compare with."
    if min(_gaps(_start_arena(given))) < 0.0:
        return "The ball starts in the material: ours is put outside at once, the other is pushed out step by step."
    if state.bounces == 0:
        return "In free flight both are the same."
    if state.theirs and length(state.theirs[state.tick] - state.arena.balls[0].position) > 1.0:
        return "Late contacts began it; every bounce off something round makes the difference larger, in any engine alike."
    return (
        "At the first bounce they part: a discrete step turns the ball round only after it has flown into the wall. "
        "So deep it meets several chords at once: finer chords alone do not help."
    )


def _check(given: Given) -> tuple[Claim, ...]:
    """Ours in half a second; the other engine until the first bounce."""
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
    way = sum([abs(there - here) for here, there in pairwise(state.trail)])
    whole = clear and len(state.trail) < _TRAIL
    return (
        Claim("ours flies v_0 dt in every tick, round its bounces, too", not whole or abs(way - speed * _RUN * _TICK) < 1e-9),
        Claim("ours overlaps nothing at the end of any tick", least > -1e-9),
        Claim("at the speed v_0", abs(length(state.arena.balls[0].velocity) - speed) < 1e-9),
        Claim("until the first bounce both fly alike", not clear or before < 1e-9),
        Claim("in the tick of that bounce they part by less than 2 v_0 dt", not clear or first < 2.0 * speed * _TICK + 1e-6),
    )


def _gaps(arena: Arena) -> list[float]:
    """Between the ball and every sector."""
    return [contact(arena.balls[0], ring, slot).gap for ring in arena.rings for slot in range(ring.count)]


SCENE = Scene(
    name="free-run",
    title="A free run beside pymunk",
    idea="Two engines, one start: they agree until the first bounce, which a discrete step finds late.",
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
        Preset("eight steps a tick: they part later", "steps=8"),
        Preset("finer chords alone do not help", "chords=512"),
        Preset("head-on, seen late", "ball=0,0&heading=35&speed=30"),
        Preset("round the wall: no chaos", "ball=7,-5&heading=80&steps=8&chords=256"),
    ),
)
