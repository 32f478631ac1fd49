"""A box of inputs is halved until a function's rounding error is bounded on every piece.

On a piece on which the program takes one branch, and the formula, too, the error of every float input is bounded by what
`rounded` carries: |computed - exact value of the same program| <= error. That the program's exact value is the formula's is
checked in points of every such piece, with both known to 1e-24: there both are analytic, and two different analytic
functions agree by chance nowhere that one would hit. For a program that approximates its formula, what the two differ by is
bounded on the whole piece instead.
"""

import heapq
import itertools
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from flint import arb

from tools.certify.boxes.formulas import Numbers
from tools.certify.boxes.rounded import BranchBorderError, Rounded, RoundedPoint, number

_SAME = arb(2) ** -80
"""How near the program's exact value and the formula's must be in a point: 1e-24. Both are known to 2^-96 or better."""

_POINTS = 3
"""Of every piece that are compared."""

Range = tuple[float, float]


class Box(NamedTuple):
    """A function, a box of its inputs, and what is asked.

    ranges: of each coordinate, both ends included. call: from the coordinates to the function's result. formula: from exact
    coordinates to the exact result, None where it is `None`. bound: of the absolute error of every coordinate of the result.
    off: for a program that approximates its formula: from a piece's middle and the piece to a bound of what they differ by.
    """

    name: str
    ranges: tuple[Range, ...]
    call: Callable[[Sequence[Rounded]], Any]
    formula: Callable[[Numbers], Numbers | None]
    bound: float
    off: Callable[[arb, arb], arb] | None = None


class Proof(NamedTuple):
    """What is proved of a box.

    proved: share of its volume where the error is within the bound. border: where pieces are left on which a branch is not
    decided. loose: where the error found is above the bound. worst: the largest bound found where proved. wrong: coordinates
    at which the program's formula is not the source's. pieces: evaluations.
    """

    name: str
    bound: float
    proved: float
    border: float
    loose: float
    worst: float
    wrong: tuple[float, ...] | None
    pieces: int


class _BoxPart(NamedTuple):
    """A part of a box. order: largest first, then first come."""

    order: tuple[float, int]
    middles: tuple[arb, ...]
    halves: tuple[arb, ...]
    border: bool


def proof_of(box: Box, pieces: int) -> Proof:
    """Halve the largest piece that is not proved, its widest side first, as often as allowed."""
    numbers = itertools.count()
    sides = [(arb(low), arb(high)) for low, high in box.ranges]
    middles, halves = tuple([(low + high) / 2 for low, high in sides]), tuple([(high - low) / 2 for low, high in sides])
    heap = [_BoxPart((-1.0, next(numbers)), middles, halves, border=False)]
    proved, worst, count = 0.0, arb(0), 0
    while heap and count < pieces:
        piece = heapq.heappop(heap)
        error = _error(box, piece)
        count += 1
        if error is not None and error <= box.bound:
            wrong = None if box.off is not None else _wrong(box, piece)
            if wrong is not None:
                return Proof(box.name, box.bound, proved, 0.0, 0.0, _up(worst), wrong, count)
            proved -= piece.order[0]
            worst = arb.max(worst, error)
            continue
        for middles, halves in _halved(piece):
            heapq.heappush(heap, _BoxPart((piece.order[0] / 2.0, next(numbers)), middles, halves, border=error is None))
    border = -sum([piece.order[0] for piece in heap if piece.border])
    loose = -sum([piece.order[0] for piece in heap if not piece.border])
    return Proof(box.name, box.bound, proved, border, loose, _up(worst), None, count)


def _error(box: Box, piece: _BoxPart) -> arb | None:
    """The largest error of the result on a piece; None where the program's branch, or the formula's, is not decided."""
    sides = [arb(middle, half) for middle, half in zip(piece.middles, piece.halves, strict=True)]
    try:
        result = _parts(box.call([Rounded(side, arb(0)) for side in sides]))
        box.formula(sides)
        off = arb(0) if box.off is None else box.off(piece.middles[0], sides[0])
    except (BranchBorderError, ValueError):
        return None
    rounding = arb(0)
    for part in result or ():
        if not part.error.is_finite():
            return None
        rounding = arb.max(rounding, part.error)
    return off + rounding


def _wrong(box: Box, piece: _BoxPart) -> tuple[float, ...] | None:
    """A point of a piece where the exact value of the program is not the formula's: its middle or one of two others."""
    for number_of_point in range(_POINTS):
        shares = [_spread(number_of_point, side) for side in range(len(piece.middles))]
        parts = zip(piece.middles, piece.halves, shares, strict=True)
        point = [(middle + half * share).mid() for middle, half, share in parts]
        try:
            found, expected = _parts(box.call([Rounded(x, arb(0)) for x in point])), box.formula(point)
        except (BranchBorderError, ValueError):
            continue
        if found is None or expected is None:
            agree = found is None and expected is None
        else:
            agree = all([abs(one.exact - other) < _SAME for one, other in zip(found, expected, strict=True)])
        if not agree:
            return tuple([float(x) for x in point])
    return None


def _spread(point: int, side: int) -> float:
    """Where a point lies along a side, in (-1, 1): 0 for the first, then without a pattern."""
    return 0.0 if point == 0 else 2.0 * ((0.6180339887 * point + 0.7548776662 * (side + 1)) % 1.0) - 1.0


def _parts(result: Any) -> list[Rounded] | None:
    """The coordinates of a result."""
    if result is None:
        return None
    return [result.real, result.imag] if isinstance(result, RoundedPoint) else [number(result)]


def _halved(piece: _BoxPart) -> Iterator[tuple[tuple[arb, ...], tuple[arb, ...]]]:
    """Both halves of a piece, cut across its widest side."""
    widths = [float(half) for half in piece.halves]
    side = widths.index(max(widths))
    half = piece.halves[side] / 2
    halves = (*piece.halves[:side], half, *piece.halves[side + 1 :])
    for middle in (piece.middles[side] - half, piece.middles[side] + half):
        yield (*piece.middles[:side], middle, *piece.middles[side + 1 :]), halves


def _up(x: arb) -> float:
    """A float not below x."""
    return float(x.upper()) * (1.0 + 2.0**-50)
