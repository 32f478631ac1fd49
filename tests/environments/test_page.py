"""The page on the environments, and the example that it shows."""

import re
import runpy
import sys
import warnings

import pytest

from tests.support.paths import ROOT

pytestmark = pytest.mark.deep


def test_the_example_of_the_page_runs():
    """As it stands; a hundred steps of 1,024 games bring some points."""
    text = (ROOT / "docs" / "environments.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    seen = {}
    with warnings.catch_warnings():
        exec(example, seen)  # noqa: S102  # the project's own page
    assert seen["observations"] in seen["many"].observation_space
    assert seen["infos"]["score"].max() > 0


def test_the_example_agent_trains(monkeypatch, capsys):
    """Two generations: a line for each, one before and one after them."""
    monkeypatch.setattr(sys, "argv", ["train_agent.py", "--generations", "2", "--agents", "16"])
    runpy.run_path(str(ROOT / "docs" / "examples" / "train_agent.py"), run_name="__main__")
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["at", "generation", "generation", "trained,"]
