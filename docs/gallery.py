"""A picture for each chapter of the tutorial: `python docs/gallery.py` draws them all into docs/gallery.png.

Everything is made up: the furnished room, seen by a camera, and shapes. Each function returns what `loom.render` takes.
"""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import Any

import numpy as np

import pointloom as loom
from pointloom.app.pictures.canvas import Canvas
from pointloom.app.pictures.picture_files import save_picture
from pointloom.app.room import room_sequence

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.651, 0.929)
SIZE = (480, 360)  # [px] of a picture
COLUMNS = 3

Scene = dict[str, Any]


@functools.cache
def frames() -> list[Any]:
    """Four frames of a walk through the room, without noise."""
    sequence = room_sequence(24, width=200, height=150, noise=False)
    return [sequence.read(index) for index in (0, 1, 2, 3)]


@functools.cache
def frame_cloud(index: int) -> loom.PointCloud:
    """What a frame shows, in the room's coordinates."""
    frame = frames()[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_scale=1.0, depth_trunc=6.0)
    return loom.PointCloud.from_rgbd_image(image, frame.intrinsic, np.linalg.inv(frame.T_world_camera))


@functools.cache
def room() -> loom.PointCloud:
    """The four frames in one cloud."""
    return loom.PointCloud.concatenate([frame_cloud(index) for index in range(4)])


@functools.cache
def room_mesh() -> loom.TriangleMesh:
    """The four frames fused."""
    volume = loom.TSDFVolume(0.03, 0.12)
    for frame in frames():
        T = np.linalg.inv(frame.T_world_camera)
        volume.integrate(frame.depth, frame.intrinsic, T, frame.color, depth_scale=1.0, depth_max=6.0)
    return volume.extract_triangle_mesh(weight_threshold=0.5)


@functools.cache
def solids() -> loom.PointCloud:
    """A ball, a ring and a block on a floor, 30,000 points with normals."""
    block = loom.TriangleMesh.create_box(0.5, 0.5, 0.5).translate([0.6, -0.2, 0.0])
    ball = loom.TriangleMesh.create_sphere(0.35).translate([-0.5, 0.5, 0.35])
    ring = loom.TriangleMesh.create_torus(0.4, 0.12).translate([-0.4, -0.5, 0.12])
    floor = loom.TriangleMesh.create_plane(2.4, 2.4).translate([-1.2, -1.2, 0.0])
    counts = (6000, 6000, 6000, 12000)
    return loom.PointCloud.concatenate(
        [mesh.sample_points_uniformly(n, seed=1) for mesh, n in zip((block, ball, ring, floor), counts, strict=True)]
    )


@functools.cache
def objects() -> loom.PointCloud:
    """The three without the floor."""
    return solids().select_by_mask(solids().points[:, 2] > 0.01)


def loading() -> Scene:
    """1 Load a cloud and look at it."""
    return {"geometries": room()}


def looking_with_a_view() -> Scene:
    """1 The same from a view of Open3D's, colours by height."""
    return {"geometries": {"geometry": room(), "color_by": "height"}, "color_bar": True,
            "camera": {"zoom": 0.5, "front": [0.6, -0.5, 0.7], "up": [0, 0, 1]}}  # fmt: skip


def down_sampling() -> Scene:
    """2 Down-sample by voxels and estimate normals."""
    thin = objects().voxel_down_sample(0.06).estimate_normals(radius=0.15, max_nn=30)
    return {"geometries": thin, "point_show_normal": True, "point_size": 4.0}


def cropping() -> Scene:
    """3 Crop, paint, measure distances: the ball, and how far the rest lies from it."""
    box = loom.AxisAlignedBoundingBox([-0.9, 0.1, 0.01], [-0.1, 0.9, 0.8])
    ball = solids().crop(box)
    rest = solids().select_by_index(box.get_point_indices_within_bounding_box(solids().points), invert=True)
    rest["distance"] = rest.compute_point_cloud_distance(ball)
    return {"geometries": [{"geometry": ball.paint_uniform_color(ORANGE), "name": "ball"}, box,
                           {"geometry": rest, "color_by": "distance", "colormap": "turbo"}], "color_bar": True}  # fmt: skip


def boxes_and_hulls() -> Scene:
    """4 Boxes and hulls."""
    labels = np.asarray(objects().cluster_dbscan(0.08, 8))
    parts = [objects().select_by_mask(labels == label) for label in range(labels.max() + 1)]
    drawn: list[Any] = [objects().paint_uniform_color((0.6, 0.6, 0.6))]
    for part in parts:
        drawn.append({"geometry": part.get_axis_aligned_bounding_box(), "color": (0.85, 0.1, 0.1)})
        drawn.append({"geometry": part.get_minimal_oriented_bounding_box(), "color": (0.1, 0.6, 0.1)})
    hull, _ = parts[-1].compute_convex_hull()
    drawn.append({"geometry": hull, "wireframe": True, "color": BLUE})
    return {"geometries": drawn}


def clustering() -> Scene:
    """4 DBSCAN, with its labels."""
    cloud = objects()
    cloud["label"] = np.asarray(cloud.cluster_dbscan(0.08, 8))
    places = [cloud.select_by_mask(cloud["label"] == k).points.mean(axis=0) + [0, 0, 0.45] for k in range(3)]
    names = [f"cluster {k}" for k in range(3)]
    return {"geometries": {"geometry": cloud, "color_by": "label"}, "labels": list(zip(names, places, strict=True)),
            "color_bar": True}  # fmt: skip


def planes() -> Scene:
    """4 The plane of the floor."""
    _, inliers = solids().segment_plane(0.01, 3, 200)
    floor = solids().select_by_index(inliers).paint_uniform_color((0.9, 0.2, 0.2))
    rest = solids().select_by_index(inliers, invert=True).paint_uniform_color((0.45, 0.5, 0.55))
    return {"geometries": {"plane": floor, "rest": rest}, "legend": True}


def outliers() -> Scene:
    """5 Statistical outliers in red."""
    rng = np.random.default_rng(3)
    noisy = loom.PointCloud(np.vstack([objects().points, rng.uniform([-1.2, -1.2, 0], [1.2, 1.2, 1.2], (300, 3))]))
    kept, rows = noisy.remove_statistical_outlier(20, 2.0)
    lost = noisy.select_by_index(rows, invert=True)
    return {"geometries": {"inliers": kept.paint_uniform_color((0.6, 0.6, 0.6)),
                           "outliers": {"geometry": lost, "color": (0.9, 0.1, 0.1), "point_size": 5.0}},
            "legend": True}  # fmt: skip


def rgbd() -> Scene:
    """6 An RGB-D frame as a cloud, and its camera."""
    frame = frames()[0]
    return {"geometries": [frame_cloud(0), loom.CameraFrustum(frame.intrinsic, frame.T_world_camera, 0.4)]}


def pairs() -> Scene:
    """8 Two clouds that ICP brings together, and the pairs that it begins with."""
    T = np.eye(4)
    angle = math.radians(8)
    T[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
    T[:3, 3] = [0.1, 0.05, 0.12]
    target = objects().voxel_down_sample(0.03)
    source = target.transform(T)
    nearest, _ = loom.NearestNeighborSearch(target).knn_search(source.points, 1)
    rows = np.arange(0, len(source.points), 40)
    lines = loom.LineSet.create_from_point_cloud_correspondences(
        source, target, np.column_stack([rows, np.asarray(nearest).ravel()[rows]])
    )
    return {"geometries": {"source": {"geometry": source, "color": ORANGE},
                           "target": {"geometry": target, "color": BLUE},
                           "pairs": lines.paint_uniform_color((0.2, 0.2, 0.2))}, "legend": True}  # fmt: skip


def surfaces() -> Scene:
    """10 A surface through points, its edges and its error."""
    ball = loom.TriangleMesh.create_sphere(0.35, resolution=10).translate([-0.45, 0, 0])
    smooth = loom.TriangleMesh.create_torus(0.3, 0.12).compute_vertex_normals().translate([0.45, 0, 0])
    return {"geometries": [{"geometry": ball, "wireframe": True}, {"geometry": smooth, "color": (0.5, 0.62, 0.75)}]}


def voxels() -> Scene:
    """10 Voxels of a cloud."""
    grid = loom.VoxelGrid.create_from_point_cloud(room(), 0.12)
    return {"geometries": grid}


def path() -> Scene:
    """11 Frames fused along the camera's path."""
    poses = np.stack([frame.T_world_camera for frame in frames()])
    cameras = [{"geometry": loom.CameraFrustum(frames()[0].intrinsic, T, 0.3), "color": BLUE} for T in poses]
    return {"geometries": [room_mesh(), loom.Trajectory(poses), *cameras], "mesh_show_back_face": False}


CHAPTERS = (
    loading, looking_with_a_view, down_sampling, cropping, boxes_and_hulls, clustering, planes, outliers, rgbd, pairs,
    surfaces, voxels, path,
)  # fmt: skip


def main() -> None:
    """Draw the sheet."""
    rows = -(-len(CHAPTERS) // COLUMNS)
    width, height = SIZE
    sheet = Canvas.blank(COLUMNS * width, rows * (height + 28), (1, 1, 1), "cpu")
    for k, chapter in enumerate(CHAPTERS):
        picture = loom.render(size=SIZE, **chapter())
        x, y = (k % COLUMNS) * width, (k // COLUMNS) * (height + 28)
        sheet.image(picture, x, y + 28)
        sheet.text((chapter.__doc__ or "").strip().rstrip("."), x + 10, y + 14, size=12, color=(0.1, 0.1, 0.1))
    save_picture(Path(__file__).with_suffix(".png"), sheet.to_numpy())


if __name__ == "__main__":
    main()
