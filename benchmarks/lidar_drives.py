"""LiDAR odometry and SLAM on drives through the synthetic city, beside other libraries.

    python benchmarks/lidar_drives.py loop tunnel --sensor 16 64 --length 500

runs all contestants on both drives.

    python benchmarks/lidar_drives.py --submaps 46 --sensor 32 --seed 0

counts false loops between unrelated submaps of 46 cities, and `--real` lists the loops between real ones, from
POINTLOOM_DATA.

One row per drive and contestant:

- ATE [m]: RMS position error, aligned by the first pose, and by a rigid transformation (Umeyama, without scale). Poses
  are compared with the true ones at the start, middle or end of each scan, whichever fits best.
- drift [%]: mean translation error over all parts of 100 m.
- jump [m]: largest translation error between consecutive scans.
- thickness [cm]: standard deviation of the points across the plane in each occupied 1 m voxel of the map of every fifth
  scan, median and 90th percentile. The row `truth` has the values of the true poses.
- loops: right, false (by over 2 m or 5 degrees), and the percentage of the revisited path within 30 m of a right one.
- ms per scan, MB per km: additional peak memory of the process, in which nothing else runs. Below the row: minutes in
  all, and the additional memory and time at each kilometer, which shows whether they grow linearly.

    python benchmarks/lidar_drives.py long --sensor 16 --only LidarSLAM

maps 3.8 km.

Every contestant gets the same scans, voxels of 1 m and ranges. RKO-LIO also gets an ideal inertial sensor at 200 Hz.
KISS-SLAM 0.0.2 and MapClosures 2.2 are not in the extra `bench`, as MapClosures asks for older versions of NumPy,
pydantic and typer, although it works with the installed ones: `pip install --no-deps kiss-slam map_closures`.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

import city
import numpy as np
from bench_odometry import GRAVITY, IMU_RATE, nanoseconds
from city import SCAN_PERIOD, CityDrive, Scenario, load_drive
from contest import limit_threads, thread_count
from memory import release_memory, resident_bytes
from numpy.typing import NDArray
from real_data import DataMissingError, real_data

Array = NDArray[np.float64]
Times = NDArray[np.float64]

VOXEL_SIZE = 1.0  # [m] KISS-ICP's default for a range of 100 m
MAX_RANGE, MIN_RANGE = 100.0, 2.0  # [m]
WARM_UP_SCANS = 3
FALSE_LOOP_DISTANCE, FALSE_LOOP_ANGLE = 2.0, 5.0  # [m], [degrees] error of the relative pose
REVISIT_RADIUS, REVISIT_HEIGHT, REVISIT_TRAVEL = 6.0, 1.5, 60.0  # [m] what counts as the same place again
LOOP_REACH = 30.0  # [m] of revisited path that a loop covers, before and after
DRIFT_LENGTH = 100.0  # [m]
SUBMAP_LENGTH = 80.0  # [m] of submaps for loop detectors
THICKNESS_VOXEL, THICKNESS_POINTS, THICKNESS_SCANS = 1.0, 30, 5  # [m], points per voxel, every fifth scan


@dataclass(frozen=True)
class Loop:
    """A loop closure: scan numbers, and T_first_second, or None if the contestant does not return it."""

    first: int
    second: int
    pose: Array | None = None


@dataclass
class Outcome:
    """Result of a contestant on a drive.

    Attributes:
        poses: T_world_sensor of each scan, [n, 4, 4].
        loops: Accepted loop closures.
        reliable: The contestant's own assessment. None if it has none.
        warnings: Its reasons.
        doubted: Numbers of the scans whose poses it doubts.
        seconds: For all scans.
        bytes: Additional peak memory.
        kilometers: Seconds, and additional memory [bytes], when each kilometer is completed, [n, 2].
    """

    poses: Array
    loops: list[Loop] = field(default_factory=list)
    reliable: bool | None = None
    warnings: tuple[str, ...] = ()
    doubted: tuple[int, ...] = ()
    seconds: float = 0.0
    bytes: int = 0
    kilometers: tuple[tuple[float, int], ...] = ()


# ------------------------------------------------------------------------------------------------ contestants

Scans = Sequence[tuple[NDArray[np.float32], Times]]
Runner = Callable[[Scenario, CityDrive, Scans], Outcome]


def run_lidar_odometry(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    import pointloom as loom

    odometry = loom.registration.LidarOdometry(voxel_size=VOXEL_SIZE, max_range=MAX_RANGE, min_range=MIN_RANGE)
    for points, times in scans:
        odometry.register(loom.PointCloud(points, time=times))
    summary = odometry.summary
    doubted = tuple(step.index for step in odometry.steps if step.warnings)
    return Outcome(odometry.poses, [], summary.reliable, summary.warnings, doubted)


def run_lidar_slam(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    import pointloom as loom

    if not hasattr(loom.registration, "LidarSLAM"):
        raise ModuleNotFoundError("pointloom.registration has no LidarSLAM")
    slam = loom.registration.LidarSLAM(voxel_size=VOXEL_SIZE, max_range=MAX_RANGE, min_range=MIN_RANGE)
    for points, times in scans:
        slam.register(loom.PointCloud(points), times)
    summary, submaps = slam.summary, slam.submaps
    loops = [
        Loop(submaps[loop.target].first_scan, submaps[loop.source].first_scan, loop.transformation)
        for loop in slam.loops
        if loop.reliable
    ]
    doubted = tuple(step.index for step in slam.odometry.steps if step.warnings)
    return Outcome(slam.poses, loops, summary.reliable, summary.warnings, doubted)


def run_kiss_icp(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    from kiss_icp.config import KISSConfig
    from kiss_icp.kiss_icp import KissICP

    config = KISSConfig()
    set_kiss_options(config.data, config.mapping, config.registration)
    odometry, poses = KissICP(config), []
    for points, times in scans:
        odometry.register_frame(points.astype(np.float64), times)
        poses.append(odometry.last_pose)
    return Outcome(np.array(poses))


def set_kiss_options(data: Any, mapping: Any, registration: Any) -> None:
    data.max_range, data.min_range, mapping.voxel_size = MAX_RANGE, MIN_RANGE, VOXEL_SIZE
    registration.max_num_threads = thread_count()


def run_genz_icp(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    from genz_icp.config import GenZConfig
    from genz_icp.genz_icp import GenZICP

    config = GenZConfig()
    config.data.max_range, config.data.min_range, config.mapping.voxel_size = MAX_RANGE, MIN_RANGE, VOXEL_SIZE
    config.data.deskew = True
    odometry, poses = GenZICP(config), []
    for points, times in scans:
        odometry.register_frame(points.astype(np.float64), (times - times[0]) / SCAN_PERIOD)
        poses.append(odometry.last_pose)
    return Outcome(np.array(poses))


def inertia(scenario: Scenario, end: float) -> tuple[Times, Array, Array]:
    """Times [s], accelerations with gravity [m/s^2, m x 3] and angular rates [rad/s, m x 3] in the sensor's frame."""
    times, h, motion = np.arange(0, end, 1 / IMU_RATE), 1e-3, scenario.motion
    R, before, after = (motion.rotations(times + step) for step in (0.0, -h, h))
    forces = motion.coordinates(times, 2)[:, :3] + [0, 0, GRAVITY]
    change = np.einsum("nji,njk->nik", R, after - before) / (2 * h)
    rates = np.stack([change[:, 2, 1], change[:, 0, 2], change[:, 1, 0]], axis=1)
    return times, np.einsum("nji,nj->ni", R, forces), rates


def run_rko_lio(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    from rko_lio.config import LIOConfig
    from rko_lio.lio import LIO

    config = LIOConfig(
        voxel_size=VOXEL_SIZE, max_range=MAX_RANGE, min_range=MIN_RANGE, max_num_threads=thread_count(),
        double_downsample=False,
    )  # fmt: skip
    starts = drive.numbers[: len(scans)] * SCAN_PERIOD
    times, forces, rates = inertia(scenario, float(starts[-1]) + SCAN_PERIOD)
    measured, first = nanoseconds(times), 0
    odometry, poses = LIO(config), []
    for (points, stamps), start in zip(scans, starts, strict=True):
        last = int(np.searchsorted(times, start + SCAN_PERIOD, side="right"))
        for i in range(first, last):
            odometry.add_imu_measurement(forces[i], rates[i], int(measured[i]))
        first = last
        odometry.register_scan(
            points.astype(np.float64), nanoseconds(stamps),
            start_time_ns=int(nanoseconds(start)), end_time_ns=int(nanoseconds(start + SCAN_PERIOD)),
        )  # fmt: skip
        poses.append(odometry.pose())
    return Outcome(np.array(poses))


def run_kiss_slam(scenario: Scenario, drive: CityDrive, scans: Scans) -> Outcome:
    from kiss_slam.config import KissSLAMConfig
    from kiss_slam.slam import KissSLAM

    config = KissSLAMConfig()
    set_kiss_options(config.odometry.preprocessing, config.odometry.mapping, config.odometry.registration)
    count, loops, closed = len(scans), [], []
    with contextlib.redirect_stdout(io.StringIO()):
        slam = KissSLAM(config)
        add_factor = slam.optimizer.add_factor

        def record(source: int, target: int, pose: Array, information: Array) -> None:
            if abs(source - target) > 1:
                closed.append((source, target, pose.copy()))
            add_factor(source, target, pose, information)

        slam.optimizer.add_factor = record
        for points, times in scans:
            slam.process_scan(points.astype(np.float64), times)
        slam.generate_new_node()
        slam.local_map_graph.erase_last_local_map()
        ends = np.cumsum([len(node.local_trajectory) - (node.id > 0) for node in slam.local_map_graph.local_maps()])
        poses, _ = slam.fine_grained_optimization()
    frames = [0, *(int(end) - 1 for end in ends)]  # scan of each local map's frame
    loops = [Loop(frames[target], frames[source], pose) for source, target, pose in closed]
    return Outcome(np.array(poses)[-count:], loops)


CONTESTANTS: dict[str, Runner] = {
    "LidarOdometry": run_lidar_odometry,
    "LidarSLAM": run_lidar_slam,
    "KISS-ICP": run_kiss_icp,
    "GenZ-ICP": run_genz_icp,
    "RKO-LIO": run_rko_lio,
    "KISS-SLAM": run_kiss_slam,
}


def run_here(name: str, scenario: Scenario, device: str = "cpu") -> Outcome:
    """Run a contestant in this process, after a few scans to load and compile."""
    limit_threads(device)
    drive = load_drive(scenario)
    scans = list(zip(drive.scans, drive.times, strict=True))
    run = CONTESTANTS[name]
    with contextlib.suppress(RuntimeError, ValueError, IndexError):  # too few scans for a result
        run(scenario, drive, scans[:WARM_UP_SCANS])
    release_memory()
    watched = WatchedScans(scans, traveled(drive.poses))
    before, start = resident_bytes(), time.perf_counter()
    outcome = run(scenario, drive, watched)
    outcome.seconds = time.perf_counter() - start
    outcome.bytes = max(0, resident_bytes("VmHWM") - before)
    outcome.kilometers = tuple((moment - start, size - before) for moment, size in watched.readings)
    return outcome


class WatchedScans(list[tuple[NDArray[np.float32], Times]]):
    """Scans that read the time [s] and the process's memory [bytes] at each kilometer of a path while they are used."""

    def __init__(self, scans: Scans, path: Array):
        super().__init__(scans)
        self.path, self.readings = path, list[tuple[float, int]]()

    def __iter__(self) -> Iterator[tuple[NDArray[np.float32], Times]]:
        for scan, distance in zip(super().__iter__(), self.path, strict=True):
            if distance >= 1000 * (len(self.readings) + 1):
                self.readings.append((time.perf_counter(), resident_bytes()))
            yield scan


def run_apart(name: str, scenario: Scenario) -> Outcome | str:
    """Run a contestant in a process of its own; the reason if it has no result."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "outcome.npz"
        request = json.dumps({"name": name, "scenario": vars_of(scenario), "path": str(path)})
        done = subprocess.run(
            [sys.executable, __file__, "--child", request], capture_output=True, text=True, check=False
        )
        if not path.exists():
            lines = [line for line in done.stderr.splitlines() if line.strip()]
            return lines[-1] if lines else f"exit code {done.returncode}"
        return read_outcome(path)


def vars_of(scenario: Scenario) -> dict[str, Any]:
    return {name: getattr(scenario, name) for name in Scenario.__dataclass_fields__}


def write_outcome(path: Path, outcome: Outcome) -> None:
    nowhere = np.full((4, 4), np.nan)
    np.savez(
        path, poses=outcome.poses,
        loops=np.array([[loop.first, loop.second] for loop in outcome.loops], np.int64).reshape(-1, 2),
        loop_poses=np.array([nowhere if loop.pose is None else loop.pose for loop in outcome.loops]).reshape(-1, 4, 4),
        facts=json.dumps([
            outcome.reliable, list(outcome.warnings), list(outcome.doubted), outcome.seconds, outcome.bytes,
            outcome.kilometers,
        ]),
    )  # fmt: skip


def read_outcome(path: Path) -> Outcome:
    with np.load(path) as stored:
        reliable, warnings, doubted, seconds, peak, kilometers = json.loads(str(stored["facts"]))
        loops = [
            Loop(int(i), int(j), None if np.isnan(T).any() else T)
            for (i, j), T in zip(stored["loops"], stored["loop_poses"], strict=True)
        ]
        marks = tuple(map(tuple, kilometers))
        return Outcome(stored["poses"], loops, reliable, tuple(warnings), tuple(doubted), seconds, peak, marks)


# ------------------------------------------------------------------------------------------------ errors


def aligned_rigidly(positions: Array, truth: Array) -> Array:
    """Positions [n, 3] moved onto the true ones by least squares (Umeyama 1991, without scale)."""
    middle, true_middle = positions.mean(axis=0), truth.mean(axis=0)
    U, _, Vt = np.linalg.svd((truth - true_middle).T @ (positions - middle))
    R = U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return (positions - middle) @ R.T + true_middle


def rms(errors: Array) -> float:
    return float(np.sqrt((errors**2).sum(axis=-1).mean()))


def relative(A: Array, B: Array) -> Array:
    return np.linalg.inv(A) @ B


def angle_degrees(T: Array) -> Array:
    """Rotation angle of poses [..., 4, 4]."""
    trace = T[..., 0, 0] + T[..., 1, 1] + T[..., 2, 2]
    return np.degrees(np.arccos(np.clip((trace - 1) / 2, -1, 1)))


def drift_percent(poses: Array, truth: Array) -> float:
    """Mean translation error [%] over parts of DRIFT_LENGTH. NaN if the drive is shorter."""
    s = traveled(truth)
    ends = np.searchsorted(s, s + DRIFT_LENGTH)
    first = np.flatnonzero(ends < len(s))[::10]
    if not len(first):
        return float("nan")
    last = ends[first]
    error = relative(relative(truth[first], truth[last]), relative(poses[first], poses[last]))
    return float(np.linalg.norm(error[:, :3, 3], axis=1).mean() / DRIFT_LENGTH * 100)


def traveled(poses: Array) -> Array:
    """Distance traveled [m] at each pose."""
    return np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1))])


def step_errors(poses: Array, truth: Array) -> Array:
    """Translation errors [m] between consecutive scans, [n - 1]."""
    error = relative(relative(truth[:-1], truth[1:]), relative(poses[:-1], poses[1:]))
    return np.linalg.norm(error[:, :3, 3], axis=1)


def best_truth(scenario: Scenario, drive: CityDrive, poses: Array) -> Array:
    """True poses at the start, middle or end of the scans: those that the positions fit best."""
    moments = [scenario.motion.poses((drive.numbers + part) * SCAN_PERIOD) for part in (0.0, 0.5, 1.0)]
    return min(moments, key=lambda truth: np.median(step_errors(poses, truth)))


def is_false(loop: Loop, truth: Array) -> bool:
    T = relative(truth[loop.first], truth[loop.second])
    if loop.pose is None:
        return bool(np.linalg.norm(T[:3, 3]) > LOOP_REACH)
    error = relative(T, loop.pose)
    return bool(np.linalg.norm(error[:3, 3]) > FALSE_LOOP_DISTANCE or angle_degrees(error) > FALSE_LOOP_ANGLE)


def revisited(truth: Array, step: float = 10.0) -> Array:
    """Distances traveled [m], every `step`, at which the scanner is at an earlier place again."""
    s = traveled(truth)
    rows = np.searchsorted(s, np.arange(0, s[-1], step))
    at, found = truth[rows, :3, 3], []
    for k, row in enumerate(rows):
        before = s[rows[:k]] < s[row] - REVISIT_TRAVEL
        gap = at[:k][before] - at[k]
        if (np.hypot(gap[:, 0], gap[:, 1]) + 1000 * (np.abs(gap[:, 2]) > REVISIT_HEIGHT) < REVISIT_RADIUS).any():
            found.append(s[row])
    return np.array(found)


def covered_percent(loops: Sequence[Loop], truth: Array) -> float:
    """Percentage of the revisited path within LOOP_REACH of the later scan of a loop."""
    places, s = revisited(truth), traveled(truth)
    if not len(places):
        return float("nan")
    closed = np.array([s[max(loop.first, loop.second)] for loop in loops])
    return 100 * float(np.mean([(np.abs(closed - at) < LOOP_REACH).any() for at in places]))


def thickness(points: Array) -> tuple[float, float]:
    """Median and 90th percentile [m] of the standard deviation across the plane in each occupied voxel."""
    points = points.reshape(-1, 3)
    cells = np.floor(points / THICKNESS_VOXEL).astype(np.int64)
    cells -= cells.min(axis=0)
    sizes = cells.max(axis=0) + 1
    key = (cells[:, 0] * sizes[1] + cells[:, 1]) * sizes[2] + cells[:, 2]
    order = np.argsort(key, kind="stable")
    local = (points - np.floor(points / THICKNESS_VOXEL) * THICKNESS_VOXEL)[order]
    starts = np.flatnonzero(np.diff(key[order], prepend=-1))
    counts = np.diff(starts, append=len(key))
    means = np.add.reduceat(local, starts) / counts[:, None]
    squares = np.stack(
        [np.add.reduceat(local[:, i] * local[:, j], starts) / counts - means[:, i] * means[:, j]
         for i in range(3) for j in range(3)], axis=1,
    )  # fmt: skip
    values = np.linalg.eigvalsh(squares[counts >= THICKNESS_POINTS].reshape(-1, 3, 3))
    across = np.sqrt(np.maximum(values[:, 0], 0))
    return float(np.median(across)), float(np.percentile(across, 90))


def map_points(scenario: Scenario, drive: CityDrive, poses: Array, truth: Array) -> Array:
    """Points of every fifth scan, without motion distortion, at the estimated poses."""
    parts = []
    for k in range(0, len(drive.scans), THICKNESS_SCANS):
        points, times = drive.scans[k][::2], drive.times[k][::2]
        moments, which = np.unique(times, return_inverse=True)
        if len(moments) > 1000:  # a pattern in which every point has its own time
            which = np.arange(len(times)) * 500 // len(times)
            moments = times[np.arange(500) * len(times) // 500]
        T = (relative(truth[k], scenario.motion.poses(moments)))[which]
        local = np.einsum("nij,nj->ni", T[:, :3, :3], points) + T[:, :3, 3]
        parts.append(local @ poses[k, :3, :3].T + poses[k, :3, 3])
    return np.concatenate(parts)


def undetected(outcome: Outcome, errors: Array, limit: float = 0.5) -> list[int]:
    """Scans with a step error above `limit` [m] that no scan within three of it is doubted for."""
    doubted = np.array(outcome.doubted)
    wrong = np.flatnonzero(errors > limit) + 1
    return [int(k) for k in wrong if not len(doubted) or np.abs(doubted - k).min() > 3]


HEADER = (
    "| drive | contestant | ATE | rigid | drift % | jump | thickness | loops | ms | MB/km | reliable |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|"
)


def row_of(scenario: Scenario, drive: CityDrive, name: str, outcome: Outcome) -> str:
    truth = best_truth(scenario, drive, outcome.poses)
    poses = truth[0] @ np.linalg.inv(outcome.poses[0]) @ outcome.poses
    positions, true_positions = poses[:, :3, 3], truth[:, :3, 3]
    errors = step_errors(poses, truth)
    median, wide = thickness(map_points(scenario, drive, poses, truth))
    false = [loop for loop in outcome.loops if is_false(loop, truth)]
    right = [loop for loop in outcome.loops if not is_false(loop, truth)]
    loops = f"{len(right)}, {len(false)} false, {covered_percent(right, truth):.0f} %" if name.endswith("SLAM") else "-"
    cells = (
        scenario.name, name, f"{rms(positions - true_positions):.2f}",
        f"{rms(aligned_rigidly(positions, true_positions) - true_positions):.2f}",
        f"{drift_percent(poses, truth):.2f}", f"{errors.max():.2f}", f"{100 * median:.1f} / {100 * wide:.1f}", loops,
        f"{1000 * outcome.seconds / len(poses):.1f}", f"{outcome.bytes / 1e6 / (drive.distance / 1000):.0f}",
        {None: "-", True: "yes", False: "no"}[outcome.reliable],
    )  # fmt: skip
    return "| " + " | ".join(cells) + " |"


def print_growth(drive: CityDrive, outcome: Outcome) -> None:
    minutes, km = outcome.seconds / 60, drive.distance / 1000
    marks = [f"{k + 1} km: {s / 60:.1f} min, {size / 1e6:.0f} MB" for k, (s, size) in enumerate(outcome.kilometers)]
    print("  " + "; ".join([*marks, f"{km:.1f} km: {minutes:.1f} min, at most {outcome.bytes / 1e6:.0f} MB"]))


def print_faults(drive: CityDrive, scenario: Scenario, outcome: Outcome) -> None:
    truth = best_truth(scenario, drive, outcome.poses)
    errors = step_errors(outcome.poses, truth)
    for reason in outcome.warnings:
        print(f"  warning: {reason}")
    if outcome.reliable is not None and (scans := undetected(outcome, errors)):
        print(f"  undetected: steps to scans {scans[:12]} are wrong by up to {errors[np.array(scans) - 1].max():.2f} m")


def run_drives(scenarios: Sequence[Scenario], only: Sequence[str]) -> None:
    print(HEADER, flush=True)
    for scenario in scenarios:
        drive = load_drive(scenario)
        truth = scenario.motion.poses((drive.numbers + 1) * SCAN_PERIOD)
        median, wide = thickness(map_points(scenario, drive, truth, truth))
        print(f"| {scenario.name} | truth | | | | | {100 * median:.1f} / {100 * wide:.1f} | | | | |", flush=True)
        for name in only or CONTESTANTS:
            outcome = run_apart(name, scenario)
            if isinstance(outcome, str):
                print(f"{scenario.name}: {name} left out: {outcome}", flush=True)
                continue
            if len(outcome.poses) != len(drive.scans) or not np.isfinite(outcome.poses).all():
                print(f"{scenario.name}: {name} left out: {len(outcome.poses)} poses", flush=True)
                continue
            print(row_of(scenario, drive, name, outcome), flush=True)
            print_growth(drive, outcome)
            print_faults(drive, scenario, outcome)


# ------------------------------------------------------------------------------------------------ loops alone


class Detector(Protocol):
    """A loop detector: compares a submap [n, 3] with those before and keeps it."""

    def add(self, points: Array) -> list[tuple[int, Array]]:
        """Numbers of earlier submaps that are accepted as the same place, and T_earlier_this."""
        ...


class MapClosuresDetector:
    """MapClosures with its default configuration, as in KISS-SLAM before its check by ICP."""

    def __init__(self) -> None:
        from map_closures.config import MapClosuresConfig
        from map_closures.map_closures import MapClosures

        self.threshold = MapClosuresConfig().inliers_threshold
        self.closures, self.count = MapClosures(MapClosuresConfig()), 0

    def add(self, points: Array) -> list[tuple[int, Array]]:
        number, self.count = self.count, self.count + 1
        found = self.closures.get_closures(number, np.ascontiguousarray(points, np.float64))
        return [
            (int(closure.source_id), np.linalg.inv(np.asarray(closure.pose)))
            for closure in found
            if closure.number_of_inliers >= self.threshold
        ]


class CheckedMapClosuresDetector(MapClosuresDetector):
    """MapClosures, and KISS-SLAM's check of the best candidate by ICP and overlap."""

    def __init__(self) -> None:
        super().__init__()
        from kiss_slam.config import LoopCloserConfig
        from kiss_slam.loop_closer import LoopCloser
        from kiss_slam.voxel_map import VoxelMap

        self.closer, self.maps = LoopCloser(LoopCloserConfig()), []
        self.voxel_map = VoxelMap

    def add(self, points: Array) -> list[tuple[int, Array]]:
        number, self.count = self.count, self.count + 1
        grid = self.voxel_map(0.5)
        grid.integrate_frame(np.ascontiguousarray(points, np.float64), np.eye(4))
        self.maps.append(type("LocalMap", (), {"pcd": grid.open3d_pcd_with_normals()}))
        with contextlib.redirect_stdout(io.StringIO()):
            is_good, source, _, pose = self.closer.compute(number, grid.point_cloud(), self.maps)
        return [(int(source), np.linalg.inv(pose))] if is_good else []


class LocalizeDetector:
    """The check of LidarSLAM.localize against one submap at a time, without the prior knowledge of a path."""

    def __init__(self) -> None:
        try:
            from pointloom.registration.lidar import lidar_loops, localization, place_descriptor, submap_pairs
        except ImportError as error:
            raise ModuleNotFoundError("pointloom.registration has no LidarSLAM") from error
        self.modules = lidar_loops, localization, place_descriptor, submap_pairs
        self.places: list[Any] = []
        self.surfaces: list[Any] = []

    def add(self, points: Array) -> list[tuple[int, Array]]:
        import warp as wp

        loops, localization, descriptors, pairs = self.modules
        radius, size = 0.6 * MAX_RANGE, 0.75 * VOXEL_SIZE  # as LidarSLAM does
        near = points[np.linalg.norm(points, axis=1) < radius].astype(np.float32)
        surfaces = pairs.SubmapSurfaces.of(near, size, wp.get_device("cpu"))
        descriptor, found = descriptors.describe_place(near, np.zeros(3), radius), []
        for k, (place, known) in enumerate(zip(self.places, self.surfaces, strict=True)):
            result = localization.localize_cloud(
                surfaces, descriptor, [place], [np.eye(4)], lambda _, known=known: known, size
            )
            if result.reliable:
                found.append((k, result.transformation))
        self.places.append(loops.Place(descriptor, np.eye(3), 0.0, SUBMAP_LENGTH, np.zeros(3)))
        self.surfaces.append(surfaces)
        return found


DETECTORS: dict[str, Callable[[], Detector]] = {
    "LidarSLAM.localize": LocalizeDetector,
    "MapClosures": MapClosuresDetector,
    "MapClosures + ICP of KISS-SLAM": CheckedMapClosuresDetector,
}


def submap(scenario: Scenario, start: float, length: float, voxel: float = 0.1) -> tuple[Array, Array]:
    """Points of a part of a drive at the true poses, in the frame of its middle scan, and that frame's true pose."""
    drive = load_drive(scenario)
    s = traveled(drive.poses)
    rows = np.flatnonzero((s >= start) & (s < start + length))
    part = replace(
        drive, scans=[drive.scans[k] for k in rows], times=[drive.times[k] for k in rows],
        poses=drive.poses[rows], numbers=drive.numbers[rows],
    )  # fmt: skip
    middle = part.poses[len(rows) // 2]
    points = map_points(scenario, part, relative(middle, part.poses), part.poses)
    _, first = np.unique(np.floor(points / voxel).astype(np.int64), axis=0, return_index=True)
    return points[np.sort(first)], middle


def unrelated_submaps(count: int, sensor: str = "32", seed: int = 0) -> Iterator[Array]:
    """Submaps of different cities, each from another part of the longest route: no two show the same place.

    Seeds share no city. Many submaps overlap on the map: the same streets, between other houses.
    """
    truth = Scenario("long").motion
    ends = np.arange(0, truth.end, 0.5)
    path = truth.poses(ends)
    s, again = traveled(path), revisited(path)
    starts = np.arange(20.0, s[-1] - SUBMAP_LENGTH, 10.0)
    middles = starts + SUBMAP_LENGTH / 2
    new = starts[[not len(again) or bool(np.abs(again - at).min() > SUBMAP_LENGTH) for at in middles]]
    for k, start in enumerate(new[np.linspace(0, len(new) - 1, count).astype(int)]):
        scenario = Scenario("long", sensor, seed=1000 * (seed + 1) + k, length=SUBMAP_LENGTH, start=float(start))
        yield submap(scenario, 0.0, SUBMAP_LENGTH)[0]


def count_false_loops(detector: Detector, submaps: Iterator[Array]) -> tuple[int, list[tuple[int, int]]]:
    """Number of pairs of unrelated submaps, and the pairs that are accepted: every one is false."""
    loops: list[tuple[int, int]] = []
    count = 0
    for number, points in enumerate(submaps):
        loops += [(earlier, number) for earlier, _ in detector.add(points)]
        count += 1
    return count * (count - 1) // 2, loops


def run_submaps(count: int, sensor: str, seed: int) -> None:
    submaps = list(unrelated_submaps(count, sensor, seed))
    for name, make in DETECTORS.items():
        try:
            detector = make()
        except ModuleNotFoundError as error:
            print(f"{name} left out: {error}")
            continue
        pairs, loops = count_false_loops(detector, iter(submaps))
        print(f"{name}: {len(loops)} false loops between {pairs} pairs of unrelated submaps {loops}", flush=True)


def real_submaps() -> list[tuple[Array, Array]]:
    """The five submaps of KITTI 07 in gtsam_points' test data, [n, 3], with true poses."""
    rows = real_data("reg-gtsam-points/kitti_07_dump/graph.txt").read_text().splitlines()
    found = []
    for k, row in enumerate(line.split() for line in rows if line.startswith("v")):
        x, y, z, qx, qy, qz, qw = map(float, row[1:])
        points = np.fromfile(real_data(f"reg-gtsam-points/kitti_07_dump/{k:06d}/points.bin"), np.float32).reshape(-1, 3)
        T = np.eye(4)
        T[:3, :3] = rotation(np.array([qx, qy, qz, qw]))
        T[:3, 3] = x, y, z
        found.append((points.astype(np.float64), T))
    return found


def rotation(q: Array) -> Array:
    """Rotation matrix of a quaternion (x, y, z, w)."""
    x, y, z, w = q / np.linalg.norm(q)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def real_pair() -> list[tuple[Array, Array]]:
    """Two KITTI scans of small_gicp's example, with true poses in the frame of the first."""
    import pointloom as loom

    clouds = [loom.read_point_cloud(real_data(f"reg-small-gicp/{name}.ply")) for name in ("target", "source")]
    T = np.loadtxt(real_data("reg-small-gicp/T_target_source.txt"))
    return [(cloud.points.astype(np.float64), pose) for cloud, pose in zip(clouds, (np.eye(4), T), strict=True)]


def run_real() -> None:
    for data, load in (("KITTI 07 submaps", real_submaps), ("KITTI pair", real_pair)):
        submaps = load()
        for name, make in DETECTORS.items():
            try:
                detector = make()
            except ModuleNotFoundError as error:
                print(f"{name} left out: {error}")
                continue
            poses, errors = [], []
            for k, (points, pose) in enumerate(submaps):
                for j, T in detector.add(points):
                    error = relative(relative(poses[j], pose), T)
                    errors.append(
                        f"{j}-{k}: {np.linalg.norm(error[:3, 3]):.2f} m {float(angle_degrees(error)):.1f} deg"
                    )
                poses.append(pose)
            print(f"{data}: {name}: {len(errors)} loops of {len(submaps) * (len(submaps) - 1) // 2} pairs; {errors}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    city.add_scenario_options(parser)
    parser.add_argument("--only", action="append", default=[], choices=CONTESTANTS)
    parser.add_argument("--submaps", type=int, default=0, help="number of unrelated submaps for the loop detectors")
    parser.add_argument("--real", action="store_true", help="loops between real submaps")
    parser.add_argument("--child", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        request = json.loads(options.child)
        outcome = run_here(request["name"], Scenario(**request["scenario"]))
        write_outcome(Path(request["path"]), outcome)
        return
    if options.submaps:
        run_submaps(options.submaps, options.sensor[0], options.seed)
    if options.real:
        try:
            run_real()
        except DataMissingError as error:
            print(f"left out: {error}")
    run_drives(city.scenarios_of(options), options.only)


if __name__ == "__main__":
    main()
