"""What must hold after every tick, asked of the oracle."""

import math
from collections.abc import Iterator, Sequence

from physics import Arena, Ball, Feature, Hit, Ring, Step
from physics.tolerances import MAX_IMPACTS
from tools.fuzz.oracle import first_overlap, ring_gap, slot_gap

PENETRATION = 1e-9
"""Fraction of the ball's radius: the promised depth at most."""

SPEED = 1e-12
PLACE = 1e-11
NORMAL = 1e-9
SQUEEZED = 1e-10


LEAST_LEAVING = 2e-3
"""Fraction of the ball's speed. One that leaves a surface more slowly may have been helped: its direction is not checked."""

SHORTEST = 1e-3
"""Fraction of the ball's speed: the direction of a velocity that is shorter before it is set to the speed is not checked."""

BEND = 1e-8
"""Fraction of the ball's speed: how much a velocity after a bounce may differ from that of the law."""


def first_fault(before: Arena, step: Step, dt: float, speed: float) -> str | None:
    """What is wrong with a tick, in one line; None if nothing is."""
    return next(_faults(before, step, dt, speed), None)


def _faults(before: Arena, step: Step, dt: float, speed: float) -> Iterator[str]:
    """Every fault of a tick, the plainest first."""
    yield from _numbers(step, speed)
    yield from _bookkeeping(before, step, dt)
    if step.freed and not step.dropped and not _any_overlap(before):
        yield "a ball was freed that overlapped nothing"
    for index in range(len(before.balls)):
        if not (step.freed and _overlaps(before, index)):
            yield from _flight(index, before, step, dt, speed)
    yield from _overlaps_left(step)


def _numbers(step: Step, speed: float) -> Iterator[str]:
    """Finite state, fixed speed."""
    for index, ball in enumerate(step.arena.balls):
        p, v, _ = ball
        if not all([math.isfinite(x) for x in (p.real, p.imag, v.real, v.imag)]):
            yield f"ball {index} is not finite: {ball}"
        elif abs(math.hypot(v.real, v.imag) - speed) > SPEED * speed:
            yield f"ball {index} has speed {math.hypot(v.real, v.imag)!r}, not {speed!r}"
    for ring in step.arena.rings:
        if not 0.0 <= ring.phase < 2.0 * math.pi:
            yield f"a phase is outside the range: {ring.phase!r}"


def _bookkeeping(before: Arena, step: Step, dt: float) -> Iterator[str]:
    """Rings turned, layers taken by hits and by nothing else, hits in order."""
    for ring, turned in zip(before.rings, step.arena.rings, strict=True):
        lag = math.remainder(turned.phase - ring.phase - ring.spin * dt, 2.0 * math.pi)
        if abs(lag) > PLACE or turned._replace(phase=ring.phase) != ring:
            yield f"a ring did not turn by its spin: {ring} -> {turned}"
    if [hit.time for hit in step.hits] != sorted([hit.time for hit in step.hits]):
        yield "hits are not in the order of time"
    layers = [list(row) for row in before.layers]
    for hit in step.hits:
        left = layers[hit.ring][hit.slot]
        if left == 0:
            yield f"an empty slot was hit: {hit}"
        layers[hit.ring][hit.slot] = left - 1 if left > 0 else left
        if hit.layers != layers[hit.ring][hit.slot]:
            yield f"a hit reports the wrong layers: {hit}"
    if tuple([tuple(row) for row in layers]) != step.arena.layers:
        yield "layers changed without a hit"


def _flight(index: int, before: Arena, step: Step, dt: float, speed: float) -> Iterator[str]:
    """One ball from impact to impact: no material on the way, no hit without contact, and it ends where it is said to."""
    ball, clock = before.balls[index], 0.0
    layers = list(before.layers)
    left = MAX_IMPACTS
    last: Hit | None = None
    for hit in step.hits:
        if hit.ball == index:
            left -= last is None or not _is_one_bounce(last, hit)
            last = hit
            yield from _clear(index, ball, clock, hit.time, before.rings, layers)
            ball = Ball(ball.position + ball.velocity * (hit.time - clock), hit.after, ball.radius)
            clock = hit.time
            yield from _real(hit, ball, before.rings[hit.ring])
            yield from _bounced(hit, step.hits, before.rings[hit.ring], speed)
            if left == 0 and step.dropped:
                return  # it rests for what is left of the tick
        elif hit.layers == 0:  # the slot is empty from here on
            yield from _clear(index, ball, clock, hit.time, before.rings, layers)
            ball, clock = Ball(ball.position + ball.velocity * (hit.time - clock), ball.velocity, ball.radius), hit.time
        row = layers[hit.ring]
        layers[hit.ring] = (*row[: hit.slot], hit.layers, *row[hit.slot + 1 :])
    if left < 0:
        yield f"ball {index} bounced more than {MAX_IMPACTS} times"
    yield from _clear(index, ball, clock, dt, before.rings, layers)
    end = ball.position + ball.velocity * (dt - clock)
    there = step.arena.balls[index].position
    if not step.freed and math.hypot(end.real - there.real, end.imag - there.imag) > PLACE * (
        1.0 + math.hypot(end.real, end.imag)
    ):
        yield f"ball {index} is at {there}, its hits lead to {end}"


def _is_one_bounce(one: Hit, other: Hit) -> bool:
    """Whether two hits of a ball, one after the other, are one bounce off two sectors at once."""
    same = (one.time, one.before, one.after) == (other.time, other.before, other.after)
    return same and (one.ring, one.slot) != (other.ring, other.slot)


def _clear(
    index: int, ball: Ball, start: float, stop: float, rings: Sequence[Ring], layers: Sequence[tuple[int, ...]]
) -> Iterator[str]:
    """No living sector is overlapped on a straight flight."""
    for k, (ring, alive) in enumerate(zip(rings, layers, strict=True)):
        time = first_overlap(ball, ring, start, stop, alive, PENETRATION * ball.radius)
        if time is not None:
            yield f"ball {index} flies into ring {k} at {time!r} s of the tick"


def _real(hit: Hit, ball: Ball, ring: Ring) -> Iterator[str]:
    """A hit is a touch, from the side its normal says, and the ball then leaves the surface."""
    p = ball.position
    gap = slot_gap(p, ball.radius, ring, hit.time, hit.slot)
    if abs(gap) > PENETRATION * ball.radius:
        yield f"a hit without contact, the gap is {gap!r}: {hit}"
    n, q = hit.contact.normal, hit.contact.point
    away = p - n * ball.radius - q
    if math.hypot(away.real, away.imag) > NORMAL * ball.radius or abs(math.hypot(n.real, n.imag) - 1.0) > NORMAL:
        yield f"the contact of a hit is not where ball and sector meet: {hit}"
    surface = q * 1j * ring.spin
    relative = ball.velocity - surface
    size = math.hypot(ball.velocity.real, ball.velocity.imag)
    if n.real * relative.real + n.imag * relative.imag <= 0.0 and abs(ring.spin) * (ring.radius + ring.half_width) < size:
        yield f"the ball does not leave the surface it hit: {hit}"


def _bounced(hit: Hit, hits: Sequence[Hit], ring: Ring, speed: float) -> Iterator[str]:
    """A bounce off one sector reverses the approach, brakes the slip by friction, and keeps the speed.

    Not asked of a bounce off two sectors at once, nor off the two ends of one sector.
    """
    if any([other.ball == hit.ball and _is_one_bounce(hit, other) for other in hits]):
        return
    if ring.count == 1 and hit.contact.feature in {Feature.END, Feature.CORNER}:
        return
    n, q = hit.contact.normal, hit.contact.point
    surface = q * 1j * ring.spin
    relative = hit.before - surface
    approach = n.real * relative.real + n.imag * relative.imag
    slip = relative - n * approach
    size = math.hypot(slip.real, slip.imag)
    braked = min(-approach * ring.friction / size, ring.friction) if size > 0.0 else 0.0
    after = hit.before - n * (2.0 * approach) - slip * braked
    length = math.hypot(after.real, after.imag)
    if approach >= 0.0 or length < SHORTEST * speed:
        return
    after *= speed / length
    leaving = after - surface
    if n.real * leaving.real + n.imag * leaving.imag < LEAST_LEAVING * speed:
        return
    bend = hit.after - after
    if math.hypot(bend.real, bend.imag) > BEND * speed:
        yield f"the ball should leave with velocity {after}: {hit}"


def _overlaps_left(step: Step) -> Iterator[str]:
    """At the end of the tick every ball is outside of everything."""
    for index, ball in enumerate(step.arena.balls):
        for k, (ring, alive) in enumerate(zip(step.arena.rings, step.arena.layers, strict=True)):
            gap = ring_gap(ball.position, ball.radius, ring, 0.0, alive)
            if gap < -PENETRATION * ball.radius:
                yield f"ball {index} overlaps ring {k} by {-gap / ball.radius!r} of its radius"


def _any_overlap(arena: Arena) -> bool:
    """Whether any ball overlaps anything by what a bounce cannot leave."""
    return any([_overlaps(arena, index) for index in range(len(arena.balls))])


def _overlaps(arena: Arena, index: int) -> bool:
    """Whether one ball overlaps anything by what a bounce cannot leave."""
    ball = arena.balls[index]
    gaps = [
        ring_gap(ball.position, ball.radius, ring, 0.0, alive) for ring, alive in zip(arena.rings, arena.layers, strict=True)
    ]
    return min(gaps) < -0.9 * SQUEEZED * ball.radius
