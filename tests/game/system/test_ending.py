"""Signals: what they do while a program loads, works, saves and ends."""

import os
import signal
import subprocess
import sys

import pytest

from tests.support.paths import ROOT

if sys.platform == "win32":
    pytest.skip("Windows has no such signals", allow_module_level=True)

BEGIN = """
import os, signal, sys, time, types
for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
    signal.signal(number, signal.SIG_DFL)
signal.signal(signal.SIGINT, signal.default_int_handler)
{before}
from game.system import ending
from game.system.start import prepare
prepare("program")
me = os.getpid()
"""
SIGNALS = {signal.SIGINT: "interrupted", signal.SIGTERM: "terminated", signal.SIGHUP: "hung up"}


def program(text, before=""):
    """A program that sends itself signals, run to its end."""
    code = BEGIN.format(before=before) + text
    return subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)


COMMAND = """
import typer
from game.system.command_line import run
app = typer.Typer(pretty_exceptions_enable=False)
@app.command()
def work():
{work}
sys.exit(run(app, "program", []))
"""


def command(work, before=""):
    """A program with one command."""
    return program(COMMAND.format(work="\n".join(f"    {line}" for line in work.strip().splitlines())), before)


@pytest.mark.parametrize(("number", "word"), SIGNALS.items())
def test_a_signal_while_libraries_load(number, word):
    """One line, 128 + the signal's number, no traceback."""
    done = program(f"os.kill(me, {int(number)})\nimport json, decimal, email.message\nprint('not reached')")
    assert (done.returncode, done.stdout, done.stderr) == (128 + number, "", f"program: {word}\n")


@pytest.mark.parametrize(("number", "word"), SIGNALS.items())
def test_a_signal_at_work(number, word):
    """What was printed before it is there, and one line after it."""
    done = command(f"print('begun')\nos.kill(me, {int(number)})\ntime.sleep(60)")
    assert (done.returncode, done.stdout, done.stderr) == (128 + number, "begun\n", f"program: {word}\n")


@pytest.mark.parametrize(("number", "word"), SIGNALS.items())
def test_a_signal_while_saving_waits(number, word):
    """The block comes to its end, also with another block inside; then the program ends as if the signal came then."""
    work = f"""
with ending.deferred():
    with ending.deferred():
        os.kill(me, {int(number)})
        print("saved", ending.pending())
    print("and closed")
print("not reached")
"""
    done = command(work)
    assert (done.returncode, done.stdout, done.stderr) == (128 + number, "saved True\nand closed\n", f"program: {word}\n")


@pytest.mark.parametrize(("number", "word"), SIGNALS.items())
def test_a_signal_inside_an_evaluated_text(number, word, tmp_path):
    """As where a named tuple is made: the exit code is the signal's own, not what Python makes of a KeyboardInterrupt there."""
    work = f"    eval('os.kill(me, {int(number)}) or time.sleep(60)')"
    (tmp_path / "victim.py").write_text(BEGIN.format(before="") + COMMAND.format(work=work), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "victim"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (128 + number, "", f"program: {word}\n")


def test_a_second_signal_does_not_tear_what_the_first_has_begun_to_save():
    """The clean-up of an interrupted command is a block like any other; the first signal names the exit code."""
    work = """
try:
    os.kill(me, signal.SIGTERM)
    time.sleep(60)
finally:
    with ending.deferred():
        os.kill(me, signal.SIGINT)
        print("kept")
"""
    done = command(work)
    assert (done.returncode, done.stdout, done.stderr) == (143, "kept\n", "program: terminated\n")


def test_a_block_that_does_not_end_is_ended_by_one_more_signal_later():
    """Not by three at once, as some systems send them."""
    work = """
now = 7.0
ending.time = types.SimpleNamespace(monotonic=lambda: now)
with ending.deferred():
    for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGHUP):
        os.kill(me, number)
    now += ending._PATIENCE
    os.kill(me, signal.SIGTERM)
    print("still here", flush=True)
    now += 0.1
    os.kill(me, signal.SIGTERM)
    time.sleep(60)
"""
    done = command(work)
    assert (done.returncode, done.stdout, done.stderr) == (129, "still here\n", "program: hung up\n")


def test_a_signal_after_the_end_says_nothing():
    """The result is printed; only the exit code speaks of the signal."""
    text = (
        COMMAND.format(work="    print('result')").replace("sys.exit(", "code = (")
        + "os.kill(me, signal.SIGTERM)\nsys.exit(code)"
    )
    done = program(text)
    assert (done.returncode, done.stdout, done.stderr) == (143, "result\n", "")


def test_a_signal_where_no_exception_can_go():
    """In a destructor Python would print a traceback and go on."""
    work = """
class Late:
    def __del__(self):
        os.kill(me, signal.SIGTERM)
        time.sleep(0.01)
Late()
print("not reached")
"""
    done = command(work)
    assert (done.returncode, done.stdout, done.stderr) == (143, "", "program: terminated\n")


@pytest.mark.parametrize(
    "rest", ["time.sleep(60)", "with ending.deferred():\n    while not ending.pending(): time.sleep(0.01)"]
)
def test_a_signal_whose_exception_is_lost_is_raised_again(rest):
    """Code that swallows every exception, as some libraries do while they are imported, does not keep the program alive."""
    work = f"""
ending._REMINDER = 0.1
for _ in range(3):
    try:
        os.kill(me, signal.SIGTERM) if _ == 0 else time.sleep(60)
    except BaseException:
        pass
{rest}
"""
    done = command(work)
    assert (done.returncode, done.stdout, done.stderr) == (143, "", "program: terminated\n")


def test_other_exceptions_in_a_destructor_are_still_told():
    """They are mistakes of the program."""
    done = command("class Late:\n    def __del__(self):\n        raise ValueError('a mistake')\nLate()")
    assert done.returncode == 0
    assert "a mistake" in done.stderr


def test_what_was_ignored_stays_ignored():
    """As under nohup."""
    done = command("os.kill(me, signal.SIGHUP)\nprint('alive')", "signal.signal(signal.SIGHUP, signal.SIG_IGN)")
    assert (done.returncode, done.stdout, done.stderr) == (0, "alive\n", "")


def test_children_do_not_see_what_a_terminal_sends():
    """A process that was started in such a block blocks SIGINT and SIGHUP; this one does not."""
    work = """
import subprocess
show = [sys.executable, "-c", "import signal; print(sorted(map(int, signal.pthread_sigmask(signal.SIG_BLOCK, []))))"]
with ending.interrupts_blocked():
    subprocess.run(show)
subprocess.run(show)
"""
    assert command(work).stdout == "[1, 2]\n[]\n"


@pytest.mark.parametrize(
    "module",
    ["game", "tools.fuzz", "tools.crosscheck", "tools.bench", "tools.robustness"]
    + [f"tools.measure.{name}" for name in ("frame", "lab", "memory", "startup", "tipping_gif")],
)
def test_every_command_is_made_ready_before_it_loads_anything(module):
    """When signals are first watched, none of the libraries that take time is there; and so for the console scripts' `main`."""
    code = f"""
import runpy, sys
from game.system import start
class Ready(BaseException): pass
def prepared(program):
    print(program, sorted({{"typer", "msgspec", "pygame", "rich", "numpy", "pymunk", "game.rules"}} & set(sys.modules)))
    raise Ready
start.prepare = prepared
sys.argv = ["x"]
try:
    runpy.run_module({module!r}, run_name="__main__", alter_sys=True)
except Ready:
    pass
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False)
    name = {"game": "polar-breakout", "tools.crosscheck": "polar-crosscheck"}.get(module, f"python -m {module}")
    assert done.stdout == f"{name} []\n", done.stderr
