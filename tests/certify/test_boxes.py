"""The source's functions over boxes: the error bounds hold for floats, and another function is told apart."""

import math
from fractions import Fraction
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

pytest.importorskip("flint", reason="the proofs need python-flint, the extra [proof]")

from flint import arb

import physics
from physics.narrow_phase import closest_point_on_line
from tests.support.strategies import reals
from tools.certify.boxes import catalogue, formulas
from tools.certify.boxes.catalogue import boxes
from tools.certify.boxes.rounded import BranchBorderError, Rounded, RoundedMath, RoundedPoint, number
from tools.certify.boxes.same_code import on_other_numbers
from tools.certify.boxes.series import SeriesMath, direction_off
from tools.certify.boxes.subdivision import Box, proof_of
from tools.certify.exact_geometry import use_precision

use_precision()

OPERATIONS = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
}


def within(rounded, exact, computed):
    """Whether an exact value is enclosed, and the computed one as near to it as the error says."""
    exact = Fraction(exact)
    point = arb(exact.numerator) / exact.denominator
    return rounded.exact.overlaps(point) and abs(arb(computed) - point) <= rounded.error


@given(
    st.lists(st.sampled_from(sorted(OPERATIONS)), min_size=1, max_size=6), st.lists(reals(-9.0, 9.0), min_size=7, max_size=7)
)
def test_a_chain_of_operations_stays_within_its_error(signs, values):
    """Exact fractions, floats and `Rounded` through the same chain of operations."""
    exact, computed, rounded = Fraction(values[0]), values[0], number(values[0])
    for sign, value in zip(signs, values[1:], strict=False):
        operation = OPERATIONS[sign]
        if sign == "/" and abs(value) < 1e-3:
            continue
        exact, computed = operation(exact, Fraction(value)), operation(computed, value)
        rounded = operation(rounded, value)
        assert within(rounded, exact, computed)


@given(reals(1e-3, 9.0), reals(0.0, 1e-3), reals(0.0, 1.0))
def test_a_root_and_a_product_over_a_box_hold_for_its_floats(middle, half, share):
    """A float of the box, computed and exact, lies where the box's result says."""
    x = middle - half / 2.0 + half * share * 0.5
    box = Rounded(arb(middle, half), arb(0))
    root = math.sqrt(x)
    try:
        found = box.sqrt()
    except BranchBorderError:
        assert half >= middle * (1.0 - 1e-8)  # a radius is kept with 30 bits, rounded up
        return
    assert found.exact.overlaps(arb(x).sqrt())
    assert abs(arb(root) - arb(x).sqrt()) <= found.error
    assert within(box * box, Fraction(x) ** 2, x * x)


@given(reals(-40.0, 40.0))
def test_the_remainder_is_pythons(x):
    """`%` of floats with tau, against the true remainder with 2 pi."""
    try:
        found = number(x) % RoundedMath().tau
    except BranchBorderError:
        assert abs(x / math.tau - round(x / math.tau)) < 1e-14
        return
    assert found.computed.overlaps(arb(x % math.tau))
    turns = math.floor(x / math.tau)
    assert found.exact.overlaps(arb(x) - 2 * arb.pi() * turns)
    assert found.error < 1e-14


def test_a_comparison_without_one_answer_is_a_border():
    """Also of what may be equal; where it is certain there is an answer."""
    wide = Rounded(arb(1, 0.5), arb(0))
    for question in (lambda: wide < 1.0, lambda: wide >= 1.2, lambda: wide == 1.0, lambda: RoundedPoint(wide) == 1.0):
        with pytest.raises(BranchBorderError):
            question()
    assert wide < 1.6
    assert not wide < 0.4
    assert wide != 2.0
    assert number(3.0) == 3.0
    assert RoundedPoint(wide) != 2.0


def test_the_code_itself_runs():
    """On floats it gives the same bits; the function it was made from keeps its own namespace."""
    copy = on_other_numbers(closest_point_on_line, {})
    assert copy.__code__ is closest_point_on_line.__code__
    assert copy(0j, 2 + 0j, 1 + 5j) == closest_point_on_line(0j, 2 + 0j, 1 + 5j)
    other = on_other_numbers(closest_point_on_line, {"dot": lambda _a, _b: -1.0})
    assert other(1j, 2 + 0j, 1 + 5j) == 1j
    assert closest_point_on_line(0j, 2 + 0j, 1 + 5j) == 1 + 0j


@pytest.mark.parametrize("box", boxes(), ids=lambda box: box.name)
def test_every_box_is_proved(box):
    """More than nine tenths of each with few pieces, nothing wrong; `--functions` is the same at length."""
    proof = proof_of(box, 2500)
    assert proof.wrong is None
    assert proof.proved > 0.9
    assert proof.worst <= box.bound
    assert proof.proved + proof.border + proof.loose == pytest.approx(1.0)


PLAIN = {
    "direction": physics.direction,
    "min_difference": lambda *angles: [physics.min_difference(*angles)],
    "closest_point_on_line": lambda *x: physics.closest_point_on_line(complex(*x[:2]), complex(*x[2:4]), complex(*x[4:])),
    "narrow_phase_case_1": lambda x, y, radius: physics.narrow_phase_case_1(complex(x, y), radius),
    "narrow_phase_case_2": lambda x, y, *more: physics.narrow_phase_case_2(complex(x, y), *more),
}


@pytest.mark.parametrize("box", boxes(), ids=lambda box: box.name)
def test_floats_of_a_box_are_within_its_bound(box):
    """The function as everybody calls it, at random floats of the box, against the formula."""
    chance = Random(5)
    for _ in range(200):
        inputs = [chance.uniform(*side) for side in box.ranges]
        function, _, which = box.name.partition(", ")
        before, after = [0.0] * which.startswith("0 and"), [0.0] * which.endswith("and 0")
        found = PLAIN[function](*before, *inputs, *after)
        try:
            expected = box.formula([arb(x) for x in inputs])
        except ValueError:
            continue
        if expected is None or found is None:
            assert expected is None
            assert found is None
            continue
        parts = found if isinstance(found, list) else [found.real, found.imag]
        assert all(abs(arb(part) - one) <= box.bound for part, one in zip(parts, expected, strict=True))


def _box(name):
    """The first box of that name."""
    return next(box for box in boxes() if box.name.startswith(name))


@pytest.mark.parametrize(
    ("name", "mistake"),
    [
        ("min_difference", {"signed_difference": lambda a, b: a - b}),
        ("closest_point_on_line, beside", {"dot": lambda a, b: a.real * b.real - a.imag * b.imag}),
        ("closest_point_on_line, all around", {"dot": lambda a, b: a.real * b.real + a.imag * b.imag + 1e-9}),
        ("narrow_phase_case_1", {"length": lambda a: (a.real * a.real + a.imag * a.imag).sqrt() + 0.01}),
        ("narrow_phase_case_2, beside", {"quarter_turn": lambda a: RoundedPoint(a.imag, -a.real)}),
        ("narrow_phase_case_2, outer corner", {"on_left": lambda a, b: a < b}),
        ("narrow_phase_case_2, all around", {"on_left": lambda a, b: a < b}),
    ],
)
def test_another_function_is_told_apart(name, mistake):
    """A fold forgotten, a sign, a slip of 1e-9, the wrong end: its exact value is not the formula's."""
    box = _box(name)
    function = getattr(physics, name.partition(",")[0])
    code = catalogue._code(function, **({"direction": catalogue._direction} if "case_2" in name else {}), **mistake)
    calls = {
        "min_difference": lambda x: code(*x),
        "closest_point_on_line": lambda x: code(RoundedPoint(*x[:2]), RoundedPoint(*x[2:4]), RoundedPoint(*x[4:])),
        "narrow_phase_case_1": lambda x: code(RoundedPoint(x[0], x[1]), x[2]),
        "narrow_phase_case_2": lambda x: code(RoundedPoint(x[0], x[1]), *x[2:]),
    }
    proof = proof_of(box._replace(call=calls[name.partition(",")[0]]), 2500)
    assert proof.wrong is not None


@pytest.mark.parametrize(
    "mistake",
    [
        {"_HALF_PI_MIDDLE": 0.0},
        {"_HALF_PI_LOW": 1e-14},
        {"_cos_sin": lambda x: (1.0 - x * x * 0.5 + x * x * x * x * (1 / 24), x - x * x * x * (1 / 6))},
    ],
)
def test_another_direction_is_not_proved(mistake):
    """A part of pi left out, 1e-14 too much of it, two terms of each series."""
    box = _box("direction")
    names = {"math": SeriesMath, "complex": lambda cosine, sine: (cosine, sine), **mistake}
    on_series = on_other_numbers(physics.direction, names)
    code = catalogue._code(physics.direction, **mistake)
    proof = proof_of(box._replace(call=lambda x: code(x[0]), off=lambda *side: direction_off(on_series, *side)), 500)
    assert proof.proved < 0.15  # the middle quadrant takes nothing of pi away


def test_a_bound_that_does_not_hold_is_not_proved():
    """A tenth of the error that there is."""
    box = _box("closest_point_on_line, beside")
    proof = proof_of(box._replace(bound=2e-16), 500)
    assert (proof.proved, proof.wrong) == (0.0, None)
    assert proof.loose > 0.5


def test_a_box_that_is_a_point_is_proved_at_once():
    """Nothing to halve."""
    point = Box("min_difference", ((1.0, 1.0), (2.0, 2.0)), lambda x: abs(x[0] - x[1]), formulas.min_difference, 1e-15)
    assert proof_of(point, 10)[2:] == (1.0, 0.0, 0.0, pytest.approx(1.1e-16, rel=0.02), None, 1)
