"""The command line: one line and an exit code for everything that can go wrong."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from game import levels
from game.autopilot import Autopilot
from game.input.view import FLAT, SOLID
from game.levels import classic
from game.replays import file as replay
from game.replays.verify import verified
from game.rules import EventKind, new_game, tick
from game.screenshot import save_screenshot
from tests.support.command_line import polar
from tests.support.paths import ROOT

HEADLESS = ["--headless", "--autopilot", "--seed", "7", "--ticks", "500"]


def test_a_headless_game_prints_one_line(capsys):
    """The result line says how the game stands and what repeats it, and is the same every time."""
    first, again = polar(capsys, *HEADLESS), polar(capsys, *HEADLESS)
    pattern = r"ticks=500 seed=7 physics=swept level=1 phase=\w+ score=\d+ lives=\d layers=\d+ hash=[0-9a-f]{64}\n"
    assert first == again
    assert re.fullmatch(pattern, first[1])
    assert polar(capsys, *HEADLESS[:-3], "8", *HEADLESS[-2:])[1] != first[1]


def test_the_physics_of_the_line_is_the_one_that_was_flown(capsys):
    """With --physics source the line says so; without --seed the seed is 1."""
    code, out, _ = polar(capsys, "--headless", "--autopilot", "--ticks", "300", "--physics", "source")
    assert code == 0
    assert out.startswith("ticks=300 seed=1 physics=source level=1 ")


def test_the_list_of_levels_counts_bricks_and_layers(capsys):
    """A stack of several layers is one brick."""
    _, out, _ = polar(capsys, "levels")
    towers = next(level for level in levels.classic() if level.name == "Towers")
    stacks = [layers for ring in towers.rings for layers in ring.slots() if layers > 0]
    assert len(stacks) < sum(stacks)
    assert out.split("\n", 1)[0].split()[:4] == ["#", "name", "bricks", "layers"]
    assert re.search(rf"Towers +{len(stacks)} +{sum(stacks)} ", out)


def test_a_recorded_game_verifies(capsys, tmp_path: Path):
    """What --record writes, replay --verify plays to the same hash."""
    file = tmp_path / "game.polar"
    _, out, _ = polar(capsys, *HEADLESS, "--record", file)
    code, verified, _ = polar(capsys, "replay", "--verify", file)
    assert code == 0
    assert verified == f"verified {file}: {out}"


def test_two_players_are_chosen(capsys, tmp_path: Path):
    """The autopilot plays for both; the recording verifies; the source's rules know one player."""
    file = tmp_path / "two.polar"
    code, out, _ = polar(capsys, *HEADLESS, "--players", "versus", "--record", file)
    assert code == 0
    assert replay.load(file).ruleset.versus
    assert polar(capsys, "replay", "--verify", file) == (0, f"verified {file}: {out}", "")
    code, _, err = polar(capsys, *HEADLESS, "--players", "versus", "--rules", "source")
    assert (code, err.count("\n")) == (2, 1)
    assert "--players versus" in err


def test_the_rules_and_the_difficulty_are_chosen(capsys, tmp_path: Path):
    """Each is another game; arcade at normal difficulty is played where nothing is said, and a replay knows its rules."""
    chosen = [[], ["--rules", "arcade"], ["--difficulty", "easy"], ["--difficulty", "hard"], ["--rules", "source"]]
    file = tmp_path / "game.polar"
    lines = []
    for options in chosen:
        lines.append(polar(capsys, *HEADLESS, *options, "--record", file)[1])
        assert polar(capsys, "replay", "--verify", file)[1].endswith(lines[-1])
    assert lines[0] == lines[1]
    assert len(set(lines)) == 4


def test_headless_imports_no_pygame(tmp_path: Path):
    """A headless game, recorded and verified, and the list of levels never import pygame."""
    file = tmp_path / "game.polar"
    program = (
        "import sys; from game.commands import app; from game.system.command_line import run\n"
        f"for arguments in ({[*HEADLESS, '--record', str(file)]!r}, ['replay', '--verify', {str(file)!r}], ['levels']):\n"
        "    assert run(app, 'x', arguments) == 0\n"
        "assert 'pygame' not in sys.modules and 'numba' not in sys.modules and 'pymunk' not in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["--bogus"], "No such option"),
        (["--level"], "requires an argument"),
        (["--level", "none"], "no such level"),
        (["--level", "none.toml"], "cannot read level"),
        (["--seed", "abc"], "--seed"),
        (["--seed", "-1"], "--seed"),
        (["--seed", str(2**70)], "--seed"),
        (["--headless", "--autopilot", "--ticks", "-1"], "--ticks"),
        (["--headless", "--autopilot", "--ticks", "1e3"], "--ticks"),
        (["--headless", "--autopilot", "--ticks", str(10**18)], "--ticks"),
        (["--headless"], "nobody plays; add --autopilot"),
        (["--screenshot", "x.png"], "add --headless --autopilot"),
        ([*HEADLESS, "--size", "0x0", "--screenshot", "x.png"], "--size 0x0: expected 16 to 16384"),
        ([*HEADLESS, "--size", "big"], "--size big: expected WIDTHxHEIGHT"),
        ([*HEADLESS, "--record", "."], "a folder; expected a file"),
        ([*HEADLESS, "--record", "none/x.polar"], "there is no folder none"),
        ([*HEADLESS, "--screenshot", "none/x.png"], "there is no folder none"),
        ([*HEADLESS, "--record", "/dev/null"], "--record /dev/null: cannot be written; a device, not a regular file"),
        ([*HEADLESS, "--screenshot", "a.txt"], "--screenshot a.txt: expected a name that ends in .png, not .txt"),
        ([*HEADLESS, "--size", "100x100"], "--size: is for a picture; add --screenshot FILE"),
        ([*HEADLESS, "--view", "solid"], "--view: is for a picture"),
        ([*HEADLESS, "--rules", "arcade", "--physics", "source"], "--rules arcade: the slides' own algorithm"),
        ([*HEADLESS, "--rules", "source", "--difficulty", "easy"], "--difficulty: is for the arcade rules"),
        ([*HEADLESS, "--difficulty", "brutal"], "'--difficulty': 'brutal' is not one of 'easy'"),
        (["screens", "--pictures", ".", "--only", "nothing"], "--only nothing: no screen has that in its name"),
        (["--rules", "source", "levels"], "--rules: is not for the command levels"),
        (["--ticks", "5"], "--ticks: is for a headless game"),
        (["--headless", "levels"], "--headless: is not for the command levels"),
        (["--seed", "3", "replays"], "--seed: is not for the command replays"),
        (["--record", "a.polar", "lab"], "--record: is not for the command lab"),
        (["lab", "--list", "--headless"], "--headless: does nothing beside --list"),
        (["lab", "case-2", "--list"], "scene: does nothing beside --list"),
        (["lab", "--headless", "--screenshot", "a.png"], "--screenshot: does nothing beside --headless"),
        (["lab", "--drags", "5"], "--drags: is for checking scenes"),
        (["lab", "--theme", "light"], "--theme: is for a picture"),
        (["lab", "--screenshot", "a.txt"], "expected a name that ends in .png"),
        (["--level", "00099"], "--level 00099: no such level"),
        (["--level", "x" * 5000], "x...x"),
        (["--size", "9" * 5000, "--screenshot", "a.png"], "9...9"),
        (["replay", "no\nne.polar"], "no\\nne.polar: cannot read replay"),
        (["replay", "x" * 5000], "File name too long"),
        (["replay"], "FILES"),
        (["replay", "none.polar"], "cannot read replay"),
        (["replay", "--verify", "."], "not a folder"),
        (["replay", "a.polar", "b.polar"], "expected one"),
        (["nonsense"], "No such command"),
    ],
)
def test_bad_options_exit_2_with_one_line(capsys, monkeypatch, tmp_path, arguments, reason):
    """Every bad option or file exits with 2 and one line on stderr that names it, and prints nothing else."""
    monkeypatch.chdir(tmp_path)
    code, out, err = polar(capsys, *arguments)
    assert (code, out) == (2, "")
    assert re.fullmatch(r"polar-breakout: [^\n]{1,500}\n", err)
    assert reason.casefold() in err.casefold()
    assert list(tmp_path.iterdir()) == []


def test_an_interrupted_recording_is_kept(tmp_path: Path):
    """A signal ends a headless game early: what was played is written, and verifies."""
    file = tmp_path / "game.polar"
    code = (
        "import os, signal, sys\n"
        "from game.system.start import prepare\n"
        "signal.signal(signal.SIGTERM, signal.SIG_DFL)\n"
        "prepare('x')\n"
        "from game import commands, headless\n"
        "from game.system.command_line import run\n"
        "tick = headless.tick\n"
        "def counted(game, controls, advance):\n"
        "    if game.tick == 100: os.kill(os.getpid(), signal.SIGTERM)\n"
        "    return tick(game, controls, advance)\n"
        "headless.tick = counted\n"
        f"sys.exit(run(commands.app, 'x', {[*HEADLESS, '--record', str(file)]!r}))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (143, "", "x: terminated\n")
    recording = replay.load(file)
    assert 100 <= recording.ticks < 110
    assert verified(recording).divergence is None


def test_a_narrow_gate_is_warned_of(capsys, tmp_path: Path):
    """One line on stderr; the game is played."""
    ring = "[[rings]]\nradius = 7.0\nhalf_width = 0.1\nhalf_angle = 87.6\ncount = 2\nlayers = -1\n"
    file = tmp_path / "gate.toml"
    first = Path(levels.__file__).parent / "classic" / "1-first-wall.toml"
    file.write_text(first.read_text(encoding="utf-8") + ring, encoding="utf-8")
    code, out, err = polar(capsys, *HEADLESS, "--level", file)
    assert (code, out.count("\n"), err.count("\n")) == (0, 1, 1)
    assert "warning: " in err
    assert "rings[1]: its widest gate is 1.1" in err


def test_a_divergence_exits_1(capsys, tmp_path: Path, monkeypatch):
    """A replay that plays differently exits with 1 and says where."""
    file = tmp_path / "game.polar"
    polar(capsys, *HEADLESS, "--record", file)
    monkeypatch.setattr("game.rules.scoring._POINTS_PER_BRICK", 11)
    monkeypatch.setattr("game.rules.serving.SERVE_GAP", 1e-5)
    code, _, err = polar(capsys, "replay", "--verify", file)
    assert code == 1
    assert "diverged at tick 1 (block 1-60), first in: ball positions" in err


def test_help_needs_no_display():
    """--help, --version and levels exit with 0 on a machine without any display."""
    environment = {name: value for name, value in os.environ.items() if "DISPLAY" not in name}
    for arguments in (["--help"], ["--version"], ["levels"], ["replay", "--help"], ["replays"]):
        done = subprocess.run([sys.executable, "-m", "game", *arguments], env=environment, capture_output=True, check=False)
        assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such shell")
def test_a_closed_pipe_is_no_error():
    """Output into a pipe that nobody reads ends quietly."""
    command = f"{sys.executable} -m game levels | true"
    done = subprocess.run(["sh", "-c", command], capture_output=True, check=False)  # noqa: S607
    assert b"Traceback" not in done.stderr


def test_ctrl_c_is_one_line(capsys, monkeypatch):
    """An interrupted game exits with 130 and one line."""

    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("game.chosen_game.autopilot_game", interrupted)
    assert polar(capsys, *HEADLESS) == (130, "", "polar-breakout: interrupted\n")


@pytest.mark.skipif(sys.platform == "win32", reason="on Windows every path is UTF-16")
def test_odd_characters_in_a_path_can_be_named(capsys):
    """A path that is not UTF-8 is named in the error, not the cause of another."""
    code, _, err = polar(capsys, "replay", os.fsdecode(b"no\xffne.polar"))
    assert code == 2
    assert "no\\udcffne.polar" in err


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there is always a display")
def test_without_a_display_it_says_so_and_shows_what_it_can(tmp_path: Path):
    """Without any display, the plain command says so in one line, plays by itself and leaves a picture; it exits with 0."""
    hidden = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"}
    environment = {name: value for name, value in os.environ.items() if name not in hidden}
    root = ROOT
    command = [sys.executable, "-m", "game", "--seed", "5"]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment | {"PYTHONPATH": str(root)}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert re.fullmatch(r"polar-breakout: no display[^\n]*; playing 20 s without a window instead\n", done.stderr)
    assert re.fullmatch(r"ticks=4800 [^\n]*\npicture: [^\n]*polar-breakout\.png\n", done.stdout)
    assert (tmp_path / "polar-breakout.png").read_bytes().startswith(b"\x89PNG")


def test_a_screenshot_shows_the_effects_of_the_last_ticks(capsys, tmp_path: Path):
    """Just after a brick was hit there are shards in the air; a picture of the bare game has none."""
    game, pilot, hit = new_game(classic(), 7), Autopilot(), 0
    while not hit or game.tick < hit + 24:
        done = tick(game, pilot.controls(game))
        game = done.game
        if not hit and any(event.kind == EventKind.BRICK_HIT for event in done.events):
            hit = game.tick
    for view, seen in (("flat", FLAT), ("solid", SOLID)):
        path, bare = tmp_path / "shown.png", tmp_path / "bare.png"
        shot = ("--screenshot", path, "--view", view, "--size", "640x400")
        assert polar(capsys, *HEADLESS[:-1], game.tick, *shot)[0] == 0
        save_screenshot(game, bare, (640, 400), view=seen)
        assert path.read_bytes() != bare.read_bytes()
        again = tmp_path / "again.png"
        polar(capsys, *HEADLESS[:-1], game.tick, "--screenshot", again, "--view", view, "--size", "640x400")
        assert path.read_bytes() == again.read_bytes()
