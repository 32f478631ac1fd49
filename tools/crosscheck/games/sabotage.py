"""Five deliberate mistakes in the game's physics. A harness that cannot find them finds nothing."""

from collections.abc import Callable

from physics import Arena, Ball, Contact, Feature, Hit, Ring, Step, advance, collision_response, direction, dot, to_polar
from tools.crosscheck.games.trajectory import Advance

_TENTH_OF_A_DEGREE = 1.7453292519943295e-3
_DROPPED = 3
"""Every so many bounces, one is dropped."""


def rotated_normal(arena: Arena, dt: float, speed: float) -> Step:
    """The physics, but every normal is turned by 0.1 degrees."""
    turn = direction(_TENTH_OF_A_DEGREE)
    return _altered(arena, dt, speed, lambda hit, _: _with_normal(hit, hit.contact.normal * turn))


def swapped_end(arena: Arena, dt: float, speed: float) -> Step:
    """The physics, but a ball that hits an end gets the normal of the sector's other end."""

    def swapped(hit: Hit, ring: Ring) -> Hit:
        if hit.contact.feature != Feature.END:
            return hit
        across = direction(ring.angle(hit.slot) + ring.spin * hit.time)
        normal = hit.contact.normal
        return _with_normal(hit, 2.0 * dot(normal, across) * across - normal)  # mirrored at the sector's middle

    return _altered(arena, dt, speed, swapped)


def corner_as_end(arena: Arena, dt: float, speed: float) -> Step:
    """The physics, but a corner answers like the end it belongs to."""

    def flattened(hit: Hit, ring: Ring) -> Hit:
        if hit.contact.feature != Feature.CORNER:
            return hit
        _, bearing = to_polar(hit.contact.point)
        across = direction(bearing) * 1j
        middle = direction(ring.angle(hit.slot) + ring.spin * hit.time)
        own = -across if dot(middle, across) > 0.0 else across  # away from the sector's middle
        return _with_normal(hit, own)

    return _altered(arena, dt, speed, flattened)


def still_surface(arena: Arena, dt: float, speed: float) -> Step:
    """The physics, but a bounce forgets that the ring turns: omega is ignored in the surface's velocity."""

    def forgetful(hit: Hit, ring: Ring) -> Hit:
        after = collision_response(hit.before, hit.contact.normal, 0j, ring.friction, speed)
        return hit._replace(after=after)

    return _altered(arena, dt, speed, forgetful)


class dropped_bounce:  # noqa: N801  # used like the functions beside it
    """The physics, but every third bounce does not happen: the ball flies on."""

    def __init__(self) -> None:
        self._bounces = 0

    def __call__(self, arena: Arena, dt: float, speed: float) -> Step:
        """One tick."""
        step = advance(arena, dt, speed)
        self._bounces += len(step.hits)
        if len(step.hits) != 1 or self._bounces % _DROPPED:
            return step
        moved = tuple(ball.moved(dt) for ball in arena.balls)
        return step._replace(arena=step.arena._replace(balls=moved, layers=arena.layers), hits=())


SABOTAGES: dict[str, Callable[[], Advance]] = {
    "rotated-normal": lambda: rotated_normal,
    "swapped-end": lambda: swapped_end,
    "corner-as-end": lambda: corner_as_end,
    "still-surface": lambda: still_surface,
    "dropped-bounce": dropped_bounce,
}
"""By the name on the command line: what makes a sabotaged copy of `physics.advance`."""


def _altered(arena: Arena, dt: float, speed: float, change: Callable[[Hit, Ring], Hit]) -> Step:
    """The tick with its hits changed; a changed velocity also changes where the ball flies in what is left of the tick."""
    step = advance(arena, dt, speed)
    if not step.hits:
        return step
    hits = tuple(change(hit, arena.rings[hit.ring]) for hit in step.hits)
    balls = list(step.arena.balls)
    for index in {hit.ball for hit in hits}:
        balls[index] = _flown(arena.balls[index], [hit for hit in hits if hit.ball == index], dt)
    return step._replace(hits=hits, arena=step.arena._replace(balls=tuple(balls)))


def _flown(ball: Ball, hits: list[Hit], dt: float) -> Ball:
    """Where a ball's hits lead it."""
    clock = 0.0
    for hit in hits:
        ball = Ball(ball.position + ball.velocity * (hit.time - clock), hit.after, ball.radius)
        clock = hit.time
    return ball.moved(dt - clock)


def _with_normal(hit: Hit, normal: complex) -> Hit:
    contact = hit.contact
    return hit._replace(contact=Contact(normal, contact.point, contact.gap, contact.feature))
