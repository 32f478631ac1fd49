"""What a player can do on the page, asked of its Python alone: two players, fingers, gamepads, settings, languages."""

import pytest

from game.levels import campaign
from game.rules import paddle_rings
from tests.support.played_page import PlayedPage

PAD = {"type": "pad", "buttons": [0.0] * 17, "axes": [0.0] * 4}


@pytest.fixture
def played():
    """A page at its title."""
    return PlayedPage()


def items(menu):
    """The labels of a menu by their ids."""
    return {item["id"]: item["label"] for item in menu["items"]}


def versus(played):
    """A game of two opponents, and a function for the angles of both paddles."""
    played.choose("levels")
    played.choose("players", "VERSUS")
    played.choose("level-1")
    before = [played.game.arena.rings[k].phase for k in paddle_rings(played.game)]
    return lambda: [
        played.game.arena.rings[k].phase != phase for k, phase in zip(paddle_rings(played.game), before, strict=True)
    ]


def test_two_at_one_keyboard_have_a_paddle_each(played):
    """A and D turn the upper one, the arrows the lower one; the choice says so, and so does the notice."""
    played.choose("levels")
    reply = played.choose("players", "VERSUS")
    hint = next(item["hint"] for item in reply["menu"]["items"] if item["id"] == "players")
    assert "the upper one A, D" in hint
    turned = versus(played)
    assert "Player 1: Left, Right. Player 2: A, D. Space: serve" in played.frame()["texts"]
    played.key("KeyA", "a")
    played.frame(seconds=0.1)
    assert turned() == [False, True]
    played.key("KeyA", "a", down=False)
    played.key("ArrowLeft")
    played.frame(seconds=0.1)
    assert turned() == [True, True]


def test_the_second_gamepad_is_the_second_players(played):
    """Its stick moves the upper paddle; the first player's paddle stays."""
    turned = versus(played)
    played.frame({**PAD, "pad": 1, "axes": [0.9, -0.5, 0.0, 0.0]})
    played.frame(seconds=0.1)
    assert turned() == [False, True]


def test_together_both_steer_all_paddles(played):
    """The keys of either player turn all paddles, and no name for a score is asked for."""
    played.choose("levels")
    played.choose("players", "TOGETHER")
    played.choose("level-1")
    before = played.game.arena.rings[0].phase
    played.key("KeyD", "d")
    played.frame(seconds=0.1)
    assert played.game.arena.rings[0].phase != before
    assert not played.game.sides
    assert not played.page._screen._record.counts


def test_two_fingers_orbit_and_zoom_in_3d_alone(played):
    """A drag with both turns the camera, spreading them zooms in; from above they only point. Neither finger serves."""
    played.choose("play")
    apart = [("down", 1, 500, 400), ("down", 2, 700, 400), ("move", 1, 400, 400), ("move", 2, 800, 400)]
    together = [("move", 1, 450, 420), ("move", 2, 850, 420), ("up", 1, 450, 420), ("up", 2, 850, 420)]
    played.fingers(*apart, *together)
    assert (played.view.zoom, played.view.azimuth) == (1.0, 0.0)
    played.key("Digit2", "2")
    played.fingers(*apart)
    assert played.view.zoom == pytest.approx(2.0)
    assert played.view.azimuth == pytest.approx(0.0)
    tilt = played.view.tilt
    played.fingers(*together)
    assert played.view.zoom == pytest.approx(2.0)
    assert played.view.azimuth < 0.0
    assert played.view.tilt != tilt
    assert played.game.phase.name == "SERVING"


def test_a_tap_serves_and_a_finger_that_the_browser_takes_away_does_not(played):
    """As when the system's own gesture begins with it."""
    played.choose("play")
    for end, phase in (("cancel", "SERVING"), ("up", "PLAYING")):
        played.fingers(("down", 1, 500, 400), (end, 1, 500, 400))
        for _ in range(5):
            played.frame(seconds=0.1)
        assert played.game.phase.name == phase


def test_who_plays_by_touch_is_told_to_tap():
    """From the start on a touch device, else after the first touch; a mouse brings the words for keys back."""
    played = PlayedPage(touch=True)
    played.choose("play")
    assert "Tap: serve along the arrow" in played.frame()["texts"]
    played.frame({"type": "pointer", "phase": "move", "id": 1, "touch": False, "x": 9, "y": 9})
    assert "Space or click: serve along the arrow" in played.frame()["texts"]


def test_levels_are_called_and_explained_in_the_players_language():
    """In the list of levels and in the button for the next level, with the condition that unlocks a level."""
    played = PlayedPage(languages="de")
    menu = played.choose("levels")["menu"]
    labels = items(menu)
    names = [labels[f"level-{number}"] for number, _ in enumerate(campaign(), 1)]
    assert sum(level.name in name for level, name in zip(campaign(), names, strict=True)) < len(names) / 3
    hints = [item.get("hint", "") for item in menu["items"] if item["id"].startswith(("level-", "classic-"))]
    english = {level.description for level in campaign()}
    assert not english & set(hints)
    assert "Sunrise" not in " ".join(hints)


def test_levels_without_end_begin_from_a_number_and_have_an_address(played):
    """The same number gives the same levels; so does the address."""
    played.choose("endless")
    assert played.choose("number", "4711")["fragment"] == "endless/4711"
    level = played.game.level
    played.key("Escape")
    played.choose("title")
    played.frame({"type": "link", "fragment": "endless/4711"})
    assert played.game.level == level


def test_the_settings_of_the_desktop_are_there(played):
    """Text size, colour vision, single effects, full screen; a locked trail is not offered."""
    played.choose("settings")
    played.choose("text_size", "200")
    assert played.page._state.text_unit((1280, 800)) == 2.0 * 800 / 34.0
    played.choose("vision", "deuteranopia")
    assert played.page._state.settings.vision == "deuteranopia"
    played.choose("trail", "spectrum")
    assert played.page._state.settings.trail == "comet"
    assert played.choose("full-screen")["full_screen"]
    assert "full_screen" not in played.frame()
    played.choose("one-by-one")
    played.choose("effect-shake", "False")
    assert "shake" not in played.page._state.settings.shown
