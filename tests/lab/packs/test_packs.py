"""Scene packs: a file's scenes are added to the lab, and whatever is wrong with a file is one line."""

import re

import pytest

from game.lab import registry
from game.lab.packs.load import load_pack
from game.lab.registry import scene_named, scenes
from game.lab.session.session import fresh
from game.lab.session.share import parsed
from game.system.errors import BadInputError
from tests.support.command_line import polar
from tests.support.paths import ROOT

TOML = """
title = "Lecture 5"

[[scenes]]
name = "l5-missed"
shows = "case-2?ball=9.23,4.35"
title = "A near miss"
presets = { "touching" = "ball=9.4,3.9" }
"""

PYTHON = """
from game.lab.kit.cited_line import source_line
from game.lab.kit.parameters import Number
from game.lab.kit.picture import Disc, Role, one_step, in_steps
from game.lab.kit.scene import Claim, LabScene, ViewBox

TITLE = "Mine"

def picture(given):
    r = given.number("r")
    steps = (one_step("a ball", [Disc(0j, r, Role.BALL)]), one_step("its radius", [], [f"r = {1.0 / (r - 2.0):g}"]))
    return in_steps(steps, source_line("Collision detection", "r"))

SCENES = (
    LabScene(
        name="my-ball", title="A ball", idea="A ball.", functions=(), handles=(), view_box=ViewBox(0j, 3 + 3j), shows=picture,
        parameters=(Number("r", "r", "", 0.5, LARGEST, 1.0, 0.25),),
        check=lambda given: (Claim("r is above 0", given.number("r") > 0.0),),
    ),
)
"""


@pytest.fixture(autouse=True)
def no_packs(monkeypatch):
    """No pack outlives its test."""
    monkeypatch.setattr(registry, "_ADDED", {})


def test_a_toml_pack_has_scenes_with_other_values_and_words(tmp_path, capsys):
    """Its scenes come first, in a chapter of its title; the values of the line are the defaults, the other words stay."""
    path = tmp_path / "pack.toml"
    path.write_text(TOML)
    code, out, err = polar(capsys, "lab", "--scenes", str(path), "--list")
    assert (code, err) == (0, "")
    assert [line.split("  ")[0].strip() for line in out.splitlines()[1:3]] == ["-- Lecture 5", "l5-missed"]
    scene = scene_named("l5-missed")
    assert scenes()[0] is scene
    assert fresh(scene, None).given.point("ball") == 9.23 + 4.35j
    assert (scene.title, scene.idea) == ("A near miss", scene_named("case-2").idea)
    assert [preset.label for preset in scene.presets] == ["touching"]


def test_a_python_pack_has_scenes_of_its_own_and_a_failure_later_is_shown_in_place_of_the_picture(tmp_path):
    """A scene that divides by zero at a value that no check came to says so with the file's line number."""
    path = tmp_path / "pack.py"
    path.write_text(PYTHON.replace("LARGEST", "1.75"))
    load_pack(path)
    scene = scene_named("my-ball")
    given = fresh(scene, None).given
    assert scene.shows(given).formula == ("r = -1",)
    broken = scene.shows(given._replace(values={"r": 2.0}))
    assert re.fullmatch(rf"{path}:11: ZeroDivisionError: [^\n]+", broken.formula[0])


@pytest.mark.parametrize(
    ("name", "text", "problem"),
    [
        ("a.toml", "scenes = 3", "Expected `array`"),
        ("a.toml", "[[scenes", "not TOML; "),
        ("a.toml", TOML.replace("9.23,4.35", "99,0"), "scene l5-missed: lab: part 'ball=99,0' of the share line: 99 is not"),
        ("a.toml", TOML.replace("l5-missed", "case-2"), "there is already a scene case-2"),
        ("a.toml", TOML + 'speed = "fast"\n', "contains unknown field `speed`"),
        ("a.py", "SCENES = ()", "expected SCENES, a tuple of LabScene"),
        ("a.py", "x = (\n", "a.py:1: SyntaxError: "),
        ("a.py", "\n\nimport nowhere_at_all", "a.py:3: ModuleNotFoundError: No module named 'nowhere_at_all'"),
        ("a.py", PYTHON.replace("LARGEST", "1.75").replace("> 0.0)", "< 1.0)"), '"r is above 0" does not hold: my-ball?r=1'),
        ("a.py", PYTHON.replace("LARGEST", "3.0").replace("(r - 2.0)", "(r - 1.0)"), "a.py:11: ZeroDivisionError: "),
        ("a.txt", "", "expected a name that ends in .py or .toml"),
    ],
)  # fmt: skip
def test_a_pack_that_cannot_be_used_is_one_line(tmp_path, capsys, name, text, problem):
    """The line names the file, and its line or its scene; exit code 2, and no scene is added."""
    path = tmp_path / name
    path.write_text(text)
    code, out, err = polar(capsys, "lab", "--scenes", str(path), "--list")
    assert (code, out) == (2, "")
    assert re.fullmatch(r"polar-breakout: [^\n]+\n", err)
    assert problem in err
    assert name in err
    assert scenes()[0].name == "polar"


def test_a_pack_that_is_not_there_is_one_line(tmp_path):
    """Neither kind of file needs to be there for a message."""
    for name in ("none.toml", "none.py"):
        with pytest.raises(BadInputError, match=f"{name}: cannot read scene pack; No such file"):
            load_pack(tmp_path / name)


def test_the_examples_of_the_documentation_and_the_lesson_can_be_used(tmp_path):
    """The packs on the lab's page load as they stand there, so does the lesson's; every share line of the pages opens."""
    page = (ROOT / "docs" / "lab.md").read_text(encoding="utf-8").partition("## A scene pack")[2]
    for kind in ("toml", "python"):
        path = tmp_path / f"pack.{kind.replace('python', 'py')}"
        path.write_text(re.search(rf"```{kind}\n(.*?)```", page, re.DOTALL)[1], encoding="utf-8")
        load_pack(path)
    load_pack(ROOT / "docs" / "lesson.toml")
    names = {scene.name for scene in scenes()}
    assert {"l5-near-miss", "l5-position", "lesson-8-response"} <= names
    pages = [(ROOT / "docs" / name).read_text(encoding="utf-8") for name in ("teaching.md", "lab.md")]
    lines = re.findall(r'[`"]([a-z0-9-]+(?:\?[^`"\s]*)?)[`"]', "".join(pages))
    opened = [parsed(line) for line in lines if line.partition("?")[0] in names]
    assert len(opened) > 20
