"""The runner of a job of tiles over dask.distributed.

This process claims tasks and settles them; workers see the folder's files and nothing of the manifest but the plan, so
that its locks are needed on one machine only. Paths and numbers go through the scheduler, points never do.
"""

from __future__ import annotations

import contextlib
import os
import time
import uuid
from collections.abc import Callable, Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

from .. import __version__  # pyright: ignore[reportMissingImports]
from ..core.errors import FileError
from ..files.foreign import import_for
from .buckets import Filled
from .manifest import NAME
from .plan import Plan, plan_alone
from .tasks import Task, Taskbook, do_task
from .work_tile import Outcome

LOOK = 0.5  # [s]
AHEAD = 2  # tasks a worker that are on their way
PATIENCE = 10.0  # [s] for a scheduler
MOST_LONELY = 60.0  # [s] without any worker


def run_on_cluster(folder: Path, book: Taskbook, tell: Callable[[], None], dask: int, scheduler: str | None) -> None:
    """Work the tasks of a book off on a cluster.

    Args:
        folder: Of the job, which all workers see under this path.
        book: Claims and settles them.
        tell: Called after each.
        dask: Processes of a cluster of this machine, where no scheduler is given.
        scheduler: Address of one.

    Raises:
        FileError: No such scheduler, it went away, or its workers are of another version.
    """
    distributed = import_for(folder / NAME, "distributed", "scale")
    flying: dict[Any, Task] = {}
    with _client(distributed, folder, dask, scheduler) as client:
        lonely = time.monotonic()
        checked: set[str] = set()
        while True:
            crew = set(_workers(client, folder, scheduler))
            if crew - checked:
                _check_versions(client, folder, crew - checked)
                checked |= crew
            task: Task | bool = True
            while len(flying) < AHEAD * len(crew) and isinstance(task := book.take(), Task):
                flying[client.submit(_do, str(folder), task, pure=False)] = task
            if not flying and task is False:
                return
            lonely = time.monotonic() if crew else lonely
            if time.monotonic() - lonely > MOST_LONELY:
                raise FileError(folder / NAME, f"there was no worker at {client.scheduler.address} for a minute")
            for future in [future for future in flying if future.done()] or _waited(distributed, flying):
                _settle(distributed, book, flying.pop(future), future)
                tell()


def _waited(distributed: Any, flying: dict[Any, Task]) -> list[Any]:
    """Those of the tasks that end within a while."""
    if not flying:
        time.sleep(LOOK)
        return []
    try:
        return list(distributed.wait([*flying], timeout=LOOK, return_when="FIRST_COMPLETED").done)
    except TimeoutError:
        return []


def _settle(distributed: Any, book: Taskbook, task: Task, future: Any) -> None:
    if future.cancelled() or future.status == "lost":
        raise FileError(book.owner, "the scheduler has gone, or it dropped a task", remedy="Run it again, it goes on")
    try:
        found, seconds = future.result()
    except distributed.KilledWorker as error:
        book.fail(task, error, state="aside")
    except Exception as error:  # of steps, which may be a user's
        book.fail(task, error)
    else:
        # as its class is here
        kind = Filled if task.table == "sources" else Outcome
        assert isinstance(found, kind)
        book.settle(task, found, seconds)


@contextlib.contextmanager
def _client(distributed: Any, folder: Path, count: int, scheduler: str | None) -> Iterator[Any]:
    if scheduler is None:
        threads = os.environ.get("POINTLOOM_CPU_THREADS") or str(max(1, (os.cpu_count() or 1) // count))
        config = import_for(folder / NAME, "dask.config", "scale")
        told: dict[str, Any] = {
            "env": {"POINTLOOM_CPU_THREADS": threads},
            "memory_limit": 0,
            "dashboard_address": "127.0.0.1:0",
        }
        with (
            config.set({"distributed.scheduler.allowed-failures": 2}),
            distributed.LocalCluster(count, threads_per_worker=1, host="127.0.0.1", **told) as cluster,
            distributed.Client(cluster) as client,
        ):
            yield client
        return
    try:
        client = distributed.Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TimeoutError, RuntimeError) as error:
        reason = f"there is no scheduler at {scheduler}: {error or type(error).__name__}"
        raise FileError(folder / NAME, reason, remedy="Start `dask scheduler` and give its address") from error
    with client, client.as_current():
        yield client


def _workers(client: Any, folder: Path, scheduler: str | None) -> list[str]:
    if client.status != "running":
        where = scheduler or "this machine"
        raise FileError(folder / NAME, f"the scheduler at {where} has gone", remedy="Run it again, it goes on")
    return [*client.scheduler_info(n_workers=-1)["workers"]]


def _check_versions(client: Any, folder: Path, workers: set[str]) -> None:
    try:
        told = client.run(_version, workers=[*workers])
    except Exception as error:  # a worker without pointloom, or one that has just gone
        raise FileError(folder / NAME, f"a worker of the cluster cannot load pointloom: {error}") from error
    other = {address: version for address, version in told.items() if version != __version__}
    if other:
        address, version = next(iter(other.items()))
        reason = f"the worker at {address} has pointloom {version}, this is {__version__}"
        raise FileError(folder / NAME, reason, remedy="Install one version on all machines")


def _version() -> str:
    return __version__


def _do(folder: str, task: Task) -> tuple[Filled | Outcome, float]:
    """A task on a worker of the cluster."""
    return do_task(_plan(folder, (Path(folder) / NAME).stat().st_ino), Path(folder), task, uuid.uuid4().hex)


@lru_cache(maxsize=4)
def _plan(folder: str, inode: int) -> Plan:
    return plan_alone(Path(folder))
