"""The operations timed on a GPU: preparation and call.

Cached data of a cloud, such as its tree, are prepared before the call; `tree` measures the tree. Rows of one name have
NumPy input and results, with their transfer. Rows that end in `_device` have Warp arrays, and all data stay on the GPU.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import scenes
from bench_icp import DISTANCE, ITERATIONS, offset
from gpu_more_operations import MORE_ROWS
from gpu_operation import DEVICE, FULL_HD, UHD, VGA, Operation, cloud_of, image_size, spacing_of, surface_of
from mesh_scenes import scene_in_pointloom, wavy_mesh

# ------------------------------------------------------------------------------------------------ clouds


def on_cloud(
    call: Callable[[Any, int], Any], *, tree: bool, arrays: str = "numpy"
) -> Callable[[int], Callable[[], Any]]:
    """An operation on the surface, with the tree built beforehand or in the call."""

    def prepare(size: int) -> Callable[[], Any]:
        cloud = cloud_of(size, arrays=arrays)
        if tree:
            cloud.search_tree()
        return lambda: call(cloud, size)

    return prepare


def _knn(cloud: Any, size: int) -> Any:
    import pointloom as loom

    return loom.NearestNeighborSearch(cloud).knn_search(cloud, 20)


def _voxel_of(size: int) -> float:
    """The voxel size [m] that leaves about `size` of a million points."""
    return 0.02 * (62_000 / size) ** 0.5


def _described(size: int, arrays: str) -> Any:
    voxel = _voxel_of(size)
    cloud = cloud_of(1_000_000, arrays=arrays).voxel_down_sample(voxel).estimate_normals(radius=2 * voxel, max_nn=30)
    cloud = cloud.orient_normals_to_align_with_direction()
    cloud.search_tree()
    return cloud


def _fpfh(arrays: str = "numpy") -> Callable[[int], Callable[[], Any]]:
    def prepare(size: int) -> Callable[[], Any]:
        import pointloom as loom

        cloud = _described(size, arrays)
        return lambda: loom.compute_fpfh_feature(cloud, radius=5 * _voxel_of(size), max_nn=100)

    return prepare


def _dbscan(cloud: Any, size: int) -> Any:
    return cloud.cluster_dbscan(0.02 * spacing_of(size), 10)


def _outliers(cloud: Any, size: int) -> Any:
    return cloud.remove_statistical_outlier(20, 2.0)


def _normals(cloud: Any, size: int) -> Any:
    return cloud.estimate_normals(max_nn=30)


def _hybrid_normals(cloud: Any, size: int) -> Any:
    return cloud.estimate_normals(radius=0.03 * spacing_of(size), max_nn=30)


def given(array: Any, arrays: str) -> Any:
    """An array as a library's: of NumPy on the host, or of Warp on the GPU."""
    import warp as wp

    return array if arrays == "numpy" else wp.array(array, dtype=wp.dtype_from_numpy(array.dtype), device=DEVICE)


# ------------------------------------------------------------------------------------------------ registration


def _icp(size: int) -> Callable[[], Any]:
    import pointloom as loom

    T = offset()
    points = (surface_of(size, 1) - T[:3, 3]) @ T[:3, :3]
    source, target = loom.PointCloud(points, device=DEVICE), cloud_of(size).estimate_normals(max_nn=20)
    reg = loom.registration
    method = reg.TransformationEstimationPointToPlane()

    def align(steps: int) -> Any:
        rules = reg.ICPConvergenceCriteria(0, 0, steps)
        return reg.registration_icp(source, target, DISTANCE, None, method, rules)

    align(1)  # builds trees and other cached data
    return lambda: align(ITERATIONS)


def _ransac(samples: int) -> Callable[[], Any]:
    import pointloom as loom

    voxel, T = 0.05, offset()
    target = cloud_of(200_000).voxel_down_sample(voxel)
    source = loom.PointCloud((target.points - T[:3, 3]) @ T[:3, :3], device=DEVICE)
    count, rng = len(target.points), np.random.default_rng(0)
    pairs = np.stack([np.arange(count)] * 2, axis=1).astype(np.int32)
    wrong = rng.random(count) < 0.6
    pairs[wrong, 1] = rng.integers(0, count, wrong.sum())
    reg = loom.registration
    checkers = [reg.CorrespondenceCheckerBasedOnEdgeLength(0.9), reg.CorrespondenceCheckerBasedOnDistance(1.5 * voxel)]
    call = reg.registration_ransac_based_on_correspondence
    return lambda: call(source, target, pairs, 1.5 * voxel, checkers=checkers, num_iterations=samples, confidence=1.0)


# ------------------------------------------------------------------------------------------------ volumes, meshes


def _volume(count: int, pixels: int, arrays: str = "numpy") -> tuple[Any, Callable[[int], Any]]:
    import pointloom as loom

    frames = scenes.room_frames(count, *image_size(pixels))
    height, width = frames.depths.shape[1:]
    camera = loom.PinholeCameraIntrinsic(width, height, *frames.intrinsic)
    volume = loom.TSDFVolume(voxel_size=0.01, truncation=0.04, color=False, device=DEVICE)
    depths = [given(depth, arrays) for depth in frames.depths]

    def integrate(k: int) -> Any:
        return volume.integrate(depths[k], camera, frames.extrinsics[k], depth_scale=1000.0, depth_max=5.0)

    return volume, integrate


def _tsdf_integrate(arrays: str = "numpy") -> Callable[[int], Callable[[], Any]]:
    def prepare(pixels: int) -> Callable[[], Any]:
        _, integrate = _volume(3, pixels, arrays)
        for k in range(2):
            integrate(k)
        return lambda: integrate(2)

    return prepare


def _tsdf_mesh(pixels: int) -> Callable[[], Any]:
    volume, integrate = _volume(3, pixels)
    for k in range(3):
        integrate(k)
    return lambda: volume.extract_triangle_mesh(weight_threshold=0)


def _marching_cubes(cells: int) -> Callable[[], Any]:
    import warp as wp

    import pointloom as loom

    field = wp.array(scenes.wavy_ball(round(cells ** (1 / 3))), dtype=wp.float32, device=DEVICE)
    return lambda: loom.meshing.marching_cubes(field)


def _cast_rays(arrays: str = "numpy") -> Callable[[int], Callable[[], Any]]:
    def prepare(count: int) -> Callable[[], Any]:
        import pointloom as loom

        vertices, triangles = wavy_mesh(128)
        middle, size = (vertices.min(axis=0) + vertices.max(axis=0)) / 2, np.ptp(vertices, axis=0).max()
        eye = middle + size * np.array([0.2, 0.3, 1.2])
        height = round((count * 3 / 4) ** 0.5)
        rays = loom.RaycastingScene.create_rays_pinhole(60, middle, eye, [0, 1, 0], count // height, height)
        scene = scene_in_pointloom((vertices, triangles), DEVICE)
        scene.cast_rays(rays[:1])
        own = given(rays, arrays)
        return lambda: scene.cast_rays(own)

    return prepare


def _closest_points(arrays: str = "numpy") -> Callable[[int], Callable[[], Any]]:
    def prepare(count: int) -> Callable[[], Any]:
        vertices, triangles = wavy_mesh(128)
        rng = np.random.default_rng(0)
        queries = rng.uniform(vertices.min(axis=0), vertices.max(axis=0), (count, 3)).astype(np.float32)
        scene = scene_in_pointloom((vertices, triangles), DEVICE)
        scene.compute_closest_points(queries[:1])
        own = given(queries, arrays)
        return lambda: scene.compute_closest_points(own)

    return prepare


LARGE = (10_000_000, 50_000_000)
PIXELS = (VGA, FULL_HD, UHD)
ROWS = (
    Operation("normals_k30", on_cloud(_normals, tree=True), large=LARGE),
    Operation("normals_hybrid", on_cloud(_hybrid_normals, tree=True)),
    Operation("knn20", on_cloud(_knn, tree=True)),
    Operation("knn20_device", on_cloud(_knn, tree=True, arrays="warp")),
    Operation("tree", on_cloud(lambda c, n: c.search_tree(), tree=False), large=LARGE, in_new_state=True),
    Operation("fpfh", _fpfh(), (62_000, 300_000), small=500),
    Operation("fpfh_device", _fpfh("warp"), (62_000, 300_000), small=500),
    Operation("voxel_down_sample", on_cloud(lambda c, n: c.voxel_down_sample(0.02), tree=False), large=LARGE),
    Operation("statistical_outliers", on_cloud(_outliers, tree=True)),
    Operation("statistical_outliers_device", on_cloud(_outliers, tree=True, arrays="warp")),
    Operation("dbscan", on_cloud(_dbscan, tree=True)),
    Operation("dbscan_device", on_cloud(_dbscan, tree=True, arrays="warp"), large=LARGE),
    Operation("farthest_points", on_cloud(lambda c, n: c.farthest_point_down_sample(min(n // 4, 1000)), tree=True)),
    Operation("segment_plane", on_cloud(lambda c, n: c.segment_plane(0.01, num_iterations=1000), tree=False)),
    Operation("icp_plane", _icp, (200_000,)),
    Operation("ransac", _ransac, (100_000,)),
    Operation("tsdf_integrate", _tsdf_integrate(), PIXELS, small=160 * 120),
    Operation("tsdf_integrate_device", _tsdf_integrate("warp"), PIXELS, small=160 * 120),
    Operation("tsdf_mesh", _tsdf_mesh, (VGA,), small=160 * 120),
    Operation("marching_cubes", _marching_cubes, (256**3,), small=24**3),
    Operation("cast_rays", _cast_rays()),
    Operation("cast_rays_device", _cast_rays("warp")),
    Operation("closest_points", _closest_points(), (200_000,)),
    Operation("closest_points_device", _closest_points("warp"), (200_000,)),
)
OPERATIONS = {o.name: o for o in (*ROWS, *MORE_ROWS)}
