"""The command `python -m tools.crosscheck`: its output, its files, its exit codes, and what it says to bad input."""

import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import types
from pathlib import Path

import pytest
from rich.console import Console

from game.autopilot import Autopilot
from game.levels import campaign, chosen, classic
from game.replays.file import Recorder, save
from game.rules import new_game, tick
from game.system.command_line import run
from tests.support.paths import ROOT
from tools.crosscheck import command
from tools.crosscheck.commands import _PLAYERS, _VERDICTS, app
from tools.crosscheck.comparisons.convergence import FACETS, Curve
from tools.crosscheck.games.sources import AIMED, PLAYERS, RANDOM, Source
from tools.crosscheck.report.terminal import print_findings
from tools.crosscheck.report.words import BOUNDS, TERMS, compared_games, pace
from tools.crosscheck.results.findings import Findings
from tools.crosscheck.results.measurements import VERDICT_MEANINGS, ContactVerdict
from tools.crosscheck.run import Job, RunResult, check_game, default_sources
from tools.crosscheck.sabotage.suite import suite_jobs
from tools.executor import Lost

SHORT = ["--games", "1", "--level", "38", "--ticks", "1500"]


@pytest.fixture(autouse=True)
def _in_this_process(monkeypatch):
    """Worker processes take a second to start; `test_workers` is about them."""

    def answers(function, jobs, _):
        yield from enumerate(map(function, jobs))

    for module in ("run", "sabotage.suite", "corpus.build"):
        monkeypatch.setattr(f"tools.crosscheck.{module}.results_of", answers)


def crosscheck(capsys, *arguments):
    """Exit code, stdout and stderr."""
    code = run(app, "polar-crosscheck", [str(argument) for argument in arguments])
    out, err = capsys.readouterr()
    return code, out, err


@pytest.fixture(scope="module")
def replay(tmp_path_factory):
    """A recorded game of eight seconds."""
    path = tmp_path_factory.mktemp("replays") / "a game.polar"
    levels = chosen("3")
    game, pilot, recorder = new_game(levels, 4), Autopilot(), Recorder(levels, 4)
    for _ in range(1920):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        recorder.add(controls, game)
    save(recorder.recording(), path)
    return path


def test_agreement_is_exit_code_0_and_one_verdict_line(capsys):
    """The last line says it, the table fits 80 columns, and stderr is empty."""
    code, out, err = crosscheck(capsys, *SHORT)
    assert (code, err) == (0, "")
    assert re.fullmatch(r"AGREE: 0 unexplained in \d+ contacts, [\d,]+ poses in 1 game", out.splitlines()[-1])
    assert max(len(line) for line in out.splitlines()) <= 80
    assert "…" not in out
    words = ("what was hit", "normal, exact shape", "presence every tick", "time of first touch", "bounce, no friction")
    for word in (*words, "phase, rebuilt", "contacts by kind", "Not compared:"):
        assert word in out


def test_the_terminal_says_what_was_compared_and_what_its_words_mean(capsys):
    """First the game with its level, seed and player; then every bound and term; no rate of a run too short to have one."""
    _, out, _ = crosscheck(capsys, *SHORT)
    assert out.splitlines()[0] == "compared: level 38, seed 1, autopilot, at most 1,500 ticks"
    for word in (*BOUNDS, *TERMS):
        assert re.search(rf"^{word} +\S", out, re.MULTILINE), word
    for meaning in VERDICT_MEANINGS.values():
        assert meaning.split()[0] in out
    assert re.search(r"\d+ contacts compared in \d\.\d\d s, presence", out)
    assert "per second of a core" not in out


def test_empty_cells_are_listed_only_where_contacts_of_every_kind_are_meant(capsys):
    """A single game meets few of the kinds, and says nothing by that; aimed contacts are to meet all."""
    assert "cells with a contact:" not in crosscheck(capsys, *SHORT)[1]
    aimed = crosscheck(capsys, "--level", "aimed", "--ticks", "200")[1]
    assert "cells with a contact:" in aimed
    assert "more; --json names all" in aimed


def test_many_games_are_counted_and_a_long_run_has_a_rate():
    """Four games and more are not named one by one; from ten seconds of comparing on the rate is said."""
    result = RunResult([Job(source, 64) for source in default_sources(1, 100)])
    assert compared_games(result) == f"compared: {len(result.jobs)} games; --report names each"
    assert "0 contacts compared in 0.00 s" in pace(result)
    result.checking = 10.0
    assert "0 contacts compared per second of a core" in pace(result)


def test_disagreement_is_exit_code_1_with_a_command_to_repeat_it(capsys):
    """A sabotaged game: the reason, how often, and a command that shows the first case again, alone."""
    code, out, _ = crosscheck(capsys, *SHORT, "--sabotage", "rotated-normal")
    assert code == 1
    assert out.splitlines()[-1].startswith("DISAGREE: ")
    assert "the game's normal is turned by +0.1 degrees" in out
    line = next(line for line in out.splitlines() if "--tick " in line).split()
    assert line[:3] == ["python", "-m", "tools.crosscheck"]
    code, again, _ = crosscheck(capsys, *line[3:])
    assert code == 1
    assert "the game's normal is turned by +0.1 degrees" in again
    assert "1 contacts" in again or "2 contacts" in again


def test_a_replay_is_checked(capsys, replay):
    """The recorded game gives the contacts of the same game played again."""
    code, out, _ = crosscheck(capsys, replay)
    assert code == 0
    played = check_game(Job(Source(None, "3", 4, 1920), 64)).rows
    assert f"AGREE: 0 unexplained in {played.contacts} contacts" in out


def test_measurements_of_a_verdict_can_be_listed(capsys):
    """Each in a line, with its command."""
    _, out, _ = crosscheck(capsys, "--games", 1, "--level", RANDOM, "--seed", 2, "--ticks", 1500, "--list", "rule")
    listed = [line for line in out.splitlines() if line.startswith("source rule: ")]
    assert len(listed) == int(re.search(r"source rule\s+(\d+)", out)[1]) > 0
    assert all("python -m tools.crosscheck --level random --seed 2" in line for line in listed)


KEYS = {
    "format", "verdict", "agrees", "partial", "versions", "options", "games", "totals", "seconds", "verdicts", "rows",
    "measurements", "contacts", "coverage", "convergence", "free_run", "sabotage",
}  # fmt: skip
ROW_KEYS = {
    "comparison", "feature", "unit", "count", "median", "p99", "maximum", "bound", "share", "bound_source", "worst",
}  # fmt: skip


def test_the_json_file_keeps_its_format(capsys, tmp_path: Path):
    """The documented keys, all of them, no others; numbers that JSON has; and the numbers of the table."""
    file = tmp_path / "result.json"
    code, out, _ = crosscheck(capsys, *SHORT, "--json", file)
    result = json.loads(file.read_text(), parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    assert code == 0
    assert result["format"] == "polar-breakout crosscheck 2"
    assert set(result) == KEYS
    assert all(set(row) == ROW_KEYS for row in result["rows"])
    assert result["verdict"] == out.splitlines()[-1]
    assert sum(result["verdicts"].values()) == result["totals"]["contacts"]
    assert result["games"] == [{"options": "--level 38 --seed 1 --games 1 --ticks 1500", "lost": None}]
    assert len(result["contacts"]) == result["totals"]["contacts"] == sum(cell[-1] for cell in result["coverage"]["cells"])
    assert all(contact["errors"]["normal_exact"][0] < 1e-12 for contact in result["contacts"])
    documented = __import__("tools.crosscheck.report.json_file", fromlist=["_"]).__doc__
    worst = next(row["worst"] for row in result["rows"] if row["worst"] is not None)
    found = set(worst) | set(result["contacts"][0]) | set(result["totals"]) | set(result["seconds"]) | set(result["coverage"])
    for key in KEYS | ROW_KEYS | found:
        assert re.search(rf"\b{key}\b", documented), f"{key} is not documented"


def test_the_page_needs_nothing_else(capsys, tmp_path: Path):
    """No link, script, style sheet or picture from outside; its ids are its own; it knows the dark, phones and paper."""
    file = tmp_path / "page.html"
    code, _, _ = crosscheck(capsys, *SHORT, "--sabotage", "swapped-end", "--seed", 3, "--report", file)
    page = file.read_text()
    assert code in {0, 1}
    assert re.findall(r"""(?:src|href)=["'](?!#)[^"']*|@import|<link|<script|url\((?!#)""", page) == []
    ids = re.findall(r'\bid="([^"]*)"', page)
    assert len(ids) == len(set(ids)) > 10
    assert set(re.findall(r'(?:href="#|url\(#)([^")]*)', page)) <= set(ids)
    for word in ("prefers-color-scheme: dark", "@media print", "max-width: 40rem", 'name="viewport"', "<svg viewBox"):
        assert word in page
    assert not re.search(r"#0[1-6]0[1-6]0[1-6]", page), "a colour that is not the page's"


def test_the_extras_are_shown(capsys, tmp_path: Path, monkeypatch):
    """Convergence and free run, on the terminal, in the page and in the JSON file."""
    monkeypatch.setattr(command, "_FREE_RUNS", 1)
    errors = tuple(1.0 / n for n in FACETS)
    curve = Curve("normal, outer face", "rad", -1.0, FACETS, errors, errors, (1e-13,) * len(FACETS), 100)
    monkeypatch.setattr(command, "converged", lambda *_: [curve])
    page, numbers = tmp_path / "page.html", tmp_path / "numbers.json"
    code, out, _ = crosscheck(capsys, *SHORT, "--convergence", "--free-run", "--report", page, "--json", numbers)
    result = json.loads(numbers.read_text())
    assert code == 0
    assert [(curve["slope"], curve["holds"]) for curve in result["convergence"]] == [(pytest.approx(-1.0), True)]
    assert result["free_run"][0]["together"] >= 1
    assert "normal, outer face: falls as N^-1.000, expected N^-1 within 0.060, over 100" in out
    assert "free run 1: together for" in out
    assert "More facets, smaller difference" in page.read_text()
    assert "Left alone" in page.read_text()


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["--facets", "2"], "'--facets'"),
        (["--facets", "5000"], "'--facets'"),
        (["--games", "0"], "'--games'"),
        (["--games", "many"], "'--games'"),
        (["--workers", "0"], "'--workers'"),
        (["--seed", "-1"], "'--seed'"),
        (["--ticks", "0"], "'--ticks'"),
        (["--tick", "-1"], "'--tick'"),
        (["--level", "nowhere"], "--level nowhere: no such level"),
        (["--list", "everything"], "--list everything: expected one of"),
        (["--sabotage", "sand"], "--sabotage sand: expected one of all, rotated-normal"),
        (["--player", "nobody"], "--player nobody: expected one of autopilot, mouse, keys"),
        (["--corpus", "README.md"], "--corpus README.md: cannot write there"),
        (["no such.polar"], "no such.polar: cannot read replay"),
        (["."], "cannot read replay; expected a file, not a folder"),
        (["--report", "no/such/folder/page.html"], "there is no folder no/such/folder"),
        (["--json", "."], "--json .: a folder"),
        (["--bogus"], "No such option"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys, monkeypatch, arguments, reason):
    """Before any work starts."""
    for module in ("command.checked_games", "corpus.build.results_of"):
        monkeypatch.setattr(f"tools.crosscheck.{module}", lambda *_: pytest.fail("work has started"))
    code, out, err = crosscheck(capsys, *arguments)
    assert (code, out) == (2, "")
    assert reason in err
    assert err.count("\n") == 1
    assert err.startswith("polar-crosscheck: ")


@pytest.mark.parametrize(
    "content", [b"", b"polar-breakout replay 1\n", b"\x00" * 100, b"polar-breakout replay 9\n" + b"x" * 99]
)
def test_a_damaged_or_foreign_replay_is_refused(capsys, tmp_path: Path, content):
    """Also when it comes after a good one: no work is done for half a list."""
    file = tmp_path / "bad.polar"
    file.write_bytes(content)
    code, out, err = crosscheck(capsys, file)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert str(file) in err


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="here anybody may write anywhere, as root may")
def test_a_folder_without_permission_is_refused(capsys, tmp_path: Path):
    """Said before the work, not after it."""
    tmp_path.chmod(0o500)
    code, _, err = crosscheck(capsys, *SHORT, "--report", tmp_path / "page.html")
    tmp_path.chmod(0o700)
    assert (code, err.count("\n")) == (2, 1)


@pytest.mark.parametrize(
    ("version", "reason"), [(None, "pymunk is not installed"), ("6.11.1", "pymunk 6.11.1 is installed"), ("8.0", "pymunk 8.0")]
)
def test_without_a_fitting_pymunk_it_says_what_to_install(capsys, monkeypatch, version, reason):
    """Exit code 3, one line."""
    find = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if (name, version) == ("pymunk", None) else find(name))
    if version is not None:
        monkeypatch.setitem(sys.modules, "pymunk", types.SimpleNamespace(version=version, __spec__=object()))
    code, out, err = crosscheck(capsys, *SHORT)
    assert (code, out, err.count("\n")) == (3, "", 1)
    assert reason in err
    assert 'python -m pip install "pymunk>=7.1,<8"' in err


def test_without_assertions_it_refuses_to_run():
    """pymunk's own checks are assertions; -O would let its garbage through."""
    done = subprocess.run(
        [sys.executable, "-O", "-m", "tools.crosscheck", *SHORT],
        check=False,
        capture_output=True,
        text=True,
        cwd=ROOT,
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (3, "", 1)
    assert "without -O" in done.stderr


def test_ctrl_c_leaves_a_partial_result(capsys, monkeypatch, tmp_path: Path):
    """What was checked until then is shown, and written beside the file of an earlier run, which stays as it is."""

    def interrupted(function, jobs, _):
        yield 0, function(jobs[0])
        raise KeyboardInterrupt

    monkeypatch.setattr("tools.crosscheck.run.results_of", interrupted)
    file, page = tmp_path / "result.json", tmp_path / "page.html"
    file.write_text("earlier")
    code, out, err = crosscheck(capsys, *SHORT, "--games", 3, "--json", file, "--report", page)
    assert code == 128 + signal.SIGINT
    assert re.search(r"^PARTIAL \(1 of 3 games\): AGREE: 0 unexplained in \d+ contacts", out, re.MULTILINE)
    assert f"partial result: {tmp_path / 'result.partial.json'}" in out
    assert err == "polar-crosscheck: interrupted\n"
    assert file.read_text() == "earlier"
    partial = json.loads((tmp_path / "result.partial.json").read_text())
    assert (partial["partial"], partial["agrees"], len(partial["contacts"])) == (True, False, partial["totals"]["contacts"])
    assert "PARTIAL (1 of 3 games)" in (tmp_path / "page.partial.html").read_text()
    assert len([*tmp_path.iterdir()]) == 3


def test_a_lost_game_is_reported_and_no_agreement(capsys, monkeypatch):
    """A crash of pymunk loses its game and nothing else; the exit code says that something is missing."""

    def one_lost(function, jobs, _):
        yield 0, Lost("its process was killed by SIGABRT")
        yield 1, function(jobs[1])

    monkeypatch.setattr("tools.crosscheck.run.results_of", one_lost)
    code, out, _ = crosscheck(capsys, *SHORT, "--games", 2)
    assert code == 1
    assert "lost: level 38, seed 1: its process was killed by SIGABRT" in out
    assert re.match(r"INCOMPLETE: 1 game lost; 0 unexplained in \d+ contacts, [\d,]+ poses in 1 game", out.splitlines()[-1])


def test_the_table_fits_80_columns_with_the_counts_of_a_long_run(capsys):
    """Twelve million poses and every row: no number is cut."""
    result = RunResult([Job(Source(None, "6", 1, 1500), 64)])
    result.take(result.jobs[0].source, check_game(result.jobs[0]))
    for samples in result.rows.samples.values():
        samples.zeros += 12_345_678
    print_findings(Console(width=80), Findings(result), None)
    out = capsys.readouterr().out
    assert "12,34" in out
    assert "…" not in out


def test_nothing_compared_is_no_agreement():
    """A game without a contact proves nothing."""
    result = RunResult([Job(Source(None, "1", 1, 10), 64)])
    result.take(result.jobs[0].source, check_game(result.jobs[0]))
    assert (result.rows.contacts, result.agrees) == (0, False)


def test_the_command_line_knows_every_player_and_verdict():
    """It names them without importing pymunk; here the lists are held together."""
    assert _PLAYERS == PLAYERS
    assert {name.upper() for name in _VERDICTS} == {
        verdict.name for verdict in ContactVerdict if verdict > ContactVerdict.EXACT
    }


def test_by_default_all_kinds_of_games_are_checked():
    """Every classic level by the autopilot and by one who is less good, the end of every chapter; random and aimed ones."""
    sources = default_sources(1, 14_400)
    kinds = {(source.level if source.level in {RANDOM, AIMED} else "level", source.player, source.arcade) for source in sources}
    assert kinds == {
        ("level", "autopilot", None),
        ("level", "mouse", None),
        ("level", "keys", None),
        ("level", "autopilot", "easy"),
        ("level", "autopilot", "normal"),
        ("level", "autopilot", "hard"),
        ("random", "autopilot", None),
        ("aimed", "autopilot", None),
    }
    assert sources[0].level == AIMED, "it takes longest: at the end one process would be left alone with it"
    chapters = {level.chapter for level in campaign()}
    assert len(set(sources)) == len(sources) == 2 * len(classic()) + len(chapters) + 7


def test_the_suite_of_mistakes_is_a_table(capsys, monkeypatch, tmp_path: Path):
    """After the games: each mistake with what caught it; what is missed makes the exit code 1 and is named."""
    few = {name: command.MISTAKES[name] for name in ("two-layers", "still-surface", "early-stop")}
    monkeypatch.setattr(command, "MISTAKES", few)

    def short(names, seed, facets):
        jobs = [job for job in suite_jobs(names, seed, facets) if job.source.level in {"4", "aimed"}]
        return [job._replace(source=job.source._replace(ticks=400)) for job in jobs]

    monkeypatch.setattr(command, "suite_jobs", short)
    numbers, page = tmp_path / "numbers.json", tmp_path / "page.html"
    code, out, _ = crosscheck(capsys, *SHORT, "--sabotage", "all", "--json", numbers, "--report", page)
    assert code == 0
    assert re.search(r"^ *two-layers +what was hit +\d+", out, re.MULTILINE)
    assert "early-stop: a resulting velocity of" in out
    assert out.splitlines()[-1].endswith("2 of 3 mistakes caught, 1 cannot show in a game")
    result = json.loads(numbers.read_text())
    assert [(one["name"], one["caught"], one["holds"]) for one in result["sabotage"]] == [
        ("two-layers", True, True),
        ("still-surface", True, True),
        ("early-stop", False, True),
    ]
    assert "Mistakes made on purpose" in page.read_text()

    monkeypatch.setattr(command, "MISTAKES", {"early-stop": few["early-stop"]})
    monkeypatch.setattr("tools.crosscheck.sabotage.suite.MISTAKES", {"early-stop": few["early-stop"]._replace(invisible="")})
    code, out, _ = crosscheck(capsys, *SHORT, "--sabotage", "all")
    assert code == 1
    assert out.splitlines()[-1].startswith("NOT CAUGHT: early-stop;")
