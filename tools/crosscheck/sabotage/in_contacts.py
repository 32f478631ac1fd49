"""Mistakes in where and when a ball touches: put around the search for the first touch, whose answer the game goes on with."""

import math
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager

import physics
from physics import Ball, Contact, Feature, Impact, Ring, direction, dot, on_left, to_polar
from physics.time_of_impact import first_impact
from physics.vectors import quarter_turn
from tools.crosscheck.sabotage.replacing import method, replaced

_TENTH_OF_A_DEGREE = math.radians(0.1)
_LATER = 1e-7
"""Seconds."""

Alive = Sequence[int]


def rotated_normal() -> AbstractContextManager[None]:
    """Every normal is turned by a tenth of a degree."""
    turn = direction(_TENTH_OF_A_DEGREE)
    return _other_contacts(lambda contact, *_: contact._replace(normal=contact.normal * turn))


def reversed_inner_normal() -> AbstractContextManager[None]:
    """The normal of an inner face points outward."""
    return _other_contacts(
        lambda contact, *_: contact._replace(normal=-contact.normal) if contact.feature == Feature.INNER_FACE else contact
    )


def swapped_end() -> AbstractContextManager[None]:
    """A ball that hits an end gets the normal of the sector's other end."""
    return _other_contacts(lambda contact, _, middle: _other_end(contact, middle) if _is_end(contact) else contact)


def sources_end() -> AbstractContextManager[None]:
    """The end is chosen by the source's rule, which is wrong where a sector is wide."""

    def chosen(contact: Contact, ring: Ring, middle: float) -> Contact:
        if contact.feature not in {Feature.END, Feature.CORNER}:
            return contact
        _, bearing = to_polar(contact.point + contact.normal)
        right = on_left(bearing, middle)
        by_source = on_left(bearing, physics.normalize_angle(middle + ring.half_angle))
        return contact if right == by_source else _other_end(contact, middle)

    return _other_contacts(chosen)


def corner_as_end() -> AbstractContextManager[None]:
    """A corner answers like the end it belongs to."""

    def flattened(contact: Contact, _: Ring, middle: float) -> Contact:
        if contact.feature != Feature.CORNER:
            return contact
        end = direction(to_polar(contact.point)[1])
        across = quarter_turn(end)
        return contact._replace(normal=-across if dot(direction(middle), across) > 0.0 else across)

    return _other_contacts(flattened)


def point_of_the_middle() -> AbstractContextManager[None]:
    """The contact point of an end lies at the ring's middle radius, so that the surface there moves at another speed."""

    def moved(contact: Contact, ring: Ring, _: float) -> Contact:
        if contact.feature != Feature.END:
            return contact
        return contact._replace(point=contact.point * (ring.radius / physics.length(contact.point)))

    return _other_contacts(moved)


def face_called_inner() -> AbstractContextManager[None]:
    """An outer face is reported as an inner one; the bounce is right but for the least speed of leaving."""
    return _other_contacts(
        lambda contact, *_: contact._replace(feature=Feature.INNER_FACE) if contact.feature == Feature.OUTER_FACE else contact
    )


def late_touch() -> AbstractContextManager[None]:
    """Every touch is found a ten-millionth of a second late."""

    def late(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        found = _right(ball, ring, dt, alive)
        return found if found is None or found.time + _LATER > dt else found._replace(time=found.time + _LATER)

    return replaced(_right, late)


def early_touch() -> AbstractContextManager[None]:
    """Every touch is found a ten-millionth of a second early."""

    def early(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        found = _right(ball, ring, dt, alive)
        return found if found is None or found.time < _LATER else found._replace(time=found.time - _LATER)

    return replaced(_right, early)


def wrong_inner_border() -> AbstractContextManager[None]:
    """Inner faces stand a ten-thousandth of a unit too far out."""
    return _other_rings(lambda ring: ring._replace(radius=ring.radius + 5e-5, half_width=ring.half_width - 5e-5))


def narrower_sectors() -> AbstractContextManager[None]:
    """Sectors are narrower by a millionth."""
    return _other_rings(lambda ring: ring._replace(half_angle=ring.half_angle * (1.0 - 1e-6)))


def resting_rings() -> AbstractContextManager[None]:
    """The search for the first touch takes turning rings to be at rest for the length of a tick."""
    return _other_rings(lambda ring: ring._replace(spin=0.0))


def larger_ball() -> AbstractContextManager[None]:
    """The ball touches as if it were larger by a millionth."""

    def larger(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        return _right(ball._replace(radius=ball.radius * (1.0 + 1e-6)), ring, dt, alive)

    return replaced(_right, larger)


def no_corners() -> AbstractContextManager[None]:
    """A ball flies through corners."""
    return _unseen(lambda found, _: found.contact.feature == Feature.CORNER)


def no_turning_ends() -> AbstractContextManager[None]:
    """A ball flies through the ends of turning rings."""
    return _unseen(lambda found, ring: ring.spin != 0.0 and found.contact.feature in {Feature.END, Feature.CORNER})


def slanted_hits_only() -> AbstractContextManager[None]:
    """Contacts within 5 degrees of head-on are not seen."""
    steepest = -math.cos(math.radians(5.0))

    def seen(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        found = _right(ball, ring, dt, alive)
        if found is None or dot(ball.velocity, found.contact.normal) < steepest * physics.length(ball.velocity):
            return None
        return found

    return replaced(_right, seen)


def ghost_bricks() -> AbstractContextManager[None]:
    """Broken bricks can still be hit."""
    return replaced(_right, lambda ball, ring, dt, *_: _right(ball, ring, dt, (1,) * ring.count))


def fast_rings() -> AbstractContextManager[None]:
    """Rings turn too fast by a ten-millionth."""
    right = Ring.turned
    return method(Ring, "turned", lambda ring, time: right(ring, time * (1.0 + 1e-7)))


_right = first_impact


def _other_contacts(change: Callable[[Contact, Ring, float], Contact]) -> AbstractContextManager[None]:
    """The search with its contact changed; the change gets the ring and the middle angle of the sector at that moment."""

    def changed(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        found = _right(ball, ring, dt, alive)
        if found is None:
            return None
        middle = physics.normalize_angle(ring.angle(found.slot) + ring.spin * found.time)
        return found._replace(contact=change(found.contact, ring, middle))

    return replaced(_right, changed)


def _other_rings(change: Callable[[Ring], Ring]) -> AbstractContextManager[None]:
    """The search among other rings."""
    return replaced(_right, lambda ball, ring, dt, alive: _right(ball, change(ring), dt, alive))


def _unseen(ignored: Callable[[Impact, Ring], bool]) -> AbstractContextManager[None]:
    """The search without some of its answers."""

    def seen(ball: Ball, ring: Ring, dt: float, alive: Alive) -> Impact | None:
        found = _right(ball, ring, dt, alive)
        return None if found is not None and ignored(found, ring) else found

    return replaced(_right, seen)


def _is_end(contact: Contact) -> bool:
    return contact.feature == Feature.END


def _other_end(contact: Contact, middle: float) -> Contact:
    """A contact with its normal mirrored at the sector's middle."""
    across = quarter_turn(direction(middle))
    return contact._replace(normal=contact.normal - 2.0 * dot(contact.normal, across) * across)
