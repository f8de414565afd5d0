"""The runner of a job of tiles over dask.distributed.

This process claims tasks and settles them; workers see the folder's files and nothing of the manifest but the plan, so
that its locks are needed on one machine only. Paths and numbers go through the scheduler, points never do.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from pathlib import Path
from typing import Any

from .. import __version__  # pyright: ignore[reportMissingImports]
from ..core.errors import FileError
from ..files.foreign import import_for
from .borders import Joined
from .buckets import REMOTE, Filled
from .gpus import Gpu, environment_of, held_gpus
from .manifest import NAME
from .plan import Plan, plan_alone
from .tasks import Found, Task, Taskbook, do_task
from .work_tile import Outcome

LOOK = 0.5  # [s]
AHEAD = 2  # tasks a worker that are on their way
PATIENCE = 10.0  # [s] for a scheduler
MOST_LONELY = 60.0  # [s] without any worker
MOST_VAIN = 3  # deaths a process, in a row without one task done
# A worker whose runner was killed ends: at once where it had found the scheduler, else after half a minute.
_OPTIONS = (
    *("--host", "127.0.0.1", "--nthreads", "1", "--no-nanny", "--no-dashboard"),
    *("--memory-limit", "0", "--death-timeout", "30"),
)


def run_on_cluster(
    folder: Path,
    book: Taskbook,
    tell: Callable[[], None],
    where: int | str,
    *,
    security: Any = None,
    device: str = "cpu",
    gpus: Sequence[Gpu] = (),
    functions: tuple[str, ...] = (),
) -> None:
    """Work the tasks of a book off on a cluster.

    Args:
        folder: Of the job, which all workers see under this path.
        book: Claims and settles them.
        tell: Called after each.
        where: Processes of a cluster of this machine, or the address of a scheduler.
        security: distributed's, for a scheduler's certificates; None takes dask's own configuration.
        device: That workers use.
        gpus: Those of this machine's processes, one each.
        functions: Names of the functions that the caller passed, which workers import.

    Raises:
        FileError: No such scheduler, it went away, or its workers are of another version or die before they do
            anything.
    """
    distributed = import_for(folder / NAME, "distributed", "scale")
    flying: dict[Any, Task] = {}
    place = str(folder.absolute())
    with _quiet(), _client(distributed, folder, where, security, gpus) as (client, crew):
        lonely = time.monotonic()
        checked: set[str] = set()
        while True:
            workers = set(_workers(client, folder, where))
            if workers - checked:
                checked |= _check_versions(client, folder, workers - checked)
            task: Task | bool = True
            while len(flying) < AHEAD * len(workers) and isinstance(task := book.take(), Task):
                flying[client.submit(_do, place, task, device, functions, pure=False)] = task
            if not flying and task is False:
                return
            lonely = time.monotonic() if workers else lonely
            if time.monotonic() - lonely > MOST_LONELY:
                remedy = "Start some: dask worker ADDRESS --nthreads 1 --memory-limit 0"
                raise FileError(folder / NAME, f"there was no worker at {client.scheduler.address} for a minute",
                                remedy=remedy)  # fmt: skip
            for future in [future for future in flying if future.done()] or _waited(distributed, flying):
                _settle(distributed, folder, book, flying.pop(future), future)
                crew.vain = 0
                tell()
            crew.mend(folder)


def _waited(distributed: Any, flying: dict[Any, Task]) -> list[Any]:
    """Those of the tasks that end within a while."""
    if not flying:
        time.sleep(LOOK)
        return []
    try:
        return list(distributed.wait([*flying], timeout=LOOK, return_when="FIRST_COMPLETED").done)
    except TimeoutError:
        return []


def _settle(distributed: Any, folder: Path, book: Taskbook, task: Task, future: Any) -> None:
    if future.cancelled() or future.status == "lost":
        reason = "the scheduler has gone, or it dropped a task"
        raise FileError(folder / NAME, reason, remedy="Run it again, it goes on")
    try:
        found, seconds = future.result()
    except distributed.KilledWorker as error:
        book.fail(task, error, state="aside")
    except Exception as error:  # of steps, which may be a user's
        book.fail(task, error)
    else:
        # as its class is here
        kinds = {"sources": Filled, "tiles": Outcome, "joins": Joined}
        assert isinstance(found, kinds[task.table])
        book.settle(task, found, seconds)


class _Crew:
    """Worker processes of this machine; one that dies is replaced.

    They are started by commands: a nanny of distributed loads the caller's script once more in each.

    Attributes:
        vain: How many died since something was done.
    """

    def __init__(self, address: str, count: int, gpus: Sequence[Gpu]):
        self._address, self._count, self._gpus, self.vain = address, count, gpus, 0
        self._places: dict[int, subprocess.Popen[bytes]] = {}

    def mend(self, folder: Path) -> None:
        """Start what is not there."""
        for place in range(self._count):
            worker = self._places.get(place)
            if worker is not None and worker.poll() is None:
                continue
            self.vain += worker is not None
            if self.vain > MOST_VAIN * self._count:
                reason = f"{self.vain} workers died without doing anything"
                raise FileError(folder / NAME, reason, remedy="Run it with workers=0 to see why")
            gpu = self._gpus[place : place + 1]
            self._places[place] = subprocess.Popen(
                [sys.executable, "-P", "-m", "distributed.cli.dask_worker", self._address, *_OPTIONS],
                env=environment_of(self._count, gpu) | {"DASK_LOGGING__DISTRIBUTED": "critical"},
                stdin=subprocess.DEVNULL,
                process_group=0,
                pass_fds=[one.lock for one in gpu],
            )

    def end(self) -> None:
        """End all, however deep they are in a kernel."""
        for worker in self._places.values():
            worker.kill()
        for worker in self._places.values():
            worker.wait()


@contextlib.contextmanager
def _client(
    distributed: Any, folder: Path, where: int | str, security: Any, gpus: Sequence[Gpu]
) -> Iterator[tuple[Any, _Crew]]:
    with contextlib.ExitStack() as held:
        if isinstance(where, int):
            config = import_for(folder / NAME, "dask.config", "scale")
            held.enter_context(config.set({"distributed.scheduler.allowed-failures": 2}))
            told = {"host": "127.0.0.1", "dashboard_address": "127.0.0.1:0"}
            address = held.enter_context(distributed.LocalCluster(n_workers=0, **told)).scheduler_address
        else:
            address = where
        try:
            with ThreadPoolExecutor(1) as pool:  # a Client that finds none is waited for again when it is released
                pool.submit(lambda: asyncio.run(_touch(distributed, address, security))).result()
            client = distributed.Client(address, timeout=PATIENCE, set_as_default=False, security=security)
        except (OSError, ValueError, TimeoutError, RuntimeError, TypeError) as error:
            reason = f"there is no scheduler at {address}: {error or type(error).__name__}"
            raise FileError(folder / NAME, reason, remedy="Start `dask scheduler` and give its address") from error
        held.callback(_close, client)
        held.enter_context(client.as_current())
        crew = _Crew(address, where if isinstance(where, int) else 0, gpus)
        held.callback(crew.end)
        yield client, crew


def _close(client: Any) -> None:
    with contextlib.suppress(TimeoutError, OSError):  # of a scheduler that has gone
        client.close(timeout=2)


async def _touch(distributed: Any, address: str, security: Any) -> None:
    """Open a connection to the scheduler, and close it."""
    arguments = (security or distributed.Security()).get_connection_args("client")
    (await distributed.comm.connect(address, timeout=PATIENCE, **arguments)).abort()


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Have distributed not print what is an error here, or none, such as a connection that ends."""
    loggers = [logging.getLogger(f"distributed.{name}") for name in ("client", "core", "scheduler", "comm", "batched")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


def _workers(client: Any, folder: Path, where: int | str) -> list[str]:
    try:
        if client.status == "running":
            return [*client.nthreads()]
    except (OSError, TimeoutError):
        pass
    reason = f"the scheduler at {'this machine' if isinstance(where, int) else where} has gone"
    raise FileError(folder / NAME, reason, remedy="Run it again, it goes on")


def _check_versions(client: Any, folder: Path, workers: set[str]) -> set[str]:
    """Hold that workers have this version; those that said so, as others may have gone meanwhile."""
    told = client.run(_version, workers=[*workers], on_error="return")
    told = {address: version for address, version in told.items() if not isinstance(version, OSError)}
    for address, version in told.items():
        if isinstance(version, BaseException):
            raise FileError(folder / NAME, f"the worker at {address} cannot load pointloom: {version}")
        if version != __version__:
            reason = f"the worker at {address} has pointloom {version}, this is {__version__}"
            raise FileError(folder / NAME, reason, remedy="Install one version on all machines")
    return {*told}


def _version() -> str:
    return __version__


_ONE = threading.Lock()  # a worker may have several threads, and has one device
_held = contextlib.ExitStack()
_devices: dict[str, str] = {}  # those that this process holds, by what was asked for


def _do(folder: str, task: Task, device: str, functions: tuple[str, ...]) -> tuple[Found, float]:
    """A task on a worker of the cluster."""
    with _ONE:
        if device not in _devices:
            gpus = _held.enter_context(held_gpus(device, 1))
            _devices[device] = gpus[0].alias if gpus else device
        plan = _plan(folder, (Path(folder) / NAME).stat().st_ino, functions)
        plan.device = _devices[device]
        return do_task(plan, Path(folder), task, REMOTE + uuid.uuid4().hex)


@lru_cache(maxsize=4)
def _plan(folder: str, inode: int, functions: tuple[str, ...]) -> Plan:
    return plan_alone(Path(folder), functions)
