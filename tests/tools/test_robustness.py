"""A short run of the campaign against the program's edges; and the campaign finds what is wrong.

The long one is `python -m tools.robustness`.
"""

import sys
from pathlib import Path
from random import Random

import pytest

from game.levels import load_file
from game.system.errors import BadInputError
from tools.robustness import inputs, processes, saving
from tools.robustness.processes import COMMANDS, SURROUNDINGS, CommandRun

pytestmark = pytest.mark.deep

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="watched through /proc")
KINDS = {kind.name: kind for kind in inputs.kinds()}
QUICK = [command for command in COMMANDS if command.arguments in {("game", "levels"), ("game", "--bogus")}]
LATEST = 0.8
"""Seconds after which a signal comes, at most: a command is loaded by then, and has worked for a while."""
RECORD = next(command for command in COMMANDS if "--ticks 800000" in command.name)


@pytest.mark.parametrize("name", KINDS)
def test_hostile_inputs_are_accepted_or_refused_in_one_line(name, tmp_path):
    """Levels, replays, share lines and settings: no exception, no other exit code, no second line."""
    assert [fault for fault in inputs.faults(KINDS[name], 7, 60, tmp_path) if fault is not None] == []


def test_some_inputs_are_accepted_and_some_refused(tmp_path):
    """Or the campaign would show nothing."""
    accepted = 0
    for number in range(60):
        file = tmp_path / "level.toml"
        file.write_bytes(KINDS["levels"].made(Random(f"levels 7 {number}")))
        try:
            load_file(file)
            accepted += 1
        except BadInputError:
            pass
    assert 3 < accepted < 57


@pytest.mark.parametrize("name", KINDS)
def test_an_exception_is_found(name, tmp_path, monkeypatch):
    """Wherever the input is read; the input is kept."""

    def broken(*_):
        raise ZeroDivisionError("broken")

    for module, function in (("game.levels.reading", "parse"), ("game.replays.file", "decoded")):
        monkeypatch.setattr(f"{module}.{function}", broken)
    monkeypatch.setattr(inputs, "parsed", broken)
    monkeypatch.setattr("game.settings.file.decoded", broken)
    found = [fault for fault in inputs.faults(KINDS[name], 7, 12, tmp_path) if fault is not None]
    assert found
    assert all("ZeroDivisionError: broken" in fault for fault in found)
    assert len([*tmp_path.glob("fault-*")]) == len(found)


@pytest.mark.parametrize("line", ["two\nlines", "colour \x1b[31m", "x" * 1000])
def test_a_bad_message_is_found(line):
    """More than a line, control characters, or too much of it."""
    assert inputs.wrong_line(line)
    assert inputs.wrong_line("polar-breakout: x: a short reason") is None


@LINUX
@pytest.mark.parametrize("surroundings", SURROUNDINGS)
def test_commands_in_hostile_surroundings(surroundings):
    """Closed streams, a full disk, no reader, no home, ASCII, a folder that is gone: the exit code as documented, one line."""
    assert [fault for command in QUICK if (fault := processes.fault(command, surroundings)) is not None] == []


@LINUX
@pytest.mark.parametrize("number", processes.SIGNALS)
def test_a_recorded_game_is_kept_whenever_a_signal_comes(number):
    """One line, 128 + the signal's number, and what was recorded verifies."""
    ended = processes.ended(RECORD, number, Random(number), LATEST)
    assert ended == (128 + number, None)


@LINUX
@pytest.mark.parametrize("number", processes.SIGNALS)
def test_commands_that_share_their_work_end_in_one_line(number):
    """Whether a signal goes to the first process alone, or to all of them, as a terminal sends it."""
    command = next(command for command in COMMANDS if command.name == "tools.fuzz --steps 100000000 --workers 2")
    for seed in range(2):
        assert processes.ended(command, number, Random(seed), LATEST) == (128 + number, None)


@LINUX
def test_what_a_command_does_wrong_is_found():
    """Another exit code, a traceback, a second line."""
    assert "exit code 2" in processes.fault(CommandRun(("game", "--bogus")), "plain")
    assert processes._wrong("Traceback (most recent call last):\n", "")
    assert processes._wrong("one\ntwo\n", "")
    assert processes._wrong("one\n", "out\nand more\n") is None


@LINUX
def test_kills_while_saving_tear_nothing(tmp_path):
    """Every file is whole, and the next start leaves no temporary file; some kills did hit a file on its way."""
    done = list(saving.kills(1000, 1, tmp_path))
    assert sum(kill.torn for kill in done) == 0
    assert sum(kill.behind for kill in done) == 0
    assert sum(kill.left for kill in done) > 0


@LINUX
def test_torn_files_are_found(tmp_path, monkeypatch):
    """With a way of writing that is not whole, kills do tear files; without the sweep, they leave some behind."""

    def in_place(path, data):
        with Path(path).open("wb") as file:
            for start in range(0, len(data), 16):
                file.write(data[start : start + 16])
                file.flush()

    monkeypatch.setattr("game.settings.file.write_atomically", in_place)
    monkeypatch.setattr("game.replays.file.write_atomically", in_place)
    monkeypatch.setattr(saving, "remove_temporaries", lambda _: None)
    torn = behind = 0
    for kill in saving.kills(1000, 1, tmp_path):
        torn, behind = torn + kill.torn, behind + kill.behind
        if torn and behind:
            return
    pytest.fail(f"{torn} torn files, {behind} left behind")
