"""KDTreeFlann: single queries by scipy's tree in float64; `loom.NearestNeighborSearch` is for many at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import KDTree

from ...core.attribute_hints import HintedNames
from ...core.checks import check_count, check_positive
from ..vectors import DoubleVector, IntVector
from ..wrapper import Wrapper
from .search_param import KDTreeSearchParam, keywords_of

SearchResult = tuple[int, IntVector, DoubleVector]


class KDTreeFlann(HintedNames):
    """Search in the points of a cloud, the vertices of a mesh, features, or the columns of a matrix.

    Searches return count, indices by distance, and squared distances. As in Open3D, the tree keeps the positions at
    construction. Non-finite points are never found.
    """

    _places: NDArray[np.int64]  # indices of the finite points, which the tree contains

    def __init__(self, data: object = None):
        self._tree: KDTree | None = None
        if data is not None:
            self._set(data)

    def set_geometry(self, geometry: object) -> bool:
        return self._set(geometry)

    def set_matrix_data(self, data: ArrayLike) -> bool:
        return self._set(data)

    def set_feature(self, feature: object) -> bool:
        return self._set(feature)

    def _set(self, data: object) -> bool:
        rows = _rows_of(data)
        if not len(rows):
            raise ValueError("data: expected one or more points, got none")
        self._places = np.flatnonzero(np.isfinite(rows).all(axis=1))
        self._tree = KDTree(rows[self._places])
        return True

    def search_knn_vector_3d(self, query: ArrayLike, knn: int) -> SearchResult:
        return self._nearest(query, check_count("knn", knn))

    def search_radius_vector_3d(self, query: ArrayLike, radius: float) -> SearchResult:
        """All points within a radius, excluding those at exactly the radius, as in Open3D."""
        tree, point = self._tree_and_query(query)
        max_distance = check_positive("radius", radius, allow_zero=True, allow_infinite=True)
        rows = np.array(tree.query_ball_point(point, max_distance) if tree.n else (), np.int64)
        sqdists = ((tree.data[rows] - point) ** 2).sum(axis=1)
        rows, sqdists = rows[sqdists < max_distance**2], sqdists[sqdists < max_distance**2]
        order = np.lexsort((rows, sqdists))
        return len(rows), IntVector(self._places[rows[order]]), DoubleVector(sqdists[order])

    def search_hybrid_vector_3d(self, query: ArrayLike, radius: float, max_nn: int) -> SearchResult:
        return self._nearest(
            query, check_count("max_nn", max_nn), check_positive("radius", radius, allow_zero=True, allow_infinite=True)
        )

    def search_vector_3d(self, query: ArrayLike, search_param: KDTreeSearchParam) -> SearchResult:
        limits = keywords_of(search_param)
        if limits["radius"] is None:
            return self.search_knn_vector_3d(query, limits["max_nn"])
        if limits["max_nn"] is None:
            return self.search_radius_vector_3d(query, limits["radius"])
        return self.search_hybrid_vector_3d(query, limits["radius"], limits["max_nn"])

    search_knn_vector_xd = search_knn_vector_3d
    search_radius_vector_xd = search_radius_vector_3d
    search_hybrid_vector_xd = search_hybrid_vector_3d
    search_vector_xd = search_vector_3d

    def _nearest(self, query: ArrayLike, count: int, radius: float = np.inf) -> SearchResult:
        tree, point = self._tree_and_query(query)
        if not tree.n:
            return 0, IntVector(), DoubleVector()
        distances, rows = tree.query(point, min(count, tree.n), distance_upper_bound=radius)
        near = np.isfinite(np.atleast_1d(distances))
        rows = np.atleast_1d(rows)[near]
        return len(rows), IntVector(self._places[rows]), DoubleVector(((tree.data[rows] - point) ** 2).sum(axis=1))

    def _tree_and_query(self, query: ArrayLike) -> tuple[KDTree, NDArray[np.float64]]:
        if self._tree is None:
            raise RuntimeError("the tree contains no points; use KDTreeFlann(cloud), or set_geometry(cloud)")
        point = np.asarray(query, np.float64).reshape(-1)
        if len(point) != self._tree.m or not np.isfinite(point).all():
            raise ValueError(f"query: expected {self._tree.m} finite numbers, got {np.asarray(query).tolist()}")
        return self._tree, point


def _rows_of(data: object) -> NDArray[np.float64]:
    if isinstance(data, Wrapper):
        for name in ("points", "vertices"):
            if name in dir(type(data)):
                return np.asarray(getattr(data, name)).copy()
        raise TypeError(f"data: expected a cloud, a mesh, features or a matrix, got a {type(data).__name__}")
    columns = np.asarray(getattr(data, "data", data) if not isinstance(data, np.ndarray) else data, np.float64)
    if columns.ndim != 2:
        raise TypeError(f"data: expected a cloud, a mesh, features or a matrix [d, n], got {type(data).__name__}")
    return columns.T
