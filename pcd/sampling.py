"""Fewer points that stand for a cloud: means of voxels, every k-th, a random choice, the farthest from each other."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out, hand_out_host, view_as
from ..core.checks import check_count, check_finite, check_name, check_positive, check_seed, check_shape, shown
from ..core.dropped_results import returns_new
from ..kernels.arrays.bounds import bound_points
from ..kernels.arrays.run_sums import average_vec3, first_rows, sum_columns
from ..kernels.arrays.select import gather_rows
from ..kernels.arrays.subsets import draw_rows, sort_rows, step_rows
from ..kernels.lang import float64, int32, vec3
from ..kernels.memory import cast, download, upload
from ..kernels.sampling.farthest_points import choose_farthest
from ..kernels.sampling.voxel_keys import VoxelGroups
from ..kernels.sampling.voxel_traces import commonest_rows, nearest_to_means, nearest_to_middles, trace_voxels
from .length_doubts import warn_of_long
from .point_arrays import VECTORS
from .selection import Selection
from .voxel_trace import VoxelTrace

CELL_LIMIT = 2.0**53  # cells from the corner: float64 counts no further by ones
WITHIN_ONE = 8  # cells at most that hold a cloud which is no larger than one
OPEN3D_CELLS = 2**31 - 1  # Open3D counts the cells between the bounds in 32 bits


class Sampling(Selection):
    """The part of PointCloud that thins a cloud."""

    @returns_new
    def voxel_down_sample(self, voxel_size: float, reduction: str = "mean") -> Self:
        """One point for each occupied voxel: the mean of its points and of all their attributes, or one of its points.

        The grid starts half a voxel below the lowest corner, as Open3D's legacy form does. Means are summed in
        float64 in the order of the points, normals are not made unit again, and integer attributes take the value of
        the voxel's first point. Points that are not finite are dropped (Open3D emits a NaN point). NaN and infinite
        attributes do not count in a mean, which is NaN where none counts (Open3D counts a NaN normal in the divisor).

        Args:
            voxel_size: Edge of a voxel [m].
            reduction: "mean", or "nearest" for the input point nearest to the mean of its voxel's positions, ties to
                the lowest index: positions and attributes are then those of points that were measured.

        Returns:
            One point a voxel in the order of the voxels, x slowest. O(n) memory, the same bits from run to run.

        Raises:
            ValueError: Not a positive number, so small that the grid has more than 2^62 cells, or no such reduction.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [0.25, 0, 0], [1, 0, 0], [9, 9, 9]], label=[4, 3, 7, 5])
            >>> cloud.voxel_down_sample(3.0)["label"].tolist()
            [4, 5]
            >>> cloud.voxel_down_sample(3.0, reduction="nearest")["label"].tolist()
            [3, 5]
        """
        size = check_positive("voxel_size", voxel_size)
        if check_name("reduction", reduction) not in ("mean", "nearest"):
            raise ValueError(f"reduction: expected 'mean' or 'nearest', got {shown(reduction)}")
        groups, _ = self._voxels(size, None)
        if groups.count <= WITHIN_ONE:
            low, high, finite = bound_points(self._arrays["points"])
            left = "one point is left" if groups.count == 1 else f"{groups.count} points are left"
            warn_of_long("voxel_size", size, low, high, finite, self.unit, left)
        if reduction == "nearest":
            return self._select_rows(nearest_to_means(self._arrays["points"], groups))
        return self._means(groups)

    def voxel_down_sample_and_trace(
        self,
        voxel_size: float,
        min_bound: ArrayLike | None = None,
        max_bound: ArrayLike | None = None,
        approximate_class: bool = False,
    ) -> VoxelTrace:
        """The means of `voxel_down_sample`, and which points fell where.

        As in Open3D the bounds only place the grid, so that grids of several sizes share a corner: points beyond them
        are kept. Open3D gives the voxels in no fixed order, here x is slowest.

        Args:
            voxel_size: Edge of a voxel [m].
            min_bound: Corner of the grid [m], shape [3]; None for half a voxel below the lowest corner of the cloud.
            max_bound: Upper end of the grid [m], shape [3]; only checked: to lie within 2^31 voxels of the lower.
            approximate_class: Whether colours and one-column attributes of whole numbers, being classes, take the
                commonest value of their voxel, of equally common ones the lowest; colours within 5e-7 are one. (Open3D
                gives the commonest whole part of red as all three channels.)

        Returns:
            A VoxelTrace; `cloud, cubic_id, original_indices = ...` takes it as Open3D's tuple. O(n) memory.

        Raises:
            ValueError: Not a positive size, bounds that are not finite, or more voxels than fit.
        """
        size = check_positive("voxel_size", voxel_size)
        low = None if min_bound is None else check_finite("min_bound", check_shape("min_bound", min_bound, (3,)))
        if max_bound is not None:
            high = check_finite("max_bound", check_shape("max_bound", max_bound, (3,)))
            if low is not None and (high - low).max() > size * OPEN3D_CELLS:
                raise ValueError(f"voxel_size: {size} makes more than 2^31 voxels between the bounds; take larger ones")
        groups, corner = self._voxels(size, low)
        cloud: Any = self._means(groups)
        if approximate_class:
            self._set_classes(cloud, groups)
        octants, voxels = trace_voxels(self._arrays["points"], groups, corner, size)
        finite = int(download(groups.starts[groups.starts.size - 1 :])[0])  # sync
        indices, offsets, voxels = map(
            self._handed_out, (view_as(groups.order, int32, (finite,)), groups.starts, voxels)
        )
        cubic_id = hand_out(octants, self._library, shape=(octants.size // 8, 8))
        return VoxelTrace(cloud, cubic_id, voxels, indices, offsets)

    @returns_new
    def thin(self, spacing: float, corner: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """One point for each occupied cell of a grid that is fixed in space: the point nearest to the cell's middle.

        Points stay where they were measured, with all their attributes and in their own order. What is kept in a cell
        depends on its points alone: parts of a cloud that are thinned one by one are the thinned whole, and thinning
        again with the same grid changes nothing.

        Args:
            spacing: Edge of a cell [m]: points are about as far apart, two at a border may be closer.
            corner: Where cells are counted from [m], shape [3].

        Returns:
            One point a cell; of points equally near the first. Points that are not finite are dropped. O(n) memory,
            the same bits from run to run.

        Raises:
            ValueError: Not a positive number, a corner that is not finite, or more cells than fit.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0.1, 0, 0], [0.4, 0.4, 0.5], [0.9, 0, 0], [1.2, 0, 0]])
            >>> cloud.thin(1.0).points[:, 0].round(1).tolist()
            [0.4, 1.2]
        """
        size = check_positive("spacing", spacing)
        fixed = check_finite("corner", check_shape("corner", corner, (3,)))
        groups, low = self._voxels(size, fixed, ("spacing", "corner"))
        rows = nearest_to_middles(self._arrays["points"], groups, low, size)
        return self._select_rows(sort_rows(rows, len(self), are_distinct=True))

    @returns_new
    def uniform_down_sample(self, every_k_points: int) -> Self:
        """Every k-th point, the first among them.

        Raises:
            ValueError: Below 1.
            TypeError: No whole number.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[i, 0, 0] for i in range(5)]).uniform_down_sample(2).points[:, 0].tolist()
            [0.0, 2.0, 4.0]
        """
        step = check_count("every_k_points", every_k_points)
        return self._select_rows(step_rows(len(self), step, self.device))

    @returns_new
    def random_down_sample(self, sampling_ratio: float, seed: int = 0) -> Self:
        """`int(sampling_ratio * n)` of the points, chosen at random without repeats, in their own order.

        The choice depends on the seed and on n alone: it is the same on every device. O(n log n).

        Args:
            sampling_ratio: The share of the points, 0..1.
            seed: Chooses the choice, 0..2^31 - 1.

        Raises:
            ValueError: A ratio outside 0..1 or a seed out of range.
            TypeError: No numbers.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[i, 0, 0] for i in range(1000)])
            >>> len(cloud.random_down_sample(0.25)), len(cloud.random_down_sample(0.25, seed=1))
            (250, 250)
        """
        ratio = check_positive("sampling_ratio", sampling_ratio, allow_zero=True)
        if ratio > 1:
            remedy = f"; {sampling_ratio:g} % are {sampling_ratio / 100:g}" if 1 < sampling_ratio <= 100 else ""
            raise ValueError(f"sampling_ratio: expected a share 0..1, got {sampling_ratio!r}{remedy}")
        return self._select_rows(draw_rows(len(self), int(ratio * len(self)), check_seed(seed), self.device))

    @returns_new
    def farthest_point_down_sample(self, num_samples: int, start_index: int = 0) -> Self:
        """Points spread over the cloud, each chosen as the farthest from all before it; in their own order.

        The set is Open3D's, which measures in float64: of points whose squared distances differ by less than a part
        in 10^7 float32 may choose another one, and later choices then differ too. As there, points equally far are
        chosen by index, fewer points come back where fewer positions differ, and asking for all n gives all, duplicates
        included. Points that are not finite are never chosen.

        Args:
            num_samples: How many points to choose, up to n.
            start_index: The first of them.

        Raises:
            ValueError: More samples than points, or a start that is not finite.
            IndexError: A start beyond the cloud.
            TypeError: No whole numbers.

        Notes:
            About O(n log(num_samples)) for points on surfaces; 20 B a point beside the search tree. The same bits from
            run to run and on every device. `farthest_point_indices` gives the order of choice.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [5, 0, 0], [9, 0, 0]])
            >>> cloud.farthest_point_down_sample(3).points[:, 0].tolist()
            [0.0, 5.0, 9.0]
        """
        if check_count("num_samples", num_samples, minimum=0) == len(self):
            return self.remove_non_finite_points()
        chosen = upload(self._farthest(num_samples, start_index), int32, self.device)
        return self._select_rows(sort_rows(chosen, len(self)))

    def farthest_point_indices(self, num_samples: int, start_index: int = 0) -> NDArray[np.int32]:
        """The indices of farthest points in the order of choice: the first k of them are the choice of k.

        Args and errors as for `farthest_point_down_sample`. Of points at one position only one is ever chosen.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [1, 0, 0], [5, 0, 0], [9, 0, 0]]).farthest_point_indices(3).tolist()
            [0, 3, 2]
        """
        return hand_out_host(self._farthest(num_samples, start_index), self._library, self.device)

    # ------------------------------------------------------------------------------------------ internals

    def _farthest(self, num_samples: int, start_index: int) -> NDArray[np.int32]:
        count = check_count("num_samples", num_samples, minimum=0)
        start = check_count("start_index", start_index, minimum=0)
        if count > len(self):
            raise ValueError(f"num_samples: expected at most the cloud's {len(self)} points, got {num_samples!r}")
        if count == 0:
            return np.zeros(0, np.int32)
        if start >= len(self):
            raise IndexError(f"start_index: {start_index!r} reaches beyond a cloud of {len(self)} points")
        points = self._arrays["points"]
        first = download(gather_rows(points, upload(np.array([start]), int32, self.device)))[0]  # sync
        if not np.isfinite(first).all():
            raise ValueError(
                f"start_index: expected a finite point, got {first.tolist()} at {start_index!r}; "
                "remove_non_finite_points() leaves those out"
            )
        return choose_farthest(self.search_tree(), count, start)

    def _voxels(
        self, size: float, min_bound: NDArray[np.float64] | None, names: tuple[str, str] = ("voxel_size", "min_bound")
    ) -> tuple[Any, NDArray[np.float64]]:
        """The finite points by voxel, and the corner of the grid relative to the origin."""
        points = self._arrays["points"]
        low, high, finite = bound_points(points)
        low, high = (low.astype(np.float64), high.astype(np.float64)) if finite else (np.zeros(3), np.zeros(3))
        with np.errstate(over="ignore"):
            if min_bound is None:
                corner = low - size / 2
                first = np.zeros(3)
            else:
                corner = min_bound - self._origin
                first = np.floor((low - corner) / size)
                if not (np.abs(first) < CELL_LIMIT).all():
                    raise ValueError(f"{names[0]}: {size} puts more than 2^53 voxels between {names[1]} and the cloud")
            cells = np.floor((high - corner) / size) + 1 - first
        return VoxelGroups(points, corner, size, cells, first.astype(np.int64), names[0]), corner

    def _means(self, groups: Any) -> Self:
        """The means of voxels; of whole numbers the first."""
        if not groups.count:
            return self._select_rows(upload(np.zeros(0, np.int32), int32, self.device))
        means: dict[str, wp.array] = {}
        rows = None
        for name, values in self._arrays.items():
            if name in VECTORS:
                means[name] = average_vec3(values, groups.order, groups.starts)
            elif np.dtype(wp.dtype_to_numpy(values.dtype)).kind == "f":
                means[name] = self._average(values, groups)
            else:
                rows = first_rows(groups.order, groups.starts) if rows is None else rows
                means[name] = gather_rows(values, rows)
        return self._with_arrays(means)

    def _average(self, values: wp.array, groups: Any) -> wp.array:
        shape = values.shape
        columns = cast(values.reshape((shape[0], shape[1] if len(shape) > 1 else 1)), float64)
        means = sum_columns(columns, groups.order, groups.starts, mean=True)
        return cast(means, values.dtype).reshape((groups.count, *shape[1:]))

    def _set_classes(self, cloud: Self, groups: Any) -> None:
        """Give a cloud of means the commonest colours and classes of its voxels."""
        for name, values in self._arrays.items():
            whole = (
                values.dtype != vec3 and values.ndim == 1 and np.dtype(wp.dtype_to_numpy(values.dtype)).kind in "iub"
            )
            if name == "colors" or whole:
                cloud._arrays[name] = gather_rows(values, commonest_rows(values, groups))
