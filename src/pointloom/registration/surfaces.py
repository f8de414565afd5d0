"""Surfaces of clouds at the resolution of a registration, with normals on their concave side."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..kernels.arrays.bounds import bound_each
from ..kernels.linear_algebra import det, matmul
from ..kernels.surface.hollow_side import Surface
from ..pcd.cloud import PointCloud
from .assessment_constants import (
    FINE_VOXEL_FACTOR,
    MATCH_VOXELS,
    MAX_DISTORTION,
    NORMAL_RADIUS,
    SIDE_RADIUS,
    SOURCE_VOXEL_FACTOR,
)
from .rigid import nearest_rotation


def surface_of(cloud: PointCloud, voxel_size: float) -> Surface:
    return surfaces_of([cloud], [voxel_size])[0]


def surfaces_of(clouds: Sequence[PointCloud], voxel_sizes: Sequence[float]) -> list[Surface]:
    """The surface of each cloud. All are on one device."""
    boxes = bound_each([cloud.arrays["points"] for cloud in clouds])  # sync
    points = [
        cloud.average_voxels(size, ["points"], box).arrays["points"]  # sync
        for cloud, size, box in zip(clouds, voxel_sizes, boxes, strict=True)
    ]
    return Surface.select_each(
        points, [NORMAL_RADIUS * size for size in voxel_sizes], [SIDE_RADIUS * size for size in voxel_sizes]
    )


def surfaces_for(clouds: Sequence[PointCloud], voxel_sizes: Sequence[float], distance: float) -> list[Surface]:
    """As `surfaces_of`. Its error names the match distance [m] that the voxels were chosen for."""
    try:
        return surfaces_of(clouds, voxel_sizes)
    except ValueError as error:
        raise ValueError(f"max_correspondence_distance: {distance} m is too small for these clouds: {error}") from error


class SurfacePair:
    """The surfaces of two clouds for a match distance [m], each computed once: source, target.

    `coarse` has the voxels of the registration, `fine` half of them. Those of the source are smaller.
    """

    def __init__(self, source: PointCloud, target: PointCloud, distance: float):
        self.source, self.target, self.distance, self.voxel_size = source, target, distance, distance / MATCH_VOXELS

    @cached_property
    def coarse(self) -> tuple[Surface, Surface]:
        return self._in_voxels(self.voxel_size)

    @cached_property
    def fine(self) -> tuple[Surface, Surface]:
        return self._in_voxels(FINE_VOXEL_FACTOR * self.voxel_size)

    def _in_voxels(self, size: float) -> tuple[Surface, Surface]:
        source, target = surfaces_for((self.source, self.target), (SOURCE_VOXEL_FACTOR * size, size), self.distance)
        return source, target


def as_rigid(source: PointCloud, T: NDArray[np.float64]) -> tuple[PointCloud, NDArray[np.float64]]:
    """The source and a rigid pose. Under a pose with a scale or shear, the transformed source and the identity."""
    if np.abs(matmul(T[:3, :3], T[:3, :3].T) - np.eye(3)).max() > MAX_DISTORTION or det(T[:3, :3]) < 0:
        source, T = source.transform(T), np.eye(4)
    T = np.array(T)
    T[:3, :3] = nearest_rotation(T[:3, :3])
    return source, T
