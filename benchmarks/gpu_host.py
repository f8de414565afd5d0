"""What the host costs, from results/gpu-host-time.json: `python benchmarks/gpu_host_time.py --save` of that file.

It holds the CPU time of Python and Warp for calls on the emulated device, the device's part taken out, and the counts
of what was given to it. From these come seconds of the operations that it has, and a cost of a launch, an array and so
on for all others: a fit without negative costs, first of the calls that make no graph. The driver's part, which no
emulated device has, is added. A GPU's own host may be twice as fast; what was measured on one stands in the chip's
constants.
"""

from __future__ import annotations

import functools
import json
import statistics
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

FILE = Path(__file__).parent / "results" / "gpu-host-time.json"
DRIVER = 3e-6  # s of the driver for a launch, a copy, an array, a wait, a graph: 2 to 5 us by experience
GIVEN = ("launches", "graphs", "copies to host", "copies to device", "allocations", "waits")
COSTS = {  # a chip's field: what is counted of it
    "host_launch": ("launches",),
    "host_copy": ("copies to host", "copies to device"),
    "host_allocation": ("allocations",),
    "wait": ("waits",),
}
NAMES = {  # of the model's operations: the calls there
    "normals_k30": ("normals k30",),
    "voxel_down_sample": ("voxel_down_sample",),
    "knn20": ("knn 20",),
    "statistical_outliers": ("statistical outliers",),
    "dbscan": ("dbscan",),
    "fpfh": ("fpfh",),
    "icp_plane": ("icp plane, 20 steps",),
    "lidar_odometry_scan": ("odometry, a scan",),
    "tsdf_integrate": ("tsdf integrate",),
    "tsdf_mesh": ("tsdf mesh",),
    "rgbd_frame": ("rgbd frame", "rgbd alignment"),
    "cast_rays": ("cast_rays",),
}

Rows = Sequence[dict[str, Any]]


@functools.cache
def kept_rows(file: Path = FILE) -> tuple[dict[str, Any], ...]:
    """What was measured; nothing where nobody did."""
    return tuple(json.loads(file.read_text())) if file.exists() else ()


def seconds_of(row: dict[str, Any]) -> float:
    """The host's part of a call, the driver's part of what it gives to the device with it."""
    return row["host_ms"] / 1e3 + DRIVER * sum(row[name] for name in GIVEN)


def measured_hosts(rows: Rows | None = None) -> dict[str, float]:
    """Seconds of the host's part of the model's operations, where they were measured."""
    found = {row["operation"]: seconds_of(row) for row in (kept_rows() if rows is None else rows)}
    return {
        name: sum(found[call] for call in calls)
        for name, calls in NAMES.items()
        if all(call in found for call in calls)
    }


def costs(rows: Rows | None = None) -> dict[str, float]:
    """Fields of a chip: what a launch, a copy, an array, a wait and the making of a graph cost the host.

    A launch inside a graph costs its host nothing when it runs, and is recorded when the graph is made: so graphs are
    what calls that make them take beyond the others' costs, all their nodes together.
    """
    rows = kept_rows() if rows is None else rows
    plain = [row for row in rows if not row["graphs made"] and not row["graphs"]]
    if len(plain) < len(COSTS):
        return {}
    from scipy.optimize import nnls

    counts = np.array([_counts(row) for row in plain], float)
    weights = 1 / np.array([seconds_of(row) for row in plain])
    fitted, _ = nnls(counts * weights[:, None], np.ones(len(plain)))
    found = {name: float(cost) for name, cost in zip(COSTS, fitted, strict=True) if cost}
    rest = [
        (seconds_of(row) - float(np.dot(_counts(row)[1:], fitted[1:]))) / row["graphs made"]
        for row in rows
        if row["graphs made"]
    ]
    if rest and statistics.median(rest) > 0:
        found |= {"graph_made": statistics.median(rest), "graph_made_node": 0.0}
    return found


def _counts(row: dict[str, Any]) -> list[int]:
    return [sum(row[name] for name in names) for names in COSTS.values()]
