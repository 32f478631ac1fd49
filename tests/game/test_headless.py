"""A game without a window, and the line that says how it stands."""

import pytest

from game.headless import autopilot_game, result_line
from game.levels import campaign, chosen, classic, parse
from game.overlay.readings import readings
from game.rules import Ruleset, new_game
from tests.support.level_text import GOOD


def values(line):
    """The words of a result line."""
    return dict(word.split("=") for word in line.split())


@pytest.mark.parametrize("levels", [campaign(), campaign()[6:], classic(), classic()[6:]])
def test_the_number_of_a_level_is_the_one_that_starts_it(levels):
    """`--level` takes the number that the result line has, also for classic levels, which are listed after the campaign's."""
    assert chosen(values(result_line(new_game(levels, 3)))["level"]) == levels


@pytest.mark.parametrize("levels", [campaign(), campaign()[6:], (parse(GOOD, "good"),)])
def test_the_line_and_the_window_name_the_same_level_and_layers(levels):
    """Of the campaign's levels and one's own, the result line and the window have the same number and the same layers."""
    game = new_game(levels, 3)
    said, shown = values(result_line(game)), readings(game)
    assert (said["level"], said["layers"]) == (str(shown.level_number), str(shown.layers))


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
