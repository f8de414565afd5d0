"""A folder with what the scripts of Open3D's pages on pipelines read: three frames of a made room, 320 x 240."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import pointloom as loom

COUNT = 3
EVERY = 7  # points of the two clouds
FARTHEST = 4.0  # [m]


def write_pipeline_files(folder: Path) -> NDArray[np.float64]:
    """Write them; gives the true poses, camera to the world of the first camera."""
    frames = loom.data.room_frames(COUNT)
    T_first_world = np.linalg.inv(frames[0].T_world_camera)
    poses = np.array([T_first_world @ frame.T_world_camera for frame in frames])
    camera = frames[0].intrinsic
    for name in ("color", "depth"):
        (folder / name).mkdir()
    volume = loom.TSDFVolume(voxel_size=0.05, truncation=0.2)
    for i, frame in enumerate(frames):
        depth = (frame.depth * 1000).round().astype(np.uint16)
        Image.fromarray(frame.color).save(folder / f"color/{i}.jpg", quality=95)
        Image.fromarray(depth).save(folder / f"depth/{i}.png")
        volume.integrate(depth, camera, np.linalg.inv(poses[i]), frame.color, depth_max=FARTHEST)
        if i < 2:
            rgbd = loom.RGBDImage.from_color_and_depth(frame.color, depth, 1000.0, FARTHEST, False)
            cloud = loom.PointCloud.from_rgbd_image(rgbd, camera)
            loom.write_point_cloud(folder / f"{i}.pcd", cloud.uniform_down_sample(EVERY))
    loom.write_pinhole_camera_intrinsic(folder / "camera.json", camera)
    path = loom.Trajectory(poses)
    loom.write_trajectory(folder / "trajectory.log", path)
    loom.write_trajectory(folder / "cameras.json", path, intrinsic=camera)
    loom.write_triangle_mesh(folder / "room.ply", volume.extract_triangle_mesh(0))
    return poses
