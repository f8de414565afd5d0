"""What a process finds out about a kernel for the CPU, kept for the next, which launches it without reading its text.

To read and check the kernels of a file, write out their loops and hand them to Warp, which finds by their hash what it
compiled before, takes a process 20 to 100 ms a file: twice what registering two small clouds takes. All of it follows
from the sources of kernels, from Warp and from the kind of processor. So here are kept, under a digest of those, where
a kernel's machine code lies, what each of its parameters comes from, and how its arguments are packed: one small file
for each file of kernels, beside Warp's own cache of kernels.

A kernel that is not found here, or whose machine code is gone, goes the long way. Kernels of other packages always do.
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

from . import cpu_code
from .cache_folders import is_intact, write_atomically
from .compiled_ahead import digest_of_sources
from .structs import Place

FOLDER = "pointloom-kept"  # in Warp's cache
MOST_FOLDERS = 8  # of other sources or processors, before the oldest goes
PACKAGE = __name__.rpartition(".language.")[0]


class Kept(NamedTuple):
    """A kernel as an earlier process found it.

    Attributes:
        places: Where each flat parameter comes from.
        plan: A letter a parameter of the machine code: "a" for an array, "v" for a vector or matrix, "s" for a number.
        layout: The format in which arguments are packed, of `struct`.
        symbol: The machine code's name.
        machine_code: The file that it is in.
    """

    places: list[Place]
    plan: str
    layout: str
    symbol: str
    machine_code: str


def find(module: str, name: str) -> Kept | None:
    """A kernel or sum by the module that it is written in; None where nothing is kept."""
    entry = _read(module).get(name)
    try:
        return entry and Kept([Place(k, tuple(path)) for k, path in entry[0]], *entry[1:])
    except (TypeError, ValueError):  # of other making
        return None


def keep(module: str, name: str, kept: Kept) -> None:
    """Keep a kernel for later processes, where the folder can be written to."""
    path = _path(module)
    if path is None:
        return
    _read.cache_clear()
    entries = {**_read(module), name: list(kept)}
    with contextlib.suppress(OSError):
        if not path.parent.is_dir():
            path.parent.mkdir(parents=True)
            _forget_oldest(path.parent.parent)
        write_atomically(path, json.dumps(entries).encode())
    _read.cache_clear()


def address_of(kept: Kept) -> int:
    """The address of a kernel's machine code, which is loaded; 0 where it is gone, or this Warp loads it otherwise."""
    try:
        llvm = wp._src.context.runtime.llvm
        handle = _handle(kept.machine_code)
        return llvm.wp_lookup(handle, kept.symbol.encode()) if handle else 0
    except (AttributeError, TypeError):
        return 0


def machine_code_of(kernel: Any) -> str:
    """The file of a kernel's machine code in Warp's cache; empty where there is none, or more than one."""
    name = kernel.module.get_module_identifier(block_dim=1)
    found = [str(path) for path in (Path(wp.config.kernel_cache_dir or ".") / name).glob(f"{name}*.o")]
    return found[0] if len(found) == 1 else ""


@cache
def _handle(machine_code: str) -> bytes:
    """The name by which Warp's loader knows a file, which it has loaded; empty where it does not take it."""
    if not is_intact(Path(machine_code)):
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
    """The file that keeps a module's kernels; None where none is kept."""
    folder = _folder()
    return (
        folder / f"{module.removeprefix(PACKAGE + '.')}.json" if folder and module.startswith(f"{PACKAGE}.") else None
    )


@cache
def _folder() -> Path | None:
    """The folder of these sources, this Warp and this processor."""
    try:
        parts = [digest_of_sources(), cpu_code.header(), wp.get_cpu_kernel_cache_key(cpu_compiler_flags=cpu_code.FLAGS)]
    except (AttributeError, OSError):
        return None
    digest = hashlib.sha256("\n".join(parts).encode()).hexdigest()[:16]
    return Path(wp.config.kernel_cache_dir) / FOLDER / digest if wp.config.kernel_cache_dir else None


def _forget_oldest(folder: Path) -> None:
    folders = sorted(folder.iterdir(), key=lambda path: path.stat().st_mtime)
    for path in folders[:-MOST_FOLDERS]:
        shutil.rmtree(path, ignore_errors=True)
