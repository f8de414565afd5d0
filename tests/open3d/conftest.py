"""Folders of files that Open3D's tutorial scripts read."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
import pointloom.open3d as o3d

COUNT = 3
EVERY = 7  # keep every 7th point of the two clouds
FARTHEST = 4.0  # [m]
POLYGON = [[-0.9, 0.0, 1.2], [0.6, 0.0, 1.2], [0.8, 0.0, 2.6], [-0.7, 0.0, 2.8]]


def write_images(folder: Path, number: int, frame) -> np.ndarray:
    depth = (frame.depth * 1000).round().astype(np.uint16)
    for name, image, options in (("color/{}.jpg", frame.color, {"quality": 95}), ("depth/{}.png", depth, {})):
        path = folder / name.format(number)
        path.parent.mkdir(exist_ok=True)
        Image.fromarray(image).save(path, **options)
    return depth


@pytest.fixture
def where(device):
    """The device of a test, as Open3D names it."""
    return o3d.core.Device(device.upper())


@pytest.fixture(scope="session")
def tutorial_files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with synthetic clouds, frames, a mesh, cameras and a polygon, named as in the tutorials."""
    folder = tmp_path_factory.mktemp("tutorials")
    loom.write_point_cloud(folder / "street.pcd", loom.PointCloud(street(np.random.default_rng(1))))
    loom.write_triangle_mesh(folder / "bunny.ply", loom.datasets.object_mesh().simplify_quadric_decimation(2500))
    frames = loom.datasets.room_frames(COUNT, width=640, height=480)
    poses = []
    for i, frame in enumerate(frames):
        write_images(folder, i, frame)
        poses.append(frame.T_world_camera)
        if i < 2:
            rgbd = loom.RGBDImage.create_from_color_and_depth(frame.color, frame.depth, 1.0, 10.0, False)
            cloud = loom.PointCloud.create_from_rgbd_image(rgbd, frame.intrinsic)
            loom.write_point_cloud(folder / f"{i}.pcd", cloud.uniform_down_sample(23))
    loom.write_trajectory(folder / "trajectory.log", loom.Trajectory(np.array(poses)))
    fragment = loom.read_point_cloud(folder / "0.pcd").estimate_normals().orient_normals_towards_camera_location()
    fragment = fragment.estimate_normals().orient_normals_towards_camera_location()
    loom.write_point_cloud(folder / "fragment.ply", fragment)
    volume = {"axis_max": 4.0, "axis_min": -4.0, "bounding_polygon": POLYGON, "class_name": "SelectionPolygonVolume"}
    volume |= {"orthogonal_axis": "Y", "version_major": 1, "version_minor": 0}
    (folder / "cropped.json").write_text(json.dumps(volume))
    return folder


def street(rng: np.random.Generator) -> np.ndarray:
    """A road, a wall and cars: scanner points with some stray ones."""
    road = np.column_stack([rng.uniform(-12, 12, (3000, 2)), rng.normal(-1.6, 0.02, 3000)])
    wall = np.column_stack([rng.uniform(-12, 12, 1200), rng.normal(9, 0.02, 1200), rng.uniform(-1.2, 3, 1200)])
    cars = [rng.uniform(-0.5, 0.5, (400, 3)) * (4, 1.8, 1.4) + (x, y, -0.6) for x, y in ((-7, 3), (0, -4), (6, 2))]
    stray = rng.uniform(-12, 12, (40, 3)) * (1, 1, 0.4)
    return np.concatenate([road, wall, *cars, stray])


@pytest.fixture(scope="session")
def page_files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with three frames of a synthetic room, 320 x 240, and the files of the pipeline pages."""
    folder = tmp_path_factory.mktemp("pages")
    frames = loom.datasets.room_frames(COUNT)
    T_first_world = np.linalg.inv(frames[0].T_world_camera)
    poses = np.array([T_first_world @ frame.T_world_camera for frame in frames])
    camera = frames[0].intrinsic
    volume = loom.TSDFVolume(voxel_size=0.05, truncation=0.2)
    for i, frame in enumerate(frames):
        depth = write_images(folder, i, frame)
        volume.integrate(depth, camera, np.linalg.inv(poses[i]), frame.color, depth_max=FARTHEST)
        if i < 2:
            rgbd = loom.RGBDImage.create_from_color_and_depth(frame.color, depth, 1000.0, FARTHEST, False)
            cloud = loom.PointCloud.create_from_rgbd_image(rgbd, camera)
            loom.write_point_cloud(folder / f"{i}.pcd", cloud.uniform_down_sample(EVERY))
    camera.write(folder / "camera.json")
    path = loom.Trajectory(poses)
    loom.write_trajectory(folder / "trajectory.log", path)
    loom.write_trajectory(folder / "cameras.json", path, intrinsic=camera)
    loom.write_triangle_mesh(folder / "room.ply", volume.extract_triangle_mesh(0))
    option = o3d.visualization.RenderOption()
    option.point_size, option.background_color, option.show_coordinate_frame = 2.0, (0.1, 0.2, 0.3), True
    option.save_to_json(folder / "renderoption.json")
    return folder
