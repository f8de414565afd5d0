"""Neighbor search over a cloud: k nearest, radius, and both."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import NUMPY, Form, form_of, view_as
from ..core.attribute_hints import HintedNames
from ..core.batch_splitting import in_batches
from ..core.checks import check_count, check_numeric, check_positive, check_rows, is_on_gpu
from ..core.coordinates import split_origin
from ..core.devices import DeviceLike, check_same_device
from ..core.gpu_arrays import take_numbers, take_points
from ..kernels.arrays.row_numbers import run_lengths
from ..kernels.lang import float64, int64, vec3
from ..kernels.memory import download, upload
from ..kernels.search.tree_search import search_nearest, search_within
from .cloud import PointCloud
from .point_arrays import PointArrays, check_cloud

EXTRA_NEIGHBORS = 1024  # allowed neighbors beyond the number of points


class Neighbors(NamedTuple):
    """Neighbors of m queries by distance, ties by index. A single query of shape (3,) has no first axis.

    Attributes:
        indices: int32 (m, k), -1 if there are fewer; flat (total,) from `radius_search`.
        sqdists: Squared distances [m^2], float32, same shape; infinite at missing neighbors.
        counts: Neighbors of each query, int32 (m,).
    """

    indices: NDArray[np.int32]
    sqdists: NDArray[np.float32]
    counts: NDArray[np.int32]


class _Queries(NamedTuple):
    """Queries as a device array of vec3 about the cloud's origin, and their input form."""

    points: Any
    is_single: bool
    form: Form


def _only(part: Any) -> Any:
    return part if isinstance(part, wp.array) and part.ndim == 1 else part[0]  # Warp has no scalars


class NearestNeighborSearch(HintedNames):
    """Exact neighbor search over a snapshot of a cloud, with one tree for every radius and count.

    Uses float32 coordinates about the cloud's origin. Points and queries that are not finite have no neighbors. Bitwise
    reproducible; O(n) memory for the tree, 8 B per neighbor. Queries are split if a GPU runs out of memory.

    Args:
        cloud: A PointCloud, or points of shape (n, 3).
        device: Device for an array.

    Raises:
        ValueError: If the extent exceeds float32 squared distances: below 1e-13 m, or mostly beyond 5e18 m.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> search = loom.NearestNeighborSearch(np.array([[0.0, 0, 0], [1, 0, 0], [3, 0, 0]]))
        >>> indices, sqdists, counts = search.knn_search(np.array([[0.9, 0, 0]]), 2)
        >>> indices.tolist(), counts.tolist()
        ([[1, 0]], [2])
    """

    _internal = ("distances",)

    def __init__(self, cloud: PointCloud | ArrayLike, *, device: DeviceLike = None):
        if not isinstance(cloud, PointCloud):
            rows = cloud if is_on_gpu(cloud) else check_rows("cloud", cloud, 3)
            cloud = PointCloud(rows, device=device)
        elif device is not None:
            cloud = cloud.to(device)
        self.cloud = cloud.copy()  # snapshot: the tree does not follow later assignments
        self._tree = self.cloud.search_tree()

    def __repr__(self) -> str:
        return f"NearestNeighborSearch({len(self.cloud):,} points, {self.cloud.device})"

    def __getstate__(self) -> PointCloud:
        return self.cloud.copy()

    def __setstate__(self, cloud: PointCloud) -> None:
        check_cloud("cloud", cloud)
        self.cloud, self._tree = cloud, cloud.search_tree()

    def knn_search(self, queries: PointCloud | ArrayLike, knn: int) -> Neighbors:
        """Find the `knn` nearest points of each query.

        Args:
            queries: A cloud on the same device, or an array of shape (m, 3) or (3,). Points find themselves first.
            knn: Number of neighbors, up to the number of points plus 1024. Missing ones are -1.

        Raises:
            ValueError, DeviceError: If `knn` is out of range, the shape is wrong, or the cloud is on another device.
        """
        return self._nearest(queries, self._check_neighbors("knn", knn), np.inf)

    def hybrid_search(self, queries: PointCloud | ArrayLike, radius: float, max_nn: int) -> Neighbors:
        """Find up to `max_nn` nearest points closer than `radius` [m].

        Raises:
            ValueError: If an argument is out of range or the shape is wrong.
            DeviceError: If the cloud is on another device.
        """
        return self._nearest(queries, self._check_neighbors("max_nn", max_nn), check_positive("radius", radius))

    def radius_search(self, queries: PointCloud | ArrayLike, radius: float) -> Neighbors:
        """Find all points closer than `radius` [m]. The rows of query i start at sum(counts[:i]).

        Raises:
            ValueError: If the radius is not positive, the shape is wrong, or there are 2^31 neighbors or more.
            DeviceError: If the cloud is on another device.
        """
        search_radius = check_positive("radius", radius)
        batch = self._queries("queries", queries)

        def search(points: Any) -> tuple[Any, ...]:
            indices, sqdists, offsets = search_within(self._tree, points, search_radius)
            return indices, sqdists, run_lengths(offsets)

        indices, sqdists, counts = self._search_all(batch, search)
        return Neighbors(indices, sqdists, _only(counts) if batch.is_single else counts)

    def distances(self, queries: PointCloud | ArrayLike, k: int, bound: float) -> Any:
        """The results of `KDTree.query`."""
        count = self._check_neighbors("k", k)
        radius = check_positive("distance_upper_bound", bound, allow_infinite=True)
        batch, device = self._queries("x", queries), self.cloud.device

        def search(points: Any) -> tuple[Any, ...]:
            indices, sqdists, _ = map(download, search_nearest(self._tree, points, count, radius))  # sync
            if count == 1:
                indices, sqdists = indices[:, 0], sqdists[:, 0]
            rows = np.where(indices < 0, len(self.cloud), indices)
            return upload(np.sqrt(sqdists.astype(np.float64)), float64, device), upload(rows, int64, device)

        distances, rows = self._search_all(batch, search)
        return (_only(distances), _only(rows)) if batch.is_single else (distances, rows)

    def _nearest(self, queries: PointCloud | ArrayLike, k: int, radius: float) -> Neighbors:
        batch = self._queries("queries", queries)
        neighbors = Neighbors(*self._search_all(batch, lambda points: search_nearest(self._tree, points, k, radius)))
        return Neighbors(*map(_only, neighbors)) if batch.is_single else neighbors

    def _search_all(self, batch: _Queries, search: Callable[[Any], tuple[Any, ...]]) -> tuple[Any, ...]:
        """Search results in the form of the queries. Split for NumPy if a GPU runs out of memory."""

        def part(begin: int, end: int) -> tuple[Any, ...]:
            points = batch.points if end - begin == batch.points.size else batch.points[begin:end]
            return tuple(batch.form.hand_out_all(dict(enumerate(search(points)))).values())

        if batch.form.library != NUMPY or batch.points.device.is_cpu:
            return part(0, batch.points.size)
        return in_batches(batch.points.size, part)

    def _check_neighbors(self, name: str, count: object) -> int:
        max_count = len(self.cloud) + EXTRA_NEIGHBORS
        reason = f"the cloud has {len(self.cloud):,} points, and each neighbor takes 8 B per query"
        return check_count(name, count, maximum=max_count, because=reason)

    def _queries(self, name: str, queries: PointArrays | ArrayLike) -> _Queries:
        device, origin = self.cloud.device, self.cloud.origin
        if isinstance(queries, PointArrays):
            check_same_device(name, queries.device, device)
            return _Queries(queries.arrays.about(origin), False, Form(queries.array_library, False))
        form = form_of(queries)
        if is_on_gpu(queries):
            rows = take_numbers(name, queries, device)
            is_single = tuple(rows.shape) == (3,)
            rows = view_as(rows, rows.dtype, (1, 3)) if is_single else rows
            return _Queries(take_points(name, rows, origin, device)[0], is_single, form)
        rows = check_numeric(name, queries)
        is_single = rows.shape == (3,)
        local, _ = split_origin(check_rows(name, rows[None] if is_single else rows, 3), origin)
        return _Queries(upload(local, vec3, device, copied=False), is_single, form)


class KDTree(HintedNames):
    """Exact neighbor search with the call and the results of `scipy.spatial.KDTree`.

    Uses the tree of `NearestNeighborSearch`, which also searches within a radius.

    Args:
        data: Points of shape (n, 3), or a PointCloud.
        device: Device for an array.

    Raises:
        ValueError: As of `NearestNeighborSearch`.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> tree = loom.KDTree(np.array([[0.0, 0, 0], [1, 0, 0], [3, 0, 0]]))
        >>> distances, indices = tree.query(np.array([[0.5, 0, 0], [3, 0, 2]]))
        >>> distances.tolist(), indices.tolist()
        ([0.5, 2.0], [0, 2])
    """

    def __init__(self, data: PointCloud | ArrayLike, *, device: DeviceLike = None):
        is_usable = isinstance(data, PointCloud) or is_on_gpu(data)
        self._search = NearestNeighborSearch(data if is_usable else check_rows("data", data, 3), device=device)

    def __repr__(self) -> str:
        return f"KDTree({len(self._search.cloud):,} points, {self._search.cloud.device})"

    def query(
        self, x: PointCloud | ArrayLike, k: int = 1, *, distance_upper_bound: float = np.inf
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Find the `k` nearest points of each query that are closer than a bound.

        Args:
            x: A cloud on the same device, or an array of shape (m, 3) or (3,).
            k: Number of neighbors, up to the number of points plus 1024.
            distance_upper_bound: Exclusive search radius [m].

        Returns:
            (distances, indices) of shape (m, k), for k = 1 (m,), float64 [m] and int64. Missing neighbors have infinite
            distance and the index n.

        Raises:
            ValueError, DeviceError: If an argument is out of range, the shape is wrong, or the cloud is on another
                device.
        """
        return self._search.distances(x, k, distance_upper_bound)
