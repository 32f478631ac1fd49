"""How far a program that approximates, as `direction` does sine and cosine, is from what it approximates, on a whole interval.

Both are expanded around the middle m of the interval. Their difference D has, by Taylor's theorem,

    D(m + t) = c_0 + c_1 t + ... + c_(n-1) t^(n-1) + c_n t^n

with the coefficients of D at m, all tiny, but for c_n, which is D's n-th coefficient somewhere in the interval: it is enclosed
by expanding around the whole interval at once. The program's own code makes the coefficients, in exact arithmetic.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from flint import arb, arb_series, ctx

from tools.certify.boxes.rounded import answer, whole_number

TERMS = 14
"""n, plus 1. On intervals of 0.1 the last term is below 1e-20."""


class Series:
    """A power series with the operations, comparisons included, that `direction` uses."""

    __slots__ = ("series",)

    def __init__(self, series: arb_series) -> None:
        """Take the series."""
        self.series = series

    def __add__(self, other: "Series | float") -> "Series":
        """The sum."""
        return Series(self.series + _plain(other))

    def __sub__(self, other: "Series | float") -> "Series":
        """The difference."""
        return Series(self.series - _plain(other))

    def __mul__(self, other: "Series | float") -> "Series":
        """The product."""
        return Series(self.series * _plain(other))

    def __truediv__(self, other: float) -> "Series":
        """The quotient."""
        return Series(self.series / _plain(other))

    def __radd__(self, other: float) -> "Series":
        """The sum with a float."""
        return Series(_plain(other) + self.series)

    def __rsub__(self, other: float) -> "Series":
        """The difference from a float."""
        return Series(_plain(other) - self.series)

    def __neg__(self) -> "Series":
        """The negative."""
        return Series(-self.series)

    def __ge__(self, other: float) -> bool:
        """Whether its values, on the interval it is expanded around, are at least a number."""
        return answer(arb(other), self.series[0], strict=False)

    def __le__(self, other: float) -> bool:
        """Whether they are at most a number."""
        return answer(self.series[0], arb(other), strict=False)


class SeriesMath:
    """The part of the module `math` that `direction` uses."""

    @staticmethod
    def floor(x: Series) -> int:
        """The whole number below, which must be one for all values."""
        return whole_number(x.series[0])


def direction_off(code: Callable[[Series], tuple[Series, Series]], middle: arb, side: arb) -> arb:
    """A bound of |program - (cosine, sine)| on an interval, given its middle. code: `direction` on `Series`."""
    with _terms():
        at_middle, on_side = _differences(code, middle), _differences(code, side)
        half = abs(side - middle).upper()
        worst = arb(0)
        for near, far in zip(at_middle, on_side, strict=True):
            total = abs(far[TERMS - 1]) * half ** (TERMS - 1)
            for power in range(TERMS - 1):
                total += abs(near[power]) * half**power
            worst = arb.max(worst, total)
        return worst.upper()


def _differences(code: Callable[[Series], tuple[Series, Series]], around: arb) -> list[arb_series]:
    """The program's series less the true ones."""
    angle = arb_series([around, 1])
    cosine, sine = code(Series(angle))
    return [cosine.series - angle.cos(), sine.series - angle.sin()]


@contextmanager
def _terms() -> Iterator[None]:
    """Series of TERMS terms, for a while."""
    before = ctx.cap
    ctx.cap = TERMS
    try:
        yield
    finally:
        ctx.cap = before


def _plain(x: Series | float) -> Any:
    """What python-flint computes with."""
    return x.series if isinstance(x, Series) else arb(x)
