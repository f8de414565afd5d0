"""GPUs as a model: how long a launch takes, from what the emulated device counted of it.

A launch takes as long as what binds it: giving out instructions, a unit of the SM, turns in the L1, bytes from the L2
or from memory, fetching code, or waiting, where too few warps are there to wait together. What differs between chips is
in gpu_chips.py; none of it was fitted to a measurement of pointloom, but for what a person took over from a GPU.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from gpu_chips import H200, Chip

RESERVED_SHARED = 1 << 10  # bytes of a block, by the driver
EFFICIENCY = 0.8  # of what binds: no kernel keeps one unit busy all the time
SORT_SHARE = 0.7  # of the memory's bandwidth: Warp's radix sort (CUB) writes scattered; passes take a launch each
COPIES = {  # copies between host and device: the chip's field that says how fast
    "(copy to host)": "link_fresh",
    "(copy to device)": "link_pageable",
    "(pinned copy to host)": "link_pinned",
    "(pinned copy to device)": "link_pinned",
}
STAGED = 64 << 10  # bytes: the driver sends smaller copies of pageable memory through memory of its own that is pinned
MOST_RATIO = 1.4  # of 45 kernels all but two have 0.78 to 1.42 of the instructions expected; those are unrolled loops
FEW = 8  # rounds of blocks above which the last one, partly filled, is as good as none
LINE, SECTOR = 128, 32
# Spills and code, which nothing was measured of: loads of spilled registers that the assembler has wait together; bytes
# of an instruction; how often a loop's code runs in a warp before it is hot
SPILLS_TOGETHER, INSTRUCTION_BYTES, HOT_RUNS = 4, 16, 2


@dataclass(frozen=True)
class Resources:
    """What a kernel's cubin says; lists go by the depth of loops, 0 outside of all."""

    registers: int = 32
    local_bytes: int = 0
    instructions: int = 0  # of the machine
    statements: int = 0  # cost of its PTX by the table of costs: instructions, each counted once
    code: list[int] = field(default_factory=list)  # instructions of the machine
    local_loads: list[int] = field(default_factory=list)  # of them: words that a lane loads from local memory
    local_stores: list[int] = field(default_factory=list)

    @property
    def instruction_ratio(self) -> float:
        """Instructions of the machine for one that the table of costs expects."""
        return min(max(self._raw_ratio, 1 / MOST_RATIO), MOST_RATIO)

    @property
    def turns_together(self) -> float:
        """Turns of a loop whose loads wait together, where the assembler has unrolled it: the code is longer."""
        return self._raw_ratio if self._raw_ratio > MOST_RATIO else 1.0

    @property
    def _raw_ratio(self) -> float:
        return self.instructions / self.statements if self.statements and self.instructions else 1.0


def resident_blocks(resources: Resources, threads: int, shared: int, chip: Chip = H200) -> int:
    """Blocks of threads that an SM holds at once."""
    warps = -(-threads // 32)
    registers = -(-resources.registers * 32 // 256) * 256 * warps
    by_shared = (chip.shared_bytes + RESERVED_SHARED) // (shared + RESERVED_SHARED)
    return max(1, min(chip.blocks, chip.warps // warps, chip.registers // registers, by_shared))


def l1_share(resources: Resources, threads: int, shared: int, chip: Chip = H200) -> int:
    """Bytes of the L1 for each block, if all that fit are there."""
    blocks = resident_blocks(resources, threads, shared, chip)
    return max(chip.l1_bytes // blocks - shared - RESERVED_SHARED, 4 << 10)


@dataclass
class Prediction:
    """One launch: seconds that each limit asks for, and what binds."""

    seconds: float
    limits: dict[str, float]
    occupancy: float = 0.0  # share of an SM's warps that can be there; of the whole chip where blocks are few
    spilled: float = 0.0  # bytes of spilled registers, loaded and stored
    lost: float = 0.0  # bytes from and to memory that other resident warps push out of the L2

    @property
    def bound(self) -> str:
        return max(self.limits, key=lambda name: self.limits[name]) if self.limits else "overhead"


def _rounds(blocks: int, at_once: int) -> float:
    """How often so many blocks fill the places that they have."""
    exact = blocks / at_once
    return exact if exact > FEW else math.ceil(exact)


def _unit_cycles(units: dict[str, float], chip: Chip) -> dict[str, float]:
    """Cycles of each unit; sums of integers go to the less busy of the two that can add."""
    found = {"instructions": units.get("issued", 0.0)} | {
        u: units.get(u, 0.0) for u in ("alu", "fma", "fp64", "xu", "lsu")
    }
    found["fp64"] *= chip.fp64_cycles
    moved = min(max((found["alu"] + units.get("sums", 0.0) - found["fma"]) / 2, 0.0), units.get("sums", 0.0))
    found["fma"] += moved
    found["alu"] += units.get("sums", 0.0) - moved
    return found


@dataclass(frozen=True)
class _Spills:
    """Spilled registers of a warp: how often it loads and stores a word for all its lanes, and what the L1 keeps."""

    loads: float = 0.0
    stores: float = 0.0
    missed: float = 0.0  # share that goes to the L2
    footprint: float = 0.0  # bytes of a warp

    @property
    def requests(self) -> float:
        return self.loads + self.stores


def _runs(x: dict[str, Any], resources: Resources) -> list[tuple[int, float]]:
    """By depth of loops in the cubin: instructions of the code, and how many a warp gives out of them.

    The PTX's loops are others than the cubin's: some are unrolled, some turn once. So the code that runs most often is
    taken for the deepest, share by share of all code, down to what never ran.
    """
    ran = list(zip(x.get("issued_by_depth") or [], x.get("code_by_depth") or [], strict=False))
    statements, code = max(resources.statements, sum(c for _, c in ran)), sum(resources.code)
    if not statements or not code:
        return [(c, 0.0) for c in resources.code]
    parts = sorted(((issued / c, c / statements) for issued, c in ran if c), reverse=True)
    found = []
    for own in reversed(resources.code):
        left, total = own / code, 0.0
        while left > 0 and parts:
            often, share = parts[0]
            taken = min(left, share)
            total, left = total + often * taken * statements, left - taken
            parts[:1] = [(often, share - taken)] if share > taken else []
        found.append((own, resources.instruction_ratio * total))
    return found[::-1]


def _spills(x: dict[str, Any], resources: Resources, resident_warps: int, chip: Chip) -> _Spills:
    """An instruction in a loop is a spill as often as the loop's code is: so the unrolled ones are counted rightly."""

    def times(counts: list[int]) -> float:
        pairs = zip(counts, _runs(x, resources), strict=False)
        return sum(count / code * run for count, (code, run) in pairs if code)

    footprint = resources.local_bytes * 32
    held = max(chip.l1_bytes - (x["shared_bytes"] + RESERVED_SHARED), 0)
    missed = max(0.0, 1 - held / (footprint * resident_warps)) if footprint else 0.0
    return _Spills(times(resources.local_loads), times(resources.local_stores), missed, footprint)


def _fetched(x: dict[str, Any], resources: Resources, chip: Chip) -> float:
    """Bytes of code that a block fetches anew, its warps close together: of loops that the cache cannot hold."""
    often = [(code, run) for code, run in _runs(x, resources) if run >= HOT_RUNS * code]
    size = INSTRUCTION_BYTES * sum(code for code, _ in often)
    share = max(0.0, 1 - chip.code_bytes / size) if size else 0.0
    return share * INSTRUCTION_BYTES * sum(run for _, run in often)


def predict_kernel(x: dict[str, Any], resources: Resources, chip: Chip = H200) -> Prediction:
    """A launch of a kernel; `x` is its LaunchCounts."""
    blocks, warps_of_block = x["blocks"], -(-x["threads"] // 32)
    resident = resident_blocks(resources, x["threads"], x["shared_bytes"], chip)
    warps_of_sm = _rounds(blocks, chip.sms) * warps_of_block
    warps_of_scheduler = max(warps_of_sm / chip.schedulers, 1.0)
    ratio, total = resources.instruction_ratio, blocks * warps_of_block
    resident_warps = min(total, chip.sms * resident * warps_of_block)
    spills = _spills(x, resources, min(resident_warps, resident * warps_of_block), chip)
    limits = {}
    for unit, cycles in _unit_cycles(x["units"], chip).items():
        factor = 1.0 if unit == "lsu" else ratio
        limits[unit] = warps_of_scheduler * cycles * factor / chip.clock
    traffic = x["traffic"]
    wavefronts = sum(t["wavefronts"] for t in traffic.values()) + spills.requests
    limits["L1"] = warps_of_sm * wavefronts / chip.clock
    missed_spills = LINE * total * spills.requests * spills.missed
    missed = SECTOR * total * sum(t["missed"] for t in traffic.values()) + missed_spills
    limits["L2"] = max(missed / chip.l2_bandwidth, missed / total * warps_of_sm / chip.fill_bytes / chip.clock)
    share = _lost_share(x, spills, resident_warps, chip)
    read_again = share * (SECTOR * total * x.get("own_loads", 0.0) + LINE * total * spills.loads * spills.missed)
    written_again = share * (SECTOR * total * x.get("own_stores", 0.0) + LINE * total * spills.stores * spills.missed)
    in_memory = min(x["memory_reads"] + read_again, missed) / missed if missed else 0.0
    lost = read_again + written_again
    limits["memory"] = (x["memory_reads"] + x["memory_writes"] + lost) / chip.memory_bandwidth
    beyond = in_memory * chip.memory_cycles + (1 - in_memory) * chip.l2_cycles
    spilled_waits = spills.loads / SPILLS_TOGETHER * (spills.missed * beyond + (1 - spills.missed) * chip.l1_cycles)
    waits = (x["hits"] * chip.l1_cycles + x["misses"] * beyond) / resources.turns_together
    warp = x["chain"] * ratio + waits + spilled_waits
    limits["latency"] = _rounds(blocks, chip.sms * resident) * warp * x["imbalance"] / chip.clock
    limits["code"] = _rounds(blocks, chip.sms) * _fetched(x, resources, chip) / chip.fill_bytes / chip.clock
    atomics = total * traffic.get("global atomic", {}).get("lanes", 0.0)
    limits["atomics"] = max(x["hot_atomics"] / chip.atomic_rate, atomics / chip.atomics_rate) / chip.clock
    there = min(resident * warps_of_block, chip.warps) * min(1.0, blocks / (chip.sms * resident))
    spilled = LINE * total * spills.requests
    return Prediction(max(limits.values()) / EFFICIENCY, limits, there / chip.warps, spilled, lost)


def _lost_share(x: dict[str, Any], spills: _Spills, resident_warps: int, chip: Chip) -> float:
    """Share of what a warp wrote that is no longer in the L2 when it loads it again.

    The counts do not know it: there the warps run one after the other. Here all resident warps' own data are walked
    through again and again, and a cache keeps what fits.
    """
    footprint = resident_warps * (SECTOR * x.get("own_sectors", 0.0) + spills.footprint * spills.missed)
    return max(0.0, 1 - chip.l2_bytes / footprint) if footprint else 0.0


def predict_other(x: dict[str, Any], chip: Chip = H200) -> tuple[Prediction, int]:
    """Warp's own functions, copies and fills: the prediction, and how many launches they are."""
    name, moved = x["kernel"], x["bytes_read"] + x["bytes_written"]
    if name == "(radix sort)":
        seconds = moved / (SORT_SHARE * chip.memory_bandwidth)
        return Prediction(seconds, {"memory": seconds}), 7
    if name in COPIES:
        seconds = moved / (chip.link_pinned if moved <= STAGED else getattr(chip, COPIES[name]))
        return Prediction(seconds, {"link": seconds}), 1
    if name in ("(wait)", "(graph launch)", "(graph made)", "(turn of a loop)"):
        return Prediction(chip.loop_turn if name == "(turn of a loop)" else 0.0, {}), 0
    seconds = moved / chip.memory_bandwidth
    return Prediction(seconds, {"memory": seconds}), 2 if name == "(scan)" else 1


def host_seconds(x: dict[str, Any], chip: Chip = H200) -> float:
    """What the host does for a launch, before the device can begin."""
    if x["in_graph"] or x["kernel"] == "(wait)":
        return 0.0
    if x["kernel"] == "(graph made)":
        return chip.graph_made + chip.graph_made_node * x["nodes"]
    if x["kernel"] == "(graph launch)":
        return chip.host_graph
    return chip.host_copy if x["kernel"].startswith("(") else chip.host_launch


@dataclass
class Timeline:
    """A call, launch after launch: the device's time alone, and the caller's, in which the host can be the slower.

    Copies from and to the host are in the caller's alone. `factor` makes the host's steps as long as they were measured
    to be where that is known; `before` is what it does besides, allocations above all.
    """

    chip: Chip = H200
    factor: float = 1.0
    before: float = 0.0
    device: float = 0.0
    host_clock: float = 0.0
    device_clock: float = 0.0
    waits: int = 0
    is_idle: bool = False  # nothing has been given to the device since the last wait

    def __post_init__(self) -> None:
        self.host_clock += self.before

    def add(self, x: dict[str, Any], seconds: float, launches: int) -> None:
        """Append a launch, or several that are alike."""
        gap = launches * (self.chip.graph_node if x["in_graph"] else self.chip.launch)
        name, times = x["kernel"], x.get("times", 1)
        self.device += times * (seconds + gap) if name not in COPIES else 0.0
        self.host_clock += times * self.factor * host_seconds(x, self.chip)
        self.device_clock = max(self.device_clock, self.host_clock) + times * (seconds + gap)
        if name == "(copy to host)" or (name == "(wait)" and not self.is_idle):
            self.waits += times
            self.host_clock = max(self.host_clock, self.device_clock) + times * self.chip.wait
            self.is_idle = True
        elif launches:
            self.is_idle = False

    @property
    def call(self) -> float:
        """Seconds until the call's last launch has ended."""
        return max(self.host_clock, self.device_clock)
