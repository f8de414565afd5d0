"""The threads that share a launch on the CPU: each takes the next chunk of it until none is left.

Warp's machine code of a kernel runs a launch, or a part of it (cpu_code.py), on the thread that calls it. What hands out
the parts is a kernel of Warp's as well: native code, compiled by Warp's own compiler and kept in its cache, so no C
compiler is needed where this package is installed. A Python thread does nothing but call it, and it does not come back
before the pool ends: no chunk waits for Python's lock.

A worker looks for chunks for some microseconds after its last one, then sleeps on a semaphore of the system. A launch
wakes the first two workers and they the next ones, as long as chunks are left; it does not wait for a worker that has not
come yet, and ends when those that came have left. Which thread takes which chunk changes no result: kernels write their
own elements. Take the lock: a pool runs one launch at a time.

Linux is what this is tested on. macOS and Windows have the same waits here, untried: there a pool has one thread, unless
`POINTLOOM_CPU_THREADS` or `set_thread_count` asks for more.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import struct
import sys
import threading
import warnings
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import warp as wp

from . import cpu_code
from .device_lock import lock
from .module_loading import load_module
from .quiet import kept_from_stderr

VARIABLE = "POINTLOOM_CPU_THREADS"
MOST_THREADS = 1024  # each is started, and more than any machine's cores only wait
CHUNKS_A_THREAD = 16  # so that one slow chunk, or a busy core, makes no launch last much longer
SPINS = 1000  # looks for a chunk before a worker sleeps: 10 to 50 us, more than the host takes from launch to launch
STACK = 8 << 20  # bytes of a worker's; macOS gives 512 kB, of which kernels with large vectors take a part

# The pool's words of 64 bits, eight to a cache line. Lines: 0 how many workers are inside a launch, with CLOSED where no
# launch is open; 1 the next chunk; 2 the launch; 3 the pool; from 4 on one a worker: whether it sleeps, its semaphore.
LINE = 8
STATE, NEXT, LAUNCH, POOL, WORKER = (LINE * k for k in range(5))
CLOSED = 1 << 32
FIELDS = {
    **{name: LAUNCH + k for k, name in enumerate(("forward", "arguments", "chunks", "chunk", "total", "first"))},
    **{name: POOL + k for k, name in enumerate(("over", "wait", "post", "give_way", "workers", "spins"))},
}
_NATIVE = "".join(f"#define {name}_ p[{place}]\n" for name, place in FIELDS.items()) + (
    """
    typedef unsigned long long word;
    typedef signed (*waiter)(void*, word, void*);  // int is Warp's name for a cast here
    typedef void (*yielder)();
    word* p = (word*)pool;
    auto pause = []() {
#if defined(__x86_64__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        __builtin_arm_yield();
#endif
    };
    auto is_open = [p]() {
        return !(__atomic_load_n(&p[0], __ATOMIC_SEQ_CST) >> 32)
            && __atomic_load_n(&p[8], __ATOMIC_RELAXED) < __atomic_load_n(&chunks_, __ATOMIC_RELAXED);
    };
    auto wake = [p](word w) {
        word wanted = chunks_ - 1 < workers_ ? chunks_ - 1 : workers_;
        word* its = p + 32 + 8 * w;
        if (w < wanted && __atomic_exchange_n(&its[0], (word)0, __ATOMIC_SEQ_CST))
            ((waiter)post_)((void*)its[1], 1, nullptr);
    };
    auto work = [p]() {
        void (*forward)(void*, void*) = (void (*)(void*, void*))forward_;
        void* arguments = (void*)arguments_;
        const word chunks = chunks_, chunk = chunk_, total = total_, first = first_;
        wp::launch_bounds_t<1> bounds = {{0}, 0, 1};
        for (;;) {
            const word c = __atomic_fetch_add(&p[8], (word)1, __ATOMIC_RELAXED);
            if (c >= chunks) break;
            const word begin = c * chunk;
            bounds.shape[0] = (unsigned)(0x80000000u | (first + begin));
            bounds.size = total - begin < chunk ? total - begin : chunk;
            forward(&bounds, arguments);
        }
    };
    """
)
_SHARE = """
    forward_ = forward; arguments_ = arguments; total_ = total; chunk_ = chunk; first_ = first;
    __atomic_store_n(&chunks_, (total + chunk - 1) / chunk, __ATOMIC_RELAXED);
    __atomic_store_n(&p[8], (word)0, __ATOMIC_RELAXED);
    __atomic_store_n(&p[0], (word)0, __ATOMIC_SEQ_CST);  // open, nobody inside
    wake(0);
    wake(1);
    work();
    __atomic_fetch_or(&p[0], 1ull << 32, __ATOMIC_SEQ_CST);
    for (word turns = 0; __atomic_load_n(&p[0], __ATOMIC_ACQUIRE) & 0xffffffffull; ++turns)
        if (turns < spins_) pause(); else ((yielder)give_way_)();  // a worker without a core may want this one
"""
_SERVE = """
    word* own = p + 32 + 8 * worker;
    for (;;) {
        for (word turns = 0;;) {  // until it is inside a launch
            if (__atomic_load_n(&over_, __ATOMIC_ACQUIRE)) return;
            if (is_open()) {
                word state = __atomic_load_n(&p[0], __ATOMIC_RELAXED);
                if (!(state >> 32) && __atomic_compare_exchange_n(
                    &p[0], &state, state + 1, false, __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) break;
                continue;
            }
            if (turns++ < spins_) { pause(); continue; }
            __atomic_store_n(&own[0], (word)1, __ATOMIC_SEQ_CST);
            // A launch that opened before this saw no sleeper; who clears the mark is who ends the sleep.
            if ((is_open() || __atomic_load_n(&over_, __ATOMIC_SEQ_CST))
                && __atomic_exchange_n(&own[0], (word)0, __ATOMIC_SEQ_CST)) continue;
            while (((waiter)wait_)((void*)own[1], ~0ull, nullptr)) {}  // a signal interrupts it
            turns = 0;
        }
        wake(2 * worker + 2);
        wake(2 * worker + 3);
        work();
        __atomic_fetch_sub(&p[0], (word)1, __ATOMIC_ACQ_REL);
    }
"""


@wp.func_native(_NATIVE + _SHARE)
def _share(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
): ...


@wp.func_native(_NATIVE + _SERVE)
def _serve(pool: wp.uint64, worker: wp.uint64): ...


def _share_kernel(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
) -> None:
    _share(pool, forward, arguments, total, chunk, first)


def _serve_kernel(pool: wp.uint64, worker: wp.uint64) -> None:
    _serve(pool, worker)


def _try_kernel(given: wp.array(dtype=wp.vec3), turns: wp.int32, out: wp.array2d(dtype=wp.float32)):  # type: ignore[valid-type]
    i = wp.tid()
    total = wp.float32(0.0)
    for k in range(turns):
        if wp.isfinite(given[i]):
            total += given[i][k]
    out[i, 0] = total
    wp.atomic_add(out, i, 1, 1.0)


class _Code:
    """The machine code of this file's kernels, tried.

    Raises:
        Exception: Warp's own, where it does not compile them; RuntimeError where what it compiled is wrong.
    """

    def __init__(self) -> None:
        module = wp.get_module("pointloom.cpu_pool")
        module.options.update({"enable_backward": False, "fuse_fp": False, **cpu_code.options()})
        kernels = [
            wp.kernel(f, enable_backward=False, module=module) for f in (_share_kernel, _serve_kernel, _try_kernel)
        ]
        with kept_from_stderr():
            load_module(module, wp.get_device("cpu"))
        given = wp.array(np.arange(24, dtype=np.float32).reshape(8, 3), dtype=wp.vec3, device="cpu")
        out = wp.zeros(shape=(8, 2), dtype=wp.float32, device="cpu")
        self._commands: Any = [  # hold the machine code
            wp.launch(kernel, 1, values, device="cpu", record_cmd=True)
            for kernel, values in zip(kernels, ([0] * 6, [0] * 2, [given, 3, out]), strict=True)
        ]
        self.share, self.serve, trial = (command.hooks.forward for command in self._commands)
        self.bounds = type(self._commands[0].bounds)
        trial(ctypes.byref(cpu_code.part(self.bounds, 2, 3)), ctypes.byref(arguments_of(self._commands[2])))
        expected = np.zeros((8, 2), np.float32)
        expected[2:5] = [(9 * i + 3, 1.0) for i in (2, 3, 4)]
        if not np.array_equal(out.numpy(), expected):
            raise RuntimeError("a part of a launch begins elsewhere, or arrays lie otherwise")


def arguments_of(command: Any) -> ctypes.Structure:
    """The structure of a recorded launch's arguments, as Warp's machine code takes it."""
    params = command.params[1:]
    kind = type("Arguments", (ctypes.Structure,), {"_fields_": [(f"a{k}", type(p)) for k, p in enumerate(params)]})
    filled = kind()
    for k, param in enumerate(params):
        setattr(filled, f"a{k}", param)
    return filled


@cache
def _code() -> _Code | None:
    try:
        with lock:
            return _Code()
    except Exception as error:  # Warp's own has no other type
        warnings.warn(
            f"pointloom uses one CPU core, and slower code: Warp {wp.config.version} does not take cpu_access.h "
            f"({str(error).strip().splitlines()[-1][:200]}). Install a version of Warp that `pip show -v pointloom` names",
            RuntimeWarning,
            stacklevel=2,
        )
        return None


def is_usable() -> bool:
    """Whether kernels are compiled with the header, and launches can be shared."""
    return _code() is not None


def options() -> dict[str, Any]:
    """What modules of kernels for the CPU are compiled with, beside what all are."""
    return cpu_code.options() if _code() else {}


# ------------------------------------------------------------------------------------------------ threads


def _functions_of_system() -> tuple[list[Any], Any]:
    """What waits for a semaphore, wakes one and gives a core away; and what makes a semaphore.

    The waits get two more arguments than POSIX takes: what macOS and Windows want there, for ever and one.
    """
    if sys.platform == "win32":
        system = ctypes.WinDLL("kernel32")  # type: ignore[attr-defined]
        make = system.CreateSemaphoreW
        make.restype, make.argtypes = ctypes.c_void_p, [ctypes.c_void_p, ctypes.c_long, ctypes.c_long, ctypes.c_void_p]
        return [system.WaitForSingleObject, system.ReleaseSemaphore, system.SwitchToThread], lambda: make(
            None, 0, 2**30, None
        )
    system = ctypes.CDLL(None)
    if sys.platform == "darwin":  # where unnamed semaphores of POSIX do not exist
        make = system.dispatch_semaphore_create
        make.restype, make.argtypes = ctypes.c_void_p, [ctypes.c_long]
        return [system.dispatch_semaphore_wait, system.dispatch_semaphore_signal, system.sched_yield], lambda: make(0)

    def make_posix() -> int:
        semaphore = ctypes.create_string_buffer(64)  # a sem_t has 32 bytes
        if system.sem_init(semaphore, 0, 0):
            raise OSError("the system gives no semaphore")
        _held.append(semaphore)
        return ctypes.addressof(semaphore)

    return [system.sem_wait, system.sem_post, system.sched_yield], make_posix


_held: list[Any] = []  # semaphores, for as long as a worker may wait for one


class Pool:
    """So many threads, one of which is the caller's.

    Args:
        code: The machine code.
        thread_count: Threads.
    """

    def __init__(self, code: _Code, thread_count: int) -> None:
        self._code, self.thread_count = code, thread_count
        workers = thread_count - 1
        size = WORKER + LINE * workers
        self._room = (ctypes.c_uint64 * (size + LINE))()
        self._address = (ctypes.addressof(self._room) + 63) & ~63
        words = self._words = (ctypes.c_uint64 * size).from_address(self._address)
        functions, make_semaphore = _functions_of_system()
        words[STATE] = CLOSED
        words[FIELDS["workers"]], words[FIELDS["spins"]] = workers, SPINS
        for name, function in zip(("wait", "post", "give_way"), functions, strict=True):
            words[FIELDS[name]] = ctypes.cast(function, ctypes.c_void_p).value or 0
        self._post = functions[1]
        self._one = code.bounds((1,))
        self._pack = struct.Struct("6Q").pack
        self._threads: list[threading.Thread] = []
        stack = threading.stack_size(STACK)
        try:
            for worker in range(workers):
                words[WORKER + LINE * worker + 1] = make_semaphore()
                thread = threading.Thread(
                    target=self._work, args=(worker,), daemon=True, name=f"pointloom-cpu-{worker + 1}"
                )
                thread.start()
                self._threads.append(thread)
        except RuntimeError as error:  # the system gives no more threads, so there are fewer
            warnings.warn(
                f"pointloom uses {len(self._threads) + 1} of {thread_count} threads: {error}; {VARIABLE} asks for fewer",
                RuntimeWarning,
                stacklevel=2,
            )
            words[FIELDS["workers"]], self.thread_count = len(self._threads), len(self._threads) + 1
        finally:
            threading.stack_size(stack)

    def _work(self, worker: int) -> None:
        self._code.serve(ctypes.byref(self._one), struct.pack("2Q", self._address, worker))

    def share(self, forward: int, arguments: int, total: int, first: int) -> None:
        """Run the threads from `first` on, `total` of them, of the machine code at an address."""
        chunk = total // (CHUNKS_A_THREAD * self.thread_count) or 1
        self._code.share(ctypes.byref(self._one), self._pack(self._address, forward, arguments, total, chunk, first))

    def end(self) -> None:
        """End its threads; no launch is running."""
        words = self._words
        words[FIELDS["over"]] = 1
        for worker in range(len(self._threads)):
            self._post(ctypes.c_void_p(words[WORKER + LINE * worker + 1]), 1, None)
        for thread in self._threads:
            thread.join()


_pool: Pool | None = None
_is_chosen = False  # whether the pool, or that there is none, is what the next launch takes too
_wanted: int | None = None  # by set_thread_count
_is_over = False  # the program is ending


def default_thread_count() -> int:
    """The threads of a pool that nobody asks for another number of: the cores that this process may use.

    Raises:
        ValueError: POINTLOOM_CPU_THREADS is no whole number from 1 on.
    """
    said = os.environ.get(VARIABLE, "")
    if said:
        if not (said.isascii() and said.isdigit() and 1 <= int(said[:9]) <= MOST_THREADS):
            raise ValueError(f"{VARIABLE}: expected a whole number from 1 to {MOST_THREADS}, got {said[:40]!r}")
        return int(said)
    if sys.platform != "linux":
        return 1  # the waits of other systems are untried
    cores = len(os.sched_getaffinity(0))
    return max(1, min(cores, _cores_of_group() or cores, MOST_THREADS))


def _cores_of_group() -> int:
    """The cores that the time of this process's control group comes to, rounded up; 0 where it has no bound."""
    try:
        quota, period = Path("/sys/fs/cgroup/cpu.max").read_text().split()
        return 0 if quota == "max" else -(-int(quota) // int(period))
    except (OSError, ValueError):  # another version of control groups, or none
        return 0


def thread_count() -> int:
    """The threads that launches on the CPU are shared by, the caller's among them.

    Raises:
        ValueError: As `default_thread_count`.
    """
    if _code() is None:
        return 1
    if _pool is not None:
        return _pool.thread_count
    return _wanted if _wanted is not None else default_thread_count()


def set_thread_count(count: int | None) -> None:
    """Share launches by so many threads from the next on, None for the default; take the lock.

    Raises:
        ValueError: It is not from 1 to MOST_THREADS.
    """
    global _wanted
    if count is not None and not 1 <= count <= MOST_THREADS:
        raise ValueError(f"count: expected a number from 1 to {MOST_THREADS}, got {count}")
    _wanted = count
    _end()


def pool() -> Pool | None:
    """The pool, made when it is first asked for; None where launches are this thread's. Take the lock."""
    global _pool, _is_chosen
    if not _is_chosen:
        code, count = _code(), thread_count()
        _pool = Pool(code, count) if code is not None and count > 1 and not _is_over else None
        _is_chosen = True
    return _pool


def _end() -> None:
    global _pool, _is_chosen
    ending, _pool, _is_chosen = _pool, None, False
    if ending is not None:
        ending.end()


@atexit.register
def _end_with_program() -> None:
    """Machine code is taken away after this, from under whoever still looks for work in it."""
    global _is_over
    _is_over = True
    _end()


def _after_fork() -> None:
    global _pool, _is_chosen
    _pool, _is_chosen = None, False  # its threads did not come along


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)
