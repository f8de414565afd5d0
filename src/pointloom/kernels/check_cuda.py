"""Compile every kernel for CUDA without a GPU: python -m pointloom.kernels.check_cuda [90] [module ...].

A number is an architecture (90 for sm_90), by default all of CI_ARCHITECTURES. Prints one line per module with kernels,
cubin sizes and seconds. Then lists the kernels that use local memory or many registers. Warp ships NVRTC.
"""

from __future__ import annotations

import functools
import importlib
import multiprocessing
import pkgutil
import struct
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

from . import lang  # before Warp: it silences the banner
from .language.cpu_pool import usable_cores
from .language.warp_compiler import modules_for_cuda

import warp as wp  # isort: skip

CI_ARCHITECTURES = (75, 90, 120)  # the oldest tested by CI, the current data center, the newest
MANY_REGISTERS = 128  # above, at most half of an SM's threads are in flight

EIATTR_REGISTERS, EIATTR_FRAME = 0x2F, 0x11
SIZED_VALUE = 0x04  # format code of attributes with a payload


class Usage(NamedTuple):
    """Registers and local memory of a thread, shared memory of a block (Warp's template declares a word per thread)."""

    registers: int
    local_bytes: int
    shared_bytes: int


class Compiled(NamedTuple):
    sizes: dict[int, int]
    usage: dict[int, dict[str, Usage]]
    seconds: float


def read_usage(cubin: bytes) -> dict[str, Usage]:
    """Registers, local and shared memory of each kernel, from the ELF64 sections .nv.info, .nv.shared.* and .symtab."""
    table, entry_size, count, names_at = struct.unpack_from("<Q", cubin, 40) + struct.unpack_from("<3H", cubin, 58)
    sections = [struct.unpack_from("<IIQQQQII", cubin, table + k * entry_size) for k in range(count)]

    def text(strings: tuple, offset: int) -> str:
        start = strings[4] + offset
        return cubin[start : cubin.index(b"\0", start)].decode()

    named = {text(sections[names_at], s[0]): s for s in sections}
    symbols, strings = named[".symtab"], named[".strtab"]
    attributes: dict[int, dict[int, int]] = {EIATTR_REGISTERS: {}, EIATTR_FRAME: {}}
    position, end = named[".nv.info"][4], named[".nv.info"][4] + named[".nv.info"][5]
    while position < end:
        kind, attribute, size = struct.unpack_from("<BBH", cubin, position)
        if kind == SIZED_VALUE and attribute in attributes:
            symbol, value = struct.unpack_from("<II", cubin, position + 4)
            attributes[attribute][symbol] = value
        position += 4 + (size if kind == SIZED_VALUE else 0)
    usage = {}
    for symbol, registers in attributes[EIATTR_REGISTERS].items():
        name = text(strings, struct.unpack_from("<I", cubin, symbols[4] + 24 * symbol)[0])
        shared = named.get(f".nv.shared.{name}", (0,) * 8)[5]
        usage[name] = Usage(registers, attributes[EIATTR_FRAME].get(symbol, 0), shared)
    return usage


def compile_module(name: str, architectures: tuple[int, ...] = CI_ARCHITECTURES) -> Compiled:
    start = time.perf_counter()
    sizes = dict.fromkeys(architectures, 0)
    usage: dict[int, dict[str, Usage]] = {architecture: {} for architecture in architectures}
    for module in modules_for_cuda(name) or [name]:  # Warp reports files without kernels
        with tempfile.TemporaryDirectory() as folder:
            paths = wp.compile_aot_module(module, arch=list(architectures), module_dir=folder, use_ptx=False)
            for architecture, path in zip(architectures, paths, strict=True):
                cubin = Path(path).read_bytes()
                sizes[architecture] += len(cubin)
                usage[architecture] |= read_usage(cubin)
    return Compiled(sizes, usage, time.perf_counter() - start)


def report_heavy(compiled: Compiled) -> list[str]:
    """One line per kernel that uses local memory or many registers, with the worst architecture."""
    lines = []
    for name in sorted(next(iter(compiled.usage.values()))):
        each = {a: usage[name] for a, usage in compiled.usage.items() if name in usage}
        registers, local = max(u.registers for u in each.values()), max(u.local_bytes for u in each.values())
        if registers > MANY_REGISTERS or local:
            notes = [f"{local} B of local memory"] if local else []
            plain = name.removesuffix("_cuda_kernel_forward").rpartition("_")[0]
            lines.append(f"    {plain}: {', '.join([f'{registers} registers', *notes])}")
    return lines


def check_module(
    name: str, *, architectures: tuple[int, ...] = CI_ARCHITECTURES, may_be_empty: bool = False
) -> tuple[int, list[str], str]:
    """Compile one module. Return its kernel count, report lines and errors. No lines for a module without kernels."""
    try:
        importlib.import_module(name)
        if may_be_empty and name not in lang.LAUNCHED:
            return 0, [], ""
        lang.resolve_module(name)
        if name in lang.LAUNCHED and not modules_for_cuda(name):
            return 0, [f"{name}: kernels for the CPU alone"], ""
        compiled = compile_module(name, architectures)
    except Exception as error:  # a language rule, NVRTC, an unknown module name: all are findings
        return 0, [], f"{name}: FAILED\n{type(error).__name__}: {error}"
    count = len(next(iter(compiled.usage.values())))
    sizes = ", ".join(f"sm_{a} {size:,} B" for a, size in compiled.sizes.items())
    line = f"{name}: {count} kernel{'s' * (count != 1)}, {sizes}, {compiled.seconds:.1f} s"
    return count, [line, *report_heavy(compiled)], ""


def check_package(architectures: tuple[int, ...]) -> Iterator[tuple[int, list[str], str]]:
    """Compile the whole package in one process per core (NVRTC is single-threaded). Results are in module order."""
    package = importlib.import_module(__package__ or "pointloom.kernels")
    modules = [m.name for m in pkgutil.walk_packages(package.__path__, package.__name__ + ".")]
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(usable_cores(), spawn) as pool:
        yield from pool.map(functools.partial(check_module, architectures=architectures, may_be_empty=True), modules)


def main(words: list[str]) -> int:
    names = [word for word in words if not word.isdecimal()]
    architectures = tuple(int(word) for word in words if word.isdecimal()) or CI_ARCHITECTURES
    failures, kernels, start = 0, 0, time.perf_counter()
    for count, lines, failure in (
        (check_module(name, architectures=architectures) for name in names) if names else check_package(architectures)
    ):
        kernels += count
        failures += bool(failure)
        for line in lines:
            print(line, flush=True)
        if failure:
            print(failure, file=sys.stderr, flush=True)
    print(f"{kernels} kernels compiled in {time.perf_counter() - start:.1f} s, modules failed: {failures}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
