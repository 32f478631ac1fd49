"""Numbers that stand for every float of a box at once, and carry what rounding can have done to them.

A `Rounded` encloses the exact value that a formula has over the box, and bounds how far the float that a program computes may
be from it. Each operation adds its own error by the standard model of IEEE 754 in round to nearest,

    |fl(x op y) - (x op y)| <= u |x op y| + eta,    u = 2^-53, eta = 2^-1075 for products, quotients and roots, else 0,

which holds as long as nothing overflows, to what it passes on from its operands. A comparison is answered where every float of
the box answers it alike, and the exact value, too; else it raises `BranchBorderError`.
"""

import math

from flint import arb

UNIT = arb(2) ** -53
_ETA = arb(2) ** -1075


class BranchBorderError(Exception):
    """A box on which the program's branch, or the formula's, is not one and the same."""


class Rounded:
    """An enclosure of the exact value, and a bound of the computed one's distance from it."""

    __hash__ = None  # type: ignore[assignment]  # equality is a question that may have no answer
    __slots__ = ("error", "exact")

    def __init__(self, exact: arb, error: arb) -> None:
        """Take both."""
        self.exact = exact
        self.error = error.upper()

    @property
    def computed(self) -> arb:
        """An enclosure of the computed value."""
        return self.exact + arb(0, self.error)

    def __add__(self, other: "Rounded | float") -> "Rounded":
        """The sum, rounded."""
        other = number(other)
        return _rounded(self.exact + other.exact, self.error + other.error)

    def __sub__(self, other: "Rounded | float") -> "Rounded":
        """The difference, rounded."""
        other = number(other)
        return _rounded(self.exact - other.exact, self.error + other.error)

    def __mul__(self, other: "Rounded | float") -> "Rounded":
        """The product, rounded."""
        other = number(other)
        exact = _square(self.exact) if other is self else self.exact * other.exact
        passed = _size(self.exact) * other.error + _size(other.exact) * self.error + self.error * other.error
        return _rounded(exact, passed, _ETA)

    def __truediv__(self, other: "Rounded | float") -> "Rounded":
        """The quotient, rounded."""
        other = number(other)
        least = abs(other.exact).lower() - other.error
        if not least > 0:
            raise BranchBorderError("a divisor may be 0")
        exact = self.exact / other.exact
        return _rounded(exact, (self.error + _size(exact) * other.error) / least, _ETA)

    def __mod__(self, other: "Rounded | float") -> "Rounded":
        """Python's remainder: the C library's, which is exact, and one addition where the signs differ."""
        divisor = number(other)
        turns = whole_number(self.computed / divisor.computed)
        exact = self.exact - divisor.exact * turns
        passed = self.error + divisor.error * abs(turns)
        return _rounded(exact, passed) if turns < 0 else Rounded(exact, passed)

    def __radd__(self, other: float) -> "Rounded":
        """The sum with a float."""
        return number(other) + self

    def __rsub__(self, other: float) -> "Rounded":
        """The difference from a float."""
        return number(other) - self

    def __rmul__(self, other: float) -> "Rounded":
        """The product with a float."""
        return number(other) * self

    def __rtruediv__(self, other: float) -> "Rounded":
        """A float over this."""
        return number(other) / self

    def __neg__(self) -> "Rounded":
        """The negative, exactly."""
        return Rounded(-self.exact, self.error)

    def __abs__(self) -> "Rounded":
        """The absolute value, exactly."""
        return Rounded(abs(self.exact), self.error)

    def __lt__(self, other: "Rounded | float") -> bool:
        """Whether it is less."""
        return answer(self.computed, number(other).computed, strict=True)

    def __le__(self, other: "Rounded | float") -> bool:
        """Whether it is less or equal."""
        return answer(self.computed, number(other).computed, strict=False)

    def __gt__(self, other: "Rounded | float") -> bool:
        """Whether it is greater."""
        return answer(number(other).computed, self.computed, strict=True)

    def __ge__(self, other: "Rounded | float") -> bool:
        """Whether it is greater or equal."""
        return answer(number(other).computed, self.computed, strict=False)

    def __eq__(self, other: object) -> bool:
        """Whether it is equal: known only where it is not, or where both are one number."""
        assert isinstance(other, Rounded | float | int)
        mine, others = self.computed, number(other).computed
        if not mine.overlaps(others):
            return False
        if mine.is_exact() and others.is_exact():
            return True
        raise BranchBorderError("two numbers may be equal")

    def sqrt(self) -> "Rounded":
        """The square root, rounded."""
        least = self.exact.lower() - self.error
        if not least > 0:
            raise BranchBorderError("a root's argument may be 0")
        return _rounded(self.exact.sqrt(), self.error / (least.sqrt() + self.exact.lower().sqrt()), _ETA)


class RoundedPoint:
    """A complex number of two `Rounded`, with the operations that the source's functions use."""

    __hash__ = None  # type: ignore[assignment]
    __slots__ = ("imag", "real")

    def __init__(self, real: Rounded | float, imag: Rounded | float = 0.0) -> None:
        """Take both parts."""
        self.real, self.imag = number(real), number(imag)

    def __add__(self, other: "RoundedPoint") -> "RoundedPoint":
        """The sum."""
        return RoundedPoint(self.real + other.real, self.imag + other.imag)

    def __sub__(self, other: "RoundedPoint") -> "RoundedPoint":
        """The difference."""
        return RoundedPoint(self.real - other.real, self.imag - other.imag)

    def __mul__(self, scale: Rounded | float) -> "RoundedPoint":
        """A multiple by a real number: for a complex and a float, Python adds products with 0, which changes nothing."""
        return RoundedPoint(self.real * scale, self.imag * scale)

    def __neg__(self) -> "RoundedPoint":
        """The opposite."""
        return RoundedPoint(-self.real, -self.imag)

    def __eq__(self, other: object) -> bool:
        """Whether both parts are equal."""
        if not isinstance(other, RoundedPoint):
            assert isinstance(other, complex | float | int)
            other = RoundedPoint(complex(other).real, complex(other).imag)
        pairs = ((self.real, other.real), (self.imag, other.imag))
        if any([not mine.computed.overlaps(others.computed) for mine, others in pairs]):
            return False
        return all([mine == others for mine, others in pairs])


class RoundedMath:
    """The part of the module `math` that the source's functions use."""

    def __init__(self) -> None:
        """Enclose pi at this process's precision."""
        self.pi = Rounded(arb.pi(), abs(arb.pi() - arb(math.pi)))
        self.tau = Rounded(2 * arb.pi(), abs(2 * arb.pi() - arb(math.tau)))

    @staticmethod
    def sqrt(x: Rounded | float) -> Rounded:
        """The square root."""
        return number(x).sqrt()

    @staticmethod
    def floor(x: Rounded) -> int:
        """The whole number below."""
        return whole_number(x.computed)


def number(x: Rounded | float) -> Rounded:
    """A float as the exact number that it is."""
    return x if isinstance(x, Rounded) else Rounded(arb(x), arb(0))


def _rounded(exact: arb, passed: arb, eta: arb | None = None) -> Rounded:
    """The result of one operation: what its operands pass on, and its own rounding."""
    own = UNIT * (_size(exact) + passed)
    return Rounded(exact, passed + own if eta is None else passed + own + eta)


def _size(x: arb) -> arb:
    """The largest absolute value of an enclosure."""
    return x.abs_upper()


def _square(x: arb) -> arb:
    """The square of every value of an enclosure: never below 0."""
    least, most = x.abs_lower(), x.abs_upper()
    return arb.union(least * least, most * most)


def whole_number(x: arb) -> int:
    """The whole number below every value of an enclosure."""
    found = x.floor().unique_fmpz()
    if found is None:
        raise BranchBorderError("a whole number may be another")
    return int(found)


def answer(a: arb, b: arb, *, strict: bool) -> bool:
    """Whether a < b, or a <= b, for every pair of their values."""
    if a < b or (not strict and a <= b):
        return True
    if a > b or (strict and a >= b):
        return False
    raise BranchBorderError("a comparison has two answers")
