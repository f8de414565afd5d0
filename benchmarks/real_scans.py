"""Pairs of real scans with their true poses, from the folder `POINTLOOM_DATA`, and random starting poses."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from real_data import real_data
from scipy.spatial.transform import Rotation

Array = NDArray[np.float64]
NEAR = (5.0, 3.0)  # [degrees] and, at the center of the source, [voxels]: maximum errors of a correct pose
BUNNY_SCANS = ("bun000", "bun045", "bun090", "bun180", "bun270", "bun315", "chin", "ear_back", "top2", "top3")


@dataclass(frozen=True)
class ScanPair:
    """Two clouds, the pose between them, and parameters for registration.

    Attributes:
        name: Name in the tables.
        source, target: Points, float64 [n, 3].
        T: The true T_target_source.
        voxel_size: Voxel size for global registration [m].
        fine: Voxel size for ICP [m]; 0 for all points.
        distance: Maximum correspondence distance of ICP [m].
        spread: Range of the translations of random starting poses [m].
        unit: Name and scale of the distance unit in tables; empty if unknown.
    """

    name: str
    source: Array
    target: Array
    T: Array
    voxel_size: float
    fine: float
    distance: float
    spread: float
    unit: tuple[str, float] = ("cm", 100.0)

    def moved(self, start: Array) -> ScanPair:
        """The pair with its source moved."""
        source = self.source @ start[:3, :3].T + start[:3, 3]
        return replace(self, source=source, T=self.T @ np.linalg.inv(start))

    def error(self, estimate: Array) -> tuple[float, float, bool]:
        """Rotation error [degrees], translation error [m], and whether ICP would converge from there."""
        from pointloom.registration.rigid import pose_error

        angle, distance = pose_error(estimate, self.T)
        middle = np.append(self.source.mean(axis=0), 1)
        shift = np.linalg.norm((estimate - self.T)[:3] @ middle)
        return np.degrees(angle), distance, bool(np.degrees(angle) < NEAR[0] and shift < NEAR[1] * self.voxel_size)


def folder() -> Path:
    """The data folder."""
    return real_data()


def pose_of(rotation: Rotation, translation: Array) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation.as_matrix(), translation
    return T


def random_poses(count: int, spread: float, seed: int = 0) -> list[Array]:
    """Uniformly random rotations, and translations up to the spread along each axis."""
    rng = np.random.default_rng(seed)
    rotations = [Rotation.from_quat(rng.normal(size=4)) for _ in range(count)]
    return [pose_of(rotation, rng.uniform(-spread, spread, 3)) for rotation in rotations]


def rotation_of(T: Array) -> Array:
    """A pose without its translation."""
    return pose_of(Rotation.from_matrix(T[:3, :3]), np.zeros(3))


def points_of(path: Path) -> Array:
    """The finite points of a file."""
    import pointloom as loom

    points = loom.read_point_cloud(path).points
    return points[np.isfinite(points).all(axis=1)]


def lidar() -> ScanPair:
    """Two LiDAR scans of a street; the ground truth is another estimate, accurate to about 0.2 degrees and 2 cm."""
    at = folder() / "reg-small-gicp"
    source, target = (points_of(at / f"{name}.ply") for name in ("source", "target"))
    T = np.loadtxt(at / "T_target_source.txt")
    return ScanPair("LiDAR scans", source, target, T, 0.5, 0.25, 1.0, 20.0)


def kitchen() -> ScanPair:
    """Two fragments of a room with 55 % overlap."""
    at = folder() / "reg-teaser-3dmatch" / "data"
    source, target = (points_of(at / f"cloud_bin_{k}.ply") for k in (4, 0))
    return ScanPair("kitchen", source, target, np.loadtxt(at / "T_0_from_4.txt"), 0.05, 0.025, 0.1, 3.0)


def submaps() -> Iterator[ScanPair]:
    """All pairs of five submaps in a curve of a street, up to 88 degrees and 28 m apart."""
    at = folder() / "reg-gtsam-points" / "kitti_07_dump"
    poses = []
    for line in (at / "graph.txt").read_text().splitlines():
        if line.startswith("v"):
            numbers = np.array(line.split()[1:], float)
            poses.append(pose_of(Rotation.from_quat(numbers[3:]), numbers[:3]))
    clouds = [
        np.fromfile(at / f"{k:06d}" / "points.bin", np.float32).reshape(-1, 3).astype(float) for k in range(len(poses))
    ]
    for i, j in itertools.combinations(range(len(poses)), 2):
        T = np.linalg.inv(poses[i]) @ poses[j]
        yield ScanPair(f"submaps {i} and {j}", clouds[j], clouds[i], T, 0.5, 0.0, 1.0, 50.0)


def gap_of(pair: ScanPair) -> int:
    """Difference between the indices of a pair's submaps."""
    first, second = (int(word) for word in pair.name.split()[1::2])
    return second - first


def dragon() -> ScanPair:
    """A cloud and its rigid copy, in an unknown unit; the ground truth is the best fit of their rows."""
    from pointloom.registration.rigid import fit_pose

    at = folder() / "reg-simpleicp"
    source, target = (np.loadtxt(at / f"dragon{k}.xyz") for k in (2, 1))
    return ScanPair("dragon", source, target, fit_pose(source, target), 0.5, 0.0, 1.0, 30.0, ("", 1.0))


def bunny_parts() -> ScanPair:
    """Two parts with a third in common; no ground truth is given, but the estimated poses are about ten degrees
    around z.
    """
    at = folder() / "reg-simpleicp"
    source, target = (np.loadtxt(at / f"bunny_part{k}.xyz") for k in (2, 1))
    T = pose_of(Rotation.from_rotvec([0, 0, np.radians(10)]), np.zeros(3))
    return ScanPair("bunny parts", source, target, T, 0.2, 0.0, 0.4, 30.0, ("", 1.0))


def bunny_poses() -> dict[str, Array]:
    """The poses of the bunny's range scans."""
    poses = {}
    for line in (folder() / "reg-bunny-scans" / "data" / "bun.conf").read_text().splitlines():
        words = line.split()
        if words and words[0] == "bmesh":
            numbers = np.array(words[2:], float)
            rotation = Rotation.from_quat(numbers[3:] * [-1, -1, -1, 1])  # the file contains the inverse rotation
            poses[words[1].removesuffix(".ply")] = pose_of(rotation, numbers[:3])
    return poses


def bunny_scan(name: str) -> Array:
    return points_of(folder() / "reg-bunny-scans" / "data" / f"{name}.ply")


def bunny_pair(source: str = "bun000", target: str = "bun045") -> ScanPair:
    """Two range scans of the bunny."""
    poses = bunny_poses()
    T = np.linalg.inv(poses[target]) @ poses[source]
    name = f"{source} and {target}"
    clouds = bunny_scan(source), bunny_scan(target)
    return ScanPair(name, *clouds, T, 0.003, 0.0, 0.01, 0.2, ("mm", 1000.0))


def sparse_bunnies() -> ScanPair:
    """About 400 points of each of two scans, 34 degrees apart."""
    poses, at = bunny_poses(), folder() / "pcl-tests" / "test"
    T = np.linalg.inv(poses["bun045"]) @ poses["bun000"]
    source, target = points_of(at / "bun0.pcd"), points_of(at / "bun4.pcd")
    return ScanPair("bun0 and bun4", source, target, T, 0.005, 0.0, 0.01, 0.2, ("mm", 1000.0))


def milk() -> ScanPair:
    """A carton cut out of a scene of 241,407 points, to be located in the scene."""
    at = folder() / "pcl-tests" / "test"
    source, target = points_of(at / "milk_color.pcd"), points_of(at / "milk_cartoon_all_small_clorox.pcd")
    return ScanPair("carton in scene", source, target, np.eye(4), 0.006, 0.0, 0.01, 1.0, ("mm", 1000.0))


def kinect_views() -> list[Array]:
    """Five consecutive views of a room."""
    at = folder() / "pcl-data-tutorials" / "pairwise"
    return [points_of(at / f"capture000{k}.pcd") for k in range(1, 6)]


PAIRS: dict[str, Callable[[], ScanPair]] = {
    "lidar": lidar,
    "kitchen": kitchen,
    "dragon": dragon,
    "parts": bunny_parts,
    "sparse": sparse_bunnies,
    "milk": milk,
    "bunny": bunny_pair,
}
