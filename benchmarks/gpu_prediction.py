"""From the counts of a call to what it would take on a GPU, kernel by kernel."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from typing import Any

from gpu_chips import H200, Chip
from gpu_machine import Prediction, Resources, Timeline, host_seconds, predict_kernel, predict_other


@dataclass
class Row:
    """All launches of one kernel in a call."""

    launches: int = 0
    seconds: float = 0.0
    instructions: float = 0.0  # of warps
    statements: float = 0.0
    lane_statements: float = 0.0
    requests: float = 0.0  # to global memory
    sectors: float = 0.0
    l2_bytes: float = 0.0
    memory_bytes: float = 0.0
    local_bytes: float = 0.0  # of arrays in local memory, and of spilled registers
    lost_bytes: float = 0.0  # from and to memory, since resident warps outgrow the L2
    registers: int = 0
    spilled: int = 0
    occupancy: float = 0.0
    bounds: dict[str, float] = field(default_factory=lambda: defaultdict(float))

    def add(self, x: dict[str, Any], found: Prediction, launches: int) -> None:
        """Append a launch, or several that are alike."""
        times, seconds = x.get("times", 1), found.seconds
        self.local_bytes += times * found.spilled
        self.lost_bytes += times * found.lost
        warps = x["blocks"] * -(-x["threads"] // 32) * times
        self.launches += launches * times
        self.seconds += seconds * times
        self.instructions += warps * x["units"].get("issued", 0)
        self.statements += warps * x["warp_statements"]
        self.lane_statements += warps * x["lane_statements"]
        for name, traffic in x["traffic"].items():
            space = name.split()[0]
            if space == "global":
                self.requests += warps * traffic["requests"]
                self.sectors += warps * traffic["sectors"]
            if space == "local":
                self.local_bytes += warps * traffic["bytes"]
            self.l2_bytes += 32 * warps * traffic["missed"]
        self.memory_bytes += (x["memory_reads"] + x["memory_writes"]) * times

    @property
    def active(self) -> float:
        return self.lane_statements / (32 * self.statements) if self.statements else 0.0

    @property
    def sectors_a_request(self) -> float:
        return self.sectors / self.requests if self.requests else 0.0


@dataclass
class Predicted:
    """A call of an operation."""

    rows: dict[str, Row]
    timeline: Timeline
    counts: dict[str, Any]
    chip: Chip = H200


def resources_of(counts: dict[str, Any], chip: Chip) -> dict[str, Resources]:
    """What the cubins for a chip say, by symbol; those for sm_90 where none were made for it."""
    found = counts["resources"] | counts.get("resources_of", {}).get(str(chip.architecture), {})
    return {symbol: Resources(**values) for symbol, values in found.items()}


def host_before(counts: dict[str, Any], chip: Chip) -> float:
    """What the host does besides what is given to the device, while the device has nothing to do yet: allocations."""
    return counts["host"].get("allocations", 0) * chip.host_allocation


def predict(counts: dict[str, Any], chip: Chip = H200, measured_host: float | None = None) -> Predicted:
    """The seconds of a call, from its counts.

    Args:
        counts: Of gpu_counts.py.
        chip: The GPU.
        measured_host: Seconds of the host's part of a call, where they were measured (gpu_host_time.py): its steps,
            allocations among them, are as long as makes that sum.
    """
    resources, rows = resources_of(counts, chip), defaultdict(Row)
    before, factor = host_before(counts, chip), 1.0
    if measured_host is not None:
        steps = [x.get("times", 1) * host_seconds(x, chip) for x in counts["launches"]]
        factor = measured_host / (before + sum(steps)) if before + sum(steps) else 1.0
        before *= factor
    timeline = Timeline(chip, factor, before)
    for x in counts["launches"]:
        name, launches = x["kernel"], 1
        if name.startswith("("):
            found, launches = predict_other(x, chip)
        else:
            held = resources[x["symbol"]]
            found = predict_kernel(x, held, chip)
            rows[name].registers, rows[name].spilled = held.registers, held.local_bytes
            rows[name].occupancy = max(rows[name].occupancy, found.occupancy)
            rows[name].bounds[found.bound] += found.seconds * x.get("times", 1)
        rows[name].add(x, found, launches)
        timeline.add(x, found.seconds, launches)
    return Predicted(dict(rows), timeline, counts, chip)
