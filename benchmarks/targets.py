"""The speeds to reach: our time times the factor is at most the best of the peers' times, in one run on the CPU."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Target:
    """A speed to reach.

    Attributes:
        operation: Name of the operation.
        size: Name of the size.
        factor: How many times as fast as the best of the peers.
        peers: The peers that count.
    """

    operation: str
    size: str
    factor: float
    peers: tuple[str, ...]


OPEN3D = ("open3d-legacy", "open3d-tensor")
TREES = ("small_gicp", "pykdtree", "scipy")

TARGETS = (
    Target("voxel_down_sample", "1M", 1.5, ("open3d-legacy",)),
    Target("normals_hybrid", "200k", 5, OPEN3D),
    Target("normals_hybrid", "1M", 5, OPEN3D),
    Target("knn20_query", "surface 200k", 2, TREES),
    Target("knn20_query", "lidar synthetic", 2, TREES),
    Target("knn20_query", "lidar real", 2, TREES),
    Target("knn20_query", "lidar returns", 2, TREES),
    Target("tsdf_integrate", "30 frames", 4, ("open3d-tensor",)),
    Target("tsdf_mesh", "30 frames", 4, ("open3d-tensor",)),
    Target("marching_cubes", "256^3", 4, ("scikit-image",)),
    Target("marching_cubes", "256^3", 1, ("vtk",)),
    Target("ply_read", "5M", 1, ("open3d-tensor",)),
    Target("ply_write", "5M", 1, ("open3d-tensor",)),
)


def targets_of(operation: str, size: str) -> list[Target]:
    """The targets of one row of the table."""
    return [target for target in TARGETS if (target.operation, target.size) == (operation, size)]
