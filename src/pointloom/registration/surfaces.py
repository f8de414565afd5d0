"""Surfaces of clouds at the resolution of a registration, with normals on their concave side."""

from __future__ import annotations

from ..kernels.surface.hollow_side import Surface
from ..pcd.cloud import PointCloud

VOXELS = 1.5  # match distance, as usual for downsampled clouds
NARROW, WIDE = 3.0, 5.0  # [voxels] radii for normals, and for their orientation
NEAR = 4.0  # match distances within which surfaces should match
COSINE = 0.866  # 30 degrees: correct normals mostly differ by less, crossing surfaces by more
ENOUGH = 30  # matches below which they may be chance
FINER = 0.8  # source voxel relative to the target's, to avoid aligned grids


def surface_of(cloud: PointCloud, voxel_size: float) -> Surface:
    bare = cloud._with_arrays({"points": cloud._device_array("points")})
    thinned = bare.voxel_down_sample(voxel_size)
    return Surface(thinned._device_array("points"), NARROW * voxel_size, WIDE * voxel_size)


def surface_for(cloud: PointCloud, voxel_size: float, distance: float) -> Surface:
    """As `surface_of`. Its error names the match distance [m] that the voxels were chosen for."""
    try:
        return surface_of(cloud, voxel_size)
    except ValueError as error:
        raise ValueError(f"max_correspondence_distance: {distance} m is too small for these clouds: {error}") from error
