"""LiDAR odometry after missing scans: the path is right, or reported."""

import dataclasses

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarOdometry
from pointloom.registration.lidar import lidar_odometry
from pointloom.registration.lidar.deskewing import twist_of
from pointloom.registration.lidar.gaps import (
    MIN_GAP,
    ScanClock,
    intervals_between,
    motion_in,
    poses_after,
    scanners_in_turn,
)
from pointloom.registration.lidar.lidar_steps import OdometryStep, summarize_steps

from ..products import few_quick
from .drives import random_street, scan_at, street_of_equal_houses
from .poses import as_pose

SPEED = 0.5  # [m] per scan
BEFORE, AFTER = 7, 4  # scans before and after a gap


def drive(scene, device, missing, *, has_times=False, speed_before=SPEED):
    """Odometry of a drive that lacks scans, and its largest error [m]."""
    odometry = LidarOdometry(max_range=40.0, min_range=0.5)
    numbers = [*range(BEFORE), *range(BEFORE + missing, BEFORE + missing + AFTER)]
    way = np.array([speed_before * min(k, BEFORE - 1) + SPEED * max(k - BEFORE + 1, 0) for k in numbers])
    for number, x in zip(numbers, way, strict=True):
        odometry.register(scan_at(scene, x, device, number), time=100 + 0.1 * number if has_times else None)
    return odometry, np.abs(odometry.poses[:, 0, 3] - way).max()


@pytest.mark.parametrize("has_times", [False, True])
@few_quick(1, "missing", [20, 8])
def test_the_path_is_right_after_missing_scans(device, missing, has_times):
    odometry, error = drive(random_street(7), device, missing, has_times=has_times)
    assert error < 0.1 and odometry.summary.reliable
    assert odometry.summary.gaps == (BEFORE,)
    assert odometry.steps[BEFORE].gap == pytest.approx(missing + 1, rel=0.02)


@pytest.mark.slow
def test_a_drive_that_began_in_a_gap_is_found(device):
    _, error = drive(random_street(3), device, 5, speed_before=0.0)
    assert error < 0.1


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "missing"), [(2, 70), (5, 44)])  # without and with a pose along the path
def test_a_gap_too_long_to_be_searched_is_reported(device, seed, missing):
    odometry, error = drive(random_street(seed), device, missing)
    assert error > 5 and odometry.summary.doubtful == (BEFORE,) and not odometry.summary.reliable


def test_equal_houses_after_a_known_gap_are_reported_as_ambiguous(device):
    odometry, error = drive(street_of_equal_houses(6.0), device, 8, has_times=True)
    summary = odometry.summary
    assert summary.ambiguous == (BEFORE,) and not summary.reliable
    assert "1 of the scans after gaps fit equally well 6.0" in summary.warnings[0]
    assert error < 0.1  # of equal poses, the nearest to that of constant velocity


@pytest.mark.slow
def test_a_drive_without_gaps_is_not_changed_by_times(device):
    scene = random_street(0)
    timed, untimed = (drive(scene, device, 0, has_times=has_times)[0] for has_times in (True, False))
    np.testing.assert_array_equal(timed.poses, untimed.poses)
    assert timed.summary.gaps == timed.summary.doubtful == ()


@pytest.mark.slow
def test_times_that_run_backward_or_repeat_are_reported(device):
    scene = random_street(0)
    odometry = LidarOdometry(max_range=40.0, min_range=0.5)
    for k, time in enumerate((0.0, 0.1, 0.2, 0.3, 0.25, 0.5, 0.5)):
        odometry.register(scan_at(scene, SPEED * k, device, k), time=time)
    summary = odometry.summary
    assert summary.out_of_order == (4, 6) and not summary.reliable
    assert "the times of 2 of 7 scans are not after those before (scan 4, 6)" in str(summary.warnings)
    assert "its time is not after that of the last scan" in odometry.steps[4].warnings


@pytest.mark.slow
def test_point_times_show_gaps_if_they_grow_from_scan_to_scan(device):
    scene = random_street(7)
    for is_absolute in (True, False):
        odometry = LidarOdometry(max_range=40.0, min_range=0.5, interval=0.1)
        for number in (0, 1, 2, 3, 4, 5, 14, 15):
            scan = scan_at(scene, SPEED * number, device, number)
            times = np.linspace(0, 1e-6, len(scan)) + 0.1 * number * is_absolute  # at once: no motion in a scan
            odometry.register(scan, times)
        assert odometry.steps[6].gap == pytest.approx(9.0, rel=0.02)  # by its times, else by its motion
        assert abs(odometry.poses[-1, 0, 3] - 15 * SPEED) < 0.1 and odometry.summary.reliable


@pytest.mark.parametrize("time", [np.nan, np.inf, "noon", [0.0, 1.0]])
def test_a_time_is_a_finite_number(device, time):
    with pytest.raises((ValueError, TypeError), match="time"):
        LidarOdometry().register(loom.PointCloud([[10.0, 0, 0]], device=device), time=time)


def test_the_clock_learns_the_interval():
    clock, gaps = ScanClock(), []
    for time in (0.0, 0.1, 0.21, 0.3, 0.4, 0.9, 1.0):
        clock, gap = clock.next(time, None)
        gaps.append(gap)
    assert gaps[:5] == [1.0] * 5 and gaps[5] == pytest.approx(5.0, rel=0.1) and gaps[6] == 1.0
    same, gap = clock.next(0.5, None)
    assert same is clock and gap < 0
    assert clock.next(None, None) == (clock, 1.0)


def test_point_times_from_the_start_of_each_scan_are_no_clock():
    clock = ScanClock()
    for start in (0.0, 0.0, 1e-4, 2e-4, -1e-4):
        clock, gap = clock.next(None, (start, 0.1))
        assert gap == 1.0
    assert clock.steps == ()
    assert ScanClock().next(None, (np.inf, -np.inf)) == (ScanClock(), 1.0)  # no measured points


def test_poses_after_a_gap_follow_the_screw_of_the_motion():
    motion = as_pose([0, 0, 0.02], [1.0, 0, 0])
    poses = poses_after(np.eye(4), twist_of(motion), 1.0, 50.0, 1.5)
    nearest = np.abs(poses - motion_in(10.0, motion, 50.0)).max(axis=(1, 2)).min()
    assert nearest < 0.8  # half a spacing
    assert poses[:, 0, 3].min() < -5 and np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).max() < 1.6
    around = poses_after(np.eye(4), np.zeros(6), 1.0, 50.0, 1.5)
    assert len(around) > 100 and np.ptp(around[:, 1, 3]) > 20 and not np.ptp(around[:, 2, 3])


def test_intervals_of_a_motion():
    motion = as_pose(shift=[0.5, 0, 0])
    assert intervals_between(np.eye(4), as_pose(shift=[4.5, 0, 0]), motion) == pytest.approx(9.0)
    assert intervals_between(np.eye(4), as_pose(shift=[0.5 * MIN_GAP - 0.01, 0, 0]), motion) == 1.0
    assert intervals_between(np.eye(4), as_pose(shift=[4.5, 0, 0]), np.eye(4)) == 1.0


def test_a_jump_over_an_unknown_gap_is_doubtful_if_it_costs_more(device):
    """A scan between equal houses fits two houses away, at three times the usual cost."""
    odometry, error = drive(street_of_equal_houses(9.0), device, 20)
    known, jumped = odometry.steps[BEFORE - 1 : BEFORE + 1]
    assert error > 10 and jumped.fitness > 0.75 * known.fitness
    assert odometry.summary.doubtful == (BEFORE,) and not odometry.summary.reliable
    assert "fits the map much worse than the last one" in str(jumped.warnings)


@pytest.mark.parametrize("fitness", [0.2, 0.9])
def test_a_doubtful_scan_stays_doubtful_unless_deskewing_makes_it_fit(monkeypatch, fitness):
    """A doubted match at scan 4, and the step after it was deskewed again, which has this fitness."""
    scene, odometry = random_street(7), LidarOdometry(max_range=40.0, min_range=0.5, interval=0.1)
    match, is_doubted = LidarOdometry._match, []

    def doubted(self, *arguments, **options):
        step = match(self, *arguments, **options)
        return dataclasses.replace(step, is_doubtful=True) if step.index == 4 else step

    def deskewed(self, raw, pose, voxel_map, *_):
        is_doubted.append(len(self.steps))
        step = dataclasses.replace(self.steps[-1], index=len(self.steps), pose=pose, fitness=fitness)
        return step, self._downsample(raw, np.eye(4)), voxel_map

    for number in range(5):
        if number == 4:
            monkeypatch.setattr(LidarOdometry, "_match", doubted)
            monkeypatch.setattr(LidarOdometry, "_is_skewed", lambda *_: True)
            monkeypatch.setattr(LidarOdometry, "_deskew_again", deskewed)
        scan = scan_at(scene, SPEED * number, "cpu", number)
        odometry.register(scan, np.linspace(0, 1e-6, len(scan)))
    assert is_doubted == [4] and odometry.steps[4].is_doubtful == (fitness < 0.5)


def test_a_scan_that_fits_much_worse_is_reported():
    steps = [sound_step(k, is_doubtful=k == 1) for k in range(3)]
    summary = summarize_steps(steps)
    assert summary.doubtful == (1,) and not summary.reliable
    assert "1 of 3 scans fit the map much worse than those before (scan 1)" in summary.warnings[0]
    assert summary.to_dict()["doubtful"] == [1] and ("doubtful", "1: scan 1") in summary.fields()


@pytest.fixture(scope="module")
def slow_drive(made_street):
    return made_street.drive(20, beams=16, azimuths=600, speed=4.0)


def scans_in_turn(drive, mounts, count, device):
    """Scans by scanners on a car, in turn, and their positions in the frame of the first.

    Mounts are an angle [deg] about z, and a number of scans by which the scanner is ahead.
    """
    scans, poses = [], []
    for k in range(count):
        angle, ahead = mounts[k % len(mounts)]
        T = as_pose([0, 0, np.radians(angle)], [0, 0, 0])
        scans.append(loom.PointCloud(drive.scans[k + ahead] @ T[:3, :3], device=device))
        poses.append(drive.poses[k + ahead] @ T)
    return scans, (np.linalg.inv(poses[0]) @ poses)[:, :3, 3]


@pytest.mark.slow_on_emulated_cuda("5 s a case of host decisions; drives of one scanner run there")
@pytest.mark.parametrize("repeats", [1, 2])
@pytest.mark.parametrize(
    "mounts", [((0, 0), (90, 0)), ((0, 0), (180, 0)), ((0, 6), (0, 0)), ((0, 0), (120, 0), (240, 0)), ((0, 3), (90, 0))]
)
def test_scanners_in_turn_are_named_and_not_searched_for_at_each_scan(slow_drive, device, mounts, repeats, monkeypatch):
    scans, positions = scans_in_turn(slow_drive, mounts, 14, device)
    calls = counted(monkeypatch, "search_poses")
    odometry = LidarOdometry(max_range=80.0, min_range=1.5)
    for scan in scans:
        for _ in range(repeats):
            odometry.register(scan)
    summary, first = odometry.summary, repeats * (2 * len(mounts) + 1)
    assert np.abs(odometry.poses[::repeats, :3, 3] - positions).max() < 0.1
    assert summary.scanners == len(mounts) and set(range(first, len(odometry.steps))) <= set(summary.in_turn)
    assert not summary.reliable and "Use one LidarOdometry for each scanner" in " ".join(summary.warnings)
    assert len(calls) <= 2 * len(mounts), "then the motion is predicted by the last scan of the same scanner"
    assert summary.to_dict()["in_turn"] == list(summary.in_turn) and "in turn" in str(summary)


@pytest.mark.parametrize("dropped", [(), (5,), (4, 8), (5, 6, 7)])
def test_scans_of_one_scanner_are_not_in_turn(device, dropped):
    scene, odometry = random_street(3), LidarOdometry(max_range=40.0, min_range=1.0)
    for k in range(14):
        if k not in dropped:
            odometry.register(scan_at(scene, 0.8 * k, device, seed=k))
    assert odometry.summary.in_turn == () and odometry.summary.scanners == 1


@pytest.mark.parametrize("turn", [0.0, 15.0], ids="{} degrees per scan".format)
@pytest.mark.parametrize(("angle", "shift", "count"), [(11, 0, 2), (0, 1.6, 2), (9, 0, 0), (0, 1.4, 0), (0, 0, 0)])
def test_scanners_in_turn_differ_by_ten_degrees_or_one_and_a_half_voxels(turn, angle, shift, count):
    mounts = as_pose(), as_pose([0, np.radians(angle), 0], [0, 0, 0.5 * shift])
    motion = as_pose([0, 0, np.radians(turn)], [0.8, 0, 0])
    steps = [sound_step(k, np.linalg.matrix_power(motion, k) @ mounts[k % 2]) for k in range(9)]
    found = scanners_in_turn(steps, voxel_size=0.5)
    assert (found.scanners if found else 0) == count


def sound_step(index, pose=None, **values):
    return OdometryStep(
        index=index, pose=np.eye(4) if pose is None else pose, threshold=1.0, inliers=10, fitness=0.9, inlier_rmse=0.1,
        iterations=3, converged=True, is_predicted=False, status="converged", **values,
    )  # fmt: skip


def counted(monkeypatch, name):
    """The calls of a function of the odometry."""
    calls, function = [], getattr(lidar_odometry, name)

    def call(*args, **options):
        calls.append(name)
        return function(*args, **options)

    monkeypatch.setattr(lidar_odometry, name, call)
    return calls
