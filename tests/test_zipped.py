"""The program runs from a zip archive: levels, scenes and source lines are found where there are no files."""

import os
import shutil
import subprocess
import sys
import zipapp

import pytest

from game.lab.registry import scenes
from tests.support.paths import ROOT

pytestmark = pytest.mark.deep

HEADLESS = ["--headless", "--autopilot", "--seed", "7", "--ticks", "300"]


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    """The three packages in one file; the libraries are those of this Python."""
    folder = tmp_path_factory.mktemp("zipped")
    for package in ("game", "physics", "tools"):
        shutil.copytree(ROOT / package, folder / "packages" / package, ignore=shutil.ignore_patterns("__pycache__"))
    zipapp.create_archive(folder / "packages", folder / "polar-breakout.pyz", main="game.__main__:main")
    shutil.rmtree(folder / "packages")
    return folder / "polar-breakout.pyz"


def ran(command, folder, path=""):
    """The outcome of a command in a folder that has nothing of the project. path: where else modules are found."""
    environment = os.environ | dict.fromkeys(("HOME", "APPDATA", "XDG_CONFIG_HOME", "XDG_DATA_HOME"), str(folder))
    environment |= {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYTHONPATH": str(path)}
    return subprocess.run(
        [sys.executable, *map(str, command)], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


def test_a_zipped_game_is_the_same_game(archive, tmp_path):
    """Its result, to the hash, on a level by number; and a picture of it."""
    arguments = [*HEADLESS, "--level", "4"]
    zipped = ran([archive, *arguments, "--screenshot", tmp_path / "a.png"], tmp_path)
    assert (zipped.returncode, zipped.stderr) == (0, "")
    assert zipped.stdout == ran(["-m", "game", *arguments], tmp_path, ROOT).stdout
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


def test_the_zipped_lab_has_every_scene(archive, tmp_path):
    """They hold their claims, beside pymunk, and quote the lines that decide."""
    zipped = ran([archive, "lab", "--headless", "--drags", "1"], tmp_path)
    assert (zipped.returncode, zipped.stderr) == (0, "")
    names = [line.split()[0] for line in zipped.stdout.splitlines()[1:]]
    assert names == [scene.name for scene in scenes()]
    assert len(names) > 20
    picture = tmp_path / "b.png"
    done = ran([archive, "lab", names[0], "--screenshot", picture], tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_a_zipped_title_opens_a_window(archive, tmp_path):
    """The whole game, closed after its first picture."""
    program = (
        f"import sys; sys.path.insert(0, {str(archive)!r}); import game.loop.app as app; from game.__main__ import main\n"
        "flip = app._flip\n"
        "def first(window):\n"
        "    flip(window); print('shown', flush=True); raise KeyboardInterrupt\n"
        "app._flip = first; sys.argv = ['polar-breakout']; main()\n"
    )
    done = ran(["-c", program], tmp_path)
    assert done.stdout == "shown\n", done.stderr
    assert "Traceback" not in done.stderr
