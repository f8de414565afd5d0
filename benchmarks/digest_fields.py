"""The operations of digests.py on distance fields."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from digest_scenes import UTM, loom

MAX_DISTANCE = 0.6


def field_of(d: Any, *, far: bool = False) -> Any:
    """The distance field of a cloud."""
    cloud = d.far.cloud if far else d.surface.cloud
    return loom().DistanceField.from_point_cloud(cloud, 0.1, MAX_DISTANCE)


def box_of(d: Any) -> Any:
    """The field of a dense box, negative inside."""
    occupied = np.random.default_rng(3).random((20, 13, 30)) < 0.2
    return loom().DistanceField.from_array(occupied, 0.1, origin=UTM, signed=True, device=d.device)


def contents(field: Any) -> list[Any]:
    """The complete contents of a field."""
    return [field.bounds, field.occupied_voxels, *(field.to_array(values=v) for v in ("squared", "nearest", "known"))]


def query_results(field: Any) -> list[Any]:
    """Results of queries at points, for spheres and for a body; NaN is replaced by -9, since its bits are
    unspecified.
    """
    low, high = field.bounds
    rng = np.random.default_rng(4)
    points = rng.uniform(low - 0.2, high + 0.2, (300, 3))
    poses = np.tile(np.eye(4), (20, 1, 1))
    poses[:, :3, 3] = points[:20]
    obstacles = field.nearest_obstacles(points)
    given = [
        *(field.distances(points), field.distances(points, interpolate=True), field.is_known(points)),
        *(field.gradients(points), obstacles.rows, obstacles.positions, obstacles.distances),
        *(field.collides(points, 0.1), *field.collides_bodies([[0, 0, 0, 0.1], [0.2, 0, 0, 0.05]], poses)),
    ]
    return [np.nan_to_num(values, nan=-9.0) for values in given]


def layers(field: Any) -> list[Any]:
    """Slices of a field."""
    middle = field.bounds.mean(axis=0)
    slices = [field.slice(axis, position) for axis, position in zip("xyz", middle, strict=True)]
    return [(layer.distances, layer.is_known, layer.extent) for layer in slices]


def field_file(d: Any) -> list[Any]:
    """A field after saving and loading."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "field.npz"
        field_of(d).save(path)
        return contents(loom().DistanceField.load(path, device=d.device))


def listed(d: Any) -> list[Any]:
    """Fields of listed voxels, given as a grid and as indices."""
    make, grid = loom().DistanceField, d.ball.voxelize(0.2)
    around = make.from_voxel_grid(grid, MAX_DISTANCE, device=d.device)
    return contents(around) + contents(make.from_voxels(grid.coordinates[::-1], 0.2, MAX_DISTANCE, device=d.device))


def occupied(d: Any) -> list[Any]:
    """The field of the occupied voxels of a scan of a ball."""
    grid = loom().OccupancyGrid(0.2, device=d.device)
    grid.insert_scan(d.ball.vertices, [0.0, 0.0, 0.0])
    return contents(loom().DistanceField.from_occupancy_grid(grid, MAX_DISTANCE))


FIELDS: dict[str, Callable[[Any], Any]] = {
    "distance field, from_point_cloud": lambda d: contents(field_of(d)),
    "distance field, from_point_cloud, far": lambda d: contents(field_of(d, far=True)),
    "distance field, from_array": lambda d: contents(box_of(d)),
    "distance field, from_voxels": listed,
    "distance field, from_occupancy_grid": occupied,
    "distance field, queries": lambda d: query_results(field_of(d)),
    "distance field, queries, far": lambda d: query_results(box_of(d)),
    "distance field, slice": lambda d: layers(field_of(d)),
    "distance field, save and load": field_file,
}
