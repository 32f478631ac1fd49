"""The adapters in docs/adapters/, compiled and run where this machine has what they need."""

import shutil
import subprocess
import sys

import pytest

from game.student.signatures import SIGNATURES
from tests.grade.wrong_files import RIGHT
from tests.support.paths import ROOT
from tools.grade.grading import grade
from tools.grade.scheme import Scheme

pytestmark = pytest.mark.deep

ADAPTERS = ROOT / "docs" / "adapters"
STUDENTS = ROOT / "tests" / "grade" / "students"
BUILDS = {
    "adapter.cpp": (
        "g++",
        ["g++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-o", "student", "adapter.cpp"],
        ["{}/student"],
    ),
    "Adapter.java": ("javac", ["javac", "Adapter.java", "Student.java"], ["java", "-cp", "{}", "Adapter"]),
    "adapter.js": ("node", None, ["node", "{}/adapter.js"]),
    "adapter.rs": ("rustc", ["rustc", "-o", "student", "adapter.rs"], ["{}/student"]),
    "adapter.py": (sys.executable, None, [sys.executable, "{}/adapter.py"]),
}
"""For each adapter the program that must be there, how it is built, and how it is run."""
WITHOUT = {
    "Adapter.java": {"collision_response"},
    "adapter.js": {"broad_phase_outcome", "broad_phase", "closest_point_on_line", "narrow_phase_case_2"},
}
"""Functions that the student's program leaves out."""


@pytest.mark.parametrize("adapter", BUILDS)
def test_an_adapter_carries_every_answer(students, published, tmp_path, adapter):
    """A right program has full marks through it; what the program lacks is not defined, and does not count."""
    needed, build, run = BUILDS[adapter]
    if shutil.which(needed) is None:
        pytest.skip(f"no {needed}")
    for file in [ADAPTERS / adapter, *STUDENTS.iterdir()]:
        shutil.copy(file, tmp_path)
    shutil.copy(RIGHT, tmp_path / "student.py")
    if build is not None:
        subprocess.run(build, cwd=tmp_path, check=True)
    student = students([word.format(tmp_path) for word in run])
    found = grade(student, [vector for vector in published if vector.number % 5 == 0], Scheme())
    missing = WITHOUT.get(adapter, set())
    assert {function.name for function in found.functions if function.right} == set(SIGNATURES) - missing
    assert {function.name for function in found.functions if not function.defined} == missing
    assert (found.right, found.score) == (True, 100.0)


@pytest.mark.parametrize("adapter", sorted(path.name for path in ADAPTERS.iterdir()))
def test_an_adapter_fits_a_page(adapter):
    """Below 60 lines, so that a student can read it."""
    assert len((ADAPTERS / adapter).read_text(encoding="utf-8").splitlines()) < 60


def test_there_is_one_for_every_language():
    """C++, C#, Java, JavaScript, Rust and Python; the one in C# is not run, since dotnet needs a project around it."""
    assert {path.name for path in ADAPTERS.iterdir()} == {*BUILDS, "Adapter.cs"}
