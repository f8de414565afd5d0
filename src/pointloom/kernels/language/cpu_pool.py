"""Thread pool for CPU launches: each thread processes chunks until none is left.

The distributing code is a Warp kernel (cpu_pool.h). Python threads only enter it, and no chunk waits for the GIL. A
worker polls for some microseconds, then sleeps on a semaphore. A launch wakes two workers, which wake the next ones. A
pool runs one launch at a time: take the lock. Tested on Linux. On macOS and Windows (untested), a pool has one thread
unless POINTLOOM_CPU_THREADS or `set_thread_count` sets more.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import struct
import sys
import threading
import warnings
from functools import partial
from pathlib import Path
from typing import Any

from . import cpu_code
from .environment import MAX_THREADS, THREADS, setting
from .pool_code import CLOSED_FLAG, LINE_BYTES, PoolCode, PoolMemory, WorkerMemory, pool_code

CHUNKS_A_THREAD = 16  # so that one slow chunk, or a busy core, does not prolong a launch much
MAX_POLLS = 1000  # for a chunk before a worker sleeps: 10 to 50 us, longer than the host needs between launches
STACK_BYTES = 8 << 20  # of a worker; macOS gives 512 kB, and kernels with large vectors need a part of it
# Of a thread that launches: machine code of Warp has frames of up to 261 KiB (256 KiB of shared memory). The rest is
# for Python and the compiler: 384 KiB for all were enough in a trial.
MIN_STACK_BYTES = 512 << 10


def _functions_of_system() -> tuple[list[Any], Any]:
    """System functions to wait, wake, yield, create a semaphore. Waits get two extra arguments (macOS, Windows)."""
    if sys.platform == "win32":
        system = ctypes.WinDLL("kernel32")  # type: ignore[attr-defined]
        make = system.CreateSemaphoreW
        make.restype, make.argtypes = ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_long, ctypes.c_long, ctypes.c_void_p]
        return [system.WaitForSingleObject, system.ReleaseSemaphore, system.SwitchToThread], lambda: make(
            None, 0, 2**30, None
        )
    system = ctypes.CDLL(None)
    if sys.platform == "darwin":  # where POSIX has no unnamed semaphores
        make = system.dispatch_semaphore_create
        make.restype, make.argtypes = ctypes.c_void_p, [ctypes.c_long]
        return [system.dispatch_semaphore_wait, system.dispatch_semaphore_signal, system.sched_yield], lambda: make(0)

    def make_posix() -> int:
        semaphore = ctypes.create_string_buffer(64)  # a sem_t has 32 bytes
        if system.sem_init(semaphore, 0, 0):
            raise OSError("the system gives no semaphore")
        _semaphores.append(semaphore)
        return ctypes.addressof(semaphore)

    return [system.sem_wait, system.sem_post, system.sched_yield], make_posix


_semaphores: list[Any] = []  # semaphores, kept while a worker may wait for one

_checked = threading.local()  # has `stack_bytes` on threads whose stack is large enough


def check_stack() -> None:
    """Raise RuntimeError if the stack of this thread is too small for kernels: a launch would end the process."""
    if hasattr(_checked, "stack_bytes"):
        return
    size = _stack_bytes()
    if size < MIN_STACK_BYTES:
        is_main = threading.current_thread() is threading.main_thread()
        remedy = "raise `ulimit -s`" if is_main else f"call threading.stack_size({STACK_BYTES}) before it is started"
        raise RuntimeError(
            f"this thread has a stack of {size >> 10} KiB, and kernels need {MIN_STACK_BYTES >> 10} KiB: {remedy}"
        )
    _checked.stack_bytes = size


def _stack_bytes() -> int:
    """Size of this thread's stack, STACK_BYTES if unknown."""
    size, attributes = ctypes.c_size_t(STACK_BYTES), ctypes.create_string_buffer(128)  # pthread_attr_t has 56 bytes
    if sys.platform == "linux":
        system = ctypes.CDLL(None)
        system.pthread_self.restype = ctypes.c_void_p
        if not system.pthread_getattr_np(ctypes.c_void_p(system.pthread_self()), attributes):
            system.pthread_attr_getstacksize(attributes, ctypes.byref(size))
            system.pthread_attr_destroy(attributes)
    return size.value


class Pool:
    """Threads of a launch. `share(packed(machine code, arguments, end, chunk size, first))` runs the threads `first` ..
    `end` - 1 of machine code at an address, in about `chunks` chunks. Take the lock."""

    def __init__(self, code: PoolCode, thread_count: int) -> None:
        self._code, self.thread_count = code, thread_count
        workers = thread_count - 1
        size = ctypes.sizeof(PoolMemory) + workers * ctypes.sizeof(WorkerMemory)
        self._room = ctypes.create_string_buffer(size + LINE_BYTES)
        self._address = -(-ctypes.addressof(self._room) // LINE_BYTES) * LINE_BYTES
        self.memory = PoolMemory.from_address(self._address)
        self.workers = (WorkerMemory * workers).from_address(self._address + ctypes.sizeof(PoolMemory))
        functions, make_semaphore = _functions_of_system()
        self.memory.state, self.memory.workers, self.memory.spins = CLOSED_FLAG, workers, MAX_POLLS
        for name, function in zip(("wait", "post", "give_way"), functions, strict=True):
            setattr(self.memory, name, ctypes.cast(function, ctypes.c_void_p).value or 0)
        self._post = functions[1]
        self._one = cpu_code.full_bounds(1)
        self._threads: list[threading.Thread] = []
        stack = threading.stack_size(STACK_BYTES)
        try:
            for worker in range(workers):
                self.workers[worker].semaphore = make_semaphore()
                thread = threading.Thread(
                    target=self._work, args=(worker,), daemon=True, name=f"pointloom-cpu-{worker + 1}"
                )
                thread.start()
                self._threads.append(thread)
        except RuntimeError as error:  # the system allows no more threads, so there are fewer
            warnings.warn(
                f"pointloom uses {len(self._threads) + 1} of {thread_count} threads: {error}; {THREADS} asks for fewer",
                RuntimeWarning,
                stacklevel=2,
            )
            self.memory.workers, self.thread_count = len(self._threads), len(self._threads) + 1
        finally:
            threading.stack_size(stack)
        self.share = partial(code.share, ctypes.byref(self._one))
        self.packed = partial(struct.Struct("6Q").pack, self._address)
        self.chunks = CHUNKS_A_THREAD * self.thread_count

    def _work(self, worker: int) -> None:
        self._code.serve(ctypes.byref(self._one), struct.pack("2Q", self._address, worker))

    def end(self) -> None:
        """End the threads. No launch may be running."""
        self.memory.over = 1
        for worker in self.workers[: len(self._threads)]:
            self._post(ctypes.c_void_p(worker.semaphore), 1, None)
        for thread in self._threads:
            thread.join()


current: Pool | None = None
is_chosen = False  # True if the next launch uses the same pool, or none
_wanted: int | None = None  # set by set_thread_count
_is_over = False  # the program is ending


def default_thread_count() -> int:
    """Number of cores of this process, or POINTLOOM_CPU_THREADS. Raises ValueError if that is not an integer >= 1."""
    if text := setting(THREADS):
        return int(text)
    if sys.platform != "linux":
        return 1  # the waits of other systems are untested
    cores = usable_cores()
    return max(1, min(cores, _cores_of_group() or cores, MAX_THREADS))


def usable_cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _cores_of_group() -> int:
    """Cores by the CPU quota of this process's control group, rounded up. 0 if unlimited."""
    try:
        quota, period = Path("/sys/fs/cgroup/cpu.max").read_text().split()
        return 0 if quota == "max" else -(-int(quota) // int(period))
    except (OSError, ValueError):  # another version of control groups, or none
        return 0


def thread_count() -> int:
    if pool_code() is None:
        return 1
    if current is not None:
        return current.thread_count
    return _wanted if _wanted is not None else default_thread_count()


def set_thread_count(count: int | None) -> None:
    """Set the number of threads, 1 to MAX_THREADS, or None for the default. Take the lock."""
    global _wanted
    _wanted = count
    _end()


def pool() -> Pool | None:
    """The pool, created on first use. None if launches run on the calling thread. Take the lock."""
    global current, is_chosen
    if not is_chosen:
        code, count = pool_code(), thread_count()
        current = Pool(code, count) if code is not None and count > 1 and not _is_over else None
        is_chosen = True
    return current


def _end() -> None:
    global current, is_chosen
    ending, current, is_chosen = current, None, False
    if ending is not None:
        ending.end()


@atexit.register
def _end_with_program() -> None:
    """End the workers before their machine code is unloaded."""
    global _is_over
    _is_over = True
    _end()


def _after_fork() -> None:
    global current, is_chosen
    current, is_chosen = None, False  # its threads do not exist in the forked process


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
