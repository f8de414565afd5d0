"""What the model knows of GPUs, with where it is from.

Constants that were measured take their place: those of results/gpu-constants-CHIP.json, which `make gpu-run` proposes,
once `reviewed_by` in it names who has looked at them.
"""

from __future__ import annotations

import functools
import json
from dataclasses import dataclass, fields, replace
from pathlib import Path

from gpu_host import costs

RESULTS = Path(__file__).parent / "results"


@dataclass(frozen=True)
class Chip:
    """A GPU and its host. Times in seconds, rates a second, waits in cycles.

    Attributes:
        fp64_cycles: Of the float64 unit, for one that the table of costs counts, which is of Hopper.
        l2_bytes: That one SM's data can use; a Hopper's two halves keep copies of what the other asks for.
        code_bytes: Of the cache that feeds an SM's instruction caches (L1.5; Jia et al. 2018, of Volta and Turing).
        fill_bytes: A cycle from the L2 to an SM.
        atomic_rate: A cycle at one address; `atomics_rate` of different ones.
        launch: Before a launch; `graph_node` before a node of a graph, `loop_turn` before a turn of its loop.
        link_pinned: Bytes a second of PCIe; `link_pageable` of host memory that is in use, through the driver's own;
            `link_fresh` into memory that the system still has to hand out, page by page, as results in NumPy.
        host_launch: Python and Warp for a launch; `host_copy` for a copy or fill, `host_graph` for a graph's launch,
            `host_allocation` for an array; `wait` until the host notices the device's end.
        graph_made: To record and instantiate a graph, and `graph_made_node` for each node.
    """

    name: str
    title: str
    architecture: int
    sms: int
    clock: float
    memory_bandwidth: float
    l2_bandwidth: float
    l2_bytes: int
    fp64_cycles: float = 1.0
    schedulers: int = 4
    warps: int = 64
    blocks: int = 32
    registers: int = 65_536
    l1_bytes: int = 256 << 10
    shared_bytes: int = 227 << 10
    code_bytes: int = 128 << 10
    l1_cycles: float = 36
    l2_cycles: float = 270
    memory_cycles: float = 650
    fill_bytes: float = 64
    atomic_rate: float = 1.0
    atomics_rate: float = 96.0
    launch: float = 2.5e-6
    graph_node: float = 1.5e-6
    loop_turn: float = 4e-6
    link_pinned: float = 50e9
    link_pageable: float = 10e9
    link_fresh: float = 4e9
    host_launch: float = 20e-6
    host_copy: float = 8e-6
    host_graph: float = 8e-6
    host_allocation: float = 60e-6
    wait: float = 10e-6
    graph_made: float = 100e-6
    graph_made_node: float = 30e-6

    @property
    def float_rate(self) -> float:
        """Float32 operations a second, a fused product two."""
        return self.sms * 128 * 2 * self.clock


# NVIDIA's data sheets and white papers of H100, H200, Ada and Blackwell; clocks: boost, which short kernels run at.
# Bandwidth is what copies and sweeps reach, nine tenths of the data sheet's 4.8, 3.35, 1.008 and 1.792 TB/s. Cycles
# until a load's value is there: microbenchmarks (Luo et al. 2024 of H100 and RTX 4090; Chips and Cheese 2022, 2023).
# Links: PCIe 5 with 50 of 63 GB/s for Hopper and Blackwell, PCIe 4 with 25 of 31.5 for Ada.
H200 = Chip("h200", "H200", 90, 132, 1.98e9, 4.3e12, 5.5e12, 40 << 20)
H100 = Chip("h100", "H100 SXM", 90, 132, 1.98e9, 3.0e12, 5.5e12, 40 << 20)
_DESK = {"warps": 48, "blocks": 24, "l1_bytes": 128 << 10, "shared_bytes": 99 << 10, "fp64_cycles": 32.0}
RTX_4090 = Chip(
    "rtx-4090", "RTX 4090", 89, 128, 2.52e9, 0.92e12, 5.0e12, 72 << 20, link_pinned=25e9, **_DESK
)  # fmt: skip
RTX_5090 = Chip("rtx-5090", "RTX 5090", 120, 170, 2.41e9, 1.6e12, 6.0e12, 96 << 20, **_DESK)
CHIPS = {chip.name: chip for chip in (H200, H100, RTX_4090, RTX_5090)}
_NUMBERS = {field.name for field in fields(Chip)} - {"name", "title", "architecture"}


@functools.cache
def chip_named(name: str) -> Chip:
    """A chip with what was measured of hosts (gpu_host.py), and over that what was measured on one and reviewed.

    Raises:
        KeyError: The model does not know it.
    """
    path = RESULTS / f"gpu-constants-{name}.json"
    return replace(CHIPS[name], **(costs() | (reviewed(path) if path.exists() else {})))


def reviewed(path: Path) -> dict[str, float]:
    """Constants of a file by field, if somebody has put a name to them; names in capitals are fields.

    Raises:
        ValueError: One is not above zero.
    """
    document = json.loads(path.read_text())
    if not document.get("reviewed_by") or "emulated" in document["device"]["name"].lower():
        return {}
    found = {name.lower(): value for name, value in document["constants"].items()}
    if wrong := [name for name in found if name in _NUMBERS and not found[name] > 0]:
        raise ValueError(f"{path.name}: not above zero: {', '.join(wrong)}")
    return {name: value for name, value in found.items() if name in _NUMBERS}
