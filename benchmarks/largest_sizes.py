"""The largest cloud for each operation on a GPU, from its allocations and launches on the emulated device.

    python benchmarks/largest_sizes.py [OPERATION ...]

Each operation runs on two clouds of a surface. The growth per point is measured: elements of its largest array and of
its largest launch, both limited to 2^31, and the peak bytes, including cloud and search tree. The rows are Markdown:
bytes per point, points on 80 GB, points by 2^31, and the binding limit.
"""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "src"), str(ROOT), str(ROOT / "benchmarks")]
os.environ |= {"EMULATED_CUDA_UNINITIALISED": "0", "EMULATED_CUDA_LAZY": "0"}  # so that memory is released at once
from tests.emulated_cuda.install import install, installed  # noqa: E402

install()
import numpy as np  # noqa: E402
import scenes  # noqa: E402
import warp as wp  # noqa: E402

import pointloom as loom  # noqa: E402
from pointloom.kernels import launches  # noqa: E402
from pointloom.kernels.features import fpfh  # noqa: E402
from pointloom.kernels.search import group_scratch  # noqa: E402
from pointloom.kernels.surface import covariances  # noqa: E402

# Arrays of bounded size are given their maximum from the start
group_scratch.SM_THREADS, covariances.LIST_ENTRIES = 32, 2**12
OWN_LIMITS = {  # limits that an operation checks itself
    "compute_fpfh_feature": fpfh.MAX_POINTS,
    "detect_planar_patches": (2**31 - 1) // 30,
}

COUNTS = 12_007, 36_011
# Kernels that are launched in batches for large inputs: arrays that grow at these sizes are bounded
IN_PARTS = {
    *("search_nearest_kernel", "list_neighbors_kernel", "fit_covariances_nearest_kernel", "drop_neighbors_kernel"),
    *("search_nearest_of_lanes_kernel", "average_listed_kernel", "offer_edges_kernel", "hook_components_kernel"),
}
CARD = 80e9  # bytes
LIMIT = 2**31
DEVICE = "cuda:0"


class Cloud:
    """A surface on the device, with other inputs of operations."""

    def __init__(self, count: int) -> None:
        points = scenes.bumpy_surface(count, 1).astype(np.float32)
        self.spacing = scenes.SURFACE_EDGE / count**0.5
        self.cloud = loom.PointCloud(wp.array(points, device=DEVICE))

    def normals(self) -> Any:
        return self.cloud.estimate_normals(max_nn=8)


def registered(c: Cloud) -> Any:
    plane = loom.registration.TransformationEstimationPointToPlane()
    target = c.normals()
    return loom.registration.registration_icp(c.cloud, target, 3 * c.spacing, estimation_method=plane)


OPERATIONS: dict[str, Callable[[Cloud], Any]] = {
    "voxel_down_sample": lambda c: c.cloud.voxel_down_sample(2 * c.spacing),
    "estimate_normals, 30 nearest": lambda c: c.cloud.estimate_normals(max_nn=30),
    "estimate_covariances, 30 nearest": lambda c: c.cloud.estimate_covariances(max_nn=30),
    "knn_search, 1": lambda c: loom.NearestNeighborSearch(c.cloud).knn_search(c.cloud, 1),
    "knn_search, 30": lambda c: loom.NearestNeighborSearch(c.cloud).knn_search(c.cloud, 30),
    "radius_search, some 12": lambda c: loom.NearestNeighborSearch(c.cloud).radius_search(c.cloud, 2 * c.spacing),
    "compute_point_cloud_distance": lambda c: c.cloud.compute_point_cloud_distance(c.cloud),
    "remove_statistical_outlier, 20": lambda c: c.cloud.remove_statistical_outlier(20, 2.0),
    "remove_radius_outlier": lambda c: c.cloud.remove_radius_outlier(4, 3 * c.spacing),
    "cluster_dbscan": lambda c: c.cloud.cluster_dbscan(2 * c.spacing, 4),
    "segment_plane": lambda c: c.cloud.segment_plane(c.spacing),
    "farthest_point_down_sample, 100": lambda c: c.cloud.farthest_point_down_sample(100),
    "orient_normals_consistent_tangent_plane, 12": lambda c: c.normals().orient_normals_consistent_tangent_plane(12),
    "smooth_mls": lambda c: c.cloud.smooth_mls(radius=4 * c.spacing),
    "compute_fpfh_feature, 50": lambda c: loom.compute_fpfh_feature(c.normals(), max_nn=50),
    "detect_planar_patches, 30": lambda c: c.normals().detect_planar_patches(),
    "registration_icp": registered,
    "transform": lambda c: c.cloud.transform(np.eye(4)),
}


class Seen:
    """The largest array of each parameter of an operation's kernels, its launches, and the peak bytes."""

    def __init__(self) -> None:
        self.elements: dict[tuple[str, int], int] = {}  # by kernel and parameter, -1 for threads
        self.bytes = 0


@contextmanager
def watched() -> Iterator[Seen]:
    """Record launches and allocations in the block."""
    device, record, real = installed(), Seen(), launches.checked_arguments
    assert device is not None

    def checked(what: Any, thread_count: int, arguments: Any) -> Any:
        allocated = real(what, thread_count, arguments)
        sizes = {k: max(value.shape) for k, value in enumerate(allocated[0]) if isinstance(value, wp.array)}
        for k, size in ({-1: thread_count} | sizes).items():
            record.elements[what.name, k] = max(size, record.elements.get((what.name, k), 0))
        return allocated

    gc.collect()
    device.synchronize()
    device.memory.peak = device.memory.used
    launches.checked_arguments = checked
    try:
        yield record
    finally:
        launches.checked_arguments = real
        device.synchronize()
        record.bytes = device.memory.peak


def grown(work: Callable[[Cloud], Any]) -> tuple[float, float]:
    """Elements (or threads) and bytes per additional point."""
    sizes_and_bytes = []
    for count in COUNTS:
        gc.collect()
        installed().synchronize()  # type: ignore[union-attr]
        before = installed().memory.used  # type: ignore[union-attr]
        cloud = Cloud(count)
        with watched() as record:
            work(cloud)
        sizes_and_bytes.append((record.elements, record.bytes - before))
        del cloud
    step = COUNTS[1] - COUNTS[0]
    elements = {
        p: (size - sizes_and_bytes[0][0].get(p, size)) / step
        for p, size in sizes_and_bytes[1][0].items()
        if p[0] not in IN_PARTS
    }
    return max(elements.values()), (sizes_and_bytes[1][1] - sizes_and_bytes[0][1]) / step


def main(names: list[str]) -> None:
    """Print the table."""
    print("| operation | bytes per point | points on 80 GB | points by 2^31 | bound by |")
    print("|---|---|---|---|---|")
    for name, work in OPERATIONS.items():
        if names and not name.startswith(tuple(names)):
            continue
        elements, size = grown(work)
        own = min([own for start, own in OWN_LIMITS.items() if name.startswith(start)], default=LIMIT)
        by_size, by_count = CARD / size / 1e6, min(own, LIMIT / max(elements, 1e-9)) / 1e6
        which = "memory" if by_size < by_count else "2^31"
        print(f"| {name} | {size:,.0f} | {by_size:,.0f} M | {by_count:,.0f} M | {which} |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
