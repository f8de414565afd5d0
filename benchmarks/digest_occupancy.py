"""The operations of digests.py on an occupancy grid."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from digest_scenes import Scenes, loom

BOUNDS = [[-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]]


def filled(d: Scenes, away: float = 0.0) -> Any:
    """Three scans of a ball from inside, one of them with its origin at a point and clipped rays."""
    grid, ends = loom().OccupancyGrid(0.05, device=d.device), d.ball.vertices[::7] + away
    middle = ends.mean(axis=0)
    grid.insert_scan(ends, middle)
    grid.insert_scan(ends[::3], np.add(middle, [0.11, 0.03, 0.0]), max_range=0.6)
    grid.insert_scan(ends[1:], np.linspace(middle, middle + 0.2, len(ends) - 1))
    return grid


def queried(d: Scenes) -> list[Any]:
    grid, points = filled(d), d.ball.vertices[::11]
    results = [getattr(grid, name)(points) for name in ("states", "occupied", "probabilities", "log_odds")]
    return [
        results,
        grid.to_array(BOUNDS),
        grid.voxel_indices(),
        grid.to_point_cloud(),
        grid.to_voxel_grid().coordinates,
    ]


def met(d: Scenes) -> list[Any]:
    points = d.ball.vertices[::11]
    hits = filled(d).cast_rays(points.mean(axis=0), points - points.mean(axis=0), 3.0)
    return [hits.states, hits.distances, hits.voxels]


def saved(d: Scenes) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "grid.npz"
        filled(d).save(path)
        again = loom().OccupancyGrid.load(path, device=d.device)
    return [again.copy().block_count, again.scan_count, again.voxel_indices()]


OCCUPANCY: dict[str, Callable[[Scenes], Any]] = {
    "occupancy, insert_scan": lambda d: filled(d).voxel_indices(),
    "occupancy, insert_scan, far": lambda d: filled(d, 500_000.0).to_point_cloud(),
    "occupancy, asked": queried,
    "occupancy, cast_rays": met,
    "occupancy, save and load": saved,
}
