"""The sweep: which games it plays, what it writes of them, and that it goes on where it was stopped."""

import csv

import pytest

from game.levels import chosen
from game.rules import SOURCE_RULES
from game.system.command_line import run
from tools.sweep import commands
from tools.sweep.plan import Axes, grid, sample
from tools.sweep.play import Row, played
from tools.sweep.plots import plot
from tools.sweep.table import summaries

LEVELS = (chosen("First Wall")[0], chosen("Towers")[0])
AXES = Axes(LEVELS, ["autopilot", "220/5"], [0.5, 0.9], [0.0, 1.0], [1.0])
FEW = ["--level", "First Wall", "--players", "autopilot,150/2", "--top-speed", "0.6,0.9", "--seeds", "2", "--minutes", "0.05"]


def sweep(capsys, *arguments):
    """Exit code, stdout and stderr."""
    code = run(commands.app, "sweep", [str(argument) for argument in arguments])
    return code, *capsys.readouterr()


def rows_of(path):
    """The rows of a CSV table."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_a_grid_has_every_combination():
    """With every seed; the level's own numbers are multiplied, its friction is replaced."""
    plan = grid(AXES, 3, SOURCE_RULES, 100)
    assert len(plan.jobs) == len({repr(job) for job in plan.jobs}) == 2 * 2 * 2 * 2 * 3
    job = next(job for job in plan.jobs if (job.top_speed, job.friction) == (0.5, 1.0))
    assert job.level.paddles.top_speed == 0.5 * LEVELS[0].paddles.top_speed
    assert job.level.paddles.friction == 1.0
    assert not plan.left_out


def test_a_point_that_cannot_be_played_is_left_out_and_named():
    """Paddles faster than the ball."""
    plan = grid(AXES._replace(top_speeds=[0.5, 5.0], players=["autopilot"], frictions=[]), 1, SOURCE_RULES, 100)
    assert len(plan.jobs) == 2
    assert len(plan.left_out) == 2
    assert all("paddles.top_speed: must be below the ball's" in reason for reason in plan.left_out)


def test_a_sample_is_drawn_between_the_ends_of_the_axes():
    """The same for the same seed; levels and players in turn."""
    plan = sample(AXES, 40, 7, SOURCE_RULES, 100)
    assert plan == sample(AXES, 40, 7, SOURCE_RULES, 100) != sample(AXES, 40, 8, SOURCE_RULES, 100)
    assert {job.player for job in plan.jobs[:2]} == {"autopilot", "220/5"}
    assert all(0.5 <= job.top_speed <= 0.9 and 0.0 <= job.friction <= 1.0 and job.ball_speed == 1.0 for job in plan.jobs)
    assert len({job.friction for job in plan.jobs}) == 40


def test_a_row_says_what_happened():
    """The autopilot clears the first level in a minute and a half; the row's numbers hang together."""
    (job,) = grid(Axes(LEVELS[:1], ["autopilot"], [1.0], [], [1.0]), 1, SOURCE_RULES, 21_600).jobs
    row = played(job)
    assert row.cleared
    assert (row.level, row.friction, row.lost) == ("First Wall", LEVELS[0].paddles.friction, 0)
    assert row.impacts >= 24
    assert 0.0 < row.longest_gap < row.seconds < 90.0
    assert 0.0 < row.impacts_per_tick < row.impacts / (row.seconds * 240.0) * 1.5
    (point,) = summaries([row, row._replace(cleared=False, loops=4)])
    assert (point.games, point.cleared, point.seconds, point.loops) == (2, 0.5, row.seconds, row.loops / 2 + 2)


def test_two_workers_write_what_one_writes(capsys, tmp_path):
    """The same table; also as Parquet; a picture beside it."""
    pytest.importorskip("pyarrow")
    from pyarrow import parquet  # noqa: PLC0415

    one, two, picture = tmp_path / "one.csv", tmp_path / "two.parquet", tmp_path / "sweep.png"
    assert sweep(capsys, *FEW, "--out", one)[0] == 0
    code, out, _ = sweep(capsys, *FEW, "--out", two, "--workers", 2, "--plot", picture)
    assert code == 0
    assert "8 games at 4 points" in out
    table = parquet.read_table(two)
    assert [{name: str(value) for name, value in row.items()} for row in table.to_pylist()] == rows_of(one)
    assert tuple(table.column_names) == Row._fields
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.csv", "sweep.png", "two.parquet"]


def test_a_sweep_that_was_stopped_goes_on(capsys, monkeypatch, tmp_path):
    """Ctrl-C leaves the rows until then; with --resume the rest is played, and the table is the same as in one go."""
    whole, out = tmp_path / "whole.csv", tmp_path / "games.csv"
    sweep(capsys, *FEW, "--out", whole)

    def interrupted(function, jobs, _):
        yield from map(function, jobs[:3])
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(commands, "results", interrupted)
        code, told, _ = sweep(capsys, *FEW, "--out", out)
    assert code == 130
    assert "partial result, 3 of 8 games" in told
    assert not out.exists()
    assert rows_of(tmp_path / "games.partial.csv") == rows_of(whole)[:3]
    journal = tmp_path / "games.csv.journal"
    journal.write_text(journal.read_text() + '["cut o')  # as a kill in the middle of a line leaves it
    asked = []

    def counted(function, jobs, _):
        asked.extend(jobs)
        yield from map(function, jobs)

    monkeypatch.setattr(commands, "results", counted)
    assert sweep(capsys, *FEW, "--out", out, "--resume")[0] == 0
    assert len(asked) == 5
    assert out.read_bytes() == whole.read_bytes()
    assert not journal.exists()


def test_other_games_are_not_gone_on_with(capsys, tmp_path):
    """The journal has the hash of all games."""
    (tmp_path / "games.csv.journal").write_text("0" * 64 + "\n")
    code, _, err = sweep(capsys, *FEW, "--out", tmp_path / "games.csv", "--resume")
    assert code == 2
    assert "is of other games" in err


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["--out", "table.txt"], "--out table.txt: expected a name that ends in .csv or .parquet"),
        (["--out", "no/folder/table.csv"], "there is no folder no/folder"),
        (["--out", "table.csv", "--resume"], "--resume: there is no table.csv.journal"),
        (["--out", "table.csv", "--players", "nobody"], "expected MS/DEG"),
        (["--out", "table.csv", "--top-speed", "1,fast"], "--top-speed 1,fast: expected numbers from 0.1 to 10"),
        (["--out", "table.csv", "--friction", "1.5"], "--friction 1.5: expected numbers from 0 to 1"),
        (["--out", "table.csv", "--rules", "nice"], "--rules nice: expected one of source, easy, normal, hard"),
        (["--out", "table.csv", "--samples", "3", "--seeds", "2"], "--seeds: does nothing beside --samples"),
        (["--out", "table.csv", "--seed", "3"], "--seed: needs --samples"),
        (["--out", "table.csv", "--cluster", "tcp://a:1", "--workers", "2"], "--workers: does nothing beside --cluster"),
        (["--out", "table.csv", "--top-speed", "9"], "no point can be played"),
    ],
)
def test_bad_input_is_named(capsys, monkeypatch, tmp_path, arguments, reason):
    """Exit code 2, one line for it, nothing written."""
    monkeypatch.chdir(tmp_path)
    code, out, err = sweep(capsys, "--level", "First Wall", *arguments)
    assert (code, out) == (2, "")
    assert reason in err.splitlines()[-1]
    assert [*tmp_path.iterdir()] == []


def test_a_picture_of_a_random_sample_has_lines():
    """Many values of an axis are put together."""
    rows = [Row("a", "autopilot", k, 1.0 + k / 50, 0.5, 1.0, k % 2 == 0, 9.0, 0, 10, 3, 0.01, 0, 1.0) for k in range(50)]
    assert plot(summaries(rows)).startswith(b"\x89PNG")
