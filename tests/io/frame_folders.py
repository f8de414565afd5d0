"""Folders of three small frames in each layout; frame k is at x = k meters, and its color is k."""

from pathlib import Path

import numpy as np
from PIL import Image

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.io.pictures.image_files import write_png

SMALL = PinholeCameraIntrinsic(8, 6, 7.0, 7.0, 3.5, 2.5)
LAYOUTS = ["7scenes", "redwood", "tum"]


def pose(x: float) -> np.ndarray:
    T_world_camera = np.eye(4)
    T_world_camera[0, 3] = x
    return T_world_camera


def depth_map(value: int, shape=(6, 8)) -> np.ndarray:
    return np.full(shape, value, np.uint16)


def picture(value: int, shape=(6, 8, 3)) -> np.ndarray:
    return np.full(shape, value, np.uint8)


def make_seven_scenes(folder: Path, count: int = 3) -> Path:
    folder.mkdir()
    for i in range(count):
        write_png(folder / f"frame-{i:06d}.depth.png", depth_map(1000 + i))
        write_png(folder / f"frame-{i:06d}.color.png", picture(i))
        np.savetxt(folder / f"frame-{i:06d}.pose.txt", pose(i))
    return folder


def make_redwood(folder: Path, count: int = 3) -> Path:
    for name in ("depth", "color"):
        (folder / name).mkdir(parents=True)
    for i in range(count):
        write_png(folder / "depth" / f"{i:05d}.png", depth_map(1000 + i))
        Image.fromarray(picture(i)).save(folder / "color" / f"{i:05d}.jpg")
    write_log(folder, range(count))
    return folder


def write_log(folder: Path, ids) -> None:
    """Write a log in which pose k is at x = k meters."""
    ids = np.array([[i, i, i + 1] for i in ids])
    write_trajectory(folder / "trajectory.log", Trajectory(np.array([pose(k) for k in range(len(ids))]), ids=ids))


def make_tum(folder: Path, count: int = 3) -> Path:
    for name in ("depth", "rgb"):
        (folder / name).mkdir(parents=True)
    depth_times = [100 + 0.1 * i for i in range(count)]
    color_times = [time + 0.012 for time in depth_times]
    for i in range(count):
        write_png(folder / "depth" / f"{depth_times[i]:.6f}.png", depth_map(5000 + i))
        write_png(folder / "rgb" / f"{color_times[i]:.6f}.png", picture(i))
    write_listing(folder, "depth", depth_times)
    write_listing(folder, "rgb", color_times)
    write_poses(folder, [(time + 0.004, i) for i, time in enumerate(depth_times)])
    return folder


def write_listing(folder: Path, name: str, times) -> None:
    lines = [f"{time:.6f} {name}/{time:.6f}.png" for time in times]
    (folder / f"{name}.txt").write_text("\n".join(["# pictures", "# timestamp filename", *lines, ""]))


def write_poses(folder: Path, entries) -> None:
    poses = Trajectory(np.array([pose(x) for _, x in entries]), timestamps=np.array([time for time, _ in entries]))
    write_trajectory(folder / "groundtruth.txt", poses, format="tum")


def make(layout: str, folder: Path, count: int = 3) -> Path:
    return {"7scenes": make_seven_scenes, "redwood": make_redwood, "tum": make_tum}[layout](folder, count)
