"""The player's own functions in the lab: a pane more, red where it differs."""

import pytest

from game.lab.kit.picture import Arrow, PointMark, Role
from game.lab.kit.scene import picture_of, started
from game.lab.registry import chapters, scene_named
from game.lab.session.checks import lines
from game.lab.yours.answers import AnswerVerdict
from game.lab.yours.calls import asking_scenes, calls_of
from game.lab.yours.pane import with_yours
from game.student.engine_functions import EngineFunctions
from game.student.signatures import SIGNATURES, answer
from tests.game.student.conftest import own  # noqa: F401  # a fixture
from tests.grade.wrong_files import RIGHT
from tests.support.children import eventually
from tests.support.command_line import polar
from tests.support.windows.lab_desk import LabDesk

WRONG = RIGHT.read_text(encoding="utf-8").replace("return -n if abs(p) < r_p else n", "return n")


def test_every_scene_of_detection_and_response_asks():
    """Whatever scene shows one of the source's functions asks for an own one; what runs a whole engine does not."""
    shown = [
        scene.name
        for chapter, found in chapters().items()
        if chapter in {"angles", "broad phase", "narrow phase", "response"}
        for scene in found
        if set(scene.functions) & SIGNATURES.keys()
    ]
    assert set(shown) <= set(asking_scenes())
    assert len(shown) > 15


@pytest.mark.parametrize("name", [scene.name for scene in chapters()["response"]])
def test_the_call_is_the_scenes_own_bounce(name):
    """Ours, asked what an own function is asked, answers with an arrow that is in the scene's picture."""
    scene = scene_named(name)
    for given in lines(scene):
        arrows = [
            (mark.start, mark.vector)
            for pane in picture_of(scene, given, started(scene, given)).panes
            for mark in pane.marks
            if isinstance(mark, Arrow)
        ]
        for call in calls_of(name, given):
            vector = complex(*answer(EngineFunctions(), call.function, call.arguments)) * call.scale
            assert any([abs(call.start - start) < 1e-9 and abs(vector - there) < 1e-9 for start, there in arrows]), given


def test_a_wrong_answer_is_red(own):  # noqa: F811  # the fixture
    """Arrow and numbers; beside it ours. A right one is not; without a file, or without a question, there is no such pane."""
    scene = scene_named("case-1")
    given = lines(scene)[0]
    picture = picture_of(scene, given, None)
    pane = with_yours(picture, scene, given, own(WRONG)).panes[-1]
    assert pane.title == "yours: mine.py"
    assert pane.lines == (("narrow_phase_case_1 = (0.98, 0.21)", Role.SOURCE), ("ours: (-0.98, -0.21)", Role.PLAIN))
    assert {(mark.label, mark.role) for mark in pane.marks if isinstance(mark, Arrow)} == {
        ("n", Role.SOURCE),
        ("ours", Role.FAINT),
    }
    right = own(RIGHT.read_text(encoding="utf-8"))
    pane = with_yours(picture, scene, given, right).panes[-1]
    assert pane.lines == (("narrow_phase_case_1 = (-0.98, -0.21)", Role.GOOD),)
    assert with_yours(picture, scene, given, None) is picture
    assert with_yours(picture, scene_named("free-run"), given, right) is picture


def test_whatever_a_function_returns_is_shown(own):  # noqa: F811  # the fixture
    """In few letters, red; and no vector is drawn that is out of sight or none at all."""
    shown = {
        "10**400": "1" + "0" * 23,
        "(1e300, 10**400)": "[1e+300, 1000000000000000",
        "(1e300, 0)": "(1.0e+300, 0.00)",
        "float('nan')": "nan",
        "[True, False]": "[True, False]",
        "'left'": "left",
        "None": "None",
    }
    scene = scene_named("closest-point")
    given = lines(scene)[0]
    for result, words in shown.items():
        file = own(f"def closest_point_on_line(a, b, p):\n    return {result}\n")
        pane = with_yours(picture_of(scene, given, None), scene, given, file).panes[-1]
        assert pane.lines[0] == (f"closest_point_on_line = {words[:24]}", Role.SOURCE)
        assert [mark for mark in pane.marks if isinstance(mark, PointMark) and mark.label == "q"] == []


def test_the_window_shows_it(own, tmp_path):  # noqa: F811  # the fixture
    """Beside the panes of the scene; the picture is drawn anew when the file was saved."""
    desk = LabDesk("case-1")
    try:
        desk.shared.functions = file = own(WRONG)
        desk.screen._drawn = None
        desk.wait_once(0.1)

        def role():
            return desk.screen._picture().panes[-1].lines[0][1]

        assert (len(desk.screen._picture().panes), role()) == (2, Role.SOURCE)
        (tmp_path / "mine.py").write_text(f"# saved\n{RIGHT.read_text(encoding='utf-8')}", encoding="utf-8")
        file._next_look = 0.0
        eventually(lambda: desk.wait_once(0.01) or role() is Role.GOOD)
        assert desk.screen._notes()[-1] == "mine.py: read again"
    finally:
        desk.close()


def test_the_command(capsys, tmp_path):
    """`lab --headless --with` counts whose answers they are; exit code 1 and a line to open where one differs."""
    mine = tmp_path / "mine.py"
    for text, code in ((RIGHT.read_text(encoding="utf-8"), 0), (WRONG, 1)):
        mine.write_text(text, encoding="utf-8")
        found, out, err = polar(capsys, "lab", "case-1", "--headless", "--drags", "20", "--with", mine)
        assert (found, out.splitlines()[-1].split()[0]) == (code, "case-1")
        assert AnswerVerdict.OURS.value in out
    assert 'python -m game lab "case-1?ball=7.6,1.6' in err
