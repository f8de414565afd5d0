"""Checks that reject most wrong RANSAC hypotheses before scoring, on the device, or one at a time with `Check`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_angle, check_list, check_numeric, check_positive, check_shape, check_transformation
from ...kernels.linear_algebra import matmul, norm
from ...kernels.poses.pose_hypotheses import Checks
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds, check_pairs


class CorrespondenceChecker:
    """A test that rejects wrong samples of RANSAC before scoring: the base class of the checkers.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> checker = loom.registration.CorrespondenceCheckerBasedOnDistance(0.5)
        >>> a, b = loom.PointCloud([[0, 0, 0]]), loom.PointCloud([[0, 0, 0.4], [0, 0, 0.6]])
        >>> checker.Check(a, b, [[0, 0]], np.eye(4)), checker.Check(a, b, [[0, 1]], np.eye(4))
        (True, False)
    """

    def Check(self, source: PointCloud, target: PointCloud, corres: ArrayLike, transformation: ArrayLike) -> bool:
        """True if correspondences and a pose pass.

        Args:
            source: The source cloud.
            target: The target cloud.
            corres: Indices (source, target), shape [m, 2].
            transformation: T_target_source, shape [4, 4].

        Raises:
            TypeError, ValueError: Not clouds, a wrong shape, or a matrix that is not finite or not invertible.
        """
        check_clouds(source, target)
        pairs, T = check_pairs(corres, source, target), check_transformation("transformation", transformation)
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):  # non-finite values fail
            return self._passes(source, target, pairs, T)

    def _passes(self, source: PointCloud, target: PointCloud, pairs: NDArray[Any], T: NDArray[np.float64]) -> bool:
        raise NotImplementedError

    def _tighten(self, checks: Checks) -> None:
        """Make the device checks at least as strict as this checker."""
        raise NotImplementedError


class CorrespondenceCheckerBasedOnEdgeLength(CorrespondenceChecker):
    """Distances between the sampled points must be similar in both clouds. Not for poses with scale.

    Args:
        similarity_threshold: Minimum ratio of the shorter to the longer, 0 (loose) to 1 (strict).

    Raises:
        ValueError: A threshold outside 0..1.
    """

    def __init__(self, similarity_threshold: float = 0.9):
        self.similarity_threshold = check_positive("similarity_threshold", similarity_threshold, allow_zero=True)
        if self.similarity_threshold > 1:
            raise ValueError(f"similarity_threshold: expected a number in 0..1, got {similarity_threshold!r}")

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnEdgeLength(similarity_threshold={self.similarity_threshold})"

    def _passes(self, source: PointCloud, target: PointCloud, pairs: NDArray[Any], T: NDArray[np.float64]) -> bool:
        p, q = source.points[pairs[:, 0]], target.points[pairs[:, 1]]
        first, second = np.triu_indices(len(pairs), 1)
        a, b = np.linalg.norm(p[first] - p[second], axis=1), np.linalg.norm(q[first] - q[second], axis=1)
        return not ((a < b * self.similarity_threshold) | (b < a * self.similarity_threshold)).any()

    def _tighten(self, checks: Checks) -> None:
        checks.similarity = max(checks.similarity, self.similarity_threshold)


class CorrespondenceCheckerBasedOnDistance(CorrespondenceChecker):
    """The sampled points must be close under the pose.

    Args:
        distance_threshold: Maximum distance [m].

    Raises:
        ValueError: The threshold is not positive.
    """

    def __init__(self, distance_threshold: float):
        self.distance_threshold = check_positive("distance_threshold", distance_threshold)

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnDistance(distance_threshold={self.distance_threshold})"

    def _passes(self, source: PointCloud, target: PointCloud, pairs: NDArray[Any], T: NDArray[np.float64]) -> bool:
        moved = matmul(source.points[pairs[:, 0]], T[:3, :3].T) + T[:3, 3]
        return not (np.linalg.norm(moved - target.points[pairs[:, 1]], axis=1) > self.distance_threshold).any()

    def _tighten(self, checks: Checks) -> None:
        checks.distance = min(checks.distance, self.distance_threshold)


class CorrespondenceCheckerBasedOnNormal(CorrespondenceChecker):
    """The normals at the sampled points must agree under the pose. Clouds without normals pass.

    Opposite normals do not agree: orient them first. The scale of a pose is ignored, unlike in Open3D.

    Args:
        normal_angle_threshold: Maximum angle [rad].

    Raises:
        ValueError: The threshold is negative.
    """

    def __init__(self, normal_angle_threshold: float):
        self.normal_angle_threshold = check_angle("normal_angle_threshold", normal_angle_threshold, allow_zero=True)

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnNormal(normal_angle_threshold={self.normal_angle_threshold})"

    def _passes(self, source: PointCloud, target: PointCloud, pairs: NDArray[Any], T: NDArray[np.float64]) -> bool:
        if not all("normals" in cloud.arrays for cloud in (source, target)):
            return True
        scale = float(norm(T[:3, 0]))
        rotated = matmul(source.normals[pairs[:, 0]].astype(np.float64), T[:3, :3].T) / scale
        cosines = (rotated * target.normals[pairs[:, 1]]).sum(axis=1)
        return not (cosines < math.cos(self.normal_angle_threshold)).any()

    def _tighten(self, checks: Checks) -> None:
        checks.cosine = max(checks.cosine, math.cos(self.normal_angle_threshold))


class CorrespondenceCheckerBasedOnSourceRotation(CorrespondenceChecker):
    """The pose must not rotate the source too far about its axes.

    Args:
        rotation_threshold: Maximum absolute angles x, y, z [rad] of the rotation Rz Ry Rx, shape [3] (as in Open3D
            0.20, documented as rotation vector).

    Raises:
        ValueError: A wrong shape, or a negative threshold.
    """

    def __init__(self, rotation_threshold: ArrayLike):
        given = check_numeric("rotation_threshold", rotation_threshold)
        limits = check_shape("rotation_threshold", given.reshape(-1), (3,))
        if not (limits >= 0).all():
            raise ValueError(f"rotation_threshold: expected angles >= 0 [rad], got {limits.tolist()}")
        for limit in limits:
            check_angle("rotation_threshold", limit, allow_zero=True)
        self.rotation_threshold = limits

    def __repr__(self) -> str:
        return f"CorrespondenceCheckerBasedOnSourceRotation(rotation_threshold={self.rotation_threshold.tolist()})"

    def _passes(self, source: PointCloud, target: PointCloud, pairs: NDArray[Any], T: NDArray[np.float64]) -> bool:
        R = T[:3, :3] / norm(T[:3, 0])
        angles = np.array(
            [math.atan2(R[2, 1], R[2, 2]), math.asin(np.clip(R[2, 0], -1, 1)), math.atan2(R[1, 0], R[0, 0])]
        )
        return bool((np.abs(angles) <= self.rotation_threshold).all())

    def _tighten(self, checks: Checks) -> None:
        rotation = np.minimum(checks.rotation, self.rotation_threshold)
        checks.rotation = tuple(float(limit) for limit in rotation)


def checks_of(checkers: Sequence[CorrespondenceChecker]) -> Checks:
    checks = Checks()
    for checker in check_list("checkers", checkers, "checkers"):
        if not isinstance(checker, CorrespondenceChecker):
            raise TypeError(f"checkers: expected pointloom.registration's checkers, got {type(checker).__name__}")
        checker._tighten(checks)
    return checks
