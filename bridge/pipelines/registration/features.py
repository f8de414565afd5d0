"""Features as Open3D keeps them: a column a point."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.checks import check_count, check_numeric
from ....core.known_names import KnownNames
from ....pcd import features
from ....registration import matching
from ...geometry import PointCloud
from ...geometry.search_param import keywords_of
from ...held import ours
from ...indices import flagged
from ...vectors import Vector2iVector


class Feature(KnownNames):
    """Features of the points of a cloud: `data` has a column a point, float64 [dimension, points]."""

    _data: NDArray[np.float64]

    def __init__(self, other: Any = None):
        self._data = np.zeros((0, 0)) if other is None else other.data.copy()

    @classmethod
    def _of_rows(cls, rows: Any) -> Feature:
        """Features that are a row a point, as ours are."""
        made = cls()
        made.data = np.asarray(rows).T
        return made

    @property
    def data(self) -> NDArray[np.float64]:
        """The columns; assign others."""
        return self._data

    @data.setter
    def data(self, columns: Any) -> None:
        values = check_numeric("data", columns)
        if values.ndim != 2:
            raise ValueError(f"data: expected shape [dimension, points], got {list(values.shape)}")
        self._data = values.astype(np.float64)

    def dimension(self) -> int:
        """Numbers a point."""
        return self._data.shape[0]

    def num(self) -> int:
        """Points."""
        return self._data.shape[1]

    def resize(self, dim: int, n: int) -> None:
        """Other numbers of both; all zero."""
        self._data = np.zeros((check_count("dim", dim, minimum=0), check_count("n", n, minimum=0)))

    def select_by_index(self, indices: Any, invert: bool = False) -> Feature:
        """The features of these points, each once and in their order, or of the others."""
        flags = flagged("indices", indices, self.num(), f"Feature of {self.num()} points")
        return Feature._of_rows(self._data.T[flags != invert])

    def __repr__(self) -> str:
        size = f"dimension = {self.dimension()} and num = {self.num()}"
        return f"Feature class with {size}\nAccess its data via data member."


def rows_of(feature: Any, name: str) -> NDArray[np.float32]:
    """A row a point, as ours take them.

    Raises:
        TypeError: Something else than a `Feature`.
    """
    if not isinstance(feature, Feature):
        raise TypeError(f"{name}: expected a Feature, got {type(feature).__name__}; Feature().data = array.T makes one")
    return np.ascontiguousarray(feature.data.T, np.float32)


def compute_fpfh_feature(input: Any, search_param: Any, indices: Any = None) -> Feature:
    """FPFH, 33 numbers a point; the cloud needs normals. With `indices`, of these points alone, each once."""
    rows = np.asarray(features.compute_fpfh_feature(ours(input, PointCloud, "input"), **keywords_of(search_param)))
    made = Feature._of_rows(rows)
    return made if indices is None else made.select_by_index(indices)


def correspondences_from_features(
    source_features: Any, target_features: Any, mutual_filter: bool = False, mutual_consistency_ratio: float = 0.1
) -> Vector2iVector:
    """Pair each source point with the target point whose feature is nearest."""
    sides = rows_of(source_features, "source_features"), rows_of(target_features, "target_features")
    return Vector2iVector(matching.correspondences_from_features(*sides, mutual_filter, mutual_consistency_ratio))
