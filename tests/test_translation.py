"""Results do not depend on the position of the data: operations at four offsets, shifted back, equal the one at zero.

The operations are those on meshes, volumes, rays and pairs of scans, and calls with given positions. Those on one cloud
are in test_operations.py.

Coordinates are multiples of 2^-16 m, which float32 represents exactly within 128 m of an origin, but not at some km.
"""

from __future__ import annotations

import zlib
from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from .registration.poses import as_pose

reg = loom.registration
OFFSETS = [(0, 0, 0), (501, -351, 51), (5001, 3999, 99), (9000, -7998, 300), (500_001, 5_400_000, 300)]  # by 3 m

# How a result is moved back, its tolerance (0: bitwise), and the operation.
# same: independent of the offset; moved: positions; pose: of the world to itself; world: to the world from elsewhere.
CASES = """
moved 0 cloud.points
moved 1e-6 cloud.get_center()
moved 0 cloud.get_max_bound()
same 1e-5 cloud.orient_normals_towards_camera_location(at([2, 1.5, 1])).normals
same 0 cloud.voxel_down_sample_and_trace(0.2, at([-1, -1, -1]), at([5, 5, 5])).voxel_of_point
same 0 cloud.crop(loom.AxisAlignedBoundingBox(at([0, 0, 0]), at([2, 2, 1]))).normals
same 0 cloud.crop(loom.OrientedBoundingBox(at([2, 1, 1]), turn, [2, 2, 1])).normals
same 0 cloud.hidden_point_removal(at([2, 1.5, 1.2]), 100.0)[1]
moved 1e-6 cloud.rotate(turn, center=at([1, 1, 1])).points
moved 1e-6 cloud.scale(2.0, center=at([1, 1, 1])).points
moved 1e-6 cloud.transform(about(near)).points
same 0 loom.NearestNeighborSearch(cloud).knn_search(at([[1, 1, 1], [2, 0, 1]]), 5)[0]
moved 1e-6 loom.PointCloud.create_from_depth_image(depth, camera, view @ shift(-1)).points
same 1e-6 cloud.project_to_depth_image(64, 48, camera, view @ shift(-1))
moved 0 mesh.vertices
same 1e-6 mesh.get_surface_area()
same 1e-5 mesh.get_volume()
moved 1e-6 mesh.get_center()
same 1e-6 mesh.compute_triangle_normals()
same 1e-6 mesh.compute_vertex_normals().vertex_normals
moved 1e-5 mesh.sample_points_uniformly(50, seed=1).points
moved 1e-5 mesh.filter_smooth_taubin(2).vertices
moved 1e-6 mesh.translate([1, 2, 3]).vertices
moved 1e-6 mesh.transform(about(near)).vertices
moved 1e-5 mesh.subdivide_loop(1).vertices
same 0 soup.merge_close_vertices(1e-4).triangles
same 1e-5 mesh.simplify_quadric_decimation(300).get_surface_area()
same 0 mesh.simplify_vertex_clustering(0.25).triangles
same 1e-4 mesh.boolean_difference(mesh.translate([0.5, 0.25, 0.125])).get_volume()
same 0 loom.TriangleMesh.concatenate([mesh, mesh.translate([0.5, 0.25, 0.125])]).get_self_intersecting_triangles()
same 1e-5 mesh.compute_vertex_curvature().largest
same 1e-4 loom.TriangleMesh.create_from_point_cloud_poisson(ball, depth=4)[0].get_surface_area()
same 1e-6 scene.cast_rays(rays)["t_hit"]
same 1e-6 scene.compute_signed_distance(at([[0, 0, 0], [1, 0, 0.1]]))
moved 1e-6 scene.compute_closest_points(at([[0, 0, 0.5]]))["points"]
same 0 loom.TriangleMesh.create_from_point_cloud_alpha_shape(ball, 0.2).triangles
same 0 loom.TriangleMesh.create_from_point_cloud_ball_pivoting(ball, [0.1, 0.2]).triangles
moved 1e-4 volume.extract_triangle_mesh(weight_threshold=0).vertices
moved 1e-6 loom.LineSet(points=cloud.points[:4], lines=[[0, 1], [2, 3]]).transform(about(near)).points
pose 2e-6 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationPointToPoint()).transformation
pose 2e-6 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationPointToPlane()).transformation
pose 2e-5 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationPointToPlane(reg.TukeyLoss(0.05))).transformation
pose 2e-6 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationPointToPlane(), constraint=reg.Constraint(("x", "y", "z", "yaw"))).transformation
pose 2e-6 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationPointToPlane(), overlap=0.9).transformation
pose 2e-6 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationForGeneralizedICP()).transformation
pose 2e-5 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationForGeneralizedICP(voxel_size=0.5)).transformation
pose 2e-6 reg.registration_ndt(other, cloud, reg.NormalDistributionsTransformOption(0.5), about(start)).transformation
pose 2e-5 reg.registration_icp(other, cloud, 0.2, about(start), reg.TransformationEstimationForColoredICP()).transformation
pose 2e-6 reg.registration_icp_batch([other, other], cloud, 0.2, np.array([about(start), about(near)]), reg.TransformationEstimationPointToPlane())[1].transformation
pose 2e-5 reg.multi_scale_icp(other, cloud, [0.25, 0.125], [reg.ICPConvergenceCriteria()] * 2, [0.5, 0.25], init=about(start), estimation_method=reg.TransformationEstimationPointToPlane()).transformation
same 1e-5 reg.assess_registration(other, cloud, about(near), 0.2).score
same 1e-6 reg.evaluate_registration(other, cloud, 0.2, about(near)).inlier_rmse
pose 1e-4 reg.register_pair(other, cloud, init=about(start)).transformation
pose 1e-4 reg.register_globally(other, cloud, voxel_size=0.1).transformation
pose 1e-3 reg.registration_ransac_based_on_correspondence(other, cloud, reg.correspondences_from_features(*features, True), 0.15, seed=1).transformation
pose 1e-3 reg.registration_fgr_based_on_correspondence(other, cloud, reg.correspondences_from_features(*features, True, 0.0)).transformation
pose 2e-5 reg.registration_ransac_based_on_correspondence(other, cloud, pairs, 0.1, seed=1).transformation
same 1e-4 reg.assess_registration(other, cloud, about(near), 0.2).alignment.displacement
same 1e-3 reg.assess_registration(other, cloud, about(near), 0.2).covariance.sigmas
same 1e-4 reg.assess_registration(other, cloud, about(near), 0.2).localizability.fractions
moved 1e-3 reg.register_nonrigid(other, cloud, node_spacing=0.6, max_iterations=3).warped.points
world 1e-5 reg.register_multiway([cloud, other], voxel_size=0.1).poses[1] @ shift(1)
world 1e-5 reg.global_optimization(graph, option=reg.GlobalOptimizationOption(reference_node=0)).nodes[2].pose @ shift(1)
moved 1e-5 reg.deskew_point_cloud(cloud, about(start), np.arange(len(cloud))).points
moved 1e-3 reg.coherent_point_drift(other, cloud, max_iterations=5).warped.points
moved 0 cloud.get_min_bound()
moved 1e-6 loom.PointCloud.create_from_rgbd_image(loom.RGBDImage(np.full((48, 64, 3), 100, np.uint8), depth), camera, view @ shift(-1)).points
same 1e-6 cloud.project_to_rgbd_image(64, 48, camera, view @ shift(-1)).depth
same 1e-4 ball.segment_shape("sphere", 0.02, seed=1)[0].radius
moved 1e-4 ball.segment_shape("sphere", 0.02, seed=1)[0].center
moved 0 cloud.thin(0.3, corner=at([-1, -1, -1])).points
same 0 mesh.boolean_union(mesh.translate([0.5, 0.25, 0.125])).triangles
same 1e-5 mesh.clip_plane(at([0.1, 0, 0]), [1, 0, 0.2]).get_surface_area()
moved 1e-5 mesh.slice_plane(at([0.1, 0, 0]), [1, 0, 0.2], [0.0]).points
same 0 mesh.cluster_connected_triangles()[0]
same 1e-5 mesh.compute_metrics(mesh.translate([0.01, 0, 0])).chamfer
same 1e-5 mesh.compute_geodesic_distances([0])
same 1e-6 mesh.compute_triangle_areas()
same 1e-3 mesh.compute_uvatlas().triangle_uvs
moved 1e-4 mesh.deform_as_rigid_as_possible([0, 50], at(local[[0, 50]] + 0.05), 5).vertices
moved 1e-5 mesh.extrude_linear([0, 0, 1]).vertices
moved 1e-5 mesh.filter_sharpen(1, 0.5).vertices
moved 1e-5 mesh.filter_smooth_laplacian(2).vertices
moved 1e-5 mesh.filter_smooth_simple(2).vertices
moved 0 mesh.get_axis_aligned_bounding_box().get_box_points()
same 0 mesh.is_intersecting(mesh.translate([0.5, 0.25, 0.125]))
same 1e-2 mesh.remesh_isotropic(0.2).get_surface_area()
same 0 soup.repair()[0].triangles
moved 1e-5 mesh.sample_points_poisson_disk(50, seed=1).points
moved 1e-5 mesh.subdivide_midpoint(1).vertices
same 0 mesh.voxelize(0.25).coordinates
same 1e-6 scene.compute_distance(at([[0, 0, 0.5], [1, 0, 0.1]]))
same 0 scene.compute_occupancy(at([[0, 0, 0.5], [1, 0, 0.1]]))
same 0 scene.count_intersections(rays)
same 1e-6 scene.list_intersections(rays)["t_hit"]
same 0 scene.test_occlusions(rays)
moved 1e-4 volume.extract_point_cloud(weight_threshold=0).points
same 1e-4 volume.ray_cast(camera, view @ shift(-1)).depth
moved 0 loom.LineSet.create_from_triangle_mesh(mesh).points
same 0 loom.AxisAlignedBoundingBox(at([0, 0, 0]), at([2, 2, 1])).get_point_indices_within_bounding_box(cloud.points)
same 0 loom.OrientedBoundingBox(at([2, 1, 1]), turn, [2, 2, 1]).get_point_indices_within_bounding_box(cloud.points)
moved 1e-6 loom.OrientedBoundingBox.create_from_points(cloud.points).center
pose 2e-5 reg.registration_robust_based_on_correspondence(other, cloud, pairs, 0.1).transformation
same 1e-4 loom.fit_shape(ball, "sphere").radius
same 1e-3 loom.meshing.create_surface(ball).mesh.get_surface_area()
same 1e-6 loom.meshing.compare_meshes(mesh, mesh.translate([0.01, 0, 0])).metrics.hausdorff
"""  # noqa: E501


@cache
def room(seed: int, count: int) -> np.ndarray:
    """Points on the floor and two walls of a room, a box and a ball in it, [n, 3]."""
    rng = np.random.default_rng(seed)
    u, v = rng.random((2, count))
    kind, angle = np.arange(count) % 5, 2 * np.pi * u
    ball = np.c_[1 + 0.5 * np.cos(angle) * np.sin(np.pi * v), 1.8 + 0.5 * np.sin(angle) * np.sin(np.pi * v)]
    faces = [np.c_[4 * u, 3 * v, 0 * u], np.c_[4 * u, 0 * u, 2.5 * v], np.c_[0 * u, 3 * u, 2.5 * v]]
    faces += [np.c_[2 + 0.8 * u, 0.5 + 0.6 * v, 0 * u + 0.7], np.c_[ball, 0.5 + 0.5 * np.cos(np.pi * v)]]
    points = np.choose(kind[:, None], faces) + rng.normal(size=(count, 3)) * 0.002
    return np.round(points * 2**16) / 2**16


def things(offset: Any, device: Any = None, count: int = 1500) -> dict[str, Any]:
    """The names in CASES, at an offset; clouds of a number of points."""
    o = np.asarray(offset, np.float64)

    def at(points: Any) -> np.ndarray:
        return np.asarray(points, np.float64) + o

    def shift(sign: int) -> np.ndarray:
        return as_pose([0, 0, 0], sign * o)

    def about(T: np.ndarray) -> np.ndarray:
        return shift(1) @ T @ shift(-1)

    def cloud(seed: int) -> loom.PointCloud:
        points = room(seed, count)
        colors = 0.5 + 0.5 * np.sin(3 * points)
        return loom.PointCloud(at(points), colors=colors, device=device).estimate_normals(max_nn=12)

    middle = as_pose([0, 0, 0], [2, 1.5, 1])
    near = middle @ as_pose([0.002, -0.003, 0.004], [0.01, 0.005, -0.008]) @ np.linalg.inv(middle)
    start = middle @ as_pose([0.015, 0.025, 0.05], [0.05, -0.03, 0.04]) @ np.linalg.inv(middle)
    torus = loom.TriangleMesh.create_torus(1.0, 0.35, 24, 16)
    vertices = np.round(torus.vertices * 2**16) / 2**16
    directions = np.random.default_rng(3).normal(size=(1000, 3))
    directions = np.round(0.5 * directions / np.linalg.norm(directions, axis=1)[:, None] * 2**16) / 2**16
    corners = vertices[torus.triangles].reshape(-1, 3) + np.random.default_rng(4).uniform(-2e-5, 2e-5, (2304, 3))
    mesh = loom.TriangleMesh(at(vertices), torus.triangles, device=device)
    scene = loom.RaycastingScene(device)
    scene.add_triangles(mesh)
    ends = np.c_[np.linspace(-1.2, 1.2, 40), np.linspace(0.3, -0.3, 40), np.full(40, 2.0)]
    camera, depth = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), np.full((48, 64), 2.0, np.float32)
    view = as_pose([0.3, 0.1, 0], [-2, -1.5, 2.5])
    volume = loom.TSDFVolume(voxel_size=0.0625, truncation=0.25, device=device)
    volume.integrate(depth, camera, view @ shift(-1))
    target, source = cloud(0), cloud(1)
    nearest = loom.NearestNeighborSearch(target).knn_search(source.points, 1)[0].ravel()
    return {
        "at": at, "shift": shift, "about": about, "cloud": target, "other": source, "near": near, "start": start,
        "turn": as_pose([0.3, 0.4, 0.5])[:3, :3], "local": vertices,
        "mesh": mesh,
        "soup": loom.TriangleMesh(at(corners), np.arange(2304).reshape(-1, 3), device=device),
        "scene": scene, "camera": camera, "graph": graph_of(target, about),
        "rays": np.c_[at(ends), np.tile([0, 0, -1.0], (40, 1))], "depth": depth, "view": view, "volume": volume,
        "ball": loom.PointCloud(at(directions), normals=2 * directions, device=device),
        "features": [loom.compute_fpfh_feature(c, radius=0.6) for c in (source, target)],
        "pairs": np.c_[np.arange(count), nearest], "loom": loom, "reg": reg, "np": np,
    }  # fmt: skip


def graph_of(cloud: loom.PointCloud, about: Any) -> Any:
    """Three scans in world coordinates that differ by small motions, and a loop that does not quite fit."""
    motions = [as_pose([0.02, 0.01, -0.03], [0.1, 0.05, 0]), as_pose([-0.01, 0.03, 0.02], [0, -0.1, 0.05])]
    loop = as_pose([0, 0.001, 0], [0.004, 0, 0]) @ motions[1] @ motions[0]
    edges = []
    for (s, t), T in zip([(0, 1), (1, 2), (0, 2)], [*motions, loop], strict=True):
        moved = about(as_pose([0, 0, 0], [2, 1.5, 1]) @ T @ as_pose([0, 0, 0], [-2, -1.5, -1]))
        target = cloud.transform(moved)
        information = reg.get_information_matrix_from_point_clouds(target, target, 0.1, np.eye(4))
        edges.append(reg.PoseGraphEdge(s, t, moved, information, t - s > 1))
    nodes = [np.eye(4)]
    nodes += [nodes[-1] @ np.linalg.inv(edges[0].transformation)]
    nodes += [nodes[-1] @ np.linalg.inv(edges[1].transformation)]
    return reg.PoseGraph([reg.PoseGraphNode(T) for T in nodes], edges)


@pytest.fixture(scope="module")
def scenes() -> list[dict[str, Any]]:
    """The same things at each offset."""
    return [things(offset) for offset in OFFSETS]


def moved_back(kind: str, value: Any, offset: Any) -> np.ndarray:
    """A result as it is at zero."""
    if kind in ("pose", "world"):
        back = as_pose([0, 0, 0], -np.asarray(offset, np.float64)) @ value
        return back @ as_pose([0, 0, 0], offset) if kind == "pose" else back
    return np.asarray(value, np.float64) - (offset if kind == "moved" else 0)


@pytest.mark.parametrize("case", CASES.strip().splitlines())
def test_a_result_does_not_depend_on_the_offset(case, scenes):
    """At two of the offsets, other ones for each operation."""
    first = zlib.crc32(case.encode())
    compare(case, scenes, [1 + first % 4, 1 + (first + 1) % 4])


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES.strip().splitlines())
def test_a_result_does_not_depend_on_any_offset(case, scenes):
    compare(case, scenes, range(1, len(OFFSETS)))


def compare(case, scenes, places):
    kind, tolerance, operation = case.split(" ", 2)
    first, *others = (moved_back(kind, eval(operation, dict(scenes[place])), OFFSETS[place]) for place in (0, *places))
    assert np.isfinite(first).any()
    for offset, result in zip([OFFSETS[place] for place in places], others, strict=True):
        np.testing.assert_allclose(result, first, rtol=0, atol=float(tolerance), err_msg=f"at {offset}")
