"""VoxelGrid: the voxels that a mesh or a cloud touches. Carving is not supported."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import KnownNames
from ...meshing.mesh import voxel_grid
from ..vectors import Vector3dVector
from ..wrapper import as_array, column, unwrap
from .boxes import AxisAlignedBoundingBox
from .enums import VoxelPoolingMode
from .geometry import Geometry
from .point_cloud import PointCloud
from .triangle_mesh import TriangleMesh

CORNERS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]])


class Voxel(KnownNames):
    grid_index: NDArray[np.int32]
    color: NDArray[np.float64]

    def __init__(self, grid_index: ArrayLike = (0, 0, 0), color: ArrayLike = (0.0, 0.0, 0.0)):
        self.grid_index, self.color = np.array(grid_index, np.int32), np.array(color, np.float64)

    def __repr__(self) -> str:
        index, color = (", ".join(f"{value:g}" for value in row) for row in (self.grid_index, self.color))
        return f"Voxel with grid_index: ({index}), color: ({color})"


class VoxelGrid(Geometry):
    """Occupied voxels, with colors from a colored cloud. Voxel (0, 0, 0) begins at `origin`."""

    VoxelPoolingMode = VoxelPoolingMode
    _kind = voxel_grid.VoxelGrid
    _colors: NDArray[np.float64]

    def __init__(self, grid: VoxelGrid | None = None):
        empty = voxel_grid.VoxelGrid(np.zeros(3), 0.0, (0, 0, 0), np.zeros((0, 3), np.int32))
        self._wrapped, self._shared = empty if grid is None else grid._wrapped, {}
        self._colors = np.zeros((0, 3)) if grid is None else grid._colors

    @classmethod
    def _around(cls, grid: voxel_grid.VoxelGrid, colors: NDArray[np.float64] | None = None) -> VoxelGrid:
        made = cls._of(grid)
        made._colors = np.zeros((len(grid), 3)) if colors is None else colors
        return made

    @classmethod
    def create_from_triangle_mesh(cls, input: Any, voxel_size: float) -> VoxelGrid:
        return cls._around(unwrap(input, TriangleMesh, "input").voxelize(voxel_size))

    @classmethod
    def create_from_triangle_mesh_within_bounds(
        cls, input: Any, voxel_size: float, min_bound: ArrayLike, max_bound: ArrayLike
    ) -> VoxelGrid:
        corners = column("min_bound", min_bound), column("max_bound", max_bound)
        return cls._around(unwrap(input, TriangleMesh, "input").voxelize(voxel_size, *corners))

    @classmethod
    def create_from_point_cloud(
        cls, input: Any, voxel_size: float, pooling_mode: VoxelPoolingMode = VoxelPoolingMode.AVG
    ) -> VoxelGrid:
        """Voxels of a cloud with mean colors."""
        if pooling_mode is not VoxelPoolingMode.AVG:
            raise ValueError(f"pooling_mode: expected AVG, got {pooling_mode.name}: a voxel has its points' mean color")
        cloud = unwrap(input, PointCloud, "input")
        means = cloud.voxel_down_sample(voxel_size)
        origin = cloud.get_min_bound() - voxel_size / 2
        cells = np.floor((means.points - origin) / voxel_size).astype(np.int32)
        counts = tuple((cells.max(axis=0) + 1).tolist()) if len(cells) else (0, 0, 0)
        order = np.lexsort(cells.T[::-1])
        colors = means.colors.astype(np.float64)[order] if means.has_colors else None
        return cls._around(voxel_grid.VoxelGrid(origin, voxel_size, counts, cells[order]), colors)

    @property
    def origin(self) -> NDArray[np.float64]:
        """Corner of voxel (0, 0, 0)."""
        return self._wrapped.origin

    @property
    def voxel_size(self) -> float:
        return float(self._wrapped.voxel_size)

    def get_voxels(self) -> list[Voxel]:
        return [Voxel(*both) for both in zip(self._wrapped.coordinates, self._colors, strict=True)]

    def get_voxel(self, point: ArrayLike) -> NDArray[np.int32]:
        """Index of the voxel of a point, occupied or not."""
        return self._wrapped.get_voxel(column("point", point)).astype(np.int32)

    def get_voxel_center_coordinate(self, idx: ArrayLike) -> NDArray[np.float64]:
        """Center of an occupied voxel. Zero for others."""
        index = column("idx", idx)
        is_there = bool((self._wrapped.coordinates == index).all(axis=1).any())
        return self.origin + (index + 0.5) * self.voxel_size if is_there else np.zeros(3)

    def get_voxel_bounding_points(self, index: ArrayLike) -> Vector3dVector:
        """Corners of a voxel."""
        return Vector3dVector(self.origin + (column("index", index) + CORNERS) * self.voxel_size)

    def check_if_included(self, queries: Any) -> list[bool]:
        """For each point, True if it is in an occupied voxel."""
        return self._wrapped.check_if_included(as_array(queries)).tolist()

    def has_voxels(self) -> bool:
        return len(self._wrapped) > 0

    def has_colors(self) -> bool:
        """Always True, as in Open3D: voxels without colors are black."""
        return True

    def is_empty(self) -> bool:
        return not self.has_voxels()

    def get_min_bound(self) -> NDArray[np.float64]:
        low = self._wrapped.coordinates.min(axis=0) if self.has_voxels() else 0
        return self.origin + low * self.voxel_size

    def get_max_bound(self) -> NDArray[np.float64]:
        high = self._wrapped.coordinates.max(axis=0) + 1 if self.has_voxels() else 0
        return self.origin + high * self.voxel_size

    def get_center(self) -> NDArray[np.float64]:
        """Mean of the voxel centers."""
        return self._wrapped.centers.mean(axis=0) if self.has_voxels() else np.zeros(3)

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox(self.get_min_bound(), self.get_max_bound())

    def __repr__(self) -> str:
        return f"VoxelGrid with {len(self._wrapped)} voxels."
