"""Page-locked host memory for NumPy results of GPUs, kept for the next ones.

A GPU writes to it directly, 4 to 16 times as fast as to other memory (docs/arrays.md, Page-locked memory). A result
lives in it: its memory returns here with the last NumPy array over it.

The memory is private and registered with CUDA, so a forked process gets a copy. CUDA's own page-locked memory would be
shared with it, and the next result would overwrite the child's. Linux before 5.12 may give locked pages to the child,
and copies to the parent: memory from before a fork is not used again.
"""

from __future__ import annotations

import contextlib
import ctypes
import math
import mmap
import os
import warnings
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..array_types import Device
from .device_lock import lock, why_no_cuda_here
from .driver import driver
from .huge_pages import populate, request_huge_pages

MIN_PINNED_BYTES = 1 << 20  # [B] smaller results take less than 0.1 ms in other memory
SIZES_PER_POWER_OF_TWO = 8  # sizes per power of two, so that at most an eighth of a buffer is unused
FRACTION_OF_MEMORY = 1 / 16  # of the host's memory, as locked pages cannot be swapped out or moved for other programs
RESULTS_BEFORE_RETRY = 100  # results after a failure: a failed attempt maps and releases memory, milliseconds per 10 MB
_REGISTER_PORTABLE = 1  # CU_MEMHOSTREGISTER_PORTABLE: page-locked for all GPUs
_PRIVATE: Any = {"flags": mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS} if hasattr(mmap, "MAP_PRIVATE") else {}


class Buffer:
    """Page-locked memory. Raises MemoryError if the driver locks no more pages."""

    def __init__(self, size: int, context: Any, fork_count: int) -> None:
        self.size, self.fork_count, self._context = size, fork_count, context
        self._memory = mmap.mmap(-1, size, **_PRIVATE)
        self.address = ctypes.addressof(ctypes.c_char.from_buffer(self._memory))
        request_huge_pages(self.address, size)
        populate(self.address, size)  # while the device works
        arguments = ctypes.c_void_p(self.address), ctypes.c_size_t(size), ctypes.c_uint(_REGISTER_PORTABLE)
        with context:
            if driver().cuMemHostRegister_v2(*arguments):
                raise MemoryError(f"the driver locks no {size:,} bytes of host memory")

    def unlock(self) -> None:
        with self._context:
            driver().cuMemHostUnregister(ctypes.c_void_p(self.address))


class Pool:
    """Page-locked memory, in use and idle, up to `limit` bytes in all."""

    def __init__(self) -> None:
        self.limit: int | None = None  # bytes; set at first use
        self.buffers: set[Buffer] = set()
        self.idle: list[Buffer] = []
        self.returned: deque[Buffer] = deque()  # by garbage collection in any thread, which must not wait for the lock
        self.fork_count = 0
        self.refusals = 0  # results until memory is locked again after a failure
        self.has_warned = False

    @property
    def size(self) -> int:
        """Bytes in use and idle."""
        return sum(buffer.size for buffer in self.buffers)

    def take(self, size: int, context: object) -> Buffer | None:
        """Memory for a result. None if the limit is reached, or no more pages can be locked."""
        self._collect()
        fitting = [buffer for buffer in self.idle if size <= buffer.size <= 2 * size]
        if fitting:
            buffer = min(fitting, key=lambda each: each.size)
            self.idle.remove(buffer)
            return buffer
        if self.limit is None:
            self.limit = int(host_bytes() * FRACTION_OF_MEMORY)
        size = rounded_up(size)
        while self.idle and self.size + size > self.limit:
            self._drop(self.idle.pop(0))  # the one that has been idle longest
        if self.size + size > self.limit:
            return None
        if self.refusals:
            self.refusals -= 1
            return None
        try:
            buffer = Buffer(size, context, self.fork_count)
        except (MemoryError, OSError, AttributeError) as error:  # AttributeError: the driver has no such function
            self._refuse(error)
            return None
        self.buffers.add(buffer)
        return buffer

    def _refuse(self, error: Exception) -> None:
        """After a failure, which may pass: use other memory for the next results, and warn of the first one."""
        if not self.has_warned:
            self.has_warned = True
            warnings.warn(
                f"copies from and to a GPU use ordinary memory for now, which is slower: {error}. More pages can be "
                "locked when other programs release theirs, or with a higher `ulimit -l`",
                RuntimeWarning,
                stacklevel=2,
            )
        self.refusals = RESULTS_BEFORE_RETRY

    def release(self) -> None:
        """Release idle memory."""
        self._collect()
        while self.idle:
            self._drop(self.idle.pop())
        self.limit, self.refusals = None, 0

    def _collect(self) -> None:
        """Make returned memory idle, or release it if it is from before a fork."""
        while self.returned:
            buffer = self.returned.popleft()
            if buffer.fork_count == self.fork_count:
                self.idle.append(buffer)
            else:
                self._drop(buffer)

    def _drop(self, buffer: Buffer) -> None:
        buffer.unlock()
        self.buffers.discard(buffer)

    def note_fork(self) -> None:
        """In the parent: use no memory from before the fork again."""
        self.fork_count += 1
        self.returned.extend(self.idle)
        self.idle.clear()

    def forget(self) -> None:
        """In the child: all memory is the parent's, and live arrays are copies."""
        self.limit, self.returned = 0, deque(maxlen=0)
        self.idle.clear()
        self.buffers.clear()


class Loan:
    """Owner of the memory of one result. The memory returns to the pool with the last array over it."""

    def __init__(self, pool: Pool, buffer: Buffer, shape: tuple[int, ...], scalar: np.dtype) -> None:
        self._pool, self._buffer = pool, buffer
        self.__array_interface__ = {
            "data": (buffer.address, False),
            "shape": shape,
            "typestr": scalar.str,
            "version": 3,
        }

    def __del__(self) -> None:
        self._pool.returned.append(self._buffer)


pool = Pool()


def fill_pinned(
    shape: tuple[int, ...], scalar: np.dtype, device: Device, fill: Callable[[int, int], None]
) -> NDArray[Any] | None:
    """A NumPy array in page-locked memory. `fill(address, bytes)` lets the device write to it and waits. None if there
    is no such memory. Take the lock."""
    size = math.prod(shape) * scalar.itemsize
    buffer = pool.take(size, device.context_guard)
    if buffer is None:
        return None
    try:
        fill(buffer.address, size)
    except BaseException:  # Ctrl-C before the wait
        with device.context_guard:  # of the GPU that writes, which may not be the one that locked the pages
            driver().cuCtxSynchronize()
        pool.returned.append(buffer)
        raise
    return np.asarray(Loan(pool, buffer, shape, scalar))


def release_pinned() -> None:
    """Release page-locked memory that no array uses."""
    if not why_no_cuda_here():
        with lock:
            pool.release()


def rounded_up(size: int) -> int:
    """The size of a buffer: a multiple of an eighth of the next lower power of two."""
    step = (1 << (size.bit_length() - 1)) // SIZES_PER_POWER_OF_TWO
    return -(-size // step) * step


def host_bytes() -> int:
    """Memory of the host, or of this container if it has less. 0 if unknown, as on Windows."""
    sizes = []
    with contextlib.suppress(AttributeError, OSError, ValueError):
        sizes.append(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"))
    with contextlib.suppress(OSError, ValueError):  # "max" is no number
        sizes.append(int(Path("/sys/fs/cgroup/memory.max").read_text()))
    return min(sizes, default=0)


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_parent=pool.note_fork, after_in_child=pool.forget)
