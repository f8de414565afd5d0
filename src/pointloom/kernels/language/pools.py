"""CUDA memory pool: unused reserved bytes, and their release to the system."""

from __future__ import annotations

import ctypes

import warp as wp

from ..array_types import Device
from .device_lock import lock, release_all
from .driver import driver

_RESERVED_BYTES = 5  # CU_MEMPOOL_ATTR_RESERVED_MEM_CURRENT
_USED_BYTES = 7  # CU_MEMPOOL_ATTR_USED_MEM_CURRENT


def reserved_bytes(device: Device) -> int:
    """Bytes that the pool of a GPU reserves beyond its arrays."""
    if not device.is_mempool_enabled:
        return 0
    with lock:
        pool = _pool(device)
        return max(0, _attribute(device, pool, _RESERVED_BYTES) - _attribute(device, pool, _USED_BYTES))


def trim(device: Device) -> int:
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


def _pool(device: Device) -> ctypes.c_void_p:
    pool = ctypes.c_void_p()
    _check(device, driver().cuDeviceGetDefaultMemPool(ctypes.byref(pool), _number(device)))
    return pool


def _number(device: Device) -> ctypes.c_int:
    number = ctypes.c_int()
    _check(device, driver().cuDeviceGet(ctypes.byref(number), ctypes.c_int(device.ordinal)))
    return number


def _attribute(device: Device, pool: ctypes.c_void_p, name: int) -> int:
    value = ctypes.c_uint64()
    _check(device, driver().cuMemPoolGetAttribute(pool, ctypes.c_int(name), ctypes.byref(value)))
    return value.value


def _check(device: Device, error: int) -> None:
    if error:
        raise RuntimeError(f"{device}: its pool of memory does not answer (CUDA error {error})")
