"""The directions of the design: who may import whom. Every rule is shown to catch what breaks it."""

import pytest

from tests.support.import_rules import PACKAGES, WITHOUT_WINDOW, modules, violations
from tests.support.paths import ROOT


def test_every_import_goes_in_an_allowed_direction():
    """Over all files there are; a violation is named with its file, line and rule."""
    assert violations(ROOT) == []


def test_the_walk_finds_the_files():
    """All three packages and the tests, packages inside packages too."""
    found = modules(ROOT)
    assert {name.partition(".")[0] for name in found} == set(PACKAGES)
    assert {"physics", "physics.polar", "game", "game.rules", "game.drawing.solid.faces", "tests.test_imports"} <= set(found)
    assert len(found) == sum(len([*(ROOT / package).rglob("*.py")]) for package in PACKAGES)


def test_the_modules_without_a_window_exist():
    """A renamed file must not slip out of its rule."""
    assert {f"game.{name}" for name in WITHOUT_WINDOW} <= set(modules(ROOT))


def tree(folder, files):
    """A small project on disk."""
    for package in ("game", "physics", "tools", "tests"):
        (folder / package).mkdir()
        (folder / package / "__init__.py").write_text("")
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


WRONG = {
    "physics_numpy": ({"physics/polar.py": "import numpy as np"}, "physics.polar imports numpy"),
    "physics_from_numpy": ({"physics/polar.py": "from numpy.linalg import norm"}, "physics.polar imports numpy.linalg"),
    "physics_pygame_inside": ({"physics/polar.py": "def f():\n    import pygame"}, "physics/polar.py:2"),
    "physics_random": ({"physics/step.py": "import random"}, "physics.step imports random"),
    "physics_cmath": ({"physics/step.py": "import cmath"}, "physics.step imports cmath"),
    "physics_game": ({"physics/step.py": "from game.rules import tick"}, "physics.step imports game.rules"),
    "physics_batch": (
        {"physics/step.py": "from physics import batch", "physics/batch.py": ""},
        "physics does not need its batch",
    ),
    "physics_relative_batch": (
        {"physics/step.py": "from . import batch", "physics/batch.py": ""},
        "physics.step imports physics.batch",
    ),
    "physics_sub_numpy": ({"physics/sub/a.py": "import numpy"}, "physics.sub.a imports numpy"),
    "batch_pygame": ({"physics/batch.py": "import pygame"}, "physics.batch imports pygame"),
    "by_call": ({"physics/step.py": "__import__('numpy')"}, "physics.step imports numpy"),
    "by_name_unknown": ({"game/app.py": "import importlib\nimportlib.import_module(name)"}, "an import must be readable"),
    "game_tools": ({"game/app.py": "import tools.bench"}, "nothing imports tools but tests"),
    "game_tools_deferred": ({"game/app.py": "def f():\n    from tools import bench"}, "nothing imports tools but tests"),
    "game_main_tools": ({"game/__main__.py": "def f():\n    import tools.bench"}, "nothing imports tools but tests"),
    "game_relative_tools": ({"game/app.py": "from ..tools import bench"}, "nothing imports tools but tests"),
    "game_numba": ({"game/app.py": "import numba"}, "the game does not need numba"),
    "game_batch": ({"game/app.py": "from physics import batch", "physics/batch.py": ""}, "the game does not need numba"),
    "game_pymunk": ({"game/app.py": "import pymunk"}, "the game does not need pymunk"),
    "game_tests": ({"game/app.py": "import tests.strategies"}, "nothing imports the tests"),
    "rules_pygame": ({"game/rules.py": "import pygame"}, "game.rules -> pygame"),
    "rules_pygame_deferred": ({"game/rules.py": "def f():\n    import pygame.draw"}, "game.rules -> pygame.draw"),
    "replay_through_another": (
        {"game/replays/file.py": "from game.drawing import text", "game/drawing/text.py": "import pygame"},
        "game.replays.file -> game.drawing.text -> pygame",
    ),
    "levels_package": ({"game/levels/__init__.py": "", "game/levels/load.py": "import pygame"}, "game.levels.load -> pygame"),
    "autopilot_through_the_package": (
        {"game/__init__.py": "import pygame", "game/autopilot.py": "import game.rules", "game/rules.py": ""},
        "game.autopilot -> game -> pygame",
    ),
    "main_pygame": ({"game/__main__.py": "import pygame"}, "game.__main__ -> pygame"),
    "main_through_another": (
        {"game/__main__.py": "from game.app import play", "game/app.py": "import pygame"},
        "game.__main__ -> game.app -> pygame",
    ),
    "lab_pygame": ({"game/lab/share.py": "import pygame"}, "game.lab.share -> pygame"),
    "lab_scene_window": (
        {"game/lab/scenes/a.py": "def f():\n    from game.lab.window import x", "game/lab/window/x.py": "import pygame"},
        "game.lab.scenes.a -> game.lab.window.x -> pygame",
    ),
    "lab_scene_through_the_registry": (
        {
            "game/lab/registry.py": "import importlib\nimportlib.import_module(name)",
            "game/lab/scenes/a.py": "import pygame",
        },
        "game.lab.registry -> game.lab.scenes.a -> pygame",
    ),
    "lab_command_pygame": ({"game/lab/command.py": "import pygame"}, "game.lab.command -> pygame"),
    "lab_tools": ({"game/lab/share.py": "from tools.crosscheck.second_engine import x"}, "nothing imports tools but tests"),
    "tools_pygame": ({"tools/bench.py": "import pygame"}, "tools.bench -> pygame"),
    "tools_through_game": (
        {"tools/bench.py": "def f():\n    from game.app import play", "game/app.py": "import pygame"},
        "tools.bench -> game.app -> pygame",
    ),
}

RIGHT = {
    "physics": {"physics/polar.py": "import math\nfrom collections.abc import Sequence\nfrom physics.trig import x"},
    "batch": {"physics/batch.py": "import numba\nimport numpy as np\nfrom physics import step"},
    "screens": {"game/app.py": "import pygame\nimport numpy\nfrom game.rules import tick", "game/rules.py": "import random"},
    "main_deferred": {"game/__main__.py": "def f():\n    from game.app import play", "game/app.py": "import pygame"},
    "tools": {"tools/crosscheck/run.py": "import pymunk\nfrom tools import x\nfrom game.rules import y", "game/rules.py": ""},
    "second_opinion": {"game/commands.py": "def f():\n    from tools.crosscheck.overlay import opinions"},
    "second_engine": {"game/commands.py": "def f():\n    from tools.crosscheck.second_engine import Pymunk"},
    "lab_window": {
        "game/lab/window/x.py": "import pygame, pygame_gui",
        "game/lab/command.py": "def f():\n    from game.lab.window import x",
    },
    "lab_registry": {"game/lab/registry.py": "import importlib\nimportlib.import_module(name)", "game/lab/scenes/a.py": ""},
    "tests": {"tests/test_a.py": "import pygame, tools.bench, numba\nfrom tests import b\n__import__(name)"},
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_import_is_found_and_named(tmp_path, name):
    """Each rule catches what breaks it."""
    files, expected = WRONG[name]
    found = violations(tree(tmp_path, files))
    assert any(expected in line for line in found), found


@pytest.mark.parametrize("name", RIGHT)
def test_an_allowed_import_is_left_alone(tmp_path, name):
    """And nothing else."""
    assert violations(tree(tmp_path, RIGHT[name])) == []
