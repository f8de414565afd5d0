"""What a DistanceField holds, as dense arrays and layers."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

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
    """The distances in one layer of voxels of a DistanceField.

    Attributes:
        distances: [m], float32 [h, w]: rows along the later of the two other axes, columns along the earlier, both
            ascending, so that row 0 is the bottom of a map. `max_distance` where they are not known, NaN outside of a
            dense box.
        is_known: Whether they are known, bool [h, w].
        axis: "x", "y" or "z": what the layer is perpendicular to.
        position: Of the voxels' centres along it [m].
        extent: The lowest and the highest corner of the layer along the two other axes [m], float64 [2, 2].
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
        """The names of the axes of columns and of rows."""
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
    _blocks: DistanceBlocks
    _grid: DistanceGrid

    @property
    def bounds(self) -> NDArray[np.float64]:
        """The lowest and the highest corner of what is held [m], float64 [2, 3]: of the array, else of the blocks."""
        return self.origin + np.array(self._voxel_bounds()) * self.voxel_size

    def _voxel_bounds(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The first voxel that is held, and the one behind the last."""
        if self.shape is not None:
            return np.zeros(3, np.int64), np.array(self.shape, np.int64)
        return voxels_of_blocks(download(self._blocks.keys))  # sync

    def _box(self, bounds: Any, layer: tuple[int, int] | None = None) -> Box:
        """The voxels in bounds [m]; those of a layer: (the number of its axis, its place along it)."""
        if bounds is None:
            low, high = self._voxel_bounds()
        else:
            beyond = "reach further from the origin than blocks can"
            low, high = voxels_in_bounds(bounds, self.origin, self.voxel_size, queries.OUTERMOST, beyond)
        if layer is not None:
            low[layer[0]], high[layer[0]] = layer[1], layer[1] + 1
        count, (x, y, z), size = math.prod((high - low).tolist()), low.tolist(), (high - low).tolist()
        if count >= 2**31:
            raise ValueError(f"bounds: {' x '.join(map(str, size))} voxels are more than 2^31; give smaller bounds")
        check_room(self.device, 6 * count, f"{count:,} voxels")
        return Box((x, y, z), (size[0], size[1], size[2]))

    def to_array(self, bounds: ArrayLike | None = None, *, values: str = "distances") -> NDArray[Any]:
        """The field as a dense array of NumPy.

        Args:
            bounds: The lowest and the highest corner [m], shape [2, 3]: voxels that reach inside are taken; None takes
                `bounds`.
            values: "distances" [m], float32, `max_distance` where they are not known; "squared" [voxels^2], int32,
                2^31 - 1 there; "nearest", int32, the rows of `occupied_voxels`, -1 there; or "known", bool.

        Returns:
            Shape [x, y, z].

        Raises:
            ValueError: Bounds that are none, or no such values.
            MemoryError: There is no room for so many voxels.

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
            found = download(queries.list_sqdists(box, self._grid))  # sync
        elif values == "nearest":
            found = download(queries.list_nearest(box, self._grid))  # sync
        else:
            distances, known = queries.list_distances(box, self._grid)
            found = download(distances) if values == "distances" else download(known).view(np.bool_)  # sync
        return np.array(found).reshape(box.size)

    def slice(self, axis: str, position: float, *, bounds: ArrayLike | None = None) -> FieldSlice:
        """The distances in one layer of voxels.

        Args:
            axis: "x", "y" or "z": what the layer is perpendicular to.
            position: Where along it [m].
            bounds: The lowest and the highest corner [m], shape [2, 3]; None takes `bounds`.

        Returns:
            A FieldSlice; `draw_slice` makes a picture of it.

        Raises:
            ValueError: No such axis, or a position or bounds that are none.

        Example:
            >>> import pointloom as loom
            >>> field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, max_distance=2)
            >>> field.slice("z", 0.5, bounds=[[0, 0, 0], [3, 2, 1]]).distances.tolist()
            [[0.0, 1.0, 2.0], [1.0, 1.4142135381698608, 2.0]]
        """
        along = check_axis(axis)
        number = check_number("position", position)
        place = (number - float(self.origin[along])) / self.voxel_size
        if not abs(place) < queries.OUTERMOST:
            raise ValueError(f"position: {number:g} m is further from the origin than blocks can be")
        layer = math.floor(place)
        low, size = thin = self._box(bounds, (along, layer))
        distances, known = (np.array(download(a)).reshape(size) for a in queries.list_distances(thin, self._grid))
        corners = self.origin + np.array([low, np.add(low, size)]) * self.voxel_size
        flat = [k for k in range(3) if k != along]
        return FieldSlice(
            np.squeeze(distances, along).T,
            np.squeeze(known, along).T.astype(np.bool_),
            AXES[along],
            float(self.origin[along] + (layer + 0.5) * self.voxel_size),
            corners[:, flat],
            self.max_distance,
        )


def check_axis(axis: Any) -> int:
    """Which of the axes it is.

    Raises:
        ValueError: None.
    """
    if not isinstance(axis, str) or axis not in AXES:
        raise ValueError(f"axis: expected x, y or z, got {shown(axis)}")
    return AXES.index(axis)
