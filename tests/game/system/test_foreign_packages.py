"""Packages of others that have the game's names, or are in the way of its libraries."""

import os
import subprocess
import sys
import types

import pytest

from game.system.errors import EnvironmentMissingError
from game.system.pygame_ce import check_pygame
from tests.support.paths import ROOT

pytestmark = pytest.mark.deep

SCRIPTS = ROOT / "tools" / "packaging"
"""Where the console scripts begin; installed, a package of its own."""
PLAY = "from polar_breakout import play; play()"
CROSSCHECK = "from polar_breakout import crosscheck; crosscheck()"
HEADLESS = ["--headless", "--autopilot", "--seed", "3"]


def foreign(folder, *names):
    """A folder with packages of these names that end whoever imports them."""
    for name in names:
        (folder / name).mkdir()
        (folder / name / "__init__.py").write_text(f"raise SystemExit('the foreign {name} was imported')\n")
    return folder


def ran(code, arguments, path, cwd):
    """A program with a PYTHONPATH, run in a folder."""
    drivers = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYTHONPATH": os.pathsep.join(map(str, path))}
    command = [sys.executable, *(["-c", code] if code else []), *arguments]
    return subprocess.run(command, cwd=cwd, env=os.environ | drivers, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("names", [("game", "physics", "tools"), ("physics",), ("tools",), ("game",)], ids="-".join)
def test_the_console_scripts_find_their_own_packages(tmp_path, names):
    """Foreign packages that come first on the path are passed over; those that are called from another process, too."""
    path = [foreign(tmp_path, *names), SCRIPTS]
    played = ran(PLAY, [*HEADLESS, "--ticks", "100"], path, tmp_path)
    assert (played.returncode, played.stderr) == (0, "")
    assert played.stdout.startswith("ticks=100 ")
    checked = ran(CROSSCHECK, ["--level", "aimed", "--games", "2", "--ticks", "5", "--workers", "2"], path, tmp_path)
    assert (checked.returncode, checked.stderr) == (0, "")


def test_a_foreign_package_in_the_working_directory_is_passed_over(tmp_path):
    """`python -m game` finds the game somewhere, and its neighbours there, also pymunk's opinion that key N asks for."""
    code = "import game\nfrom tools.crosscheck.overlay import opinions\nfrom physics import advance\nprint(opinions.__module__)"
    done = ran(code, [], [foreign(tmp_path, "tools", "physics"), ROOT], tmp_path)
    assert (done.returncode, done.stdout) == (0, "tools.crosscheck.overlay\n"), done.stderr


def test_the_tools_pass_over_a_foreign_game(tmp_path):
    """`python -m tools.crosscheck` and the like find the game beside them."""
    done = ran("import tools.crosscheck.run", [], [foreign(tmp_path, "game"), ROOT], tmp_path)
    assert done.returncode == 0, done.stderr


def test_an_installation_with_holes_is_one_line(tmp_path):
    """A package that lacks a module, because another one was installed over it, is named with its folder."""
    home = tmp_path / "site"
    for name in ("game", "polar_breakout"):
        (home / name).mkdir(parents=True)
    (home / "game" / "__init__.py").write_text("")
    (home / "game" / "__main__.py").write_text("from game import VERSION")
    (home / "polar_breakout" / "__init__.py").write_bytes((SCRIPTS / "polar_breakout" / "__init__.py").read_bytes())
    done = ran(PLAY, [], [home], tmp_path)
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr.count("\n") == 1
    assert done.stderr.startswith("polar-breakout: cannot import name 'VERSION'")
    assert f"{home} lacks it or has another package of that name: pip install" in done.stderr


@pytest.mark.parametrize(
    "arguments",
    [[], [*HEADLESS, "--ticks", "5", "--screenshot", "x.png"], ["lab"], ["lab", "polar", "--screenshot", "x.png"]],
    ids=["play", "screenshot", "lab", "lab-screenshot"],
)
@pytest.mark.parametrize("left", ["", "version = '2.6.1'\n"], ids=["emptied", "pygame"])
def test_what_is_not_pygame_ce_is_one_line(tmp_path, arguments, left):
    """Whatever pygame left behind, one line says what to install; exit code 3."""
    (tmp_path / "pygame").mkdir()
    (tmp_path / "pygame" / "__init__.py").write_text(left)
    done = ran("", ["-m", "game", *arguments], [tmp_path, ROOT], tmp_path)
    assert (done.returncode, done.stdout) == (3, ""), done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stderr.startswith(f"polar-breakout: {tmp_path}")
    assert "pip install --force-reinstall pygame-ce" in done.stderr
    assert not (tmp_path / "x.png").exists()


def test_a_folder_without_a_package_is_not_pygame_ce(monkeypatch):
    """Uninstalled, pygame may leave a folder that Python takes for a package without a file."""
    left = types.ModuleType("pygame")
    left.__path__ = ["somewhere/pygame"]
    monkeypatch.setitem(sys.modules, "pygame", left)
    with pytest.raises(EnvironmentMissingError, match=r"^somewhere/pygame is not pygame-ce"):
        check_pygame()
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(EnvironmentMissingError, match=r"^pygame-ce cannot be loaded .*: pip"):
        check_pygame()
