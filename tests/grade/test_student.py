"""A student's program that loops, crashes, prints garbage or eats memory: it costs the questions that it fails, and no more."""

import contextlib
import os
import queue
import signal
import sys
from pathlib import Path

import pytest

from game.student import program as student_module
from game.student.program import Limits, next_line
from tests.grade.conftest import PATIENT
from tests.support.children import eventually
from tools.grade.grading import MOST_ENDINGS, grade
from tools.grade.scheme import Scheme

posix = pytest.mark.skipif(sys.platform == "win32", reason="no process groups on Windows")
linux = pytest.mark.skipif(sys.platform != "linux", reason="the limit on memory needs Linux")

RIGHT = """
def subtract_angles(a, b):
    return (a - b) % 6.283185307179586

"""


def with_fault(fault):
    """A file whose min_difference does something else where a is 1.5, and is right elsewhere."""
    rest = "    d = subtract_angles(a, b)\n    return min(d, 6.283185307179586 - d)\n"
    return f"{RIGHT}def min_difference(a, b):\n    if a == 1.5:\n        {fault}\n{rest}"


def chosen(published):
    """Some vectors; those of min_difference include the one with a = 1.5, once."""
    return [vector for vector in published if vector.function in {"min_difference", "subtract_angles"} and vector.number <= 40]


def one_lost(student, published):
    """The problem of the one question that failed; all the others were answered rightly."""
    found = grade(student, chosen(published), Scheme())
    checked = [one for function in found.functions for one in function.checked]
    wrong = [one for one in checked if not one.right]
    assert len(checked) == 80
    assert [one.vector.arguments[0] for one in wrong] == [1.5]
    return wrong[0].reply


def announced(marker):
    """Waits for an answer without a clock: gives up once the program has said, by a file, that it will never answer."""

    def wait(lines, _):
        found = []

        def over():
            try:
                found.append(lines.get_nowait())
            except queue.Empty:
                return marker.exists()
            return True

        eventually(over)
        if not found:
            marker.unlink()
        return found[0] if found else None

    return wait


def test_an_endless_loop(students, published, tmp_path):
    """It is ended, and the next question finds a fresh program."""
    marker = tmp_path / "looping"
    text = with_fault(f"open({str(marker)!r}, 'w').close()\n        while True: pass")
    reply = one_lost(students(text, PATIENT, announced(marker)), published)
    assert (reply.problem, reply.ended) == ("no answer within 600 seconds", True)


def test_the_line_that_hangs_is_named(students):
    """The program ends itself when its time is over, and leaves a trace."""
    text = "import time\n\ndef on_left(a, b):\n    while True:\n        time.sleep(9)\n"
    reply = students(text, Limits(answer=1.0, start=600.0)).ask("on_left", [1.0, 2.0])
    assert (reply.problem, reply.ended) == ("line 5: no answer within 1 seconds", True)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("import posix; posix._exit(7)", "the program ended (exit code 7)"),
        pytest.param(
            "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)", "line 7: the program ended (SIGSEGV)", marks=posix
        ),
        ("import posix, sys; sys.stderr.write('so long\\n'); posix._exit(1)", "the program ended (exit code 1): so long"),
        ("import os; os.write(4, b'hello\\n')", "not an answer: hello"),
        ("import os; [os.write(4, b'x' * 60000) for _ in range(40)]", "not an answer: " + "x" * 80 + "..."),
        ("import os; [os.write(4, b'yes\\n') for _ in range(10**9)]", "not an answer: yes"),
        ("import os; os.write(4, b'[1]\\n')", "not an answer: [1]"),
        ("import os; os.write(4, b'{\"answer\": 1}\\n')", 'not an answer: {"answer": 1}'),
        ("import os; os.write(4, b'\\xff\\x00\\x1b[2J\\n')", "not an answer: \N{REPLACEMENT CHARACTER}??[2J"),
    ],
)
@posix
def test_a_crash_and_garbage(students, published, fault, words):
    """The program is started again; the report quotes what it did, in one printable line. 4 is the stream of the answers."""
    reply = one_lost(students(with_fault(fault)), published)
    assert (reply.problem, reply.ended) == (words, True)


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("return 1 / 0", "line 7: ZeroDivisionError: division by zero"),
        ("return min_difference(a, b)", "line 7: RecursionError: "),
        ("raise SystemExit(3)", "line 7: SystemExit: 3"),
        ("import os; os._exit(7)", "line 7: SystemExit: os._exit(7)"),
        ("return object()", "TypeError: the result is a object"),
        ("return input()", "line 7: EOFError: EOF when reading a line"),
    ],
)
def test_an_error_names_the_students_line(students, published, fault, words):
    """The program goes on: nothing had to be ended."""
    reply = one_lost(students(with_fault(fault)), published)
    assert reply.problem.startswith(words)
    assert not reply.ended


@pytest.mark.parametrize(
    "fault", ["return float('nan')", "return float('inf')", "return 'three'", "return [0.1]", "return None", "return True"]
)
def test_a_result_of_the_wrong_kind_is_wrong(students, published, fault):
    """It is an answer, if not a right one."""
    assert one_lost(students(with_fault(fault)), published).problem is None


def test_the_students_code_finds_its_own_modules(students, published, tmp_path):
    """Those beside the file, whatever they are called; and none of the grading's."""
    (tmp_path / "report.py").write_text("TURN = 6.283185307179586")
    text = with_fault("import scheme").replace("6.283185307179586", "report.TURN")
    assert one_lost(students(f"import report\n{text}"), published).problem.endswith("No module named 'scheme'")


def test_what_the_students_code_prints_is_no_answer(students, published):
    """A line printed for every call changes nothing."""
    text = with_fault("return 9").replace("    d = sub", "    print('d is', a - b)\n    d = sub")
    assert one_lost(students(text), published).result == 9


@linux
def test_memory_without_end(students, published):
    """The operating system refuses it beyond the limit; Python says so by an error."""
    reply = one_lost(students(with_fault("x = [0]\n        while True: x = x * 2"), PATIENT._replace(memory=256)), published)
    assert reply.problem == "line 8: MemoryError"


@posix
def test_a_function_that_always_ends_the_program_is_given_up(students, published):
    """After some endings the other questions of that function are lost; the next function is asked."""
    text = f"{RIGHT}def min_difference(a, b):\n    import posix; posix._exit(1)\n"
    found = {function.name: function for function in grade(students(text), chosen(published), Scheme()).functions}
    problems = [checked.reply.problem for checked in found["min_difference"].checked]
    assert [problem.startswith("not asked") for problem in problems] == [False] * MOST_ENDINGS + [True] * (40 - MOST_ENDINGS)
    assert found["subtract_angles"].right


@posix
def test_what_the_program_has_started_ends_with_it(students, tmp_path):
    """Its whole process group is ended."""
    child = tmp_path / "child"
    start = f"import subprocess; p = subprocess.Popen(['sleep', '1000']); open({str(child)!r}, 'w').write(str(p.pid))"
    student = students(f"{start}\ndef on_left(a, b):\n    return True\n")
    assert student.ask("on_left", [1.0, 2.0]).result is True
    number = int(child.read_text())
    student.close()

    def ended():
        try:
            os.kill(number, 0)
        except ProcessLookupError:
            return True
        stat = Path(f"/proc/{number}/stat")
        return stat.exists() and stat.read_text().split()[2] == "Z"  # ended, and not yet waited for by its new parent

    try:
        eventually(ended)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.kill(number, signal.SIGKILL)


@posix
def test_ctrl_c_ends_the_students_program(children, tmp_path):
    """The grading is interrupted while the program loops: exit code 130, and the loop is ended."""
    marker = tmp_path / "pid"
    mine = tmp_path / "mine.py"
    mine.write_text(f"import os\nwith open({str(marker)!r}, 'w') as file: file.write(f'{{os.getpid()}} ')\nwhile True: pass\n")
    grading = children.start([sys.executable, "-m", "tools.grade", str(mine), "--start-limit", "3600"])
    eventually(lambda: marker.exists() and marker.read_text().endswith(" "))
    grading.send_signal(signal.SIGINT)
    assert grading.wait() == 130
    number = int(marker.read_text())
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)


def test_the_clock_is_the_default():
    """A wait ends with the next line, or without one when the time is over."""
    lines = queue.SimpleQueue()
    lines.put(b"first")
    assert next_line(lines, 600.0) == b"first"
    assert next_line(lines, 0.0) is None
    assert student_module.Student([], PATIENT)._wait is next_line
