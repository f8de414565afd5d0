"""Checks of the inputs of correspondence-based registration."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_numeric, check_rows, is_on_gpu
from ..core.devices import check_same_device
from ..core.gpu_arrays import take_pairs
from ..kernels.features.feature_matching import pair_features
from ..kernels.lang import int32
from ..kernels.memory import empty, upload
from ..pcd.cloud import PointCloud
from ..pcd.point_arrays import check_cloud as check_cloud
from ..pcd.units import common_reference
from .matching import Pairs, features_on_device


def check_clouds(source: PointCloud, target: PointCloud) -> None:
    check_cloud("source", source)
    check_cloud("target", target)
    check_same_device("source, target", source.arrays["points"].device, target.arrays["points"].device)
    if source.unit is not target.unit or source.crs is not target.crs:
        common_reference("source, target", (source, target))


def check_pairs(corres: ArrayLike, source: PointCloud, target: PointCloud) -> Pairs:
    """Correspondences as int32 [m, 2]. Negative indices are rejected."""
    pairs = check_rows("corres", corres, 2)
    if pairs.dtype.kind not in "iu" and pairs.size:
        raise TypeError(f"corres: expected integers (source index, target index), got {pairs.dtype}")
    for column, (name, cloud) in enumerate((("source", source), ("target", target))):
        rows = pairs[:, column]
        if rows.size and (rows.min() < 0 or rows.max() >= len(cloud)):
            raise IndexError(
                f"corres: {name} indices {rows.min()}..{rows.max()} are out of range for a cloud of {len(cloud)} points"
            )
    return np.ascontiguousarray(pairs, dtype=np.int32)


def pairs_on_device(corres: ArrayLike, source: PointCloud, target: PointCloud) -> wp.array:
    if is_on_gpu(corres):
        return take_pairs(corres, source.device, (len(source), len(target)))
    return upload(check_pairs(corres, source, target), int32, source.device)


def match_clouds(
    source: PointCloud,
    target: PointCloud,
    source_feature: Any,
    target_feature: Any,
    mutual_filter: bool,
    mutual_consistency_ratio: float,
) -> wp.array:
    """Feature correspondences, int32 device array [m, 2]. Arguments as of `correspondences_from_features`."""
    widths = []
    for name, feature, cloud in (("source", source_feature, source), ("target", target_feature, target)):
        given = feature if hasattr(feature, "shape") else check_numeric(f"{name}_feature", feature)
        shape = tuple(given.shape)
        if len(shape) != 2 or shape[0] != len(cloud):
            hint = "; transpose it: Open3D's features are columns" if shape[1:] == (len(cloud),) else ""
            raise ValueError(
                f"{name}_feature: expected shape [{len(cloud)}, d] as the cloud has {len(cloud)} points, "
                f"got {list(shape)}{hint}"
            )
        widths.append(shape[1])
    if widths[0] != widths[1]:
        raise ValueError(
            f"source_feature, target_feature: expected as many columns in both, got {widths[0]} and {widths[1]}"
        )
    if not len(source) or not len(target):
        return empty((0, 2), int32, source.device)
    features = features_on_device(source_feature, target_feature, source.device)
    return pair_features(*features, mutual=mutual_filter, mutual_consistency_ratio=mutual_consistency_ratio)


def world_middles(
    source: PointCloud, target: PointCloud, middles: Sequence[NDArray[np.float32]]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return source.origin + middles[0].astype(np.float64), target.origin + middles[1].astype(np.float64)
