"""The vectors of a seed, made once; and students' programs that end with their test."""

import sys
from functools import cache
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tools.grade.student import Limits, Student, next_line
from tools.vectors.vector import vectors

HOST = ROOT / "tools" / "grade" / "python_host.py"
PATIENT = Limits(answer=600.0, start=600.0)
"""Seconds that only a fault can use up."""


@pytest.fixture(scope="session")
def vectors_of():
    """The vectors of a seed, made once: that takes a second and a half."""
    return cache(vectors)


@pytest.fixture(scope="session")
def published(vectors_of):
    """The vectors of seed 0."""
    return vectors_of(0)


@pytest.fixture
def students(tmp_path):
    """Starts a student's program: the text of a Python file, or a command."""
    started = []

    def start(program, limits=PATIENT, wait=next_line):
        command = program
        if isinstance(program, str):
            Path(tmp_path / "mine.py").write_text(program, encoding="utf-8")
            command = [sys.executable, str(HOST), str(tmp_path / "mine.py")]
        started.append(Student(command, limits, wait))
        return started[-1]

    yield start
    for student in started:
        student.close()
