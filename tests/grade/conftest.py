"""The vectors of a seed, made once; and students' programs that end with their test."""

from functools import cache
from pathlib import Path

import pytest

from game.student.program import Limits, Student, next_line, python_host
from tools.vectors.vector import vectors

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
        command, file = program, None
        if isinstance(program, str):
            Path(tmp_path / "mine.py").write_text(program, encoding="utf-8")
            file = tmp_path / "mine.py"
            command = python_host(limits, file)
        started.append(Student(command, limits, wait, file))
        return started[-1]

    yield start
    for student in started:
        student.close()
