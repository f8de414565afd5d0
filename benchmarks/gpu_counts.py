"""Run one operation on the emulated device and write what it counted.

    python benchmarks/gpu_counts.py NAME SIZE FILE [lines] [fast] [89 ...]

A process of its own for each, since the device has to be there before Warp starts. The first call, on few points,
compiles; the second is counted. A number is an architecture whose cubins are read besides those of sm_90.
"""

from __future__ import annotations

import linecache
import os
import sys
import time
import warnings
from collections import Counter
from pathlib import Path
from typing import Any

from gpu_results import keep

ROOT = Path(__file__).parents[1]
SAMPLED_BLOCKS, WARM_UP, MOST_LINES = 24, 2_000, 40


def _install(lines: bool) -> Any:
    os.environ.setdefault("EMULATED_CUDA_COUNTERS", str(SAMPLED_BLOCKS))
    os.environ.setdefault("EMULATED_CUDA_UNINITIALISED", "0")
    os.environ.setdefault("EMULATED_CUDA_MEMORY", str(24 << 30))
    sys.path.append(str(ROOT / "tests"))
    from emulated_cuda.install import install, installed  # pyright: ignore[reportMissingImports]

    install()
    import warp as wp

    import pointloom.kernels.lang  # noqa: F401  before Warp starts: it silences the banner

    wp.config.lineinfo = lines
    wp.init()
    return installed()


def _resources(device: Any) -> dict[str, Any]:
    """Of every kernel that was launched, by symbol; the L1's shares are set from them."""
    from emulated_cuda.gcc import cache_folder  # pyright: ignore[reportMissingImports]
    from gpu_cubins import read_resources
    from gpu_machine import l1_share

    counters, found = device.launches.counters, {}
    launched = {x.module: x for x in counters.launches if x.module}
    for module in launched:
        found |= read_resources(module, counters.expected, cache_folder())
    for x in counters.launches:
        if x.symbol in found:
            counters.l1_shares[x.symbol] = l1_share(found[x.symbol], x.threads, x.shared_bytes)
    return found


def _lines(counters: Any) -> list[dict[str, Any]]:
    """The source lines that give out most instructions, with their text."""
    found = sorted(counters.places.items(), key=lambda item: -item[1].instructions)[:MOST_LINES]
    rows = []
    for (kernel, place), counts in found:
        path, _, line = place.rpartition(":")
        name = path[path.index("<") :] if "<" in path else path  # a generated source
        text = linecache.getline(name, int(line)).strip()
        rows.append({"kernel": kernel, "place": f"{Path(name).name}:{line}", "text": text, **vars(counts)})
    return rows


def _resources_of(device: Any, launches: list[Any], own: dict[str, Any], architecture: int) -> dict[str, Any]:
    """What cubins for another architecture say, of the kernels that hold or spill other registers there."""
    from emulated_cuda.gcc import cache_folder  # pyright: ignore[reportMissingImports]
    from gpu_cubins import read_resources

    found: dict[str, Any] = {}
    for module in {x.module for x in launches if x.module}:
        found |= read_resources(module, device.launches.counters.expected, cache_folder(), architecture)
    used = {x.symbol for x in launches}

    def held(r: Any) -> tuple[int, int, bool]:
        return r.registers, r.local_bytes, bool(r.code)

    return {symbol: vars(r) for symbol, r in found.items() if symbol in used and held(r) != held(own[symbol])}


def _drop_depths(launches: list[Any], resources: dict[str, Any], others: dict[str, Any]) -> None:
    """Drop what nothing asks for: instructions by depth of kernels whose cubins neither spill nor are large."""
    asked = {symbol for symbol, r in resources.items() if r.code}
    asked |= {symbol for found in others.values() for symbol, values in found.items() if values["code"]}
    for x in launches:
        if x.symbol not in asked:
            x.issued_by_depth, x.code_by_depth = [], []


def count(name: str, size: int, *, lines: bool, fast: bool, architectures: list[int]) -> dict[str, Any]:
    """The counts of one call, those of source lines too if they are asked for."""
    device = _install(lines)
    import warp as wp
    from emulated_cuda.counters import as_rows  # pyright: ignore[reportMissingImports]
    from emulated_cuda.settings import settings  # pyright: ignore[reportMissingImports]
    from gpu_operations import OPERATIONS
    from gpu_results import merged

    counters = device.launches.counters
    operation = OPERATIONS[name]
    operation.prepare(min(WARM_UP, size))()
    wp.synchronize()
    resources = _resources(device)
    call = operation.prepare(size)
    wp.synchronize()
    counters.launches.clear()
    counters.known.clear()
    counters.places.clear()
    if fast:
        settings.counted_alone = operation.last
    before, start = Counter(device.findings.counts), time.perf_counter()
    result = call()
    wp.synchronize()
    seconds = time.perf_counter() - start
    launches = counters.launches[:-1]  # the last is the wait above
    if {x.symbol for x in launches if x.symbol} - set(resources):
        resources |= _resources(device)
    host = Counter(device.findings.counts)
    host.subtract(before)
    host["waits"] -= 1
    del result
    used = {x.symbol for x in launches}
    others = {str(a): _resources_of(device, launches, resources, a) for a in architectures}
    _drop_depths(launches, resources, others)
    return {
        **({"lines": _lines(counters)} if lines else {}),
        "operation": name,
        "size": size,
        "emulated_seconds": round(seconds, 2),
        "host": dict(host),
        "resources": {s: vars(r) for s, r in resources.items() if s in used},
        "resources_of": others,
        "launches": merged([{k: v for k, v in x.items() if k != "module"} for x in as_rows(launches)]),
    }


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    words = sys.argv[4:]
    others = [int(word) for word in words if word.isdigit()]
    found = count(sys.argv[1], int(sys.argv[2]), lines="lines" in words, fast="fast" in words, architectures=others)
    keep(Path(sys.argv[3]), found)
