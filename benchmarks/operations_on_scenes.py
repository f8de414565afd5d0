"""Records of the operations on other scenes than one cloud. digests.py runs each of them once."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import scenes
from bench_pose_graph import DISTANCE
from digest_depth_maps import estimated_depth_maps, pair_depth_maps, plain_depth_maps
from digest_drawing import DRAWN
from digest_fields import FIELDS
from digest_files import WRITTEN
from digest_mvs import filtered_depth_maps, fused_depth_maps
from digest_occupancy import OCCUPANCY
from digest_scenes import ROTATED, UTM, SampledSurface, Scenes, about, loom, pose_of, reg
from digest_shapes import SHAPES
from digest_stations import surveyed
from digest_volumes import VOLUMES
from numpy.typing import NDArray
from operation import Operation, records
from operations_on_clouds import SIZE, cloud_file, depth_lens, icp, there_and_back


def dlpack_cloud(d: Scenes) -> Any:
    points = scenes.bumpy_surface(500, 80).astype(np.float32)
    return loom().PointCloud.from_dlpack(points, normals=points.copy(), origin=UTM, label=np.arange(500))


def projected(d: Scenes) -> Any:
    """Geographic coordinates projected to meters, and their zone."""
    cloud = loom().PointCloud(scenes.bumpy_surface(500, 80) * [0.01, 0.01, 1.0] + [9.18, 48.77, 240.0])
    from pointloom.pcd.geographic import utm_epsg

    return [loom().project_to_utm(cloud), utm_epsg(cloud)]


def moved_boxes(p: SampledSurface) -> list[Any]:
    """Boxes of points: moved, rotated, scaled and joined."""
    aligned, oriented, points = loom().AxisAlignedBoundingBox, loom().OrientedBoundingBox, p.cloud.points[:200]
    boxes = [aligned.create_from_points(points), oriented.create_from_points(points)]
    boxes += [
        oriented.create_from_points(points, robust=True),
        oriented.create_from_points_minimal(points),
        p.rotated_box,
    ]
    moved = [box.translate([1, 2, 3]).scale(1.5, p.middle).rotate(p.pose[:3, :3]) for box in boxes]
    measures = [(box.volume(), box.get_box_points(), box.get_center(), box.get_extent()) for box in boxes + moved]
    return [boxes, moved, measures, boxes[0] + p.box, [box.get_axis_aligned_bounding_box() for box in moved]]


def estimated(d: Scenes) -> Any:
    """A depth estimate that returns the camera's measurement."""
    depth = loom().RGBDImage(d.paint, d.frames.depths[0]).depth
    size = depth.shape
    from pointloom.photogrammetry.depth.estimation import DepthEstimate

    return DepthEstimate(depth, True, 1.0, 0.0, None, "none", "m", d.paint, d.lens, "given", size, 1.5)


def polygon_file(p: SampledSurface) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "polygon.json"
        p.polygon.to_json(path)
        return loom().SelectionPolygonVolume.from_json(path)


def panorama_faces(d: Scenes) -> list[Any]:
    sphere = np.random.default_rng(5).integers(0, 256, (48, 96, 3), dtype=np.uint8)
    return [loom().Panorama(96, 48, side=side, device=d.device).apply(sphere) for side in (None, 20)]


def undistorted_paint(d: Scenes) -> list[Any]:
    """An image undistorted with each lens model, at its size and smaller."""
    height, width = d.paint.shape[:2]
    middle = [width / 2 + 3.0, height / 2 - 2.0]
    lenses = [
        ("FULL_OPENCV", [width, width, *middle, 0.1, -0.05, 1e-3, -2e-3, 0.02, 0.15, -0.02, 0.01]),
        ("THIN_PRISM_FISHEYE", [width / 2, width / 2, *middle, 0.02, -0.01, 1e-3, -2e-3, 3e-3, -1e-3, 1e-3, -1e-3]),
        ("FOV", [width, width, *middle, 0.9]),
        ("DIVISION", [width, width, *middle, -0.2]),
        ("EUCM", [width, width, *middle, 0.6, 1.1]),
    ]
    cameras = [loom().CameraModel(name, width, height, params) for name, params in lenses]
    sizes = ({"blank_fraction": 0.5}, {"max_size": width // 3})
    return [loom().undistort_image(d.paint, camera, device=d.device, **size)[0] for camera in cameras for size in sizes]


def picked(p: SampledSurface) -> list[Any]:
    """Picked points for clicks on an image, and the points inside a polygon."""
    from pointloom.visualization.render.view import fit_view
    from pointloom.visualization.viewer.tools.clip_planes import Clip, hidden_points
    from pointloom.visualization.viewer.tools.picking import Target, pick
    from pointloom.visualization.viewer.tools.polygon_crop import seen_inside

    view = fit_view(p.cloud.points, width=320, height=240)
    hidden = hidden_points(p.cloud, Clip(low=p.cloud.get_center() - [np.inf, 0.0, np.inf]))
    clicks = [(float(x), float(y)) for x in range(10, 320, 25) for y in range(10, 240, 25)]
    targets = [Target("cloud", p.cloud, hidden=marks) for marks in (None, hidden)]
    hits = [pick([target], view, x, y) for x, y in clicks for target in targets]
    inside = seen_inside(p.cloud, view, [[40, 30], [300, 60], [170, 110], [250, 220], [60, 200]])
    return [np.array([-1 if hit is None else hit.index for hit in hits]), inside]


def las_chunks(p: SampledSurface) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cloud.las"
        loom().write_point_cloud(path, p.cloud)
        return list(loom().read_las_chunks(path, 3000))


def copc_window(p: SampledSurface) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cloud.copc.laz"
        loom().write_point_cloud(path, p.cloud, scale=1e-4)
        low, high = p.cloud.get_axis_aligned_bounding_box()
        window = loom().AxisAlignedBoundingBox(low, (low + high) / 2)
        return [loom().read_copc(path, within=window), loom().read_copc(path, spacing=float((high - low).max()) / 50)]


def mesh_file(mesh: Any, ending: str, **options: Any) -> Any:
    return there_and_back(mesh, ending, "write_triangle_mesh", "read_triangle_mesh", **options)


def tracked_frames(d: Any) -> Any:
    """Trajectory and surface of a moving camera that is covered and then relocalized."""
    from types import SimpleNamespace

    from room_loops import room_loop_sequence

    room = room_loop_sequence(300, width=80, height=60, covered=(5, 6))
    slam = loom().rgbd.DenseSLAM(room.intrinsic, voxel_size=0.04, submap_frames=4, device=d.device)
    for k in range(10):
        frame = room.read(k)
        slam.step(SimpleNamespace(depth=frame.depth, color=frame.color, timestamp=frame.timestamp))
    path = slam.trajectory.poses
    slam.close_loops()
    return [path, slam.trajectory.poses, slam.extract_triangle_mesh(0)]


def filmed_room(d: Any) -> Any:
    """An image of the textured room with sensor noise, and its depth."""
    from pointloom.datasets.scenes.room import film_pose, room_views

    camera = loom().PinholeCameraIntrinsic(80, 60, 65.625, 65.625, 39.5, 29.5)
    poses = np.array([film_pose(k / 30) for k in range(30)])
    frame = room_views(poses, camera, seed=1, device=d.device).read(7)
    return [frame.color, frame.depth]


def painted_plane(d: Any) -> Any:
    mesh = loom().TriangleMesh.create_plane(create_uv_map=True, device=d.device)
    mesh.vertex_colors = np.eye(4, 3)
    return mesh


def written_mesh(mesh: Any, ending: str) -> NDArray[np.uint8]:
    """The bytes of a file in a write-only format."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"mesh{ending}"
        loom().write_triangle_mesh(path, mesh)
        return np.fromfile(path, np.uint8)


def volume_file(d: Scenes) -> list[Any]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "volume.npz"
        d.volume.save(path)
        again = loom().TSDFVolume.load(path, device=d.device)
    return [again.block_count, again.frame_count, again.extract_triangle_mesh(0), again.extract_point_cloud(1)]


def scanned_volume(d: Scenes) -> list[Any]:
    """A far wall behind a post, then the wall alone from another position: the post is carved."""
    rng = np.random.default_rng(5)
    wall = np.column_stack([np.full(900, 4.0), rng.uniform(-1, 1, (900, 2))])
    volume = loom().TSDFVolume(voxel_size=0.08, device=d.device)
    touched = []
    for k, points in enumerate((np.vstack([wall, wall[::3] * 0.5]), wall, wall)):
        cloud = loom().PointCloud(points + UTM, colors=rng.random((len(points), 3)), device=d.device)
        touched.append(volume.integrate_points(cloud, np.add(UTM, [0.01 * k, 0.02, 0.03])))
    return [touched, volume.extract_triangle_mesh(0), volume.extract_point_cloud(1)]


def crowded_ball(d: Scenes) -> Any:
    """A ball with extra faces at its edges, duplicates and folded triangles."""
    triangles = d.ball.triangles
    pages = np.column_stack([triangles[::7, :2], np.roll(triangles[:, 2], -3)[::7]])
    rows = np.vstack([triangles, pages, triangles[::5, [1, 2, 0]], triangles[::9, [0, 0, 1]]])
    return loom().TriangleMesh(d.ball.vertices, rows, device=d.device)


def mesh_cleaned(d: Scenes) -> list[Any]:
    mesh = crowded_ball(d)
    names = ("degenerate_triangles", "duplicated_triangles", "duplicated_vertices", "non_manifold_edges")
    cleaned = [getattr(mesh, f"remove_{name}")() for name in names]
    rows = np.arange(0, len(mesh.vertices), 2)[::-1]
    return [*cleaned, *(mesh.merge_close_vertices(eps) for eps in (0.02, 0.2)), mesh.select_by_index(rows)]


def two_sided_ball(d: Scenes) -> Any:
    """A two-sided ball with a fin, and another ball that touches it at a vertex."""
    vertices, triangles = d.ball.vertices, d.ball.triangles
    count, fin = len(vertices), [[*triangles[9][:2], 2 * len(vertices)]]
    shift = vertices[0] - vertices[-1]
    return (
        loom()
        .TriangleMesh(
            np.concatenate([vertices, vertices + shift, 2 * vertices[:1]]),
            np.concatenate([triangles, triangles[:, ::-1], fin, triangles + count]),
            device=d.device,
        )
        .remove_duplicated_vertices()
    )


def loose_ball(d: Scenes) -> Any:
    """A ball of triangles that share no vertex."""
    corners = d.ball.vertices[d.ball.triangles].reshape(-1, 3)
    return loom().TriangleMesh(corners, np.arange(len(corners)).reshape(-1, 3), device=d.device)


def torn_ball(d: Scenes) -> Any:
    """A ball without two caps, with some triangles flipped."""
    middles = d.ball.vertices[d.ball.triangles].mean(axis=1)
    low, high = np.quantile(middles[:, 2], [0.02, 0.97])
    triangles = d.ball.triangles.copy()
    triangles[::4] = triangles[::4, ::-1]
    remaining = triangles[(middles[:, 2] > low) & (middles[:, 2] < high)]
    return loom().TriangleMesh(d.ball.vertices, remaining, device=d.device)


def mesh_topology(d: Scenes) -> list[Any]:
    mesh, torn = crowded_ball(d), torn_ball(d).orient_triangles(outward=True)[0]
    edges = [mesh.get_non_manifold_edges(), mesh.get_boundary_edges(), mesh.get_non_manifold_vertices()]
    return [*edges, *mesh.compute_adjacency_list(), torn, *torn.get_boundaries(), torn.compute_triangle_areas()]


def mesh_measures(mesh: Any) -> list[Any]:
    closed = [mesh.is_edge_manifold(), mesh.is_edge_manifold(allow_boundary_edges=False), mesh.is_watertight()]
    return [mesh.get_surface_area(), *closed, mesh.compute_triangle_normals(), *mesh.get_axis_aligned_bounding_box()]


def some_triangles(d: Scenes) -> Any:
    mesh = loom().TriangleMesh(d.ball.vertices, d.ball.triangles[::5], device=d.device)
    return mesh.remove_unreferenced_vertices()


def textured_ball(d: Scenes) -> Any:
    """The ball with normals and colors."""
    mesh = d.ball.compute_vertex_normals()
    mesh.vertex_colors = np.abs(mesh.vertex_normals)
    return mesh


def posed_images(d: Scenes) -> tuple[Any, Any, NDArray[np.float64]]:
    """A grid in front of a camera, images of it from three positions, and their poses."""
    camera = loom().PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.2, 23.7)
    v, u = np.mgrid[:48, :64]
    poses, images = np.tile(np.eye(4), (3, 1, 1)), []
    for k, pose in enumerate(poses):
        pose[:2, 3] = 0.02 * k, -0.01 * k
        shade = 127 + 60 * np.sin((u + 1.3 * k) / 5) + 60 * np.cos((v + k) / 7)
        images.append(np.stack([shade, shade / 2, 255 - shade], -1).astype(np.uint8))
    return camera, images, poses


def imaged_grid(d: Scenes) -> Any:
    """A square grid 1 m in front of the first camera, with texture coordinates."""
    j, i = np.mgrid[:21, :21]
    uvs, at = np.stack([i, j], -1).reshape(-1, 2) / 20, (j * 21 + i)[:-1, :-1].ravel()
    triangles = np.concatenate([np.stack([at, at + 21, at + 1], 1), np.stack([at + 1, at + 21, at + 22], 1)])
    vertices = np.column_stack([0.8 * uvs - 0.4, np.ones(len(uvs)) + 0.01 * np.sin(9 * uvs[:, 0])])
    return loom().TriangleMesh(vertices, triangles, triangle_uvs=uvs[triangles].reshape(-1, 2), device=d.device)


def color_maps(d: Scenes) -> list[Any]:
    """Color maps in both forms, by rays and by depth."""
    camera, images, poses = posed_images(d)
    maps, mesh, path = loom().meshing, imaged_grid(d), loom().Trajectory(poses)
    rigid = maps.ColorMapOption(maximum_iteration=5, image_boundary_margin=2)
    bent = maps.ColorMapOption(maximum_iteration=5, image_boundary_margin=2, number_of_vertical_anchors=4)
    depth = np.ones((48, 64), np.float32)
    frames = [loom().RGBDImage(image, depth, device=d.device) for image in images]
    results = [maps.optimize_color_map(mesh, images, path, rigid, intrinsic=camera)]
    results.append(maps.optimize_color_map(mesh, frames, path, bent, intrinsic=camera, method="non-rigid"))
    return [[r.mesh.vertex_colors, r.trajectory.poses, r.seen, r.warp(1), r.unwarped_image(2)] for r in results]


def rgbd_odometry(d: Scenes) -> list[Any]:
    """Frames of a relief with small motion: by all methods, and with Open3D's weights."""
    odometry, (v, u) = loom().rgbd, np.mgrid[:72, :96]
    camera = loom().PinholeCameraIntrinsic(96, 72, 90.0, 90.0, 47.5, 35.5)
    pairs = []
    for k in range(2):
        depth = 1.5 + 0.2 * np.sin((u + k) / 13) * np.cos(v / 11) + 0.1 * np.sin((v - k) / 7)
        shade = 127 + 60 * np.sin((u + k) / 3 + v / 9) + 50 * np.cos(v / 4 - (u + k) / 17)
        pairs.append((shade.astype(np.uint8), depth.astype(np.float32)))
    frames = [odometry.OdometryFrame(depth, camera, shade, device=d.device) for shade, depth in pairs]
    results = [odometry.align_frames(*frames, method=method) for method in ("point-to-plane", "intensity", "hybrid")]
    images = [loom().RGBDImage(*pair, device=d.device) for pair in pairs]
    from pointloom.rgbd.odometry import options
    from pointloom.rgbd.odometry import rgbd_odometry as internal

    legacy = options.RGBDOdometryJacobianFromHybridTerm(), options.OdometryOption()
    results.append(internal.open3d_odometry(*images, camera, np.eye(4), *legacy))
    results += [
        internal.open3d_multi_scale_odometry(*images, camera.matrix, np.eye(4), 3.0, None, method, None)
        for method in options.OdometryMethod
    ]
    depths = [depth for _, depth in pairs]
    information = odometry.compute_odometry_information_matrix(*depths, camera, np.eye(4), 0.07)
    return [information] + [[r.transformation, r.information, r.inliers, r.reliable] for r in results]


def albedo(d: Scenes) -> Any:
    camera, images, poses = posed_images(d)
    textured = imaged_grid(d).project_images_to_albedo(images, camera, [scenes.inverse(pose) for pose in poses], 64)
    return textured.textures[0]


def image_texture(d: Scenes) -> list[Any]:
    """The grid's texture from its images, with individual exposures."""
    camera, images, poses = posed_images(d)
    exposed = [(image * gain).astype(np.uint8) for image, gain in zip(images, (0.9, 1.0, 0.8), strict=True)]
    given = (imaged_grid(d), exposed, camera, [scenes.inverse(pose) for pose in poses])
    result = loom().meshing.texture_from_images(*given, loom().meshing.ImageTextureOption(smoothness=0.2))
    return [result.mesh.textures[0], result.mesh.triangle_uvs, result.views, result.energy, result.step_before]


def cast_rays(d: Scenes) -> list[Any]:
    """Hits of rays on the ball in two poses."""
    scene, rng = loom().RaycastingScene(d.device), np.random.default_rng(0)
    scene.add_instance(scene.add_triangles(d.ball), pose_of(30.0, [0.1, 0.0, 0.2]))
    low, high = d.ball.get_axis_aligned_bounding_box()
    rays = np.hstack([rng.uniform(low, high, (2000, 3)), rng.normal(size=(2000, 3))])
    queries = (scene.cast_rays, scene.test_occlusions, scene.count_intersections, scene.list_intersections)
    return [query(rays) for query in queries]


def scene_distances(d: Scenes) -> list[Any]:
    """Closest points and signed distances, by pseudonormals and by winding numbers."""
    low, high = d.ball.get_axis_aligned_bounding_box()
    queries = np.random.default_rng(1).uniform(low, high, (2000, 3))
    one, open_one = loom().RaycastingScene(d.device), loom().RaycastingScene(d.device)
    one.add_triangles(d.ball)
    open_one.add_triangles(some_triangles(d))
    signed = [one.compute_signed_distance(queries), open_one.compute_signed_distance(queries)]
    cloud, open_mesh = loom().PointCloud(queries, device=d.device), some_triangles(d)
    signed += [loom().meshing.compare_cloud_to_mesh(cloud, open_mesh, radius=radius) for radius in (None, 0.5)]
    return [one.compute_closest_points(queries), *signed, one.compute_occupancy(queries)]


def meeting_triangles(d: Scenes) -> list[Any]:
    """Self-intersections of the ball and a copy in one mesh."""
    shifted = d.ball.vertices + 0.3 * np.ptp(d.ball.vertices, axis=0)
    both = np.vstack([d.ball.vertices, shifted]), np.vstack([d.ball.triangles, d.ball.triangles + len(shifted)])
    mesh = loom().TriangleMesh(*both, device=d.device)
    return [mesh.get_self_intersecting_triangles(), d.ball.is_self_intersecting()]


def surface_metrics(d: Scenes) -> list[Any]:
    """Metrics of the ball against a part of it."""
    part = some_triangles(d)
    return [*d.ball.compute_metrics(part, [0.05], 2000), *d.ball.compute_error_map(part)]


def robust_kernels(scale: float = 0.02) -> dict[str, Any]:
    names = ("Huber", "Cauchy", "GM", "Tukey", "Generalized")
    kernels = {name: getattr(reg(), f"{name}Loss")(scale) for name in names}
    general = {f"Generalized {shape}": reg().GeneralizedLoss(scale, shape) for shape in (2.0, 0.0, -2.0, -np.inf)}
    return kernels | general | {"L1": reg().L1Loss(), "L2": reg().L2Loss()}


def icp_with(p: SampledSurface, method: str = "PointToPlane", **options: Any) -> Any:
    """ICP with the given options."""
    estimation = getattr(reg(), f"TransformationEstimation{method}")()
    return reg().registration_icp(p.source, p.facing, p.max_distance, None, estimation, **options)


def icp_fixed(p: SampledSurface) -> list[Any]:
    """ICP with some free motions, with a prior on the motions that a plane does not constrain, with scaling, and in
    a batch.
    """
    rotation = np.array([[0.8, -0.6, 0.0, 0.02], [0.6, 0.8, 0.0, 0.01], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
    known = reg().Prior(rotation, sigma_translation=0.1, sigma_rotation=0.5)
    level, scaled = ("x", "y", "z", "yaw"), reg().TransformationEstimationPointToPoint(True)
    weights = np.linspace(0, 1, len(p.source))
    return [
        icp_with(
            p, constraint=reg().Constraint(free=level, frame=rotation[:3, :3], pivot=(0.0, 0.1, 0.2)), weights=weights
        ),
        icp_with(p, constraint=reg().Constraint(prior=known)),
        reg().registration_icp(
            p.source,
            p.facing,
            p.max_distance,
            None,
            scaled,
            constraint=reg().Constraint(free=("roll", "pitch", "yaw", "x"), prior=known),
        ),
        reg().registration_icp_batch(
            p.source,
            p.facing,
            p.max_distance,
            np.stack([np.eye(4)] * 2),
            constraint=reg().Constraint(free=level, prior=known),
        ),
    ]


def icp_watched(p: SampledSurface) -> list[Any]:
    """The states passed to a callback, and the result."""
    states: list[Any] = []
    return [icp_with(p, callback_after_iteration=lambda state: states.append(dict(state))), states]


def multi_scale(p: SampledSurface) -> list[Any]:
    """Multi-scale ICP, with the states passed to a callback."""
    states: list[Any] = []
    rules = [reg().ICPConvergenceCriteria(1e-4, 1e-4, 10), reg().ICPConvergenceCriteria(max_iteration=20)]
    plane, sizes = reg().TransformationEstimationPointToPlane(), [4 * p.spacing, -1]
    clouds, distances = (p.source, p.facing), [2 * p.max_distance, p.max_distance]
    watch: dict[str, Any] = {"callback_after_iteration": lambda state: states.append(dict(state))}
    return [reg().multi_scale_icp(*clouds, sizes, rules, distances, None, plane, **watch), states]


def doppler(d: Scenes, **options: Any) -> Any:
    method = reg().TransformationEstimationForDopplerICP(**options)
    return reg().registration_icp(*d.doppler, 1.5, None, method)


def icp_batch(d: Scenes, method: str) -> list[Any]:
    estimation = getattr(reg(), f"TransformationEstimation{method}")()
    return reg().registration_icp_batch(*d.patches, 0.15, None, estimation, degeneracy=0)


def checkers() -> list[Any]:
    return [
        reg().CorrespondenceCheckerBasedOnEdgeLength(0.9),
        reg().CorrespondenceCheckerBasedOnDistance(0.12),
        reg().CorrespondenceCheckerBasedOnNormal(0.7),
        reg().CorrespondenceCheckerBasedOnSourceRotation([3.2, 3.2, 3.2]),
    ]


def checked(d: Scenes) -> list[bool]:
    """The result of each checker on some samples."""
    samples = [d.matches[3 * k : 3 * k + 3] for k in range(20)]
    return [one.Check(*d.thinned, sample, ROTATED) for one in checkers() for sample in samples]


def ransac(d: Scenes, **options: Any) -> Any:
    return reg().registration_ransac_based_on_correspondence(
        *d.thinned, d.matches, 0.1, num_iterations=20_000, **options
    )


def ransac_features(d: Scenes, mutual: bool) -> Any:
    pairs = reg().correspondences_from_features(*d.features, mutual)
    call = reg().registration_ransac_based_on_correspondence
    return call(*d.thinned, pairs, 0.1, checkers=checkers()[:3], num_iterations=20_000, seed=2)


def fast_global(d: Scenes, **options: Any) -> list[Any]:
    """Fast global registration from features and from given pairs."""
    option = reg().FastGlobalRegistrationOption(maximum_correspondence_distance=0.1, **options)
    call = reg().registration_fgr_based_on_correspondence
    pairs = reg().correspondences_from_features(*d.features, True, 0.0)
    return [call(*d.thinned, pairs, option), call(*d.thinned, d.matches, option, seed=4)]


def robust_global(d: Scenes) -> list[Any]:
    call, match = reg().registration_robust_based_on_correspondence, reg().correspondences_from_features
    pairs = [match(*d.features, mutual, 0.0) for mutual in (True, False)]
    return [*(call(*d.thinned, each, 0.06) for each in pairs), call(*d.thinned, d.matches, 0.08, seed=6)]


def halved_color(d: Scenes) -> Any:
    from pointloom.cameras.depth_filters import pyrdown_color

    return pyrdown_color(d.paint, device=d.device)


def steps_of_odometry(d: Scenes) -> list[Any]:
    steps: list[Any] = []
    reg().run_odometry(d.scans[:3], progress=steps.append, device=d.device, voxel_size=2.0)
    return steps


def optimized(d: Scenes, method: str, **options: Any) -> Any:
    return reg().global_optimization(d.graph, method, option=reg().GlobalOptimizationOption(DISTANCE, **options))


def graph_file(d: Scenes) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "graph.json"
        reg().write_pose_graph(path, d.graph)
        return reg().read_pose_graph(path)


def bent(d: Scenes) -> list[Any]:
    """A down-sampled room registered non-rigidly to the other one, and the deformation applied to points and
    volumes.
    """
    result = reg().register_nonrigid(
        *d.thinned, node_spacing=0.6, init=np.eye(4), stiffness=[10.0, 1.0], max_iterations=3
    )
    T, points = result.deformation, d.thinned[0].points[:50]
    return [result.warped, result.correspondences, result.residuals, T.transform(points), T.volumes(points)]


def drifted(d: Scenes) -> list[Any]:
    """A part of a room registered to the other one by coherent point drift, of each kind."""
    source, target = (cloud.select_by_index(np.arange(0, len(cloud), len(cloud) // 80)) for cloud in d.thinned)
    results = [
        reg().coherent_point_drift(source, target, kind=kind, max_iterations=8)
        for kind in ("rigid", "affine", "deformable")
    ]
    return [[one.warped, one.transformation, one.deviation, one.matched] for one in results]


def reconstructed(d: Scenes) -> list[Any]:
    """Trajectory and model of five small frames in two fragments; rigid, and deformed by SLAC."""
    from bench_reconstruction import Decoded, first_frames

    names = {"n_frames_per_fragment": 3, "tsdf_voxel_size": 0.03, "fragment_voxel_size": 0.02, "depth_max": 4.0}
    config, source = loom().rgbd.ReconstructionConfig(**names), Decoded(first_frames(5, 3, 80)["frames"])
    results: list[Any] = []
    with tempfile.TemporaryDirectory() as folder:
        for stages in (("refine", "integrate"), ("refine", "slac", "integrate")):
            how = {"stages": stages, "resume": "slac" in stages, "device": d.device}
            loom().rgbd.run_reconstruction_system(source, config, folder, **how)
            path = loom().read_trajectory(Path(folder) / "scene" / "trajectory.log")
            results += [path.poses, loom().read_triangle_mesh(Path(folder) / "scene" / "integrated.ply")]
        return results


def registered_fragments(d: Scenes) -> list[Any]:
    result = reg().register_multiway(d.fragments, voxel_size=0.1)
    return [result, *result.pose_covariances(d.fragments)]


def aligned_fragments(d: Scenes) -> list[Any]:
    """Fragments aligned together, rigid and deformed."""
    rec, count = loom().rgbd, len(d.fragments)
    poses = [scenes.inverse(pose_of(50.0 * k + 0.2, [k + 0.01, 0.2, 0])) for k in range(count)]
    edges = [
        (i, j, scenes.product(scenes.inverse(poses[j]), poses[i]))
        for i in range(count)
        for j in range(i + 1, min(i + 3, count))
    ]
    graph = reg().PoseGraph([reg().PoseGraphNode(T) for T in poses], [reg().PoseGraphEdge(*edge) for edge in edges])
    params = rec.SLACOptimizerParams(max_iterations=2, voxel_size=0.1, distance_threshold=0.15)
    solved, grid = rec.run_slac_optimizer_for_fragments(d.fragments, graph, params)
    bent = grid.deform(d.fragments[0])
    return [solved, grid.get_curr_positions(), bent, rec.run_rigid_optimizer_for_fragments(d.fragments, graph, params)]


def odometry(d: Scenes, **options: Any) -> list[Any]:
    run = reg().LidarOdometry(voxel_size=1.0, device=d.device, **options)
    for scan in d.scans:
        run.register(scan)
    return [run.poses, run.map, run.steps, run.summary]


CALLS: dict[str, Callable[[Scenes], Any]] = {
    "from_dlpack": dlpack_cloud,
    "project_to_utm": projected,
    "boxes moved": lambda d: moved_boxes(d.surface),
    "boxes moved, far": lambda d: moved_boxes(d.far),
    "polygon to and from JSON": lambda d: polygon_file(d.far),
    "points picked": lambda d: picked(d.surface),
    "points picked, far": lambda d: picked(d.far),
    "write and read .ply, ascii": lambda d: cloud_file(d.far.facing, ".ply", write_ascii=True),
    "write and read .pcd": lambda d: cloud_file(d.dirty.facing, ".pcd"),
    "write and read .pcd, ascii": lambda d: cloud_file(d.far.facing, ".pcd", write_ascii=True),
    "write and read .xyz": lambda d: cloud_file(d.cloud(d.far.cloud.points), ".xyz"),
    "write and read .las": lambda d: cloud_file(d.far.cloud, ".las"),
    "write and read .laz": lambda d: cloud_file(d.far.cloud, ".laz", scale=1e-4),
    "write and read .e57": lambda d: cloud_file(d.cloud(d.far.cloud.points, colors=d.far.cloud.colors), ".e57"),
    "write and read_copc": lambda d: copc_window(d.far),
    "read_las_chunks": lambda d: las_chunks(d.far),
    "create_from_depth_image": lambda d: loom().PointCloud.create_from_depth_image(
        d.frames.depths[0], d.lens, device=d.device
    ),
    "create_from_depth_image, normals": lambda d: loom().PointCloud.create_from_depth_image(
        d.frames.depths[1], d.lens, d.extrinsics(UTM)[1], depth_trunc=3.0, with_normals=True, device=d.device
    ),
    "create_from_depth_image, stride": lambda d: loom().PointCloud.create_from_depth_image(
        d.frames.depths[2] / 1000, d.lens, stride=3, project_valid_depth_only=False, with_normals=True, device=d.device
    ),
    "create_from_rgbd_image": lambda d: loom().PointCloud.create_from_rgbd_image(d.rgbd, d.lens, d.extrinsics()[0]),
    "create_from_rgbd_image, normals": lambda d: loom().PointCloud.create_from_rgbd_image(
        d.rgbd, d.lens, project_valid_depth_only=False, stride=2, with_normals=True
    ),
    "RGBDImage": lambda d: d.rgbd,
    "RGBDImage, formats": lambda d: [
        getattr(loom().RGBDImage, name)(d.paint, d.frames.depths[0], device=d.device)
        for name in ("create_from_color_and_depth", "create_from_redwood_format", "create_from_tum_format")
    ],
    "RGBDImage, raw formats": lambda d: [
        getattr(loom().RGBDImage, name)(d.paint, d.frames.depths[0], convert_rgb_to_intensity=False, device=d.device)
        for name in ("create_from_sun_format", "create_from_nyu_format")
    ],
    "project_to_rgbd_image": lambda d: d.surface.cloud.project_to_rgbd_image(
        *SIZE, depth_lens(d.surface), d.surface.camera, depth_max=9.0
    ),
    "filter_depth_bilateral": lambda d: loom().filter_depth_bilateral(d.frames.depths[0], 7, device=d.device),
    "erode_depth_edges": lambda d: loom().erode_depth_edges(d.rgbd, 2, 0.05),
    "fill_depth_holes": lambda d: loom().fill_depth_holes(d.frames.depths[0], 50, device=d.device)[0],
    "DepthEstimate, to_point_cloud": lambda d: estimated(d).to_point_cloud(device=d.device),
    "create_normal_map": lambda d: loom().create_normal_map(d.rgbd, d.lens, -1.0),
    "pyrdown_depth": lambda d: loom().create_depth_pyramid(d.frames.depths[3], 2, device=d.device)[1],
    "pyrdown_color": lambda d: halved_color(d),
    "undistort_image": undistorted_paint,
    "panorama": panorama_faces,
    "create_depth_pyramid": lambda d: loom().create_depth_pyramid(d.rgbd, 3),
    "tsdf, integrate": lambda d: d.fuse()[1],
    "tsdf, integrate_frames": lambda d: d.fuse_together()[1],
    "tsdf, integrate, far": lambda d: d.fuse(UTM, color=False)[1],
    "tsdf, extract_triangle_mesh": lambda d: [d.volume.extract_triangle_mesh(w) for w in (0.0, 2.0)],
    "tsdf, extract_triangle_mesh, far": lambda d: d.far_volume.extract_triangle_mesh(0),
    "tsdf, extract_point_cloud": lambda d: [d.volume.extract_point_cloud(w) for w in (0.0, 2.0)],
    "tsdf, extract_point_cloud, far": lambda d: d.far_volume.extract_point_cloud(0),
    "tsdf, ray_cast": lambda d: d.volume.ray_cast(d.lens, d.extrinsics()[1], depth_max=6.0, weight_threshold=0),
    "tsdf, ray_cast, far": lambda d: d.far_volume.ray_cast(
        d.lens, d.extrinsics(UTM)[2], depth_max=6.0, weight_threshold=1
    ),
    "slam, DenseSLAM": tracked_frames,
    "mvs, estimate_depth_maps": estimated_depth_maps,
    "mvs, estimate_depth_maps, pair": pair_depth_maps,
    "mvs, estimate_depth_maps, plain wall": plain_depth_maps,
    "room, film": filmed_room,
    "mvs, filter_depth_maps": filtered_depth_maps,
    "mvs, fuse": fused_depth_maps,
    "tsdf, integrate_points": scanned_volume,
    "tsdf, fuse_volumes": lambda d: (
        loom().meshing.fuse_volumes([d.volume] * 2, [np.eye(4), d.extrinsics()[1]]).extract_triangle_mesh(0)
    ),
    "tsdf, save and load": volume_file,
    "marching_cubes": lambda d: d.ball,
    "marching_cubes, level": lambda d: loom().meshing.marching_cubes(
        scenes.wavy_ball(24)[:, :20], 0.1, spacing=[0.1, 0.2, 0.3], origin=UTM, device=d.device
    ),
    "mesh, compute_vertex_normals": lambda d: d.ball.compute_vertex_normals(),
    "mesh, measures": lambda d: [mesh_measures(mesh) for mesh in (d.ball, d.volume.extract_triangle_mesh(0))],
    "rays, all queries": cast_rays,
    "scene, closest points and signs": scene_distances,
    "mesh, triangles that meet": meeting_triangles,
    "mesh, metrics and error map": surface_metrics,
    "mesh, get_volume": lambda d: d.ball.get_volume(),
    "mesh, transform": lambda d: d.ball.compute_vertex_normals().transform(about(UTM, pose_of(30.0, UTM))),
    "mesh, remove_unreferenced_vertices": some_triangles,
    "mesh, sample_points_uniformly": lambda d: [
        textured_ball(d).sample_points_uniformly(2000, triangles, seed) for triangles, seed in ((False, 0), (True, 5))
    ],
    "mesh, sample_points_poisson_disk": lambda d: [
        textured_ball(d).sample_points_poisson_disk(700, seed=2),
        d.ball.sample_points_poisson_disk(300, pcl=d.ball.sample_points_uniformly(4000)),
    ],
    "mesh, shapes": lambda d: [
        loom().TriangleMesh.create_coordinate_frame(device=d.device),
        loom().TriangleMesh.create_torus(device=d.device),
    ],
    "mesh, voxelize": lambda d: [
        grid.coordinates
        for grid in (d.ball.voxelize(0.1), loom().TriangleMesh.create_torus(device=d.device).voxelize(0.07, solid=True))
    ],
    "mesh, bake_vertex_colors": lambda d: [painted_plane(d).bake_vertex_colors(100).textures[0]],
    "mesh, textured files": lambda d: [
        mesh_file(painted_plane(d).bake_vertex_colors(16), ending) for ending in (".obj", ".ply", ".glb")
    ],
    "mesh, remove by mask": lambda d: [
        textured_ball(d).remove_vertices_by_mask(d.ball.vertices[:, 0] > 0),
        d.ball.remove_triangles_by_mask(np.arange(len(d.ball)) % 3 == 0),
    ],
    "mesh, cleaned": mesh_cleaned,
    "mesh, topology": mesh_topology,
    "mesh, repair": lambda d: [torn_ball(d).fill_holes(), torn_ball(d).repair(hole_size=0.5, merge_distance=0.01)[0]],
    "mesh, sheets": lambda d: [two_sided_ball(d).repair()[0], two_sided_ball(d).split_non_manifold_vertices()],
    "mesh, seams": lambda d: [
        loose_ball(d).filter_smooth_taubin(2),
        loose_ball(d).subdivide_loop(),
        loose_ball(d).deform_as_rigid_as_possible([0], [[0, 0, 2]], 2),
    ],
    "mesh, cluster_connected_triangles": lambda d: list(some_triangles(d).cluster_connected_triangles()),
    "mesh, remove_small_components": lambda d: some_triangles(d).remove_small_components(min_triangles=2),
    "mesh, create_from_point_cloud_poisson": lambda d: [
        loom().TriangleMesh.create_from_point_cloud_poisson(
            textured_ball(d).sample_points_uniformly(count, True), depth, scale=scale, linear_fit=depth == 5
        )
        for count, depth, scale in ((4000, 6, 1.1), (300, 9, 1.5), (1000, 5, 1.0))
    ],
    "mesh, simplify_quadric_decimation": lambda d: [textured_ball(d).simplify_quadric_decimation(n) for n in (300, 51)],
    "mesh, simplify_vertex_clustering": lambda d: [
        textured_ball(d).simplify_vertex_clustering(0.1, way) for way in ("average", "quadric")
    ],
    "mesh, trim": lambda d: [textured_ball(d).trim(d.ball.vertices[:, 0] ** 2, 0.1, island_ratio=r) for r in (0, 0.3)],
    "mesh, filters": lambda d: [
        textured_ball(d).filter_smooth_simple(2),
        textured_ball(d).filter_smooth_laplacian(2, 0.6, "normal"),
        textured_ball(d).filter_smooth_taubin(3),
        textured_ball(d).filter_sharpen(1, 0.1, "color"),
    ],
    "mesh, clip_plane": lambda d: [
        textured_ball(d).clip_plane([0.1, 0, 0.2], [1, 2, -3], cap=c) for c in (False, True)
    ],
    "mesh, remesh_isotropic": lambda d: textured_ball(d).remesh_isotropic(0.3, 3),
    "mesh, subdivide": lambda d: [textured_ball(d).subdivide_midpoint(), textured_ball(d).subdivide_loop(2)],
    "mesh, deform_as_rigid_as_possible": lambda d: [
        textured_ball(d).deform_as_rigid_as_possible([0, 50, 99], d.ball.vertices[[0, 50, 9]], 3, energy, 0.5)
        for energy in ("spokes", "smoothed")
    ],
    "mesh, compute_vertex_curvature": lambda d: list(d.ball.compute_vertex_curvature()),
    "mesh, compute_geodesic_distances": lambda d: d.ball.compute_geodesic_distances([0, 77]),
    "mesh, write and read .ply": lambda d: mesh_file(d.volume.extract_triangle_mesh(0), ".ply"),
    "mesh, write and read .ply, ascii": lambda d: mesh_file(d.ball.compute_vertex_normals(), ".ply", write_ascii=True),
    "mesh, write .obj": lambda d: written_mesh(d.ball, ".obj"),
    "mesh, write .stl": lambda d: written_mesh(d.ball, ".stl"),
    "color_map": color_maps,
    "rgbd odometry": rgbd_odometry,
    "mesh, project_images_to_albedo": albedo,
    "mesh, texture_from_images": image_texture,
    "robust kernels": lambda d: {name: k.weight(np.linspace(-1, 1, 41)) for name, k in robust_kernels(0.3).items()},
    "icp, point to plane, robust": lambda d: {
        name: icp(d.surface, "PointToPlane", kernel=kernel) for name, kernel in robust_kernels().items()
    },
    "icp, point to point, scaling": lambda d: icp(d.surface, with_scaling=True),
    "icp, point to point, Huber": lambda d: icp(d.surface, kernel=reg().HuberLoss(0.03)),
    "icp, symmetric, Tukey": lambda d: icp(d.surface, "Symmetric", kernel=reg().TukeyLoss(0.1)),
    "icp, generalized, Cauchy": lambda d: icp(d.surface, "ForGeneralizedICP", kernel=reg().CauchyLoss(1.0)),
    "icp, colored": lambda d: icp(d.surface, "ForColoredICP"),
    "icp, colored, Huber": lambda d: icp(d.far, "ForColoredICP", lambda_geometric=0.5, kernel=reg().HuberLoss(0.1)),
    "icp, overlap": lambda d: [icp_with(d.surface, method, overlap=0.7) for method in ("PointToPoint", "PointToPlane")],
    "icp, max_normal_angle": lambda d: icp_with(d.surface, max_normal_angle=0.5),
    "icp, degeneracy": lambda d: [icp_with(d.plane), icp_with(d.plane, degeneracy=0), icp_with(d.plane, "Symmetric")],
    "icp, held": lambda d: [icp_fixed(d.surface), icp_fixed(d.plane)],
    "icp, callback": lambda d: icp_watched(d.surface),
    "icp, criteria": lambda d: [
        icp_with(d.surface, criteria=reg().ICPConvergenceCriteria(1e-3, 1e-3, steps)) for steps in (0, 1, 50)
    ],
    "icp, doppler": doppler,
    "icp, doppler, robust": lambda d: doppler(
        d, reject_dynamic_outliers=True, doppler_kernel=reg().TukeyLoss(0.5), geometric_kernel=reg().HuberLoss(0.2)
    ),
    "registration_icp_batch, point to point": lambda d: icp_batch(d, "PointToPoint"),
    "registration_icp_batch, point to plane": lambda d: icp_batch(d, "PointToPlane"),
    "registration_icp_batch, generalized": lambda d: icp_batch(d, "ForGeneralizedICP"),
    "multi_scale_icp": lambda d: multi_scale(d.surface),
    "multi_scale_icp, far": lambda d: multi_scale(d.far),
    "correspondences_from_features": Operation(
        lambda d: [
            reg().correspondences_from_features(*d.features, mutual, ratio=ratio, device=d.device)
            for mutual, ratio in ((False, None), (True, None), (False, 0.9))
        ],
        counts_host_work=True,
    ),
    "ransac, checkers": checked,
    "ransac, features": lambda d: [ransac_features(d, mutual) for mutual in (False, True)],
    "ransac, pairs": lambda d: [ransac(d), ransac(d, ransac_n=4, checkers=checkers()[:2], seed=1)],
    "ransac, pairs, scaling": lambda d: ransac(
        d, estimation_method=reg().TransformationEstimationPointToPoint(with_scaling=True)
    ),
    "fast global registration": fast_global,
    "fast global registration, absolute": lambda d: fast_global(d, use_absolute_scale=True, tuple_test=False),
    "robust registration": robust_global,
    "register_globally": lambda d: reg().register_globally(*d.thinned, voxel_size=0.08),
    "register_globally, not refined": lambda d: reg().register_globally(*d.thinned, voxel_size=0.08, refine=False),
    "register_multiway": Operation(registered_fragments, counts_host_work=True),
    "run_reconstruction_system": reconstructed,
    "SLAC": aligned_fragments,
    "register_nonrigid": bent,
    "coherent_point_drift": drifted,
    "register_stations": Operation(surveyed, counts_host_work=True),
    "global_optimization": lambda d: optimized(d, "levenberg-marquardt", reference_node=0),
    "global_optimization, Gauss-Newton": lambda d: optimized(d, "gauss-newton", edge_prune_threshold=0.1),
    "pose graph, write and read": graph_file,
    "odometry": odometry,
    "odometry, as measured": lambda d: odometry(d, deskew=False, max_points_per_voxel=5, min_range=2.0),
    "run_odometry": lambda d: d.path,
    "iterate_odometry": steps_of_odometry,
    "deskew_point_cloud": lambda d: reg().deskew_point_cloud(d.scans[2], pose_of(3.0, [1, 0.1, 0])),
    "evaluate_trajectory": lambda d: [
        reg().evaluate_trajectory(d.path, d.true_path, align=align, lengths=[2, 3]) for align in (True, "first", None)
    ],
    "evaluate_trajectory, scale": lambda d: reg().evaluate_trajectory(d.path, d.true_path, with_scale=True, delta=2),
}
ONCE = records(CALLS | DRAWN | FIELDS | SHAPES | OCCUPANCY | WRITTEN | VOLUMES)
