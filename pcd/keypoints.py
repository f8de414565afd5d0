"""Keypoints: the few points of a cloud that are told from their surroundings."""

from __future__ import annotations

from typing import Literal, overload

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_positive
from ..core.told_arguments import told_arguments
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


@told_arguments
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
    """Intrinsic shape signatures: points around which the surface varies most, in all three directions.

    A point is salient where the eigenvalues l1 >= l2 >= l3 of its neighbours' covariance differ enough, and a keypoint
    where no salient point near it has a larger l3.

    Args:
        cloud: Any cloud; normals are not needed.
        salient_radius: Radius of the covariance [m], the boundary excluded.
        non_max_radius: Radius in which no other l3 is larger [m]. Where either radius is 0, as in Open3D both come from
            the cloud: 6 and 4 times the mean distance of a point to its nearest neighbour.
        gamma_21: A salient point has l2 / l1 below this.
        gamma_32: A salient point has l3 / l2 below this.
        min_neighbors: Points within each radius, the point itself included.
        return_indices: Return the keypoints' indices too.

    Returns:
        The cloud of the keypoints with all their attributes, in their order in the cloud; with `return_indices` also
        their indices, int32 [m]. Of keypoints that tie all stay.

    Raises:
        ValueError: A radius or gamma that is negative or not finite, or min_neighbors below 1.

    Notes:
        O(n) memory. Same bits from run to run. Zhong 2009, with Open3D's choices. Open3D finds none where all entries
        of the covariance are below 1e-12 m^2, and some on exact planes, where l3 is nothing but rounding; here the size
        of the cloud does not matter, and l3 counts from 1e-12 of the radius squared on, a thickness of a millionth of
        the radius. Where points have the same neighbours, Open3D's rounding decides which of them stays. Points that
        are not finite are left out.

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
    keypoints = cloud._select_rows(rows)
    return (keypoints, cloud._handed_out(rows)) if return_indices else keypoints
