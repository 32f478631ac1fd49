"""`python -m tools.bench`: its rows, its file, and what it says without numba."""

import json
import re
import sys

import pytest

from game.system.errors import BadInputError, EnvironmentMissingError
from tools.measure import scaling, whole_games
from tools.measure.tick import bench


@pytest.fixture(autouse=True)
def _short_games(monkeypatch):
    monkeypatch.setattr(whole_games, "_TICKS", 600)


def test_the_file_has_every_row_of_the_table(tmp_path, capsys):
    """Name, balls, the time of every round and their median, in nanoseconds a ball-step."""
    assert bench(rounds=3, ticks=100, batch=False, json_file=tmp_path / "bench.json") == 0
    table = capsys.readouterr().out
    written = json.loads((tmp_path / "bench.json").read_text(encoding="utf-8"))
    assert (written["rounds"], written["ticks"]) == (3, 100)
    assert len(written["rows"]) in {8, 9}  # with Box2D
    for row in written["rows"]:
        assert row["name"] in table
        assert len(row["ns"]) == 3
        assert sorted(row["ns"])[1] == row["median_ns"] > 0.0


def test_an_earlier_file_is_shown_beside(tmp_path, capsys):
    """Its nanoseconds and its ratio; a row that it does not have is left open; what is no such file is bad input."""
    file = tmp_path / "then.json"
    rows = [
        {"name": "physics.advance, 48 bricks", "median_ns": 1234.5},
        {"name": "physics.advance, 12 bricks", "median_ns": 617.25},
    ]
    file.write_text(json.dumps({"rows": rows}))
    assert bench(rounds=1, ticks=100, batch=False, compare=file) == 0
    out = capsys.readouterr().out
    assert re.search(r"advance, 48 bricks .* 1,234\.5 .* 1\.000", out)
    assert re.search(r"advance, 12 bricks .* 617\.2 .* 2\.000", out)
    assert re.search(r"pymunk, arcs of 16 facets .* - +│ +- ", out)
    assert re.search(r"headless game with the autopilot: [\d,]+ times real time", out)
    file.write_text("{}")
    with pytest.raises(BadInputError, match="expected a file that --json has written"):
        bench(rounds=1, ticks=100, batch=False, compare=file)


@pytest.mark.parametrize("compiled", [False, pytest.param(True, marks=pytest.mark.deep)])
def test_the_plot_is_a_picture(tmp_path, monkeypatch, compiled):
    """With and without the compiled batch; of few points here."""
    if not compiled:
        monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.setattr(scaling, "BRICKS_A_ROW", (4, 8))
    monkeypatch.setattr(scaling, "BALLS", (1, 2))
    monkeypatch.setattr(scaling, "_PYMUNK_BALLS", (1, 2))
    assert bench(rounds=1, ticks=100, plot=tmp_path / "scaling.png") == 0
    assert (tmp_path / "scaling.png").read_bytes().startswith(b"\x89PNG")


def test_without_numba_the_rows_of_the_batch_are_left_out(monkeypatch, capsys):
    """One line says what to install; insisted on, it is an error of the environment, exit code 3."""
    monkeypatch.setitem(sys.modules, "numba", None)
    assert bench(rounds=1, ticks=100) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "without the batch: physics.batch needs numba" in out
    assert "physics.batch, 48 bricks" not in out
    with pytest.raises(EnvironmentMissingError, match=r"install the extra \[batch\]"):
        bench(rounds=1, ticks=100, batch=True)
