"""Open3D's module `open3d.geometry.keypoint`."""

from __future__ import annotations

from ...pcd import keypoints
from ..argument_types import CloudLike
from ..wrapper import unwrap
from .point_cloud import PointCloud


def compute_iss_keypoints(
    input: CloudLike,
    salient_radius: float = 0.0,
    non_max_radius: float = 0.0,
    gamma_21: float = 0.975,
    gamma_32: float = 0.975,
    min_neighbors: int = 5,
) -> PointCloud:
    limits = salient_radius, non_max_radius, gamma_21, gamma_32, min_neighbors
    return PointCloud.from_native(keypoints.compute_iss_keypoints(unwrap(input, PointCloud, "input"), *limits))
