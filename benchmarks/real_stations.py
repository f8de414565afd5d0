"""register_stations on real scans whose poses others have found: the differences, and its warnings.

    POINTLOOM_DATA=<folder> python benchmarks/real_stations.py       # some minutes; the table of docs/stations.md

No terrestrial set with a surveyor's truth is here. In its place stand the Stanford bunny's range scans (poses by ICP of
its authors), views of a kitchen by a depth camera (poses of KinectFusion, which are known to some centimeters), and
five LiDAR maps of a street (poses of a graph of others). Rough poses are theirs, put off at random. Errors are of
stations' positions against theirs, relative to the reference station.
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


def pose_of(place: Array, quaternion: Array, *, turned_back: bool = False) -> Array:
    """A pose of a place and a quaternion (x, y, z, w)."""
    R = Rotation.from_quat(quaternion).as_matrix()
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R.T if turned_back else R, place
    return T


def bunny(folder: Path) -> tuple[list[Any], Array]:
    """Range scans; their quaternions turn the other way."""
    clouds, poses = [], []
    for line in (folder / "reg-bunny-scans/data/bun.conf").read_text().splitlines():
        words = line.split()
        if words and words[0] == "bmesh":
            numbers = np.array(words[2:], float)
            clouds.append(loom.read_point_cloud(folder / "reg-bunny-scans/data" / words[1]))
            poses.append(pose_of(numbers[:3], numbers[3:], turned_back=True))
    return clouds, np.array(poses)


def kitchen(folder: Path) -> tuple[list[Any], Array]:
    """Views of a depth camera, each as a station."""
    there, clouds, poses = folder / "rgbd-7scenes-redkitchen", [], []
    import cv2

    for k in VIEWS:
        depth = cv2.imread(str(there / f"frame-{k:06d}.depth.png"), cv2.IMREAD_UNCHANGED)
        v, u = np.nonzero((depth > 0) & (depth < 4000))
        z = depth[v, u] / 1000.0
        clouds.append(loom.PointCloud(np.column_stack([(u - 320) * z / 585, (v - 240) * z / 585, z])))
        poses.append(np.loadtxt(there / f"frame-{k:06d}.pose.txt"))
    return clouds, np.array(poses)


def street(folder: Path) -> tuple[list[Any], Array]:
    """Maps of a LiDAR on a street."""
    there, clouds, poses = folder / "reg-gtsam-points/kitti_07_dump", [], []
    for line in (there / "graph.txt").read_text().splitlines():
        words = line.split()
        if words and words[0].startswith("v"):
            numbers = np.array(words[1:], float)
            points = np.fromfile(there / f"{int(words[0][1:]):06d}" / "points.bin", np.float32).reshape(-1, 3)
            clouds.append(loom.PointCloud(points.astype(np.float64)))
            poses.append(pose_of(numbers[:3], numbers[3:]))
    return clouds, np.array(poses)


# name: reader, voxel [m], how far rough poses are off [m], [rad]
SETS: dict[str, tuple[Callable[[Path], tuple[list[Any], Array]], float, float, float]] = {
    "bunny's scans": (bunny, 0.0015, 0.002, 0.02),
    "kitchen": (kitchen, 0.05, 0.05, 0.03),
    "street": (street, 0.5, 0.5, 0.03),
}


def measure(clouds: list[Any], truth: Array, voxel: float, shift: float, turn: float, seed: int) -> str:
    """One row."""
    rng, rough = np.random.default_rng(seed), truth.copy()
    for T in rough[1:]:
        T[:3, :3] = Rotation.from_rotvec(rng.normal(0, turn, 3)).as_matrix() @ T[:3, :3]
        T[:3, 3] += rng.normal(0, shift, 3)
    start = time.process_time()
    options: dict[str, Any] = {"poses": rough, "voxel_size": voxel, "level": False, "rough": 6 * shift}
    found = loom.registration.register_stations(clouds, **options)
    spent = time.process_time() - start
    there = truth[0] @ np.linalg.inv(found.poses[0]) @ found.poses
    errors = np.linalg.norm((there - truth)[found.placed, :3, 3], axis=1)[1:] * 1000
    begin = np.linalg.norm((rough - truth)[1:, :3, 3], axis=1) * 1000
    said = np.sqrt((found.sigmas[found.placed, :3] ** 2).sum(axis=1))[1:] * 1000
    figures = f"{found.placed.sum()} of {len(clouds)} | {len(found.pairs)} | {np.median(begin):.1f}"
    figures += f" | {np.median(errors):.2f} | {errors.max():.2f} | {np.median(said):.2f} | {found.sigma0:.2f}"
    return f"{figures} | {len(found.outliers)} | {spent:.0f} | {'; '.join(found.warnings) or 'none'} |"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", nargs="+", default=list(SETS))
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    print(
        "| set | placed | pairs | rough [mm] | off, median | largest | said | sigma0 | taken out | CPU [s] | warnings |"
    )
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
