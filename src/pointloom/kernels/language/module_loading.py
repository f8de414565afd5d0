"""Load a module of kernels: from the archive, the cache, or by compiling.

Processes share Warp's cache folder. One process compiles a module while the others wait.
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
from . import compiled_ahead, cuda_code
from .cache_folders import MIN_FREE_BYTES, CacheError, discard, is_intact, is_writable, seal, temporary_cache
from .compile_notices import compiling

try:
    import fcntl
except ImportError:  # not a POSIX system: no locks
    fcntl = None

LOCKS = "pointloom.lock"  # in Warp's cache. A byte per module
LONGEST_WAIT = 300.0  # [s] before a process compiles itself: the lock's owner may have been stopped
POLL_SECONDS = 0.01  # [s] between polls


def load_module(module: Any, device: Device) -> None:
    """Load a Warp module for a device. Take the lock first."""
    block_dim = 1 if device.is_cpu else module.options["block_dim"]  # as in launches
    try:
        if (device.context, block_dim) in module.execs:
            return
        if device.is_cuda:
            cuda_code.adapt(module, device.alias)
        name = module.get_module_identifier(block_dim)
        _files_of(module, device, block_dim)
    except (AttributeError, TypeError):  # a Warp with other names: without locks between processes
        compiling()
        _load(module, device, block_dim)
        return
    with locked(f"{name}.{'cpu' if device.is_cpu else f'sm{device.arch}'}"):
        if device.is_cpu or not _is_loaded_from_archive(module, device, block_dim):
            _load_or_compile(module, device, block_dim)


def _load(module: object, device: Device, block_dim: int) -> None:
    wp.load_module(module, device, block_dim=block_dim, max_workers=0)


def _load_or_compile(module: object, device: Device, block_dim: int) -> None:
    """Load an intact cached module, or compile it. Raises CacheError if the cache is not writable."""
    files = _files_of(module, device, block_dim)
    if is_intact(*files):
        try:
            _load(module, device, block_dim)
            return
        except Exception as error:
            if type(error) is not Exception:  # Warp raises no more specific type
                raise
    named = wp.config.kernel_cache_dir
    if not discard(*files) or not is_writable(named or ".", MIN_FREE_BYTES):
        wp.config.kernel_cache_dir = temporary_cache()
    compiling()
    try:
        _load(module, device, block_dim)
    except OSError as error:
        folders = " and ".join(dict.fromkeys(map(str, (named, wp.config.kernel_cache_dir))))
        raise CacheError(
            f"compiled kernels cannot be stored in {folders}: {error.strerror or error}. Free some space, or set "
            "XDG_CACHE_HOME and TMPDIR to folders that can be written to"
        ) from error
    seal(*_files_of(module, device, block_dim))


def _files_of(module: Any, device: Device, block_dim: int) -> tuple[Path, Path]:
    folder = Path(wp.config.kernel_cache_dir or ".", module.get_module_identifier(block_dim))
    name = module._get_compile_output_name(device, block_dim=block_dim)
    return folder / name, folder / module._get_meta_name(block_dim=block_dim)


def _is_loaded_from_archive(module: Any, device: Device, block_dim: int) -> bool:
    archive = compiled_ahead.archive()
    if archive is None:
        return False
    try:
        files = archive.unpack(module, device, block_dim)
    except (OSError, ValueError, KeyError, AttributeError, zipfile.BadZipFile, lzma.LZMAError) as error:
        compiled_ahead.refuse(archive.path, f"cannot be read: {error}")
        return False
    if files is None:
        return False
    try:
        module.load(device, block_dim, files.binary, files.architecture, files.meta)
    except Exception as error:  # Warp raises no more specific type
        discard(files.binary)  # else Warp would use it
        compiled_ahead.refuse(archive.path, f"{device.alias} does not take {files.binary.name}: {error}")
        return False
    return True


@contextlib.contextmanager
def locked(name: str) -> Iterator[None]:
    """Let one process at a time do the named work, without a lock if unsupported. It ends with the process."""
    descriptor = -1
    try:
        with contextlib.suppress(OSError):  # a folder of another user, or not writable
            path = Path(wp.config.kernel_cache_dir or ".") / LOCKS
            path.parent.mkdir(parents=True, exist_ok=True)
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0), 0o666)
            _wait_for_lock(descriptor, zlib.crc32(name.encode()))
        yield
    finally:
        if descriptor >= 0:
            os.close(descriptor)  # which releases the lock


def _wait_for_lock(descriptor: int, position: int) -> None:
    end = time.monotonic() + LONGEST_WAIT
    while fcntl is not None:
        try:
            fcntl.lockf(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, position)
            return
        except (BlockingIOError, PermissionError):  # locked by another process. The error code depends on the system
            if time.monotonic() > end:
                return
            time.sleep(POLL_SECONDS)
