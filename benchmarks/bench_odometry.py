"""LiDAR odometry in a synthetic street, per scan: scans in memory; down-sampling, matching and the map included.

small_gicp's scan-to-model odometry (VGICP) has no deskewing, so the scans
come from a drive without sway, which needs none. GenZ-ICP is more accurate
without its own deskewing, which is off by default. Map voxels and ranges are
the same for all. RKO-LIO also needs an inertial sensor and gets a perfect one
at 200 Hz, from the formula of the drive; the others estimate the motion.
RKO-LIO assumes a start at rest, which this drive has not, so its
correspondence distance is 2 m instead of 0.5 m.

    python benchmarks/bench_odometry.py

prints the absolute trajectory error (ATE) of each: the RMS position error from the first pose on.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, thread_count, timed, waiting
from street import SCAN_PERIOD, Drive, drive, pose_at

VOXEL_SIZE = 1.0  # [m] of the maps, KISS-ICP's default for a range of 100 m
GICP_VOXEL_SIZE = 0.25  # [m] small_gicp's example for outdoor scans
SPEED = 10.0  # [m/s]
MAX_RANGE, MIN_RANGE = 100.0, 5.0  # [m]
IMU_RATE = 200.0  # [Hz]
GRAVITY = 9.81  # [m/s^2]
RKO_CORRESPONDENCE = 2.0  # [m]; RKO-LIO drives 1 m before it estimates the speed
EPOCH = 1000.0  # [s] of the clock at the start of the drive


def street_drive(count: int, beams: int, azimuths: int) -> Callable[[], Drive]:
    return lambda: drive(count, speed=SPEED, beams=beams, azimuths=azimuths)


def livox_drive(count: int, points: int) -> Callable[[], Drive]:
    return lambda: drive(count, speed=SPEED, rosette_points=points)


def prepare_pointloom(scene: Drive, device: str) -> Any:
    import pointloom as loom

    clouds = [loom.PointCloud(p, time=t, device=device) for p, t in zip(scene.scans, scene.times, strict=True)]

    def run() -> Any:
        odometry = loom.registration.LidarOdometry(voxel_size=VOXEL_SIZE)
        for cloud in clouds:
            odometry.register(cloud)
        return odometry.poses

    return waiting(run, device, "warp")


def prepare_kiss_icp(scene: Drive, device: str) -> Any:
    from kiss_icp.config import KISSConfig
    from kiss_icp.kiss_icp import KissICP

    config = KISSConfig()
    config.data.max_range, config.data.min_range, config.mapping.voxel_size = MAX_RANGE, MIN_RANGE, VOXEL_SIZE
    config.registration.max_num_threads = thread_count()
    scans = [points.astype(np.float64) for points in scene.scans]

    def run() -> Any:
        odometry, poses = KissICP(config), []
        for points, times in zip(scans, scene.times, strict=True):
            odometry.register_frame(points, times)
            poses.append(odometry.last_pose)
        return np.array(poses)

    return run


def prepare_small_gicp(scene: Drive, device: str) -> Any:
    import small_gicp

    scans = [points.astype(np.float64) for points in scene.scans]

    def run() -> Any:
        target, poses = small_gicp.GaussianVoxelMap(VOXEL_SIZE), []
        for points in scans:
            cloud, _ = small_gicp.preprocess_points(points, GICP_VOXEL_SIZE, num_threads=thread_count())
            guess = poses[-1] @ np.linalg.inv(poses[-2]) @ poses[-1] if len(poses) > 1 else np.eye(4)
            if poses:
                guess = small_gicp.align(target, cloud, guess, num_threads=thread_count()).T_target_source
            target.insert(cloud, guess)
            poses.append(guess)
        return np.array(poses)

    return run


def prepare_genz_icp(scene: Drive, device: str) -> Any:
    from genz_icp.config import GenZConfig
    from genz_icp.genz_icp import GenZICP

    config = GenZConfig()
    config.data.max_range, config.data.min_range, config.mapping.voxel_size = MAX_RANGE, MIN_RANGE, VOXEL_SIZE
    scans = [points.astype(np.float64) for points in scene.scans]

    def run() -> Any:
        odometry, poses = GenZICP(config), []
        for points in scans:
            odometry.register_frame(points, None)
            poses.append(odometry.last_pose)
        return np.array(poses)

    return run


def nanoseconds(times: Any) -> np.ndarray:
    """Clock times of the drive, int64 [ns]."""
    return np.round((np.asarray(times) + EPOCH) * 1e9).astype(np.int64)


def inertia(scan_count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times [s], accelerations with gravity [m/s^2, m x 3] and angular rates [rad/s, m x 3] in the sensor's frame."""
    times, h = np.arange(0, scan_count * SCAN_PERIOD + 1 / IMU_RATE, 1 / IMU_RATE), 1e-4
    (before, left), (here, heading), (after, right) = (pose_at(SPEED * (times + s), 0.0) for s in (-h, 0, h))
    forces = (after - 2 * here + before) / h**2 + [0, 0, GRAVITY]
    c, s, nothing = np.cos(heading), np.sin(heading), np.zeros(len(times))
    felt = np.stack([c * forces[:, 0] + s * forces[:, 1], c * forces[:, 1] - s * forces[:, 0], forces[:, 2]], axis=1)
    return times, felt, np.stack([nothing, nothing, (right - left) / (2 * h)], axis=1)


def prepare_rko_lio(scene: Drive, device: str, **setting: bool) -> Any:
    from rko_lio.config import LIOConfig
    from rko_lio.lio import LIO

    config = LIOConfig(
        voxel_size=VOXEL_SIZE, max_range=MAX_RANGE, min_range=MIN_RANGE, max_num_threads=thread_count(),
        max_correspondence_distance=RKO_CORRESPONDENCE, **setting,
    )  # fmt: skip
    count = len(scene.scans)
    scans = [points.astype(np.float64) for points in scene.scans]
    stamps, scan_ends = [nanoseconds(times) for times in scene.times], nanoseconds(SCAN_PERIOD * np.arange(count + 1))
    times, forces, rates = inertia(count)
    measured = nanoseconds(times)
    parts = np.split(np.arange(len(times)), np.searchsorted(measured, scan_ends[1:], side="right"))

    def run() -> Any:
        odometry, poses = LIO(config), []
        for k in range(count):
            for i in parts[k]:
                odometry.add_imu_measurement(forces[i], rates[i], int(measured[i]))
            odometry.register_scan(
                scans[k], stamps[k], start_time_ns=int(scan_ends[k]), end_time_ns=int(scan_ends[k + 1])
            )
            poses.append(odometry.pose())
        return np.array(poses)

    return run


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check that both travel the full distance; a baseline may be off by some percent (rings that move along)."""
    path_ends, _ = pose_at(np.array([0.0, SPEED * SCAN_PERIOD * (len(actual) - 1)]), 0.0)
    distance = float(np.linalg.norm(path_ends[1] - path_ends[0]))
    gap = np.linalg.norm(actual[-1, :3, 3] - actual[0, :3, 3]) / distance - 1
    assert abs(gap) < 0.01, f"pointloom has traveled {1 + gap:.1%} of the distance"
    difference = np.linalg.norm(actual[-1, :3, 3] - reference[-1, :3, 3]) / distance
    assert difference < 0.2, f"{peer} ends {difference:.1%} of the distance away from pointloom"


NO_DESKEWING = "Times are those of RKO-LIO without deskewing, which also gets the motion from an inertial sensor."
ODOMETRY = Operation(
    name="odometry",
    scenes={
        "64 beams, 115k": street_drive(30, 64, 1800),
        "16 beams, 14k": street_drive(30, 16, 900),
        "128 beams, 250k": street_drive(30, 128, 1950),
        "rosette of 70 degrees, 20k": livox_drive(30, 20000),
    },
    quick={"16 beams": street_drive(5, 16, 900)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda poses: poses, ("cpu", "cuda")),
        Contestant("kiss-icp", prepare_kiss_icp, lambda poses: poses),
        Contestant("small_gicp", prepare_small_gicp, lambda poses: poses),
        Contestant("genz-icp", prepare_genz_icp, lambda poses: poses),
        Contestant("rko-lio", partial(prepare_rko_lio, double_downsample=False), lambda poses: poses),
        Contestant("rko-lio, thinned", partial(prepare_rko_lio, double_downsample=True), lambda poses: poses),
        Contestant(
            "rko-lio, no deskewing",
            partial(prepare_rko_lio, double_downsample=False, deskew=False),
            lambda poses: poses,
        ),
    ),
    check=check,
    unit_count=lambda scene: len(scene.scans),
    targets={"64 beams, 115k": 2, "16 beams, 14k": 1.2},
    reasons={
        "64 beams, 115k": NO_DESKEWING,
        "16 beams, 14k": NO_DESKEWING,
        "rosette of 70 degrees, 20k": (
            "RKO-LIO gets the motion from an inertial sensor. A street ahead hardly determines the motion "
            "along it, so the surfaces are compared at displaced poses in each scan."
        ),
    },
)
OPERATIONS = (ODOMETRY,)


@timed(ODOMETRY)
def test_odometry(time_lap) -> None:
    time_lap()


def trajectory_error(poses: np.ndarray, truth: np.ndarray) -> float:
    """ATE [m] of poses [n, 4, 4], aligned by the first pose."""
    positions = (truth[0] @ np.linalg.inv(poses[0]) @ poses)[:, :3, 3]
    return float(np.sqrt(((positions - truth[:, :3, 3]) ** 2).sum(axis=1).mean()))


def main() -> None:
    """Print the ATE of each available contestant."""
    for size, make in ODOMETRY.scenes.items():
        scene = make()
        for contestant in ODOMETRY.contestants:
            try:
                poses = contestant.trial(scene, "cpu").once()
            except ModuleNotFoundError as error:
                print(f"{size:16} {contestant.name:12} left out: {error}", flush=True)
                continue
            print(f"{size:16} {contestant.name:12} ATE {trajectory_error(poses, scene.poses):.3f} m", flush=True)


if __name__ == "__main__":
    main()
