"""Simulated humans: they play by the rules, and a better one loses less."""

from statistics import mean

import pytest

from game.levels import campaign, classic
from game.system.command_line import run
from game.system.errors import BadInputError
from tests.support.paths import ROOT
from tools.balance.commands import app
from tools.balance.games_file import known_game, level_hash, saved_games
from tools.balance.human import AVERAGE, GOOD, SLOW, Skill
from tools.balance.page import rows
from tools.balance.players import parsed_seeds, parsed_skills
from tools.balance.trial import Trial, TrialJob, standard_error, trial

GAMES = ROOT / "tests" / "reference" / "balance.json"
COMMAND = "python -m tools.balance --seeds 4,12,4 --json tests/reference/balance.json --page docs/campaign.md"
"""The command that measures the campaign."""


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


def test_the_autopilot_is_a_player():
    assert parsed_skills("autopilot,220/5") == (None, AVERAGE)
    assert trial(classic()[0], None, 3).cleared


def test_games_are_counted_for_all_players_or_for_each():
    assert parsed_seeds("4", 3) == (4, 4, 4)
    assert parsed_seeds("4,16,6", 3) == (4, 16, 6)
    for text in ("", "0", "4,16", "4,16,x", "-1", "1" * 9):
        with pytest.raises(BadInputError, match="--seeds"):
            parsed_seeds(text, 3)


def test_levels_of_a_seed_are_played(capsys):
    assert run(app, "balance", ["--endless", "7", "--count", "1", "--players", "autopilot", "--seeds", "1"]) == 0
    assert "Endless 1 autopilot 1 100%" in " ".join(capsys.readouterr().out.split())


def test_the_command_prints_a_line_a_player_and_writes_every_game_and_plays_known_ones_no_more(tmp_path, capsys):
    """A known game has the same level, player and seed; a file without games is refused."""
    path = tmp_path / "games.json"
    arguments = ["--level", "1", "--players", "100/1", "--json", str(path)]
    assert run(app, "balance", [*arguments, "--seeds", "1"]) == 0
    assert "Sunrise 100 ms, 1 deg 1 100% 0.0 ± 0.0" in " ".join(capsys.readouterr().out.split())
    path.write_text(path.read_text().replace('"lost":0', '"lost":7'))
    assert run(app, "balance", [*arguments, "--seeds", "2", "--known", str(path)]) == 0
    games = saved_games(path)
    assert [(seed, game.lost) for (_, _, seed), game in games.items()] == [(0, 7), (1, 0)]
    assert all([0 < game.score < 10_000 for game in games.values()])
    path.write_text("[{}]")
    assert run(app, "balance", [*arguments, "--known", str(path)]) == 2
    assert "not a file of games" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("page", "said"), [(b"# Levels\n", "no table of levels"), (b"caf\xe9\n| 1 Sunrise |\n", "not UTF-8 at byte 3")]
)
def test_a_page_without_a_table_is_refused_before_a_game_is_played(page, said, tmp_path, capsys):
    path = tmp_path / "page.md"
    path.write_bytes(page)
    assert run(app, "balance", ["--level", "1", "--page", str(path)]) == 2
    shown = capsys.readouterr()
    assert said in shown.err
    assert not shown.out
    assert path.read_bytes() == page


def test_levels_of_the_same_name_are_refused(capsys):
    """Their games could not be told apart."""
    assert run(app, "balance", ["--level", "1", "--level", "2", "--level", "Sunrise"]) == 2
    assert "two levels are called Sunrise" in capsys.readouterr().err


def test_a_known_game_is_of_the_level_that_its_hash_says():
    """The name of the level in the file does not count."""
    level = classic()[0]
    known = {(level_hash(level), None, 0): Trial("Another", None, 0, True, 1.0, 0, 0, 1.0, 10)}
    assert known_game(known, TrialJob(level, None, 0)).level == level.name


def lost(skill):
    """What each level costs a player: the mean of the measured games."""
    return [mean([game.lost for game in games]) for games in measured(skill)]


def measured(skill=AVERAGE):
    """The games of a player, level by level."""
    games = saved_games(GAMES).values()
    return [[game for game in games if game.level == level.name and game.skill == skill] for level in campaign()]


def test_the_campaign_was_measured_as_it_is_now():
    """The file has every level with its present numbers, and as many games of each player as the command says."""
    hashes = {level.content_hash()[:16] for level in campaign()}
    assert {level_hash for level_hash, _, _ in saved_games(GAMES)} == hashes
    for skill, count in zip((GOOD, AVERAGE, SLOW), parsed_seeds(COMMAND.split()[4], 3), strict=True):
        assert {len(games) for games in measured(skill)} == {count}


def test_the_page_of_the_campaign_says_what_was_measured():
    """It has the command, a row for each level with lives lost, standard error and seconds, and the chapters."""
    page = (ROOT / "docs" / "campaign.md").read_text(encoding="utf-8").splitlines()
    assert f"    {COMMAND}" in page
    assert not set(rows(campaign(), (GOOD, AVERAGE, SLOW), list(saved_games(GAMES).values()))) - set(page)
    for first in range(1, len(campaign()), 4):
        assert any([line.startswith(f"| {campaign()[first].chapter} | {first}-{first + 3} | ") for line in page])


def test_the_average_player_loses_what_the_curve_asks():
    """Below 1 life in the first level, below 4 in the last of a chapter, 1 to 2 in all others."""
    first, *later = lost(AVERAGE)
    middle = [one for number, one in enumerate(later, 2) if number % 4]
    lasts = lost(AVERAGE)[3::4]
    assert first < 1.0
    assert min(middle) >= 1.0
    assert max(middle) <= 2.0
    assert max(lasts) < 4.0
    assert mean(lasts) > 1.5 * mean(middle)
    assert all([game.cleared for games in measured() for game in games])


def test_the_noise_of_the_measured_losses_is_below_half_a_life_in_the_middle_of_a_chapter():
    """The standard error of every such mean."""
    errors = [standard_error([game.lost for game in games]) for games in measured()]
    assert max([error for number, error in enumerate(errors, 1) if number % 4]) < 0.5


def test_the_curve_rises():
    """The second half of the campaign costs a tenth more lives and time than the first, the last chapter than the first one."""
    seconds = [mean([game.seconds for game in games]) for games in measured()]
    for cost in (lost(AVERAGE), seconds):
        assert sum(cost[16:]) > 1.1 * sum(cost[:16])
        assert sum(cost[28:]) > 1.1 * sum(cost[:4])


def test_no_level_is_a_wall_for_a_slow_player():
    """A player with 300 ms and 10 degrees loses at most 10 lives in any level."""
    assert max(lost(SLOW)) <= 10.0


def test_no_level_lets_a_player_wait_for_a_brick_for_long():
    """Ten seconds at most, with a ball in play, whoever plays."""
    assert max([game.longest_gap for skill in (GOOD, AVERAGE, SLOW) for games in measured(skill) for game in games]) <= 10.0


def test_the_campaign_lasts_over_an_hour():
    """The average player's time in all levels."""
    assert sum([mean([game.seconds for game in games]) for games in measured()]) > 3600.0
