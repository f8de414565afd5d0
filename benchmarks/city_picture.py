"""Draw the map of a city drive with odometry alone and with loops, for the documentation.

    python benchmarks/city_picture.py docs/loops.png

The scans have no point times here, so the odometry cannot deskew them and drifts by meters.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from city import CityDrive, Scenario, load_drive
from numpy.typing import NDArray
from PIL import Image

import pointloom as loom

Array = NDArray[np.float64]

SCENARIO = Scenario("loop", "16")
VOXEL, NEAR = 0.2, 45.0  # [m] spacing of the drawn points, and their largest distance from the scanner
HEIGHTS = (-2.0, 10.0)  # [m] ends of the colors
SIZE, GAP = (640, 380), 8  # [px] of each of the four views
PATH, LOOP = (0.84, 0.1, 0.1), (0.94, 0.2, 0.9)
WHITE, FRAME = (1.0, 1.0, 1.0), (0.1, 0.3, 0.9)
FIELD = np.radians(20)  # of the cameras
EXTENT = 340.0  # [m] shown width of the upper views
CLOSE_UP = 106.0, -3.0, 26.0  # [m] x, y of the center of the lower views, and their width
TILT = np.radians(25)
COLORS = 128  # of the file, a quarter of its size


@dataclass(frozen=True)
class CityPath:
    """Poses of a drive, and pairs of scans that loops connect."""

    title: str
    poses: Array
    loops: list[tuple[int, int]]


def run(drive: CityDrive) -> tuple[CityPath, CityPath]:
    slam = loom.registration.LidarSLAM(max_range=100.0, min_range=2.0)
    for points in drive.scans:
        slam.register(loom.PointCloud(points))
    slam.finish()
    firsts = [submap.first_scan for submap in slam.submaps]
    loops = [(firsts[loop.source], firsts[loop.target]) for loop in slam.loops if loop.reliable]
    before = CityPath("odometry alone: the street is doubled", slam.odometry.poses, [])
    return before, CityPath("LidarSLAM: the loops close the gap", slam.poses, loops)


def map_of(drive: CityDrive, path: CityPath) -> loom.PointCloud:
    parts = []
    for points, T in zip(drive.scans, path.poses, strict=True):
        near = points[np.linalg.norm(points, axis=1) < NEAR][::2]
        parts.append(near @ T[:3, :3].T + T[:3, 3])
    return loom.PointCloud(np.concatenate(parts)).voxel_down_sample(VOXEL)


def lines_of(points: Array, color: tuple[float, float, float], width: float) -> dict[str, Any]:
    """Lines between pairs of points [2 n, 3]."""
    lines = np.arange(len(points), dtype=np.int32).reshape(-1, 2)
    return {"geometry": loom.LineSet(points, lines), "color": color, "line_width": width}


def camera(center: Array, extent: float, tilt: float) -> loom.View:
    """A camera above a point that shows this width [m], tilted to the south [rad]."""
    width, height = SIZE
    focal = width / 2 / np.tan(FIELD / 2)
    front = np.array([0.0, -np.sin(tilt), np.cos(tilt)])
    right, T = np.array([1.0, 0.0, 0.0]), np.eye(4)
    T[:3, :3] = np.column_stack([right, np.cross(-front, right), -front])
    T[:3, 3] = center + extent / 2 / np.tan(FIELD / 2) * front
    pinhole = loom.PinholeCameraIntrinsic(width, height, focal, focal, width / 2, height / 2)
    return loom.View(pinhole, T)


def draw(cloud: loom.PointCloud, path: CityPath, close: bool) -> NDArray[np.uint8]:
    """The map from above: all of it, or the street that is driven twice."""
    positions = path.poses[:, :3, 3]
    above = np.array([0.0, 0.0, 0.5 if close else 12.0])  # [m] from afar, no roof hides the lines
    scene: list[Any] = [
        {"geometry": cloud, "color_by": "height", "limits": HEIGHTS, "point_size": 5 if close else 2},
        lines_of(np.repeat(positions + above, 2, axis=0)[1:-1], PATH, 3.0),
    ]
    if path.loops:
        scene.append(lines_of(np.array([positions[k] + above for pair in path.loops for k in pair]), LOOP, 3.0))
    if close:
        center, extent, legend = np.array([*CLOSE_UP[:2], 0.0]), CLOSE_UP[2], None
    else:
        low, high = np.quantile(cloud.points, (0.0, 1.0), axis=0)
        center, extent = (low + high) / 2 - [12.0, 0.0, 0.0], EXTENT  # leaves room for the legend
        corners = CLOSE_UP[2] / 2 * np.array([[-1, -0.56], [1, -0.56], [1, 0.56], [-1, 0.56]]) + CLOSE_UP[:2]
        box = np.column_stack([corners, np.full(4, 14.0)])[[0, 1, 2, 3, 0]]
        scene.append(lines_of(np.repeat(box, 2, axis=0)[1:-1], FRAME, 3.0))
        legend = [(path.title, WHITE), ("path", PATH), *[("loops", LOOP)] * bool(path.loops), ("detail below", FRAME)]
    return np.asarray(
        loom.render(scene, camera(center, extent, TILT if close else 0.0), legend=legend, scale_bar=not close)
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", type=Path)
    picture = parser.parse_args().picture
    drive = load_drive(SCENARIO)
    write(drive, run(drive), picture)


def write(drive: CityDrive, paths: tuple[CityPath, ...], picture: Path) -> None:
    columns = []
    for path in paths:
        cloud = map_of(drive, path)
        views = [draw(cloud, path, close) for close in (False, True)]
        columns.append(np.concatenate([views[0], np.full((GAP, SIZE[0], 3), 255, np.uint8), views[1]]))
    gap = np.full((len(columns[0]), GAP, 3), 255, np.uint8)
    drawn = Image.fromarray(np.concatenate([columns[0], gap, columns[1]], axis=1))
    drawn.quantize(COLORS, dither=Image.Dither.NONE).save(picture, optimize=True)


if __name__ == "__main__":
    main()
