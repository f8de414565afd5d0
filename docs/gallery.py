"""Draw an image for each step of an Open3D tutorial: `python docs/gallery.py` writes docs/gallery.jpg.

All data is synthetic: RGB-D frames of a furnished room, and shapes. Each function returns arguments of `loom.render`.
"""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import pointloom as loom
from pointloom.datasets.scenes.room import room_sequence
from pointloom.visualization.render.canvas import Canvas

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.651, 0.929)
SIZE = (400, 300)  # [px] of an image
TITLE = 26  # [px] above it
COLUMNS = 4

Scene = dict[str, Any]


@functools.cache
def frames() -> list[Any]:
    """Four frames of a camera moving through the room, without noise."""
    sequence = room_sequence(24, width=200, height=150, noise=False)
    return [sequence.read(index) for index in (0, 1, 2, 3)]


@functools.cache
def frame_cloud(index: int) -> loom.PointCloud:
    """The points of a frame in the coordinates of the room."""
    frame = frames()[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=6.0)
    return loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))


@functools.cache
def room() -> loom.PointCloud:
    """The merged points of the four frames."""
    return loom.PointCloud.concatenate([frame_cloud(index) for index in range(4)])


@functools.cache
def room_mesh() -> loom.TriangleMesh:
    """The mesh fused from the four frames."""
    volume = loom.TSDFVolume(voxel_size=0.03, truncation=0.12)
    for frame in frames():
        T = np.linalg.inv(frame.T_world_camera)
        volume.integrate(frame.depth, frame.intrinsic, T, frame.color, depth_scale=1.0, depth_max=6.0)
    return volume.extract_triangle_mesh(weight_threshold=0.5)


@functools.cache
def solids() -> loom.PointCloud:
    """A sphere, a torus and a box on a floor: 30,000 points with normals."""
    block = loom.TriangleMesh.create_box(0.5, 0.5, 0.5).translate([0.6, -0.2, 0.0])
    ball = loom.TriangleMesh.create_sphere(0.35).translate([-0.5, 0.5, 0.35])
    ring = loom.TriangleMesh.create_torus(0.4, 0.12).translate([-0.4, -0.5, 0.12])
    floor = loom.TriangleMesh.create_plane(2.4, 2.4).translate([-1.2, -1.2, 0.0])
    counts = (6000, 6000, 6000, 12000)
    samples = zip((block, ball, ring, floor), counts, strict=True)
    cloud = loom.PointCloud.concatenate([mesh.sample_points_uniformly(n, seed=1) for mesh, n in samples])
    return cloud.estimate_normals(radius=0.08, max_nn=20)


@functools.cache
def objects() -> loom.PointCloud:
    """The three objects without the floor."""
    return solids().select_by_mask(solids().points[:, 2] > 0.01)


def loading() -> Scene:
    """Load and display a cloud."""
    return {"geometries": room()}


def height() -> Scene:
    """A view as in Open3D, colored by height."""
    return {"geometries": {"geometry": room(), "color_by": "height"}, "color_bar": True,
            "camera": {"zoom": 0.5, "front": [0.6, -0.5, 0.7], "up": [0, 0, 1]}}  # fmt: skip


def normals() -> Scene:
    """Voxel downsampling and normals."""
    thin = objects().voxel_down_sample(0.06).estimate_normals(radius=0.15, max_nn=30)
    return {"geometries": thin, "point_show_normal": True, "point_size": 4.0}


def cropping() -> Scene:
    """Crop, paint, distances between clouds."""
    box = loom.AxisAlignedBoundingBox([-0.9, 0.1, 0.01], [-0.1, 0.9, 0.8])
    ball = solids().crop(box)
    rest = solids().select_by_index(box.get_point_indices_within_bounding_box(solids().points), invert=True)
    rest["distance"] = rest.compute_point_cloud_distance(ball)
    return {"geometries": [{"geometry": ball.paint_uniform_color(ORANGE), "name": "ball"}, box,
                           {"geometry": rest, "color_by": "distance", "colormap": "turbo"}],
            "color_bar": True}  # fmt: skip


def clusters() -> list[loom.PointCloud]:
    """The objects as separate clouds."""
    labels = np.asarray(objects().cluster_dbscan(0.08, 8))
    return [objects().select_by_mask(labels == label) for label in range(labels.max() + 1)]


def boxes() -> Scene:
    """Bounding boxes and convex hulls."""
    drawn: list[Any] = [objects()]
    for part in clusters():
        drawn.append({"geometry": part.get_axis_aligned_bounding_box(), "color": (0.85, 0.1, 0.1)})
        drawn.append({"geometry": part.get_oriented_bounding_box(), "color": (0.1, 0.6, 0.1)})
    hull, _ = clusters()[-1].compute_convex_hull()
    drawn.append({"geometry": hull, "wireframe": True, "color": BLUE})
    return {"geometries": drawn}


def dbscan() -> Scene:
    """DBSCAN clustering."""
    cloud = objects().copy()
    cloud["label"] = np.asarray(cloud.cluster_dbscan(0.08, 8))
    positions = [part.points.mean(axis=0) + np.array([0, 0, 0.45]) for part in clusters()]
    return {"geometries": {"geometry": cloud, "color_by": "label"}, "color_bar": True,
            "labels": [(f"cluster {k}", position) for k, position in enumerate(positions)]}  # fmt: skip


def planes() -> Scene:
    """Plane segmentation."""
    _, inliers = solids().segment_plane(0.01, 3, 200)
    floor = solids().select_by_index(inliers).paint_uniform_color((0.9, 0.2, 0.2))
    rest = solids().select_by_index(inliers, invert=True).paint_uniform_color((0.45, 0.5, 0.55))
    return {"geometries": {"plane": floor, "rest": rest}, "legend": True}


def hidden_points() -> Scene:
    """Hidden point removal."""
    camera_position = np.array([2.5, -2.5, 2.0])
    _, visible = solids().hidden_point_removal(camera_position, 300.0)
    hidden = solids().select_by_index(visible, invert=True)
    return {"geometries": {"visible": {"geometry": solids().select_by_index(visible), "color": BLUE},
                           "hidden": {"geometry": hidden, "color": (0.75, 0.75, 0.75)}},
            "legend": True, "camera": {"front": [-0.6, -0.6, 0.6], "up": [0, 0, 1], "zoom": 0.7}}  # fmt: skip


def outliers() -> Scene:
    """Statistical outlier removal."""
    rng = np.random.default_rng(3)
    noisy = loom.PointCloud(np.vstack([objects().points, rng.uniform([-1.2, -1.2, 0], [1.2, 1.2, 1.2], (300, 3))]))
    inliers, rows = noisy.remove_statistical_outlier(20, 2.0)
    outlier_points = noisy.select_by_index(rows, invert=True)
    return {"geometries": {"inliers": inliers.paint_uniform_color((0.6, 0.6, 0.6)),
                           "outliers": {"geometry": outlier_points, "color": (0.9, 0.1, 0.1), "point_size": 5.0}},
            "legend": True}  # fmt: skip


def rgbd() -> Scene:
    """An RGB-D frame as a cloud, and its camera."""
    frame = frames()[2]
    return {"geometries": [frame_cloud(2), loom.CameraFrustum(frame.intrinsic, frame.T_world_camera, 0.4)]}


def moved(cloud: loom.PointCloud, degrees: float, step: tuple[float, float, float]) -> loom.PointCloud:
    """Rotate a cloud about z and translate it."""
    angle, T = math.radians(degrees), np.eye(4)
    T[:2, :2], T[:3, 3] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]], step
    return cloud.transform(T)


def before_icp() -> Scene:
    """Two clouds before ICP."""
    target = objects().voxel_down_sample(0.02)
    source = moved(target, 8, (0.1, 0.05, 0.12))
    return {"geometries": {"source": {"geometry": source, "color": ORANGE},
                           "target": {"geometry": target, "color": BLUE}}, "legend": True}  # fmt: skip


def after_icp() -> Scene:
    """After ICP: distances to the target."""
    target = objects().voxel_down_sample(0.02).estimate_normals(radius=0.08, max_nn=20)
    source = moved(target, 8, (0.1, 0.05, 0.12))
    plane = loom.registration.TransformationEstimation.point_to_plane()
    result = loom.registration.registration_icp(source, target, 0.3, np.eye(4), plane)
    source = source.transform(result.transformation)
    source["distance"] = source.compute_point_cloud_distance(target)
    return {"geometries": {"geometry": source, "color_by": "distance", "limits": (0.0, 0.01)}, "color_bar": True}


def features() -> Scene:
    """Matches of FPFH features."""
    target = objects().voxel_down_sample(0.05).estimate_normals(radius=0.12, max_nn=30)
    source = moved(target, 60, (2.2, 0.3, 0.0))
    described = [loom.compute_fpfh_feature(cloud, radius=0.3, max_nn=100) for cloud in (source, target)]
    matches = np.asarray(loom.registration.correspondences_from_features(*described, mutual_filter=True))[::12]
    lines = loom.LineSet.create_from_point_cloud_correspondences(source, target, matches)
    return {"geometries": [source, target, lines.paint_uniform_color((0.2, 0.6, 0.2))]}


def alpha_shape() -> Scene:
    """Edges of an alpha shape."""
    mesh = loom.TriangleMesh.create_from_point_cloud_alpha_shape(clusters()[-1].voxel_down_sample(0.04), 0.15)
    return {"geometries": {"geometry": mesh, "wireframe": True}}


def ball_pivoting() -> Scene:
    """Ball pivoting."""
    thin = objects().voxel_down_sample(0.03).estimate_normals(radius=0.08, max_nn=20)
    thin = thin.orient_normals_consistent_tangent_plane(15)
    return {"geometries": loom.TriangleMesh.create_from_point_cloud_ball_pivoting(thin, [0.03, 0.06])}


def poisson() -> Scene:
    """Poisson reconstruction, colored by density."""
    oriented = objects().orient_normals_consistent_tangent_plane(15)
    mesh, densities = loom.TriangleMesh.create_from_point_cloud_poisson(oriented, 6)
    values = np.asarray(densities)
    fraction = ((values - values.min()) / np.ptp(values))[:, None]
    mesh.vertex_colors = fraction * [0.9, 0.3, 0.2] + (1 - fraction) * [0.3, 0.4, 0.8]
    mesh = mesh.remove_vertices_by_mask(values < np.quantile(values, 0.25)).compute_vertex_normals()
    return {"geometries": {"geometry": mesh, "shaded": True}}


def voxels() -> Scene:
    """Voxelization of a mesh."""
    return {"geometries": loom.TriangleMesh.create_torus(0.4, 0.15).voxelize(0.04)}


def path() -> Scene:
    """TSDF fusion and the camera trajectory."""
    poses = np.stack([frame.T_world_camera for frame in frames()])
    cameras = [{"geometry": loom.CameraFrustum(frames()[0].intrinsic, T, 0.3), "color": BLUE} for T in poses]
    return {"geometries": [room_mesh(), loom.Trajectory(poses), *cameras], "mesh_show_back_face": False}


def by_normal() -> Scene:
    """Colors by normal."""
    return {"geometries": {"geometry": room().estimate_normals(radius=0.1, max_nn=30), "color_by": "normal"}}


STEPS = (
    loading, height, normals, cropping, boxes, dbscan, planes, hidden_points, outliers, rgbd, before_icp, after_icp,
    features, alpha_shape, ball_pivoting, poisson, voxels, path, by_normal,
)  # fmt: skip


def main() -> None:
    """Draw all images."""
    rows = -(-len(STEPS) // COLUMNS)
    width, height = SIZE
    sheet = Canvas.blank(COLUMNS * width, rows * (height + TITLE), (1, 1, 1), "cpu")
    for k, step in enumerate(STEPS):
        x, y = (k % COLUMNS) * width, (k // COLUMNS) * (height + TITLE)
        sheet.image(loom.render(size=SIZE, **step()), x, y + TITLE)
        sheet.text((step.__doc__ or "").strip().rstrip("."), x + 10, y + TITLE / 2, size=14, color=(0.1, 0.1, 0.1))
    Image.fromarray(sheet.to_numpy()).save(Path(__file__).with_suffix(".jpg"), quality=88)


if __name__ == "__main__":
    main()
