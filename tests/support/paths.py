"""Where the project and the tests' files are."""

from pathlib import Path

TESTS = Path(__file__).parent.parent
ROOT = TESTS.parent
GOLDEN = TESTS / "golden"
REFERENCE = TESTS / "reference"
LAB_CASES = TESTS / "lab_cases.txt"
