"""Private parts of Warp in use, and checks that this Warp has them.

Fast launches and arrays (cuda_launches.py, device_arrays.py) bypass Warp's Python. If a part is missing, `wp.launch`
and `wp.empty` are used. On the CPU, kernels are then launched by Warp on one core (`launches.PlainLaunch`).
tests/kernels/language/test_warp_parts.py removes each part in turn.
"""

from __future__ import annotations

import ctypes
import functools
from typing import Any, NoReturn

import warp as wp

context: Any
types: Any
try:
    from warp._src import context, types
except ImportError:  # a Warp with other modules
    context = types = None

TESTED = ("1.19.0",)  # versions of Warp that all tests pass with
MAX_AXES = 4  # of an array
CURRENT_STREAM = 0xFFFFFFFFFFFFFFFF  # stands for a context's own
MEMORY_OF_POOL = getattr(getattr(context, "MemoryKind", None), "CUDA_MEMPOOL", None)
DESCRIPTION = ("data", "grad", "shape", "strides", "ndim", "flags")  # array descriptor of kernels: array_t
DESCRIPTION_BYTES = 56
BOUNDS = ("shape", "size", "coord_mult")  # first kernel argument: launch_bounds_1d_t
ARRAY = {  # attributes of an array: all that a copy for another address has to change is here
    *("_allocator", "_grad", "capacity", "ctype", "deleter", "device", "dtype", "is_contiguous", "ndim", "ptr"),
    *("shape", "size", "strides"),
}
DEVICE = (
    *(
        "_custom_allocator",
        "alias",
        "captures",
        "context",
        "current_allocator",
        "default_allocator",
        "mempool_allocator",
    ),
    *("ordinal", "stream"),
)
STREAM = ("owner",)
LAUNCH = ("block_dim", "bounds", "cluster_dim", "grid_stride", "hooks", "max_blocks", "module_exec", "params")
HOOKS = ("det_launch_meta", "forward", "forward_smem_bytes")
FUNCTIONS = {  # of the native library, with their argument types
    "wp_cuda_launch_kernel": 11,
    "wp_alloc_host": 2,
    "wp_alloc_device_async": 4,
    "wp_free_device_async": 3,
    "wp_memset_device": 5,
    "wp_memcpy_d2d": 5,
    "wp_memcpy_d2h": 5,
    "wp_memcpy_h2d": 5,
    "wp_cuda_stream_synchronize": 1,
    "wp_array_scan_int_device": 7,
    "wp_radix_sort_pairs_int64_device": 6,
}


def core() -> Any:
    return context.runtime.core


def missing() -> list[str]:
    """Parts that this Warp lacks or has in another form."""
    names = [] if MEMORY_OF_POOL is not None else ["MemoryKind.CUDA_MEMPOOL"]
    if tuple(name for name, *_ in types.array_t._fields_) != DESCRIPTION or _size(types.array_t) != DESCRIPTION_BYTES:
        names.append("array_t: an array as kernels get it")
    bounds = types.launch_bounds_t(1)
    if tuple(name for name, *_ in bounds._fields_) != BOUNDS or _size(type(bounds)) != 24:
        names.append("launch_bounds_t: what a kernel gets first")
    array = wp.empty(0, dtype=wp.int32, device="cpu")
    names += [f"array.{name}" for name in sorted(ARRAY - set(vars(array)))]
    names += [f"Device.{name}" for name in DEVICE if not _has(context.Device, name)]
    names += [f"Stream.{name}" for name in STREAM if not _has(wp.Stream, name)]
    names += [f"Launch.{name}" for name in LAUNCH if not _has(context.Launch, name)]
    names += [f"KernelHooks.{name}" for name in HOOKS if not _has(context.KernelHooks, name)]
    names += [] if hasattr(context, "CpuDefaultAllocator") else ["CpuDefaultAllocator"]
    names += [] if hasattr(context, "_raise_cuda_launch_error") else ["_raise_cuda_launch_error"]
    names += [f"runtime.{name}" for name in ("_apic_capture", "core", "tape") if not hasattr(context.runtime, name)]
    for name, count in FUNCTIONS.items():
        takes = getattr(getattr(core(), name, None), "argtypes", ())
        if takes is None or (takes and len(takes) != count):
            names.append(f"{name} with {count} arguments")
    return names


def _size(structure: Any) -> int:
    return ctypes.sizeof(structure)


def _has(kind: type, name: str) -> bool:
    """True if a class has an attribute, or one assigned in its constructor."""
    return hasattr(kind, name) or name in kind.__init__.__code__.co_names


@functools.cache
def is_known() -> bool:
    try:
        return not missing()
    except (AttributeError, TypeError):
        return False


def raise_launch_error(kernel: object, device: object, hooks: object) -> NoReturn:
    """Raise the launch error in Warp's wording."""
    context._raise_cuda_launch_error(kernel, device, hooks, False)
    raise AssertionError("it raises")


def launches_plainly() -> bool:
    """True if launches have no hooks, printing, or checks."""
    try:
        runtime, config = context.runtime, wp.config
        return not (
            runtime._apic_capture is not None
            or runtime.tape is not None
            or config.print_launches
            or config.verify_cuda
            or config.launch_array_access_mode != config.LaunchArrayAccessMode.RELAXED
        )
    except AttributeError:
        return False
