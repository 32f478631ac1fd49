"""`python -m tools.bench`: its rows, its file, and what it says without numba."""

import json
import sys

import pytest

from game.system.errors import EnvironmentMissingError
from tools.measure.tick import bench


def test_the_file_has_every_row_of_the_table(tmp_path, capsys):
    """Name, balls, the time of every round and their median, in nanoseconds a ball-step."""
    assert bench(rounds=3, ticks=100, batch=False, json_file=tmp_path / "bench.json") == 0
    table = capsys.readouterr().out
    written = json.loads((tmp_path / "bench.json").read_text(encoding="utf-8"))
    assert (written["rounds"], written["ticks"]) == (3, 100)
    assert len(written["rows"]) == 7
    for row in written["rows"]:
        assert row["name"] in table
        assert len(row["ns"]) == 3
        assert sorted(row["ns"])[1] == row["median_ns"] > 0.0


def test_without_numba_the_rows_of_the_batch_are_left_out(monkeypatch, capsys):
    """One line says what to install; insisted on, it is an error of the environment, exit code 3."""
    monkeypatch.setitem(sys.modules, "numba", None)
    assert bench(rounds=1, ticks=100) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "without the batch: physics.batch needs numba" in out
    assert "physics.batch, 48 bricks" not in out
    with pytest.raises(EnvironmentMissingError, match=r"install the extra \[batch\]"):
        bench(rounds=1, ticks=100, batch=True)
