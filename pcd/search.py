"""Neighbour search over a cloud: k nearest, radius, and both."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import NUMPY, Form, form_of, view_as
from ..core.checks import check_count, check_numeric, check_positive, check_rows, is_on_gpu
from ..core.coordinates import split_origin
from ..core.devices import check_same_device
from ..core.gpu_arrays import take_numbers, take_points
from ..core.halves import in_halves
from ..core.known_names import ToldNames
from ..kernels.arrays.row_numbers import run_lengths
from ..kernels.lang import vec3
from ..kernels.memory import upload
from ..kernels.search.tree_search import search_nearest, search_within
from .cloud import PointCloud
from .point_arrays import PointArrays, check_cloud

FEW = 1024  # neighbours that may be asked for beyond the number of points


class Neighbors(NamedTuple):
    """Neighbours of m queries, by distance, ties by index; of one query of shape [3], without the first axis.

    Arrays of the library that the queries came from; in those of Warp the count of one query is an array of one.

    Attributes:
        indices: int32 [m, k]; -1 where there are fewer than k. From `radius_search` flat, [total].
        sqdists: Squared distances [m^2], float32, of the same shape; infinite at missing neighbours.
        counts: Neighbours of each query, int32 [m].
    """

    indices: NDArray[np.int32]
    sqdists: NDArray[np.float32]
    counts: NDArray[np.int32]


class _Queries(NamedTuple):
    """What is searched for, and in what form the answer is wanted.

    Attributes:
        points: Device array of vec3 about the cloud's origin.
        is_single: Whether they are one query of shape [3].
        form: What they came as.
    """

    points: Any
    is_single: bool
    form: Form


def _only(part: Any) -> Any:
    """What was found for the only query."""
    return part if isinstance(part, wp.array) and part.ndim == 1 else part[0]  # Warp has no single elements


class NearestNeighborSearch(ToldNames):
    """Exact neighbour search over a cloud as it is now, by one tree for every radius and count.

    Distances are those of float32 coordinates relative to the cloud's origin. Points and queries that are not finite
    have no neighbours and are nobody's. The same bits from run to run; memory O(n) for the tree, 8 B a neighbour for
    results, never n x m. Where a GPU has no room for results that go to NumPy, it searches for part of the queries at a
    time.

    Args:
        cloud: A PointCloud, or points of shape [n, 3].
        device: For an array: where the search runs.

    Raises:
        ValueError: Points that span less than 1e-13 m, but not none, or of which most lie more than 5e18 m from their
            middle: float32 does not hold their squared distances. All that searches a cloud refuses these.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> search = loom.NearestNeighborSearch(np.array([[0.0, 0, 0], [1, 0, 0], [3, 0, 0]]))
        >>> indices, sqdists, counts = search.knn_search(np.array([[0.9, 0, 0]]), 2)
        >>> indices.tolist(), counts.tolist()
        ([[1, 0]], [2])
    """

    def __init__(self, cloud: PointCloud | ArrayLike, *, device: Any = None):
        if not isinstance(cloud, PointCloud):
            rows = cloud if is_on_gpu(cloud) else check_rows("cloud", cloud, 3)
            cloud = PointCloud(rows, device=device)
        elif device is not None:
            cloud = cloud.to(device)
        self.cloud = cloud.copy()  # as it is now: the tree does not follow what is assigned later
        self._tree = self.cloud.search_tree()

    def __repr__(self) -> str:
        return f"NearestNeighborSearch({len(self.cloud):,} points, {self.cloud.device})"

    def __getstate__(self) -> PointCloud:
        """The cloud, for pickle: the tree is built anew."""
        return self.cloud.copy()

    def __setstate__(self, cloud: PointCloud) -> None:
        """The search over the cloud.

        Raises:
            TypeError: The state is no cloud.
        """
        check_cloud("cloud", cloud)
        self.cloud, self._tree = cloud, cloud.search_tree()

    def knn_search(self, queries: PointCloud | ArrayLike, k: int) -> Neighbors:
        """The k nearest points of each query.

        Args:
            queries: A cloud on the same device, or an array of shape [m, 3] or [3]. A query that is one of the points
                finds itself first.
            k: Neighbours a query, up to the number of points and 1024 more; where there are fewer points, rows end in
                -1.

        Raises:
            ValueError: k out of range or a wrong shape.
            DeviceError: A cloud on another device.
        """
        return self._nearest(queries, self._check_neighbors("k", k), np.inf)

    def hybrid_search(self, queries: PointCloud | ArrayLike, radius: float, max_nn: int) -> Neighbors:
        """The `max_nn` nearest points closer than `radius` [m], the boundary excluded.

        Raises:
            ValueError: A radius or a count out of range, or a wrong shape.
            DeviceError: A cloud on another device.
        """
        return self._nearest(queries, self._check_neighbors("max_nn", max_nn), check_positive("radius", radius))

    def radius_search(self, queries: PointCloud | ArrayLike, radius: float) -> Neighbors:
        """All points closer than `radius` [m], the boundary excluded.

        Returns:
            Flat rows: those of query i begin at sum(counts[:i]).

        Raises:
            ValueError: A radius that is not positive, a wrong shape, or 2^31 neighbours or more in all; search in
                parts, or use `hybrid_search`.
            DeviceError: A cloud on another device.
        """
        reach = check_positive("radius", radius)
        asked = self._queries(queries)

        def search(points: Any) -> tuple[Any, ...]:
            indices, sqdists, offsets = search_within(self._tree, points, reach)
            return indices, sqdists, run_lengths(offsets)

        indices, sqdists, counts = self._answers(asked, search)
        return Neighbors(indices, sqdists, _only(counts) if asked.is_single else counts)

    def _nearest(self, queries: PointCloud | ArrayLike, k: int, radius: float) -> Neighbors:
        asked = self._queries(queries)
        found = Neighbors(*self._answers(asked, lambda points: search_nearest(self._tree, points, k, radius)))
        return Neighbors(*map(_only, found)) if asked.is_single else found

    def _answers(self, asked: _Queries, search: Callable[[Any], tuple[Any, ...]]) -> tuple[Any, ...]:
        """What is found for queries, in their form; where that is NumPy's, in parts if a GPU has no room at once."""

        def part(begin: int, end: int) -> tuple[Any, ...]:
            points = asked.points if end - begin == asked.points.size else asked.points[begin:end]
            return tuple(map(asked.form.hand_out, search(points)))

        if asked.form.library != NUMPY or asked.points.device.is_cpu:
            return part(0, asked.points.size)
        return in_halves(asked.points.size, part)

    def _check_neighbors(self, name: str, count: Any) -> int:
        most = len(self.cloud) + FEW
        reason = f"the cloud has {len(self.cloud):,} points, and each of the neighbours takes 8 B a query"
        return check_count(name, count, maximum=most, because=reason)

    def _queries(self, queries: PointArrays | ArrayLike) -> _Queries:
        """Queries about the cloud's origin on its device."""
        device, origin = self.cloud.device, self.cloud.origin
        if isinstance(queries, PointArrays):
            check_same_device("queries", queries.device, device)
            return _Queries(queries._points_about(origin), False, Form(queries.array_library, False))
        form = form_of(queries)
        if is_on_gpu(queries):
            rows = take_numbers("queries", queries, device)
            is_single = tuple(rows.shape) == (3,)
            rows = view_as(rows, rows.dtype, (1, 3)) if is_single else rows
            return _Queries(take_points("queries", rows, origin, device)[0], is_single, form)
        rows = check_numeric("queries", queries)
        is_single = rows.shape == (3,)
        local, _ = split_origin(check_rows("queries", rows[None] if is_single else rows, 3), origin)
        return _Queries(upload(local, vec3, device, copied=False), is_single, form)
