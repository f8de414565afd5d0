"""VoxelGrid: which cells of a regular grid are occupied."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_rows, check_shape
from ...core.devices import resolve_device
from ...kernels.memory import check_room
from ...pcd.point_arrays import read_only


class VoxelGrid:
    """The occupied voxels of a regular grid, as `TriangleMesh.voxelize` gives them; `len(grid)` counts them.

    Attributes:
        origin: The lowest corner of voxel (0, 0, 0) [m], float64 [3].
        voxel_size: Edge of a voxel [m].
        counts: Voxels of the whole grid along x, y and z.
        coordinates: The occupied voxels, int32 [k, 3], ascending by x, then y, then z; on the host.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
        >>> grid = mesh.voxelize(1)
        >>> grid
        VoxelGrid(8 of 3 x 3 x 1 voxels of 1 m)
        >>> grid.dense()[:, :, 0].astype(int).tolist()
        [[1, 1, 1], [1, 1, 1], [1, 1, 0]]
    """

    def __init__(
        self,
        origin: NDArray[np.float64],
        voxel_size: float,
        counts: tuple[int, int, int],
        coordinates: NDArray[np.int32],
    ):
        self.origin, self.voxel_size, self.counts = read_only(origin), voxel_size, counts
        self.coordinates = read_only(coordinates)

    def __len__(self) -> int:
        return len(self.coordinates)

    def __repr__(self) -> str:
        x, y, z = self.counts
        return f"VoxelGrid({len(self)} of {x} x {y} x {z} voxels of {self.voxel_size:g} m)"

    @property
    def centers(self) -> NDArray[np.float64]:
        """The centres of the occupied voxels [m], float64 [k, 3]."""
        return self.origin + (self.coordinates + 0.5) * self.voxel_size

    def dense(self) -> NDArray[np.bool_]:
        """The whole grid, one byte a voxel, shape `counts`.

        Raises:
            MemoryError: There is no room for so many voxels.
        """
        size = math.prod(self.counts)
        check_room(resolve_device("cpu"), size, f"a dense grid of {size:,} voxels")
        grid = np.zeros(self.counts, bool)
        grid[tuple(self.coordinates.T)] = True
        return grid

    def get_voxel(self, point: ArrayLike) -> NDArray[np.int64]:
        """The voxel in which a point [m] lies, int64 [3], inside the grid or not, occupied or not.

        Raises:
            ValueError: Not three finite numbers.
            TypeError: No numbers.
        """
        place = check_finite("point", check_shape("point", point, (3,)))
        return np.floor((place - self.origin) / self.voxel_size).astype(np.int64)

    def check_if_included(self, queries: ArrayLike) -> NDArray[np.bool_]:
        """Whether points [m], shape [n, 3], lie in occupied voxels.

        Raises:
            ValueError: Another shape.
            TypeError: No numbers.
        """
        points = check_rows("queries", queries, 3, dtype=np.float64)
        with np.errstate(invalid="ignore"):
            cells = np.floor((points - self.origin) / self.voxel_size)
            inside = ((cells >= 0) & (cells < self.counts)).all(axis=1)
        included = np.zeros(len(points), bool)
        occupied = np.ravel_multi_index(tuple(self.coordinates.T), self.counts)
        asked = np.ravel_multi_index(tuple(cells[inside].astype(np.int64).T), self.counts)
        included[inside] = np.isin(asked, occupied)
        return included
