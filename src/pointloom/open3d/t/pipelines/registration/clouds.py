"""Clouds of tensors as pointloom's clouds."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .....pcd.cloud import PointCloud
from ....argument_types import TensorLike
from ....core.tensor import Tensor
from ...geometry.native import native_of
from ..tensors import on_host

USED = ("normals", "colors", "covariances", "dopplers", "directions")  # by the estimators, beside positions


def cloud_of(name: str, cloud: Any) -> PointCloud:
    """The pointloom cloud on the device of the tensors. Raises TypeError if it is no cloud of tensors."""
    _positions(name, cloud)
    return native_of(cloud.point, *USED)


def points_of(name: str, cloud: object) -> NDArray[np.float64]:
    """The positions (n, 3), float64."""
    return on_host(_positions(name, cloud)).astype(np.float64)


def _positions(name: str, cloud: Any) -> Tensor:
    if not hasattr(cloud, "point"):
        hint = "; t.geometry.PointCloud.from_legacy(cloud) converts one" if hasattr(cloud, "points") else ""
        raise TypeError(f"{name}: expected a t.geometry.PointCloud, got {type(cloud).__name__}{hint}")
    if "positions" not in cloud.point:
        raise ValueError(f"{name}: expected a cloud with positions; assign cloud.point.positions")
    return cloud.point["positions"]


def clouds_of(source: object, target: object) -> tuple[PointCloud, PointCloud]:
    return cloud_of("source", source), cloud_of("target", target)


def pairs_of(correspondences: TensorLike, count: int) -> NDArray[np.int64]:
    """Pairs (k, 2) of a target index, or -1, for each of `count` source points."""
    targets = on_host(correspondences)
    if targets.shape not in ((count,), (count, 1)):
        raise ValueError(f"correspondences: expected shape [{count}] or [{count}, 1], got {list(targets.shape)}")
    if targets.dtype.kind not in "iu":
        raise TypeError(f"correspondences: expected int64, got {targets.dtype}")
    sources = np.flatnonzero(targets.ravel() != -1)
    return np.column_stack([sources, targets.ravel()[sources]]).astype(np.int64)
