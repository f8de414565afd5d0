"""Uncertainty accumulates along a path until the camera sees better-known parts again; all results include it."""

import dataclasses

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam.frame_checks import MAX_DEVIATION, judge_drift
from pointloom.rgbd.slam.keyframes import Keyframes
from pointloom.rgbd.slam.results import TrackingResult, rotated_covariance
from pointloom.rgbd.slam.tracker import Drift, join_covariance

from .slam_walks import begun, blank, frame, frames


def deviated(deviation: float, status="tracked") -> TrackingResult:
    covariance = np.zeros((6, 6))
    covariance[4, 4] = deviation * deviation
    return TrackingResult(np.eye(4), status, covariance=covariance)


def test_the_deviation_of_a_position_is_that_of_its_least_constrained_direction():
    assert np.isclose(deviated(0.02).position_deviation, 0.02)


@pytest.mark.parametrize(("share", "status"), [(0.9, "tracked"), (1.1, "uncertain")])
def test_a_poorly_constrained_pose_is_uncertain_even_if_its_frame_fits(share, status):
    result = judge_drift(deviated(share * MAX_DEVIATION), 0.04)
    assert (result.status, result.has_drifted) == (status, status == "uncertain")
    assert result.reliable == (status != "uncertain")


def test_a_coarser_model_allows_more_drift():
    assert judge_drift(deviated(1.5 * MAX_DEVIATION), 0.16).status == "tracked"


def test_a_lost_frame_stays_lost():
    assert judge_drift(dataclasses.replace(deviated(1.0), status="lost"), 0.04).status == "lost"


def test_uncertainty_accumulates_and_is_reduced_by_revisiting(device):
    """All alignments are equally certain; only the frames they refer to differ."""
    model, covariance, offs = begun(device).model, 1e-6 * np.eye(6), []
    keyframes, noises = Keyframes(model.device), ((covariance, covariance),) * 2
    drift = Drift(keyframes)
    for number in range(0, 60, 6):
        shown = frames(number)[0]
        pyramid = model.prepare(shown).pyramid
        offs.append(np.trace(drift.of(pyramid, shown.T_world_camera, noises)[0][3:, 3:]))
        keyframes.add(pyramid, shown.T_world_camera, number)
        drift.keep(pyramid)
    back = frames(1)[0]
    again = np.trace(drift.of(model.prepare(back).pyramid, back.T_world_camera, noises)[0][3:, 3:])
    assert offs[0] == 0 and offs[-1] > 2 * offs[1] > 0
    assert again < 0.7 * offs[-1]


def test_covariances_are_symmetric_and_positive(device):
    for result in begun(device).run(frames(0, 2, 4))[1:]:
        assert np.allclose(result.covariance, result.covariance.T)
        assert np.linalg.eigvalsh(result.covariance).min() > 0


def test_a_path_with_large_deviation_is_unreliable_and_reports_it():
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    v, u = np.mgrid[:48, :64]
    depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    path = loom.track(loom.frames_from([(None, depth)] * 3, camera))
    assert path.reliable and path.to_dict()["position_deviation_m"] == max(path.deviations) < MAX_DEVIATION
    drifted = dataclasses.replace(path, deviations=(0.0, 0.02, 0.12), drifted=(2,), uncertain=(2,))
    assert not drifted.reliable and "0.12 m" in str(drifted.warnings) and drifted.to_dict()["drifted"] == [2]
    assert "120 mm" in str(drifted)


def test_each_pose_of_a_path_has_a_covariance_relative_to_the_first(device):
    slam = begun(device)
    given = [*frames(0, 2), blank(frame(3)), *frames(4, 6)]
    slam.run(given)
    path = loom.track(loom.frames_from([(f.color, f.depth) for f in given], slam.model.intrinsic), voxel_size=0.04)
    for found, poses in (
        (slam.pose_covariances, slam.trajectory.poses),
        (path.pose_covariances, path.trajectory.poses),
    ):
        assert len(found) == len(poses) == 4
        assert not found[0].matrix.any() and all((one.sigmas > 0).all() for one in found[1:])
        assert [one.center.tolist() for one in found] == poses[:, :3, 3].tolist()
    assert slam.results[2].pose_covariance is None
    assert (slam.results[-1].pose_covariance.matrix == slam.pose_covariances[-1].matrix).all()
    listed = path.to_dict()["poses"]
    assert [one["frame"] for one in listed] == [0, 1, 3, 4]
    assert listed[-1]["sigma_position"] == path.pose_covariances[-1].sigmas[3:].tolist()
    assert listed[-1]["sigma_rotation"] == path.pose_covariances[-1].sigmas[:3].tolist()


def test_covariances_rotate_with_corrected_poses():
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    v, u = np.mgrid[:48, :64]
    depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    path = loom.track(loom.frames_from([(None, depth)] * 3, camera))
    quarter = np.eye(4)
    quarter[:3, :3], quarter[:3, 3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]], [5, 6, 7]
    moved = path.with_poses(quarter @ path.trajectory.poses)
    before, after = path.pose_covariances[2], moved.pose_covariances[2]
    assert np.allclose(after.sigmas, before.sigmas[[1, 0, 2, 4, 3, 5]], rtol=1e-9)
    assert np.allclose(after.center, moved.trajectory.poses[2, :3, 3])
    assert not np.allclose(after.sigmas, before.sigmas)


def test_a_correction_that_only_shifts_leaves_a_covariance_as_it_is():
    matrix, shifted = np.diag([1.0, 2, 3, 4, 5, 6]), np.eye(4)
    shifted[:3, 3] = 9.0
    assert (rotated_covariance(matrix, np.eye(4), shifted) == matrix).all()


def test_the_error_of_a_join_grows_with_the_distance_from_the_origin_of_the_joined_map():
    T = np.eye(4)
    T[:3, 3] = [3.0, 0, 0]
    join = join_covariance(T, 0.02)
    at_origin = np.sqrt(np.diag(join))
    assert np.allclose(at_origin[:3], 0.02) and np.isclose(at_origin[3], 0.02)
    assert np.allclose(at_origin[4:], 0.02 * np.sqrt(1 + 9))


def test_errors_of_keyframes_persist_in_later_frames(device):
    """The errors of a keyframe, not those of the same frame alone, add to frames that are aligned with it."""
    model, own, kept = begun(device).model, 1e-6 * np.eye(6), 9e-6 * np.eye(6)
    drift = Drift(keyframes := Keyframes(model.device))
    for number in (0, 20):
        pyramid, pose = model.prepare(frame(number)).pyramid, frame(number).T_world_camera
        first = drift.of(pyramid, pose, ((own, own), (own, kept)))
        keyframes.add(pyramid, pose, number)
        drift.keep(pyramid)
    again = drift.of(pyramid, pose, ((own, own), (own, kept)))
    assert np.allclose(first[0], first[1])
    assert np.trace(again[1]) > np.trace(again[0]) > np.trace(first[0])
