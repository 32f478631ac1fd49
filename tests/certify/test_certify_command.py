"""The command `python -m tools.certify`: its output, its file, its exit codes, and what it says to bad input."""

import json
import signal

import pytest

pytest.importorskip("flint", reason="the proofs need python-flint, the extra [proof]")

from game.system.command_line import run
from tools.certify import command, sources
from tools.certify import run as runs
from tools.certify.commands import app

NAME = "python -m tools.certify"


def certify(capsys, *arguments):
    """Exit code, stdout and stderr."""
    code = run(app, NAME, [str(argument) for argument in arguments])
    out, err = capsys.readouterr()
    return code, out, err


def test_true_claims_are_exit_code_0(capsys, tmp_path):
    """The verdict is the last line; the file says the same."""
    file = tmp_path / "result.json"
    code, out, err = certify(capsys, "arena:1:2", "arena:1:4", "--json", file)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1].startswith("CERTIFIED: ")
    result = json.loads(file.read_text(), parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    assert result["format"] == "polar-breakout certify 1"
    assert result["verdict"] == out.splitlines()[-1]
    assert (result["partial"], result["cases"], result["sources"]) == (False, [], 2)
    impacts = sum(kind["count"] for kind in result["counts"] if kind["impact"])
    assert impacts == sum(result["features"].values()) > 0


def test_a_false_claim_is_exit_code_1(capsys, monkeypatch):
    """Every time of impact is late by a nanosecond: the reason, how often, and which tick of which arena."""

    def late(arena, dt, speed):
        step = advance(arena, dt, speed)
        return step._replace(hits=tuple([hit._replace(time=hit.time + 1e-9) for hit in step.hits]))

    advance = sources.advance
    monkeypatch.setattr(sources, "advance", late)
    code, out, _ = certify(capsys, "arena:1:2")
    assert code == 1
    assert out.splitlines()[-1].startswith("REFUTED: ")
    assert "refuted: arena:1:2, tick " in out
    assert "the ball overlaps the reported sector at the reported time" in out


def test_functions_are_proved_over_boxes(capsys, tmp_path, monkeypatch):
    """A line for each box; with another formula for one of them, exit code 1."""
    file = tmp_path / "result.json"
    code, out, err = certify(capsys, "--functions", 200, "--json", file)
    assert (code, err) == (0, "")
    assert out.splitlines()[-1].startswith("CERTIFIED: ")
    result = json.loads(file.read_text())
    assert len(result["boxes"]) == len(out.splitlines()) - 1
    assert {box["wrong"] for box in result["boxes"]} == {None}
    boxes = [command.boxes()[1]._replace(formula=lambda x: [x[0] - x[1]])]
    monkeypatch.setattr(command, "boxes", lambda: boxes)
    code, out, _ = certify(capsys, "--functions", 200)
    assert code == 1
    assert "another formula at (" in out


def test_grazes_are_counted_and_listed(capsys):
    """Questions built to graze: some stay open, which is no failure."""
    code, out, _ = certify(capsys, "impacts:1:0", "impacts:1:1", "--list")
    assert code == 0
    listed = [line for line in out.splitlines() if line.startswith("undecided: impacts:1:")]
    assert listed
    assert all("graze" in line for line in listed)
    number, rest = next(line for line in out.splitlines() if "impacts: graze" in line).split(" impacts: ", 1)
    assert "not determined" in rest
    assert int(number.removeprefix("undecided: ")) == sum("the impact at" in line for line in listed)


def test_two_workers_find_what_one_does(capsys):
    """Results are taken in the order of the sources."""
    outputs = [certify(capsys, "arena:1:2", "arena:1:4", "arena:1:8", "--workers", count) for count in (1, 2)]
    assert outputs[0] == outputs[1]


def test_ctrl_c_leaves_a_partial_result(capsys, monkeypatch, tmp_path):
    """What was certified until then, marked as partial, in the last line and in the file."""
    totals_of = runs.totals_of

    def interrupted(source):
        if source.name.endswith(":4"):
            raise KeyboardInterrupt
        return totals_of(source)

    monkeypatch.setattr(runs, "totals_of", interrupted)
    file = tmp_path / "result.json"
    code, out, _ = certify(capsys, "arena:1:2", "arena:1:4", "--json", file)
    assert code == 128 + signal.SIGINT
    assert out.splitlines()[-1].endswith("; stopped by a signal")
    assert json.loads(file.read_text())["partial"] is True
    assert "1 games and arenas" in out


def test_the_plan_goes_on_until_there_are_enough(capsys, monkeypatch):
    """Games of the autopilot first, then arenas; it stops after the source that completes the number."""
    monkeypatch.setattr(sources, "GAME_TICKS", 600)
    code, out, _ = certify(capsys, "--impacts", 40, "--seed", 3)
    assert code == 0
    count = int(out.splitlines()[-1].split(" impacts")[0].removeprefix("CERTIFIED: "))
    assert 40 <= count < 2000


@pytest.mark.parametrize(
    "arguments",
    [
        ["nowhere.polar"],
        ["arena:1"],
        ["arena:1:x"],
        ["arena:1:-2"],
        ["impacts:9"],
        ["game:99:1"],
        ["game:1:"],
        ["--impacts", "0"],
        ["--workers", "0"],
        ["--seed", "x"],
        ["arena:1:1", "--json", "/nowhere/result.json"],
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys, arguments):
    """No traceback, and nothing on stdout."""
    code, out, err = certify(capsys, *arguments)
    assert (code, out, len(err.splitlines())) == (2, "", 1)
    assert "Traceback" not in err
