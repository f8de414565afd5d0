"""Machine code that distributes the parts of a CPU launch, and a test of the header it needs.

Both are Warp kernels in one module, with C++ bodies (`_fraction`, `_serve`; see cpu_pool.py). If they do not compile or
give wrong results, kernels use Warp's own code on one core.
"""

from __future__ import annotations

import ctypes
import struct
import warnings
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np
import warp as wp

from . import cpu_code, kernel_cache
from .cache_folders import CacheError
from .device_lock import lock
from .module_loading import load_module
from .warp_parts import TESTED

# Layout of the pool in 64-bit words, eight per cache line: 0 workers inside a launch, or CLOSED; 1 next chunk;
# 2 launch; 3 pool; from 4 on, one line per worker: whether it sleeps, its semaphore.
LINE = 8
STATE, NEXT, LAUNCH, POOL, WORKER = (LINE * k for k in range(5))
CLOSED = 1 << 32
FIELDS = {
    **{name: LAUNCH + k for k, name in enumerate(("forward", "arguments", "chunks", "chunk", "total", "first"))},
    **{name: POOL + k for k, name in enumerate(("over", "wait", "post", "give_way", "workers", "spins"))},
}
_NATIVE = "".join(f"#define {name}_ p[{slot}]\n" for name, slot in FIELDS.items()) + (
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
_FRACTION = """
    forward_ = forward; arguments_ = arguments; total_ = total; chunk_ = chunk; first_ = first;
    __atomic_store_n(&chunks_, (total + chunk - 1) / chunk, __ATOMIC_RELAXED);
    __atomic_store_n(&p[8], (word)0, __ATOMIC_RELAXED);
    __atomic_store_n(&p[0], (word)0, __ATOMIC_SEQ_CST);  // open, nobody inside
    wake(0);
    wake(1);
    work();
    __atomic_fetch_or(&p[0], 1ull << 32, __ATOMIC_SEQ_CST);
    for (word tries = 0; __atomic_load_n(&p[0], __ATOMIC_ACQUIRE) & 0xffffffffull; ++tries)
        if (tries < spins_) pause(); else ((yielder)give_way_)();  // a worker without a core may want this one
"""
_SERVE = """
    word* own = p + 32 + 8 * worker;
    for (;;) {
        for (word tries = 0;;) {  // until it is inside a launch
            if (__atomic_load_n(&over_, __ATOMIC_ACQUIRE)) return;
            if (is_open()) {
                word state = __atomic_load_n(&p[0], __ATOMIC_RELAXED);
                if (!(state >> 32) && __atomic_compare_exchange_n(
                    &p[0], &state, state + 1, false, __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) break;
                continue;
            }
            if (tries++ < spins_) { pause(); continue; }
            __atomic_store_n(&own[0], (word)1, __ATOMIC_SEQ_CST);
            // A launch that opened before this saw no sleeper; who clears the mark is who ends the sleep.
            if ((is_open() || __atomic_load_n(&over_, __ATOMIC_SEQ_CST))
                && __atomic_exchange_n(&own[0], (word)0, __ATOMIC_SEQ_CST)) continue;
            while (((waiter)wait_)((void*)own[1], ~0ull, nullptr)) {}  // a signal interrupts it
            tries = 0;
        }
        wake(2 * worker + 2);
        wake(2 * worker + 3);
        work();
        __atomic_fetch_sub(&p[0], (word)1, __ATOMIC_ACQ_REL);
    }
"""


@wp.func_native(_NATIVE + _FRACTION)
def _fraction(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
): ...


@wp.func_native(_NATIVE + _SERVE)
def _serve(pool: wp.uint64, worker: wp.uint64): ...


def _share_kernel(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
) -> None:
    _fraction(pool, forward, arguments, total, chunk, first)


def _serve_kernel(pool: wp.uint64, worker: wp.uint64) -> None:
    _serve(pool, worker)


def _try_kernel(given: wp.array(dtype=wp.vec3), count: int, out: wp.array2d(dtype=wp.float32)):  # type: ignore[valid-type]
    i = wp.tid()
    total = wp.float32(0.0)
    for k in range(count):
        if wp.isfinite(given[i]):
            total += given[i][k]
    out[i, 0] = total
    wp.atomic_add(out, i, 1, 1.0)


class PoolCode:
    """Machine code of this file's kernels, tested unless it is for another processor.

    Raises Warp's own error, or RuntimeError if a result is wrong.
    """

    def __init__(self) -> None:
        given = wp.array(np.arange(24, dtype=np.float32).reshape(8, 3), dtype=wp.vec3, device="cpu")
        out = wp.zeros(shape=(8, 2), dtype=wp.float32, device="cpu")
        self.kernels: list[Any] = []
        arguments = self._load(given, out) or self._compile(given, out)
        if not cpu_code.is_for_this_processor():
            return
        self._trial(ctypes.byref(cpu_code.part(2, 3)), arguments)
        expected = np.zeros((8, 2), np.float32)
        expected[2:5] = [(9 * i + 3, 1.0) for i in (2, 3, 4)]
        if not np.array_equal(out.numpy(), expected):
            raise RuntimeError("a part of a launch begins elsewhere, or arrays lie otherwise")

    def _load(self, given: Any, out: Any) -> Any:
        """Take code that was compiled ahead. Returns the arguments of the trial, or None if there is no code."""
        entries = [kernel_cache.find(__name__, function.__name__) for function in _FUNCTIONS]
        addresses = [kernel_cache.address_of(entry) for entry in entries if entry is not None]
        if len(addresses) < len(_FUNCTIONS) or not all(addresses):
            return None
        self.share, self.serve, self._trial = (ctypes.CFUNCTYPE(None)(address) for address in addresses)
        plan, layout = entries[-1].plan, struct.Struct(entries[-1].layout)  # type: ignore[union-attr]
        return ctypes.create_string_buffer(cpu_code.packed(plan, layout, [given, 3, out]))

    def _compile(self, given: Any, out: Any) -> Any:
        """Compile the code. Returns the arguments of the trial."""
        module = wp.get_module("pointloom.cpu_pool")
        module.options.update({"enable_backward": False, "fuse_fp": False, **cpu_code.options()})
        self.kernels = [wp.kernel(function, enable_backward=False, module=module) for function in _FUNCTIONS]
        load_module(module, wp.get_device("cpu"))
        self._commands: Any = [  # keep the machine code alive
            wp.launch(kernel, 1, values, device="cpu", record_cmd=True)
            for kernel, values in zip(self.kernels, ([0] * 6, [0] * 2, [given, 3, out]), strict=True)
        ]
        self.share, self.serve, self._trial = (command.hooks.forward for command in self._commands)
        return ctypes.byref(filled_with(self._commands[2].params[1:]))


_FUNCTIONS = (_share_kernel, _serve_kernel, _try_kernel)


def filled_with(params: Sequence[Any]) -> ctypes.Structure:
    """Argument structure of a recorded launch, with fields argument0, ..."""
    fields = [(f"argument{k}", type(param)) for k, param in enumerate(params)]
    filled = type("Arguments", (ctypes.Structure,), {"_fields_": fields})()
    for (name, _), param in zip(fields, params, strict=True):
        setattr(filled, name, param)
    return filled


@cache
def pool_code() -> PoolCode | None:
    """The machine code, or None and one warning if the header does not compile."""
    try:
        with lock:
            return PoolCode()
    except CacheError:  # not an error of Warp or the header
        raise
    except Exception as error:  # Warp raises no more specific type
        warnings.warn(
            f"pointloom uses one CPU core, and slower code: Warp {wp.config.version} does not take cpu_access.h "
            f"({str(error).strip().splitlines()[-1][:200]}); tested version: pip install warp-lang=={TESTED[-1]}",
            RuntimeWarning,
            stacklevel=2,
        )
        return None


def is_usable() -> bool:
    """True if kernels are compiled with the header and launches can be split."""
    return pool_code() is not None


def options() -> dict[str, Any]:
    return cpu_code.options() if pool_code() else {}
