"""Run tasks in this process, in local processes, or on the workers of a dask scheduler.

Several processes are dask.distributed workers, which restart after a death. The calling process claims tasks and
records results in the manifest; workers read the job's files.
"""

from __future__ import annotations

import asyncio
import contextlib
import importlib
import logging
import os
import tempfile
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol, TypeVar

from .. import __version__  # pyright: ignore[reportMissingImports]
from ..core.devices import DeviceLike, device_name, resolve_device
from ..core.errors import DeviceError, FileError, FilePath
from ..core.verbosity import LOGGER
from ..kernels.language.environment import THREADS, setting
from .manifest import DIED, MAX_ATTEMPTS, NAME, Manifest, worker_lock

POLL_SECONDS = 0.2  # [s] between queries for tasks that other runs may release
CONNECT_TIMEOUT = 10.0  # [s] for a connection to a scheduler
MAX_WITHOUT_WORKERS = 60.0  # [s]
CHECK_INTERVAL = 20.0  # [s] without a result, before a query whether the scheduler still has the task
_QUIET = ("client", "core", "scheduler", "comm", "batched", "nanny")  # loggers of distributed
_PRELOAD = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"  # Ctrl-C ends the process that started them
Result = TypeVar("Result")


class Book(Protocol):
    """Tasks that one run claims in a manifest."""

    def take(self) -> Any:
        """Claim a task. True if one may follow after running tasks, False if none is left."""
        ...

    def do(self, task: Any, device: str) -> Any: ...

    def record(self, task: Any, result: Any) -> None: ...

    def fail(self, task: Any, error: Exception) -> None: ...

    def quarantine(self, task: Any, reason: str) -> None:
        """Record that workers died repeatedly at a task."""
        ...


def run_tasks(
    manifest: Manifest,
    book_of: Callable[[str], Book],
    call: Callable[[Any, str], Any],
    notify: Callable[[], None],
    *,
    workers: int = 0,
    scheduler: str | None = None,
    security: Any = None,
    device: DeviceLike = "cpu",
) -> None:
    """Run all tasks that this run can claim. FileError or DeviceError if workers cannot be started. `book_of` returns
    the book of the named run, `call` is imported by workers and gets a task and a device, `tell` is called after each
    task. Without `workers` and `scheduler` (an address, with `security`) tasks run in this process. With "cuda" each
    process gets its own GPU."""
    path, device = manifest.folder / NAME, "cpu" if device is None else str(device_name(device))
    try:
        with contextlib.ExitStack() as stack:
            computes = scheduler is None and not workers
            book = book_of(stack.enter_context(worker_lock(manifest.folder, computes=computes)))
            if scheduler is not None:
                client = stack.enter_context(_remote_client(path, scheduler, security))
            elif workers:
                client = stack.enter_context(_local_client(path, workers))
            else:
                _run_here(manifest, book, stack.enter_context(reserved_device(device)), notify)
                return
            _run_on(client, manifest, book, call, device, notify)
    except BaseException:
        manifest.release_claims(is_death=False)
        raise


class Processes:
    """Local worker processes that map functions. Count 0 uses this process. `path` is the output file, for errors."""

    def __init__(self, count: int, path: FilePath):
        self.count, self._path, self._client = count, path, None
        self._stack = contextlib.ExitStack()

    def __enter__(self) -> Processes:
        if self.count:
            self._client = self._stack.enter_context(_local_client(self._path, self.count))
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def map(self, call: Callable[..., Result], tasks: Iterable[tuple[Any, ...]]) -> Iterator[Result]:
        """Yield `call(*task)` in task order, about one per process ahead. FileError after repeated deaths."""
        client = self._client
        if client is None:
            yield from (call(*task) for task in tasks)
            return
        waiting: deque[Any] = deque()
        for task in tasks:
            waiting.append((client.submit(call, *task, pure=False), call, task))
            if len(waiting) > self.count:
                yield self._result(client, *waiting.popleft())
        while waiting:
            yield self._result(client, *waiting.popleft())

    def _result(self, client: Any, future: Any, call: Callable[..., Result], task: tuple[Any, ...]) -> Result:
        while True:
            try:
                return _result_of(client, future)
            except LostTaskError:
                future = client.submit(call, *task, pure=False)
            except importlib.import_module("distributed").KilledWorker as error:
                raise FileError(self._path, DIED, remedy="Use fewer workers") from error


class LostTaskError(RuntimeError):
    """The scheduler no longer has a task that was submitted: dask may lose one when a worker process dies."""


def _result_of(client: Any, future: Any) -> Any:
    """Wait for the result of a future, or raise its error. Raises LostTaskError if none can come."""
    while True:
        try:
            return future.result(timeout=CHECK_INTERVAL)
        except TimeoutError:
            if future.status == "error":  # of the task itself
                raise
            if _is_lost(client, future):
                raise LostTaskError(future.key) from None


def _is_lost(client: Any, future: Any) -> bool:
    """True if the scheduler does not have the task. False if it runs no functions, or cannot be reached."""
    if future.status not in ("pending", "finished"):
        return False
    key = future.key
    try:  # a lambda is sent by value: the scheduler need not have pointloom
        return not client.run_on_scheduler(lambda dask_scheduler: key in dask_scheduler.tasks)
    except Exception:  # its errors come as they were raised there
        return False


def _run_here(manifest: Manifest, book: Book, device: str, notify: Callable[[], None]) -> None:
    while (task := book.take()) is not False:
        if task is True:
            if not manifest.release_claims():
                time.sleep(POLL_SECONDS)
            continue
        try:
            result = book.do(task, device)
        except Exception as error:  # user code in steps
            book.fail(task, error)
        else:
            book.record(task, result)
        notify()


def _run_on(
    client: Any, manifest: Manifest, book: Book, call: Callable[..., Any], device: str, notify: Callable[[], None]
) -> None:
    """Run tasks on a client's workers, one at a time each: dask counts a death against all tasks of a worker."""
    path, running, ready = manifest.folder / NAME, {}, set[str]()
    seen = last_result = time.monotonic()
    while True:
        workers = _workers(client, path)
        ready |= _prepared(client, path, workers - ready, device)
        task: Any = None
        while len(running) < len(workers) and not isinstance(task := book.take(), bool):
            running[client.submit(_call, call, task, device, pure=False)] = task
        if not running and task is False:
            return
        seen = time.monotonic() if workers else seen
        if time.monotonic() - seen > MAX_WITHOUT_WORKERS:
            reason = f"no worker was connected to {client.scheduler.address} for a minute"
            raise FileError(path, reason, remedy="Start workers: dask worker ADDRESS --nthreads 1 --memory-limit 0")
        ended = _ended(running)
        if not ended and time.monotonic() - last_result > CHECK_INTERVAL:
            ended = [future for future in running if _is_lost(client, future)]
        last_result = time.monotonic() if ended else last_result
        for future in ended:
            task_of = running.pop(future)
            try:
                _record(client, path, book, task_of, future)
            except LostTaskError:
                running[client.submit(_call, call, task_of, device, pure=False)] = task_of
            else:
                notify()
        if task is True:
            manifest.release_claims()


def _ended(running: dict[Any, Any]) -> list[Any]:
    """Futures that end within POLL_SECONDS seconds."""
    if not running:
        time.sleep(POLL_SECONDS)
        return []
    try:
        wait = importlib.import_module("distributed").wait
        return list(wait([*running], timeout=POLL_SECONDS, return_when="FIRST_COMPLETED").done)
    except TimeoutError:
        return []


def _record(client: Any, path: Path, book: Book, task: Any, future: Any) -> None:
    """Record the end of a task. Raises LostTaskError if it must be submitted again."""
    if future.cancelled() or future.status == "lost":
        reason = "the connection to the scheduler was lost, or it dropped a task"
        raise FileError(path, reason, remedy="Run it again to resume")
    try:
        result = _result_of(client, future)
    except LostTaskError:
        raise
    except importlib.import_module("distributed").KilledWorker:
        book.quarantine(task, DIED)
    except Exception as error:  # user code in steps
        book.fail(task, error)
    else:
        book.record(task, result)


@contextlib.contextmanager
def _local_client(path: FilePath, count: int) -> Iterator[Any]:
    """Client of new local processes that end with this one."""
    distributed, config = _imported(path, "distributed"), _imported(path, "dask.config")
    threads = setting(THREADS) or str(max(1, (os.cpu_count() or 1) // count))
    options: dict[str, Any] = {"n_workers": count, "threads_per_worker": 1, "memory_limit": 0, "host": "127.0.0.1"}
    options |= {"dashboard_address": "127.0.0.1:0", "scheduler_kwargs": {"allowed_failures": MAX_ATTEMPTS - 1}}
    options |= {"env": {THREADS: threads, "RAYON_NUM_THREADS": threads}, "preload": _PRELOAD}
    # By default distributed sets variables in the environment of this process.
    environment = {"distributed.nanny.pre-spawn-environ": {"PYTHONHASHSEED": "random"}}
    with contextlib.ExitStack() as stack:
        stack.enter_context(_quiet())
        stack.enter_context(config.set(environment))
        try:
            cluster = stack.enter_context(distributed.LocalCluster(**options, silence_logs=logging.CRITICAL))
        except RuntimeError as error:
            remedy = 'In a script, call it below `if __name__ == "__main__":`'
            reason = f"the worker processes did not start: {error}".rstrip(".")
            raise FileError(path, reason, remedy=remedy) from error
        LOGGER.debug("dashboard of the workers: %s", cluster.dashboard_link)
        client = distributed.Client(cluster, set_as_default=False, direct_to_workers=True)
        stack.enter_context(client)
        stack.enter_context(client.as_current())
        yield client


@contextlib.contextmanager
def _remote_client(path: Path, address: str, security: Any) -> Iterator[Any]:
    distributed = _imported(path, "distributed")
    with contextlib.ExitStack() as stack:
        stack.enter_context(_quiet())
        try:
            with ThreadPoolExecutor(1) as pool:  # an unsuccessful Client waits again when released
                pool.submit(lambda: asyncio.run(_touch(distributed, address, security))).result()
            client = distributed.Client(address, timeout=CONNECT_TIMEOUT, set_as_default=False, security=security)
        except (OSError, ValueError, TimeoutError, RuntimeError, TypeError) as error:
            reason = f"no scheduler at {address}: {error or type(error).__name__}"
            raise FileError(path, reason, remedy="Start `dask scheduler` and pass its address") from error
        stack.callback(_close, client)
        stack.enter_context(client.as_current())
        yield client


def _imported(path: FilePath, module: str) -> Any:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        reason = "several worker processes need the package distributed"
        raise FileError(path, reason, remedy='pip install "pointloom[tiling]"') from error


def _close(client: Any) -> None:
    with contextlib.suppress(TimeoutError, OSError):  # the scheduler is gone
        client.close(timeout=2)


async def _touch(distributed: Any, address: str, security: Any) -> None:
    """Test the connection to the scheduler."""
    arguments = (security or distributed.Security()).get_connection_args("client")
    (await distributed.comm.connect(address, timeout=CONNECT_TIMEOUT, **arguments)).abort()


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Suppress distributed's log output for errors that are handled here, such as closed connections."""
    loggers = [logging.getLogger(f"distributed.{name}") for name in _QUIET]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)


def _workers(client: Any, path: Path) -> set[str]:
    try:
        if client.status == "running":
            return {*client.nthreads()}
    except (OSError, TimeoutError):
        pass
    raise FileError(
        path, f"the connection to the scheduler at {client.scheduler.address} was lost", remedy="Run it again to resume"
    )


def _prepared(client: Any, path: Path, workers: set[str], device: str) -> set[str]:
    """Reserve devices of new workers and check their versions. Returns those that answered."""
    versions = client.run(_prepare, device, workers=[*workers], on_error="return") if workers else {}
    versions = {address: version for address, version in versions.items() if not isinstance(version, OSError)}
    for address, version in versions.items():
        if isinstance(version, DeviceError):
            raise version
        if isinstance(version, BaseException):
            raise FileError(path, f"the worker at {address} cannot load pointloom: {version}")
        if version != __version__:
            reason = f"expected pointloom {__version__} on the worker at {address}, got {version}"
            raise FileError(path, reason, remedy="Install one version on all machines")
    return {*versions}


_ONE = threading.Lock()  # a worker may have several threads, but has one device
_device_locks = contextlib.ExitStack()
_devices: dict[str, str] = {}  # devices reserved by this process, by request


def _device(requested: str) -> str:
    if requested not in _devices:
        _devices[requested] = _device_locks.enter_context(reserved_device(requested))
    return _devices[requested]


def _prepare(device: str) -> str:
    """In a worker: reserve its device. Returns its version of pointloom."""
    with _ONE:
        _device(device)
    return __version__


def _call(call: Callable[..., Any], task: Any, device: str) -> Any:
    with _ONE:
        return call(task, _device(device))


try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

LOCKS = "pointloom-gpus"  # in the machine's temporary folder


@contextmanager
def reserved_device(device: str) -> Iterator[str]:
    """Reserve the CPU (no lock) or a free GPU: "cpu", "cuda" or "cuda:1". Yields Warp's device name."""
    first = resolve_device(device)
    if not first.is_cuda:
        yield device
        return
    import warp as wp

    gpus = wp.get_cuda_devices() if device == "cuda" else [first]
    for gpu in gpus:
        lock = _lock(gpu.uuid)
        if lock is not None:
            break
    else:
        raise DeviceError(f"device: all of {len(gpus)} GPUs are in use by other workers or runs. Use fewer workers")
    try:
        yield gpu.alias
    finally:
        os.close(lock)


def _lock(uuid: str) -> int | None:
    """Descriptor of a GPU's lock, or None if another process has it."""
    folder = Path(tempfile.gettempdir()) / LOCKS
    path = folder / uuid
    try:
        if not folder.is_dir():
            folder.mkdir(exist_ok=True)
            folder.chmod(0o1777)  # shared by all users
        try:
            lock = os.open(path, os.O_RDONLY)  # opened read-only, since it may belong to another user
        except FileNotFoundError:
            lock = os.open(path, os.O_RDONLY | os.O_CREAT, 0o644)
    except OSError as error:
        raise DeviceError(f"device: {path}: the GPU cannot be locked: {error.strerror or error}") from error
    if fcntl is None:
        return lock
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(lock)
        return None
    return lock
