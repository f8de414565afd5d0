"""register_stations on real scans with published poses: differences and warnings.

    POINTLOOM_DATA=<folder> python benchmarks/real_stations.py       # some minutes; the table of docs/stations.md

No terrestrial data set with a surveyor's ground truth is available. The data are the Stanford bunny's range scans
(poses
by ICP of its authors), views of a kitchen by a depth camera (poses of KinectFusion, accurate to some centimeters), and
five LiDAR maps of a street (poses of another pose graph). Rough poses are these with random offsets. Errors are
position
differences of stations relative to the reference station.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from real_data import real_data
from scipy.spatial.transform import Rotation

import pointloom as loom

Array = np.ndarray
VIEWS = range(0, 300, 33)


def pose_of(position: Array, quaternion: Array, *, inverse: bool = False) -> Array:
    """A pose from a position and a quaternion (x, y, z, w)."""
    R = Rotation.from_quat(quaternion).as_matrix()
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R.T if inverse else R, position
    return T


def bunny(folder: Path) -> tuple[list[Any], Array]:
    """Range scans; their quaternions are inverse rotations."""
    clouds, poses = [], []
    for line in (folder / "reg-bunny-scans/data/bun.conf").read_text().splitlines():
        words = line.split()
        if words and words[0] == "bmesh":
            numbers = np.array(words[2:], float)
            clouds.append(loom.read_point_cloud(folder / "reg-bunny-scans/data" / words[1]))
            poses.append(pose_of(numbers[:3], numbers[3:], inverse=True))
    return clouds, np.array(poses)


def kitchen(folder: Path) -> tuple[list[Any], Array]:
    """Views of a depth camera as stations."""
    data, clouds, poses = folder / "rgbd-7scenes-redkitchen", [], []
    import cv2

    for k in VIEWS:
        depth = cv2.imread(str(data / f"frame-{k:06d}.depth.png"), cv2.IMREAD_UNCHANGED)
        v, u = np.nonzero((depth > 0) & (depth < 4000))
        z = depth[v, u] / 1000.0
        clouds.append(loom.PointCloud(np.column_stack([(u - 320) * z / 585, (v - 240) * z / 585, z])))
        poses.append(np.loadtxt(data / f"frame-{k:06d}.pose.txt"))
    return clouds, np.array(poses)


def street(folder: Path) -> tuple[list[Any], Array]:
    """LiDAR maps of a street."""
    data, clouds, poses = folder / "reg-gtsam-points/kitti_07_dump", [], []
    for line in (data / "graph.txt").read_text().splitlines():
        words = line.split()
        if words and words[0].startswith("v"):
            numbers = np.array(words[1:], float)
            points = np.fromfile(data / f"{int(words[0][1:]):06d}" / "points.bin", np.float32).reshape(-1, 3)
            clouds.append(loom.PointCloud(points.astype(np.float64)))
            poses.append(pose_of(numbers[:3], numbers[3:]))
    return clouds, np.array(poses)


# name: reader, voxel size [m], offsets of rough poses [m], [rad]
SETS: dict[str, tuple[Callable[[Path], tuple[list[Any], Array]], float, float, float]] = {
    "bunny's scans": (bunny, 0.0015, 0.002, 0.02),
    "kitchen": (kitchen, 0.05, 0.05, 0.03),
    "street": (street, 0.5, 0.5, 0.03),
}


def measure(clouds: list[Any], truth: Array, voxel: float, shift: float, angle: float, seed: int) -> str:
    """One row of the table."""
    rng, rough = np.random.default_rng(seed), truth.copy()
    for T in rough[1:]:
        T[:3, :3] = Rotation.from_rotvec(rng.normal(0, angle, 3)).as_matrix() @ T[:3, :3]
        T[:3, 3] += rng.normal(0, shift, 3)
    start = time.process_time()
    options: dict[str, Any] = {"poses": rough, "voxel_size": voxel, "level": False, "rough": 6 * shift}
    result = loom.registration.register_stations(clouds, **options)
    seconds = time.process_time() - start
    aligned = truth[0] @ np.linalg.inv(result.poses[0]) @ result.poses
    errors = np.linalg.norm((aligned - truth)[result.placed, :3, 3], axis=1)[1:] * 1000
    begin = np.linalg.norm((rough - truth)[1:, :3, 3], axis=1) * 1000
    expected = np.sqrt((result.sigmas[result.placed, :3] ** 2).sum(axis=1))[1:] * 1000
    figures = f"{result.placed.sum()} of {len(clouds)} | {len(result.pairs)} | {np.median(begin):.1f}"
    figures += f" | {np.median(errors):.2f} | {errors.max():.2f} | {np.median(expected):.2f} | {result.sigma0:.2f}"
    return f"{figures} | {len(result.outliers)} | {seconds:.0f} | {'; '.join(result.warnings) or 'none'} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", nargs="+", default=list(SETS))
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    print("| set | placed | pairs | rough [mm] | error | largest | sigma | sigma0 | outliers | CPU [s] | warnings |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for name in options.sets:
        read, *numbers = SETS[name]
        try:
            clouds, truth = read(real_data())
        except OSError as error:
            print(f"{name} left out: {error}")
            continue
        print(f"| {name} | {measure(clouds, truth, *numbers, options.seed)}", flush=True)


if __name__ == "__main__":
    main()
