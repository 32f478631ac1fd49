"""Games flown on a student's own functions, right, wrong and faulty: none of them ends the program."""

import sys

import pytest

from game.headless import autopilot_game
from game.lab.registry import scene_named, scenes
from game.lab.session.checks import after_drags, lines
from game.lab.yours.answers import AnswerVerdict, own_answers
from game.lab.yours.calls import asking_scenes, calls_of
from game.levels import classic
from game.replays.state_hash import state_hash
from game.student.own_physics import OwnPhysics
from game.student.program import Limits
from physics import source_mode
from tests.grade.wrong_files import RIGHT, WRONG_FILES
from tests.support.command_line import polar

posix = pytest.mark.skipif(sys.platform == "win32", reason="no such signals on Windows")
linux = pytest.mark.skipif(sys.platform != "linux", reason="the limit on memory needs Linux")


def flown(advance, ticks=800):
    """A game of the autopilot on level 4."""
    return autopilot_game(classic()[3:], 7, ticks, advance=advance)


@pytest.fixture(scope="module")
def asked():
    """What every scene of the lab asks, at its presets and after some drags."""
    calls = []
    for scene in [scene_named(name) for name in asking_scenes() if name in {scene.name for scene in scenes()}]:
        for given in [*lines(scene), *after_drags(scene, 20 if scene.name == "polar" else 3, 1)]:
            calls += calls_of(scene.name, given)
    return calls


def verdicts(file, asked):
    """Whose answers they are."""
    return {one.verdict for one in own_answers(file, asked)}


def test_the_right_file_flies_as_the_slides(own, asked):
    """The same score and bricks as the source mode, and no red answer in any scene of the lab."""
    file = own(RIGHT.read_text(encoding="utf-8"))
    game, slides = flown(OwnPhysics(file).advance, 2000), flown(source_mode.advance, 2000)
    assert (game.score, game.lives, game.arena.layers) == (slides.score, slides.lives, slides.arena.layers)
    assert game.score > 0
    assert AnswerVerdict.DIFFERS not in verdicts(file, asked)
    assert file.broken == ""


@pytest.mark.parametrize("wrong", WRONG_FILES, ids=lambda wrong: f"{wrong.name}: {wrong.wrong.strip()}")
def test_a_wrong_file_flies_and_is_red_in_the_lab(own, asked, wrong):
    """The game is played on to its end, and some scene shows the mistake."""
    file = own(wrong.text())
    assert flown(OwnPhysics(file).advance).tick == 800
    assert AnswerVerdict.DIFFERS in verdicts(file, asked)
    assert file.broken == ""


def test_one_function_alone_changes_the_game(own):
    """Also one that the slides' functions call, and ours calls in its place; a function not yet written changes nothing."""
    slides = state_hash(flown(OwnPhysics(own("x = 1")).advance))
    never = own("def min_difference(a, b):\n    raise NotImplementedError('later')")
    assert state_hash(flown(OwnPhysics(never).advance)) == slides
    assert never.own == frozenset()
    later = own("def min_difference(a, b):\n    if True:\n        raise NotImplementedError(str(a))")
    assert state_hash(flown(OwnPhysics(later).advance)) == slides
    assert later.own == {"min_difference"}
    half = own("def min_difference(a, b):\n    return abs(a - b) / 2")
    assert state_hash(flown(OwnPhysics(half).advance)) != slides


FAULTS = {
    "return 1 / 0": "line 3: ZeroDivisionError: division by zero",
    "return 'left'": "line 1: to_polar returned 'left'; expected a radius and an angle",
    "return float('nan'), 0.0": "line 1: to_polar returned (nan, 0.0); expected a radius and an angle",
    "return None": "line 1: to_polar returned None; expected a radius and an angle",
    "raise SystemExit": "line 3: SystemExit",
    "import os; os._exit(3)": "line 3: SystemExit: os._exit(3)",
    "return to_polar(p)": "line 3: RecursionError: ",
    "print('{\"result\": 3}' * 99, flush=True); return undefined": "line 3: NameError: name 'undefined' is not defined",
    "import os; os.write(4, b'hello\\n')": "mine.py: not an answer: hello",
}


@pytest.mark.parametrize("fault", FAULTS)
@posix
def test_a_fault_costs_one_line(own, fault):
    """It names the line; the slides' own functions fly on from that moment, as if they had flown all the time."""
    file = own(f"def to_polar(p):\n    # it fails\n    {fault}\n")
    game = flown(OwnPhysics(file).advance)
    assert file.broken.removeprefix("mine.py, ").startswith(FAULTS[fault])
    assert "\n" not in file.broken
    assert file.own == frozenset()
    assert state_hash(game) == state_hash(flown(source_mode.advance))


@linux
def test_memory_without_end_costs_one_line(own):
    """The operating system refuses it."""
    file = own("def to_polar(p):\n    x = [0]\n    while True: x = x * 2\n", Limits(600.0, 600.0, 256))
    assert flown(OwnPhysics(file).advance).tick == 800
    assert file.broken == "mine.py, line 3: MemoryError"


def test_a_loop_costs_one_line(own):
    """The child ends itself, and its trace names the line."""
    file = own("import time\ndef to_polar(p):\n    while True: time.sleep(9)\n", Limits(1.0, 600.0, 1024))
    assert flown(OwnPhysics(file).advance).tick == 800
    assert file.broken == "mine.py, line 3: no answer within 1 seconds"


def test_an_advance_of_ones_own(own):
    """It is asked every tick, with the student's own points; a hit that it reports takes a layer and is scored."""
    text = """
def make_point(x, y):
    return [x, y]

def advance(balls, rings, layers, dt, v_0):
    (p, v, r), = balls
    if layers[1][0]:
        return [(p, [-v[0], -v[1]])], [(0, 1, 0, (1.0, 0.0))]
    return [([p[0] + v[0] * dt, p[1] + v[1] * dt], v)], []
"""
    file = own(text)
    game = flown(OwnPhysics(file).advance)
    assert (file.broken, file.own) == ("", {"advance"})
    assert game.arena.layers[1][0] == 0
    assert game.score > 0
    file = own(text.replace("return [([p[0]", "return [], [([p[0]"))
    flown(OwnPhysics(file).advance)
    assert file.broken.startswith("mine.py, line 5: advance returned a tuple; expected a list of 1 pairs (p, v)")
    file = own(text.replace("v)], []", "[1e99, 0.0])], []"))
    flown(OwnPhysics(file).advance)
    assert file.broken == "mine.py: advance has put a ball beyond every measure"


def test_the_command(capsys, tmp_path):
    """Exit code 0 for functions that answer, 1 and the line for those that fail, after the result; 2 for bad options."""
    mine, options = tmp_path / "mine.py", ("--headless", "--autopilot", "--ticks", "300", "--with", tmp_path / "mine.py")
    assert polar(capsys, *options)[::2] == (2, f"polar-breakout: --with {mine}: no such file\n")
    mine.write_text("def on_left(a, b):\n    return 0 < a - b\n")
    code, out, err = polar(capsys, *options)
    assert (code, err) == (0, "")
    assert out.startswith("ticks=300 seed=1 physics=own ")
    mine.write_text("def on_left(a, b:\n    return 1\n")
    code, out, err = polar(capsys, *options)
    assert (code, out.count("\n")) == (1, 1)
    assert err.startswith("polar-breakout: mine.py, line 1: SyntaxError: '(' was never closed; ")
    for more in (("--physics", "swept"), ("--record", tmp_path / "game.polar")):
        code, out, err = polar(capsys, *options, *more)
        assert (code, out, err.count("\n")) == (2, "", 1)
