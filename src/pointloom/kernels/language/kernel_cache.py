"""Cache of prepared CPU kernels: later processes launch them without parsing their source.

Parsing, checking, and hashing takes 20 to 100 ms per file of kernels. This cache stores, per file and under a digest of
the kernel sources, Warp, and the processor, where a kernel's machine code is and how its arguments are packed. Kernels
of other packages are not cached.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import shutil
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import warp as wp

from . import cpu_archive, cpu_code
from .cache_folders import is_intact, write_atomically
from .compiled_ahead import digest_of_sources
from .structs import FieldPath

FOLDER = "pointloom-kept"  # in Warp's cache
MAX_FOLDERS = 8  # folders of other sources or processors, before the oldest is removed
PACKAGE = __name__.rpartition(".language.")[0]


class CachedKernel(NamedTuple):
    """A cached kernel: sources of the flat parameters, a letter per parameter (a: array, v: vector or matrix, s:
    scalar), the `struct` format of the arguments, symbol, and file of machine code."""

    field_paths: list[FieldPath]
    plan: str
    layout: str
    symbol: str
    machine_code: str


def find(module: str, name: str) -> CachedKernel | None:
    """Kernel or sum of a module that was compiled ahead or by an earlier process, or None."""
    entry = cpu_archive.entry_of(module, name) or _read(module).get(name)
    if entry is None:
        return None
    try:
        return CachedKernel([FieldPath(k, tuple(path)) for k, path in entry[0]], *entry[1:])
    except (TypeError, ValueError):  # of another version
        return None


def store(module: str, name: str, cached: CachedKernel) -> None:
    """Store a kernel for later processes if the folder is writable."""
    path = _path(module)
    if path is None:
        return
    _read.cache_clear()
    entries = {**_read(module), name: list(cached)}
    with contextlib.suppress(OSError):
        if not path.parent.is_dir():
            path.parent.mkdir(parents=True)
            _forget_oldest(path.parent.parent)
        write_atomically(path, json.dumps(entries).encode())
    _read.cache_clear()


def address_of(cached: CachedKernel) -> int:
    """Address of a kernel's loaded machine code. 0 if it is missing or this Warp loads it differently."""
    try:
        llvm = wp._src.context.runtime.llvm
        handle = _handle(cached.machine_code)
        return llvm.wp_lookup(handle, cached.symbol.encode()) if handle else 0
    except (AttributeError, TypeError):
        return 0


def machine_code_of(kernel: Any) -> str:
    """File of a kernel's machine code in Warp's cache. Empty unless there is exactly one."""
    name = kernel.module.get_module_identifier(block_dim=1)
    files = [str(path) for path in (Path(wp.config.kernel_cache_dir or ".") / name).glob(f"{name}*.o")]
    return files[0] if len(files) == 1 else ""


@cache
def _handle(machine_code: str) -> bytes:
    """Name of a loaded file in Warp's loader. Empty if it cannot be loaded."""
    if not cpu_archive.contains(machine_code) and not is_intact(Path(machine_code)):
        return b""
    handle = f"pointloom_{Path(machine_code).stem}".encode()
    refused = wp._src.context.runtime.llvm.wp_load_obj(os.fsencode(machine_code), handle, wp.config.legacy_cpu_linker)
    return b"" if refused else handle


@cache
def _read(module: str) -> dict[str, Any]:
    path = _path(module)
    try:
        entries = json.loads(path.read_text(encoding="utf-8")) if path is not None else {}
    except (OSError, ValueError):
        return {}
    return entries if isinstance(entries, dict) else {}


def _path(module: str) -> Path | None:
    folder = _folder()
    return (
        folder / f"{module.removeprefix(PACKAGE + '.')}.json" if folder and module.startswith(f"{PACKAGE}.") else None
    )


@cache
def _folder() -> Path | None:
    try:
        headers = cpu_code.header(), cpu_code.pool_header()
        parts = [digest_of_sources(), *headers, wp.get_cpu_kernel_cache_key(cpu_compiler_flags=cpu_code.FLAGS)]
    except (AttributeError, OSError):
        return None
    digest = hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]
    return Path(wp.config.kernel_cache_dir) / FOLDER / digest if wp.config.kernel_cache_dir else None


def _forget_oldest(folder: Path) -> None:
    folders = sorted(folder.iterdir(), key=lambda path: path.stat().st_mtime)
    for path in folders[:-MAX_FOLDERS]:
        shutil.rmtree(path, ignore_errors=True)
