"""Selection of points: indices, masks, boxes, outliers, down-sampling, and concatenation of clouds."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Protocol, Self, SupportsIndex, overload

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out, hand_out_host, view_as
from ..core.checks import (
    check_color,
    check_count,
    check_finite,
    check_indices,
    check_name,
    check_numeric,
    check_positive,
    check_seed,
    check_shape,
    is_on_gpu,
    shown,
)
from ..core.devices import check_same_device
from ..core.dropped_results import returns_new
from ..core.gpu_arrays import take_indices, take_mask, take_numbers
from ..core.joined_parts import ESTIMATED, common_names
from ..core.units import warn_of_units
from ..core.verbosity import printed_duration
from ..kernels.arrays.bounds import Box, bound_points
from ..kernels.arrays.concatenation import concatenate_points
from ..kernels.arrays.duplicates import first_occurrences
from ..kernels.arrays.run_sums import average_vec3, first_rows, sum_columns
from ..kernels.arrays.select import gather_rows, invert_mask, positions_of
from ..kernels.arrays.subsets import draw_rows, other_rows, sort_rows, step_rows
from ..kernels.extent.masks import mask_finite
from ..kernels.lang import float64, int32, vec3
from ..kernels.memory import cast, download, full, upload
from ..kernels.sampling.farthest_points import choose_farthest
from ..kernels.sampling.voxel_keys import VoxelGroups
from ..kernels.sampling.voxel_traces import commonest_rows, nearest_to_means, nearest_to_middles, trace_voxels
from ..kernels.search.neighbor_distances import average_distances, mask_up_to, mean_and_deviation
from ..kernels.segmentation.neighbor_counts import mask_crowded
from .attribute_columns import concatenate_columns
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .las_attributes import with_common_las_attributes
from .length_checks import MAX_SPARSE_FRACTION, check_order, warn_of_far, warn_of_long, warn_of_sparse
from .point_arrays import VECTORS, PointArrays, check_cloud, list_clouds
from .polygon_volume import SelectionPolygonVolume, mask_cropped
from .units import common_reference
from .voxel_trace import VoxelTrace

_NO_SUM = (
    "a cloud and a {} cannot be added: cloud.translate(vector) moves it, cloud.points = array sets its points, and "
    "cloud + loom.PointCloud({}) adds points"
)
MAX_POINTS = 2**31 - 1  # 32-bit indices
KEYS = "an attribute's name, a slice, a mask of shape [n] or indices of shape [k]"
MEAN_ROUNDING = 1 + 1e-12  # the mean of equal distances may round below them
CELL_LIMIT = 2.0**53  # cells from the corner: exact integers in float64
REDUCTIONS = ("mean", "nearest", "most_frequent")
WITHIN_ONE = 8  # maximum cells of a cloud that is smaller than one cell
OPEN3D_CELLS = 2**31 - 1  # Open3D counts the cells between the bounds in 32 bits


class SupportsDLPack(Protocol):
    def __dlpack__(self, *args: Any, **kwargs: Any) -> Any: ...


def _warn_of_fewer(count: int, requested: int) -> None:
    if count < requested:
        reason = "the other points are duplicates or not finite. Remove them before you choose a number"
        warn_of_units(f"num_samples: expected {requested} points, got {count}, because {reason}", UserWarning)


def _no_sum(other: object) -> TypeError:
    array = "mesh.vertices" if hasattr(other, "vertices") else "array"
    return TypeError(_NO_SUM.format(type(other).__name__, array))


class Selection(PointArrays):
    """Methods of PointCloud that select, sample and concatenate points."""

    _internal = ("average_voxels", "select_mask", "select_rows", "trace_grid")

    def __add__(self, other: object) -> Self:
        if not isinstance(other, PointArrays):
            raise _no_sum(other)
        return self.concatenate([self, other])

    def __radd__(self, other: object) -> Self:
        if isinstance(other, int) and other == 0:
            return self.copy()
        raise _no_sum(other)

    @classmethod
    def concatenate(cls, clouds: Iterable[PointArrays]) -> Self:
        """Concatenate clouds.

        Keeps the attributes that all non-empty clouds have, as Open3D's `+`. The origin is that of the largest cloud.
        Others are converted in float64. The unit is that of the clouds with a known unit. If these differ, a
        UnitWarning is issued and the unit is unknown. If some clouds have LAS's `scan_angle_rank` (whole degrees) and
        others `scan_angle` (steps of 0.006 degrees), all get `scan_angle`. O(total) time and memory.

        Args:
            clouds: At least one, all on one device.

        Raises:
            ValueError: If there is no cloud, an attribute's columns differ, or there are more than 2^31 - 1 points.
            TypeError: If an item is not a cloud, or an attribute's types differ.
            DeviceError: If the clouds are on different devices.

        Warns:
            UserWarning: If an attribute is dropped because some clouds lack it.

        Example:
            >>> import pointloom as loom
            >>> a = loom.PointCloud([[0, 0, 0]], ring=[1], time=[0.5])
            >>> b = loom.PointCloud([[5e5, 5.4e6, 0], [5e5, 5.4e6, 1]], ring=[2, 3])
            >>> both = loom.PointCloud.concatenate([a.without("time"), b])
            >>> both["ring"].tolist(), list(both.attributes), both.points[2].tolist()
            ([1, 2, 3], ['ring'], [500000.0, 5400000.0, 1.0])
        """
        given = list_clouds("clouds", clouds)
        if not given:
            raise ValueError("clouds: expected at least one cloud, got none")
        for cloud in given:
            check_cloud("clouds", cloud)
            check_same_device("clouds", cloud.device, given[0].device)
        parts = with_common_las_attributes([cloud for cloud in given if len(cloud)] or given[:1])
        total = sum(map(len, parts))
        if total > MAX_POINTS:
            raise ValueError(f"clouds: expected at most 2^31 - 1 points, got {total:,}. Keep them in several clouds")
        unit, crs = common_reference("clouds", parts)
        largest = max(parts, key=len)
        shifts = [part.origin - largest.origin for part in parts]
        arrays = {"points": concatenate_points([part.arrays["points"] for part in parts], shifts)}
        for name in common_names("clouds", [part.arrays for part in parts], "clouds", ESTIMATED):
            if name != "points":
                arrays[name] = concatenate_columns(name, [part.arrays[name] for part in parts], "clouds")
        merged = cls.from_device_arrays(arrays, largest.origin, parts[0].array_library)
        merged.unit, merged.crs = unit, crs
        return merged

    @returns_new
    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """Set one color for all points.

        Args:
            color: Red, green and blue in 0..1 (Open3D clips other values).

        Raises:
            ValueError: If there are not three numbers in 0..1.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [1, 1, 1]]).paint_uniform_color([1, 0.5, 0]).colors.tolist()
            [[1.0, 0.5, 0.0], [1.0, 0.5, 0.0]]
        """
        rgb = check_color("color", color)
        colors = full(len(self), vec3(*rgb.tolist()), vec3, self.device)
        return self.with_arrays({**self.arrays, "colors": colors}, grid=self.grid)

    @overload
    def __getitem__(self, key: str) -> NDArray[Any]: ...
    @overload
    def __getitem__(self, key: slice | Sequence[SupportsIndex] | NDArray[Any] | SupportsDLPack) -> Self: ...
    def __getitem__(self, key: object) -> NDArray[Any] | Self:
        """Get an attribute by name as NumPy array, or points by slice, mask of shape (n,) or indices.

        Raises:
            KeyError, ValueError: If there is no such attribute, or the mask has another shape.
            IndexError: If an index is out of range.
            TypeError: If the key has another type, or is a single number, which is ambiguous.

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
                raise TypeError(f"cloud[...]: expected a slice of integers, got {shown(key)}") from error
            return self.select_rows(upload(rows, int32, self.device))
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
        """Select points by index in the given order with repeats, or with `invert` all others in order.

        Raises:
            IndexError, TypeError: If an index is out of range, or if the indices are not integers.
        """
        what = {"of": f"cloud of {len(self)} points", "hint": "; for a mask see select_by_mask"}
        if is_on_gpu(indices):
            chosen = take_indices("indices", indices, self.device, len(self), **what)
            return self.select_rows(other_rows(chosen, len(self)) if invert else chosen)
        chosen = upload(check_indices("indices", indices, len(self), **what), int32, self.device)
        return self.select_rows(other_rows(chosen, len(self)) if invert else chosen)

    @returns_new
    def select_by_mask(self, mask: ArrayLike, invert: bool = False) -> Self:
        """Select points where a boolean mask of shape (n,) is set (or, inverted, not set).

        Raises:
            ValueError: If the mask is not boolean or has another shape.
        """
        if is_on_gpu(mask):
            return self.select_mask(take_mask("mask", mask, self.device, len(self)), invert)
        chosen = check_numeric("mask", mask)
        if chosen.dtype != np.bool_ or chosen.shape != (len(self),):
            raise ValueError(f"mask: expected booleans of shape [{len(self)}], got {chosen.dtype} {list(chosen.shape)}")
        return self.select_rows(upload(np.flatnonzero(chosen != invert).astype(np.int32), int32, self.device))

    @returns_new
    def crop(
        self, bounding_box: AxisAlignedBoundingBox | OrientedBoundingBox | SelectionPolygonVolume, invert: bool = False
    ) -> Self:
        """Select points inside a box (faces included) or polygon volume, or with `invert` all others.

        Raises:
            TypeError: If `bounding_box` is of another type.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 1], [2, 2, 2]])
            >>> len(cloud.crop(loom.AxisAlignedBoundingBox([0.5] * 3, [2] * 3)))
            2
        """
        cropped = self.select_mask(mask_cropped(bounding_box, self.arrays["points"], self.arrays.origin), invert)
        if len(self) and not len(cropped) and not invert and not isinstance(bounding_box, SelectionPolygonVolume):
            self._warn_of_box(bounding_box)
        return cropped

    @returns_new
    def remove_non_finite_points(self, remove_nan: bool = True, remove_infinite: bool = True) -> Self:
        """Remove points with a NaN or infinite coordinate."""
        return self.select_mask(mask_finite(self.arrays["points"], remove_nan, remove_infinite))

    @returns_new
    def remove_duplicated_points(self) -> Self:
        """Keep the first point at each position, in order.

        Compares float32 coordinates. Zero equals minus zero. Points with NaN are kept. O(n) time, 45 B per point.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[1, 0, 0], [0, 0, 0], [1, 0, 0]], row=[0, 1, 2])
            >>> cloud.remove_duplicated_points()["row"].tolist()
            [0, 1]
        """
        return self.select_rows(first_occurrences(self.arrays["points"]))

    def select_rows(self, rows: wp.array) -> Self:
        """`select_by_index` for an int32 device array, unchecked."""
        return self.with_arrays({name: gather_rows(values, rows) for name, values in self.arrays.items()})

    def _warn_of_box(self, box: AxisAlignedBoundingBox | OrientedBoundingBox) -> None:
        """Warn if an empty box seems to use other coordinates than the cloud."""
        low, high, finite = bound_points(self.arrays["points"])
        if finite:
            cloud_bounds = low + self.arrays.origin, high + self.arrays.origin
            warn_of_far("bounding_box", (box.get_min_bound(), box.get_max_bound()), cloud_bounds, finite, self.unit)

    def select_mask(self, mask: wp.array, invert: bool = False) -> Self:
        return self.select_rows(positions_of(invert_mask(mask) if invert else mask))

    @returns_new
    def remove_statistical_outlier(
        self, nb_neighbors: int, std_ratio: float, print_progress: bool = False
    ) -> tuple[Self, NDArray[np.int32]]:
        """Remove points whose mean neighbor distance exceeds mean + std_ratio * deviation over the cloud.

        O(n) memory, bitwise reproducible. Rusu et al., "Toward 3D point cloud based object maps for household
        environments", RAS 2008, section 4.

        Args:
            nb_neighbors: Number of nearest points in a mean, including the point itself at distance 0, as in Open3D.
            std_ratio: Number of standard deviations.
            print_progress: Report start and duration on stderr.

        Returns:
            (remaining cloud, ascending indices int32 (m,)). Non-finite points are removed. Coincident points stay.

        Raises:
            ValueError: If a count or ratio is not positive.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.append(np.random.default_rng(0).random((1000, 3)), [[5.0, 5, 5]], axis=0)
            >>> inliers, indices = loom.PointCloud(points).remove_statistical_outlier(20, 3.0)
            >>> 1000 in indices
            False
        """
        check_order("nb_neighbors", nb_neighbors, "std_ratio", std_ratio)
        k = check_count("nb_neighbors", nb_neighbors)
        ratio = check_positive("std_ratio", std_ratio)
        with printed_duration(f"statistical outliers of {len(self):,} points", print_progress):
            distances = average_distances(self.search_tree(), k)
            count, mean, deviation = mean_and_deviation(distances)
            limit = (mean + ratio * deviation) * MEAN_ROUNDING if count else 0.0
            return self._keep(mask_up_to(distances, limit))

    @returns_new
    def remove_radius_outlier(
        self, nb_points: int, radius: float, print_progress: bool = False
    ) -> tuple[Self, NDArray[np.int32]]:
        """Remove points with few neighbors.

        Args:
            nb_points: Minimum number of other points within the radius of a kept point.
            radius: Exclusive radius [m].
            print_progress: Report start and duration on stderr.

        Returns:
            (remaining cloud, ascending indices int32 (m,)). Non-finite points are removed. Bitwise reproducible.

        Raises:
            ValueError: If a count or radius is not positive.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> points = np.append(np.random.default_rng(0).random((1000, 3)), [[5.0, 5, 5]], axis=0)
            >>> inliers, indices = loom.PointCloud(points).remove_radius_outlier(nb_points=2, radius=0.3)
            >>> len(inliers), 1000 in indices
            (1000, False)
        """
        check_order("nb_points", nb_points, "radius", radius)
        needed = check_count("nb_points", nb_points) + 1
        search_radius = check_positive("radius", radius)
        with printed_duration(f"radius outliers of {len(self):,} points", print_progress):
            selected = self._keep(mask_crowded(self.search_tree(), search_radius, needed))
        if len(selected[0]) < (1.0 - MAX_SPARSE_FRACTION) * len(self):
            warn_of_sparse("radius", self.search_tree(), search_radius, needed, self.unit, "they are removed")
        return selected

    def _keep(self, mask: wp.array) -> tuple[Self, NDArray[np.int32]]:
        rows = positions_of(mask)
        return self.select_rows(rows), self.arrays.hand_out(rows)

    @returns_new
    def voxel_down_sample(self, voxel_size: float, reduction: str = "mean") -> Self:
        """Reduce each occupied voxel to one point: the mean of its points and attributes, or one of its points.

        The grid starts half a voxel below the lowest corner. Means are float64 sums in point order. Normals are not
        renormalized. Integer attributes take the value of the first point. Points that are not finite are dropped.
        Non-finite attribute values are ignored in means.

        Args:
            voxel_size: Edge of a voxel [m].
            reduction: "mean", "nearest" for the input point nearest to the mean position, ties to the lowest index, or
                "most_frequent" for the most frequent color and value of each integer attribute with one column, ties to
                the lowest. All else is averaged then.

        Returns:
            One point per voxel in voxel order, x slowest. O(n) memory, bitwise reproducible.

        Raises:
            ValueError: If the size is not positive or gives more than 2^62 cells, or the reduction is unknown.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [0.25, 0, 0], [1, 0, 0], [9, 9, 9]], label=[4, 3, 7, 5])
            >>> cloud.voxel_down_sample(3.0)["label"].tolist()
            [4, 5]
            >>> cloud.voxel_down_sample(3.0, reduction="nearest")["label"].tolist()
            [3, 5]
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [2, 0, 0]], label=[2, 7, 7])
            >>> cloud.voxel_down_sample(9.0, reduction="most_frequent")["label"].tolist()
            [7]
        """
        size = check_positive("voxel_size", voxel_size)
        if not isinstance(reduction, str) or reduction not in REDUCTIONS:
            check_name("reduction", reduction)
            raise ValueError(f"reduction: expected one of {', '.join(REDUCTIONS)}, got {shown(reduction)}")
        groups, _ = self._voxels(size, None)
        if groups.count <= WITHIN_ONE:
            low, high, finite = bound_points(self.arrays["points"])
            outcome = "one point remains" if groups.count == 1 else f"{groups.count} points remain"
            warn_of_long("voxel_size", size, low, high, finite, self.unit, outcome)
        if reduction == "nearest":
            return self.select_rows(nearest_to_means(self.arrays["points"], groups))
        cloud = self._means(groups, self.arrays)
        if reduction == "most_frequent":
            self._set_classes(cloud, groups)
        return cloud

    def average_voxels(self, voxel_size: float, names: Iterable[str], box: Box | None = None) -> Self:
        """`voxel_down_sample` of some arrays, without warnings. `box`: that of the points, if it is known."""
        groups, _ = self._voxels(check_positive("voxel_size", voxel_size), None, box=box)
        return self._means(groups, names)

    def voxel_down_sample_and_trace(
        self,
        voxel_size: float,
        min_bound: ArrayLike | None = None,
        max_bound: ArrayLike | None = None,
        approximate_class: bool = False,
    ) -> VoxelTrace[Self]:
        """Reduce voxels to means as `voxel_down_sample`, and list the points of each voxel.

        Args:
            voxel_size: Edge of a voxel [m].
            min_bound: Corner of the grid [m], shape (3,). If None: half a voxel below the lowest corner. Does not crop.
            max_bound: Checked to be within 2^31 voxels of `min_bound` [m], shape (3,).
            approximate_class: Use the most common value (ties: lowest) for colors and one-column integer attributes.

        Returns:
            A VoxelTrace in voxel order, x slowest; unpacks as Open3D's `cloud, cubic_id, original_indices`.

        Raises:
            ValueError: If the size is not positive, a bound is not finite, or there are too many voxels.
        """
        size = check_positive("voxel_size", voxel_size)
        low = None if min_bound is None else check_finite("min_bound", check_shape("min_bound", min_bound, (3,)))
        if max_bound is not None:
            high = check_finite("max_bound", check_shape("max_bound", max_bound, (3,)))
            if low is not None and (high - low).max() > size * OPEN3D_CELLS:
                raise ValueError(f"voxel_size: {size} gives more than 2^31 voxels between the bounds. Use larger ones")
        return self.trace_grid(size, None if low is None else low - self.arrays.origin, approximate_class)

    def trace_grid(
        self, size: float, corner: NDArray[np.float64] | None, approximate_class: bool = False
    ) -> VoxelTrace[Self]:
        """`voxel_down_sample_and_trace` with a corner relative to the origin, without rounding it."""
        groups, corner = self._voxels(size, corner)
        cloud = self._means(groups, self.arrays)
        if approximate_class:
            self._set_classes(cloud, groups)
        octants, voxels = trace_voxels(self.arrays["points"], groups, corner, size)
        finite = int(download(groups.starts[groups.starts.size - 1 :])[0])  # sync
        indices, offsets, voxels = map(
            self.arrays.hand_out, (view_as(groups.order, int32, (finite,)), groups.starts, voxels)
        )
        cubic_id = hand_out(octants, self.arrays.library, shape=(octants.size // 8, 8))
        return VoxelTrace(cloud, cubic_id, voxels, indices, offsets)

    @returns_new
    def thin(self, spacing: float, corner: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Keep the point nearest to the center of each occupied cell of a fixed grid.

        Points keep position, attributes and order. The result per cell depends only on its points, so thinning parts
        equals thinning the complete cloud, and repeating it changes nothing.

        Args:
            spacing: Edge of a cell [m].
            corner: Corner of a cell [m], shape (3,).

        Returns:
            One point per cell, ties to the first. Non-finite points are dropped. O(n) memory, bitwise reproducible.

        Raises:
            ValueError: If the spacing is not positive, the corner is not finite, or there are too many cells.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0.1, 0, 0], [0.4, 0.4, 0.5], [0.9, 0, 0], [1.2, 0, 0]])
            >>> cloud.thin(1.0).points[:, 0].round(1).tolist()
            [0.4, 1.2]
        """
        size = check_positive("spacing", spacing)
        fixed = check_finite("corner", check_shape("corner", corner, (3,)))
        groups, low = self._voxels(size, fixed - self.arrays.origin, ("spacing", "corner"))
        rows = nearest_to_middles(self.arrays["points"], groups, low, size)
        return self.select_rows(sort_rows(rows, len(self), are_distinct=True))

    @returns_new
    def uniform_down_sample(self, every_k_points: int) -> Self:
        """Keep every k-th point, starting with the first.

        Raises:
            ValueError, TypeError: If `every_k_points` is not an integer >= 1.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[i, 0, 0] for i in range(5)]).uniform_down_sample(2).points[:, 0].tolist()
            [0.0, 2.0, 4.0]
        """
        step = check_count("every_k_points", every_k_points)
        return self.select_rows(step_rows(len(self), step, self.device))

    @returns_new
    def random_down_sample(self, sampling_ratio: float, seed: int = 0) -> Self:
        """Select `int(sampling_ratio * n)` random points without repeats, in order.

        The choice depends only on the seed and n, not on the device. O(n log n) time.

        Args:
            sampling_ratio: Fraction of the points, 0..1.
            seed: Random seed, 0..2^31 - 1.

        Raises:
            ValueError, TypeError: If an argument is not a number or out of range.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[i, 0, 0] for i in range(1000)])
            >>> len(cloud.random_down_sample(0.25)), len(cloud.random_down_sample(0.25, seed=1))
            (250, 250)
        """
        ratio = check_positive("sampling_ratio", sampling_ratio, allow_zero=True)
        if ratio > 1:
            remedy = f"; {sampling_ratio:g} % is {sampling_ratio / 100:g}" if 1 < sampling_ratio <= 100 else ""
            raise ValueError(f"sampling_ratio: expected a fraction in 0..1, got {sampling_ratio!r}{remedy}")
        return self.select_rows(draw_rows(len(self), int(ratio * len(self)), check_seed(seed), self.device))

    @returns_new
    def farthest_point_down_sample(self, num_samples: int, start_index: int = 0) -> Self:
        """Select points by farthest point sampling, returned in cloud order.

        Equals Open3D's selection, except for squared distances that differ by less than 1e-7 (float32). Ties go to the
        lowest index. Duplicate positions are chosen only if all n points are requested. Points that are not finite are
        never chosen. About O(n log(num_samples)) on surfaces, 20 B per point. Bitwise identical on every device.

        Args:
            num_samples: Number of points, up to n.
            start_index: First point.

        Raises:
            ValueError: If there are more samples than points, or the start is not finite.
            IndexError, TypeError: If the start is out of range, or if an argument is not an integer.

        Warns:
            UserWarning: If there are fewer distinct finite points than requested.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [5, 0, 0], [9, 0, 0]])
            >>> cloud.farthest_point_down_sample(3).points[:, 0].tolist()
            [0.0, 5.0, 9.0]
        """
        count, _ = self._check_farthest(num_samples, start_index)
        if count == len(self):
            finite = self.remove_non_finite_points()
            _warn_of_fewer(len(finite), count)
            return finite
        chosen = upload(self._farthest(num_samples, start_index), int32, self.device)
        return self.select_rows(sort_rows(chosen, len(self)))

    def farthest_point_indices(self, num_samples: int, start_index: int = 0) -> NDArray[np.int32]:
        """Indices of `farthest_point_down_sample` in order of choice: the first k are the choice of k.

        Arguments and errors as `farthest_point_down_sample`. Of coincident points only one is chosen.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [1, 0, 0], [5, 0, 0], [9, 0, 0]]).farthest_point_indices(3).tolist()
            [0, 3, 2]
        """
        return hand_out_host(self._farthest(num_samples, start_index), self.arrays.library, self.device)

    def _check_farthest(self, num_samples: int, start_index: int) -> tuple[int, int]:
        count = check_count("num_samples", num_samples, minimum=0)
        start = check_count("start_index", start_index, minimum=0)
        if count > len(self):
            raise ValueError(f"num_samples: expected at most the cloud's {len(self)} points, got {num_samples!r}")
        if count and start >= len(self):
            raise IndexError(f"start_index: {start_index!r} is out of range for a cloud of {len(self)} points")
        return count, start

    def _farthest(self, num_samples: int, start_index: int) -> NDArray[np.int32]:
        count, start = self._check_farthest(num_samples, start_index)
        if count == 0:
            return np.zeros(0, np.int32)
        points = self.arrays["points"]
        first = download(gather_rows(points, upload(np.array([start]), int32, self.device)))[0]  # sync
        if not np.isfinite(first).all():
            raise ValueError(
                f"start_index: expected a finite point, got {first.tolist()} at {start_index!r}; "
                "call remove_non_finite_points() first"
            )
        chosen = choose_farthest(self.search_tree(), count, start)
        _warn_of_fewer(len(chosen), count)
        return chosen

    def _voxels(
        self,
        size: float,
        corner: NDArray[np.float64] | None,
        names: tuple[str, str] = ("voxel_size", "min_bound"),
        box: Box | None = None,
    ) -> tuple[Any, NDArray[np.float64]]:
        """Group the finite points by voxel of a grid with a corner relative to the origin, which is also returned."""
        points = self.arrays["points"]
        low, high, finite = bound_points(points) if box is None else box
        low, high = (low.astype(np.float64), high.astype(np.float64)) if finite else (np.zeros(3), np.zeros(3))
        with np.errstate(over="ignore"):
            if corner is None:
                corner = low - size / 2
                first = np.zeros(3)
            else:
                first = np.floor((low - corner) / size)
                if not (np.abs(first) < CELL_LIMIT).all():
                    raise ValueError(f"{names[0]}: {size} gives more than 2^53 voxels between {names[1]} and the cloud")
            cells = np.floor((high - corner) / size) + 1 - first
        return VoxelGroups(points, corner, size, cells, first.astype(np.int64), names[0]), corner

    def _means(self, groups: VoxelGroups, names: Iterable[str]) -> Self:
        if not groups.count:
            return self.select_rows(upload(np.zeros(0, np.int32), int32, self.device))
        means: dict[str, wp.array] = {}
        rows = None
        for name in names:
            values = self.arrays[name]
            if name in VECTORS:
                means[name] = average_vec3(values, groups.order, groups.starts)
            elif np.dtype(wp.dtype_to_numpy(values.dtype)).kind == "f":
                means[name] = self._average(values, groups)
            else:
                rows = first_rows(groups.order, groups.starts) if rows is None else rows
                means[name] = gather_rows(values, rows)
        return self.with_arrays(means)

    def _average(self, values: wp.array, groups: VoxelGroups) -> wp.array:
        shape = values.shape
        columns = cast(values.reshape((shape[0], shape[1] if len(shape) > 1 else 1)), float64)
        means = sum_columns(columns, groups.order, groups.starts, mean=True)
        return cast(means, values.dtype).reshape((groups.count, *shape[1:]))

    def _set_classes(self, cloud: Self, groups: Any) -> None:
        """Set the most common colors and classes of the voxels in a cloud of means."""
        for name, values in self.arrays.items():
            is_integer = (
                values.dtype != vec3 and values.ndim == 1 and np.dtype(wp.dtype_to_numpy(values.dtype)).kind in "iub"
            )
            if name == "colors" or is_integer:
                cloud.arrays[name] = gather_rows(values, commonest_rows(values, groups))
