"""`python -m game scores`: the table, and the proof that every score was played."""

import hashlib

import pytest

from game import commands
from game.autopilot import Autopilot
from game.levels import classic
from game.rules import Ruleset, new_game, tick
from game.storage import games as kept_games
from game.storage.scores import Score
from game.storage.storage import Storage
from tests.support.command_line import polar


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The user's data folder with one game and its score."""
    monkeypatch.setattr(commands, "data_folder", lambda: tmp_path)
    monkeypatch.setattr(kept_games, "_SHORTEST", 0.1)
    storage = Storage(tmp_path)
    game, pilot = new_game(classic(), 3, Ruleset()), Autopilot()
    for _ in range(1500):
        controls = pilot.controls(game)
        game = tick(game, controls).game
        storage.games(controls, game)
    played = storage.game_done()
    assert played.score == game.score > 0
    storage.enter(Score("Ada", game.score, "normal", replay=played.file, sha256=played.sha256))
    return tmp_path


def test_a_true_score_is_verified(folder, capsys):
    """Its replay is played again and makes the same points."""
    code, out, err = polar(capsys, "scores", "--verify")
    assert (code, err) == (0, "")
    assert "Ada" in out
    assert out.rstrip().endswith("verified")
    assert (folder / "scores.json").exists()


@pytest.mark.parametrize("lie", ["more points", "another replay", "no replay", "outside"])
def test_a_false_score_is_found_out(folder, capsys, lie):
    """More points than the replay makes, another file, none, or one outside of the folder: exit code 1."""
    storage = Storage(folder)
    (true,) = storage.scores.value.entries
    points = true.score + (lie == "more points")
    replay = {"no replay": "", "outside": f"../{folder.name}/replays/{true.replay}"}.get(lie, true.replay)
    sha256 = hashlib.sha256(b"").hexdigest() if lie == "another replay" else true.sha256
    storage.enter(Score("Eve", points, "normal", replay=replay, sha256=sha256))
    code, out, err = polar(capsys, "scores", "--verify")
    assert code == 1
    assert "1 of 2 scores could not be verified" in err
    assert [line.count("NOT VERIFIED") for line in out.splitlines() if "Eve" in line] == [1]
