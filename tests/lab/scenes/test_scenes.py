"""Every scene of the lab: its claims hold wherever one drags it, and the registry finds it."""

import ast
import inspect
import os
import py_compile
import random
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pygame
import pytest

import physics
from game.lab import scenes as folder
from game.lab.kit.cited_line import code_line
from game.lab.kit.differences import DIFFERENCES
from game.lab.kit.handles import dragged
from game.lab.kit.parameters import Point, defaults
from game.lab.kit.picture import Toggle
from game.lab.kit.scene import Claim, EngineUse, LabScene, picture_of, started
from game.lab.registry import scenes
from game.lab.session.checks import after_drags, failures, lines, report
from game.lab.session.share import parsed
from tests.support.lab_scenes import counting_scene, state_at
from tools.crosscheck.second_engine import Pymunk

SCENES = pytest.mark.parametrize("scene", scenes(), ids=lambda scene: scene.name)


def test_every_file_of_a_scene_is_listed_under_its_own_name():
    """A file below `scenes/` that its chapter does not list would never be shown; every scene is called like its file."""
    files = sorted([path.stem.replace("_", "-") for path in Path(folder.__path__[0]).rglob("[!_]*.py")])
    assert sorted([scene.name for scene in scenes()]) == files


def cited_lines():
    """Every scene's cited lines at its defaults and its presets."""
    return [(scene.name, *picture_of(scene, one, started(scene, one)).cited) for scene in scenes() for one in lines(scene)]


PRINT_CITED_LINES = f"""
from game.lab.kit.scene import picture_of, started
from game.lab.registry import scenes
from game.lab.session.checks import lines
{inspect.getsource(cited_lines)}
print(repr(cited_lines()))
"""


def test_without_files_and_source_text_every_scene_is_shown_with_its_cited_line(tmp_path):
    """In a zip archive of byte code, as in a frozen program, there is no folder to list and no source to read.

    The byte code is that of `python -OO`, without asserts and docstrings. Only the lines' numbers are missing there.
    """
    root, archive = Path(physics.__file__).parent.parent, tmp_path / "game.zip"
    with zipfile.ZipFile(archive, "w") as zipped:
        for path in [path for package in ("game", "physics") for path in (root / package).rglob("*.py")]:
            inside = path.relative_to(root)
            zipped.write(
                py_compile.compile(str(path), str(tmp_path / "one.pyc"), str(inside), True, 2), inside.with_suffix(".pyc")
            )
    environment = {**os.environ, "PYTHONPATH": str(archive), "PYTHONIOENCODING": "utf-8"}
    command = [sys.executable, "-P", "-OO", "-c", PRINT_CITED_LINES]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, encoding="utf-8", check=False)
    assert done.stderr == ""
    without_numbers = [(name, re.sub(r"\.py:\d+ ", ".py ", where), text) for name, where, text in cited_lines()]
    assert ast.literal_eval(done.stdout) == without_numbers


def test_a_flight_into_the_left_notch_stays_on_its_axis_but_for_rounding():
    """The bricks beside the angle pi are mirror images but for rounding, since no float is pi."""
    shared = parsed("two-bricks?ball=0,0&v=-14,0&r=1.2&notch=6.5&half_width=1.5&dt=0.4")
    assert failures(shared.scene, shared.given) == ()


@SCENES
def test_the_claims_hold_at_the_defaults_and_the_presets(scene):
    """With and without a second engine every claim holds at the defaults and at the presets."""
    for engine in (Pymunk(), None):
        for given in lines(scene, engine):
            assert failures(scene, given) == ()


@pytest.mark.deep
@SCENES
def test_the_claims_hold_after_a_thousand_drags(scene):
    """After each of a thousand random drags every claim holds and every number of the picture is finite."""
    seed = 1 if os.environ.get("CI") else random.randrange(2**32)
    for given in after_drags(scene, 1000, seed):
        assert failures(scene, given) == (), f"seed {seed}"


@SCENES
def test_pymunk_may_be_asked_anywhere(scene):
    """With a second engine every claim holds after forty random drags; a scene's `engine_use` tells whether it uses one."""
    given, before = lines(scene, Pymunk())[0], lines(scene)[0]
    pictures = [picture_of(scene, one, started(scene, one)) for one in (given, before)]
    expected = EngineUse.ALWAYS if pictures[0].formula != pictures[1].formula else EngineUse.NONE
    assert scene.engine_use is (EngineUse.TOGGLE if Toggle.PYMUNK in pictures[0].toggles else expected)
    for given in after_drags(scene, 40, 2, Pymunk()):
        assert failures(scene, given) == ()


@SCENES
def test_a_claim_that_fails_is_reported(scene):
    """A false claim is reported at every setting, with the line that opens it."""
    lying = scene._replace(check=lambda given: (*scene.check(given), Claim("the moon is a cheese", holds=False)))
    found = report(lying, 5, 1)
    assert len(found.failures) == found.settings
    assert found.failures[0].fact == "the moon is a cheese"
    assert found.failures[0].line.startswith(scene.name)


@SCENES
def test_a_scene_says_what_it_is(scene):
    """The idea is a sentence; functions and rows exist; labels and names are unique; defaults are in range."""
    assert re.fullmatch(r"[A-Z].*\.", scene.idea)
    assert all([callable(getattr(physics, name)) for name in scene.functions])
    assert set(scene.rows) <= set(DIFFERENCES)
    assert len({preset.label for preset in scene.presets}) == len(scene.presets)
    names = [parameter.name for parameter in scene.parameters]
    assert len(set(names)) == len(names)
    for parameter in scene.parameters:
        parts = (parameter.default.real, parameter.default.imag if isinstance(parameter, Point) else parameter.low)
        assert all([parameter.low <= part <= parameter.high for part in parts])


def test_every_function_of_the_source_has_a_scene():
    """Each function named after the source is shown by a scene."""
    words = "normalize_angle min_difference on_left to_polar to_cartesian closest_point_on_line broad_phase narrow_phase_case_1"
    shown = {name for scene in scenes() for name in scene.functions}
    assert {*words.split(), "narrow_phase_case_2", "collision_response"} <= shown


def test_every_row_beyond_the_source_has_a_scene():
    """Each row of the table of differences is shown by a scene."""
    assert {row for scene in scenes() for row in scene.rows} == set(DIFFERENCES)


def test_the_rows_are_those_of_the_documentation():
    """As many as its table has, under the same numbers."""
    page = (Path(physics.__file__).parent.parent / "docs" / "algorithm.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (\d+) \|", page.partition("## Beyond the source")[2], re.MULTILINE)
    assert [int(row) for row in rows] == list(DIFFERENCES)


@SCENES
def test_every_handle_can_be_taken_hold_of_and_does_something(scene):
    """A drag of a handle changes a value."""
    given = defaults(scene.parameters)
    for handle in scene.handles:
        position = handle.position(given)
        elsewhere = dragged(scene.parameters, given, handle, position + (0.9 - 0.7j)).given
        assert elsewhere.values != given.values, handle.label


@SCENES
def test_a_handle_follows_the_hand(scene):
    """A dragged handle comes nearer to the pointer, unless its value is at a border or a step short."""
    chance = random.Random(3)
    for given in after_drags(scene, 300, 4):
        for handle in scene.handles:
            here = handle.position(given)
            wanted = here + complex(chance.random() - 0.5, chance.random() - 0.5)
            after, notes = dragged(scene.parameters, given, handle, wanted)
            assert notes or abs(handle.position(after) - wanted) <= abs(here - wanted) + 0.2, handle.label


@SCENES
def test_words_and_formula_fit_the_font(scene):
    """Every letter that a scene writes has a glyph in pygame's font."""
    pygame.font.init()
    font = pygame.font.Font(None, 40)
    missing = pygame.image.tobytes(font.render("\u2220", True, (255, 255, 255)), "RGBA")
    for given in lines(scene, Pymunk()):
        picture = picture_of(scene, given, started(scene, given))
        texts = [scene.title, scene.idea, picture.note, picture.cited.where, picture.cited.text, *picture.formula]
        texts += [text for one in scene.parameters for text in (one.label, one.meaning, getattr(one, "unit", ""))]
        texts += [preset.label for preset in scene.presets] + [pane.title for pane in picture.panes]
        texts += [getattr(mark, "label", "") for pane in picture.panes for mark in pane.marks]
        texts += [getattr(mark, "text", "") for pane in picture.panes for mark in pane.marks]
        for letter in sorted(set("".join(texts))):
            drawn = pygame.image.tobytes(font.render(letter, True, (255, 255, 255)), "RGBA")
            assert drawn != missing, f"{letter!r} has no glyph"


def test_a_cited_line_stands_where_it_says():
    """A cited line is in the file, at the number. A citation found in no line of the function, or in several, is an error."""
    found = code_line(physics.closest_point_on_line, "if along >= square:")
    file, number = re.fullmatch(r"(.+):(\d+) closest_point_on_line", found.where).groups()
    root = Path(physics.__file__).parent.parent
    assert (root / file).read_text(encoding="utf-8").splitlines()[int(number) - 1].strip() == found.text
    for text in ("no such line", "a"):
        with pytest.raises(ValueError, match="closest_point_on_line has"):
            code_line(physics.closest_point_on_line, text)


def test_a_scene_that_runs_is_a_function_of_its_tick():
    """The state at tick 7 is seven steps from the start."""
    scene = counting_scene()
    given = defaults(scene.parameters)
    assert state_at(scene, given, 7) == 7
    assert picture_of(scene, given, 7).note == "7"


def test_scenes_are_values():
    """A scene is a tuple of values and functions."""
    assert all([isinstance(scene, LabScene) for scene in scenes()])
    assert all([not inspect.isgeneratorfunction(scene.check) for scene in scenes()])
