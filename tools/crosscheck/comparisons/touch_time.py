"""Comparison c: when does the ball first touch a ring, by pymunk's segment queries and by the game?"""

import cmath
import math

from tools.crosscheck.comparisons.contact_check import ContactCheck
from tools.crosscheck.comparisons.hit_frame import CheckedTick
from tools.crosscheck.games.trajectory import Leg
from tools.crosscheck.pymunk_model import rounding
from tools.crosscheck.pymunk_model.sweep import BallFlight, Window, first_touch
from tools.crosscheck.results.measurements import Compared, Comparison, ContactVerdict, Measurement

_ROUNDING = 2.0**-50
"""Fraction of a ray as long as the arena: what rounding makes of pymunk's position on it."""

_MISSED = "pymunk touches earlier than the game bounces (missed bounce)"
_INVENTED = "the game bounced before pymunk touches (invented bounce)"
_AGREED = "seconds between the two first touches"


def compare_time(check: ContactCheck, checked: CheckedTick, leg: Leg) -> None:
    """Compare the end of a leg that a hit ended with the first touch that pymunk finds on any ring."""
    flight = leg.stop - leg.start
    if flight <= 0.0:
        return
    windows = _windows(checked, leg, check.moment.hit.ring)
    early, middle, late = [min(times) for times in zip(*windows.values(), strict=True)]
    error, bound = abs(middle - flight), late - early
    if late < flight:
        check.measure(Compared(Comparison.TIME, ContactVerdict.UNEXPLAINED, _MISSED, flight - late, 0.0))
    elif early > flight:
        check.measure(Compared(Comparison.TIME, ContactVerdict.UNEXPLAINED, _INVENTED, error, 0.0))
    elif math.isinf(late):
        what = f"pymunk touches {'a slightly larger ball' if math.isinf(middle) else 'this ball, but not a smaller one'}"
        check.note(Compared(Comparison.TIME, ContactVerdict.GRAZING, what, error, math.inf))
    else:
        check.measure(Compared(Comparison.TIME, ContactVerdict.EXACT, _AGREED, error, bound))


def missed_touch(checked: CheckedTick, leg: Leg) -> Measurement | None:
    """A ring that pymunk touches for certain on a leg that no hit ended."""
    flight = leg.stop - leg.start
    if flight <= 0.0:
        return None
    for ring, window in _windows(checked, leg, None).items():
        if window.late < flight:
            compared = Compared(Comparison.TIME, ContactVerdict.UNEXPLAINED, _MISSED, flight - window.late, 0.0)
            return Measurement(compared, checked.situation(leg.ball, ring, leg.end, leg.stop))
    return None


def _windows(checked: CheckedTick, leg: Leg, hit_ring: int | None) -> dict[int, Window]:
    """The first touch with every ring within reach, and with the one that was hit, by the ring's index."""
    tick, flight = checked.tick, leg.stop - leg.start
    radius = tick.level.ball_radius
    speed, distance = abs(leg.velocity), abs(leg.position)
    reach = speed * flight + radius
    windows = {}
    for k, (ring, model) in enumerate(zip(tick.arena.rings, checked.models, strict=True)):
        geometry = model.geometry
        noise = rounding.contact_noise(geometry.outer, radius) + _ROUNDING * geometry.outer
        near = model.living and abs(distance - geometry.radius) - geometry.half_width <= reach + noise
        if near or k == hit_ring:
            turn = cmath.rect(1.0, -(ring.phase + ring.spin * leg.start))
            seen = BallFlight(leg.position * turn, leg.velocity * turn, radius, ring.spin)
            windows[k] = first_touch(model, seen, flight + 2.0 * noise / max(speed, noise), noise)
    return windows
