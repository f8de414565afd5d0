"""Covariances of the poses of LiDAR odometry."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import LidarOdometry
from pointloom.registration.lidar.path_errors import SHIFT_FACTOR, MapError, MatchError, match_error, prediction_error
from pointloom.registration.pose_errors import PoseCovariance

from .test_lidar_verdicts import beam_scan, corridor_scan, run

PIERS = [-9.0, -2.5, 3.1, 8.0]


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
    ends = (-5.0, 8.0)
    still = run([beam_scan(rng, 4.0, 24, ends=ends) for _ in range(8)], device, max_range=40.0)
    moving = [beam_scan(rng, 4.0, 24, ends=(ends[0] - 0.3 * k, ends[1] - 0.3 * k)) for k in range(8)]
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
    np.testing.assert_allclose(ahead.sigmas, [0, 0, 0.01, 0, 0.3, 0], atol=1e-12)
    seen = MapError().after(100, 50, np.zeros(3), noise)
    assert not seen.of_pose(100, np.zeros(3), MatchError()).matrix.any()  # the map has no new voxel
    half, complete = (seen.of_pose(n, np.zeros(3), MatchError()).matrix[0, 0] for n in (110, 10**6))
    assert 0 < half < complete == 1e-4
    pruned = seen.without_voxels(40)
    np.testing.assert_array_equal(pruned.of_pose(60, np.zeros(3), noise).matrix, noise.matrix)


def test_a_predicted_motion_displaces_far_points_by_its_deviation():
    matrix = prediction_error(2.0, 50.0)
    far = PoseCovariance(matrix, np.zeros(3)).about([0.0, 50.0, 0.0])
    np.testing.assert_allclose(far.matrix[3, 3], 2 * 2.0**2)
