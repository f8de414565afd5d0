"""NearestNeighborSearch of tensors."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from ....core.attribute_hints import HintedNames
from ....core.checks import check_count, check_positive
from ....pcd.search import NearestNeighborSearch as PointSearch
from ...argument_types import TensorLike
from ..dtype import Dtype, int32, int64
from ..errors import TensorError
from ..tensor import Tensor


class NearestNeighborSearch(HintedNames):
    """Searches among points of shape (n, d), on their device.

    In three dimensions this is `loom.NearestNeighborSearch`, in others SciPy's tree on the host. Squared distances have
    the dtype of the points: on the CPU they are computed in float64, on a GPU in float32. Neighbors are sorted by
    distance.
    """

    def __init__(self, dataset_points: TensorLike, index_dtype: Dtype = int64):
        points = dataset_points if isinstance(dataset_points, Tensor) else Tensor(dataset_points)
        if points.ndim != 2 or points.dtype.numpy.kind != "f":
            wanted = "Float32 or Float64 of shape (n, d)"
            raise TensorError(f"dataset_points: expected {wanted}, got {points.dtype} of shape {list(points.shape)}")
        if index_dtype not in (int32, int64):
            raise TensorError(f"index_dtype: expected Int32 or Int64, got {index_dtype}")
        self._points, self._index_dtype, self._indices = points.clone(), index_dtype, set[str]()
        self._tree: Any = None

    def knn_index(self) -> bool:
        return self._index("knn")

    def multi_radius_index(self) -> bool:
        return self._index("multi_radius")

    def fixed_radius_index(self, radius: float | None = None) -> bool:
        """Prepare searches within any radius."""
        return self._index("fixed_radius")

    def hybrid_index(self, radius: float | None = None) -> bool:
        """Prepare searches within any radius."""
        return self._index("hybrid")

    def _index(self, name: str) -> bool:
        if self._tree is None and len(self._points):
            is_3d = self._points.shape[1] == 3
            self._tree = PointSearch(self._points.array) if is_3d else KDTree(self._points.numpy())
        self._indices.add(name)
        return True

    def knn_search(self, query_points: TensorLike, knn: int) -> tuple[Tensor, Tensor]:
        """Indices and squared distances of the `knn` nearest points, or of all if there are fewer: (m, knn)."""
        queries = self._queries("knn", query_points)
        return self._nearest(queries, min(check_count("knn", knn), len(self._points)), np.inf)[:2]

    def hybrid_search(self, query_points: TensorLike, radius: float, max_knn: int) -> tuple[Tensor, Tensor, Tensor]:
        """Up to `max_knn` points closer than `radius`: indices and squared distances (m, max_knn), and counts (m,).

        Missing neighbors have index -1 and distance 0.
        """
        queries = self._queries("hybrid", query_points)
        return self._nearest(queries, check_count("max_knn", max_knn), check_positive("radius", radius))

    def fixed_radius_search(
        self, query_points: TensorLike, radius: float, sort: bool | None = True
    ) -> tuple[Tensor, Tensor, Tensor]:
        """All points closer than `radius`: indices, squared distances, and where those of each query begin (m + 1,)."""
        queries = self._queries("fixed_radius", query_points)
        return self._within(queries, np.full(len(queries), check_positive("radius", radius)))

    def multi_radius_search(self, query_points: TensorLike, radii: TensorLike) -> tuple[Tensor, Tensor, Tensor]:
        """As `fixed_radius_search`, with a radius for each query."""
        queries = self._queries("multi_radius", query_points)
        given = np.asarray(radii)
        if given.shape != (len(queries),) or not (given > 0).all():
            raise TensorError(f"radii: expected {len(queries)} positive numbers, got {given.tolist()}")
        return self._within(queries, given)

    def _queries(self, name: str, given: TensorLike) -> Tensor:
        queries = given if isinstance(given, Tensor) else Tensor(given)
        if name not in self._indices:
            raise TensorError(f"{name}_search: expected an index, got none; call {name}_index() first")
        wanted = (self._points.dtype, self._points.device, self._points.shape[1:])
        if (queries.dtype, queries.device, queries.shape[1:]) != wanted:
            shape = f"{wanted[0]} of shape (m, {wanted[2][0]}) on {wanted[1]}"
            given_shape = f"{queries.dtype} of shape {list(queries.shape)} on {queries.device}"
            raise TensorError(f"query_points: expected {shape}, got {given_shape}")
        return queries.contiguous()

    def _nearest(self, queries: Tensor, k: int, radius: float) -> tuple[Tensor, Tensor, Tensor]:
        if not len(queries) or not len(self._points):
            empty = np.full((len(queries), k), -1), np.zeros((len(queries), k)), np.zeros(len(queries))
            return self._results(*empty)
        if isinstance(self._tree, PointSearch):
            search = self._tree.knn_search if radius == np.inf else lambda q, k: self._tree.hybrid_search(q, radius, k)
            indices, sqdists, counts = search(queries.array, k)
            if not queries.is_cpu:
                indices, sqdists, counts = map(Tensor.from_array, (indices, sqdists, counts))
                distances = sqdists.to(queries.dtype)
                distances[distances.isinf()] = 0
                return indices.to(self._index_dtype), distances, counts.to(self._index_dtype)
        else:
            indices = self._tree.query(queries.numpy(), range(1, k + 1), distance_upper_bound=radius)[1]
            indices = np.where(indices < len(self._points), indices, -1)
        is_found = indices >= 0
        distances = np.zeros(indices.shape)
        distances[is_found] = self._sqdists(queries, np.nonzero(is_found)[0], indices[is_found])
        return self._results(indices, distances, is_found.sum(axis=1))

    def _within(self, queries: Tensor, radii: NDArray[Any]) -> tuple[Tensor, Tensor, Tensor]:
        if not len(queries) or not len(self._points):
            return self._results(np.zeros(0), np.zeros(0), np.zeros(len(queries) + 1))
        if isinstance(self._tree, PointSearch):
            found = self._tree.radius_search(queries.array, float(radii.max()))
            indices, sqdists, counts = (Tensor.from_array(part).numpy() for part in found)
            owners = np.repeat(np.arange(len(queries)), counts)
            if queries.is_cpu:
                sqdists = self._sqdists(queries, owners, indices)
        else:
            lists = self._tree.query_ball_point(queries.numpy(), radii)
            owners = np.repeat(np.arange(len(queries)), [len(each) for each in lists])
            indices = np.concatenate([*lists, []]).astype(np.int64)
            sqdists = self._sqdists(queries, owners, indices)
            order = np.lexsort((indices, sqdists, owners))
            owners, indices, sqdists = owners[order], indices[order], sqdists[order]
        is_near = sqdists < radii[owners].astype(np.float64) ** 2
        counts = np.bincount(owners[is_near], minlength=len(queries))
        return self._results(indices[is_near], sqdists[is_near], np.concatenate([[0], np.cumsum(counts)]))

    def _sqdists(self, queries: Tensor, owners: NDArray[Any], indices: NDArray[Any]) -> Any:
        """Squared distances of some queries from points, in float64."""
        steps = self._points.numpy()[indices].astype(np.float64) - queries.numpy()[owners]
        return (steps**2).sum(axis=1)

    def _results(
        self, indices: NDArray[Any], sqdists: NDArray[Any], counts: NDArray[Any]
    ) -> tuple[Tensor, Tensor, Tensor]:
        kind, device = self._index_dtype, self._points.device
        return Tensor(indices, kind, device), Tensor(sqdists, self._points.dtype, device), Tensor(counts, kind, device)
