"""What makes a level one that can be played: every rule that a file may break, and what is allowed and yet tedious."""

import itertools
import math
from collections.abc import Iterator
from typing import Any

import msgspec

from game.level_format.arcade_checks import arcade_warnings, broken_arcade_rules
from game.level_format.specs import BallSpec, Level, RingSpec
from physics import PERMANENT
from physics.tolerances import MAX_IMPACTS

_MAX_BRICKS = 5000
_LEAST_PLAY = 1e-3
"""Of the ball's radius: what a lane or a gate must at least be wider than the ball. In less it bounces on the spot."""
_TICKS_PER_SECOND = 240.0
_EASY_GATE = 1.5
"""Diameters of the ball: a ball finds through a narrower gate only by luck, and may stay behind it for minutes."""
_LEAST_BALL = 1e-3
"""Of the ground's radius: a smaller ball cannot be seen."""
_LONGEST_CROSSING = 60.0
"""Seconds that a ball may take across the ground; nobody waits for a slower one."""


def warnings(level: Level) -> list[str]:
    """What is allowed in a level and yet makes it tedious to play: key and reason, a line each."""
    widths = [(number, _widest_gate(ring)) for number, ring in enumerate(level.rings)]
    across = 2.0 * level.ball.radius
    return [
        f"rings[{number}]: its widest gate is {width / across:.3g} balls wide; the ball may stay behind it for minutes "
        f"where a gate is narrower than {_EASY_GATE}"
        for number, width in widths
        if width is not None and across < width < _EASY_GATE * across
    ] + arcade_warnings(level)


def broken_rules(level: Level) -> Iterator[tuple[str, str]]:
    """(key, rule) of every rule of a possible arena that the level breaks."""
    numbers_fine = True
    for key, value in _numbers(msgspec.to_builtins(level)):
        if not math.isfinite(value):
            numbers_fine = False
            yield key, f"must be finite, not {value}"
    if not numbers_fine:
        return
    yield from _broken_track_rules(level)
    for number, ring in enumerate(level.rings):
        yield from _broken_ring_rules(f"rings[{number}]", ring, level)
    yield from _broken_wall_rules(level)
    yield from broken_arcade_rules(level)


def _numbers(value: Any, key: str = "") -> Iterator[tuple[str, float]]:
    """Every number in nested tables with its key."""
    if isinstance(value, dict):
        for name, item in value.items():
            yield from _numbers(item, f"{key}.{name}" if key else name)
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _numbers(item, f"{key}[{index}]")
    elif isinstance(value, int | float):
        yield key, value


def _broken_track_rules(level: Level) -> Iterator[tuple[str, str]]:
    """Rules of the ground, the ball and the paddles."""
    paddles, speed, ground = level.paddles, level.ball.speed, level.ground_radius
    outer = paddles.radius + paddles.half_width
    if level.ball.radius < _LEAST_BALL * ground:
        yield "ball.radius", f"must be at least {_LEAST_BALL:g} of ground_radius, {_LEAST_BALL * ground:g}"
    if speed < 2.0 * ground / _LONGEST_CROSSING:
        slowest = 2.0 * ground / _LONGEST_CROSSING
        yield "ball.speed", f"must be at least {slowest:.4g}, to cross the ground in {_LONGEST_CROSSING:g} s"
    if outer > level.ground_radius:
        yield "paddles.radius", f"the paddles reach to {outer:g}, beyond ground_radius {level.ground_radius:g}"
    if paddles.half_width >= paddles.radius:
        yield "paddles.half_width", f"must be below paddles.radius {paddles.radius:g}"
    if paddles.half_angle * paddles.count >= 180.0:
        yield "paddles.half_angle", f"{paddles.count} paddles must leave gaps: below {180.0 / paddles.count:g} degrees"
    fastest = math.degrees(speed / outer)
    if paddles.top_speed >= fastest:
        yield "paddles.top_speed", f"must be below the ball's, {fastest:.4g} degrees per second at the paddles' outer radius"


def _broken_ring_rules(key: str, ring: RingSpec, level: Level) -> Iterator[tuple[str, str]]:
    """Rules of one ring of bricks."""
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    if inner <= 0.0:
        yield f"{key}.half_width", f"must be below the ring's radius {ring.radius:g}"
    if ring.half_angle * ring.count > 180.0 * (1.0 + 1e-12):
        yield f"{key}.half_angle", f"bricks overlap; at most {180.0 / ring.count:g} degrees for {ring.count} of them"
    if isinstance(ring.layers, list) and len(ring.layers) != ring.count:
        yield f"{key}.layers", f"must have one number per slot, {ring.count}, not {len(ring.layers)}"
    if math.radians(abs(ring.spin)) * outer >= level.ball.speed:
        fastest = math.degrees(level.ball.speed / outer)
        yield f"{key}.spin", f"must be below the ball's speed, {fastest:.4g} degrees per second at the ring's outer radius"
    track = level.paddles.radius - level.paddles.half_width
    if outer + 2.0 * level.ball.radius + least_play(level.ball) >= track:
        yield (
            f"{key}.radius",
            f"reaches to {outer:g}; the ball ({2.0 * level.ball.radius:g} across) must fit below the paddles' track {track:g}",
        )


def _broken_wall_rules(level: Level) -> Iterator[tuple[str, str]]:
    """Rules that concern the rings together: no overlap, something to break, everything within reach."""
    bricks = sum([layers > 0 for ring in level.rings for layers in ring.slots()])
    if bricks == 0:
        yield "rings", "no bricks to break"
    if bricks > _MAX_BRICKS:
        yield "rings", f"{bricks} bricks; at most {_MAX_BRICKS}"
    outside_in = sorted(enumerate(level.rings), key=lambda pair: -pair[1].radius)
    for (number, ring), (below_number, below) in itertools.pairwise(outside_in):
        if below.radius + below.half_width > ring.radius - ring.half_width:
            yield f"rings[{below_number}]", f"overlaps rings[{number}]"
    yield from _broken_play_rules(outside_in, level.ball)
    barrier: int | None = None
    for number, ring in outside_in:
        if barrier is not None and max(ring.slots()) > 0:
            yield f"rings[{number}]", f"level cannot be completed: rings[{barrier}] lets no ball in"
        if barrier is None and _is_barrier(ring, level.ball.radius):
            barrier = number


def _broken_play_rules(outside_in: list[tuple[int, RingSpec]], ball: BallSpec) -> Iterator[tuple[str, str]]:
    """Rules against unbreakable walls that the ball just fits between: it would bounce to and fro for ever."""
    rule = f"leaves the ball less than {least_play(ball):.3g} to move; make it wider, or too narrow for the ball"
    fixed = [(number, ring) for number, ring in outside_in if PERMANENT in ring.slots()]
    for number, ring in fixed:
        if any([_is_tight(width, ball) for width in _gates(ring)]):
            yield f"rings[{number}]", f"a gate between its unbreakable sectors {rule}"
        if _is_tight(2.0 * (ring.radius - ring.half_width), ball):
            yield f"rings[{number}]", f"the hole inside it {rule}"
    for (number, ring), (below_number, below) in itertools.combinations(fixed, 2):
        if _is_tight(ring.radius - ring.half_width - below.radius - below.half_width, ball):
            yield f"rings[{below_number}]", f"the lane between it and rings[{number}] {rule}"


def _is_tight(width: float, ball: BallSpec) -> bool:
    """Whether the ball just fits into a width."""
    return abs(width - 2.0 * ball.radius) < least_play(ball)


def least_play(ball: BallSpec) -> float:
    """World units by which a lane must be wider than the ball, for a tick to hold all impacts of a flight across it."""
    return max(_LEAST_PLAY * ball.radius, ball.speed / _TICKS_PER_SECOND / MAX_IMPACTS)


def _is_barrier(ring: RingSpec, ball_radius: float) -> bool:
    """Whether the unbreakable sectors leave no gap that the ball fits through, all bricks gone."""
    widest = _widest_gate(ring)
    return widest is not None and widest <= 2.0 * ball_radius


def _widest_gate(ring: RingSpec) -> float | None:
    """Width of the widest gap between unbreakable sectors, all bricks gone, world units; None where there are none."""
    return max(_gates(ring), default=None)


def _gates(ring: RingSpec) -> list[float]:
    """Widths of the gaps between neighbouring unbreakable sectors, all bricks gone: the chords at the inner radius."""
    fixed = [slot for slot, layers in enumerate(ring.slots()) if layers == PERMANENT]
    following = [*fixed[1:], *[slot + ring.count for slot in fixed[:1]]]
    inner = ring.radius - ring.half_width
    widths = []
    for slot, after in zip(fixed, following, strict=True):
        gap = math.radians((after - slot) * 360.0 / ring.count - 2.0 * ring.half_angle)
        widths.append(2.0 * inner * math.sin(gap / 2.0) if gap < math.pi else 2.0 * inner)
    return widths
