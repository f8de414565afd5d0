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
from .cache_folders import ROOM, CacheError, discard, is_intact, is_writable, seal, temporary_cache
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
            _load_or_compile(module, device, block_dim)


def _load_or_compile(module: Any, device: Device, block_dim: int) -> None:
    """Load what an earlier process has left of a module if it is intact, or compile the module.

    Raises:
        CacheError: It is not there, and cannot be written.
    """
    files = _files_of(module, device, block_dim)
    if is_intact(*files):
        try:
            module.load(device, block_dim)
            return
        except Exception as error:
            if type(error) is not Exception:  # Warp's own has no other type
                raise
    named = wp.config.kernel_cache_dir
    if not discard(*files) or not is_writable(named or ".", ROOM):
        wp.config.kernel_cache_dir = temporary_cache()
    compiling()
    try:
        module.load(device, block_dim)
    except OSError as error:
        places = " and ".join(dict.fromkeys(map(str, (named, wp.config.kernel_cache_dir))))
        raise CacheError(
            f"compiled kernels cannot be stored in {places}: {error.strerror or error}. Free some space, or set "
            "XDG_CACHE_HOME and TMPDIR to folders that can be written to"
        ) from error
    seal(*_files_of(module, device, block_dim))


def _files_of(module: Any, device: Device, block_dim: int) -> tuple[Path, Path]:
    """What Warp makes of a module, in its cache."""
    folder = Path(wp.config.kernel_cache_dir or ".", module.get_module_identifier(block_dim))
    name = module._get_compile_output_name(device, block_dim=block_dim)
    return folder / name, folder / module._get_meta_name(block_dim=block_dim)


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
        discard(files.binary)  # else Warp would take it for its own
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
