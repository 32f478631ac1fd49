"""What the player has chosen: steps from one choice to another, and the file that keeps it."""

import json
import os
import subprocess
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.drawing.colour_vision import VISIONS
from game.drawing.palette import HIGH_CONTRAST, LIGHT
from game.effects import ALL, MOVING, PLAIN, EffectKind
from game.input.actions import Action, OwnKeys
from game.input.rebinding import bindings, checked
from game.language import CODES, SYSTEM, choose
from game.settings import folder as settings_folder
from game.settings.file import VERSION, SettingsFile, decoded, encoded
from game.settings.values import SPEEDS, TEXT_SIZES, Settings
from game.unlocks import BALLS, TRAILS
from tests.support.paths import ROOT

CHOSEN = Settings("light", False, 30, True, False, frozenset({EffectKind.SHAKE, EffectKind.TRAIL}))

choices = st.builds(
    Settings,
    st.sampled_from(["dark", "light"]),
    st.booleans(),
    st.integers(0, 100),
    st.booleans(),
    st.booleans(),
    st.frozensets(st.sampled_from(EffectKind)),
    speed=st.integers(*SPEEDS),
    text_size=st.integers(*TEXT_SIZES),
    vision=st.sampled_from(VISIONS),
    music=st.integers(0, 100),
    ball=st.sampled_from(list(BALLS)),
    trail=st.sampled_from(list(TRAILS)),
    language=st.sampled_from([SYSTEM, *CODES]),
    own_keys=st.dictionaries(st.sampled_from(Action), st.lists(st.integers(0, 511)).map(tuple)).map(
        lambda keys: OwnKeys(tuple(sorted(keys.items(), key=lambda choice: choice[0].value)))
    ),
)
anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=5,
)


def left(folder):
    """The names of the files in a folder."""
    return sorted(path.name for path in folder.iterdir())


@given(choices)
def test_what_is_written_is_read(chosen):
    """Every choice survives the file."""
    assert decoded(json.loads(encoded(chosen))) == chosen


@given(st.dictionaries(st.sampled_from([*Settings._fields, "other"]), anything))
def test_any_value_gives_settings_that_can_be_played(said):
    """Whatever the keys hold: known colours, a volume from 0 to 100, known effects; and what makes sense is taken."""
    found = decoded(said)
    assert found.theme is not None
    assert 0 <= found.volume <= 100
    assert found.off <= ALL
    assert SPEEDS[0] <= found.speed <= SPEEDS[1]
    assert TEXT_SIZES[0] <= found.text_size <= TEXT_SIZES[1]
    assert found.vision in VISIONS
    choose(found.language)
    choose("en")
    assert bindings(checked(found.own_keys))
    assert all(isinstance(flag, bool) for flag in (found.sound, found.reduced_motion, found.effects))
    if isinstance(said.get("reduced_motion"), bool):
        assert found.reduced_motion == said["reduced_motion"]


@pytest.mark.parametrize(
    ("said", "kept"), [(700, 100), (-3, 0), (1e300, 100), (49.6, 50), ("loud", 80), (True, 80), (None, 80)]
)
def test_a_volume_out_of_range_is_brought_into_it_and_nothing_else_changes(said, kept):
    """The other keys of the file are read as they are."""
    assert decoded({"volume": said, "colours": "light", "off": ["shake", "unheard of", 7]}) == Settings(
        colours="light", volume=kept, off=frozenset({EffectKind.SHAKE})
    )


def test_without_a_file_there_are_the_defaults_and_no_word(tmp_path):
    """The first start; a file is made only when something was changed."""
    file = SettingsFile(tmp_path / "deep" / "settings.json")
    assert file.load() == Settings()
    file.keep(Settings())
    assert file.problem is None
    assert left(tmp_path) == []
    file.keep(CHOSEN)
    assert SettingsFile(tmp_path / "deep" / "settings.json").load() == CHOSEN
    assert left(tmp_path / "deep") == ["settings.json"]


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"{",
        b"[1]",
        b'{"volume": NaN}',
        b"\xff\xfe",
        b"\xef\xbb\xbf{}",
        b'{"a":' * 9000,
        b" " * 70_000,
        b"null",
        bytes(100),
        b'{"volume": 50} trailing',
    ],
)
def test_a_file_that_cannot_be_read_is_put_aside(tmp_path, data):
    """One line, the defaults, and the broken file under another name; what is chosen then is kept."""
    path = tmp_path / "settings.json"
    path.write_bytes(data)
    file = SettingsFile(path)
    assert file.load() == Settings()
    assert "moved to" in file.problem
    assert "\n" not in file.problem
    (aside,) = left(tmp_path)
    assert aside.startswith("settings.json.bad-")
    assert (tmp_path / aside).read_bytes() == data
    file.keep(CHOSEN)
    assert SettingsFile(path).load() == CHOSEN


def test_a_newer_file_is_read_but_not_overwritten(tmp_path):
    """What is understood of it holds; the file stays as it is."""
    path = tmp_path / "settings.json"
    path.write_text(json.dumps({"version": VERSION + 1, "volume": 20, "hats": True}))
    before = path.read_bytes()
    file = SettingsFile(path)
    assert file.load().volume == 20
    file.keep(CHOSEN)
    assert path.read_bytes() == before
    assert "newer" in file.problem


def test_a_folder_in_the_files_place_is_left_alone(tmp_path):
    """Nothing to read, nothing to write, one line, and the game goes on."""
    path = tmp_path / "settings.json"
    path.mkdir()
    file = SettingsFile(path)
    assert file.load() == Settings()
    assert "not a file" in file.problem
    file.keep(CHOSEN)
    assert file.problem.startswith("settings not saved")
    assert left(tmp_path) == ["settings.json"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names on this system")
def test_a_pipe_in_the_files_place_does_not_block(tmp_path):
    """Nobody ever writes into it."""
    path = tmp_path / "settings.json"
    os.mkfifo(path)
    file = SettingsFile(path)
    assert file.load() == Settings()
    assert "not a file" in file.problem


def test_where_nothing_can_be_written_the_old_file_stays(tmp_path, monkeypatch):
    """A disk that is full or may not be written: one line, and no torn or left-over file."""
    path = tmp_path / "settings.json"
    SettingsFile(path).keep(CHOSEN)
    before = path.read_bytes()

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("game.system.files.os.fsync", full)
    file = SettingsFile(path)
    file.load()
    file.keep(Settings())
    assert file.problem == f"settings not saved: {path}: No space left on device"
    assert left(tmp_path) == ["settings.json"]
    assert path.read_bytes() == before


def test_a_link_is_followed(tmp_path):
    """A dotfile manager keeps the file elsewhere: the link stays, the file there is written."""
    (tmp_path / "kept").mkdir()
    path = tmp_path / "settings.json"
    path.symlink_to("kept/mine.json")
    SettingsFile(path).keep(Settings(volume=30))
    assert path.is_symlink()
    assert SettingsFile(path).load().volume == 30
    assert left(tmp_path / "kept") == ["mine.json"]


def test_what_a_killed_session_left_is_removed_at_the_next_start(tmp_path):
    """Before the settings are read."""
    (tmp_path / ".polar-breakout-00.tmp").write_bytes(b'{"vol')
    SettingsFile(tmp_path / "settings.json").load()
    assert left(tmp_path) == []


def test_headless_games_touch_no_settings(tmp_path):
    """A broken file stays where it is, and no folder is made."""
    code = f"""
import pathlib
from game.settings import folder as settings_folder
from game.commands import app
from game.system.command_line import run
def place():
    raise AssertionError("the settings were looked for")
settings_folder.settings_path = place
import game.commands
game.commands.settings_path = place
assert run(app, "x", ["--headless", "--autopilot", "--ticks", "300", "--screenshot", {str(tmp_path / "a.png")!r}]) == 0
"""
    subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, check=True, capture_output=True, env={**os.environ, "SDL_VIDEODRIVER": "dummy"}
    )
    assert left(tmp_path) == ["a.png"]


def test_the_settings_are_in_the_users_folder(monkeypatch, tmp_path):
    """Under the program's name."""
    monkeypatch.setattr(settings_folder.platformdirs, "user_config_path", lambda name, **_: tmp_path / name)
    assert settings_folder.settings_path() == tmp_path / "polar-breakout" / "settings.json"


def test_every_effect_can_be_left_out_alone():
    """Twice is as before; nothing else is left out with it."""
    for kind in EffectKind:
        without = Settings().toggled(kind)
        assert without.shown == ALL - {kind}
        assert without.toggled(kind) == Settings()


def test_reduced_motion_does_without_what_moves_the_picture():
    """Shake, flashes, waves and hit-stop go; what is off stays off."""
    calm = Settings(reduced_motion=True, off=frozenset({EffectKind.SHARDS}))
    assert calm.shown == ALL - MOVING - {EffectKind.SHARDS}
    assert {EffectKind.SHAKE, EffectKind.FLASH, EffectKind.HIT_STOP} <= MOVING


def test_without_effects_only_the_trail_and_the_arenas_light_are_left():
    """And not even these for those who do not want them."""
    assert Settings(effects=False).shown == PLAIN == {EffectKind.TRAIL, EffectKind.DEPTH}
    assert Settings(effects=False, off=PLAIN).shown == frozenset()


def test_the_volume_goes_in_steps_and_ends_at_its_ends():
    """Turning it up turns the sound on, turning it down does not."""
    loud = Settings(sound=False)
    for _ in range(30):
        loud = loud.louder(1)
    assert (loud.volume, loud.sound) == (100, True)
    for _ in range(30):
        loud = loud._replace(sound=False).louder(-1)
    assert (loud.volume, loud.sound) == (0, False)


def test_colours_go_round():
    """Dark, light, high contrast, dark."""
    light = Settings().other_colours()
    assert light.theme is LIGHT
    assert light.other_colours().theme is HIGH_CONTRAST
    assert light.other_colours().other_colours() == Settings()
