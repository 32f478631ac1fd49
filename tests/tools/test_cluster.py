"""Work on a Dask cluster: a real scheduler with two workers on this machine, one of which is killed in mid-run."""

import json
import signal
import socket
import sys

import pytest

from game.levels import chosen
from game.rules import SOURCE_RULES
from game.system.command_line import run
from game.system.errors import BadInputError, EnvironmentMissingError
from tests.support.children import eventually
from tests.support.paths import ROOT
from tools.executor import cluster, results
from tools.fuzz.commands import app
from tools.sweep.plan import Axes, grid
from tools.sweep.play import played

pytestmark = pytest.mark.deep

distributed = pytest.importorskip("distributed")

JOBS = grid(Axes(chosen("First Wall")[:1], ["220/5"], [0.9], [], [1.0]), 24, SOURCE_RULES, 500).jobs


@pytest.fixture
def scheduler(children, tmp_path):
    """The address of a scheduler, and its two workers."""
    file, options = tmp_path / "scheduler.json", {"cwd": ROOT, "stderr": -3, "stdout": -3}
    started = ["scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(file)]
    children.start([sys.executable, "-m", "dask", *started], **options)
    worker = ["worker", "--scheduler-file", str(file), "--no-dashboard", "--no-nanny", "--nthreads", "1"]
    eventually(file.is_file)
    workers = [
        children.start([sys.executable, "-m", "dask", *worker, "--local-directory", str(tmp_path)], **options) for _ in range(2)
    ]
    return json.loads(file.read_text())["address"], workers


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL to send")
def test_a_cluster_gives_what_one_process_gives_also_with_a_worker_killed(scheduler, monkeypatch):
    """The same results in the same order; what the dead worker had is done again. Another version is refused, naming both."""
    address, workers = scheduler
    answers = results(played, JOBS, address)
    found = [next(answers)]
    with distributed.Client(address, set_as_default=False) as client:
        client.wait_for_workers(2)
    workers[0].send_signal(signal.SIGKILL)
    found += answers
    assert found == list(results(played, JOBS))
    monkeypatch.setattr(cluster, "project_version", lambda: "0.0.9 (abc)")
    with pytest.raises(
        EnvironmentMissingError, match=r"worker tcp://.* has version 0\.\d.* of the project, this process 0\.0\.9"
    ):
        list(results(played, JOBS, address))


def test_where_no_scheduler_answers_the_exit_code_is_3(monkeypatch, capsys):
    """Nobody listens; or somebody who never answers. The waiting is bounded."""
    monkeypatch.setattr(cluster, "PATIENCE", 0.2)
    with socket.socket() as silent:
        silent.bind(("127.0.0.1", 0))
        silent.listen()
        for port in (1, silent.getsockname()[1]):
            code = run(app, "fuzz", ["--cluster", f"tcp://127.0.0.1:{port}"])
            assert code == 3
            assert "no Dask scheduler answers within 0.2 s" in capsys.readouterr().err


def test_what_is_no_address_is_bad_input():
    """The expected form is named."""
    with pytest.raises(BadInputError, match=r"--cluster post:nine: expected tcp://HOST:PORT"):
        list(results(played, JOBS, "post:nine"))
