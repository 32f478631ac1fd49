"""A file of own functions is read again when it is saved; what cannot be used leaves the last good state."""

import pygame
import pytest

from game.screens.play.screen import PlayScreen
from game.student import program
from game.student.answering import answers_to
from game.student.functions_file import FunctionsFile
from game.student.own_physics import OwnPhysics
from game.system.errors import EnvironmentMissingError
from tests.game.student.conftest import PATIENT
from tests.support.children import eventually
from tests.support.windows.dummy_window import FRAME, Desk, shared

GOOD, BETTER, BROKEN = (f"def on_left(a, b){rest}" for rest in (":\n    return True", ":\n    return False\nx = 1", "\n"))


def test_a_saved_file_is_read_again(tmp_path):
    """Within a second of the clock; a broken version is reported and leaves the one before; a good one takes its place."""
    path, clock = tmp_path / "mine.py", [0.0]
    path.write_text(GOOD)
    with FunctionsFile(path, PATIENT, clock=lambda: clock[0]) as file:

        def saved(text):
            path.write_text(text)
            assert file.refresh() == ""  # the second is not yet over
            clock[0] += 1.0
            told = []
            eventually(lambda: bool(told.append(file.refresh()) or told[-1]))
            return told[-1]

        def answer():
            return answers_to(file, [("on_left", [1.0, 2.0])])[0].result

        assert (answer(), file.note) == (True, "Yours, from mine.py: on_left; the rest is the slides'")
        assert saved(BROKEN) == "mine.py, line 1: SyntaxError"
        assert (answer(), file.note) == (True, "mine.py, line 1: SyntaxError: expected ':'; the version before goes on")
        assert saved(BETTER) == "mine.py: read again"
        assert (answer(), file.problem) == (False, "")
        assert saved(f"{GOOD} / 0") == "mine.py: read again"
        assert (
            file.ask("bounces", [[[5.0, 0.0, 1.0, 0.0, 9.0]], [[5.0, 1.0, 0.1, 1, 0.5, 0.0, 0.0]] * 2, [[1], [1]], 1.0]) is None
        )
        assert (file.refresh(), file.own) == ("mine.py, line 2: ZeroDivisionError", frozenset())
        assert file.note.endswith("; the slides' own functions answer until it is saved again")
        path.unlink()
        clock[0] += 1.0
        assert file.refresh() == ""
        assert saved(GOOD) == "mine.py: read again"
        assert answer() is True
        assert (file.problem, file.broken) == ("", "mine.py, line 1: SyntaxError: expected ':'")


def test_without_a_python_to_run_it(tmp_path, monkeypatch):
    """In a zip archive there is no file that a child process could be started with: it is said what to do."""
    (tmp_path / "mine.py").write_text(GOOD)
    monkeypatch.setattr(program, "_HOST", tmp_path / "archive.zip" / "python_host.py")
    with pytest.raises(EnvironmentMissingError, match="needs Python and this package unpacked"):
        FunctionsFile(tmp_path / "mine.py")


def test_the_window_says_so(own):
    """A note stands below the game all the time, news for a moment; a fault pauses nothing."""
    state = shared(autopilot=True)
    state.physics = OwnPhysics(own("def to_polar(p):\n    return p.angle\n"))
    desk = Desk(state, PlayScreen(state, state.catalogue))
    try:
        desk.wait(60 * FRAME)
        assert state.toast is None
        desk.wait(120 * FRAME)
        assert state.toast.text == "mine.py, line 2: AttributeError"
        assert state.physics.note.startswith("mine.py, line 2: AttributeError: 'complex' object has no")
        tick = desk.screen._ticked.game.tick
        desk.wait(10 * FRAME)
        assert desk.screen._ticked.game.tick > tick
        assert pygame.display.get_init()
    finally:
        desk.close()
