"""Base of bounding boxes: color and point tests."""

from __future__ import annotations

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out, hand_out_host, library_of
from ..core.attribute_hints import KnownNames
from ..core.checks import check_rows, check_shape, is_on_gpu
from ..core.devices import resolve_device
from ..core.gpu_arrays import take_points
from ..core.html_tables import html_table
from ..kernels.arrays.select import positions_of
from .point_arrays import PointArrays
from .stored_arrays import read_only

BOX_REMEDY = "create one with loom.AxisAlignedBoundingBox(min_bound, max_bound)"  # of errors of other arguments


class BoundingBox(KnownNames):
    """Base of bounding boxes: color and point tests."""

    def __init__(self, color: ArrayLike):
        self.color = color

    def _repr_html_(self) -> str:
        sides = {"center [m]": self.get_center(), "sides [m]": self.get_extent()}
        return html_table(type(self).__name__, ((name, np.round(row, 6).tolist()) for name, row in sides.items()))

    def get_center(self) -> NDArray[np.float64]:
        """Center [m], shape (3,)."""
        raise NotImplementedError

    def get_extent(self) -> NDArray[np.float64]:
        """Lengths of the sides [m], shape (3,)."""
        raise NotImplementedError

    @property
    def color(self) -> NDArray[np.float64]:
        """Display color, 0..1, shape (3,); assignable."""
        return read_only(self._color.copy())

    @color.setter
    def color(self, values: ArrayLike) -> None:
        color = check_shape("color", values, (3,))
        if not ((color >= 0) & (color <= 1)).all():
            raise ValueError(f"color: expected three numbers 0..1, got {color.tolist()}")
        self._color = color.copy()

    def get_point_indices_within_bounding_box(self, points: ArrayLike | PointArrays) -> NDArray[np.int64]:
        """Ascending indices of the points inside (faces included), of a cloud or an array (n, 3)."""
        if isinstance(points, PointArrays):
            mask = self.mask_points(points.arrays["points"], points.origin)
            return points.arrays.hand_out(positions_of(mask), dtype=np.int64)
        library = library_of(points)
        if is_on_gpu(points):
            mask = self.mask_points(*take_points("points", points, None))
            return hand_out(positions_of(mask), library, dtype=np.int64)
        rows = np.flatnonzero(self._contains(check_rows("points", points, 3, dtype=np.float64)))
        return hand_out_host(rows, library, resolve_device("cpu"))

    def mask_points(self, points: wp.array, origin: NDArray[np.float64]) -> wp.array:
        """Uint8 device mask of the vec3 points (relative to an origin) inside."""
        raise NotImplementedError

    def _contains(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        raise NotImplementedError
