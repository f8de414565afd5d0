"""Compile every CPU kernel ahead: python -m pointloom.kernels.cpu_kernels [--levels x86-64-v3].

Writes kernels/compiled, which wheels contain and `language/cpu_archive.py` reads. The result depends on the sources,
Warp's version and the level, not on this machine.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import json
import shutil
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import lang  # before Warp: it silences the banner
from .cuda_cache import INTERRUPTED_STATUS, find_files, in_processes
from .language import cpu_archive, cpu_code, pool_code
from .language.kernel_cache import machine_code_of
from .language.module_loading import load_module
from .language.prepared_launches import WarpLaunch
from .memory import empty

import warp as wp  # isort: skip


def _zero_of(kind: Any) -> Any:
    """An argument of a type: layouts depend on types only."""
    if isinstance(kind, wp.array):
        return empty((1,) * kind.ndim, kind.dtype, "cpu")
    return kind(0)


def _entry(field_paths: Sequence[Any], kernel: Any) -> list[Any]:
    """Fields of a CachedKernel without the path of the machine code. Raises RuntimeError for unknown layouts."""
    made = WarpLaunch(kernel, [_zero_of(argument.type) for argument in kernel.adj.args])
    if not made.layout:
        raise RuntimeError(f"{kernel.key}: unknown layout of the arguments")
    return [field_paths, made.plan, made.layout, made.symbol]


def compile_file(file: str, level: str, work: Path, output: Path) -> tuple[int, int, float]:
    """Compile a file of kernels into `output`. Returns the number of kernels, bytes and CPU seconds."""
    begin = time.process_time()
    cpu_archive.disable()
    cpu_code.set_target(level)
    wp.config.kernel_cache_dir = str(work)
    importlib.import_module(file)
    if file == pool_code.__name__:
        kernels = {kernel.key: ([], kernel) for kernel in pool_code.PoolCode().kernels}
    else:
        launched = lang.LAUNCHED.get(file, {})
        kernels = {name: (each.field_paths, each.on_host) for name, each in launched.items()}
    if not kernels:
        return 0, 0, 0.0
    for _, kernel in kernels.values():
        load_module(kernel.module, wp.get_device("cpu"))
    paths = {machine_code_of(kernel) for _, kernel in kernels.values()}
    if len(paths) != 1 or "" in paths:
        raise RuntimeError(f"expected one file of machine code, got {sorted(paths)}")
    content = Path(paths.pop()).read_bytes()
    entries = {name: _entry(field_paths, kernel) for name, (field_paths, kernel) in kernels.items()}
    name = cpu_archive.name_of(file)
    (output / f"{name}.o").write_bytes(content)
    text = json.dumps({"sha256": hashlib.sha256(content).hexdigest(), "kernels": entries}, separators=(",", ":"))
    (output / f"{name}.json").write_text(text, encoding="utf-8")
    return len(kernels), len(content) + len(text), time.process_time() - begin


def compile_level(files: Sequence[str], level: str, output: Path) -> None:
    """Compile files for a level, one process per core, and replace its folder. Raises RuntimeError."""
    sums, begin = [0, 0, 0.0], time.perf_counter()
    part = output / f".{level}.part"
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as work:  # a terminated process may still write
        for count, (_, result) in enumerate(in_processes(compile_file, files, level, Path(work), part), 1):
            sums = [total + more for total, more in zip(sums, result, strict=True)]
            if not count % 40:
                print(f"{level}: {count} of {len(files)} files", flush=True)
    (part / cpu_archive.MANIFEST).write_text(json.dumps(cpu_archive.made_from(), indent=1), encoding="utf-8")
    shutil.rmtree(output / level, ignore_errors=True)
    part.rename(output / level)
    kernels, size, seconds = sums
    wall = time.perf_counter() - begin
    print(f"{level}: {kernels} kernels, {size / 1e6:.1f} MB, {seconds:.0f} CPU s, {wall:.0f} s", flush=True)


def main(arguments: Sequence[str]) -> int:
    summary = (__doc__ or "").split("\n")[0]
    parser = argparse.ArgumentParser(prog="python -m pointloom.kernels.cpu_kernels", description=summary)
    levels = list(cpu_archive.LEVELS)
    parser.add_argument("--levels", nargs="+", choices=levels, default=levels, help="of x86-64")
    parser.add_argument("--output", type=Path, default=cpu_archive.FOLDER, help="folder of the compiled kernels")
    parser.add_argument("--only", nargs="+", default=[], metavar="MODULE", help="these modules of kernels only")
    parsed = parser.parse_args(arguments)
    try:
        files = find_files()
        if unknown := sorted(set(parsed.only) - set(files)):
            raise RuntimeError(f"--only: expected modules such as {files[0]}, got {', '.join(unknown)}")
        for level in parsed.levels:
            compile_level(parsed.only or files, level, parsed.output)
    except KeyboardInterrupt:
        return INTERRUPTED_STATUS
    except (RuntimeError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
