"""Speed targets on the CPU: pointloom's time times the factor is at most the best baseline's time in one run."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Target:
    """A speed target.

    Attributes:
        operation: Name of the operation.
        size: Name of the size.
        factor: Required ratio to the best of the baselines.
        peers: The baselines that count.
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
    Target("orient_consistently", "200k", 3, ("open3d-legacy",)),
    Target("orient_consistently", "1M", 3, ("open3d-legacy",)),
    Target("knn20_query", "surface 200k", 2, TREES),
    Target("knn20_query", "lidar synthetic", 2, TREES),
    Target("knn20_query", "lidar real", 2, TREES),
    Target("knn20_query", "lidar returns", 2, TREES),
    Target("segment_plane", "200k", 5, ("open3d-legacy",)),
    Target("segment_plane", "1M", 5, ("open3d-legacy",)),
    Target("tsdf_integrate", "30 frames", 4, ("open3d-tensor",)),
    Target("tsdf_mesh", "30 frames", 4, ("open3d-tensor",)),
    Target("tsdf_ray_cast", "30 frames", 1, ("open3d-tensor",)),
    Target("reconstruction", "24 frames", 3, ("open3d-legacy",)),
    Target("slam", "20 frames", 3, ("open3d-tensor",)),
    Target("marching_cubes", "128^3", 1.2, ("vtk",)),
    Target("marching_cubes", "256^3", 4, ("scikit-image",)),
    Target("marching_cubes", "256^3", 1, ("vtk",)),
    Target("statistical_outliers", "200k", 4, OPEN3D),
    Target("statistical_outliers", "1M", 4, OPEN3D),
    Target("radius_outliers", "200k", 5, OPEN3D),
    Target("radius_outliers", "1M", 5, OPEN3D),
    Target("cloud_distance", "200k", 3, ("open3d-legacy", "small_gicp", "pykdtree")),
    Target("cloud_distance", "1M", 3, ("open3d-legacy", "small_gicp", "pykdtree")),
    Target("dbscan", "200k", 4, (*OPEN3D, "scikit-learn")),
    Target("dbscan", "1M", 4, (*OPEN3D, "scikit-learn")),
    Target("ply_read", "5M", 1, ("open3d-tensor",)),
    Target("ply_write", "5M", 1, ("open3d-tensor",)),
    Target("farthest_points", "200k", 5, OPEN3D),
    Target("farthest_points", "1M", 5, OPEN3D),
    Target("fpfh", "200k", 4, OPEN3D),
    Target("fpfh", "1M", 4, OPEN3D),
    Target("iss_keypoints", "200k", 5, ("open3d-legacy",)),
    Target("iss_keypoints", "1M", 5, ("open3d-legacy",)),
    Target("hidden_points", "200k", 1, ("open3d-legacy",)),
    Target("hidden_points", "1M", 1, ("open3d-legacy",)),
    Target("hidden_points", "fragment", 1, ("open3d-legacy",)),
    Target("convex_hull", "1M", 1, ("open3d-legacy",)),
    Target("alpha_shape", "bunny 8k, 6 mm", 5, ("open3d-legacy",)),
    Target("alpha_shape", "bunny 36k, 2 mm", 5, ("open3d-legacy",)),
    Target("alpha_shape", "bunny 36k, 6 mm", 5, ("open3d-legacy",)),
    Target("alpha_shape", "200k", 5, ("open3d-legacy",)),
    Target("drift_rigid", "10k, 3 steps", 20, ("pycpd",)),
    Target("drift_deformable", "10k, 2 steps", 20, ("pycpd",)),
    Target("pose_graph", "ring 1000", 1, ("open3d-legacy",)),
    Target("pose_graph", "grid 900", 1, ("open3d-legacy",)),
    Target("register_globally", "200k, 5 cm", 2, ("kiss-matcher",)),
    Target("register_globally", "200k, 8 cm", 2, ("kiss-matcher",)),
    Target("ransac", "200k, 5 cm", 4, ("open3d-legacy",)),
    Target("ransac", "kitchen, 5 cm", 4, ("open3d-legacy",)),
    Target("feature_matching", "8k", 3, OPEN3D),
    Target("feature_matching", "30k", 3, OPEN3D),
    Target("feature_matching", "kitchen 8k", 5, OPEN3D),
    Target("icp_plane", "200k", 8, ("open3d-legacy",)),
    Target("icp_plane", "200k", 6, ("small_gicp",)),
    Target("gicp", "200k", 1, ("small_gicp",)),
    Target("gicp", "kitti pair", 1.5, ("small_gicp",)),
    Target("icp_batch", "1000 pairs", 20, ("open3d-legacy",)),
    Target("icp_batch", "50 pairs", 4, ("open3d-legacy",)),
    Target("poisson_disk", "10000", 3, ("open3d-legacy",)),
    Target("poisson_disk", "100000", 3, ("open3d-legacy",)),
    Target("mesh_components", "closed 76k", 5, ("open3d-legacy",)),
    Target("mesh_loop", "closed 76k", 10, ("open3d-legacy",)),
    Target("mesh_midpoint", "closed 76k", 1, ("open3d-legacy",)),
    Target("mesh_taubin", "closed 76k", 1, ("open3d-legacy",)),
    Target("ray_casting", "camera 1280x960", 0.5, ("open3d-tensor",)),
    Target("render", "cloud 1M", 1, ("open3d-legacy",)),
    Target("render", "cloud 20M", 1, ("open3d-legacy",)),
    Target("render", "mesh 200k", 1, ("open3d-legacy",)),
    Target("closest_points", "box 200k", 5, ("open3d-tensor",)),
    Target("self_intersection", "closed 76k", 10, ("open3d-legacy",)),
    Target("decimation", "bunny 69k to 7k", 3, ("open3d-legacy",)),
    Target("decimation", "bunny 69k to 2k", 3, ("open3d-legacy",)),
    Target("rgbd_odometry", "pair", 10, ("open3d-legacy",)),
    Target("rgbd_odometry", "pair", 4, ("open3d-tensor",)),
    Target("rgbd_odometry", "prepared", 10, ("open3d-legacy",)),
    Target("rgbd_odometry", "prepared", 4, ("open3d-tensor",)),
    Target("odometry", "64 beams, 115k", 1.5, ("kiss-icp", "small_gicp")),
    Target("odometry", "16 beams, 14k", 1.5, ("kiss-icp", "small_gicp")),
    Target("detail_tree_build", "1M", 2, ("scipy",)),
    Target("detail_tree_build", "10M", 2, ("scipy",)),
    Target("m3c2", "200k", 10, ("py4dgeo",)),
    Target("m3c2", "1M, 100k cores", 10, ("py4dgeo",)),
    Target("segment_sphere", "15k", 20, ("pyransac3d",)),
    Target("segment_sphere", "150k", 20, ("pyransac3d",)),
    Target("segment_cylinder", "15k", 20, ("pyransac3d",)),
    Target("segment_cylinder", "150k", 20, ("pyransac3d",)),
    Target("launch_of_one_thread", "1 thread", 2, ("warp",)),
)


def targets_of(operation: str, size: str) -> list[Target]:
    """The targets of one row of the table."""
    return [target for target in TARGETS if (target.operation, target.size) == (operation, size)]
