"""Is a function above zero on a whole interval? Decided from its ends and the range of its second derivative."""

from typing import NamedTuple

from flint import arb


class FunctionOnInterval(NamedTuple):
    """A function f on an interval [a, b]: f and f' at both ends, and an enclosure of f'' on all of it.

    ease: what f would be larger by for a ball smaller by the tolerance; None where f does not depend on the radius.
    """

    start: arb
    start_rate: arb
    stop: arb
    stop_rate: arb
    bend: arb
    ease: arb | None


def positive(f: FunctionOnInterval, width: arb) -> bool:
    """Whether f > 0 on the interval for certain. Where f'' is known exactly, the answer is exact, too.

    Each line is a lower bound of f: a concave f lies above its chord, one with f'' <= H above the chord less H w^2 / 8; one
    that only rises or only falls is least at an end; one with f'' >= L > 0 lies above f(a) + f'(a) s + L s^2 / 2.
    """
    if not (f.start > 0 and f.stop > 0):
        return False
    if f.bend <= 0:
        return True
    if rising(f, width) or falling(f, width):
        return True
    sag = f.bend.upper() * width * width / 8
    if f.start > sag and f.stop > sag:
        return True
    if f.bend > 0:
        twice = 2 * f.bend.lower()
        return bool(twice * f.start > f.start_rate * f.start_rate or twice * f.stop > f.stop_rate * f.stop_rate)
    return False


def rising(f: FunctionOnInterval, width: arb) -> bool:
    """Whether f' > 0 inside the interval for certain."""
    if not f.start_rate > 0:
        return False
    return bool(f.bend >= 0 or f.start_rate + f.bend.lower() * width > 0 or (f.bend <= 0 and f.stop_rate > 0))


def falling(f: FunctionOnInterval, width: arb) -> bool:
    """Whether f' < 0 inside the interval for certain."""
    if not f.stop_rate < 0:
        return False
    return bool(f.bend >= 0 or f.stop_rate - f.bend.lower() * width < 0 or (f.bend <= 0 and f.start_rate < 0))


def kept_apart(f: FunctionOnInterval, width: arb, *, first: bool, last: bool) -> bool:
    """Whether f > 0 on the interval but for a touch within the tolerance that the flight starts from, or ends in.

    first, last: whether the interval begins, or ends, with the flight. On a first one f may begin below 0, though not for
    a ball smaller by the tolerance, if it rises to above 0; on a last one it may fall to there.
    """
    if positive(f, width):
        return True
    if f.ease is None:
        return False
    if first and f.start + f.ease > 0 and rising(f, width):
        return last or bool(f.stop > 0)
    return bool(last and f.start > 0 and f.stop + f.ease > 0 and falling(f, width))
