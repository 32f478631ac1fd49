"""Students' mistakes are found and named; what is right, or goes beyond the source, has full marks."""

import shutil
import subprocess
from collections import Counter

import pytest

import physics
from game.lab.session.share import parsed
from game.lab.yours.calls import calls_of
from game.student.signatures import SIGNATURES, agrees, answer
from tests.grade.wrong_files import RIGHT, WRONG_FILES
from tests.support.paths import ROOT
from tools.grade.findings import all_findings
from tools.grade.grading import grade
from tools.grade.lab_line import lab_line
from tools.grade.mistakes import MISTAKES
from tools.grade.report import report_lines
from tools.grade.scheme import Scheme

pytestmark = pytest.mark.deep


def graded(student, vectors):
    """The grade of a student's program."""
    return grade(student, vectors, Scheme())


def wrong_functions(found):
    """The names of the functions that are wrong."""
    return {function.name for function in found.functions if function.defined and not function.right}


def test_the_right_file_has_full_marks(students, published):
    """Every function is there, every answer is right; lines and slide 5's rule for the end are reported apart."""
    found = graded(students(RIGHT.read_text(encoding="utf-8")), published)
    assert (found.right, found.score, wrong_functions(found)) == (True, 100.0, set())
    assert [function.name for function in found.functions if not function.defined] == []
    lines = list(report_lines(found, all_findings(found)))
    assert lines[-1] == "RIGHT: score 100.0 of 100, 13 of 13 functions right, seed 0"
    assert any("line in place of segment" in line for line in lines[lines.index("Beyond the source (does not count)") :])


ENGINE = f"""
import sys

sys.path.insert(0, {str(ROOT)!r})
import physics
from physics import *
from physics import Outcome, Ring


def on_left(a, b):
    return physics.on_left(normalize_angle(a), normalize_angle(b))


def broad_phase_outcome(p, r, r_g, r_p, w_p, r_b, w_b):
    names = {{Outcome.GAME_OVER: "game over", Outcome.PADDLES: "paddles", Outcome.BRICKS: "bricks"}}
    rings = Ring(r_p, w_p, 0.5, 1), [Ring(r_b, w_b, 0.5, 1)]
    return names.get(physics.broad_phase_outcome(p, r, r_g, *rings), "no collision")
"""


def test_the_games_own_functions_have_full_marks(students, published):
    """They go beyond the source: a segment, wide sectors, a ball that is carried. None of it counts against them."""
    found = graded(students(ENGINE), published)
    assert (found.right, found.score, wrong_functions(found)) == (True, 100.0, set())
    assert [function.name for function in found.functions if not function.defined] == []
    topics = {(function.name, topic) for function in found.functions for topic, (own, _) in function.topics.items() if own == 0}
    assert {
        ("closest_point_on_line", "segment"),
        ("narrow_phase_case_2", "segment"),
        ("narrow_phase_case_2", "wide sector"),
        ("collision_response", "carried"),
    } <= topics


@pytest.mark.parametrize("wrong", WRONG_FILES, ids=lambda wrong: f"{wrong.name}: {wrong.wrong.strip()}")
def test_a_mistake_is_found_and_named(students, published, wrong):
    """In just the functions that it makes wrong, by one name in all of them; and the lab shows a wrong answer."""
    found = graded(students(wrong.text()), [vector for vector in published if vector.number % 3 == 1])
    findings = all_findings(found)
    assert wrong_functions(found) == wrong.functions
    assert not found.right
    assert found.score < 100.0
    for name in wrong.functions:
        assert [mistake.name for mistake in findings[name].mistakes] == [wrong.name], name
        assert findings[name].lab_line is not None
    lines = list(report_lines(found, findings))
    assert lines[-1].startswith("WRONG: score ")
    assert "score 100.0" not in lines[-1]


def test_two_mistakes_in_one_function_are_both_named(students, published):
    """Neither of them alone explains the answers."""
    text = (
        RIGHT.read_text(encoding="utf-8").replace("change_n = -2 * dv_n", "change_n = -dv_n").replace("dv = v - v_p", "dv = v")
    )
    found = graded(students(text), [vector for vector in published if vector.function == "collision_response"])
    named = {mistake.name for mistake in all_findings(found)["collision_response"].mistakes}
    assert named == {"half a bounce", "v_p forgotten"}


def test_a_mistake_beside_a_refinement_is_named(students, published):
    """A segment in place of the line hides no mistake, and is not called one."""
    text = RIGHT.read_text(encoding="utf-8")
    text = text.replace("ab * (dot(p - a, ab) / dot(ab, ab))", "ab * min(max(dot(p - a, ab) / dot(ab, ab), 0.0), 1.0)")
    text = text.replace("    return (p - q) / abs(p - q)", "    return (q - p) / abs(p - q)")
    found = graded(students(text), published)
    assert wrong_functions(found) == {"narrow_phase_case_2", "broad_phase"}
    named = all_findings(found)["narrow_phase_case_2"].mistakes
    assert [mistake.name for mistake in named] == ["normal the wrong way round"]


@pytest.mark.parametrize(
    ("line", "wrong"),
    [
        ("change_n = -2 * dv_n", "change_n = -2.3 * dv_n + 0.1"),
        ("change_t = -mu_p *", "change_t = -(mu_p if mu_p < 0.5 else 0) *"),
    ],
)
def test_an_unknown_mistake_has_no_name(students, published, line, wrong):
    """Nothing is guessed, also where a mistake would explain the wrong answers, but not the right ones."""
    text = RIGHT.read_text(encoding="utf-8").replace(line, wrong)
    found = graded(students(text), [vector for vector in published if vector.function == "collision_response"])
    assert wrong_functions(found) == {"collision_response"}
    assert all_findings(found)["collision_response"].mistakes == ()


@pytest.mark.parametrize("number", range(len(MISTAKES)), ids=lambda number: MISTAKES[number].name)
def test_every_mistake_of_the_catalogue_fails_a_vector(published, number):
    """One that the vectors cannot see would be graded as right."""
    functions = MISTAKES[number].functions()
    for vector in published:
        try:
            given = answer(functions, vector.function, vector.arguments)
        except ZeroDivisionError:
            continue
        kind = SIGNATURES[vector.function].result
        accepted = [vector.expected, *vector.also.values()]
        if vector.defined and not any([agrees(kind, given, expected, vector.tolerance) for expected in accepted]):
            return
    pytest.fail("every vector is answered rightly")


def test_the_lab_shows_vectors_of_every_function(published):
    """Each function has a scene that takes nearly all of its calls."""
    for name in SIGNATURES:
        lines = [lab_line(vector) for vector in published if vector.function == name and vector.defined]
        assert len([line for line in lines if line is not None]) > 0.9 * len(lines), name


def test_the_lab_draws_what_it_is_given(published):
    """A line of every function and trap opens, and its scene's claims hold."""
    seen = set()
    for vector in published:
        line = lab_line(vector) if (vector.function, vector.trap) not in seen else None
        if line is not None:
            seen.add((vector.function, vector.trap))
            scene, given, *_ = parsed(line)
            assert scene.shows(given).panes
            assert [claim for claim in scene.check(given) if not claim.holds] == [], line
    assert {function for function, _ in seen} == set(SIGNATURES)


def test_the_lab_shows_a_bounce_turned(published):
    """The scene's bounce, whose normal is upwards unless the surface moves along it, is the vector's, turned."""
    scenes = Counter()
    for vector in published:
        line = lab_line(vector) if vector.function == "collision_response" and vector.defined and not vector.also else None
        if line is None:
            continue
        (call,) = calls_of(parsed(line).scene.name, parsed(line).given)
        after = physics.collision_response(*[complex(*call.arguments[k : k + 2]) for k in (0, 2, 4)], *call.arguments[6:])
        turned = complex(*vector.expected) * complex(*call.arguments[2:4]) / complex(*vector.arguments[2:4])
        assert abs(after - turned) < 1e-9 * vector.arguments[7], line
        scenes[parsed(line).scene.name] += 1
    assert all(scenes[name] > 50 for name in ("response-wall", "response-paddle", "moving-surface")), scenes


CPP_MISTAKES = {
    "friction unclamped": ("std::min(std::abs(dv_n), slip)", "slip", {"collision_response"}),
    "wrong sign at |p| < r_p": (
        "std::abs(p) < r_p ? -n : n",
        "std::abs(p) < r_p ? n : -n",
        {"narrow_phase_case_1", "broad_phase"},
    ),
}


@pytest.mark.skipif(shutil.which("g++") is None, reason="no g++")
@pytest.mark.parametrize("name", CPP_MISTAKES)
def test_a_mistake_in_cpp_is_found_and_named(students, published, tmp_path, name):
    """The same names as for a Python file."""
    line, wrong, functions = CPP_MISTAKES[name]
    right = (ROOT / "tests" / "grade" / "students" / "student.hpp").read_text(encoding="utf-8")
    assert right.count(line) == 1
    (tmp_path / "student.hpp").write_text(right.replace(line, wrong), encoding="utf-8")
    adapter, program = ROOT / "docs" / "adapters" / "adapter.cpp", tmp_path / "student"
    subprocess.run([shutil.which("g++"), "-std=c++17", "-I", tmp_path, "-o", program, adapter], check=True)
    found = graded(students([str(program)]), published)
    findings = all_findings(found)
    assert wrong_functions(found) == functions
    for function in functions:
        assert [mistake.name for mistake in findings[function].mistakes] == [name]
