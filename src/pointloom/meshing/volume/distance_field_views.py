"""Dense arrays and slices of a DistanceField."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import NUMPY, hand_out, hand_out_host
from ...core.checks import check_number, shown
from ...kernels.memory import check_room, download
from ...kernels.volumes import distance_queries as queries
from ...kernels.volumes.distance_blocks import DistanceBlocks
from ...kernels.volumes.distance_queries import Box, DistanceGrid
from .voxel_boxes import voxels_in_bounds, voxels_of_blocks

AXES = ("x", "y", "z")
VALUES = ("distances", "squared", "nearest", "known")


@dataclass(frozen=True, eq=False)
class FieldSlice:
    """Distances in one layer of voxels of a DistanceField.

    Attributes:
        distances: [m], float32 (h, w): rows along the later of the other axes, columns along the earlier, ascending;
            `max_distance` if unknown, NaN outside a dense box.
        is_known: Known distances, bool (h, w).
        axis, position: Normal axis "x", "y" or "z", and position of the voxel centers along it [m].
        extent: Lowest and highest corner along the other axes [m], float64 (2, 2).
        max_distance: As of the field.
    """

    distances: NDArray[np.float32]
    is_known: NDArray[np.bool_]
    axis: str
    position: float
    extent: NDArray[np.float64]
    max_distance: float | None

    @property
    def axes(self) -> tuple[str, str]:
        """Names of the axes of columns and rows."""
        first, second = (name for name in AXES if name != self.axis)
        return first, second

    def __repr__(self) -> str:
        rows, columns = self.distances.shape
        return f"FieldSlice({self.axis} = {self.position:g} m, {columns} x {rows} voxels)"


class FieldViews:
    """Dense arrays and layers of voxels."""

    device: Any
    voxel_size: float
    max_distance: float | None
    origin: NDArray[np.float64]
    shape: tuple[int, int, int] | None
    blocks: DistanceBlocks
    _grid: DistanceGrid
    _library: str = NUMPY  # library of returned arrays, see src/pointloom/core/array_libraries.py

    @property
    def array_library(self) -> str:
        """Library of the arrays that operations without an array argument return: that of the source."""
        return self._library

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Lowest and highest corner of the array or the blocks [m], float64 (2, 3)."""
        return self.origin + np.array(self._voxel_bounds()) * self.voxel_size

    def _voxel_bounds(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """First stored voxel, and the one after the last."""
        if self.shape is not None:
            return np.zeros(3, np.int64), np.array(self.shape, np.int64)
        return voxels_of_blocks(download(self.blocks.keys))  # sync

    def _box(self, bounds: ArrayLike | None, layer: tuple[int, int] | None = None) -> Box:
        """Voxels in bounds [m]; those of a layer: (axis index, position along it)."""
        if bounds is None:
            low, high = self._voxel_bounds()
        else:
            beyond = "exceed the range of block indices around the origin"
            low, high = voxels_in_bounds(bounds, self.origin, self.voxel_size, queries.MAX_QUERY_VOXELS, beyond)
        if layer is not None:
            low[layer[0]], high[layer[0]] = layer[1], layer[1] + 1
        count, (x, y, z), size = math.prod((high - low).tolist()), low.tolist(), (high - low).tolist()
        if count >= 2**31:
            raise ValueError(f"bounds: {' x '.join(map(str, size))} voxels are more than 2^31. Use smaller bounds")
        check_room(self.device, 6 * count, f"{count:,} voxels")
        return Box((x, y, z), (size[0], size[1], size[2]))

    def to_array(self, bounds: ArrayLike | None = None, *, values: str = "distances") -> NDArray[Any]:
        """Field as a dense array of shape (x, y, z).

        Args:
            bounds: Lowest and highest corner [m], shape (2, 3). Overlapping voxels are included. If None: `bounds`.
            values: "distances" [m], float32, `max_distance` if unknown; "squared" [voxels^2], int32, 2^31 - 1 if
                unknown; "nearest", int32 rows of `occupied_voxels`, -1 if unknown; or "known", bool.

        Raises:
            ValueError, MemoryError: If the bounds or `values` are invalid, or if the array does not fit into memory.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, max_distance=2)
            >>> field.to_array([[0, 0, 0], [4, 1, 1]]).ravel().tolist()
            [0.0, 1.0, 2.0, 2.0]
            >>> field.to_array([[0, 0, 0], [4, 1, 1]], values="known").ravel().tolist()
            [True, True, True, False]
        """
        if not isinstance(values, str) or values not in VALUES:
            raise ValueError(f"values: expected one of {', '.join(VALUES)}, got {shown(values)}")
        box = self._box(bounds)
        if values == "squared":
            return hand_out(queries.list_sqdists(box, self._grid), self._library, shape=box.size)
        if values == "nearest":
            return hand_out(queries.list_nearest(box, self._grid), self._library, shape=box.size)
        distances, known = queries.list_distances(box, self._grid)
        if values == "distances":
            return hand_out(distances, self._library, shape=box.size)
        return hand_out(known, self._library, dtype=np.bool_, shape=box.size)

    def slice(self, axis: str, position: float, *, bounds: ArrayLike | None = None) -> FieldSlice:
        """Distances in one layer of voxels, for `draw_slice`.

        Args:
            axis: Normal axis: "x", "y" or "z".
            position: Position along it [m].
            bounds: Lowest and highest corner [m], shape (2, 3). If None: `bounds`.

        Raises:
            ValueError: If the axis, position or bounds are invalid.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, max_distance=2)
            >>> field.slice("z", 0.5, bounds=[[0, 0, 0], [3, 2, 1]]).distances.tolist()
            [[0.0, 1.0, 2.0], [1.0, 1.4142135381698608, 2.0]]
        """
        along = check_axis(axis)
        number = check_number("position", position)
        cell = (number - float(self.origin[along])) / self.voxel_size
        if not abs(cell) < queries.MAX_QUERY_VOXELS:
            raise ValueError(f"position: {number:g} m exceeds the range of block indices around the origin")
        layer = math.floor(cell)
        low, size = thin = self._box(bounds, (along, layer))
        distances, known = (np.array(download(a)).reshape(size) for a in queries.list_distances(thin, self._grid))
        library, device = self._library, self.device
        corners = self.origin + np.array([low, np.add(low, size)]) * self.voxel_size
        flat = [k for k in range(3) if k != along]
        return FieldSlice(
            hand_out_host(np.squeeze(distances, along).T, library, device),
            hand_out_host(np.squeeze(known, along).T.astype(np.bool_), library, device),
            AXES[along],
            float(self.origin[along] + (layer + 0.5) * self.voxel_size),
            corners[:, flat],
            self.max_distance,
        )


def check_axis(axis: object) -> int:
    if not isinstance(axis, str) or axis not in AXES:
        raise ValueError(f"axis: expected x, y or z, got {shown(axis)}")
    return AXES.index(axis)
