"""Keypoint detection."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.checks import check_count, check_positive
from ..kernels.features.iss import find_iss_keypoints
from .cloud import PointCloud
from .point_arrays import check_cloud


@overload
def compute_iss_keypoints(
    cloud: PointCloud,
    salient_radius: float = 0.0,
    non_max_radius: float = 0.0,
    gamma_21: float = 0.975,
    gamma_32: float = 0.975,
    min_neighbors: int = 5,
    *,
    return_indices: Literal[False] = False,
) -> PointCloud: ...


@overload
def compute_iss_keypoints(
    cloud: PointCloud,
    salient_radius: float = 0.0,
    non_max_radius: float = 0.0,
    gamma_21: float = 0.975,
    gamma_32: float = 0.975,
    min_neighbors: int = 5,
    *,
    return_indices: Literal[True],
) -> tuple[PointCloud, NDArray[np.int32]]: ...


@explain_argument_errors
def compute_iss_keypoints(
    cloud: PointCloud,
    salient_radius: float = 0.0,
    non_max_radius: float = 0.0,
    gamma_21: float = 0.975,
    gamma_32: float = 0.975,
    min_neighbors: int = 5,
    *,
    return_indices: bool = False,
) -> PointCloud | tuple[PointCloud, NDArray[np.int32]]:
    """Detect keypoints by intrinsic shape signatures (ISS).

    A point is salient if the eigenvalues l1 >= l2 >= l3 of its neighborhood's covariance differ enough, and a keypoint
    if no salient point near it has a larger l3. O(n) memory, bitwise reproducible. Scale-invariant: l3 counts from
    1e-12 of the squared radius (Open3D: 1e-12 m^2). Zhong, "Intrinsic shape signatures", ICCV Workshops 2009.

    Args:
        cloud: Any cloud. Normals are not needed.
        salient_radius: Exclusive radius of the covariance [m].
        non_max_radius: Radius of non-maximum suppression [m]. If either is 0: 6 and 4 times the mean spacing.
        gamma_21, gamma_32: Upper limits of l2 / l1 and l3 / l2 of salient points.
        min_neighbors: Minimum points within each radius, including the point itself.
        return_indices: Also return the indices.

    Returns:
        Cloud of the keypoints in order, ties included. With `return_indices` also their indices, int32 (m,).

    Raises:
        ValueError: If an argument is out of range.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41))
        >>> hill = np.exp(-20 * (x**2 + 2 * y**2)) + 0.1 * x
        >>> cloud = loom.PointCloud(np.column_stack([x.ravel(), y.ravel(), hill.ravel()]))
        >>> keypoints, indices = loom.compute_iss_keypoints(cloud, 0.3, 0.3, return_indices=True)
        >>> 0 < len(keypoints) < 20, bool((keypoints.points == cloud.points[indices]).all())
        (True, True)
    """
    check_cloud("cloud", cloud)
    salient = check_positive("salient_radius", salient_radius, allow_zero=True)
    non_max = check_positive("non_max_radius", non_max_radius, allow_zero=True)
    ratio_21 = check_positive("gamma_21", gamma_21, allow_zero=True)
    ratio_32 = check_positive("gamma_32", gamma_32, allow_zero=True)
    count = min(check_count("min_neighbors", min_neighbors), len(cloud) + 1)
    radii = (salient, non_max) if salient > 0 and non_max > 0 else None
    rows = find_iss_keypoints(cloud.search_tree(), radii, ratio_21, ratio_32, count)
    keypoints = cloud.select_rows(rows)
    return (keypoints, cloud.arrays.hand_out(rows)) if return_indices else keypoints
