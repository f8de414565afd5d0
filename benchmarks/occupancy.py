"""OccupancyGrid beside OctoMap (pyoctomap): every voxel's log odds, and thread CPU time per scan.

    python benchmarks/occupancy.py [--scan FILE] [--voxel-size 0.1] [--points 100000]

Without a file the scans are of a room of 20 x 16 x 6 m with 10 % noise, from a moving sensor; every other one is
clipped
at 6 m, and the last one is on voxel corners. With a file, its points are scanned from (0, 0, 0), twice.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pyoctomap

import pointloom as loom
from pointloom.kernels.volumes.tsdf_blocks import block_box


def room_scans(count: int) -> Iterator[tuple[Any, Any, float | None]]:
    rng = np.random.default_rng(0)
    for k in range(5):
        start = np.array([0.5 * k, 0.3 * k, 0.1], np.float32)
        directions = rng.normal(size=(count, 3))
        ranges = rng.uniform(0.9, 1.0, (count, 1)) / np.abs(directions / [10, 8, 3]).max(axis=1, keepdims=True)
        ends = (directions * ranges).astype(np.float32) + start
        yield (np.round(ends, 1), np.round(start, 1), None) if k == 4 else (ends, start, None if k % 2 else 6.0)


def file_scans(path: str) -> Iterator[tuple[Any, Any, float | None]]:
    points = np.asarray(loom.read_point_cloud(path).points, np.float32)
    start = np.zeros(3, np.float32)
    yield points, start, None
    yield points, start, 30.0


def leaves_of(tree: Any, edge: float) -> dict[tuple[int, ...], float]:
    """The log odds of every voxel of OctoMap; pruned leaves are expanded."""
    leaves: dict[tuple[int, ...], float] = {}
    for leaf in tree.begin_leafs():
        side = round(leaf.getSize() / edge)
        low = np.round((np.array(leaf.getCoordinate()) - leaf.getSize() / 2) / edge).astype(int)
        value = float(np.float32(leaf.current_node.getLogOdds()))
        for voxel in np.ndindex(side, side, side):
            leaves[tuple((low + voxel).tolist())] = value
    return leaves


def voxels_of(grid: Any) -> dict[tuple[int, ...], float]:
    arrays = grid.__getstate__()["arrays"]
    known = np.flatnonzero(arrays["odds"] < 1e8)
    v, blocks = known % 512, block_box(arrays["keys"])
    cells = 8 * blocks[known // 512] + np.stack([v // 64, v // 8 % 8, v % 8], axis=1)
    return dict(zip(map(tuple, cells.tolist()), arrays["odds"][known].tolist(), strict=True))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scan")
    parser.add_argument("--voxel-size", type=float, default=0.1)
    parser.add_argument("--points", type=int, default=100_000)
    given = parser.parse_args()
    grid, tree = loom.OccupancyGrid(given.voxel_size), pyoctomap.OcTree(given.voxel_size)
    for name, value in (("ProbHit", 0.7), ("ProbMiss", 0.4), ("ClampingThresMin", 0.1192), ("ClampingThresMax", 0.971)):
        getattr(tree, f"set{name}")(value)
    loom.OccupancyGrid(given.voxel_size).insert_scan([[1.0, 1.0, 1.0]], [0, 0, 0])  # compiles
    for points, start, cut in file_scans(given.scan) if given.scan else room_scans(given.points):
        begin = time.process_time()
        grid.insert_scan(points, start, max_range=cut)
        seconds = time.process_time() - begin
        begin = time.process_time()
        tree.insertPointCloud(points.astype(np.float64), start.astype(np.float64), -1.0 if cut is None else cut)
        octomap_seconds = time.process_time() - begin
        ratio = octomap_seconds / seconds
        print(f"{len(points):,} points: {1e3 * seconds:.0f} ms, OctoMap {1e3 * octomap_seconds:.0f} ms, {ratio:.1f}x")
    voxels, octomap_voxels = voxels_of(grid), leaves_of(tree, given.voxel_size)
    both = voxels.keys() & octomap_voxels.keys()
    print(f"{grid}, {grid.memory_bytes / 1e6:.1f} MB")
    print(
        f"{len(voxels):,} voxels, OctoMap {len(octomap_voxels):,}; "
        f"in only one {len(voxels.keys() ^ octomap_voxels.keys())}, "
        f"different log odds {sum(voxels[v] != octomap_voxels[v] for v in both)}"
    )


if __name__ == "__main__":
    main()
