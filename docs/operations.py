"""Pictures of the reference, one for each operation or group of similar operations.

The statements of a function are the code that the reference shows below its picture.
"""

from __future__ import annotations

import numpy as np
from machinery.pictures import Panels, picture

import pointloom as loom

ORANGE, BLUE, GRAY, RED = (1.0, 0.706, 0.0), (0.0, 0.451, 0.75), (0.75, 0.75, 0.75), (0.9, 0.1, 0.1)
OWL = {"front": (0.5, -0.8, 0.35), "zoom": 0.72}
ROOM = {"front": (-0.35, -0.55, 0.75), "zoom": 0.75}
HILLS = {"front": (0.3, -0.75, 0.6), "zoom": 0.66}


def gray(depth: np.ndarray) -> np.ndarray:
    """A depth image [m] with near pixels light and missing ones black."""
    near, far = 0.5, 5.0
    shades = np.clip(255 - 215 * (depth - near) / (far - near), 40, 255)
    return np.repeat(np.where(depth > 0, shades, 0).astype(np.uint8)[:, :, None], 3, axis=2)


# Clouds


@picture("PointCloud.voxel_down_sample", "PointCloud.voxel_down_sample_and_trace", **OWL)
def voxel_down_sample() -> Panels:
    """Average all points of a voxel."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(50_000, seed=0)
    thin = cloud.voxel_down_sample(voxel_size=0.008)
    return {f"{len(cloud):,} points": cloud, f"{len(thin):,} points": thin}


@picture("PointCloud.random_down_sample", "PointCloud.uniform_down_sample", "PointCloud.farthest_point_down_sample",
         "PointCloud.farthest_point_indices", "PointCloud.thin", **OWL)  # fmt: skip
def down_sample() -> Panels:
    """Three ways to keep about 2,000 of 50,000 points."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(50_000, seed=0)
    random = cloud.random_down_sample(0.04, seed=1)
    farthest = cloud.farthest_point_down_sample(2000)
    thin = cloud.thin(0.0088)
    size = {"point_size": 4.0}
    return {
        f"random_down_sample: {len(random):,}": {"geometries": random, **size},
        f"farthest_point: {len(farthest):,}": {"geometries": farthest, **size},
        f"thin: {len(thin):,}": {"geometries": thin, **size},
    }


@picture("PointCloud.estimate_normals", "PointCloud.orient_normals_towards_camera_location", **OWL)
def estimate_normals() -> Panels:
    """Normals of planes fitted to the neighbors of each point, oriented to the camera."""
    scan = loom.datasets.object_scans(1).in_world(0)
    scan = scan.voxel_down_sample(0.006).estimate_normals(radius=0.015, max_nn=30)
    scan = scan.orient_normals_towards_camera_location([0.3, -0.5, 0.3])
    return {
        "colored by normal": {"geometry": scan, "color_by": "normal"},
        "as lines": {"geometries": scan, "point_show_normal": True},
    }


@picture("PointCloud.orient_normals_consistent_tangent_plane", "PointCloud.orient_normals_to_align_with_direction",
         "PointCloud.normal_disagreement", **OWL)  # fmt: skip
def orient_normals() -> Panels:
    """Normals of arbitrary sign, and the same normals oriented consistently. Inverted ones are red."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(6000, seed=0)
    estimated = cloud.without("normals").estimate_normals(radius=0.02, max_nn=30)
    oriented = estimated.orient_normals_consistent_tangent_plane(15)
    inverted = [(np.sum(c.normals * cloud.normals, axis=1) < 0)[:, None] for c in (estimated, oriented)]
    panels = [loom.PointCloud(cloud.points, colors=np.where(rows, RED, GRAY)) for rows in inverted]
    return {"estimate_normals": panels[0], "orient_normals_consistent_tangent_plane": panels[1]}


@picture(
    "PointCloud.crop",
    "PointCloud.select_by_index",
    "PointCloud.select_by_mask",
    "AxisAlignedBoundingBox",
    "AxisAlignedBoundingBox.mask_points",
    "AxisAlignedBoundingBox.get_point_indices_within_bounding_box",
    **OWL,
)
def crop() -> Panels:
    """The points inside a box."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(80_000, seed=0)
    box = loom.AxisAlignedBoundingBox([-0.1, -0.1, 0.0], [0.1, 0.1, 0.16])
    head = cloud.crop(box)
    return {"cloud and box": [cloud, {"geometry": box, "color": RED}], f"crop: {len(head):,} of {len(cloud):,}": head}


@picture("PointCloud.cluster_dbscan", "PointCloud.cluster_euclidean", **HILLS)
def cluster() -> Panels:
    """Clusters of the points of houses."""
    survey = loom.datasets.terrain()
    houses = survey.select_by_mask(survey["classification"] == 6)
    houses["label"] = houses.cluster_dbscan(eps=2.0, min_points=10)
    count = houses["label"].max() + 1
    return {"survey": survey, f"{count} houses": {"geometry": houses, "color_by": "label", "point_size": 3.0}}


@picture("PointCloud.segment_plane", "PointCloud.segment_planes", "PointCloud.detect_planar_patches",
         "PointCloud.region_growing", **ROOM)  # fmt: skip
def segment_planes() -> Panels:
    """Planes of a room by RANSAC. Points without a plane are dark."""
    room = loom.datasets.room_cloud().crop(loom.AxisAlignedBoundingBox([0, 0, -1], [5, 4, 2.2]))
    room = room.voxel_down_sample(0.04)
    room["label"], _ = room.segment_planes(0.03, num_iterations=500, min_points=400, max_planes=8)
    return {"room": room, "segment_planes": {"geometry": room, "color_by": "label"}}


@picture("PointCloud.remove_statistical_outlier", "PointCloud.remove_radius_outlier", **OWL)
def remove_outliers() -> Panels:
    """Points that are far from their neighbors."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(20_000, seed=0)
    stray = np.random.default_rng(0).uniform(cloud.get_min_bound(), cloud.get_max_bound(), (400, 3))
    cloud = loom.PointCloud(np.vstack([cloud.points, stray]))
    inliers, rows = cloud.remove_statistical_outlier(nb_neighbors=20, std_ratio=2.0)
    outliers = cloud.select_by_index(rows, invert=True)
    marked = {"geometry": outliers, "color": RED, "point_size": 5.0}
    return {
        f"{len(outliers)} outliers": [{"geometry": inliers, "color": GRAY}, marked],
        "without them": {"geometry": inliers, "color": GRAY},
    }


@picture(
    "PointCloud.compute_convex_hull",
    "TriangleMesh.compute_convex_hull",
    "ConvexHull",
    "LineSet.create_from_triangle_mesh",
    **OWL,
)
def convex_hull() -> Panels:
    """The smallest convex polyhedron that contains all points."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(20_000, seed=0)
    hull, _ = cloud.compute_convex_hull()
    lines = loom.LineSet.create_from_triangle_mesh(hull)
    return {
        "cloud and edges of the hull": [cloud, {"geometry": lines, "color": BLUE}],
        f"{len(hull.triangles):,} triangles": {"geometry": hull, "color": GRAY},
    }


@picture("PointCloud.get_axis_aligned_bounding_box", "PointCloud.get_oriented_bounding_box", "OrientedBoundingBox",
         "PointCloud.get_minimal_oriented_bounding_box", "TriangleMesh.get_axis_aligned_bounding_box",
         "TriangleMesh.get_oriented_bounding_box", "TriangleMesh.get_minimal_oriented_bounding_box",
         "OrientedBoundingBox.create_from_points", "OrientedBoundingBox.create_from_points_minimal",
         "AxisAlignedBoundingBox.create_from_points", **OWL)  # fmt: skip
def bounding_boxes() -> Panels:
    """Boxes around a tilted object."""
    tilt = np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]])
    cloud = loom.datasets.object_mesh().sample_points_uniformly(40_000, seed=0).rotate(tilt)
    box = cloud.get_axis_aligned_bounding_box()
    minimal = cloud.get_minimal_oriented_bounding_box()
    return {
        "axis-aligned": [cloud, {"geometry": box, "color": RED}],
        "minimal": [cloud, {"geometry": minimal, "color": BLUE}],
    }


@picture("PointCloud.hidden_point_removal", "VisibleSurface", **OWL)
def hidden_point_removal() -> Panels:
    """The points that a camera sees, without a mesh."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(30_000, seed=0)
    surface, rows = cloud.hidden_point_removal([-1.0, -0.6, 0.3], radius=100.0)
    hidden = cloud.select_by_index(rows, invert=True)
    return {
        "visible from the left": [cloud.select_by_index(rows), {"geometry": hidden, "color": GRAY}],
        "VisibleSurface": {"geometry": surface, "color": GRAY},
    }


@picture("compute_iss_keypoints", **OWL)
def keypoints() -> Panels:
    """ISS keypoints: positions with distinct principal directions."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(20_000, seed=0)
    points = loom.compute_iss_keypoints(cloud, salient_radius=0.012, non_max_radius=0.01)
    marked = {"geometry": points, "color": RED, "point_size": 7.0}
    return {
        f"{len(cloud):,} points": cloud,
        f"{len(points)} keypoints": [{"geometry": cloud, "color": GRAY, "point_size": 1.0}, marked],
    }


@picture("compute_eigen_features", "estimate_curvature", "PointCloud.estimate_covariances", **ROOM)
def eigen_features() -> Panels:
    """Features of the covariance of each neighborhood."""
    room = loom.datasets.room_cloud().crop(loom.AxisAlignedBoundingBox([0, 0, -1], [5, 4, 2.2]))
    room = loom.compute_eigen_features(room.voxel_down_sample(0.04), radius=0.12, max_nn=None)
    return {
        "planarity": {"geometry": room, "color_by": "planarity"},
        "curvature": {"geometry": room, "color_by": "curvature"},
    }


@picture("PointCloud.smooth_mls", "PointCloud.smooth_bilateral", "PointCloud.smooth_laplacian",
         "PointCloud.smooth_taubin", **OWL)  # fmt: skip
def smooth_cloud() -> Panels:
    """Move noisy points to a surface that is fitted to their neighbors."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(20_000, seed=0)
    noise = np.random.default_rng(0).normal(0.0, 0.002, cloud.points.shape)
    noisy = loom.PointCloud(cloud.points + noise, colors=cloud.colors)
    smooth = noisy.smooth_mls(radius=0.012, max_nn=None)
    return {"2 mm of noise": noisy, "smooth_mls": smooth}


@picture("PointCloud.compute_point_cloud_distance", "PointCloud.compute_nearest_neighbor_distance", **OWL)
def cloud_distance() -> Panels:
    """The distance of each point to the nearest point of another cloud."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(60_000, seed=0)
    scan = loom.datasets.object_scans(1).in_world(0)
    cloud["distance"] = cloud.compute_point_cloud_distance(scan)
    shown = {"geometry": cloud, "color_by": "distance", "colormap": "turbo"}
    return {"one scan": scan, "distance to it [m]": {"geometries": shown, "color_bar": True}}


# Terrain and change


@picture("classify_ground", "height_above_ground", **HILLS)
def classify_ground() -> Panels:
    """Ground points of an airborne scan, and the height of the others above them."""
    survey = loom.datasets.terrain()
    ground = loom.classify_ground(survey)
    survey["classification"] = np.where(ground, 2, 1).astype(np.uint8)
    survey["height"] = loom.height_above_ground(survey)
    return {
        "classify_ground": {"geometry": survey, "color_by": "classification"},
        "height_above_ground [m]": {"geometries": {"geometry": survey, "color_by": "height"}},
    }


@picture("rasterize", "Raster", "Raster.contour_lines", "Raster.fill_gaps", front=(0.0, 0.0, 1.0), up=(0.0, 1.0, 0.0),
         zoom=0.66)  # fmt: skip
def rasterize() -> Panels:
    """A terrain model with the true classes of the points, and its contour lines."""
    survey = loom.datasets.terrain()
    dtm = loom.rasterize(survey, 1.0, "dtm")
    lines = dtm.contour_lines(interval=1.0)
    return {"points": survey, "contour lines every meter": [survey, lines]}


@picture("m3c2", "M3C2Result", "paint_change", "draw_change", front=(-0.25, -0.6, 0.75), zoom=0.68)
def m3c2() -> Panels:
    """Change between two surveys along the normals of the surface, with its uncertainty."""
    rng = np.random.default_rng(0)
    x, y = rng.uniform(-20, 20, (2, 40_000))
    heap = 3 * np.exp(-((x - 5) ** 2 + y**2) / 20)
    before, after = (loom.PointCloud(np.column_stack([x, y, np.sin(x / 5) + z])) for z in (0 * heap, heap))
    change = loom.m3c2(before, after, normal_radii=[2.0], cylinder_radius=0.6, max_distance=5.0)
    return {"after": {"geometry": after, "color_by": "height"}, "paint_change": loom.paint_change(after, change)}


# Shapes


@picture("detect_shapes", "DetectedShapes", "PointCloud.segment_shape", "fit_shape", "Shape", zoom=0.6)
def detect_shapes() -> Panels:
    """Spheres, cylinders, cones, tori and planes of a cloud by RANSAC."""
    parts = [loom.TriangleMesh.create_plane(4.0, 3.0), loom.TriangleMesh.create_sphere(0.5).translate([1, 1, 0.6]),
             loom.TriangleMesh.create_cylinder(0.3, 1.2).translate([2.2, 1.6, 0.6]),
             loom.TriangleMesh.create_cone(0.5, 1.0).translate([3.2, 0.8, 0.05])]  # fmt: skip
    cloud = loom.PointCloud.concatenate([part.sample_points_uniformly(20_000, seed=1) for part in parts])
    shapes = loom.detect_shapes(cloud.estimate_normals(radius=0.1, max_nn=30), 0.01)
    cloud["label"] = shapes.labels
    return {"cloud": {"geometry": cloud, "color": GRAY}, "detect_shapes": {"geometry": cloud, "color_by": "label"}}


@picture("find_boxes", "BoxShape", zoom=0.95)
def find_boxes() -> Panels:
    """Boxes from the detected planes of a cloud."""
    cartons = [
        loom.TriangleMesh.create_box(0.4, 0.3, 0.2),
        loom.TriangleMesh.create_box(0.2, 0.3, 0.4).translate([0.6, 0, 0]),
    ]
    cloud = loom.PointCloud.concatenate([carton.sample_points_uniformly(8000, seed=1) for carton in cartons])
    shapes = loom.detect_shapes(cloud.estimate_normals(radius=0.03, max_nn=30), 0.005, kinds="plane")
    boxes = [loom.TriangleMesh(*box.to_mesh()) for box in loom.find_boxes(cloud, shapes, 0.02)]
    return {
        "cloud": {"geometry": cloud, "color": GRAY},
        f"{len(boxes)} boxes": [{"geometry": box, "color": ORANGE} for box in boxes],
    }


# Depth images


@picture("PointCloud.create_from_rgbd_image", "PointCloud.create_from_depth_image", "RGBDImage",
         "CameraFrustum", front=(0.9, -0.35, 0.6), zoom=0.7)  # fmt: skip
def depth_image_to_cloud() -> Panels:
    """A depth image in colors by distance, and its points with the camera."""
    frame = loom.datasets.room_frames(1)[0]
    image = loom.RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=6.0)
    cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))
    camera = loom.CameraFrustum(frame.intrinsic, frame.T_world_camera, 0.5)
    return {"color and depth": np.vstack([frame.color, gray(frame.depth)]), "create_from_rgbd_image": [cloud, camera]}


@picture("PointCloud.project_to_depth_image", "PointCloud.project_to_rgbd_image", **ROOM)
def project_to_depth_image() -> Panels:
    """The depth image that a camera has of a cloud."""
    room = loom.datasets.room_cloud()
    frame = loom.datasets.room_frames(1)[0]
    extrinsic = np.linalg.inv(frame.T_world_camera)
    depth = room.project_to_depth_image(320, 240, frame.intrinsic, extrinsic, depth_max=6.0)
    cloud = room.crop(loom.AxisAlignedBoundingBox([0, 0, -1], [5, 4, 2.2]))
    return {"cloud": cloud, "project_to_depth_image": gray(depth)}


@picture("filter_depth_bilateral", "fill_depth_holes", "erode_depth_edges")
def depth_filters() -> Panels:
    """A noisy depth image with holes, filtered and filled."""
    depth = loom.datasets.room_frames(1)[0].depth
    smooth = loom.filter_depth_bilateral(depth, depth_scale=1.0)
    filled, _ = loom.fill_depth_holes(smooth, max_pixels=400, depth_scale=1.0)
    eroded = loom.erode_depth_edges(depth, depth_scale=1.0)
    return {"depth and erode_depth_edges": np.vstack([gray(depth), gray(eroded)]),
            "bilateral, fill_depth_holes": np.vstack([gray(smooth), gray(filled)])}  # fmt: skip


@picture("create_normal_map")
def normal_map() -> Panels:
    """Normals of a depth image: x, y and z as red, green and blue."""
    frame = loom.datasets.room_frames(1, noise=False)[0]
    normals = loom.create_normal_map(frame.depth, frame.intrinsic, depth_scale=1.0)
    return {"color": frame.color, "create_normal_map": (127.5 * (normals + 1)).astype(np.uint8)}


# Registration


@picture("registration.registration_icp", "registration.multi_scale_icp", "registration.registration_ndt",
         "registration.evaluate_registration", "registration.RegistrationResult", **OWL)  # fmt: skip
def registration_icp() -> Panels:
    """Two scans before and after ICP."""
    target, source = (loom.datasets.object_scans(12).in_world(k).estimate_normals() for k in (0, 1))
    source = source.rotate(np.array([[0.96, -0.28, 0.0], [0.28, 0.96, 0.0], [0.0, 0.0, 1.0]])).translate(
        [0, 0.01, 0.02]
    )
    method = loom.registration.TransformationEstimationPointToPlane()
    result = loom.registration.registration_icp(source, target, 0.03, estimation_method=method)
    return {
        "before": [{"geometry": source, "color": ORANGE}, {"geometry": target, "color": BLUE}],
        "after": [{"geometry": source.transform(result.transformation), "color": ORANGE},
                  {"geometry": target, "color": BLUE}],
    }  # fmt: skip


@picture("registration.register_globally", "registration.registration_fgr_based_on_correspondence",
         "registration.registration_ransac_based_on_correspondence", "registration.register_pair",
         "registration.registration_robust_based_on_correspondence", "compute_fpfh_feature",
         "registration.correspondences_from_features", "LineSet.create_from_point_cloud_correspondences",
         front=(0.1, -0.2, -1.0), up=(0.0, -1.0, 0.0), zoom=0.62)  # fmt: skip
def global_registration() -> Panels:
    """Matches of features of two scans without initial poses, and the registered scans."""
    target, source = (
        scan.voxel_down_sample(0.004).estimate_normals() for scan in loom.datasets.object_scans(20).scans[:2]
    )
    source = source.translate([0.3, 0.0, 0.0])
    features = [loom.compute_fpfh_feature(cloud, radius=0.03) for cloud in (source, target)]
    matches = loom.registration.correspondences_from_features(*features, mutual_filter=True)
    lines = loom.LineSet.create_from_point_cloud_correspondences(source, target, matches[::25])
    result = loom.registration.register_globally(source, target, voxel_size=0.006)
    return {
        "correspondences_from_features": [source, target, {"geometry": lines, "color": BLUE}],
        "register_globally": {
            "geometries": [{"geometry": source.transform(result.transformation), "color": ORANGE},
                           {"geometry": target, "color": BLUE}],
            "camera": {"front": [0.1, -0.2, -1.0], "up": [0.0, -1.0, 0.0], "zoom": 0.75},
        },
    }  # fmt: skip


@picture("registration.run_odometry", "registration.LidarOdometry", "registration.LidarOdometry.register",
         "Trajectory", front=(-0.9, -0.4, 0.5), zoom=0.25)  # fmt: skip
def run_odometry() -> Panels:
    """The path of a LiDAR on a car, and its scans along it."""
    scans = loom.datasets.street_scans(20).scans
    path = loom.registration.run_odometry(scans)
    street = loom.PointCloud.concatenate([scan.transform(pose) for scan, pose in zip(scans, path.poses, strict=True)])
    shown = {"geometry": street.voxel_down_sample(0.15), "point_size": 2.0}
    return {"run_odometry": [shown, {"geometry": path, "color": RED, "line_width": 4.0}]}


@picture("registration.register_nonrigid", "registration.coherent_point_drift", "registration.NonRigidResult",
         "registration.DriftResult", zoom=0.7)  # fmt: skip
def register_nonrigid() -> Panels:
    """A surface before and after it is deformed to fit another."""
    x, y = np.random.default_rng(0).uniform(-1, 1, (2, 2000))
    flat = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x)]))
    bent = loom.PointCloud(np.column_stack([x, y, 0.1 * np.sin(4 * x) + 0.4 * x * x]))
    result = loom.registration.register_nonrigid(flat, bent, max_correspondence_distance=0.5)
    moved = result.warped
    return {
        "before": [{"geometry": flat, "color": ORANGE}, {"geometry": bent, "color": BLUE}],
        "after": [{"geometry": moved, "color": ORANGE}, {"geometry": bent, "color": BLUE}],
    }


# Surfaces


@picture("TriangleMesh.create_from_point_cloud_alpha_shape", **OWL)
def alpha_shape() -> Panels:
    """Alpha shapes of two sizes."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(6000, seed=0)
    fine = loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 0.015)
    coarse = loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 0.05)
    return {"alpha = 15 mm": {"geometry": fine.compute_vertex_normals(), "shaded": True},
            "alpha = 50 mm": {"geometry": coarse.compute_vertex_normals(), "shaded": True}}  # fmt: skip


@picture("TriangleMesh.create_from_point_cloud_ball_pivoting", **OWL)
def ball_pivoting() -> Panels:
    """A ball that rolls over the points adds a triangle wherever it touches three."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(6000, seed=0)
    mesh = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [0.004, 0.008])
    return {f"{len(cloud):,} points": cloud, f"{len(mesh.triangles):,} triangles": {"geometry": mesh, "shaded": True}}


@picture("TriangleMesh.create_from_point_cloud_poisson", "TriangleMesh.trim", "meshing.create_surface", **OWL)
def poisson() -> Panels:
    """A smooth closed surface, and the same surface without the parts of few points."""
    scan = loom.datasets.object_scans(12).in_world(0).estimate_normals()
    scan = scan.orient_normals_towards_camera_location([0.3, -0.5, 0.3])
    mesh, densities = loom.TriangleMesh.create_from_point_cloud_poisson(scan, depth=7)
    trimmed = mesh.trim(densities, np.quantile(densities, 0.4))
    return {
        "one scan": scan,
        "Poisson": {"geometry": mesh, "color": GRAY},
        "trim": {"geometry": trimmed, "color": GRAY},
    }


@picture("TSDFVolume", "TSDFVolume.integrate", "TSDFVolume.extract_triangle_mesh", "TSDFVolume.extract_point_cloud",
         "PagedTSDFVolume", "PagedTSDFVolume.integrate", "PagedTSDFVolume.extract_triangle_mesh",
         "PagedTSDFVolume.extract_point_cloud", "rgbd.fuse", front=(0.2, -0.75, 0.6), zoom=0.62)  # fmt: skip
def tsdf_volume() -> Panels:
    """Depth images with known poses, fused into a mesh."""
    volume = loom.TSDFVolume(voxel_size=0.03)
    frames = loom.datasets.room_frames(24)
    for frame in frames:
        volume.integrate(frame.depth, frame.intrinsic, np.linalg.inv(frame.T_world_camera), frame.color, 1.0, 5.0)
    mesh = volume.extract_triangle_mesh(weight_threshold=1.0)
    return {
        "three of 24 frames": np.vstack([np.hstack([frames[k].color, gray(frames[k].depth)]) for k in (0, 11, 23)]),
        "extract_triangle_mesh": {"geometries": {"geometry": mesh, "shaded": False}, "mesh_show_back_face": False},
    }


@picture("TSDFVolume.ray_cast", "PagedTSDFVolume.ray_cast")
def ray_cast_volume() -> Panels:
    """Depth and normals of a volume, as a camera sees it."""
    volume = loom.TSDFVolume(voxel_size=0.02)
    for frame in loom.datasets.room_frames(4):
        extrinsic = np.linalg.inv(frame.T_world_camera)
        volume.integrate(frame.depth, frame.intrinsic, extrinsic, frame.color, 1.0, 5.0)
    seen = volume.ray_cast(frame.intrinsic, extrinsic, depth_max=5.0, weight_threshold=1.0)
    return {"depth": gray(seen.depth), "normals": np.nan_to_num(127.5 * (seen.normals + 1)).astype(np.uint8)}


@picture("meshing.marching_cubes", "TriangleMesh.create_isosurfaces", zoom=1.0)
def marching_cubes() -> Panels:
    """The surface of a field at a level."""
    x, y, z = np.mgrid[-1:1:60j, -1:1:60j, -1:1:60j] * 4.5
    gyroid = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
    mesh = loom.meshing.marching_cubes(gyroid, level=0.0, spacing=(0.1, 0.1, 0.1))
    inside = loom.meshing.marching_cubes(gyroid, level=0.6, spacing=(0.1, 0.1, 0.1))
    return {"level 0": {"geometry": mesh, "color": ORANGE}, "level 0.6": {"geometry": inside, "color": ORANGE}}


# Meshes


@picture("TriangleMesh.create_box", "TriangleMesh.create_plane", "TriangleMesh.create_tetrahedron",
         "TriangleMesh.create_octahedron", "TriangleMesh.create_icosahedron", "TriangleMesh.create_sphere",
         "TriangleMesh.create_ellipsoid", "TriangleMesh.create_cylinder", "TriangleMesh.create_cone",
         "TriangleMesh.create_torus", "TriangleMesh.create_arrow", "TriangleMesh.create_coordinate_frame",
         "TriangleMesh.create_mobius", front=(0.0, -0.6, 0.8), zoom=0.45)  # fmt: skip
def primitives() -> Panels:
    """Shapes of `TriangleMesh.create_...`."""
    mesh = loom.TriangleMesh
    shapes = [mesh.create_box(), mesh.create_plane(), mesh.create_tetrahedron(), mesh.create_octahedron(),
              mesh.create_icosahedron(), mesh.create_sphere(), mesh.create_ellipsoid(), mesh.create_cylinder(),
              mesh.create_cone(), mesh.create_torus(), mesh.create_arrow().scale(0.2, [0, 0, 0]),
              mesh.create_coordinate_frame(), mesh.create_mobius()]  # fmt: skip
    placed = [shape.translate([3 * (k % 5), -3.2 * (k // 5), 0.0]) for k, shape in enumerate(shapes)]
    colored = [{"geometry": shape, "color": BLUE} if not shape.has_vertex_colors() else shape for shape in placed]
    return {"primitives": colored}


@picture("TriangleMesh.simplify_quadric_decimation", "TriangleMesh.simplify_vertex_clustering",
         "meshing.simplify_mesh", **OWL)  # fmt: skip
def simplify() -> Panels:
    """Fewer triangles of the same shape."""
    mesh = loom.datasets.object_mesh()
    quadric = mesh.simplify_quadric_decimation(2000)
    clustered = mesh.simplify_vertex_clustering(0.012)
    return {
        f"{len(mesh.triangles):,} triangles": mesh,
        f"quadric: {len(quadric.triangles):,}": {"geometry": quadric, "wireframe": True},
        f"clustering: {len(clustered.triangles):,}": {"geometry": clustered, "wireframe": True},
    }


@picture("TriangleMesh.filter_smooth_taubin", "TriangleMesh.filter_smooth_laplacian",
         "TriangleMesh.filter_smooth_simple", "meshing.smooth_mesh", "TriangleMesh.filter_sharpen", **OWL)  # fmt: skip
def smooth_mesh() -> Panels:
    """A noisy mesh, and the mesh after Taubin smoothing, which keeps its volume."""
    mesh = loom.datasets.object_mesh().simplify_quadric_decimation(20_000)
    mesh.vertices = mesh.vertices + np.random.default_rng(0).normal(0.0, 0.0008, mesh.vertices.shape)
    smooth = mesh.filter_smooth_taubin(20)
    return {"0.8 mm of noise": {"geometry": mesh.compute_vertex_normals(), "color": GRAY},
            "filter_smooth_taubin": {"geometry": smooth.compute_vertex_normals(), "color": GRAY}}  # fmt: skip


@picture("TriangleMesh.fill_holes", "TriangleMesh.repair", **OWL)
def fill_holes() -> Panels:
    """A mesh with holes, and the mesh with them closed."""
    mesh = loom.datasets.object_mesh().simplify_quadric_decimation(20_000)
    centers = np.array([[-0.03, -0.08, 0.02], [0.06, -0.06, 0.0], [0.0, -0.05, 0.11]])
    distances = np.linalg.norm(mesh.vertices[:, None] - centers, axis=2).min(axis=1)
    broken = mesh.remove_vertices_by_mask(distances < 0.025)
    closed = broken.fill_holes()
    return {"with holes": broken, "fill_holes": closed}


@picture("TriangleMesh.subdivide_midpoint", "TriangleMesh.subdivide_loop", "TriangleMesh.remesh_isotropic", zoom=1.5)
def subdivide() -> Panels:
    """A box, subdivided in two ways and remeshed with edges of equal length."""
    box = loom.TriangleMesh.create_box()
    midpoint = box.subdivide_midpoint(2)
    smooth = box.subdivide_loop(3)
    remeshed = box.remesh_isotropic(0.15)
    style = {"wireframe": True, "color": ORANGE}
    return {"subdivide_midpoint": {"geometry": midpoint, **style}, "subdivide_loop": {"geometry": smooth, **style},
            "remesh_isotropic": {"geometry": remeshed, **style}}  # fmt: skip


@picture("TriangleMesh.boolean_union", "TriangleMesh.boolean_difference", "TriangleMesh.boolean_intersection", zoom=1.1)
def booleans() -> Panels:
    """Union, difference and intersection of a box and a sphere."""
    box = loom.TriangleMesh.create_box()
    ball = loom.TriangleMesh.create_sphere(0.5, resolution=40).translate([1.0, 0.0, 1.0])
    union, difference, common = box.boolean_union(ball), box.boolean_difference(ball), box.boolean_intersection(ball)
    return {"union": {"geometry": union, "color": ORANGE}, "difference": {"geometry": difference, "color": ORANGE},
            "intersection": {"geometry": common, "color": ORANGE}}  # fmt: skip


@picture(
    "TriangleMesh.clip_plane", "TriangleMesh.slice_plane", "TriangleMesh.section_loops", "TriangleMesh.crop", **OWL
)
def cut() -> Panels:
    """The part of a mesh on one side of a plane, and sections at several heights."""
    mesh = loom.datasets.object_mesh()
    half = mesh.clip_plane([0, 0, 0], [1, 0, 0], cap=True)
    sections = mesh.slice_plane([0, 0, 0], [0, 0, 1], np.linspace(-0.14, 0.14, 15))
    return {"clip_plane": half, "slice_plane": sections}


@picture("TriangleMesh.sample_points_uniformly", "TriangleMesh.sample_points_poisson_disk", **OWL)
def sample_points() -> Panels:
    """Points on a mesh: random, and at even distances."""
    mesh = loom.datasets.object_mesh()
    random = mesh.sample_points_uniformly(5000, seed=0)
    even = mesh.sample_points_poisson_disk(5000, seed=0)
    return {
        "mesh": mesh,
        "uniformly": {"geometries": random, "point_size": 3.0},
        "poisson_disk": {"geometries": even, "point_size": 3.0},
    }


@picture("TriangleMesh.voxelize", "VoxelGrid", "VoxelGrid.create_from_triangle_mesh",
         "VoxelGrid.create_from_triangle_mesh_within_bounds", **OWL)  # fmt: skip
def voxelize() -> Panels:
    """The voxels that a mesh touches."""
    mesh = loom.datasets.object_mesh()
    grid = mesh.voxelize(0.01)
    return {"mesh": mesh, "voxelize": {"geometry": grid, "color": ORANGE}}


@picture("RaycastingScene", "RaycastingScene.cast_rays", "RaycastingScene.create_rays_pinhole")
def ray_casting() -> Panels:
    """Distances and normals where the rays of a camera meet a mesh."""
    scene = loom.RaycastingScene()
    scene.add_triangles(loom.datasets.room_mesh())
    rays = scene.create_rays_pinhole(fov_deg=80, center=[2, 3, 0.8], eye=[4.4, 0.6, 1.7], up=[0, 0, -1], width_px=318,
                                     height_px=376)  # fmt: skip
    hits = scene.cast_rays(rays)
    normals = (127.5 * (hits["primitive_normals"] + 1)).astype(np.uint8)
    return {"t_hit": gray(np.where(np.isfinite(hits["t_hit"]), hits["t_hit"], 0)), "primitive_normals": normals}


@picture("DistanceField", "DistanceField.from_point_cloud", "DistanceField.slice", "draw_slice")
def distance_field() -> Panels:
    """A section of the distances to the points of a cloud."""
    cloud = loom.datasets.object_mesh().sample_points_uniformly(50_000, seed=0)
    field = loom.DistanceField.from_point_cloud(cloud, voxel_size=0.004, max_distance=0.1)
    section = loom.draw_slice(field.slice("y", 0.0), title="y = 0", size=(640, 376))
    return {"draw_slice": section}


@picture("RaycastingScene.compute_signed_distance", "RaycastingScene.compute_distance",
         "RaycastingScene.compute_occupancy", front=(0.0, -1.0, 0.0))  # fmt: skip
def signed_distance() -> Panels:
    """Signed distances to a mesh at the points of a section, negative inside."""
    mesh, scene = loom.datasets.object_mesh(), loom.RaycastingScene()
    scene.add_triangles(mesh)
    x, z = np.meshgrid(np.linspace(-0.16, 0.16, 200), np.linspace(-0.2, 0.2, 250))
    points = np.column_stack([x.ravel(), np.zeros(x.size), z.ravel()]).astype(np.float32)
    section = loom.PointCloud(points, distance=scene.compute_signed_distance(points))
    shown = {"geometry": section, "color_by": "distance", "colormap": "coolwarm", "limits": (-0.08, 0.08)}
    return {"mesh": mesh, "compute_signed_distance [m]": {"geometries": shown, "color_bar": True}}


@picture("OccupancyGrid", "OccupancyGrid.insert_scan", "OccupancyGrid.to_voxel_grid", **ROOM)
def occupancy() -> Panels:
    """Occupied voxels of the room after scans from three positions."""
    room = loom.datasets.room_cloud(voxel_size=0.02).crop(loom.AxisAlignedBoundingBox([0, 0, -1], [5, 4, 2.0]))
    grid = loom.OccupancyGrid(voxel_size=0.15)
    grid.insert_scan(room, [2.5, 2.0, 1.4])
    return {"scan": room, "to_voxel_grid": {"geometry": grid.to_voxel_grid(), "color": ORANGE, "wireframe": True}}


@picture("TriangleMesh.compute_vertex_curvature", "TriangleMesh.compute_geodesic_distances", **OWL)
def curvature() -> Panels:
    """Mean curvature, and distances along the surface from the top of an ear."""
    mesh = loom.datasets.object_mesh().simplify_quadric_decimation(40_000)
    mesh.vertex_attributes["curvature"] = mesh.compute_vertex_curvature().mean
    mesh.vertex_attributes["distance"] = mesh.compute_geodesic_distances([int(np.argmax(mesh.vertices[:, 2]))])
    return {"compute_vertex_curvature": {"geometry": mesh, "color_by": "curvature", "colormap": "coolwarm"},
            "compute_geodesic_distances": {"geometry": mesh, "color_by": "distance", "colormap": "turbo"}}  # fmt: skip


@picture("TriangleMesh.compute_error_map", "meshing.compare_meshes", "meshing.compare_cloud_to_mesh", **OWL)
def error_map() -> Panels:
    """The distance of a simplified mesh from the original."""
    mesh = loom.datasets.object_mesh()
    simple = mesh.simplify_quadric_decimation(500)
    simple, _ = mesh.compute_error_map(simple)
    return {"original": mesh, "compute_error_map": simple}


@picture("TriangleMesh.extrude_linear", "TriangleMesh.extrude_rotation", "TriangleMesh.from_polygon",
         "TriangleMesh.revolve", zoom=1.3)  # fmt: skip
def extrude() -> Panels:
    """A polygon with a hole, extruded, and a revolved profile."""
    hole = [[1, 1], [2, 1], [2, 2], [1, 2]]
    frame = loom.TriangleMesh.from_polygon([[0, 0], [3, 0], [3, 3], [0, 3]], [hole])
    prism = frame.extrude_linear([0, 0, 1.5])
    vase = loom.TriangleMesh.revolve([[0, 0], [1, 0], [0.5, 1], [0.7, 2], [0.6, 2], [0.4, 1], [0, 0.2]])
    return {"from_polygon": {"geometry": frame, "color": BLUE}, "extrude_linear": {"geometry": prism, "color": BLUE},
            "revolve": {"geometries": {"geometry": vase, "color": BLUE}, "camera": None}}  # fmt: skip


@picture(
    "TriangleMesh.remove_small_components", "TriangleMesh.cluster_connected_triangles", "meshing.clean_mesh", **OWL
)
def components() -> Panels:
    """A mesh with 40 loose pieces, and its largest component."""
    mesh, rng = loom.datasets.object_mesh(), np.random.default_rng(0)
    positions = rng.uniform(mesh.get_min_bound(), mesh.get_max_bound(), (40, 3))
    pieces = [loom.TriangleMesh.create_icosahedron(0.004).translate(position) for position in positions]
    loose = loom.TriangleMesh.concatenate([mesh, *(piece.paint_uniform_color([0.9, 0.1, 0.1]) for piece in pieces)])
    largest = loose.remove_small_components(min_triangles=100)
    return {"41 components": loose, "remove_small_components": largest}


@picture("GaussianSplats", "GaussianSplats.rasterize", "meshing.fuse_splats", **OWL)
def splats() -> Panels:
    """Points, Gaussian splats at the same positions, and the mesh fused from views of the splats."""
    cloud = loom.datasets.object_mesh().sample_points_poisson_disk(10_000, seed=0)
    count, harmonics = len(cloud), (cloud.colors - 0.5) / 0.2821
    scales, rotations = np.full((count, 3), 0.0025), np.tile([1.0, 0.0, 0.0, 0.0], (count, 1))
    splats = loom.GaussianSplats(cloud.points, scales, rotations, np.full(count, 0.8), harmonics)
    mesh = loom.meshing.fuse_splats(splats, voxel_size=0.004)
    return {
        f"{count:,} points": {"geometries": cloud, "point_size": 2.0},
        "GaussianSplats": splats,
        "fuse_splats": mesh,
    }
