"""`tools.fuzz.checks` and the walk of `tools.fuzz.oracle` on arrays: what must hold after a tick, as a number of `Fault`.

The distance to a sector is the oracle's own function. Written anew for the compiler are the search for the nearest living slot,
the walk along a flight, which there is a function of a function, and the order of the checks. A fault that is found here is
told in words by `tools.fuzz.checks`, which gets the tick as an `Arena`.
"""

import math
from enum import IntEnum
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from physics.batch.arrays import Complexes, Floats, Games
from physics.shapes import Ring
from physics.tolerances import MAX_IMPACTS
from tools.fuzz.checks import BEND, LEAST_LEAVING, NORMAL, PENETRATION, PLACE, SHORTEST, SPEED, SQUEEZED
from tools.fuzz.oracle import FINEST, LONGEST_WALK, distance_to_sector

Slots = npt.NDArray[np.int32]


class Fault(IntEnum):
    """What is wrong with a tick."""

    NONE = 0
    NUMBERS = 1
    RINGS = 2
    LAYERS = 3
    FREED = 4
    FLIGHT = 5
    HIT = 6
    BOUNCES = 7
    END = 8
    OVERLAP = 9
    BOUNCE = 10


class Before(NamedTuple):
    """A game at the start of a tick: (balls,), (balls,), (rings,), (rings,), (rings, slots)."""

    positions: Complexes
    velocities: Complexes
    phases: Floats
    spins: Floats
    layers: Slots


def tick_fault(
    before: Before,
    games: Games,
    g: int,
    hits: npt.NDArray[Any],
    count: int,
    dt: float,
    speed: float,
    freed: int,
    dropped: int,
    work: Slots,
) -> int:
    """The `Fault` of a tick, the plainest first. games: after it, row g. hits: `count` rows. work: room, as `before.layers`."""
    rings = [_ring(games, before, k) for k in range(len(before.phases))]
    fault = _state_fault(before, games, g, hits, count, dt, speed, work)
    if fault != 0:
        return fault
    if freed > 0 and dropped == 0 and not _any_overlaps(before, games, g, rings):
        return 4
    for i in range(len(before.positions)):
        if not (freed > 0 and _overlaps(before.positions[i], games.ball_radii[g, i], rings, before.layers)):
            fault = _flight_fault(i, before, games, g, rings, hits, count, dt, speed, freed, dropped, work)
            if fault != 0:
                return fault
    for k in range(len(rings)):
        ring = _turned(rings[k], games.phases[g, k])
        for i in range(len(before.positions)):
            if _is_within(games.positions[g, i], games.ball_radii[g, i], ring, games.layers[g, k], PENETRATION):
                return 9
    return 0


def _state_fault(
    before: Before,
    games: Games,
    g: int,
    hits: npt.NDArray[Any],
    count: int,
    dt: float,
    speed: float,
    work: Slots,
) -> int:
    """Finite state, fixed speed; rings turned; the bookkeeping of hits."""
    for i in range(len(before.positions)):
        p, v = games.positions[g, i], games.velocities[g, i]
        if not (math.isfinite(p.real) and math.isfinite(p.imag) and math.isfinite(v.real) and math.isfinite(v.imag)):
            return 1
        if abs(math.hypot(v.real, v.imag) - speed) > SPEED * speed:
            return 1
    for k in range(len(before.phases)):
        phase = games.phases[g, k]
        lag = _remainder(phase - before.phases[k] - before.spins[k] * dt)
        if not (0.0 <= phase < 2.0 * math.pi) or abs(lag) > PLACE or games.spins[g, k] != before.spins[k]:
            return 2
    return 0 if _layers_fit(before, games, g, hits, count, work) else 3


def _layers_fit(before: Before, games: Games, g: int, hits: npt.NDArray[Any], count: int, work: Slots) -> bool:
    """Layers are taken by hits and by nothing else; hits are in order."""
    _copy(before.layers, work)
    time = 0.0
    for n in range(count):
        hit = hits[n]
        left = work[hit["ring"], hit["slot"]]
        if left == 0 or hit["layers"] != (left - 1 if left > 0 else left) or hit["time"] < time:
            return False
        work[hit["ring"], hit["slot"]] = hit["layers"]
        time = hit["time"]
    for k in range(work.shape[0]):
        for slot in range(work.shape[1]):
            if work[k, slot] != games.layers[g, k, slot]:
                return False
    return True


def _flight_fault(
    i: int,
    before: Before,
    games: Games,
    g: int,
    rings: list[Ring],
    hits: npt.NDArray[Any],
    count: int,
    dt: float,
    speed: float,
    freed: int,
    dropped: int,
    work: Slots,
) -> int:
    """One ball from impact to impact: no material on the way, no hit without contact, and it ends where it is said to."""
    p, v, r, clock = before.positions[i], before.velocities[i], games.ball_radii[g, i], 0.0
    _copy(before.layers, work)
    left, last = MAX_IMPACTS, -1
    for n in range(count):
        hit = hits[n]
        mine = hit["ball"] == i
        if mine or hit["layers"] == 0:
            if not _clear(p, v, r, clock, hit["time"], rings, work):
                return 5
            p, clock = p + v * (hit["time"] - clock), hit["time"]
        if mine:
            left -= 0 if last >= 0 and _is_one_bounce(hits[last], hit) else 1
            last, v = n, hit["after"]
            fault = _hit_fault(n, hits, count, p, r, rings[hit["ring"]], work[hit["ring"]], speed)
            if fault != 0:
                return fault
            if left == 0 and dropped > 0:
                return 0  # it rests for what is left of the tick
        work[hit["ring"], hit["slot"]] = hit["layers"]
    if left < 0:
        return 7
    if not _clear(p, v, r, clock, dt, rings, work):
        return 5
    end = p + v * (dt - clock)
    off = end - games.positions[g, i]
    return 8 if freed == 0 and math.hypot(off.real, off.imag) > PLACE * (1.0 + math.hypot(end.real, end.imag)) else 0


def _hit_fault(n: int, hits: npt.NDArray[Any], count: int, p: complex, r: float, ring: Ring, alive: Slots, speed: float) -> int:
    """What is wrong with one hit of a ball that is at p then: it is no touch, or the ball leaves in another direction."""
    hit = hits[n]
    if not _is_real(hit, p, hit["after"], r, ring, alive):
        return 6
    paired = (n > 0 and _is_one_bounce(hits[n - 1], hit)) or (n + 1 < count and _is_one_bounce(hits[n + 1], hit))
    return 0 if paired or _is_bounced(hit, ring, speed) else 10


def _is_one_bounce(one: Any, other: Any) -> bool:
    """Whether two hits of a ball, one after the other, are one bounce off two sectors at once."""
    same = one["time"] == other["time"] and one["before"] == other["before"] and one["after"] == other["after"]
    return same and not (one["ring"] == other["ring"] and one["slot"] == other["slot"])


def _clear(p: complex, v: complex, r: float, start: float, stop: float, rings: list[Ring], layers: Slots) -> bool:
    """No living sector is overlapped on a straight flight."""
    for k in range(len(rings)):  # noqa: SIM110  # what compiles
        if overlap_time(p, v, r, rings[k], start, stop, layers[k]) >= 0.0:
            return False
    return True


def overlap_time(p: complex, v: complex, r: float, ring: Ring, start: float, stop: float, alive: Slots) -> float:
    """`tools.fuzz.oracle.first_overlap`, of a ball that is at p at time `start`; -1 for none.

    It walks only while the ball is in the ring's band. Elsewhere the faces' circles alone keep it apart from every sector.
    """
    enters, reaches_hole, leaves_hole, leaves = _times_in_band(p, v, r, ring)
    one, other = start + max(enters, 0.0), start + max(leaves_hole, 0.0)
    one_stop, other_stop = min(start + reaches_hole, stop), min(start + leaves, stop)
    if one > one_stop and other > other_stop:
        return -1.0
    size = math.hypot(v.real, v.imag)
    closed = ring.half_angle >= math.pi / ring.count
    for slot in range(ring.count):
        closed = closed and alive[slot] != 0
    far = min(math.hypot(p.real, p.imag) + size * (stop - start), ring.radius + ring.half_width + r)
    pace = size if closed else size + abs(ring.spin) * far
    shortest = max(FINEST * r / pace, (stop - start) / LONGEST_WALK) if pace > 0.0 else 0.0
    time = _walk(p, v, r, ring, start, one, one_stop, alive, pace, shortest)
    return time if time >= 0.0 else _walk(p, v, r, ring, start, other, other_stop, alive, pace, shortest)


def _times_in_band(p: complex, v: complex, r: float, ring: Ring) -> tuple[float, float, float, float]:
    """When a ball at p enters the ring's band, enters the hole inside of it, leaves the hole and the band: seconds from now.

    The band is where the ball may overlap a sector by half of PENETRATION. A flight that misses the band enters it after it
    has left it. One that misses the hole passes it at one moment, that of its least distance from the centre.
    """
    size = math.sqrt(v.real * v.real + v.imag * v.imag)
    if size == 0.0:
        return 0.0, math.inf, math.inf, -1.0
    nearest, least = -(p.real * v.real + p.imag * v.imag) / (size * size), abs(p.real * v.imag - p.imag * v.real) / size
    outer = ring.radius + ring.half_width + r * (1.0 - 0.5 * PENETRATION)
    inner = ring.radius - ring.half_width - r * (1.0 - 0.5 * PENETRATION)
    if outer <= least:
        return math.inf, -1.0, math.inf, -1.0
    band = math.sqrt((outer - least) * (outer + least)) / size
    hole = math.sqrt((inner - least) * (inner + least)) / size if inner > least else 0.0
    return nearest - band, nearest - hole, nearest + hole, nearest + band


def _walk(
    p: complex,
    v: complex,
    r: float,
    ring: Ring,
    start: float,
    time: float,
    stop: float,
    alive: Slots,
    pace: float,
    shortest: float,
) -> float:
    """The first moment seen from `time` to `stop` at which a ball that is at p at `start` overlaps; -1 for none."""
    while time <= stop:
        gap = gap_beside(p + v * (time - start), r, ring, time, alive, -1)
        if gap < -PENETRATION * r:
            return time
        if time >= stop or pace == 0.0:
            return -1.0
        time = min(time + max(gap / pace, shortest), stop)
    return -1.0


def _is_real(hit: Any, p: complex, v: complex, r: float, ring: Ring, alive: Slots) -> bool:
    """A hit is a touch, from the side its normal says, and the ball then leaves the surface."""
    n, q = hit["normal"], hit["point"]
    if abs(gap_beside(p, r, ring, hit["time"], alive, hit["slot"])) > PENETRATION * r:
        return False
    away = p - n * r - q
    if math.hypot(away.real, away.imag) > NORMAL * r or abs(math.hypot(n.real, n.imag) - 1.0) > NORMAL:
        return False
    relative = v - complex(-q.imag, q.real) * ring.spin
    leaves = n.real * relative.real + n.imag * relative.imag > 0.0
    return leaves or abs(ring.spin) * (ring.radius + ring.half_width) >= math.hypot(v.real, v.imag)


def _is_bounced(hit: Any, ring: Ring, speed: float) -> bool:
    """A bounce off one sector reverses the approach, brakes the slip by friction, and keeps the speed: `checks._bounced`."""
    n, q, v = hit["normal"], hit["point"], hit["before"]
    if ring.count == 1 and hit["feature"] >= 2:
        return True
    surface = complex(-q.imag, q.real) * ring.spin
    relative = v - surface
    approach = n.real * relative.real + n.imag * relative.imag
    slip = relative - n * approach
    size = math.hypot(slip.real, slip.imag)
    braked = min(-approach * ring.friction / size, ring.friction) if size > 0.0 else 0.0
    after = v - n * (2.0 * approach) - slip * braked
    length = math.hypot(after.real, after.imag)
    if approach >= 0.0 or length < SHORTEST * speed:
        return True
    after = after * (speed / length)
    leaving, bend = after - surface, hit["after"] - after
    if n.real * leaving.real + n.imag * leaving.imag < LEAST_LEAVING * speed:
        return True
    return math.hypot(bend.real, bend.imag) <= BEND * speed


def _any_overlaps(before: Before, games: Games, g: int, rings: list[Ring]) -> bool:
    """Whether any ball overlaps anything at the tick's start by what a bounce cannot leave."""
    for i in range(len(before.positions)):
        if _overlaps(before.positions[i], games.ball_radii[g, i], rings, before.layers):
            return True
    return False


def _overlaps(p: complex, r: float, rings: list[Ring], layers: Slots) -> bool:
    """Whether a ball overlaps anything by what a bounce cannot leave."""
    for k in range(len(rings)):  # noqa: SIM110  # what compiles
        if _is_within(p, r, rings[k], layers[k], 0.9 * SQUEEZED):
            return True
    return False


def _is_within(p: complex, r: float, ring: Ring, alive: Slots, depth: float) -> bool:
    """Whether a ball overlaps a living sector by more than a fraction of its radius."""
    beyond = abs(math.sqrt(p.real * p.real + p.imag * p.imag) - ring.radius) - ring.half_width - r
    return beyond < 0.0 and gap_beside(p, r, ring, 0.0, alive, -1) < -depth * r


def gap_beside(p: complex, r: float, ring: Ring, time: float, alive: Slots, only: int) -> float:
    """`tools.fuzz.oracle.ring_gap`; of one slot alone where `only` is not negative."""
    bearing = math.atan2(p.imag, p.real) - ring.phase - ring.spin * time
    pitch = 2.0 * math.pi / ring.count
    if only >= 0:
        away = abs(_remainder(bearing - only * pitch))
    else:
        away = _angle_beside(bearing, ring.count, pitch, alive)
        if away == math.inf:
            return math.inf
    return distance_to_sector(math.hypot(p.real, p.imag), away - ring.half_angle, ring) - r


def _angle_beside(bearing: float, count: int, pitch: float, alive: Slots) -> float:
    """Angle between a bearing, seen from slot 0's middle, and the middle of the nearest living slot; infinite for none.

    Slots are asked by their distance from the one that is nearest of all; the first living one may lie on either side.
    """
    middle = math.floor(bearing / pitch + 0.5)
    for away in range(count // 2 + 1):
        before, after = (middle - away) % count, (middle + away) % count
        if alive[before] != 0 or alive[after] != 0:
            one = abs(_remainder(bearing - before * pitch)) if alive[before] != 0 else math.inf
            return min(one, abs(_remainder(bearing - after * pitch)) if alive[after] != 0 else math.inf)
    return math.inf


def _remainder(angle: float) -> float:
    """The angle less its whole turns, in [-pi, pi]."""
    return angle - 2.0 * math.pi * math.floor(angle / (2.0 * math.pi) + 0.5)


def _ring(games: Games, before: Before, k: int) -> Ring:
    """A ring at the tick's start."""
    sizes = games.ring_radii[k], games.half_widths[k], games.half_angles[k]
    return Ring(sizes[0], sizes[1], sizes[2], int(games.counts[k]), before.phases[k], before.spins[k], games.frictions[k])


def _turned(ring: Ring, phase: float) -> Ring:
    """The ring with another phase."""
    return Ring(ring.radius, ring.half_width, ring.half_angle, ring.count, phase, ring.spin, ring.friction)


def _copy(layers: Slots, into: Slots) -> None:
    """Copy layers. A slice would compile for seconds."""
    for k in range(layers.shape[0]):
        for slot in range(layers.shape[1]):
            into[k, slot] = layers[k, slot]
