"""VoxelGrid: occupied cells of a regular grid."""

from __future__ import annotations

import math
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import HintedNames
from ...core.checks import check_finite, check_positive, check_rows, check_shape
from ...core.devices import resolve_device
from ...core.exchange import hand_back, on_host
from ...kernels.arrays.bounds import box_of, find_extremes
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.side_by_side import read_together
from ...kernels.memory import check_room, download
from ...kernels.meshes.mesh_topology import Topology, find_topology, topology_of
from ...kernels.rays.solid_voxels import crossed_columns, inner_voxels
from ...kernels.rays.triangle_voxels import VoxelFrame, read_counts, touched_columns, touched_voxels, voxels_of
from ...pcd.stored_arrays import read_only
from .mesh_arrays import MeshArrays, check_mesh

MAX_COORDINATE = 1e30  # [m] limit of coordinates
MAX_KEYS = 2**62
MAX_CELLS = 2**30  # along an axis


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


def voxelize(
    mesh: MeshArrays, voxel_size: float, min_bound: ArrayLike | None, max_bound: ArrayLike | None, *, solid: bool
) -> VoxelGrid:
    """As `TriangleMesh.voxelize`."""
    size = check_positive("voxel_size", voxel_size, maximum=MAX_COORDINATE)
    extremes, findings = _examined(mesh, solid)  # sync
    low, high = _bounds_of_voxels(mesh, box_of(extremes), size, min_bound, max_bound)
    with np.errstate(over="ignore"):
        size_in_voxels = np.floor((high - low) / size + 0.5)
    if not (size_in_voxels < MAX_CELLS).all():
        raise ValueError(
            "voxel_size, min_bound, max_bound: expected fewer than 2^30 voxels along an axis, got "
            f"{size_in_voxels.max():g}. Use larger voxels"
        )
    counts = (int(size_in_voxels[0]), int(size_in_voxels[1]), int(size_in_voxels[2]))
    if math.prod(counts) >= MAX_KEYS:
        raise ValueError(
            f"voxel_size: a grid of {' x '.join(map(str, counts))} has more than 2^62 voxels. Use larger voxels"
        )
    if solid:
        _check_closed(mesh, topology_of(findings), box_of(extremes)[2])
    cells = np.empty((0, 3), np.int32)
    if min(counts) > 0 and len(mesh):
        vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
        frame = VoxelFrame(low, size, counts)
        columns = [touched_columns(vertices, triangles, frame)]
        if solid:
            columns.append(crossed_columns(vertices, triangles, frame))
        read_counts(columns)  # sync
        keys = touched_voxels(columns[0])
        if solid:
            keys = concatenate_rows([keys, inner_voxels(columns[1], frame)])  # sync
        cells = download(voxels_of(keys, frame)).reshape(-1, 3).astype(np.int32)
    return VoxelGrid(low + mesh.arrays.origin, size, counts, cells)


def _examined(mesh: MeshArrays, solid: bool) -> list[NDArray[Any]]:
    """Download the bounds of the vertices and, for solids, the topology. One sync."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    arrays: list[Any] = [find_extremes(vertices)]
    if solid:
        arrays.append(find_topology(triangles, vertices.size))
    return [*read_together(arrays), np.ones(4)][:2]  # sync


def _bounds_of_voxels(
    mesh: MeshArrays,
    box: tuple[NDArray[Any], NDArray[Any], int],
    size: float,
    min_bound: ArrayLike | None,
    max_bound: ArrayLike | None,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Corners of the grid relative to the mesh's origin."""
    low, high, count = box
    at_low = low.astype(np.float64) - size * 0.5 if count else -np.full(3, size * 0.5)
    at_high = high.astype(np.float64) + size * 0.5 if count else np.full(3, size * 0.5)
    if min_bound is not None:
        at_low = _check_corner("min_bound", min_bound) - mesh.arrays.origin
    if max_bound is not None:
        at_high = _check_corner("max_bound", max_bound) - mesh.arrays.origin
    if not (at_low <= at_high).all():
        shown = f"{(at_low + mesh.arrays.origin).tolist()} and {(at_high + mesh.arrays.origin).tolist()}"
        raise ValueError(f"min_bound, max_bound: expected the lower corner first, got {shown}")
    return at_low, at_high


def _check_closed(mesh: MeshArrays, topology: Topology, finite_count: int) -> None:
    if not len(mesh) or topology.has_boundary or topology.has_crowded_edge:
        raise ValueError(
            "voxelize: solid=True requires a closed mesh, with two triangles at every edge. Merge vertices "
            "or fill holes first"
        )
    if finite_count < mesh.arrays["vertices"].size:
        raise ValueError("voxelize: solid=True requires finite vertices, got NaN or infinite ones")


def _check_corner(name: str, values: ArrayLike) -> NDArray[np.float64]:
    corner = check_finite(name, check_shape(name, values, (3,)))
    if np.abs(corner).max() > MAX_COORDINATE:
        raise ValueError(f"{name}: expected coordinates up to {MAX_COORDINATE:g} m, got {corner.tolist()}")
    return corner
