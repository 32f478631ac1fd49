"""Work shared by the workers of a Dask scheduler that runs already."""

import asyncio
import hashlib
import logging
import pickle
from collections import deque
from collections.abc import Callable, Generator, Iterator
from functools import cache
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from game import VERSION
from game.system.errors import BadInputError, EnvironmentMissingError
from game.system.wording import quoted
from tools.executor.lost import Lost, raised

Job = TypeVar("Job")
Result = TypeVar("Result")

PATIENCE = 5.0
"""Seconds to wait for the scheduler, and then for its first worker."""
_AHEAD = 4
"""Jobs for each of the cluster's threads that are with it at a time."""
_PACKAGES = ("physics", "game", "tools")


class _Answer(NamedTuple):
    """What a worker says of a job. version: its project's."""

    version: str
    result: Any


@cache
def project_version() -> str:
    """The project's version, and a hash of its code and its levels."""
    digest, root = hashlib.sha256(), Path(__file__).resolve().parents[2]
    for package in _PACKAGES:
        for path in sorted((root / package).rglob("*")):
            if path.suffix in {".py", ".toml"}:
                digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return f"{VERSION} ({digest.hexdigest()[:12]})"


def cluster_results(
    function: Callable[[Job], Result], jobs: Iterator[Job], address: str
) -> Generator[Result | Lost, None, None]:
    """`tools.executor.results` by the workers of the scheduler at an address, as tcp://host:port."""
    client, threads = _connected(address)
    waiting: deque[Any] = deque()
    try:
        for job in islice(jobs, _AHEAD * threads):
            waiting.append(client.submit(_answered, function, job, pure=False))
        while waiting:
            answer = _result(waiting.popleft())
            for job in islice(jobs, 1):
                waiting.append(client.submit(_answered, function, job, pure=False))
            yield answer
    finally:
        client.cancel(list(waiting), asynchronous=False, force=True)
        client.close(timeout=PATIENCE)


def _connected(address: str) -> tuple[Any, int]:
    """A client of the scheduler, and the number of its workers' threads."""
    try:
        from distributed import Client  # noqa: PLC0415  # an extra
    except ImportError as error:
        wanted = "python -m pip install 'polar-breakout[cluster]'"
        raise EnvironmentMissingError(f"--cluster needs Dask, which cannot be imported ({error}); {wanted}") from None
    for name in ("distributed", "distributed.client", "distributed.core"):
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what is wrong is said here
    _check_scheduler(address)
    client = Client(address, timeout=PATIENCE, set_as_default=False)
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
        _check_versions(client, address)
        return client, sum(client.nthreads().values())
    except TimeoutError:
        client.close(timeout=PATIENCE)
        raise EnvironmentMissingError(
            f"--cluster {quoted(address)}: the scheduler has no worker; start some with `dask worker {address}`"
        ) from None
    except BaseException:
        client.close(timeout=PATIENCE)
        raise


def _check_scheduler(address: str) -> None:
    """Refuse an address at which no scheduler answers. A client that finds none takes long to go away."""
    from distributed.core import connect  # noqa: PLC0415  # an extra

    async def identity() -> Any:
        """What the scheduler says of itself."""
        comm = await connect(address, timeout=PATIENCE)
        try:
            await comm.write({"op": "identity", "reply": True})
            return await comm.read()
        finally:
            comm.abort()

    try:
        answer = asyncio.run(asyncio.wait_for(identity(), PATIENCE))
    except ValueError as error:
        raise BadInputError(f"--cluster {quoted(address)}: expected tcp://HOST:PORT; {error}") from None
    except Exception:  # noqa: BLE001  # whatever may be at an address that is no scheduler
        answer = None
    if not isinstance(answer, dict) or answer.get("type") != "Scheduler":
        said = f"no Dask scheduler answers within {PATIENCE:g} s; start one with `dask scheduler`"
        raise EnvironmentMissingError(f"--cluster {quoted(address)}: {said}")


def _check_versions(client: Any, address: str) -> None:
    """Refuse a cluster one of whose workers has another version of the project, or none."""
    for worker, theirs in client.run(_version_said, on_error="return").items():
        if isinstance(theirs, BaseException):
            raise EnvironmentMissingError(f"--cluster {quoted(address)}: worker {worker} cannot import the project: {theirs}")
        _check_version(theirs, f"worker {worker}")


def _check_version(theirs: str, who: str) -> None:
    """EnvironmentMissingError, naming both, for another version than this one's."""
    if theirs != project_version():
        raise EnvironmentMissingError(f"{who} has version {theirs} of the project, this process {project_version()}")


def _version_said() -> str:
    """A worker's version."""
    return project_version()


def _answered(function: Callable[[Job], Any], job: Job) -> _Answer:
    """What a worker does. A worker that came later may have another version: it says so with every answer."""
    try:
        answer = function(job)
    except Exception as error:  # noqa: BLE001  # the job is lost, the others go on
        answer = raised(error)
        try:
            pickle.dumps(answer)
        except Exception:  # noqa: BLE001  # whatever it was that cannot be pickled
            answer = answer._replace(error=None)
    return _Answer(project_version(), answer)


def _result(future: Any) -> Any:
    """The result of a job, once it is there."""
    try:
        answer = future.result()
    except Exception as error:  # noqa: BLE001  # such as a job that has killed every worker it was given to
        return Lost(f"{type(error).__name__}: {str(error).splitlines()[0]}")
    _check_version(answer.version, "a worker")
    return answer.result
