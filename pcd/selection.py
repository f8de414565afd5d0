"""Choosing points of a cloud: by index, mask or slice, inside a box or polygon, the finite ones, each position once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, Self, SupportsIndex, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_indices, check_numeric, is_on_gpu, shown
from ..core.dropped_results import returns_new
from ..core.gpu_arrays import take_indices, take_mask, take_numbers
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.select import gather_rows, invert_mask, positions_of
from ..kernels.arrays.subsets import other_rows
from ..kernels.extent.masks import mask_finite
from ..kernels.lang import int32
from ..kernels.memory import upload
from ..kernels.sampling.duplicates import first_occurrences
from .bounding_box import BoundingBox
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .composition import Composition
from .length_doubts import warn_of_far
from .polygon_volume import SelectionPolygonVolume, mask_volume


class SupportsDLPack(Protocol):
    """An array of any library."""

    def __dlpack__(self, *args: Any, **kwargs: Any) -> Any: ...


KEYS = "an attribute's name, a slice, a mask of shape [n] or indices of shape [k]"


class Selection(Composition):
    """The part of PointCloud that chooses points."""

    @overload
    def __getitem__(self, key: str) -> NDArray[Any]: ...
    @overload
    def __getitem__(self, key: slice | Sequence[SupportsIndex] | NDArray[Any] | SupportsDLPack) -> Self: ...
    def __getitem__(self, key: Any) -> NDArray[Any] | Self:
        """An attribute by its name as NumPy, or points by a slice, a mask or indices, as NumPy selects rows.

        Args:
            key: A name, `points`, `normals` and `colors` among them; or a slice, booleans of shape [n], or whole
                numbers of shape [k], those below 0 counted from the end, on the host or on the cloud's device.

        Raises:
            KeyError, ValueError: No such attribute, or a mask of another shape.
            IndexError: An index beyond the cloud.
            TypeError: Another key; a single number, which could mean a cloud of one point or its coordinates.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 1], [2, 2, 2]])
            >>> len(cloud[:2]), cloud[[-1]].points.tolist(), len(cloud[cloud.points[:, 2] > 0.5])
            (2, [[2.0, 2.0, 2.0]], 2)
        """
        if isinstance(key, str):
            return super().__getitem__(key)
        if isinstance(key, slice):
            try:
                rows = np.arange(*key.indices(len(self)), dtype=np.int32)
            except TypeError as error:
                raise TypeError(f"cloud[...]: expected a slice of whole numbers, got {shown(key)}") from error
            return self._select_rows(upload(rows, int32, self.device))
        if isinstance(key, tuple) or key is None or key is Ellipsis:
            raise TypeError(f"cloud[...]: expected {KEYS}, got {shown(key)}; cloud.points[...] selects coordinates")
        chosen = take_numbers("cloud[...]", key, self.device) if is_on_gpu(key) else check_numeric("cloud[...]", key)
        if chosen.dtype in (np.bool_, wp.bool):
            return self.select_by_mask(chosen)
        if chosen.ndim != 1:
            hint = "; cloud[[i]] is a cloud of one point, cloud.points[i] its coordinates" if chosen.ndim == 0 else ""
            raise TypeError(f"cloud[...]: expected {KEYS}, got an array of shape {list(chosen.shape)}{hint}")
        return self.select_by_index(chosen)

    @returns_new
    def select_by_index(self, indices: ArrayLike, invert: bool = False) -> Self:
        """The points at some indices, in the order given, repeats kept; or with `invert` all others in their order.

        Open3D's legacy form sorts the indices and drops repeats; this one follows its tensor form.

        Raises:
            IndexError: An index beyond the cloud.
            TypeError: Not whole numbers.
        """
        what = {"of": f"cloud of {len(self)} points", "hint": "; for a mask see select_by_mask"}
        if is_on_gpu(indices):
            chosen = take_indices("indices", indices, self.device, len(self), **what)
            return self._select_rows(other_rows(chosen, len(self)) if invert else chosen)
        chosen = upload(check_indices("indices", indices, len(self), **what), int32, self.device)
        return self._select_rows(other_rows(chosen, len(self)) if invert else chosen)

    @returns_new
    def select_by_mask(self, mask: ArrayLike, invert: bool = False) -> Self:
        """The points where a boolean mask of shape [n] is set (or, inverted, is not).

        Raises:
            ValueError: Not booleans, or another shape.
        """
        if is_on_gpu(mask):
            return self._select_mask(take_mask("mask", mask, self.device, len(self)), invert)
        chosen = check_numeric("mask", mask)
        if chosen.dtype != np.bool_ or chosen.shape != (len(self),):
            raise ValueError(f"mask: expected booleans of shape [{len(self)}], got {chosen.dtype} {list(chosen.shape)}")
        return self._select_rows(upload(np.flatnonzero(chosen != invert).astype(np.int32), int32, self.device))

    @returns_new
    def crop(
        self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool = False
    ) -> Self:
        """The points inside a box, its faces included, or inside a polygon volume; or with `invert` all others.

        Raises:
            TypeError: No bounding box and no polygon volume.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 1], [2, 2, 2]])
            >>> len(cloud.crop(loom.AxisAlignedBoundingBox([0.5] * 3, [2] * 3)))
            2
        """
        points = self._arrays["points"]
        if isinstance(bounding_box, BoundingBox):
            mask = bounding_box.mask_points(points, self._origin)
        elif isinstance(bounding_box, SelectionPolygonVolume):
            mask = mask_volume(bounding_box, points, self._origin)
        else:
            remedy = "loom.AxisAlignedBoundingBox(min_bound, max_bound) is one"
            raise TypeError(f"bounding_box: expected a bounding box, got {type(bounding_box).__name__}; {remedy}")
        kept = self._select_mask(mask, invert)
        if len(self) and not len(kept) and not invert and not isinstance(bounding_box, SelectionPolygonVolume):
            self._doubt_box(bounding_box)
        return kept

    @returns_new
    def remove_non_finite_points(self, remove_nan: bool = True, remove_infinite: bool = True) -> Self:
        """The cloud without points that have a NaN or an infinite coordinate."""
        return self._select_mask(mask_finite(self._arrays["points"], remove_nan, remove_infinite))

    @returns_new
    def remove_duplicated_points(self) -> Self:
        """The cloud with each position once: the first point there, with its own attributes, in the old order.

        Positions are equal where all three float32 coordinates are, zero and minus zero among them; points that
        differed in float64 alone have become one when the cloud was made. Points with a NaN equal none and are kept,
        as Open3D keeps them; `remove_non_finite_points()` drops them. O(n log n), 40 B of memory a point for the time
        of the call.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[1, 0, 0], [0, 0, 0], [1, 0, 0]], row=[0, 1, 2])
            >>> cloud.remove_duplicated_points()["row"].tolist()
            [0, 1]
        """
        return self._select_rows(first_occurrences(self._arrays["points"]))

    # ------------------------------------------------------------------------------------------ internals

    def _select_rows(self, rows: wp.array) -> Self:
        """The points of these rows, in their order: `select_by_index` for a device array of int32, unchecked."""
        return self._with_arrays({name: gather_rows(values, rows) for name, values in self._arrays.items()})

    def _doubt_box(self, box: AxisAlignedBoundingBox | OrientedBoundingBox) -> None:
        """Warn where a box that holds no point is of other coordinates than the cloud."""
        low, high, finite = bound_points(self._arrays["points"])
        if finite:
            own = low + self._origin, high + self._origin
            warn_of_far("bounding_box", box.get_min_bound(), box.get_max_bound(), *own, finite, self.unit)

    def _select_mask(self, mask: wp.array, invert: bool = False) -> Self:
        return self._select_rows(positions_of(invert_mask(mask) if invert else mask))
