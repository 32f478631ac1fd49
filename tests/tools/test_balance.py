"""Simulated humans: they play by the rules, and a better one loses less."""

import json
from statistics import mean

import pytest

from game.levels import campaign, classic
from game.system.command_line import run
from game.system.errors import BadInputError
from tests.support.paths import ROOT
from tools.balance.commands import app, parsed_skills
from tools.balance.human import AVERAGE, Skill
from tools.balance.trial import trial


def test_a_better_player_loses_less():
    level = classic()[0]
    best, worst = [sum([trial(level, skill, seed).lost for seed in range(2)]) for skill in (Skill(0.05, 0.5), Skill(0.6, 30.0))]
    assert best < worst


def test_the_same_seed_is_the_same_game():
    assert trial(classic()[0], AVERAGE, 3) == trial(classic()[0], AVERAGE, 3)


@pytest.mark.parametrize("text", ["", "220", "220/", "-1/5", "220/91", "nan/5", "220/5,"])
def test_a_player_that_cannot_be_is_refused(text):
    with pytest.raises(BadInputError, match="--players"):
        parsed_skills(text)


def test_the_command_prints_a_line_a_player_and_writes_every_game(tmp_path, capsys):
    path = tmp_path / "games.json"
    assert run(app, "balance", ["--level", "1", "--players", "100/1", "--seeds", "2", "--json", str(path)]) == 0
    assert "Sunrise 100 ms, 1 deg 2 100%" in " ".join(capsys.readouterr().out.split())
    games = json.loads(path.read_text())
    assert [game["seed"] for game in games] == [0, 1]
    assert all([0 < game["score"] < 10_000 for game in games])


def measured():
    """What `python -m tools.balance --seeds 4 --json FILE` wrote: name to games of the average player."""
    games = json.loads((ROOT / "tests" / "reference" / "balance.json").read_text())
    skill = AVERAGE._asdict()
    return {
        level.name: [game for game in games if game["level"] == level.name and game["skill"] == skill] for level in campaign()
    }


def test_the_campaign_was_measured_as_it_is_now():
    """A level that changes is to be measured again."""
    for level in campaign():
        assert {game["level_hash"] for game in measured()[level.name]} == {level.content_hash()[:16]}, level.name


def test_the_page_of_the_campaign_says_what_was_measured():
    """A row each level: lives lost and seconds of the three players, and the average player's longest wait; the chapters."""
    page = (ROOT / "docs" / "campaign.md").read_text(encoding="utf-8").splitlines()
    games = json.loads((ROOT / "tests" / "reference" / "balance.json").read_text())
    players = [skill._asdict() for skill in parsed_skills("150/2,220/5,300/10")]
    for number, level in enumerate(campaign(), 1):
        own = [[game for game in games if game["level"] == level.name and game["skill"] == skill] for skill in players]
        cells = [
            f"{mean([game['lost'] for game in some]):.1f}, {mean([game['seconds'] for game in some]):.0f} s" for some in own
        ]
        wait = max([game["longest_gap"] for game in measured()[level.name]])
        assert f"| {number} {level.name} | {' | '.join(cells)} | {wait:.1f} s |" in page
        first = (number - 1) // 4 * 4 + 1
        assert any([line.startswith(f"| {level.chapter} | {first}-{first + 3} | ") for line in page])


def test_the_campaign_gets_harder_inside_a_chapter_and_stays_possible():
    """At normal difficulty, 220 ms, 5 degrees: below 1 life in the first level, below 4 in any; a chapter's last cost more."""
    lost = [mean([game["lost"] for game in measured()[level.name]]) for level in campaign()]
    assert all([game["cleared"] for games in measured().values() for game in games])
    assert lost[0] < 1.0
    assert max(lost) < 4.0
    firsts, lasts = lost[0::4], lost[3::4]
    assert sum(lasts) > 1.5 * sum(firsts)


def test_no_level_lets_a_player_wait_for_a_brick_for_long():
    """Ten seconds at most, with a ball in play."""
    assert max([game["longest_gap"] for games in measured().values() for game in games]) <= 10.0


def test_the_campaign_lasts_over_an_hour():
    """The average player's time in all levels."""
    assert sum([mean([game["seconds"] for game in games]) for games in measured().values()]) > 3600.0
