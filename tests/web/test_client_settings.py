"""Own keys, captions, the ghost, and the menus that are read, asked of the page's Python alone."""

import msgspec
import pytest

from game.autopilot import Autopilot
from game.input.actions import Action
from game.input.key_names import key_names
from game.input.keys import KEYS, PadButton
from game.input.scancodes import SCANCODES
from game.levels import campaign
from game.overlay.captions import SECONDS
from game.picture.display_list import DisplayList
from game.picture.ghost import add_ghost
from game.rules import Phase
from game.settings.file import SettingsFile
from game.storage import ghost
from tests.support.best_run import stored_run
from tests.support.played_page import PlayedPage

PAD = {"type": "pad", "buttons": [0.0] * 17, "axes": [0.0] * 4}


@pytest.fixture
def played():
    """A page at its title."""
    return PlayedPage()


def asked(played, item):
    """Open the question for a key of an action. item: as in "pause-0"."""
    name, slot = item.split("-")
    played.choose("settings")
    played.choose("keys")
    return played.choose(f"key-{name}", slot)["menu"]


def test_a_chosen_key_turns_the_paddles_is_named_and_is_there_again(tmp_path):
    """The question takes any key but the browser's; the settings' file is the desktop's; the words for a new player name it."""
    played = PlayedPage(tmp_path)
    question = asked(played, "left-0")
    assert question["title"] == "Left, clockwise"
    assert "Tab" in question["uncaptured"]
    assert "menu" not in played.key("Tab")
    reply = played.key("KeyK", "k")
    assert reply["notification"] == "Left, clockwise: K"
    assert reply["keep"]
    assert reply["menu"]["focus"] == "key-left-0"
    assert SettingsFile(tmp_path / "settings.json").load().own_keys.keys == ((Action.LEFT, (14, 4)),)
    again = PlayedPage(tmp_path)
    again.go("classic/1")
    assert "K, Right or the mouse: turn the paddles" in again.frame()["texts"]
    before = again.game.arena.rings[0].phase
    again.key("KeyK", "k")
    again.frame(seconds=0.1)
    assert again.game.arena.rings[0].phase != before
    again.key("Escape")
    again.choose("settings")
    again.choose("keys")
    again.choose("reset")
    assert key_names(Action.LEFT) == ("Left", "A")


def test_a_conflict_is_said_as_on_the_desktop(played):
    """A taken key is taken from another action; what is reserved stays; the same key once more removes it; Escape leaves."""
    said = []
    for key in ("KeyM", "Enter", "KeyM", "Escape"):
        asked(played, "pause-0")
        said.append(played.key(key, key.removeprefix("Key").lower() if key.startswith("Key") else key).get("notification", ""))
        played.key("Escape")
        played.key("Escape")
    assert said == ["Pause: M, no longer Sound on or off", "Enter is reserved: Confirm", "Pause: key removed", ""]
    assert key_names(Action.PAUSE) == ("Pause",)


def test_a_button_of_a_gamepad_is_chosen_and_b_leads_back(played):
    """By its own number in the browser's layout: Y gives up a ball, and is the camera's no longer."""
    asked(played, "give_up-2")
    buttons = [0.0] * 17
    buttons[3] = 1.0
    assert played.frame({**PAD, "buttons": buttons})["notification"] == "Give up a ball: Y, no longer Tip the camera"
    assert KEYS.button_action(PadButton.Y) is Action.GIVE_UP
    played.frame(PAD)
    played.choose("key-pause", "0")
    buttons = [0.0] * 17
    buttons[1] = 1.0
    assert played.frame({**PAD, "buttons": buttons})["menu"]["title"] == "Keys"


def test_keys_have_the_names_that_the_layout_gives_them(played):
    """What the browser tells of the layout; else a letter is learned when it is pressed."""
    played.frame({"type": "layout", "written": {"KeyA": "q", "Semicolon": "m"}})
    assert key_names(Action.LEFT) == ("Left", "Q")
    assert key_names(Action.MUTE) == ("M",)
    played.key("KeyD", "\u0432")
    assert key_names(Action.RIGHT) == ("Right", "\u0412")


def test_the_lab_has_its_own_keys_whatever_the_player_has_chosen(played):
    """Space plays a scene and stops it, although it pauses the game."""
    asked(played, "pause-0")
    played.key("Space", " ")
    played.go("lab/free-run")
    before = played.page._screen.session.playing
    played.key("Space", " ")
    assert played.page._screen.session.playing is not before


def test_keys_change_settings_on_every_screen(played):
    """A word about it is drawn for a moment, a screen reader says it, and the menu that shows the setting follows."""
    played.choose("settings")
    reply = played.key("KeyE", "e")
    assert reply["announcement"] == "Effects off"
    assert "Effects off" in reply["texts"]
    assert next(item["value"] for item in reply["menu"]["items"] if item["id"] == "effects") == "False"
    assert "Effects off" not in played.frame(seconds=2.0).get("texts", [])


def serve(played, fragment):
    """A game whose ball has just been served."""
    played.go(fragment)
    played.key("Space", " ")
    while played.game.phase != Phase.PLAYING:
        played.frame(seconds=0.01)


def after_a_brick(played):
    """The reply in whose frame the autopilot has broken the first brick."""
    played.page._screen._pilot = Autopilot()
    for _ in range(500):
        reply = played.frame(seconds=0.01)
        if played.game.score:
            return reply
    raise AssertionError(played.game)


def test_a_caption_is_shown_with_its_event_and_for_its_time(played):
    """In the frame in which a brick breaks, if they are wanted; bricks are not said to a screen reader."""
    played.change(captions=True, ghost=False)
    serve(played, "classic/1")
    reply = after_a_brick(played)
    assert "brick struck" in reply["texts"]
    assert "brick" not in reply.get("announcement", "")
    shown = [played.frame(seconds=0.25)["texts"] for _ in range(round(SECONDS / 0.25) + 1)]
    assert not [words for words in shown[-1] if words == "brick struck"]
    played.change(captions=False)
    serve(played, "classic/5")
    assert not [words for words in after_a_brick(played)["texts"] if "struck" in words]


@pytest.fixture
def patient(monkeypatch):
    """The recording is played on at once to where it has to be."""
    monkeypatch.setattr(ghost, "_BUDGET", 60.0)


@pytest.mark.usefixtures("patient")
def test_the_ghost_is_the_best_run_tick_by_tick(tmp_path):
    """From the first serve on the frame has the desktop's outlines of the recorded game; without the setting it has none."""
    run = stored_run(tmp_path, campaign())
    played = PlayedPage(tmp_path)
    played.go("level/1")
    for _ in range(5):
        played.frame(seconds=0.1)
    assert played.page._screen._record.ghost.game is None
    serve(played, "level/1")
    played.frame(seconds=0.2)
    raced = played.page._screen._record.ghost.game
    assert raced.arena == run[played.game.phase_tick + 1].arena
    state, size = played.page._state, (1280, 800)
    expected = DisplayList()
    seen = state.layout(size, played.game.level.ground_radius)
    add_ghost(expected, raced, seen.camera, state.theme, state.scene_unit(size))
    assert expected.numbers.tobytes() in played.page.numbers.tobytes()
    assert "BEST RUN" in played.frame()["texts"]
    played.change(ghost=False)
    assert "BEST RUN" not in played.frame()["texts"]
    assert expected.numbers.tobytes() not in played.page.numbers.tobytes()


@pytest.mark.usefixtures("patient")
def test_a_best_run_of_another_version_of_the_level_is_no_ghost(tmp_path):
    """The level has been changed since: its name is the same."""
    older = msgspec.structs.replace(campaign()[0], ground_radius=campaign()[0].ground_radius + 0.5)
    stored_run(tmp_path, (older,), name=older.name)
    played = PlayedPage(tmp_path)
    serve(played, "level/1")
    assert played.page._screen._record.ghost is None


def test_a_ghost_that_comes_late_stands_where_it_has_to_be(tmp_path, monkeypatch):
    """While the recording is played on, nothing is shown; then it has caught up with the player."""
    monkeypatch.setattr(ghost, "_BUDGET", 0.0)
    run = stored_run(tmp_path, campaign())
    played = PlayedPage(tmp_path)
    serve(played, "level/1")
    played.frame(seconds=0.2)
    assert played.page._screen._record.ghost.game is None
    monkeypatch.setattr(ghost, "_BUDGET", 60.0)
    played.frame(seconds=0.1)
    assert played.page._screen._record.ghost.game.arena == run[played.game.phase_tick + 1].arena


def test_help_and_credits_are_the_desktops_words(played):
    """With the keys that hold now; what has no key on the page is left out."""
    asked(played, "restart-0")
    played.key("KeyB", "b")
    for _ in range(2):
        played.key("Escape")
    items = played.choose("help")["menu"]["items"]
    pairs = {item["hint"]: item["label"] for item in items if item["kind"] == "pair"}
    assert pairs["restart (asks first)"] == "B"
    assert "full screen" not in pairs
    assert [len(item.get("picture", ())) > 0 for item in items if "Wide paddles" in item["label"]] == [True]
    played.key("Escape")
    labels = [item["label"] for item in played.choose("credits")["menu"]["items"]]
    assert "Made with" in labels
    assert played.choose("back")["menu"]["title"] == "Polar Breakout"


def test_positions_of_keys_are_scancodes():
    """The chosen key of the test above is where SDL has K, beside the A that stays."""
    assert (SCANCODES["KeyK"], SCANCODES["KeyA"]) == (14, 4)


def test_a_game_is_thrown_away_only_after_a_question(played):
    """R asks; Escape goes on, and the level that is played can be begun anew, or the first one."""
    played.go("classic/2")
    first = played.game
    menu = played.key("KeyR", "r")["menu"]
    assert menu["title"] == "Restart?"
    assert [item["id"] for item in menu["items"]] == ["go-on", "level", "first"]
    played.key("Escape")
    assert played.game is first
    played.key("KeyR", "r")
    played.choose("level")
    assert (played.game.level, played.game.tick) == (first.level, 0)
    assert played.game is not first


def test_a_game_that_is_left_is_stored_at_once(tmp_path):
    """So the ghost of a level finished in it is there even if the page is closed then."""
    played = PlayedPage(tmp_path)
    played.go("level/1")
    for _ in range(60):
        played.frame(seconds=0.1)
    played.key("Escape")
    assert played.choose("title")["keep"]
    assert len(list((tmp_path / "replays").glob("*.polar"))) == 1


def test_a_stored_game_is_named_kept_and_deleted_after_a_question(tmp_path):
    """What has a title is kept; a best run refers to this one, and the question says so."""
    stored_run(tmp_path, campaign())
    (file,) = (tmp_path / "replays").glob("*.polar")
    played = PlayedPage(tmp_path)
    played.choose("replays")
    played.choose(f"replay-{file.name}")
    assert played.choose("name", "My rally")["keep"]
    (game,) = played.page._state.storage.games.listed()
    assert (game.title, game.kept) == ("My rally", True)
    played.choose("keep", "False")
    assert not played.page._state.storage.games.listed()[0].kept
    assert "could no longer be verified" in " ".join(played.choose("delete")["menu"]["lines"])
    played.key("Escape")
    assert file.exists()
    played.choose("delete")
    played.choose("delete")
    assert not file.exists()
    assert played.page._screen.menu.title == "Replays"


def test_a_replay_has_its_own_keys_for_speed_beginning_and_end(tmp_path):
    """They are the desktop's, and leave the volume as it is."""
    stored_run(tmp_path, campaign())
    (file,) = (tmp_path / "replays").glob("*.polar")
    played = PlayedPage(tmp_path)
    before = played.page._state.settings.volume
    for item in ("replays", f"replay-{file.name}", "watch"):
        played.choose(item)

    played.key("Equal", "=")
    played.key("End")
    menu = {item.id: item.value for item in played.page._screen.menu.items}
    assert (menu["speed"], int(menu["second"])) == ("4", 1300 // 240)
    played.key("Home")
    played.key("Minus", "-")
    menu = {item.id: item.value for item in played.page._screen.menu.items}
    assert (menu["speed"], menu["second"]) == ("1", "0")
    assert played.page._state.settings.volume == before


@pytest.mark.parametrize(
    ("file", "text", "said"),
    [
        ("settings.json", "{broken", "settings not readable: moved to "),
        ("settings.json", '{"version": 99}', "settings of a newer version in "),
        ("progress.json", "[]", "progress not readable: moved to "),
    ],
)
def test_a_stored_file_that_cannot_be_read_is_told_at_the_start(tmp_path, file, text, said):
    """Once, with the page's first picture: what the player had chosen or reached is not there."""
    (tmp_path / file).write_text(text, encoding="utf-8")
    played = PlayedPage(tmp_path, changes=False)
    assert said in played.frame()["notification"]
    assert "notification" not in played.frame()


def test_a_key_that_stays_is_the_one_that_is_named(played):
    """Esc always leads back: another key in its position is refused with the name of Esc."""
    asked(played, "back-0")
    assert played.key("KeyJ", "j")["notification"] == "Esc is reserved: Back"
