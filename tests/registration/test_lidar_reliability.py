"""Warnings of LiDAR odometry for scans that do not constrain the motion, and the covariances of its poses."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarOdometry
from pointloom.registration.assessment_constants import MIN_RISE
from pointloom.registration.lidar.lidar_odometry import Rest
from pointloom.registration.lidar.lidar_steps import OdometryStep, summarize_steps
from pointloom.registration.lidar.path_errors import RANGE_SCALE, SHIFT_FACTOR, MapError, MatchError, match_error
from pointloom.registration.lidar.scan_matching import MIN_SURE_PATCHES, OpenDirections, rises_surely
from pointloom.registration.unobservable_motions import rises_clearly

from .drives import random_street, scan_at
from .poses import as_pose

PIERS = [-9.0, -2.5, 3.1, 8.0]


def corridor_scan(rng, count=4000, piers=(), at=0.0, fraction=0.33):
    """Points on the walls, floor and ceiling of a corridor along x (2 x 2.5 m), 12 m to either side of the sensor.

    A fraction of them is on piers at the given x, which protrude 50 cm from the walls.
    """
    x = rng.uniform(-12, 12, count)
    side = rng.integers(0, 4, count)
    y = np.select([side == 0, side == 1], [-1.0, 1.0], rng.uniform(-1, 1, count))
    z = np.select([side == 2, side == 3], [-1.2, 1.3], rng.uniform(-1.2, 1.3, count))
    near = [pier - at for pier in piers if abs(pier - at) < 12]
    if near:
        on_pier = rng.random(count) < fraction
        x = np.where(on_pier, rng.choice(near, count), x)
        y = np.where(on_pier, rng.uniform(0.5, 1.0, count) * rng.choice([-1, 1], count), y)
        z = np.where(on_pier, rng.uniform(-1.2, 1.3, count), z)
    return np.column_stack([x, y, z]) + rng.normal(0, 0.005, (count, 3))


def run(scans, device, **options):
    odometry = LidarOdometry(**({"max_range": 30.0, "min_range": 0.3} | options))
    for scan in scans:
        odometry.register(loom.PointCloud(scan, device=device))
    return odometry


def test_a_bare_corridor_does_not_constrain_motion_along_it(device, rng):
    odometry = run([corridor_scan(rng) for _ in range(5)], device)
    for step in odometry.steps[1:]:
        assert np.abs(step.undetermined[0]) @ [1, 0, 0] > 0.99 and len(step.undetermined) == 1
    summary = odometry.summary
    assert summary.undetermined == (1, 2, 3, 4) and summary.open_motions == "along x"
    assert "4 of 5 scans do not determine the motion along x (scan 1-4)" in str(summary.warnings)
    assert summary.to_dict()["undetermined"] == [1, 2, 3, 4]
    assert dict(summary.fields())["undetermined"] == "4: along x, scan 1-4"


def beam_scan(rng, width, beams, *, ends=()):
    """A scan of a spinning sensor in an endless corridor along x, or one between ends at these x."""
    angles, rise = np.radians(np.arange(0, 360, 0.7)), np.radians(np.linspace(-22, 14, beams))
    a, e = (grid.ravel() for grid in np.meshgrid(angles, rise))
    rays = np.column_stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    planes = [(1, -width / 2), (1, width / 2), (2, -1.6), (2, 1.0), *((0, x) for x in ends)]
    with np.errstate(divide="ignore"):
        ranges = np.array([at / rays[:, axis] for axis, at in planes])
    t = np.where(ranges > 0, ranges, np.inf).min(axis=0)
    near = t < 40
    return rays[near] * (t[near] + rng.normal(0, 0.01, near.sum()))[:, None]


@pytest.mark.parametrize(("width", "beams", "min_range"), [(2.0, 32, 5.0), (2.4, 16, 0.5), (4.0, 64, 0.5)])
def test_the_pattern_of_the_beams_does_not_constrain_motion_along_a_corridor(device, rng, width, beams, min_range):
    scans = [beam_scan(rng, width, beams) for _ in range(6)]
    summary = run(scans, device, max_range=40.0, min_range=min_range).summary
    assert len(summary.undetermined) >= 3 and not summary.reliable


def test_the_ends_of_a_corridor_constrain_the_motion(device, rng):
    odometry = run([beam_scan(rng, 4.0, 32, ends=(-5.0 - 0.3 * k, 8.0 - 0.3 * k)) for k in range(5)], device)
    assert odometry.summary.reliable and odometry.poses[-1, 0, 3] == pytest.approx(1.2, abs=0.05)


def test_a_prior_is_used_along_free_directions_without_a_warning(device, rng):
    odometry = LidarOdometry(max_range=30.0, min_range=0.3)
    prior = as_pose(shift=[0.4, 0.05, 0.0])  # 5 cm of it are wrong, across
    odometry.register(loom.PointCloud(corridor_scan(rng), device=device))
    for _ in range(3):
        odometry.register(loom.PointCloud(corridor_scan(rng), device=device), prior=prior)
    np.testing.assert_allclose(odometry.poses[-1, :3, 3], [1.2, 0, 0], atol=0.03)
    assert odometry.steps[-1].undetermined and odometry.summary.reliable
    with pytest.raises(ValueError, match="prior"):
        odometry.register(loom.PointCloud(corridor_scan(rng), device=device), prior=2 * np.eye(4))


def test_distant_piers_constrain_the_motion(device, rng):
    odometry = run([corridor_scan(rng, 4000, PIERS, 0.2 * k) for k in range(5)], device)
    assert odometry.summary.reliable and odometry.poses[-1, 0, 3] == pytest.approx(0.8, abs=0.05)


def test_repeated_piers_are_reported_as_ambiguous(device, rng):
    piers = np.arange(-40, 40, 2.0)
    odometry = run([corridor_scan(rng, 20000, piers, 2.0 * k, 0.06) for k in range(3)], device)
    assert odometry.summary.ambiguous
    rivals = np.array([rival for step in odometry.steps for rival in step.rivals])
    assert np.abs(np.linalg.norm(rivals, axis=1) - 2.0).min() < 0.1
    assert "of the first scans fit equally well" in str(odometry.summary.warnings)


def test_one_foreign_scan_is_harmless(device, fast_drive, rng):
    drive = zip(fast_drive.scans[:8], fast_drive.times[:8], strict=True)
    scans = [loom.PointCloud(points, time=times, device=device) for points, times in drive]
    clean, odometry = LidarOdometry(), LidarOdometry()
    foreign = loom.PointCloud(scans[5].points[:, [1, 0, 2]] * [1.0, -1.0, 1.0] + [9.0, -4.0, 0.5], device=device)
    for k, scan in enumerate(scans):
        clean.register(scan)
        odometry.register(foreign if k == 5 else scan)
    assert odometry.summary.strayed == (5,) and "scan 5" in str(odometry.summary.warnings)
    np.testing.assert_allclose(odometry.poses, clean.poses, atol=0.05)


@pytest.mark.parametrize("angle", [0.5, np.pi / 2])
def test_a_quickly_rotated_scanner_is_relocalized(device, fast_drive, angle):
    rotation, odometry = as_pose([0, 0, -angle]), LidarOdometry()
    for points in fast_drive.scans[:3]:
        odometry.register(loom.PointCloud(points, device=device))
    predicted = odometry.poses[-1] @ np.linalg.inv(odometry.poses[-2]) @ odometry.poses[-1]
    T = odometry.register(loom.PointCloud(fast_drive.scans[3], device=device).transform(rotation))
    assert odometry.summary.strayed == ()
    np.testing.assert_allclose(T, predicted @ np.linalg.inv(rotation), atol=0.05)


def test_rings_of_a_car_that_pitches_before_it_moves_are_no_new_surfaces(device):
    scene, odometry = random_street(2), LidarOdometry(max_range=40.0, min_range=0.5)
    for k in range(14):
        odometry.register(scan_at(scene, 0.0, device, k, pitch=0.0015 * max(k - 2, 0)))
    summary = odometry.summary
    assert summary.resting >= 10 and summary.reliable


def test_new_points_far_away_contradict_a_stationary_scanner(device, rng):
    """Walls at 2 m move along; poles at 10 m do not."""

    def scan(k):
        angles = rng.uniform(0, 2 * np.pi, 4000)
        wall = np.column_stack([2 * np.cos(angles), 2 * np.sin(angles), rng.uniform(-1, 1, 4000)])
        wall = np.clip(wall, -1.5, 1.5)
        at = np.arange(-12, 12, 4.0) - 0.8 * k
        poles = np.column_stack([rng.choice(at, 400), rng.choice([-10.0, 10.0], 400), rng.uniform(-2, 2, 400)])
        return np.concatenate([wall, poles]) + rng.normal(0, 0.005, (4400, 3))

    odometry = run([scan(k) for k in range(10)], device)
    assert np.abs(odometry.poses[:, :3, 3]).max() < 0.05
    assert odometry.summary.is_contradicted and "appears stationary" in str(odometry.summary.warnings)
    still = run([scan(0) for _ in range(10)], device)
    assert not still.summary.is_contradicted


def test_a_stationary_scanner_among_moving_objects_is_reported():
    def steps(fitness, speed=0.0):
        poses = [as_pose(shift=[speed * k, 0, 0]) for k in range(12)]
        return [OdometryStep(k, T, 1.0, 100, fitness, 0.1, 5, True, False, "converged") for k, T in enumerate(poses)]

    assert "appears stationary while 9 scans" in str(summarize_steps(steps(0.95)).warnings)
    assert summarize_steps(steps(0.98)).reliable and summarize_steps(steps(0.95, 0.5)).reliable


def test_ground_that_moves_within_walls_that_move_along_contradicts_a_stationary_scanner(device, rng):
    floor, wall = rng.uniform(-5, 5, (6000, 2)), rng.uniform([-5, -5, -1], [5, 5, 1], (3000, 3))
    wall[:, 1] = np.where(wall[:, 1] > 0, 5.0, -5.0)
    wall[::2, :2] = wall[::2, 1::-1]

    def scan(at):
        x, y = floor[:, 0] + at, floor[:, 1]
        z = -1.5 + 0.1 * np.sin(x + 0.4 * y) * np.cos(1.3 * y - 0.3 * x)
        points = np.concatenate([wall, np.column_stack([floor, z])])
        return points + rng.normal(0, 0.005, points.shape)

    moving, still = run([scan(0.08 * k * min(k, 5)) for k in range(10)], device), run(10 * [scan(0.0)], device)
    assert np.abs(moving.poses[:, :3, 3]).max() < 0.1
    assert moving.summary.is_contradicted and still.summary.reliable


def test_a_scanner_at_rest_whose_scans_fit_worse_than_the_first_one_is_reported():
    def summary(costs, speed=0.0):
        poses = [as_pose([0, 0, 0.1 * k], [speed * k, 0, 0]) for k in range(len(costs))]
        return summarize_steps([
            OdometryStep(k, T, 1.0, 100, 1.0, 0.1, 5 * (k > 0), True, False, "converged", disagreement=cost)
            for k, (T, cost) in enumerate(zip(poses, costs, strict=True))
        ])  # fmt: skip

    worse = summary([0.0, 0.04] + 10 * [0.08])
    assert worse.contradicted == tuple(range(3, 12)) and worse.resting == 9 and worse.is_contradicted
    assert summary([0.0, 0.04] + 10 * [0.05]).reliable and summary([0.0, 0.01] + 10 * [0.027]).reliable
    assert summary([0.0, 0.04] + 5 * [0.08, 0.05]).reliable and summary([0.0, 0.04] + 10 * [0.08], 0.5).reliable


def test_many_scans_in_a_row_that_determine_the_position_weakly_make_the_path_unreliable():
    def summary(sigmas):
        errors = [MatchError(np.diag([0, 0, 0, sigma**2, 0, 0])) for sigma in sigmas]
        return summarize_steps([
            OdometryStep(
                k, as_pose(shift=[k, 0, 0]), 1.0, 100, 1.0, 0.1, 5, True, False, "converged", match_error=error,
                voxel_size=0.5,
            )
            for k, error in enumerate(errors)
        ])  # fmt: skip

    weak = summary(10 * [0.01] + 15 * [0.065] + 20 * [0.01])
    assert set(range(10, 25)) <= set(weak.weak) and 40 not in weak.weak and not weak.reliable
    assert 0.05 < weak.weak_sigma < 0.07 and "within 0.06 m each" in weak.warnings[0]
    assert weak.to_dict()["weak"] == list(weak.weak)
    assert summary(30 * [0.05]).reliable and summary(14 * [0.2]).reliable and summary([]).weak == ()


def test_a_residual_increase_counts_if_large_and_significant():
    rows = np.array([[0.03, 0.0, 1.0, 0.0], [3.1, 0.9, 100.0, 0.0], [15.0, 1.0, 1000.0, 0.0], [4.0, 4.0, 100.0, 0.0]])
    assert MIN_RISE == 0.02 and rises_clearly(rows).tolist() == [False, True, False, False]


def test_free_directions_are_taken_from_another_pose(rng):
    pose, reference = as_pose(shift=[1, 2, 3]), as_pose(shift=[5, 7, 9])
    free = OpenDirections(4.0, np.eye(6)[:, [3]])
    np.testing.assert_allclose(free.taken_from(pose, reference)[:3, 3], [5, 2, 3])
    assert free.translations() == ((1.0, 0.0, 0.0),) and free.rotations() == ()
    np.testing.assert_allclose(free.weight(), np.diag([0, 0, 0, 1e6, 0, 0]))
    np.testing.assert_allclose(OpenDirections(4.0, np.eye(6)[:, [2]]).weight()[2, 2], 16e6)


def slow_scan(rng, shift):
    """A scan among walls at 1.5 m that move along, with poles at 6 and 10 m at the given shift along x."""
    wall = np.column_stack([rng.uniform(-1.5, 1.5, 1600), rng.choice([-1.5, 1.5], 1600), rng.uniform(-1, 1, 1600)])
    wall[::2, :2] = wall[::2, 1::-1]
    x = rng.choice(np.arange(-12, 12, 2.5), 1000) - shift
    poles = np.column_stack([x, rng.choice([-10.0, -6.0, 6.0, 10.0], 1000), rng.uniform(-2, 2, 1000)])
    return np.concatenate([wall, poles]) + rng.normal(0, 0.005, (2600, 3))


def test_surroundings_that_move_slowly_with_the_scanner_are_detected_by_the_scan_at_the_start_of_the_rest(device, rng):
    moving = run([slow_scan(rng, 0.1 * k) for k in range(12)], device)
    assert np.abs(moving.poses[:, :3, 3]).max() < 0.05
    assert np.median([step.rest_change for step in moving.steps[6:]]) > 0.2
    assert moving.summary.is_contradicted and "appears stationary" in str(moving.summary.warnings)
    still = run([slow_scan(rng, 0.0) for _ in range(12)], device)
    assert max(step.rest_change for step in still.steps) < 0.1 and not still.summary.is_contradicted


def test_a_rest_ends_with_a_motion_and_after_thirty_scans():
    def step(index, x):
        return OdometryStep(index, as_pose(shift=[x, 0, 0]), 1.0, 9, 1.0, 0.1, 3, True, False, "converged")

    rest = Rest(None, step(4, 1.0))
    assert rest.lasts_to(step(34, 1.05)) and not rest.lasts_to(step(35, 1.05)) and not rest.lasts_to(step(6, 1.2))


def test_the_first_pose_is_exact_and_the_covariances_are_those_of_the_steps(device, rng):
    odometry = run([corridor_scan(rng, 3000, PIERS, 0.2 * k) for k in range(3)], device)
    assert not odometry.pose_covariances[0].matrix.any()
    for covariance, pose in zip(odometry.pose_covariances, odometry.poses, strict=True):
        np.testing.assert_array_equal(covariance.matrix, covariance.matrix.T)
        np.testing.assert_array_equal(covariance.center, pose[:3, 3])
    assert all(np.linalg.eigvalsh(covariance.matrix).min() > 0 for covariance in odometry.pose_covariances[1:])
    summary = odometry.summary
    np.testing.assert_array_equal(summary.sigmas, odometry.steps[-1].covariance.sigmas)
    written = json.loads(json.dumps(summary.to_dict()))
    assert written["last_position_sigma_m"] == pytest.approx(summary.sigmas[3:])
    assert written["last_rotation_sigma_deg"] == pytest.approx(np.degrees(summary.sigmas[:3]))
    assert LidarOdometry().pose_covariances == () and LidarOdometry().summary.sigmas == ()


def test_errors_in_a_corridor_with_piers_are_within_four_standard_deviations(device, rng):
    odometry = run([corridor_scan(rng, 4000, PIERS, 0.2 * k) for k in range(6)], device)
    assert odometry.summary.reliable
    for k, step in enumerate(odometry.steps[1:], 1):
        error = [0.2 * k, 0, 0] - step.pose[:3, 3]
        assert (np.abs(error) < 4 * step.covariance.sigmas[3:]).all()
        assert step.covariance.sigmas[3:].max() < 0.1 and step.covariance.sigmas[:3].max() < 0.02


def test_the_standard_deviation_along_a_bare_corridor_is_meters_and_grows(device, rng):
    odometry = run([corridor_scan(rng, 3000) for _ in range(5)], device, initial_threshold=1.5)
    sigmas = np.array([step.covariance.sigmas for step in odometry.steps])
    np.testing.assert_allclose(sigmas[1:, 3], 1.5 * np.sqrt(np.arange(1, 5)), rtol=0.02)  # one unknown motion per scan
    assert sigmas[:, 4:].max() < 0.05 and sigmas[:, :3].max() < 0.02


def test_a_stationary_scanner_does_not_drift_and_a_moving_one_does(device, rng):
    still = run([beam_scan(rng, 4.0, 24, ends=(-5.0, 8.0)) for _ in range(8)], device, max_range=40.0)
    moving = [beam_scan(rng, 4.0, 24, ends=(-5.0 - 0.3 * k, 8.0 - 0.3 * k)) for k in range(8)]
    position = [np.sqrt(np.trace(step.covariance.matrix[3:, 3:])) for step in still.steps]
    assert position[-1] < 1.5 * max(position[1:4])
    drifting = run(moving, device, max_range=40.0)
    map_errors = [step.covariance.matrix - step.match_error.matrix for step in drifting.steps[1:]]
    assert (np.diff([np.trace(matrix[3:, 3:]) for matrix in map_errors]) > 0).all()


def test_a_scan_without_points_has_the_error_of_a_prediction_and_the_next_one_that_of_the_map(device, rng):
    scans = [corridor_scan(rng, 3000, PIERS, 0.1 * k) for k in range(5)]
    scans[3] = np.empty((0, 3))
    odometry = run(scans, device, initial_threshold=1.0)
    before, lost, after = (step.covariance.sigmas for step in odometry.steps[2:])
    np.testing.assert_allclose(lost[3:] ** 2 - before[3:] ** 2, 1.0, atol=1e-3)
    np.testing.assert_allclose(lost[:3] ** 2 - before[:3] ** 2, (1.0 / 30.0) ** 2, rtol=1e-3)  # 1 m at the range limit
    assert after[3:].max() < 0.1


def test_the_covariance_is_bitwise_reproducible_and_a_read_of_the_steps_does_not_change_it(device, rng):
    scans = [corridor_scan(rng, 2000, PIERS, 0.2 * k) for k in range(4)]
    first, second = run(scans, device), LidarOdometry(max_range=30.0, min_range=0.3)
    for scan in scans:
        second.register(loom.PointCloud(scan, device=device))
        assert second.summary.scan_count == len(second.pose_covariances)
    for one, other in zip(first.pose_covariances, second.pose_covariances, strict=True):
        np.testing.assert_array_equal(one.matrix, other.matrix)


def rows_of_box(rng, count, motion):
    """Rows of points on three pairs of walls, whose distances a motion explains, and their normal matrix."""
    y, n = rng.uniform(-5, 5, (count, 3)), np.eye(3)[rng.integers(0, 3, count)]
    J = np.concatenate([np.cross(y, n), n], 1)
    return np.column_stack([J, -J @ motion]), J.T @ J


def test_the_distance_to_the_pose_of_the_surfaces_is_part_of_the_error(rng):
    motion = np.array([0.002, -0.001, 0.003, 0.02, -0.01, 0.03])
    rows, information = rows_of_box(rng, 600, motion)
    error = match_error(information, rows, 0.0, 1.0).matrix
    at_pose = match_error(information, np.column_stack([rows[:, :6], np.zeros(600)]), 0.0, 1.0).matrix
    assert np.abs(at_pose).max() < 1e-12
    np.testing.assert_allclose(motion @ np.linalg.solve(error, motion), 1 / SHIFT_FACTOR, rtol=0.2)


def test_motions_that_the_surfaces_hardly_determine_last(rng):
    rows, information = rows_of_box(rng, 600, np.zeros(6))
    assert not match_error(information, rows, 0.1, 1.0).lasting.any()
    walls = rows[np.abs(rows[:, 5]) < 0.5]  # no floor: height is determined by planes only
    error = match_error(information, walls, 0.1, 1.0)
    values, vectors = np.linalg.eigh(error.lasting)
    assert abs(vectors[5, -1]) > 0.99 and values[-1] > 100 * values[-2]
    assert error.matrix[5, 5] == pytest.approx(error.lasting[5, 5], rel=0.01)


def test_a_rotation_of_the_map_displaces_later_poses_and_only_renewed_parts_add_errors():
    tilt = MatchError(np.diag([0, 0, 1e-4, 0, 0, 0]), np.diag([0, 0, 1e-4, 0, 0, 0]))
    noise = MatchError(np.eye(6) * 1e-4)
    start = MapError().after(100, 50, np.zeros(3), tilt)
    ahead = start.of_pose(100, np.array([30.0, 0, 0]), MatchError())
    np.testing.assert_allclose(ahead.sigmas, [0, 0, 0.01, RANGE_SCALE * 30, 0.3, 0], atol=1e-12)
    seen = MapError().after(100, 50, np.zeros(3), noise)
    assert not seen.of_pose(100, np.zeros(3), MatchError()).matrix.any()  # the map has no new voxel
    half, complete = (seen.of_pose(n, np.zeros(3), MatchError()).matrix[0, 0] for n in (110, 10**6))
    np.testing.assert_allclose([half, complete], [0.2**2 * 1e-4, 1e-4])
    pruned = seen.without_voxels(40)
    np.testing.assert_array_equal(pruned.of_pose(60, np.zeros(3), noise).matrix, noise.matrix)


def test_errors_of_matches_add_up_until_the_map_is_renewed():
    def variances(points, count):
        error, noise = MapError(), MatchError(np.eye(6) * 1e-4)
        for k in range(count):
            error = error.after(10 * k, points, np.array([0.1 * k, 0, 0]), noise)
        return error.covariance.matrix

    few = [variances(10_000, count)[0, 0] for count in (11, 21)]  # fractions of 0.001: a constant rate
    np.testing.assert_allclose(few, [(0.001 * 10) ** 2 * 1e-4, (0.001 * 20) ** 2 * 1e-4], rtol=0.05)
    many = [variances(10, count)[0, 0] for count in (11, 21)]  # all is new: independent errors
    np.testing.assert_allclose(many, [10 * 1e-4, 20 * 1e-4])
    matrix = variances(50, 40)
    assert np.linalg.eigvalsh(matrix).min() > 0 and matrix[4, 4] > 1.5 * matrix[3, 3]  # yaw displaces along y


def test_a_wrong_range_scale_displaces_poses_away_from_the_first_scan_and_cancels_on_return():
    error = MapError().after(100, 50, np.zeros(3), MatchError())
    away = error.of_pose(100, np.array([30.0, 40.0, 0.0]), MatchError()).matrix[3:, 3:]
    np.testing.assert_allclose(away @ [0.6, 0.8, 0.0], (RANGE_SCALE * 50) ** 2 * np.array([0.6, 0.8, 0.0]))
    np.testing.assert_allclose(away @ [-0.8, 0.6, 0.0], 0.0, atol=1e-15)
    assert not error.of_pose(100, np.zeros(3), MatchError()).matrix.any()


def test_costs_that_rise_surely_rise_clearly_with_more_points(rng):
    rises = rng.uniform(0, 0.6, (500, 1)) * np.array([[60.0, 30.0, 100.0, 0.0]])
    rises[:, 2] = rng.integers(1, 200, 500)
    surely = rises_surely(rises)
    assert 20 < surely.sum() < 480
    assert rises_clearly(rises)[surely].all() and rises_clearly(4 * rises)[surely].all()
    few = np.array([[9.0, 9.0, 9.0, 0.0]])  # costs of at most 1
    assert not rises_surely(few)[0] and MIN_SURE_PATCHES > 9
