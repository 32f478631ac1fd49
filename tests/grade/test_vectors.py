"""The conformance vectors: their results, their files, and the command that writes them."""

import csv
import json
import math
from collections import Counter

import pytest

from game.student.engine_functions import EngineFunctions
from game.student.signatures import OUTCOMES, SIGNATURES, agrees, answer
from game.system.command_line import run
from tests.support.oracles import source_oracle
from tools.vectors.commands import app
from tools.vectors.files import COLUMNS, FORMAT, csv_text, json_text
from tools.vectors.inputs.angles import angle_plans
from tools.vectors.inputs.chosen import ChosenInput
from tools.vectors.inputs.detection import detection_plans
from tools.vectors.inputs.response import response_plans
from tools.vectors.vector import is_stable, vector_of


def point(numbers):
    """A complex number of two floats."""
    return complex(*numbers)


ORACLE = {
    "broad_phase_outcome": lambda a: source_oracle.outcome(point(a[:2]), *a[2:]).removeprefix("broad phase with "),
    "min_difference": lambda a: source_oracle.min_difference(*a),
    "broad_phase": lambda a: source_oracle.broad_phase(
        point(a[:2]), a[2], a[3], list(zip(a[6::2], a[7::2], strict=True)), a[4], a[5]
    ),
    "narrow_phase_case_1": lambda a: source_oracle.narrow_phase_case_1(point(a[:2]), a[2]),
    "on_left": lambda a: source_oracle.on_left(*a),
    "to_cartesian": lambda a: source_oracle.to_cartesian(*a),
    "closest_point_on_line": lambda a: source_oracle.closest_point_on_line(point(a[:2]), point(a[2:4]), point(a[4:])),
    "narrow_phase_case_2": lambda a: source_oracle.narrow_phase_case_2(point(a[:2]), *a[2:]),
    "collision_response": lambda a: source_oracle.collision_response(point(a[:2]), point(a[2:4]), point(a[4:6]), *a[6:]),
    "normalize_angle": lambda a: source_oracle.normalize_angle(*a),
    "add_angles": lambda a: source_oracle.normalize_angle(a[0] + a[1]),
    "subtract_angles": lambda a: source_oracle.normalize_angle(a[0] - a[1]),
    "to_polar": lambda a: source_oracle.to_polar(point(a)),
}
"""The slides' pseudocode, transcribed a second time for the tests of the physics, in floats."""


def test_the_arithmetic_of_floats_has_the_same_results(published):
    """Where no mpmath is: the same answers within the tolerance, the same refinements, the same divisions by zero."""
    for exact in published:
        chosen = ChosenInput(exact.function, exact.trap, exact.arguments)
        found = vector_of(chosen, exact.number, exact=False)
        assert (found.defined, list(found.also)) == (exact.defined, list(exact.also)), exact
        kind = SIGNATURES[exact.function].result
        assert not exact.defined or agrees(kind, found.expected, exact.expected, exact.tolerance), exact


@pytest.mark.parametrize("seed", [0, 1])
def test_the_results_are_the_slides(vectors_of, seed):
    """A transcription that shares no code with the vectors answers the same, and divides by zero where they are undefined."""
    for vector in vectors_of(seed):
        try:
            found = ORACLE[vector.function](vector.arguments)
        except ZeroDivisionError:
            assert not vector.defined, vector
            continue
        plain = [found.real, found.imag] if isinstance(found, complex) else list(found) if isinstance(found, tuple) else found
        assert vector.defined, vector
        assert agrees(SIGNATURES[vector.function].result, plain, vector.expected, vector.tolerance), vector


def test_there_are_enough_of_every_trap(published):
    """More than 5,000 in all, at least 300 of each function; every planned trap is there as often as planned, no call twice."""
    assert len(published) >= 5000
    assert min(Counter([vector.function for vector in published]).values()) >= 300
    traps = Counter([(vector.function, vector.trap) for vector in published])
    for plan in (*angle_plans(), *detection_plans(), *response_plans()):
        assert traps[plan.function, plan.trap] >= plan.amount
    assert len({(vector.function, vector.arguments) for vector in published}) == len(published)


def test_the_traps_of_the_source_are_sprung(published):
    """Seam, corner, wide sector, carried ball, friction 1, v_res = 0: each has vectors that tell one answer from another."""
    answered = {(vector.function, vector.trap, topic) for vector in published for topic in vector.also}
    assert ("narrow_phase_case_2", "corner", "segment") in answered
    assert ("narrow_phase_case_2", "wide sector", "wide sector") in answered
    assert ("collision_response", "carried", "carried") in answered
    undefined = {(vector.function, vector.trap) for vector in published if not vector.defined}
    assert undefined == {
        ("narrow_phase_case_1", "p = 0"),
        ("closest_point_on_line", "A = B"),
        ("collision_response", "v_res = 0"),
    }
    outcomes = {vector.expected for vector in published if vector.function == "broad_phase_outcome"}
    assert outcomes == set(OUTCOMES)


def test_the_inputs_are_short_numbers(published):
    """Two decimals, but for an angle that follows from a point, and the products of a direction's three decimals."""
    for vector in published:
        if vector.function in {"min_difference", "on_left", "to_cartesian", "narrow_phase_case_1", "closest_point_on_line"}:
            assert all(number == round(number, 2) or number == math.pi for number in vector.arguments), vector
        if vector.function == "collision_response":
            assert all(number == round(number, 6) for number in vector.arguments), vector


def test_another_seed_makes_other_vectors(vectors_of, published):
    """That the same seed makes the same again is seen below, where the command makes those of seed 0 a second time."""
    other = {(vector.function, vector.arguments) for vector in vectors_of(1)}
    assert len(other & {(vector.function, vector.arguments) for vector in published}) < 0.2 * len(published)


def test_a_boundary_is_no_stable_input():
    """There rounding would decide: the ball's angle at the sector's end, |p| = r_p, the side of a direction."""
    assert not is_stable("narrow_phase_case_1", (3.0, 4.0, 5.0))
    assert not is_stable("on_left", (1.0, 1.0))
    assert not is_stable("broad_phase_outcome", (3.0, 4.0, 0.5, 4.5, 8.0, 0.5, 2.0, 0.5))
    assert is_stable("narrow_phase_case_1", (3.0, 4.0, 5.1))


def test_both_files_say_the_same(published):
    """Every vector in the order of the slides, its numbers exactly."""
    record = json.loads(json_text(published, 0))
    rows = list(csv.DictReader(csv_text(published).splitlines()))
    assert (record["format"], record["seed"], record["digits"]) == (FORMAT, 0, 50)
    assert list(record["functions"]) == list(SIGNATURES)
    assert tuple(rows[0]) == COLUMNS
    assert len(record["vectors"]) == len(rows) == len(published)
    for vector, one, row in zip(published, record["vectors"], rows, strict=True):
        assert (one["id"], one["function"], one["trap"]) == (row["id"], row["function"], row["trap"])
        assert tuple(one["arguments"]) == vector.arguments == tuple([float(word) for word in row["arguments"].split()])
        assert one["expected"] == vector.expected
        assert one["tolerance"] == float(row["tolerance"]) == vector.tolerance
        assert one.get("also", {}) == vector.also
        if isinstance(vector.expected, list):
            assert [float(word) for word in row["expected"].split()] == vector.expected
        elif isinstance(vector.expected, float) and not isinstance(vector.expected, bool):
            assert float(row["expected"]) == vector.expected
        elif vector.defined:
            assert row["expected"] == {None: "none", True: "true", False: "false"}.get(vector.expected, vector.expected)
        else:
            assert (row["defined"], row["expected"]) == ("false", "")


def write(capsys, *arguments):
    """Exit code, stdout and stderr of the command."""
    code = run(app, "python -m tools.vectors", [str(argument) for argument in arguments])
    return code, *capsys.readouterr()


def test_the_command_writes_both_files(capsys, tmp_path, published):
    """Into a folder that it makes; every line fits a reader. Seed 0 gives the same vectors, made a second time."""
    code, out, err = write(capsys, tmp_path / "a" / "b")
    assert (code, err) == (0, "")
    assert out.startswith(f"{len(published):,} vectors of 13 functions, seed 0: ")
    text = (tmp_path / "a" / "b" / "vectors.json").read_text(encoding="utf-8")
    assert text == json_text(published, 0)
    assert (tmp_path / "a" / "b" / "vectors.csv").read_text(encoding="utf-8") == csv_text(published)
    assert max(map(len, text.splitlines())) < 600


def test_bad_input_is_one_line_and_exit_code_2(capsys, tmp_path):
    """A file in place of the folder, or a seed that is none."""
    file = tmp_path / "file"
    file.write_text("")
    for arguments in ([file], [tmp_path, "--seed", "-1"], []):
        code, out, err = write(capsys, *arguments)
        assert (code, out, len(err.splitlines())) == (2, "", 1)


def test_without_mpmath_is_exit_code_3(capsys, tmp_path, monkeypatch):
    """The line says what to install."""
    monkeypatch.setitem(__import__("sys").modules, "mpmath", None)
    code, out, err = write(capsys, tmp_path)
    assert (code, out) == (3, "")
    assert "polar-breakout[grade]" in err


def test_the_engines_own_functions_answer_them(published):
    """Each by its name and its arguments in the slides' order; what goes beyond the source is among the other right results."""
    for vector in published[::7]:
        if vector.defined:
            kind, given = SIGNATURES[vector.function].result, answer(EngineFunctions(), vector.function, vector.arguments)
            accepted = [vector.expected, *vector.also.values()]
            assert any([agrees(kind, given, expected, vector.tolerance) for expected in accepted]), vector.name
