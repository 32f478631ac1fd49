"""What makes a level one that can be played: every rule that a file may break, and what is allowed and yet tedious."""

import itertools
import math
from collections.abc import Iterator
from typing import Any

import msgspec

from game.language import tr_noop
from game.level_format.arcade_checks import arcade_warnings, broken_arcade_rules
from game.level_format.broken_rule import BrokenRule
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
_TIGHT_GATE = tr_noop(
    "a gate between its unbreakable sectors leaves the ball less than {play:.3g} to move;"
    " make it wider, or too narrow for the ball"
)
_TIGHT_HOLE = tr_noop(
    "the hole inside it leaves the ball less than {play:.3g} to move; make it wider, or too narrow for the ball"
)
_TIGHT_LANE = tr_noop(
    "the lane between it and rings[{other}] leaves the ball less than {play:.3g} to move;"
    " make it wider, or too narrow for the ball"
)


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


def broken_rules(level: Level) -> Iterator[BrokenRule]:
    """Every rule of a possible arena that the level breaks."""
    numbers_fine = True
    for key, value in _numbers(msgspec.to_builtins(level)):
        if not math.isfinite(value):
            numbers_fine = False
            yield BrokenRule(key, tr_noop("must be finite, not {value}"), {"value": value})
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


def _broken_track_rules(level: Level) -> Iterator[BrokenRule]:
    """Rules of the ground, the ball and the paddles."""
    paddles, speed, ground = level.paddles, level.ball.speed, level.ground_radius
    outer = paddles.radius + paddles.half_width
    if level.ball.radius < _LEAST_BALL * ground:
        rule = tr_noop("must be at least {share:g} of ground_radius, {least:g}")
        yield BrokenRule("ball.radius", rule, {"share": _LEAST_BALL, "least": _LEAST_BALL * ground})
    if speed < 2.0 * ground / _LONGEST_CROSSING:
        rule = tr_noop("must be at least {least:.4g}, to cross the ground in {seconds:g} s")
        yield BrokenRule("ball.speed", rule, {"least": 2.0 * ground / _LONGEST_CROSSING, "seconds": _LONGEST_CROSSING})
    if outer > level.ground_radius:
        rule = tr_noop("the paddles reach to {outer:g}, beyond ground_radius {ground:g}")
        yield BrokenRule("paddles.radius", rule, {"outer": outer, "ground": ground})
    if paddles.half_width >= paddles.radius:
        yield BrokenRule("paddles.half_width", tr_noop("must be below paddles.radius {radius:g}"), {"radius": paddles.radius})
    if paddles.half_angle * paddles.count >= 180.0:
        rule = tr_noop("{count} paddles must leave gaps: below {most:g} degrees")
        yield BrokenRule("paddles.half_angle", rule, {"count": paddles.count, "most": 180.0 / paddles.count})
    fastest = math.degrees(speed / outer)
    if paddles.top_speed >= fastest:
        rule = tr_noop("must be below the ball's, {fastest:.4g} degrees per second at the paddles' outer radius")
        yield BrokenRule("paddles.top_speed", rule, {"fastest": fastest})


def _broken_ring_rules(key: str, ring: RingSpec, level: Level) -> Iterator[BrokenRule]:
    """Rules of one ring of bricks."""
    inner, outer = ring.radius - ring.half_width, ring.radius + ring.half_width
    if inner <= 0.0:
        yield BrokenRule(f"{key}.half_width", tr_noop("must be below the ring's radius {radius:g}"), {"radius": ring.radius})
    if ring.half_angle * ring.count > 180.0 * (1.0 + 1e-12):
        rule = tr_noop("bricks overlap; at most {most:g} degrees for {count} of them")
        yield BrokenRule(f"{key}.half_angle", rule, {"most": 180.0 / ring.count, "count": ring.count})
    if isinstance(ring.layers, list) and len(ring.layers) != ring.count:
        rule = tr_noop("must have one number per slot, {count}, not {given}")
        yield BrokenRule(f"{key}.layers", rule, {"count": ring.count, "given": len(ring.layers)})
    if math.radians(abs(ring.spin)) * outer >= level.ball.speed:
        fastest = math.degrees(level.ball.speed / outer)
        rule = tr_noop("must be below the ball's speed, {fastest:.4g} degrees per second at the ring's outer radius")
        yield BrokenRule(f"{key}.spin", rule, {"fastest": fastest})
    track = level.paddles.radius - level.paddles.half_width
    if outer + 2.0 * level.ball.radius + least_play(level.ball) >= track:
        rule = tr_noop("reaches to {outer:g}; the ball ({across:g} across) must fit below the paddles' track {track:g}")
        yield BrokenRule(f"{key}.radius", rule, {"outer": outer, "across": 2.0 * level.ball.radius, "track": track})


def _broken_wall_rules(level: Level) -> Iterator[BrokenRule]:
    """Rules that concern the rings together: no overlap, something to break, everything within reach."""
    bricks = sum([layers > 0 for ring in level.rings for layers in ring.slots()])
    if bricks == 0:
        yield BrokenRule("rings", tr_noop("no bricks to break"))
    if bricks > _MAX_BRICKS:
        yield BrokenRule("rings", tr_noop("{count} bricks; at most {most}"), {"count": bricks, "most": _MAX_BRICKS})
    outside_in = sorted(enumerate(level.rings), key=lambda pair: -pair[1].radius)
    for (number, ring), (below_number, below) in itertools.pairwise(outside_in):
        if below.radius + below.half_width > ring.radius - ring.half_width:
            yield BrokenRule(f"rings[{below_number}]", tr_noop("overlaps rings[{other}]"), {"other": number})
    yield from _broken_play_rules(outside_in, level.ball)
    barrier: int | None = None
    for number, ring in outside_in:
        if barrier is not None and max(ring.slots()) > 0:
            rule = tr_noop("level cannot be completed: rings[{other}] lets no ball in")
            yield BrokenRule(f"rings[{number}]", rule, {"other": barrier})
        if barrier is None and _is_barrier(ring, level.ball.radius):
            barrier = number


def _broken_play_rules(outside_in: list[tuple[int, RingSpec]], ball: BallSpec) -> Iterator[BrokenRule]:
    """Rules against unbreakable walls that the ball just fits between: it would bounce to and fro for ever."""
    play = least_play(ball)
    fixed = [(number, ring) for number, ring in outside_in if PERMANENT in ring.slots()]
    for number, ring in fixed:
        if any([_is_tight(width, ball) for width in _gates(ring)]):
            yield BrokenRule(f"rings[{number}]", _TIGHT_GATE, {"play": play})
        if _is_tight(2.0 * (ring.radius - ring.half_width), ball):
            yield BrokenRule(f"rings[{number}]", _TIGHT_HOLE, {"play": play})
    for (number, ring), (below_number, below) in itertools.combinations(fixed, 2):
        if _is_tight(ring.radius - ring.half_width - below.radius - below.half_width, ball):
            yield BrokenRule(f"rings[{below_number}]", _TIGHT_LANE, {"play": play, "other": number})


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
