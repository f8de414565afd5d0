"""CUDA memory pool: unused reserved bytes, and their release to the system."""

from __future__ import annotations

import ctypes
from typing import Any

import warp as wp

from .device_lock import lock, release_all
from .driver import driver

_RESERVED_BYTES = 5  # CU_MEMPOOL_ATTR_RESERVED_MEM_CURRENT
_USED_BYTES = 7  # CU_MEMPOOL_ATTR_USED_MEM_CURRENT


def reserved_bytes(device: Any) -> int:
    """Bytes that the pool of a GPU reserves beyond its arrays."""
    if not device.is_mempool_enabled:
        return 0
    with lock:
        pool = _pool(device)
        return max(0, _attribute(device, pool, _RESERVED_BYTES) - _attribute(device, pool, _USED_BYTES))


def trim(device: Any) -> int:
    """Release unused memory of the pool and of graphs (sync). Return the pool's bytes."""
    with lock:
        release_all()
        wp.synchronize_device(device)  # sync
        _check(device, driver().cuDeviceGraphMemTrim(_number(device)))
        if not device.is_mempool_enabled:
            return 0
        pool = _pool(device)
        before = _attribute(device, pool, _RESERVED_BYTES)
        _check(device, driver().cuMemPoolTrimTo(pool, ctypes.c_size_t(0)))
        return max(0, before - _attribute(device, pool, _RESERVED_BYTES))


def _pool(device: Any) -> ctypes.c_void_p:
    pool = ctypes.c_void_p()
    _check(device, driver().cuDeviceGetDefaultMemPool(ctypes.byref(pool), _number(device)))
    return pool


def _number(device: Any) -> ctypes.c_int:
    number = ctypes.c_int()
    _check(device, driver().cuDeviceGet(ctypes.byref(number), ctypes.c_int(device.ordinal)))
    return number


def _attribute(device: Any, pool: ctypes.c_void_p, name: int) -> int:
    value = ctypes.c_uint64()
    _check(device, driver().cuMemPoolGetAttribute(pool, ctypes.c_int(name), ctypes.byref(value)))
    return value.value


def _check(device: Any, error: int) -> None:
    if error:
        raise RuntimeError(f"{device}: its pool of memory does not answer (CUDA error {error})")
