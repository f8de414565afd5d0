"""Automatic voxel size for registration: `choose_voxel_size`."""

from __future__ import annotations

from statistics import median_low

import numpy as np

from ..core.coordinates import quiet
from ..pcd.cloud import PointCloud
from ..pcd.point_spacing import distance_of_nearest, probe_points, rounded_up
from ..pcd.search import NearestNeighborSearch
from .correspondence_input import check_cloud

# This gives some 5,000 to 15,000 occupied voxels for a room, an object or a street.
VOXELS_TO_MIDDLE, EXTENT_QUANTILE = 32.0, 0.75


def choose_voxel_size(*clouds: PointCloud) -> float:
    """Choose a voxel edge [m] for the registration of clouds, to two digits.

    1/32 of the distance from the center that contains three quarters of the points (sampled), at least the typical
    neighbor distance. The minimum of two clouds, the median of more.

    Args:
        *clouds: At least one, each with a finite point.

    Returns:
        The edge. 1 if all points coincide.

    Raises:
        TypeError, ValueError: Not a PointCloud, no cloud, or one without a finite point.

    Notes:
        Samples about 1,000 points per cloud, with one neighbor search. Bitwise reproducible.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.voxel_size import choose_voxel_size
        >>> room = loom.PointCloud(np.random.default_rng(0).random((20000, 3)) * [4, 5, 2.5])
        >>> choose_voxel_size(room)
        0.076
    """
    if not clouds:
        raise ValueError("clouds: expected at least one, got none")
    return choose_for({f"clouds[{i}]": cloud for i, cloud in enumerate(clouds)})


def choose_for(clouds: dict[str, PointCloud]) -> float:
    size = median_low([_size_of(name, cloud) for name, cloud in clouds.items()])
    return rounded_up(size) if size > 0 else 1.0


def resolvable_voxel_size(source: PointCloud, target: PointCloud) -> float:
    """As `choose_voxel_size`, but at least the typical neighbor distance of both clouds, so that both have surfaces."""
    sizes = [_lengths_of(name, cloud) for name, cloud in (("source", source), ("target", target))]
    size = max(min(extent for extent, _ in sizes) / VOXELS_TO_MIDDLE, *(spacing for _, spacing in sizes))
    return size if size > 0 else 1.0


def extent_of(name: str, cloud: PointCloud) -> float:
    """Distance [m] from the center that contains three quarters of the points."""
    return _lengths_of(name, cloud)[0]


def _size_of(name: str, cloud: PointCloud) -> float:
    extent, spacing = _lengths_of(name, cloud)
    return max(extent / VOXELS_TO_MIDDLE, spacing)


@quiet()
def _lengths_of(name: str, cloud: PointCloud) -> tuple[float, float]:
    """Distance from the center that contains three quarters of the points, and typical neighbor distance [m]."""
    check_cloud(name, cloud)
    probes = probe_points(cloud)
    if not len(probes):
        contents = f"{len(cloud):,} points, none of them finite" if len(cloud) else "no point"
        raise ValueError(f"{name}: expected finite points, got {contents}")
    extent = float(np.quantile(np.linalg.norm(probes - np.median(probes, axis=0), axis=1), EXTENT_QUANTILE))
    return extent, distance_of_nearest(NearestNeighborSearch(cloud), probes, 2) or 0.0
