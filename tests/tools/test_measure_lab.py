"""The benchmark of the lab's scenes reads the same scenes as the window and the tests."""

import re

from game.lab.registry import scenes
from game.system.command_line import run
from tests.lab.scenes.test_scenes import counting_scene
from tools.measure.lab import app, scene_cost


def test_every_scene_is_timed(capsys):
    """One row for each."""
    assert run(app, "x", ["--rounds", "1"]) == 0
    out = capsys.readouterr().out
    for scene in scenes():
        assert re.search(rf"{scene.name} +│", out)


def test_a_scene_that_runs_has_a_cost_a_tick():
    """One that stands still has none."""
    assert scene_cost(counting_scene(), 3).tick is not None
    assert scene_cost(counting_scene()._replace(shows=lambda _: None), 3).tick is None
