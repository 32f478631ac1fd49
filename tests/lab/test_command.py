"""`python -m game lab` without a window."""

import os
import re
import subprocess
import sys

import pygame
import pytest

from game.lab import command
from game.lab.kit.scene import Claim
from game.lab.registry import chapters, scenes
from game.lab.session.share import parsed
from tests.support.command_line import polar


def test_the_list_names_every_scene(capsys):
    """`--list` prints a row for each scene that begins with its name."""
    code, out, err = polar(capsys, "lab", "--list")
    assert (code, err) == (0, "")
    for scene in scenes():
        assert re.search(rf"^{scene.name} ", out, re.MULTILINE)


def test_the_list_has_the_chapters_and_says_where_the_rows_are(capsys):
    """Every scene stands below its chapter; the last line names the page of the table that the numbers are rows of."""
    _, out, _ = polar(capsys, "lab", "--list")
    lines = out.splitlines()
    assert 'rows of "Beyond the source"' in lines[0]
    assert lines[-1].endswith("is a table in docs/algorithm.md")
    heads = [line.strip() for line in lines if line.startswith("-- ")]
    assert heads == ["-- angles", "-- broad phase", "-- narrow phase", "-- response", "-- time of impact", "-- runs"]
    listed = [scene for chapter in chapters().values() for scene in chapter]
    assert listed == list(scenes())
    names = [scene.name for scene in listed]
    assert [name for line in lines if (name := line.partition(" ")[0]) in names] == names


def test_headless_checks_every_scene_without_a_window():
    """`--headless` prints a row without failures for each scene, and exits with 0. Neither it nor `--list` imports pygame."""
    program = (
        "import sys; from game.commands import app; from game.system.command_line import run\n"
        "for arguments in (['lab', '--list'], ['lab', '--headless', '--drags', '3']):\n"
        "    assert run(app, 'x', arguments) == 0\n"
        "assert 'pygame' not in sys.modules\n"
    )
    done = subprocess.run([sys.executable, "-c", program], check=False, capture_output=True, encoding="utf-8")
    assert (done.returncode, done.stderr) == (0, "")
    for scene in scenes():
        assert re.search(rf"^{scene.name} +[\d,]+ +[\d,]+ +0$", done.stdout, re.MULTILINE)


def test_headless_exits_1_when_a_claim_fails(capsys, monkeypatch):
    """A failed claim is named on stderr with the command that opens the scene there."""
    broken = scenes()[0]._replace(check=lambda _: (Claim("black is white", holds=False),))
    monkeypatch.setattr(command, "scenes", lambda: (broken, *scenes()[1:2]))
    code, _, err = polar(capsys, "lab", "--headless", "--drags", "3")
    assert code == 1
    assert f'"black is white" does not hold: python -m game lab "{broken.name}?' in err
    assert err.endswith("polar-breakout: lab: 1 of 2 scenes failed\n")


def test_a_picture_is_drawn_without_a_display(tmp_path):
    """`--screenshot` saves a picture of the size asked for, in dark or in light colours."""
    pictures = []
    for theme in ("dark", "light"):
        file = tmp_path / f"{theme}.png"
        arguments = ["lab", "case-2?ball=10.9,4.4", "--screenshot", str(file), "--size", "640x480", "--theme", theme]
        hidden = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}
        environment = {name: value for name, value in os.environ.items() if name not in hidden}
        done = subprocess.run(
            [sys.executable, "-m", "game", *arguments], env=environment, capture_output=True, text=True, check=False
        )
        assert (done.returncode, done.stdout, done.stderr) == (0, f"picture: {file}\n", "")
        pictures.append(pygame.image.load(file))
    assert [picture.get_size() for picture in pictures] == [(640, 480)] * 2
    assert pictures[0].get_at((300, 200)) != pictures[1].get_at((300, 200))


def test_headless_checks_one_scene_at_the_values_of_a_share_line(capsys, monkeypatch):
    """A claim that fails only at the values of the share line is found."""
    named = parsed("case-2?r=1.25")
    touchy = named.scene._replace(check=lambda given: (Claim("r is not 1.25", given.number("r") != 1.25),))
    monkeypatch.setattr(command, "parsed", lambda *_: named._replace(scene=touchy))
    code, out, err = polar(capsys, "lab", "case-2?r=1.25", "--headless", "--drags", "5")
    assert code == 1
    assert len(out.splitlines()) == 2
    assert "r=1.25&" in err


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there is always a display")
def test_without_a_display_it_is_one_line_and_exit_3():
    """Without a display the lab says so in one line and exits with 3."""
    hidden = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"}
    environment = {name: value for name, value in os.environ.items() if name not in hidden}
    command = [sys.executable, "-m", "game", "lab", "polar"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (3, "")
    assert re.fullmatch(r"polar-breakout: no display[^\n]*\n", done.stderr)


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["lab", "cse-2", "--headless"], "near: case-2"),
        (["lab", "case-2?ball=x,1", "--screenshot", "a.png"], "'x' is not a number"),
        (["lab", "--screenshot", "none/a.png"], "there is no folder none"),
        (["lab", "--screenshot", "a.png", "--size", "1"], "expected WIDTHxHEIGHT"),
        (["lab", "--screenshot", "a.png", "--theme", "blue"], "'blue' is not one of 'dark', 'light'"),
        (["lab", "--headless", "--drags", "-1"], "--drags"),
        (["lab", "a", "b"], "unexpected extra argument"),
    ],
)
def test_bad_options_exit_2_with_one_line(capsys, monkeypatch, tmp_path, arguments, reason):
    """A bad option is one line on stderr; nothing is printed to stdout and no file is written."""
    monkeypatch.chdir(tmp_path)
    code, out, err = polar(capsys, *arguments)
    assert (code, out) == (2, "")
    assert re.fullmatch(r"polar-breakout: [^\n]+\n", err)
    assert reason in err
    assert list(tmp_path.iterdir()) == []
