"""How the command ends when it is stopped, or when nobody takes its output: one line, the right exit code, no process left."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.children import GIVE_UP, eventually
from tests.support.paths import ROOT

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="looks at /proc and /dev/full")
COMMAND = (sys.executable, "-m", "tools.crosscheck")
SHORT = ("--games", "1", "--level", "38", "--ticks", "600")


@pytest.fixture
def crosscheck(children):
    """Starts the command; ended with the test, whatever happens."""

    def start(*arguments, through=(), **options):
        return children.start([*through, *COMMAND, *arguments], cwd=ROOT, stderr=subprocess.PIPE, text=True, **options)

    return start


def children_of(process):
    """The processes that a process has started and that live."""
    try:
        return [int(word) for word in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
    except FileNotFoundError:
        return []


def gone(pid):
    """Whether a process has ended: it is not there, or only its exit code is."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except FileNotFoundError:
        return True


def working(process):
    """The worker processes that have loaded the harness and are at work."""
    return [pid for pid in children_of(process) if "chipmunk" in Path(f"/proc/{pid}/maps").read_text()]


def test_sigterm_ends_the_workers_at_once(crosscheck):
    """In the middle of long games: exit code 143, one line, and no worker is left."""
    process = crosscheck("--workers", "2", "--ticks", "200000", stdout=subprocess.DEVNULL)
    eventually(lambda: len(working(process)) == 2)
    workers = children_of(process)
    process.terminate()
    _, err = process.communicate(timeout=GIVE_UP)
    assert (process.returncode, err) == (128 + signal.SIGTERM, "polar-crosscheck: terminated\n")
    eventually(lambda: all(gone(pid) for pid in workers))


def test_ctrl_c_in_a_terminal_is_answered_once(crosscheck):
    """A terminal sends it to the workers, too, also while they load: one line, what was checked, and no worker is left."""
    process = crosscheck("--workers", "2", "--ticks", "200000", stdout=subprocess.PIPE)
    eventually(lambda: len(children_of(process)) >= 2)  # one of them tracks resources
    workers = children_of(process)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=GIVE_UP)
    assert (process.returncode, err) == (128 + signal.SIGINT, "polar-crosscheck: interrupted\n")
    assert "PARTIAL (0 of " in out
    eventually(lambda: all(gone(pid) for pid in workers))


def test_a_working_directory_that_is_gone_is_one_line(tmp_path: Path):
    """Worker processes could not start in it."""
    code = f"import os; os.rmdir({str(tmp_path)!r}); from tools.crosscheck.__main__ import main; main()"
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", code, *SHORT]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (3, "", 1)
    assert done.stderr.startswith("polar-crosscheck: no working directory")


def test_workers_end_without_their_parent(crosscheck):
    """A parent that is killed cannot end them: they notice, and say nothing."""
    process = crosscheck("--workers", "2", "--ticks", "3000", stdout=subprocess.DEVNULL)
    eventually(lambda: len(working(process)) == 2)
    workers = children_of(process)
    process.kill()
    eventually(lambda: all(gone(pid) for pid in workers))
    assert process.stderr.read() == ""


def test_a_full_output_is_one_line(crosscheck):
    """What was checked is lost, and the exit code says that the machine could not take it."""
    with Path("/dev/full").open("w") as full:
        process = crosscheck(*SHORT, stdout=full)
    _, err = process.communicate(timeout=GIVE_UP)
    assert (process.returncode, err) == (
        3,
        "polar-crosscheck: cannot write output; No space left on device\n",
    )


def test_a_closed_output_changes_no_exit_code(crosscheck):
    """There is no standard output at all: nobody wants to read."""
    process = crosscheck(*SHORT, through=("/bin/sh", "-c", 'exec "$@" >&-', "sh"))
    _, err = process.communicate(timeout=GIVE_UP)
    assert (process.returncode, err) == (0, "")


@pytest.mark.parametrize(("more", "code"), [((), 0), (("--sabotage", "weak-mirror"), 1)])
def test_a_reader_that_has_gone_away_changes_no_exit_code(crosscheck, more, code):
    """As in a pipe to `head`: nothing is said, and the exit code is that of the check."""
    reader, writer = os.pipe()
    os.close(reader)
    process = crosscheck(*SHORT, *more, stdout=writer)
    os.close(writer)
    _, err = process.communicate(timeout=GIVE_UP)
    assert (process.returncode, err) == (code, "")
