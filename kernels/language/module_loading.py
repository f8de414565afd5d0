"""A module of kernels is made ready for a device: compiled ahead, kept from an earlier run, or compiled now.

Warp keeps what it compiles in a folder that all processes of a user share, and writes each module whole or not at all;
but processes that start together would each compile the same. Here one does, and the others wait for it.
"""

from __future__ import annotations

import contextlib
import lzma
import os
import time
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import warp as wp

from ..array_types import Device
from . import compiled_ahead
from .notices import compiling

try:
    import fcntl
except ImportError:  # not a POSIX system: no turns
    fcntl = None

LOCKS = "pointloom.lock"  # in Warp's cache; a byte a module
LONGEST_WAIT = 300.0  # [s] beyond it a process compiles for itself: who has the turn may have been stopped
PAUSE = 0.01  # [s] between two looks


def load_module(module: Any, device: Device) -> None:
    """Make a module of Warp's ready for launches on a device; take the lock first.

    Args:
        module: Warp's, all its kernels made.
        device: Warp's.
    """
    block_dim = 1 if device.is_cpu else module.options["block_dim"]  # as launches have it
    if (device.context, block_dim) in module.execs:
        return
    place = "cpu" if device.is_cpu else f"sm{device.arch}"
    with turn_of(f"{module.get_module_identifier(block_dim)}.{place}"):
        if device.is_cpu or not _is_loaded_from_archive(module, device, block_dim):
            if not _is_in_cache(module, device, block_dim):
                compiling()
            module.load(device, block_dim)


def _is_in_cache(module: Any, device: Device, block_dim: int) -> bool:
    """Whether an earlier process has left what Warp would make of a module."""
    file = module._get_compile_output_name(device, block_dim=block_dim)
    return Path(wp.config.kernel_cache_dir or ".", module.get_module_identifier(block_dim), file).exists()


def _is_loaded_from_archive(module: Any, device: Device, block_dim: int) -> bool:
    found = compiled_ahead.archive()
    if found is None:
        return False
    try:
        files = found.place(module, device, block_dim)
    except (OSError, ValueError, KeyError, zipfile.BadZipFile, lzma.LZMAError) as error:
        compiled_ahead.refuse(found.path, f"cannot be read: {error}")
        return False
    if files is None:
        return False
    try:
        module.load(device, block_dim, files.binary, files.architecture, files.meta)
    except Exception as error:  # Warp's own has no other type
        files.binary.unlink(missing_ok=True)  # else Warp would take it for its own
        compiled_ahead.refuse(found.path, f"{device.alias} does not take {files.binary.name}: {error}")
        return False
    return True


@contextlib.contextmanager
def turn_of(name: str) -> Iterator[None]:
    """Let one process at a time do what is named; go on without a turn where that cannot be had.

    The system ends a turn with its process, however that ends.
    """
    descriptor = -1
    try:
        with contextlib.suppress(OSError):  # a folder of others, or one that cannot be written to
            path = Path(wp.config.kernel_cache_dir or ".") / LOCKS
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0), 0o666)
            _wait_for_turn(descriptor, zlib.crc32(name.encode()))
        yield
    finally:
        if descriptor >= 0:
            os.close(descriptor)  # which ends the turn


def _wait_for_turn(descriptor: int, position: int) -> None:
    end = time.monotonic() + LONGEST_WAIT
    while fcntl is not None:
        try:
            fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, position)
            return
        except (BlockingIOError, PermissionError):  # another has it; systems differ in the word
            if time.monotonic() > end:
                return
            time.sleep(PAUSE)
