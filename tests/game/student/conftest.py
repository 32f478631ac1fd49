"""Files of own functions, whose child processes end with their test."""

import pytest

from game.student.functions_file import OWN_LIMITS, FunctionsFile

PATIENT = OWN_LIMITS._replace(answer=600.0, start=600.0)
"""Seconds that only a fault can use up."""


@pytest.fixture
def own(tmp_path):
    """Opens a file of own functions with some text."""
    opened = []

    def file(text, limits=PATIENT):
        path = tmp_path / "mine.py"
        path.write_text(text, encoding="utf-8")
        opened.append(FunctionsFile(path, limits))
        return opened[-1]

    yield file
    for one in opened:
        one.close()
