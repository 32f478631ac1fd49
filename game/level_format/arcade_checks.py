"""Rules for the keys that the arcade rules alone read."""

from collections.abc import Iterator

from game.language import tr_noop
from game.level_format.broken_rule import BrokenRule
from game.level_format.specs import Level, RingSpec
from physics import PERMANENT

SLOWEST = 0.64
"""Share of `ball.speed`: under no rules does a ball fly slower."""
FASTEST = 3.0
"""Shares of `ball.speed`: the most that `ball.top_speed` may be."""
_MANY_DROPS = 0.5
_FAST_GROWTH = 0.5
"""Seconds."""
_CAPTURE = 0.95
"""Share of the pull that could keep a ball in a circle."""


def broken_arcade_rules(level: Level) -> Iterator[BrokenRule]:
    """Every rule of these keys that the level breaks."""
    speed, top_speed = level.ball.speed, level.ball.top_speed
    if top_speed is not None and not speed <= top_speed <= FASTEST * speed:
        rule = tr_noop("must be from ball.speed {speed:g} to {most:g} times as much")
        yield BrokenRule("ball.top_speed", rule, {"speed": speed, "most": FASTEST})
    if len(set(level.drops.kinds)) != len(level.drops.kinds):
        yield BrokenRule("drops.kinds", tr_noop("names a power-up twice"))
    for number, ring in enumerate(level.rings):
        yield from _broken_ring_rules(f"rings[{number}]", ring, level)
    strongest = 4.0 * _CAPTURE * SLOWEST * speed * SLOWEST * speed
    for number, well in enumerate(level.wells):
        if well.distance > level.ground_radius:
            rule = tr_noop("lies beyond ground_radius {ground:g}")
            yield BrokenRule(f"wells[{number}].distance", rule, {"ground": level.ground_radius})
        if abs(well.strength) * well.reach > strongest:
            rule = tr_noop("could hold a ball for ever; at most {most:.4g} for this speed and reach")
            yield BrokenRule(f"wells[{number}].strength", rule, {"most": strongest / well.reach})


def arcade_warnings(level: Level) -> list[str]:
    """What these keys allow and yet makes a level tedious to play: key and reason, a line each."""
    found = []
    if level.drops.chance > _MANY_DROPS:
        found.append(f"drops.chance: above {_MANY_DROPS:g} power-ups hide the balls")
    for number, ring in enumerate(level.rings):
        if 0.0 < ring.regrow < _FAST_GROWTH:
            found.append(f"rings[{number}].regrow: below {_FAST_GROWTH:g} s it grows faster than it can be broken")
    track = level.paddles.radius - level.paddles.half_width
    for number, well in enumerate(level.wells):
        if well.distance + well.reach > track:
            found.append(f"wells[{number}].reach: it turns balls at the paddles' track {track:g}, where nobody can answer")
    return found


def _broken_ring_rules(key: str, ring: RingSpec, level: Level) -> Iterator[BrokenRule]:
    """Rules of one ring: bumpers cannot break, and what grows again needs something that does not."""
    if ring.bumper and max(ring.slots()) > 0:
        yield BrokenRule(f"{key}.layers", tr_noop("a bumper cannot break; {permanent} or 0 only"), {"permanent": PERMANENT})
    if ring.regrow and max(ring.slots()) <= 0:
        yield BrokenRule(f"{key}.regrow", tr_noop("there is no brick that could grow again"))
    if ring.regrow and not any([max(other.slots()) > 0 and not other.regrow for other in level.rings]):
        yield BrokenRule(f"{key}.regrow", tr_noop("level cannot be completed: every ring with bricks grows again"))
    if ring.reverse and not ring.spin:
        yield BrokenRule(f"{key}.reverse", tr_noop("the ring does not turn; give it a spin"))
