"""An H200 as a model: how long a launch takes, from what the emulated device counted of it.

A launch takes as long as what binds it: giving out instructions, a unit of the SM, turns in the L1, bytes from the L2
or from memory, or waiting, where too few warps are there to wait together. All constants are here, with where they are
from; none was fitted to a measurement of pointloom, since none was made on a GPU.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

# NVIDIA H200 data sheet and H100 white paper; clock: the boost clock of the SXM module, which short kernels run at
SMS, SCHEDULERS, CLOCK = 132, 4, 1.98e9
WARPS, THREADS, BLOCKS, REGISTERS = 64, 2048, 32, 65_536  # of an SM
L1_BYTES, SHARED_BYTES, RESERVED_SHARED = 256 << 10, 227 << 10, 1 << 10  # of an SM; of a block, by the driver
# Bandwidth that copies and sweeps reach; the data sheet has 4.8e12 for the memory
MEMORY_BANDWIDTH, L2_BANDWIDTH = 4.3e12, 5.5e12
# Cycles until a load's value is there (microbenchmarks of H100: Luo et al. 2024, Chips and Cheese 2023)
L1_CYCLES, L2_CYCLES, MEMORY_CYCLES = 36, 270, 650
FILL_BYTES = 64  # a cycle from the L2 to an SM
ATOMIC_RATE = 1.0  # a cycle at one address; of different ones
ATOMICS_RATE = 96.0
EFFICIENCY = 0.8  # of what binds: no kernel keeps one unit busy all the time
LAUNCH, GRAPH_NODE, LOOP_TURN = 2.5e-6, 1.5e-6, 4e-6  # s before a launch, a node of a graph, a turn of its loop
SORT_BANDWIDTH = 3.0e12  # of Warp's radix sort (CUB): scattered writes; passes take a launch each
# Host: Python and Warp for a launch, a copy or fill, a graph's launch; a wait; a graph by node
HOST_LAUNCH, HOST_COPY, HOST_GRAPH, WAIT = 20e-6, 8e-6, 8e-6, 10e-6
GRAPH_MADE, GRAPH_MADE_NODE = 100e-6, 30e-6
LINK_BANDWIDTH = 20e9  # pageable memory of the host, by PCIe
LINK = ("(copy to host)", "(copy to device)")
MOST_RATIO = 1.4  # of 45 kernels all but two have 0.78 to 1.42 of the instructions expected; those are unrolled loops
FEW = 8  # rounds of blocks above which the last one, partly filled, is as good as none


@dataclass(frozen=True)
class Resources:
    """What a kernel's cubin for sm_90 says."""

    registers: int = 32
    local_bytes: int = 0
    instructions: int = 0  # of the machine
    statements: int = 0  # cost of its PTX by the table of costs: instructions, each counted once

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


def resident_blocks(resources: Resources, threads: int, shared: int) -> int:
    """Blocks of threads that an SM holds at once."""
    warps = -(-threads // 32)
    registers = -(-resources.registers * 32 // 256) * 256 * warps
    by_shared = (SHARED_BYTES + RESERVED_SHARED) // (shared + RESERVED_SHARED)
    return max(1, min(BLOCKS, WARPS // warps, REGISTERS // registers, by_shared))


def l1_share(resources: Resources, threads: int, shared: int) -> int:
    """Bytes of the L1 for each block, if all that fit are there."""
    blocks = resident_blocks(resources, threads, shared)
    return max(L1_BYTES // blocks - shared - RESERVED_SHARED, 4 << 10)


@dataclass
class Prediction:
    """One launch: seconds that each limit asks for, and what binds."""

    seconds: float
    limits: dict[str, float]
    occupancy: float = 0.0  # share of an SM's warps that can be there; of the whole chip where blocks are few

    @property
    def bound(self) -> str:
        return max(self.limits, key=lambda name: self.limits[name]) if self.limits else "overhead"


def _rounds(blocks: int, at_once: int) -> float:
    """How often so many blocks fill the places that they have."""
    exact = blocks / at_once
    return exact if exact > FEW else math.ceil(exact)


def _unit_cycles(units: dict[str, float]) -> dict[str, float]:
    """Cycles of each unit; sums of integers go to the less busy of the two that can add."""
    found = {"instructions": units.get("issued", 0.0)} | {
        u: units.get(u, 0.0) for u in ("alu", "fma", "fp64", "xu", "lsu")
    }
    moved = min(max((found["alu"] + units.get("sums", 0.0) - found["fma"]) / 2, 0.0), units.get("sums", 0.0))
    found["fma"] += moved
    found["alu"] += units.get("sums", 0.0) - moved
    return found


def predict_kernel(x: dict[str, Any], resources: Resources) -> Prediction:
    """A launch of a kernel; `x` is its LaunchCounts."""
    blocks, warps_of_block = x["blocks"], -(-x["threads"] // 32)
    resident = resident_blocks(resources, x["threads"], x["shared_bytes"])
    warps_of_sm = _rounds(blocks, SMS) * warps_of_block
    warps_of_scheduler = max(warps_of_sm / SCHEDULERS, 1.0)
    ratio, total = resources.instruction_ratio, blocks * warps_of_block
    limits = {}
    for unit, cycles in _unit_cycles(x["units"]).items():
        factor = 1.0 if unit == "lsu" else ratio
        limits[unit] = warps_of_scheduler * cycles * factor / CLOCK
    traffic = x["traffic"]
    limits["L1"] = warps_of_sm * sum(t["wavefronts"] for t in traffic.values()) / CLOCK
    missed = 32 * total * sum(t["missed"] for t in traffic.values())
    in_memory = min(x["memory_reads"], missed) / missed if missed else 0.0
    limits["L2"] = max(missed / L2_BANDWIDTH, missed / total * warps_of_sm / FILL_BYTES / CLOCK)
    limits["memory"] = (x["memory_reads"] + x["memory_writes"]) / MEMORY_BANDWIDTH
    beyond = in_memory * MEMORY_CYCLES + (1 - in_memory) * L2_CYCLES
    waits = (x["hits"] * L1_CYCLES + x["misses"] * beyond) / resources.turns_together
    warp = x["chain"] * ratio + waits
    limits["latency"] = _rounds(blocks, SMS * resident) * warp * x["imbalance"] / CLOCK
    atomics = total * traffic.get("global atomic", {}).get("lanes", 0.0)
    limits["atomics"] = max(x["hot_atomics"] / ATOMIC_RATE, atomics / ATOMICS_RATE) / CLOCK
    there = min(resident * warps_of_block, WARPS) * min(1.0, blocks / (SMS * resident))
    return Prediction(max(limits.values()) / EFFICIENCY, limits, there / WARPS)


def predict_other(x: dict[str, Any]) -> tuple[Prediction, int]:
    """Warp's own functions, copies and fills: the prediction, and how many launches they are."""
    name, moved = x["kernel"], x["bytes_read"] + x["bytes_written"]
    if name == "(radix sort)":
        return Prediction(moved / SORT_BANDWIDTH, {"memory": moved / SORT_BANDWIDTH}), 7
    if name in LINK:
        return Prediction(moved / LINK_BANDWIDTH, {"link": moved / LINK_BANDWIDTH}), 1
    if name in ("(wait)", "(graph launch)", "(graph made)", "(turn of a loop)"):
        return Prediction(LOOP_TURN if name == "(turn of a loop)" else 0.0, {}), 0
    return Prediction(moved / MEMORY_BANDWIDTH, {"memory": moved / MEMORY_BANDWIDTH}), 2 if name == "(scan)" else 1


def host_seconds(x: dict[str, Any]) -> float:
    """What the host does for a launch, before the device can begin."""
    if x["in_graph"]:
        return 0.0
    if x["kernel"] == "(graph made)":
        return GRAPH_MADE + GRAPH_MADE_NODE * x["nodes"]
    if x["kernel"] == "(wait)":
        return 0.0
    if x["kernel"] == "(graph launch)":
        return HOST_GRAPH
    return HOST_COPY if x["kernel"].startswith("(") else HOST_LAUNCH


@dataclass
class Timeline:
    """A call, launch after launch: the device's time alone, and the caller's, in which the host can be the slower.

    Copies from and to the host are in the caller's alone.
    """

    device: float = 0.0
    host_clock: float = 0.0
    device_clock: float = 0.0
    waits: int = 0
    is_idle: bool = False  # nothing has been given to the device since the last wait

    def add(self, x: dict[str, Any], seconds: float, launches: int) -> None:
        """Append a launch, or several that are alike."""
        gap, times = launches * (GRAPH_NODE if x["in_graph"] else LAUNCH), x.get("times", 1)
        self.device += times * (seconds + gap) if x["kernel"] not in LINK else 0.0
        self.host_clock += times * host_seconds(x)
        self.device_clock = max(self.device_clock, self.host_clock) + times * (seconds + gap)
        if x["kernel"] == "(copy to host)" or (x["kernel"] == "(wait)" and not self.is_idle):
            self.waits += times
            self.host_clock = max(self.host_clock, self.device_clock) + times * WAIT
            self.is_idle = True
        elif launches:
            self.is_idle = False

    @property
    def call(self) -> float:
        """Seconds until the call's last launch has ended."""
        return max(self.host_clock, self.device_clock)
