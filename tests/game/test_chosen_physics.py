"""A game flown on the slides' own algorithm: it goes another way, says so on the screen, and leaves no replay."""

from pathlib import Path

import msgspec
import pygame
import pytest

from game import commands
from game.chosen_physics import SOURCE, SWEPT
from game.levels import Level, classic, parse
from game.loop import app
from game.screens.play.screen import PlayScreen
from game.storage import games as kept_games
from game.storage.storage import Storage
from tests.support.command_line import polar
from tests.support.level_text import GOOD
from tests.support.windows.dummy_window import FRAME, SIZE, Desk, shared

HEADLESS = ("--headless", "--autopilot", "--seed", "3", "--ticks", "2000")


def test_swept_is_what_is_flown_unless_asked_otherwise(capsys):
    """`--physics swept` is the game without the option; `--physics source` ends elsewhere, and the same every time."""
    plain, swept = polar(capsys, *HEADLESS), polar(capsys, *HEADLESS, "--physics", "swept")
    source, again = (polar(capsys, *HEADLESS, "--physics", "source") for _ in range(2))
    assert plain == swept
    assert source == again != plain
    assert (source[0], source[2]) == (0, "")
    assert source[1].startswith("ticks=2000 ")


def test_a_recording_is_refused(capsys, tmp_path: Path):
    """A replay is verified with the swept physics: one line, exit code 2, and no file."""
    file = tmp_path / "game.polar"
    for arguments in (HEADLESS, ()):
        code, out, err = polar(capsys, *arguments, "--physics", "source", "--record", file)
        assert (code, out, err.count("\n")) == (2, "", 1)
        assert err.startswith("polar-breakout: --record: a replay is verified with the swept physics")
    assert not file.exists()


@pytest.mark.parametrize("physics", ["swept", "source"])
def test_a_game_in_the_window_is_kept_only_if_it_can_be_verified(capsys, monkeypatch, tmp_path: Path, physics):
    """The option's physics reaches the window, and games of the slides' own algorithm leave nothing behind."""
    monkeypatch.setattr(commands, "settings_path", lambda: tmp_path / "settings.json")
    monkeypatch.setattr(commands, "data_folder", lambda: tmp_path)
    monkeypatch.setattr(kept_games, "_SHORTEST", 0.1)
    plain, flown = app.frame, []

    def frame(window, state, screen, _seconds):
        flown.append(state.physics)
        return plain(window, state, screen, FRAME) if len(flown) < 30 else None

    monkeypatch.setattr(app, "frame", frame)
    code, _, err = polar(capsys, "--autopilot", "--physics", physics)
    assert (code, err) == (0, "")
    assert set(flown) == {{"swept": SWEPT, "source": SOURCE}[physics]}
    assert len(Storage(tmp_path).games.paths()) == (physics == "swept")


def flown_in_a_window(physics, seconds, size=SIZE):
    """The picture of a game of the autopilot after some seconds, the game, and the layout."""
    state = shared(autopilot=True)
    state.physics = physics
    desk = Desk(state, PlayScreen(state, classic()), size)
    desk.wait(seconds)
    picture = pygame.Surface(size, 0, 32)
    desk.screen.draw(picture)
    game, seen = desk.screen._ticked.game, desk.screen._layout(size)
    desk.close()
    return picture, game, seen


def test_the_window_flies_what_it_is_given():
    """After the first bricks the games of the two are different ones."""
    swept, source = (flown_in_a_window(physics, 5.0)[1] for physics in (SWEPT, SOURCE))
    assert swept.score > 0
    assert swept.arena != source.arena


@pytest.mark.parametrize("size", [SIZE, (1280, 800), (300, 900), (200, 150)])
def test_a_line_on_the_screen_says_so(size):
    """The note stands alone at the lower edge, in the middle, whole; a game without a note leaves no room for one."""
    state = shared()
    (without, *_), (given, _, seen) = (flown_in_a_window(physics, 0.1, size) for physics in (SWEPT, SOURCE))
    unit = state.canvas(given).unit
    room = pygame.Rect(0, size[1] - round(unit * 1.5), size[0], round(unit * 1.5))

    def ink(picture):
        return pygame.mask.from_threshold(picture.subsurface(room), state.theme.accent, (190, 160, 255, 255))

    letters = ink(given).get_bounding_rects()
    box = letters[0].unionall(letters)
    assert box.width > 30.0 * box.height
    assert abs(box.centerx - size[0] / 2.0) <= 2.0
    assert min(box.left, size[0] - box.right) >= unit * 0.7
    assert ink(given).count() > 100
    assert seen.camera.project(-1j * seen.ground_radius).imag < room.top + box.top
    assert ink(without).overlap_area(ink(given), (0, 0)) != ink(given).count()


def narrow_level() -> Level:
    """A level as no file may be: between its paddle, nearly a whole ring, and a steel ring the ball has no play."""
    level = parse(GOOD, "x")
    lane = 2.0 * level.ball.radius * (1.0 + 1e-5)
    paddles = msgspec.structs.replace(level.paddles, count=1, half_angle=179.0)
    inner = paddles.radius - paddles.half_width - lane - level.rings[0].half_width
    steel = msgspec.structs.replace(level.rings[0], radius=inner, half_angle=180.0, count=1, layers=-1)
    return msgspec.structs.replace(level, paddles=paddles, rings=(*level.rings, steel))


def test_ticks_cut_short_are_said_at_the_end(capsys, monkeypatch):
    """A ball held in a lane too narrow bounces more often than a tick can answer: one line on stderr counts those ticks."""
    monkeypatch.setattr(commands, "chosen", lambda _: (narrow_level(),))
    monkeypatch.setattr(commands, "warnings", lambda _: ())
    code, out, err = polar(capsys, *HEADLESS[:-1], "800")
    assert (code, out.count("\n"), err.count("\n")) == (0, 1, 1)
    assert err.startswith("polar-breakout: ")
    assert err.endswith(" cut short: a ball is held in a lane too narrow\n")
    assert int(err.split()[1]) > 10
