"""Simulated humans: they play by the rules, and a better one loses less."""

import json

import pytest

from game.levels import built_in
from game.system.command_line import run
from game.system.errors import BadInputError
from tools.balance.commands import app, parsed_skills
from tools.balance.human import AVERAGE, Skill
from tools.balance.trial import trial


def test_a_better_player_loses_less():
    level = built_in()[0]
    best, worst = [sum([trial(level, skill, seed).lost for seed in range(2)]) for skill in (Skill(0.05, 0.5), Skill(0.6, 30.0))]
    assert best < worst


def test_the_same_seed_is_the_same_game():
    assert trial(built_in()[0], AVERAGE, 3) == trial(built_in()[0], AVERAGE, 3)


@pytest.mark.parametrize("text", ["", "220", "220/", "-1/5", "220/91", "nan/5", "220/5,"])
def test_a_player_that_cannot_be_is_refused(text):
    with pytest.raises(BadInputError, match="--players"):
        parsed_skills(text)


def test_the_command_prints_a_line_a_player_and_writes_every_game(tmp_path, capsys):
    path = tmp_path / "games.json"
    assert run(app, "balance", ["--level", "1", "--players", "100/1", "--seeds", "2", "--json", str(path)]) == 0
    assert "First Wall 100 ms, 1 deg 2 100%" in " ".join(capsys.readouterr().out.split())
    games = json.loads(path.read_text())
    assert [game["seed"] for game in games] == [0, 1]
    assert all([0 < game["score"] < 10_000 for game in games])
