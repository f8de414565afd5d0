"""A mesh as voxels: those that its surface touches, and those that it encloses."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_positive, check_shape
from ...kernels.arrays.bounds import box_of, find_extremes
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.arrays.side_by_side import read_together
from ...kernels.memory import download
from ...kernels.meshes.mesh_topology import Topology, find_topology, topology_of
from ...kernels.rays.solid_voxels import crossed_columns, inner_voxels
from ...kernels.rays.triangle_voxels import VoxelFrame, settle, touched_columns, touched_voxels, voxels_of
from .mesh_measures import MeshMeasures
from .voxel_grid import VoxelGrid

LONGEST = 1e30  # [m] of a coordinate
MOST_KEYS = 2**62
MOST_CELLS = 2**30  # along an axis


class MeshVoxels(MeshMeasures):
    """The part of TriangleMesh that turns it into voxels."""

    def voxelize(
        self,
        voxel_size: float,
        min_bound: ArrayLike | None = None,
        max_bound: ArrayLike | None = None,
        *,
        solid: bool = False,
    ) -> VoxelGrid:
        """The voxels of a regular grid that the surface touches, and on demand those that it encloses.

        As Open3D's `VoxelGrid.create_from_triangle_mesh` and `..._within_bounds`: the grid begins half a voxel below
        the lowest coordinates, or at `min_bound`, and has as many voxels as `max_bound` (half a voxel above the highest
        coordinates) is away in voxels, rounded.

        Args:
            voxel_size: Edge of a voxel [m].
            min_bound: The lowest corner of the grid [m], shape [3].
            max_bound: Its highest corner [m].
            solid: Also the voxels whose centres the surface encloses, by parity: of two surfaces, one in the other,
                what lies between. The mesh has to be closed; which way its triangles turn does not matter.

        Returns:
            The grid with its occupied voxels, all of them within the bounds (Open3D's may lie outside). A voxel that a
            triangle but touches from outside, to a billionth of a voxel, is occupied (in Open3D sometimes). Triangles
            with a corner that is not finite touch none.

        Raises:
            ValueError: A size or bounds that are no finite numbers or enclose nothing, 2^30 voxels along an axis, more
                than 2^31 - 1 of them to look at; for `solid` also an edge that does not belong to exactly two triangles
                or a vertex that is not finite.
            TypeError: No numbers.
            MemoryError: The device has no room for the voxels; refused before they are allocated.

        Notes:
            8 B of memory a column of voxels over each triangle, about 50 B a voxel of each triangle, 50 B a voxel
            inside. Same voxels from run to run and on every device. Akenine-Moller 2001.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box(4, 4, 4)
            >>> len(box.voxelize(1)), len(box.voxelize(1, solid=True))
            (98, 125)
        """
        size = check_positive("voxel_size", voxel_size, maximum=LONGEST)
        extremes, findings = self._examined(solid)  # sync
        low, high = self._bounds_of_voxels(box_of(extremes), size, min_bound, max_bound)
        with np.errstate(over="ignore"):
            reach = np.floor((high - low) / size + 0.5)
        if not (reach < MOST_CELLS).all():
            raise ValueError(
                "voxel_size, min_bound, max_bound: expected less than 2^30 voxels along an axis, got "
                f"{reach.max():g}; take larger voxels"
            )
        counts = (int(reach[0]), int(reach[1]), int(reach[2]))
        if math.prod(counts) >= MOST_KEYS:
            raise ValueError(
                f"voxel_size: a grid of {' x '.join(map(str, counts))} has more than 2^62 voxels; take larger voxels"
            )
        if solid:
            self._check_closed(topology_of(findings), box_of(extremes)[2])
        cells = np.empty((0, 3), np.int32)
        if min(counts) > 0 and len(self):
            vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
            frame = VoxelFrame(low, size, counts)
            columns = [touched_columns(vertices, triangles, frame)]
            if solid:
                columns.append(crossed_columns(vertices, triangles, frame))
            settle(columns)  # sync
            keys = touched_voxels(columns[0])
            if solid:
                keys = concatenate_rows([keys, inner_voxels(columns[1], frame)])  # sync
            cells = download(voxels_of(keys, frame)).reshape(-1, 3).astype(np.int32)
        return VoxelGrid(low + self._origin, size, counts, cells)

    def _examined(self, solid: bool) -> list[NDArray[Any]]:
        """What the box of the vertices is told from, and the topology, which only solids ask for; one sync."""
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        arrays: list[Any] = [find_extremes(vertices)]
        if solid:
            arrays.append(find_topology(triangles, vertices.size))
        return [*read_together(arrays), np.ones(4)][:2]  # sync

    def _bounds_of_voxels(
        self,
        box: tuple[NDArray[Any], NDArray[Any], int],
        size: float,
        min_bound: ArrayLike | None,
        max_bound: ArrayLike | None,
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The corners of the grid, relative to the mesh's origin."""
        low, high, count = box
        at_low = low.astype(np.float64) - size * 0.5 if count else -np.full(3, size * 0.5)
        at_high = high.astype(np.float64) + size * 0.5 if count else np.full(3, size * 0.5)
        if min_bound is not None:
            at_low = _check_corner("min_bound", min_bound) - self._origin
        if max_bound is not None:
            at_high = _check_corner("max_bound", max_bound) - self._origin
        if not (at_low <= at_high).all():
            shown = f"{(at_low + self._origin).tolist()} and {(at_high + self._origin).tolist()}"
            raise ValueError(f"min_bound, max_bound: expected the lower corner first, got {shown}")
        return at_low, at_high

    def _check_closed(self, topology: Topology, finite_count: int) -> None:
        if not len(self) or topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(
                "voxelize: solid wants a closed mesh, with two triangles at every edge; merge vertices at one place, "
                "or fill its holes first"
            )
        if finite_count < self._arrays["vertices"].size:
            raise ValueError("voxelize: solid wants finite vertices, and some are not")


def _check_corner(name: str, values: ArrayLike) -> NDArray[np.float64]:
    corner = check_finite(name, check_shape(name, values, (3,)))
    if np.abs(corner).max() > LONGEST:
        raise ValueError(f"{name}: expected coordinates up to {LONGEST:g} m, got {corner.tolist()}")
    return corner
