"""From the counts of a call to what it would take on an H200, kernel by kernel."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass, field
from typing import Any

from gpu_machine import Resources, Timeline, predict_kernel, predict_other


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
    local_bytes: float = 0.0
    registers: int = 0
    spilled: int = 0
    occupancy: float = 0.0
    bounds: dict[str, float] = field(default_factory=lambda: defaultdict(float))

    def add(self, x: dict[str, Any], seconds: float, launches: int) -> None:
        """Append a launch, or several that are alike."""
        times = x.get("times", 1)
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


def predict(counts: dict[str, Any]) -> Predicted:
    """The seconds of a call, from its counts."""
    resources = {symbol: Resources(**values) for symbol, values in counts["resources"].items()}
    rows: dict[str, Row] = defaultdict(Row)
    timeline = Timeline()
    for x in counts["launches"]:
        name, launches = x["kernel"], 1
        if name.startswith("("):
            found, launches = predict_other(x)
        else:
            held = resources[x["symbol"]]
            found = predict_kernel(x, held)
            rows[name].registers, rows[name].spilled = held.registers, held.local_bytes
            rows[name].occupancy = max(rows[name].occupancy, found.occupancy)
            rows[name].bounds[found.bound] += found.seconds * x.get("times", 1)
        rows[name].add(x, found.seconds, launches)
        timeline.add(x, found.seconds, launches)
    return Predicted(dict(rows), timeline, counts)
