"""Whole sessions in a real window: title, a level, pause, settings, a lost game, name, scores, a replay, the editor, out."""

import pytest

from game.levels import load_file
from game.storage.scores import objection
from game.storage.storage import Storage
from tests.support.windows.real_window import NO_SERVER, Keys, Mouse, Pad, RealGame, started_server
from tests.support.windows.virtual_pad import library

pytestmark = [pytest.mark.window, NO_SERVER]

ONE_TOUCH = """
name = "One touch"
ground_radius = 10.0
[ball]
radius = 0.5
speed = 12.0
[paddles]
radius = 9.3
half_width = 0.22
half_angle = 40.0
top_speed = 30.0
acceleration = 400.0
[[rings]]
radius = 6.0
half_width = 0.5
half_angle = 179.0
count = 1
"""
"""A level that any serve clears."""


@pytest.mark.parametrize("hands", [Keys, Mouse, Pad])
def test_a_session(children, tmp_path, hands):
    """By keys alone, by mouse alone, and by gamepad alone, against the program as it is started from a terminal.

    What is kept is what was done: the score, proven by its replay, the level that the editor made, and the setting. The only
    line that is said is that there is no sound.
    """
    if hands is Pad and library() is None:
        pytest.skip("no SDL library to plug a virtual gamepad into")
    folder = tmp_path / "polar-breakout"
    (folder / "levels").mkdir(parents=True)
    (folder / "levels" / "one-touch.toml").write_text(ONE_TOUCH)
    game = RealGame(
        children, started_server(children), tmp_path, "--level", "32", "--difficulty", "hard", "--seed", "5", pad=hands is Pad
    )
    player = hands(game)
    game.expect("Title")
    game.wait(lambda seen: seen["focused"])
    player.choose("Settings")
    game.expect("SettingsPanel")
    player.choose("Reduced motion")
    player.leave()
    game.expect("Title")
    clear_a_level(game, player)
    make_a_level(game, player)
    player.leave()
    game.expect("Title")
    lose_a_game(game, player)
    player.enter("MO")
    game.expect("HighScores")
    player.choose(next(label for label in game.seen["items"] if "  MO  " in label))
    game.expect("Watch")
    game.wait(lambda seen: seen.get("moved"))
    player.leave()
    game.expect("HighScores")
    player.choose("Main menu")
    game.expect("Title")
    player.choose("Quit")
    game.wait(lambda seen: seen["screen"] is None)
    out, err = game.process.communicate()
    assert game.process.returncode == 0, (out, err)
    assert err.count(b"\n") == 1, err
    assert b"sound" in err
    (score,) = Storage(folder).scores.value.entries
    assert (score.name, score.difficulty, score.first) == ("MO", "hard", "The Heart")
    assert score.score > 0
    assert objection(score, folder / "replays") is None
    assert len([load_file(path) for path in (folder / "levels").glob("*.toml")]) == 2
    assert '"reduced_motion": true' in next(folder.glob("settings.json")).read_text()


def clear_a_level(game, player):
    """A level of one's own, from the title to its results and on to the choice of levels."""
    player.choose("Levels")
    game.expect("LevelSelect")
    player.choose("One touch")
    game.expect("Menu")
    player.choose("Play")
    serve_until(game, player, "ResultsPanel")
    player.choose("All levels")
    game.expect("LevelSelect")


def make_a_level(game, player):
    """A new level, kept as it is."""
    player.choose("Make a new level")
    game.expect("Editor")
    player.leave()
    game.expect("Menu")
    player.choose("Save and leave")
    game.expect("LevelSelect")


def lose_a_game(game, player):
    """The campaign, with a pause and the settings, until all lives are lost; to the entry of the name."""
    player.choose("Play")
    game.expect("PlayScreen")
    player.pause()
    game.expect("Menu")
    player.choose("Settings")
    game.expect("SettingsPanel")
    player.leave()
    game.expect("Menu")
    player.choose("Continue")
    game.expect("PlayScreen")
    game.wait(lambda seen: seen["is_kept"])
    player.steer(on=True)
    serve_until(game, player, "ResultsPanel")
    player.choose("Enter your name")
    game.expect("TextEntry")


def serve_until(game, player, screen):
    """Serve whenever a ball waits, until another screen opens."""
    while game.seen["screen"] != screen:
        phase = game.seen.get("phase")
        if phase == "SERVING":
            player.serve()
            continue
        if phase in ("OVER", "WON"):
            player.steer(on=False)
        game.wait(lambda seen, phase=phase: seen.get("phase") != phase or seen["screen"] == screen)
