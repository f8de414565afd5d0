"""VoxelGrid: occupied cells of a regular grid."""

from __future__ import annotations

import math
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import HintedNames
from ...core.checks import check_finite, check_rows, check_shape
from ...core.devices import resolve_device
from ...core.exchange import hand_back, on_host
from ...kernels.memory import check_room
from ...pcd.stored_arrays import read_only
from .mesh_arrays import check_mesh


class VoxelGrid(HintedNames):
    """Occupied voxels of a regular grid, as of `TriangleMesh.voxelize`; `len(grid)` counts them.

    Attributes:
        origin: Lowest corner of voxel (0, 0, 0) [m], float64 (3,).
        voxel_size: Edge of a voxel [m].
        counts: Number of voxels along x, y and z.
        coordinates: Occupied voxels, int32 (k, 3), sorted by x, y, z, on the host.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
        >>> grid = mesh.voxelize(1)
        >>> grid
        VoxelGrid(8 of 3 x 3 x 1 voxels of 1 m)
        >>> grid.dense()[:, :, 0].astype(int).tolist()
        [[1, 1, 1], [1, 1, 1], [1, 1, 0]]
    """

    origin: NDArray[np.float64]
    voxel_size: float
    counts: tuple[int, int, int]
    coordinates: NDArray[np.int32]

    def __init__(
        self,
        origin: NDArray[np.float64],
        voxel_size: float,
        counts: tuple[int, int, int],
        coordinates: NDArray[np.int32],
    ):
        self.origin, self.voxel_size, self.counts = read_only(origin), voxel_size, counts
        self.coordinates = read_only(coordinates)

    @classmethod
    def create_from_triangle_mesh(cls, input: Any, voxel_size: float) -> Self:
        """Voxels that a mesh touches. See `TriangleMesh.voxelize`."""
        check_mesh("input", input)
        return input.voxelize(voxel_size)

    @classmethod
    def create_from_triangle_mesh_within_bounds(
        cls, input: Any, voxel_size: float, min_bound: ArrayLike, max_bound: ArrayLike
    ) -> Self:
        """Voxels between two corners [m] that a mesh touches. See `TriangleMesh.voxelize`."""
        check_mesh("input", input)
        return input.voxelize(voxel_size, min_bound, max_bound)

    def __len__(self) -> int:
        return len(self.coordinates)

    def __repr__(self) -> str:
        x, y, z = self.counts
        return f"VoxelGrid({len(self)} of {x} x {y} x {z} voxels of {self.voxel_size:g} m)"

    @property
    def centers(self) -> NDArray[np.float64]:
        """Centers of the occupied voxels [m], float64 (k, 3)."""
        return self.origin + (self.coordinates + 0.5) * self.voxel_size

    def dense(self) -> NDArray[np.bool_]:
        """Complete grid as booleans of shape `counts`.

        Raises:
            MemoryError: If the array does not fit into memory.
        """
        size = math.prod(self.counts)
        check_room(resolve_device("cpu"), size, f"a dense grid of {size:,} voxels")
        grid = np.zeros(self.counts, bool)
        grid[tuple(self.coordinates.T)] = True
        return grid

    def get_voxel(self, point: ArrayLike) -> NDArray[np.int64]:
        """Voxel that contains a point [m], shape (3,), int64 (3,), also outside the grid.

        Raises:
            ValueError, TypeError: If the point is not three finite numbers, or the voxel exceeds 64 bits.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box().voxelize(0.25).get_voxel([0.3, 0.3, 0.9]).tolist()
            [1, 1, 4]
        """
        cell = self._cells_of(check_finite("point", check_shape("point", point, (3,))))
        if np.abs(cell).max() >= 2.0**63:
            raise ValueError(
                f"point: is {np.abs(cell).max():.3g} voxels from the origin, beyond the range of 64-bit indices"
            )
        return cell.astype(np.int64)

    def check_if_included(self, queries: ArrayLike) -> NDArray[np.bool_]:
        """True where points [m], shape (n, 3), are in occupied voxels, computed on the host.

        Raises:
            ValueError, TypeError: If the array has a wrong shape or is not numeric.
        """
        cells = self._cells_of(check_rows("queries", on_host("queries", queries), 3, dtype=np.float64))
        with np.errstate(invalid="ignore"):
            inside = ((cells >= 0) & (cells < self.counts)).all(axis=1)
        included = np.zeros(len(cells), bool)
        occupied = np.ravel_multi_index(tuple(self.coordinates.T), self.counts)
        queried = np.ravel_multi_index(tuple(cells[inside].astype(np.int64).T), self.counts)
        included[inside] = np.isin(queried, occupied)
        return hand_back(included, queries)

    def _cells_of(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        with np.errstate(invalid="ignore", over="ignore"):
            return np.floor((points - self.origin) / self.voxel_size)
