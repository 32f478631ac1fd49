"""Who may import whom: the contracts in pyproject.toml hold, and each of them is shown to catch what breaks it.

What no contract can say is here: how little of the standard library the physics needs, and who may import pygame at all once
a window is wanted (tests/game/system/test_command_line.py and tests/lab/test_command.py look at what was imported).
"""

import re
import shutil
import subprocess
import sys
import tomllib
from itertools import pairwise

import grimp
import pytest

from tests.support.paths import ROOT

CONFIGURATION = ROOT / "pyproject.toml"
CONTRACTS = tomllib.loads(CONFIGURATION.read_text(encoding="utf-8"))["tool"]["importlinter"]["contracts"]
PURE_STDLIB = {"__future__", "collections", "dataclasses", "enum", "functools", "itertools", "math", "typing"}
LINT = [sys.executable, "-c", "from importlinter.cli import lint_imports; raise SystemExit(lint_imports(cache_dir=None))"]
WRONG = {
    "Nothing imports the tests": {
        "physics/polar.py": "import tests.support.strategies",
        "game/levels/reading.py": "def f():\n    from tests import support",
    },
    "The physics knows neither the game nor the tools": {"physics/vectors.py": "def f():\n    from game import VERSION"},
    "The physics is plain Python: arrays and compiled code are the batch's alone": {
        "physics/trig.py": "import numpy",
        "physics/sweep/band.py": "def f():\n    import numba",
    },
    "The batch is for tools and other programs: neither the physics nor the game imports it": {
        "physics/step.py": "import physics.batch",
        "game/rules/speed.py": "def f():\n    from physics.batch import Batch",
    },
    "The game runs on the hand-written physics: a second engine reaches it through its command line alone": {
        "game/loop/app.py": "def f():\n    from tools import bench",
        "game/commands.py": "from tools.crosscheck import run",
        "game/loop/fixed_step.py": "import numba",
        "game/second_opinion.py": "import pymunk",
    },
    "What plays without a window needs no pygame, neither directly nor through others": {
        "game/system/files.py": "import pygame",
        "game/autopilot/source_pilot.py": "def f():\n    import game.overlay.hud",
        "game/lab/kit/marks.py": "import game.loop.app",
        "tools/bench.py": "import pygame.draw",
    },
    "What runs in a browser needs the standard library and msgspec alone": {
        "game/picture/view.py": "import numpy",
        "game/web/client/keys.py": "def f():\n    import game.overlay.hud",
    },
    "The drawing knows nothing of what draws with it": {"game/drawing/camera.py": "def f():\n    import game.screens.title"},
    "The flat and the solid view know nothing of each other": {
        "game/drawing/flat/ring.py": "import game.drawing.solid.faces",
    },
    "The tools that draw are commands: nothing imports them": {"tools/measure/lab.py": "import tools.measure.frame"},
    "The packages around them need no pygame either": {"game/__init__.py": "import pygame"},
}


def lint(folder):
    """Exit code and words of import-linter on the packages in a folder."""
    done = subprocess.run(LINT, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    return done.returncode, " ".join(done.stdout.split())


def test_the_contracts_hold():
    """Over all files there are."""
    code, out = lint(ROOT)
    assert code == 0, out


@pytest.fixture(scope="module")
def broken(tmp_path_factory):
    """What import-linter says of a copy of the packages into which every wrong import was written."""
    folder = tmp_path_factory.mktemp("broken")
    for package in ("game", "physics", "tools"):
        shutil.copytree(ROOT / package, folder / package, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(CONFIGURATION, folder)
    for files in WRONG.values():
        for name, text in files.items():
            path = folder / name
            path.write_text(f"{path.read_text(encoding='utf-8')}\n{text}\n", encoding="utf-8")
    code, out = lint(folder)
    assert code == 1, out
    return out


@pytest.mark.parametrize("name", [contract["name"] for contract in CONTRACTS])
def test_a_wrong_import_breaks_its_contract_and_is_named(broken, name):
    """Every contract is broken, and names each module that breaks it."""
    sections = re.split(r" -{4,} ", broken.partition("Broken contracts")[2])  # each ends with the next one's heading
    said = next(after for before, after in pairwise(sections) if before.endswith(name))
    for file in WRONG[name]:
        module = file.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
        assert f"{module} -> " in said, said


def strangers(graph):
    """What the modules of the physics, all but the batch, import of others, but for the little that they may."""
    modules = {module for module in graph.modules if not module.startswith("physics.batch")}
    imported = {name for module in modules for name in graph.find_modules_directly_imported_by(module)}
    return {name for name in imported if name.partition(".")[0] not in {"physics", *PURE_STDLIB}}


def test_the_physics_needs_almost_nothing():
    """A few modules of the standard library, and itself; not even a generator of random numbers."""
    graph = grimp.build_graph("physics", include_external_packages=True, cache_dir=None)
    assert {"physics.polar", "physics.step"} <= graph.modules
    assert strangers(graph) == set()
    for name in ("random", "cmath", "numpy"):
        graph.add_module(name, is_squashed=True)
        graph.add_import(importer="physics.step", imported=name)
    assert strangers(graph) == {"random", "cmath", "numpy"}


def test_no_import_is_hidden_in_a_call():
    """Ruff refuses `import_module`, and nobody calls what import statements call."""
    files = [file for package in ("game", "physics", "tools") for file in (ROOT / package).rglob("*.py")]
    assert len(files) > 200
    assert [file for file in files if "__import__" in file.read_text(encoding="utf-8")] == []
