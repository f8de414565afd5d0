"""Features of clouds of tensors."""

from __future__ import annotations

import numpy as np

from .....pcd import features
from .....registration import matching
from ....argument_types import TensorCloud, TensorLike
from ....core.dtype import int64
from ....core.tensor import Tensor
from ....indices import flagged
from ..tensors import on_host, tensor_of
from .clouds import cloud_of


def compute_fpfh_feature(
    input: TensorCloud, max_nn: int | None = 100, radius: float | None = None, indices: TensorLike | None = None
) -> Tensor:
    """FPFH features (n, 33) in the type of the positions. With `indices`, of these points, each once in their order.

    Requires normals. Neighbors: the nearest `max_nn`, all within `radius` [m], or both limits.
    """
    if max_nn is None and radius is None:
        raise ValueError("max_nn, radius: expected at least one of them, got None for both")
    positions = input.point["positions"]
    rows = on_host(features.compute_fpfh_feature(cloud_of("input", input), radius=radius, max_nn=max_nn))
    if indices is not None:
        rows = rows[flagged("indices", np.asarray(on_host(indices)), len(rows), f"cloud of {len(rows)} points")]
    return tensor_of(rows, positions.dtype, positions.device)


def correspondences_from_features(
    source_features: Tensor, target_features: Tensor, mutual_filter: bool = False, mutual_consistency_ratio: float = 0.1
) -> Tensor:
    """Pairs (source, target) of nearest features, int64 (k, 2), by source."""
    sides = source_features.array, target_features.array
    pairs = matching.correspondences_from_features(*sides, mutual_filter, mutual_consistency_ratio)
    return tensor_of(pairs, int64, source_features.device)
