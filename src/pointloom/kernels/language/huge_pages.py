"""Huge pages for large arrays of the host, as NumPy uses them on Linux.

Each new large array is mapped anew, and a fault for each page of 4 kB takes a fifth of an operation's time.
"""

from __future__ import annotations

import ctypes
import mmap
import sys
import threading

MIN_MAPPED_BYTES = 32 << 20  # bytes from which glibc maps each block anew; smaller blocks may be used again
ADVICE = getattr(mmap, "MADV_HUGEPAGE", None)  # Linux alone has it
_POPULATE_WRITE = 23  # MADV_POPULATE_WRITE, from Linux 5.14
_MAX_THREADS = 8
_system = ctypes.CDLL(None) if sys.platform == "linux" and ADVICE is not None else None


def request_huge_pages(address: int, size: int) -> None:
    """Request huge pages within a block. The system may refuse, which changes no result."""
    if _system is not None:
        begin = -(-address // mmap.PAGESIZE) * mmap.PAGESIZE
        length = (address + size) // mmap.PAGESIZE * mmap.PAGESIZE - begin
        _system.madvise(ctypes.c_void_p(begin), ctypes.c_size_t(length), ADVICE)


def populate(address: int, size: int) -> None:
    """Map the pages of a new block by several threads. The driver's copy would map one after another."""
    if _system is None:
        return
    begin = -(-address // mmap.PAGESIZE) * mmap.PAGESIZE
    end = (address + size) // mmap.PAGESIZE * mmap.PAGESIZE
    step = max(-(-(end - begin) // (_MAX_THREADS * mmap.PAGESIZE)), 1) * mmap.PAGESIZE
    threads = [
        threading.Thread(
            target=_system.madvise,
            args=(ctypes.c_void_p(first), ctypes.c_size_t(min(step, end - first)), _POPULATE_WRITE),
        )
        for first in range(begin, end, step)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
