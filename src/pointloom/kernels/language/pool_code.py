"""Machine code that distributes the parts of a CPU launch, and a test of the header it needs.

Both are Warp kernels in one module, with their bodies in cpu_pool.h. If they do not compile or give wrong results,
kernels use Warp's own code on one core.
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

CLOSED_FLAG = 1 << 32  # as in cpu_pool.h
WORD, LINE_BYTES = ctypes.c_uint64, 64  # a cache line


class PoolMemory(ctypes.Structure):
    """`Pool` of cpu_pool.h. `spare` fills the cache lines."""

    _fields_ = (
        *(("state", WORD), ("spare0", WORD * 7), ("next", WORD), ("spare1", WORD * 7)),
        *((name, WORD) for name in ("forward", "arguments", "chunks", "chunk", "total", "first")),
        ("spare2", WORD * 2),
        *((name, WORD) for name in ("over", "wait", "post", "give_way", "workers", "spins")),
        ("spare3", WORD * 2),
    )


class WorkerMemory(ctypes.Structure):
    """`Worker` of cpu_pool.h."""

    _fields_ = (("sleeps", WORD), ("semaphore", WORD), ("spare", WORD * 6))


@wp.func_native("pointloom::share(*(pointloom::Pool*)pool, forward, arguments, total, chunk, first);")
def _share(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
): ...


@wp.func_native("pointloom::serve(*(pointloom::Pool*)pool, worker);")
def _serve(pool: wp.uint64, worker: wp.uint64): ...


def _share_kernel(
    pool: wp.uint64, forward: wp.uint64, arguments: wp.uint64, total: wp.uint64, chunk: wp.uint64, first: wp.uint64
) -> None:
    _share(pool, forward, arguments, total, chunk, first)


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

    def _load(self, given: object, out: object) -> Any:
        """Take code that was compiled ahead. Returns the arguments of the trial, or None if there is no code."""
        entries = [kernel_cache.find(__name__, function.__name__) for function in _FUNCTIONS]
        addresses = [kernel_cache.address_of(entry) for entry in entries if entry is not None]
        if len(addresses) < len(_FUNCTIONS) or not all(addresses):
            return None
        self.share, self.serve, self._trial = (ctypes.CFUNCTYPE(None)(address) for address in addresses)
        plan, layout = entries[-1].plan, struct.Struct(entries[-1].layout)  # type: ignore[union-attr]
        return ctypes.create_string_buffer(cpu_code.packed(plan, layout, [given, 3, out]))

    def _compile(self, given: object, out: object) -> Any:
        """Compile the code. Returns the arguments of the trial."""
        module = wp.get_module("pointloom.cpu_pool")
        headers = wp.ModuleBuildOptions(extra_cpu_preamble=cpu_code.header() + cpu_code.pool_header())
        options = {**cpu_code.options(), "extra_build_options": headers}
        module.options.update({"enable_backward": False, "fuse_fp": False, **options})
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
