"""A game without a window, and the line that says how it stands."""

import pytest

from game.headless import autopilot_game, result_line
from game.levels import classic, parse
from game.overlay.readings import readings
from game.rules import Ruleset, new_game
from tests.support.level_text import GOOD


def values(line):
    """The words of a result line."""
    return dict(word.split("=") for word in line.split())


@pytest.mark.parametrize("levels", [classic(), classic()[1:], classic()[6:], (parse(GOOD, "good"),)])
def test_the_line_and_the_window_name_the_same_level_and_layers(levels):
    """Whatever level a game starts at, the result line and the window have one number for it, and one for its layers."""
    game = new_game(levels, 3)
    said, shown = values(result_line(game)), readings(game)
    assert (said["level"], said["layers"]) == (str(shown.level_number), str(shown.layers))


def test_a_game_begun_at_level_2_says_level_2():
    """The number counts all levels that come with the game, not those that are played."""
    assert values(result_line(autopilot_game(classic()[1:], 7, 10)))["level"] == "2"


def test_the_line_says_what_repeats_the_game():
    """Seed and physics are in the line."""
    said = values(result_line(new_game(classic(), 77), "source"))
    assert (said["seed"], said["physics"]) == ("77", "source")


def test_the_line_tells_two_players_apart():
    """It has each player's score and lives; the game's own are the sum of the scores and the smaller number of lives."""
    game = autopilot_game(classic(), 3, 4000, ruleset=Ruleset(versus=True))
    game = game._replace(sides=(game.sides[0]._replace(lives=2), game.sides[1]))
    said = values(result_line(game))
    assert [(said[f"player_{k}_score"], said[f"player_{k}_lives"]) for k in (1, 2)] == [
        (str(game.sides[0].score), "2"),
        (str(game.sides[1].score), "3"),
    ]
    assert game.sides[0].score != game.sides[1].score
    assert not any([word.startswith("player_") for word in values(result_line(new_game(classic(), 1)))])
