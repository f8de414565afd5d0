"""Counts of each launch: what its warps ran and what they asked of memory (EMULATED_CUDA_COUNTERS).

Some blocks of threads of a launch are sampled: their threads leave traces, from which their warps run again with lanes
that part and meet (runtime/counters.c). Every access of every thread goes through a model of the L2. What a launch was
is a `LaunchCounts`; sums over a warp's blocks are scaled to all warps by who reads them.
"""

from __future__ import annotations

import ctypes
import functools
import itertools
import json
import math
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from . import ptx
from .ptx.blocks import ACCESSES, SPACES
from .ptx.costs import UNITS
from .settings import settings

SECTOR, LINE = 32, 128
L2_BYTES = 40 << 20  # of an H200's 50 MB: its two halves keep copies of what the other asks for
L1_BYTES = 224 << 10  # of an SM's 256 KB, shared memory included
HIT_CYCLES, MISS_CYCLES = 36, 350  # until a load's value is there: from the L1, and beyond it on average
OFTEN = 32  # launches of one kernel after which only every sixteenth is sampled
FIELDS = ("requests", "lanes", "bytes", "sectors", "wavefronts", "missed")


class Traffic(ctypes.Structure):
    """`struct Traffic` of runtime/counters.h."""

    _fields_ = tuple((name, ctypes.c_uint64) for name in FIELDS)


class State(ctypes.Structure):
    """`struct Counters` of runtime/counters.h."""

    _fields_ = (
        *((name, ctypes.c_uint32) for name in ("block_count", "site_count")),
        *((name, ctypes.c_void_p) for name in ("meets", "after_call", "cycles", "issued")),
        *((name, ctypes.c_void_p) for name in ("space", "size", "access", "level")),
        *((name, ctypes.c_uint64) for name in ("first", "every")),
        *((name, ctypes.c_uint32) for name in ("l1_lines", "alone", "hit_cycles", "miss_cycles")),
        *((name, ctypes.c_void_p) for name in ("issues", "lanes", "sites")),
        ("traffic", Traffic * 9),
        *((name, ctypes.c_uint64) for name in ("blocks", "warps", "chain", "hits", "misses", "longest", "slowest")),
        *((name, ctypes.c_uint64) for name in ("cut", "hot_atomics")),
    )


@dataclass
class LaunchCounts:
    """One launch, or one of Warp's own device functions.

    What is named `per_warp` is a mean over the sampled warps: cycles of a scheduler by unit, and so on. Bytes of
    memory are of the whole launch.
    """

    kernel: str
    symbol: str = ""  # of the kernel in its module
    module: str = ""  # the file of its PTX
    blocks: int = 0
    threads: int = 0  # of a block
    shared_bytes: int = 0  # of a block
    in_graph: bool = False
    sampled_warps: int = 0
    units: dict[str, float] = field(default_factory=dict)  # per warp: cycles by unit; `issued` are instructions
    lane_statements: float = 0.0  # per warp: statements of PTX times lanes that ran them
    warp_statements: float = 0.0  # per warp: statements of PTX
    traffic: dict[str, dict[str, float]] = field(default_factory=dict)  # per warp, by "global load" and so on
    chain: float = 0.0  # per warp: cycles of instructions that wait for each other
    hits: float = 0.0  # per warp: waits for loads that the L1 has
    misses: float = 0.0  # per warp: waits for loads from beyond it
    imbalance: float = 1.0  # slowest warp of a block against the mean
    slowest: float = 0.0  # cycles of the slowest warp that was sampled
    memory_reads: int = 0  # bytes, by the model of the L2
    memory_writes: int = 0
    bytes_read: int = 0  # of what is no kernel: asked for
    bytes_written: int = 0
    nodes: int = 0  # of a graph that is made
    hot_atomics: float = 0.0  # at the one address that most go to, scaled to the launch
    own_sectors: float = 0.0  # per warp: sectors that it writes and then loads from beyond the L1
    own_loads: float = 0.0  # per warp: sectors of these, load by load
    own_stores: float = 0.0
    issued_by_depth: list[float] = field(default_factory=list)  # per warp: instructions, by how many loops they are in
    code_by_depth: list[int] = field(default_factory=list)  # instructions of the code of these, each once
    cut: int = 0  # lanes whose trace was too long

    @property
    def warps(self) -> int:
        return self.blocks * -(-self.threads // 32)

    @property
    def active_lanes(self) -> float:
        """Share of a warp's lanes that ran its instructions."""
        return self.lane_statements / (32 * self.warp_statements) if self.warp_statements else 1.0


@dataclass
class PlaceCounts:
    """What all warps of a kernel's launches did in one line of the source."""

    instructions: float = 0.0
    statements: float = 0.0
    lane_statements: float = 0.0
    requests: float = 0.0
    sectors: float = 0.0
    wavefronts: float = 0.0


class Tables:
    """What the runtime has to know of a module, in its form."""

    def __init__(self, described: dict[str, Any]):
        blocks, sites = described["blocks"], described["sites"]
        self.blocks, self.sites, self.functions = blocks, sites, described["functions"]

        def array(kind: Any, values: Iterator[int]) -> Any:
            found = list(values)
            return (kind * max(len(found), 1))(*found)

        self.arrays = {
            "meets": array(ctypes.c_int32, (b["meets"] for b in blocks)),
            "after_call": array(ctypes.c_int32, (b["after_call"] for b in blocks)),
            "cycles": array(ctypes.c_uint32, (b["cycles"] for b in blocks)),
            "issued": array(ctypes.c_uint32, (b["units"]["issued"] for b in blocks)),
            **{name: array(ctypes.c_uint8, (s[name] for s in sites)) for name in ("space", "size", "access", "level")},
            "issues": array(ctypes.c_uint64, (0 for _ in blocks)),
            "lanes": array(ctypes.c_uint64, (0 for _ in blocks)),
            "sites": (Traffic * max(len(sites), 1))(),
        }


class Counters:
    """Counts launches, if the settings ask for it."""

    def __init__(self, runtime: ctypes.CDLL):
        self.runtime = runtime
        self.launches: list[LaunchCounts] = []
        self.known: dict[str, tuple[int, LaunchCounts]] = {}  # by kernel: launches so far, and the last sampled one
        self.expected: dict[str, int] = {}  # instructions of the machine in each kernel's code, by symbol
        self.l1_shares: dict[str, int] = {}  # bytes that a block has for itself, by kernel; all of it where not said
        self.reads, self.writes = ctypes.c_uint64(), ctypes.c_uint64()
        self.places: dict[tuple[str, str], PlaceCounts] = {}  # by kernel and line, of modules that know their lines

    def touch(self, address: int, size: int, *, write: bool) -> None:
        """Bytes that something else than a kernel reads or writes."""
        self.runtime.emulator_touch_range(ctypes.c_uint64(address), ctypes.c_uint64(size), ctypes.c_uint32(write))

    @contextmanager
    def other(self, name: str, in_graph: bool, **values: Any) -> Iterator[None]:
        """A launch that is none of a kernel: Warp's own functions, copies, fills."""
        self.runtime.emulator_count(None, L2_BYTES // SECTOR)
        yield
        found = LaunchCounts(name, in_graph=in_graph, **values)
        self._take_memory(found)
        self.launches.append(found)

    @contextmanager
    def launch(
        self, found: Any, grid: tuple[int, int, int], threads: int, shared: int, in_graph: bool
    ) -> Iterator[None]:
        """Count what runs meanwhile as a launch of a kernel."""
        self.expected[found.kernel.name] = found.tables.functions[found.kernel.name]
        times, last = self.known.get(found.name, (0, None))
        counts = LaunchCounts(found.name, found.kernel.name, found.module, math.prod(grid), threads, shared, in_graph)
        state = None
        if last is None or times < OFTEN or times % 16 == 0:
            state = self._state(found, counts, times)
        self.runtime.emulator_count(ctypes.byref(state) if state else None, L2_BYTES // SECTOR)
        yield
        if state is not None:
            self._take(found, state, counts)
        elif last is not None:
            kept = ("units", "lane_statements", "warp_statements", "traffic", "chain", "hits", "misses", "imbalance")
            for name in (
                *kept,
                "slowest",
                "own_sectors",
                "own_loads",
                "own_stores",
                "issued_by_depth",
                "code_by_depth",
            ):
                setattr(counts, name, getattr(last, name))
        self._take_memory(counts, counts.warps / state.warps if state is not None and state.alone else 1.0)
        self.known[found.name] = times + 1, (counts if state is not None else last or counts)
        self.launches.append(counts)

    def _state(self, found: Any, counts: LaunchCounts, times: int) -> State:
        tables, state = found.tables, State()
        for name, array in tables.arrays.items():
            setattr(state, name, ctypes.addressof(array))
        state.block_count, state.site_count = len(tables.blocks), len(tables.sites)
        state.every = max(1, counts.blocks // max(settings.counters, 1))
        state.first = (times * 7919 + state.every // 2) % state.every
        state.l1_lines = self.l1_shares.get(found.kernel.name, L1_BYTES) // LINE
        state.hit_cycles, state.miss_cycles = HIT_CYCLES, MISS_CYCLES
        state.alone = bool(settings.counted_alone and re.fullmatch(settings.counted_alone, found.name))
        for name in ("issues", "lanes", "sites"):
            ctypes.memset(tables.arrays[name], 0, ctypes.sizeof(tables.arrays[name]))
        return state

    def _take(self, found: Any, state: State, counts: LaunchCounts) -> None:
        self.runtime.emulator_hot_atomics()
        warps, tables = max(state.warps, 1), found.tables
        counts.sampled_warps, counts.cut = state.warps, state.cut
        units = dict.fromkeys(UNITS, 0.0)
        for issues, lanes, block in zip(tables.arrays["issues"], tables.arrays["lanes"], tables.blocks, strict=False):
            if issues:
                for unit, cycles in block["units"].items():
                    units[unit] += issues * cycles
                counts.warp_statements += issues * block["statements"] / warps
                counts.lane_statements += lanes * block["statements"] / warps
        counts.units = {unit: cycles / warps for unit, cycles in units.items()}
        for k in range(9):
            if state.traffic[k].requests:
                name = f"{SPACES[k // 3]} {ACCESSES[k % 3]}"
                counts.traffic[name] = {f: getattr(state.traffic[k], f) / warps for f in FIELDS}
        counts.chain, counts.hits, counts.misses = state.chain / warps, state.hits / warps, state.misses / warps
        mean = state.chain / warps + (HIT_CYCLES * state.hits + MISS_CYCLES * state.misses) / warps
        counts.imbalance = state.longest / max(state.blocks, 1) / mean if mean else 1.0
        counts.slowest = float(state.slowest)
        counts.hot_atomics = state.hot_atomics * counts.warps / warps
        own = (ctypes.c_uint64 * 3)()
        self.runtime.emulator_own(own)
        counts.own_sectors, counts.own_loads, counts.own_stores = (x / warps for x in own)
        issued, counts.code_by_depth = self._by_depth(tables)
        counts.issued_by_depth = [x / warps for x in issued]
        self._take_places(found, tables, counts.warps / warps)

    def _by_depth(self, tables: Tables) -> tuple[list[float], list[int]]:
        """Instructions of the sampled warps by how many loops, of those that led back, hold them; and their code's."""
        count = len(tables.blocks)
        ends = (ctypes.c_uint32 * max(count, 1))()
        self.runtime.emulator_loops(ends, ctypes.c_uint32(count))
        starts = [0] * (count + 1)
        for first, end in enumerate(ends[:count]):
            if end:
                starts[first] += 1
                starts[end] -= 1
        issued: list[float] = []
        code: list[int] = []
        depths = itertools.accumulate(starts)
        for depth, issues, block in zip(depths, tables.arrays["issues"], tables.blocks, strict=False):
            if issues:
                issued += [0.0] * (depth + 1 - len(issued))
                code += [0] * (depth + 1 - len(code))
                issued[depth] += issues * block["units"]["issued"]
                code[depth] += block["units"]["issued"]
        return issued, code

    def _take_places(self, found: Any, tables: Tables, scale: float) -> None:
        def place(name: str) -> PlaceCounts:
            return self.places.setdefault((found.name, name), PlaceCounts())

        for issues, lanes, block in zip(tables.arrays["issues"], tables.arrays["lanes"], tables.blocks, strict=False):
            for name, (instructions, statements) in block["places"].items() if issues else ():
                to = place(name)
                to.instructions += scale * issues * instructions
                to.statements += scale * issues * statements
                to.lane_statements += scale * lanes * statements
        for traffic, site in zip(tables.arrays["sites"], tables.sites, strict=False):
            if traffic.requests and site["place"]:
                to = place(site["place"])
                to.requests += scale * traffic.requests
                to.sectors += scale * traffic.sectors
                to.wavefronts += scale * traffic.wavefronts

    def _take_memory(self, counts: LaunchCounts, scale: float = 1.0) -> None:
        self.runtime.emulator_level2(ctypes.byref(self.reads), ctypes.byref(self.writes))
        counts.memory_reads = round(scale * SECTOR * self.reads.value)
        counts.memory_writes = round(scale * SECTOR * self.writes.value)
        self.runtime.emulator_count(None, L2_BYTES // SECTOR)


def described(translation: ptx.Translation) -> dict[str, Any]:
    """The tables of a counted module, for JSON."""
    assert translation.counted is not None
    return translation.counted.described()


@functools.cache
def tables_of(path: Path) -> Tables:
    """The tables that were kept beside a module's library."""
    return Tables(json.loads(path.read_text()))


def as_rows(launches: list[LaunchCounts]) -> list[dict[str, Any]]:
    """For JSON."""
    return [asdict(x) for x in launches]
