"""Uncertainty accumulates along a path; a wrong focal length is detected; moving foreground is excluded."""

import dataclasses

import numpy as np
import pytest

import pointloom as loom
from benchmarks.room_loops import room_loop_sequence
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.trajectory import Trajectory
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.room import look_along
from pointloom.rgbd.odometry.camera_fit import (
    MAX_DISTANCE,
    MAX_PAIRS,
    MIN_ROTATION,
    CameraView,
    ViewPairs,
    _corrected_normals,
    _rays,
    fit_camera,
    rotated_pairs,
)
from pointloom.rgbd.odometry.posed_camera import fit_posed_camera
from pointloom.rgbd.odometry.results import OdometryResult
from pointloom.rgbd.slam.camera_check import assess_camera, judge_posed_camera
from pointloom.rgbd.slam.focal_check import check_focal
from pointloom.rgbd.slam.foreground import Fit, Layers, depth_between
from pointloom.rgbd.slam.frame_checks import MAX_DEVIATION, judge_drift
from pointloom.rgbd.slam.keyframes import Keyframes
from pointloom.rgbd.slam.results import TrackingResult, rotated_covariance
from pointloom.rgbd.slam.tracker import Drift, join_covariance, noises_of

from ..sequences import CAMERA, Part
from .slam_walks import HEIGHT, VOXEL, WIDTH, begun, blank, changed, error_of, fit, frame, frames, sequence, statuses


def deviated(deviation: float, status="tracked") -> TrackingResult:
    covariance = np.zeros((6, 6))
    covariance[4, 4] = deviation * deviation
    return TrackingResult(np.eye(4), status, covariance=covariance)


@pytest.mark.parametrize(
    ("fraction", "voxel_size", "status"), [(0.9, 0.04, "tracked"), (1.1, 0.04, "uncertain"), (1.5, 0.16, "tracked")]
)
def test_a_poorly_constrained_pose_is_uncertain_even_if_its_frame_fits(fraction, voxel_size, status):
    """A coarser model allows more drift. The deviation is that of the least constrained direction."""
    assert np.isclose(deviated(0.02).position_deviation, 0.02)
    result = judge_drift(deviated(fraction * MAX_DEVIATION), voxel_size)
    assert (result.status, result.has_drifted) == (status, status == "uncertain")
    assert result.reliable == (status != "uncertain")
    assert judge_drift(deviated(1.0, "lost"), 0.04).status == "lost"


def test_uncertainty_accumulates_and_is_reduced_by_revisiting(device):
    """All alignments are equally certain; only the frames they refer to differ."""
    model, covariance, offs = begun(device).model, 1e-6 * np.eye(6), []
    keyframes, noises = Keyframes(model.device), ((covariance, covariance),) * 2
    drift = Drift(keyframes)
    for number in range(0, 60, 6):
        shown = frames(number)[0]
        prepared = model.prepare(shown)
        pyramid = prepared.pyramid
        offs.append(np.trace(drift.of(pyramid, shown.T_world_camera, noises)[0][3:, 3:]))
        keyframes.add(pyramid, shown.T_world_camera, number)
        drift.keep(pyramid)
    back = frames(1)[0]
    again = np.trace(drift.of(model.prepare(back).pyramid, back.T_world_camera, noises)[0][3:, 3:])
    assert offs[0] == 0 and offs[-1] > 2 * offs[1] > 0 and again < 0.7 * offs[-1]


def test_errors_of_the_sensor_widen_the_errors_of_poses_and_not_the_checks():
    unit, check = np.eye(6), 1e-6 * np.eye(6)
    result = OdometryResult(np.eye(4), np.zeros((6, 6)), check_covariance=check, unit_covariance=unit, bias=0.01)
    checks, errors = noises_of(result)
    assert all((matrix == check).all() for matrix in checks)
    for matrix, without in zip(errors, noises_of(dataclasses.replace(result, bias=0.0))[1], strict=True):
        assert 1e-6 < (matrix - without)[0, 0] < 1e-4  # at most the bias


def test_covariances_are_symmetric_and_positive(device):
    for result in begun(device).run(frames(0, 2, 4))[1:]:
        assert np.allclose(result.covariance, result.covariance.T)
        assert np.linalg.eigvalsh(result.covariance).min() > 0


@pytest.fixture(scope="module")
def path():
    """The path of three equal frames."""
    v, u = np.mgrid[:48, :64]
    depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
    return loom.rgbd.track(loom.frames_from([(None, depth)] * 3, CAMERA))


def test_a_path_with_large_deviation_is_unreliable_and_reports_it(path):
    assert path.reliable and path.to_dict()["position_deviation_m"] == max(path.deviations) < MAX_DEVIATION
    drifted = dataclasses.replace(path, deviations=(0.0, 0.02, 0.12), drifted=(2,), uncertain=(2,))
    assert not drifted.reliable and "0.12 m" in str(drifted.warnings) and drifted.to_dict()["drifted"] == [2]
    assert "120 mm" in str(drifted)


def test_each_pose_of_a_path_has_a_covariance_relative_to_the_first(device):
    slam = begun(device)
    given = [*frames(0, 2), blank(frame(3)), *frames(4, 6)]
    slam.run(given)
    path = loom.rgbd.track(loom.frames_from([(f.color, f.depth) for f in given], slam.model.intrinsic), voxel_size=0.04)
    for tracked in (slam, path):
        found, poses = tracked.pose_covariances, tracked.trajectory.poses
        assert len(found) == len(poses) == 4
        assert not found[0].matrix.any() and all((one.sigmas > 0).all() for one in found[1:])
        assert [one.center.tolist() for one in found] == poses[:, :3, 3].tolist()
    assert slam.results[2].pose_covariance is None
    assert (slam.results[-1].pose_covariance.matrix == slam.pose_covariances[-1].matrix).all()
    listed = path.to_dict()["poses"]
    assert [one["frame"] for one in listed] == [0, 1, 3, 4]
    assert listed[-1]["sigma_position"] == path.pose_covariances[-1].sigmas[3:].tolist()
    assert listed[-1]["sigma_rotation"] == path.pose_covariances[-1].sigmas[:3].tolist()


def test_covariances_rotate_with_corrected_poses(path):
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
    at_origin = np.sqrt(np.diag(join_covariance(T, 0.02)))
    assert np.allclose(at_origin[:3], 0.02) and np.isclose(at_origin[3], 0.02)
    assert np.allclose(at_origin[4:], 0.02 * np.sqrt(1 + 9))


def test_errors_of_keyframes_persist_in_later_frames(device):
    """The errors of a keyframe, not those of the same frame alone, add to frames that are aligned with it."""
    model, own, kept = begun(device).model, 1e-6 * np.eye(6), 9e-6 * np.eye(6)
    drift = Drift(keyframes := Keyframes(model.device))
    for number in (0, 20):
        prepared, pose = model.prepare(frame(number)), frame(number).T_world_camera
        pyramid = prepared.pyramid
        first = drift.of(pyramid, pose, ((own, own), (own, kept)))
        keyframes.add(pyramid, pose, number)
        drift.keep(pyramid)
    again = drift.of(pyramid, pose, ((own, own), (own, kept)))
    assert np.allclose(first[0], first[1]) and np.trace(again[1]) > np.trace(again[0]) > np.trace(first[0])


class Wrong(Part):
    """Frames with a wrong focal length, or a principal point moved by a fraction of it."""

    def __init__(self, part: Part, factor: float = 1.0, shift: float = 0.0):
        super().__init__(part.sequence, part.count, part.every)
        K = part.intrinsic
        moved = K.cx + shift * K.fx
        self.intrinsic = PinholeCameraIntrinsic(K.width, K.height, K.fx * factor, K.fy * factor, moved, K.cy)


@pytest.fixture(scope="module")
def turning() -> Part:
    """10 frames, 4 to 7 degrees apart."""
    return Part(room_loop_sequence(120, width=80, height=60), 10, every=1)


@pytest.fixture(scope="module")
def short_sequence() -> Part:
    """8 frames, 1 cm apart."""
    return Part(room_loop_sequence(600, width=80, height=60), 8)


def path_of(part: Part) -> Trajectory:
    order = np.arange(len(part))[:, None]
    return Trajectory(part.poses, ids=np.hstack([order, order, order + 1]))


def test_the_right_focal_length_is_not_reported(turning, device):
    check = check_focal(turning, path_of(turning), depth_max=4.0, device=device)
    assert check is not None and check.factor == 1.0
    assert check.reliable and "no other focal length fits better" in str(check)


def test_the_keyframes_of_a_run_give_the_true_focal_length():
    K, images = sequence().intrinsic, frames(*range(0, 36, 6))
    camera = PinholeCameraIntrinsic(K.width, K.height, 1.25 * K.fx, 1.25 * K.fy, K.cx, K.cy)
    slam = loom.rgbd.DenseSLAM(camera, T_init=images[0].T_world_camera, voxel_size=VOXEL)
    slam.run(images)
    check = slam.check_camera()
    assert not check.reliable and abs(check.factor * 1.25 - 1) < 0.03
    views = slam.keyframes.views
    assert len(slam.keyframes) <= len(views.poses) == len(views.cells) and views.numbers[0] == 0


@pytest.mark.parametrize("factor", [1.25, 0.9, 1.1])
def test_a_wrong_focal_length_is_reported_with_a_better_one(turning, factor):
    check = check_focal(Wrong(turning, factor), path_of(turning), depth_max=4.0)
    assert abs(check.factor * factor - 1) < 0.03 and not any(check.center) and not check.distortion
    right = check_focal(turning, path_of(turning), depth_max=4.0)
    assert abs(check.residual_there / right.residual - 1) < 0.05 and check.residual > 1.2 * right.residual
    assert f"about {check.factor:.3g} times as long" in str(check.warnings)


class Repeated(Wrong):
    """The frames of a part in 60 rooms, 5 m apart."""

    def __len__(self):
        return 60 * self.count

    def read(self, index):
        return super().read(index % self.count)


def test_a_wrong_focal_length_of_a_long_path_is_reported(turning):
    """Pairs of near frames are chosen from all frames: 40 frames spread over the path are all in different rooms."""
    frames, poses = Repeated(turning, 1.1), np.tile(path_of(turning).poses, (60, 1, 1))
    poses[:, 0, 3] += 5.0 * (np.arange(len(frames)) // turning.count)
    check = check_focal(frames, Trajectory(poses), depth_max=4.0)
    assert check is not None and abs(check.factor * 1.1 - 1) < 0.03
    assert f"(sigma {check.factor_deviation:.2g})" in str(check.warnings) and 0 < check.factor_deviation < 0.05


@pytest.mark.parametrize("parameter", range(5))
def test_planes_are_those_of_the_points_with_corrected_rays(parameter):
    """Focal length, principal point (u, v), distortion, fx / fy: the normal is that of the surface of moved points."""
    rng, values = np.random.default_rng(parameter), np.zeros(6)
    values[parameter], step = 0.15, 1e-5
    x, y = rng.uniform(-0.5, 0.5, (2, 200))
    normals = rng.normal(size=(3, 200)) * [[0.4], [0.4], [1.0]]
    normals /= np.sqrt((normals**2).sum(axis=0))

    def point(x, y):
        there = np.stack([*_rays(x, y, values), np.ones_like(x)])
        return there / (normals[0] * x + normals[1] * y + normals[2])

    along_x, along_y = (point(x + a, y + b) - point(x - a, y - b) for a, b in ((step, 0), (0, step)))
    expected = np.cross(along_x.T, along_y.T)
    expected /= np.sqrt((expected**2).sum(axis=1, keepdims=True))
    found = _corrected_normals(np.stack([np.ones(200), *normals, x, y]), values).T
    assert np.abs(np.abs((found * expected).sum(axis=1)) - 1).max() < 1e-7


def test_a_wrong_principal_point_is_reported(turning):
    check = check_focal(Wrong(turning, shift=0.4), path_of(turning), depth_max=4.0)
    assert abs(check.center[0] + 0.4 * turning.intrinsic.fx) < 0.05 * turning.intrinsic.fx and not check.center[1]
    assert "a principal point moved by" in str(check.warnings)


def test_distorted_rays_are_reported(turning):
    """Each pixel gets the depth of the ray that a lens with distortion would see there."""

    class Bent(Part):
        def read(self, index):
            frame, K = super().read(index), self.intrinsic
            v, u = np.mgrid[: K.height, : K.width]
            x, y = (u - K.cx) / K.fx, (v - K.cy) / K.fy
            factor = 1.0 + 0.4 * (x * x + y * y)
            column, row = np.rint(x * factor * K.fx + K.cx).astype(int), np.rint(y * factor * K.fy + K.cy).astype(int)
            is_seen = (column >= 0) & (row >= 0) & (column < K.width) & (row < K.height)
            depth = np.where(is_seen, frame.depth[row.clip(0, K.height - 1), column.clip(0, K.width - 1)], 0)
            return dataclasses.replace(frame, depth=depth.astype(frame.depth.dtype))

    check = check_focal(Bent(turning.sequence, turning.count, turning.every), path_of(turning), depth_max=4.0)
    assert abs(check.distortion - 0.4) < 0.1 and "a radial distortion of 0." in str(check.warnings)


def noisy_views(yaws, tilts, step, noise, seed, walls=()):
    """Views of a floor 1.5 m below, and of walls (axis, distance), with noise of depth [m]; their poses and camera."""
    K, rng, views, poses = PinholeCameraIntrinsic(80, 60, 66.0, 66.0, 39.5, 29.5), np.random.default_rng(seed), [], []
    v, u = np.mgrid[:60, :80]
    rays = np.stack([(u - K.cx) / K.fx, (v - K.cy) / K.fy, np.ones(u.shape)], -1)
    for k, (yaw, tilt) in enumerate(zip(yaws, tilts, strict=True)):
        direction = np.array([np.cos(yaw) * np.cos(tilt), np.sin(yaw) * np.cos(tilt), np.sin(tilt)])
        poses.append(look_along(np.array([step * k, 0.0, 1.5]), direction))
        seen = rays @ poses[-1][:3, :3].T
        depths = [np.where(-seen[..., 2] > 0.3, 1.5 / np.maximum(-seen[..., 2], 0.3), np.inf)]
        for axis, distance in walls:
            away = distance - poses[-1][axis, 3]
            depths.append(np.where(seen[..., axis] > 0.3, away / np.maximum(seen[..., axis], 0.3), np.inf))
        z = np.minimum.reduce(depths)
        z = np.where(np.isfinite(z), z + rng.normal(0, noise, z.shape), 0.0)
        nearness = np.divide(1.0, z, out=np.zeros(z.shape), where=z > 0)
        views.append(CameraView(nearness.astype(np.float32), (K.fx, K.fy, K.cx, K.cy)))
    return views, poses, K


def fitted(views, poses):
    return fit_camera(ViewPairs(views, poses, rotated_pairs(poses)))


@pytest.mark.slow
def test_a_floor_alone_does_not_determine_the_camera():
    turns = np.arange(10)
    views, poses, K = noisy_views(0.25 * turns, -0.9 + 0.2 * np.sin(1.7 * turns), 0.1, 0.004, seed=3)
    fit = fitted(views, poses)
    assert len(fit.pairs) >= 10 and np.isinf(fit.deviations[0]) and fit.values[0] == 0
    assert assess_camera(views, poses, K) is None


def test_walls_along_the_path_determine_no_factor_of_the_depth():
    """Noise of normals is no information: it fits a depth that is 10 % shorter."""
    turns = np.arange(12)
    views, poses, K = noisy_views(
        0.3 + 0.02 * np.sin(1.3 * turns), 0.02 * np.cos(turns) - 0.3, 0.07, 0.004, 3, [(1, 1.2)]
    )
    camera, factor, _ = judge_posed_camera(fit_posed_camera(views, poses), K)
    assert factor == 1.0 and (camera is None or camera.reliable)


def test_deviations_hardly_depend_on_noise():
    """The information of a pair without noise may be singular: one such pair made the principal point undetermined."""
    turns = np.arange(10)
    rotations = 0.2 * (turns - 4.5), -0.6 + 0.25 * np.sin(1.7 * turns)
    fits = [fitted(*noisy_views(*rotations, 0.08, 0.01, seed, [(1, 2.0)])[:2]) for seed in (0, 2)]
    first, second = (fit.deviations[:4] for fit in fits)
    assert np.isfinite(first).all() and (np.abs(np.log(first / second)) < np.log(2)).all()
    assert all((np.abs(fit.values[:4]) < 2 * fit.deviations[:4]).all() for fit in fits)


@pytest.mark.slow
def test_noise_of_depth_makes_the_focal_length_hardly_longer():
    """By 0.019 with derivatives at the planes themselves."""
    turns, walls = np.arange(10), [(0, 2.5)]
    rotations = 0.08 * (turns - 4.5), -0.5 + 0.2 * np.sin(1.7 * turns)
    fits = [fitted(*noisy_views(*rotations, 0.05, 0.01, seed, walls)[:2]) for seed in range(6)]
    assert abs(np.mean([fit.values[0] for fit in fits])) < 0.014


def test_a_camera_with_little_rotation_gives_no_focal_check(short_sequence):
    assert check_focal(short_sequence, path_of(short_sequence), depth_max=4.0) is None


def test_uncertain_poses_and_unreadable_frames_give_no_focal_check(turning, monkeypatch):
    path = path_of(turning)
    assert check_focal(turning, path, depth_max=4.0, uncertain=range(2, 10)) is None

    def break_off(index):
        raise FileError("frame.png", "damaged")

    monkeypatch.setattr(turning, "read", break_off)
    assert check_focal(turning, path, depth_max=4.0) is None


def test_pairs_are_rotated_enough_and_near(turning):
    poses = path_of(turning).poses
    pairs = rotated_pairs(poses)
    assert 3 <= len(pairs) <= MAX_PAIRS
    for first, second in pairs:
        motion = np.linalg.inv(poses[first]) @ poses[second]
        angle = np.arccos((np.trace(motion[:3, :3]) - 1) / 2)
        assert angle > MIN_ROTATION - 1e-6 and np.linalg.norm(motion[:3, 3]) < MAX_DISTANCE


V, U = np.mgrid[:HEIGHT, :WIDTH]


def with_object(original, left, width, depth=600, seed=0):
    """A frame with a near object in some of its columns, whose pattern moves with the camera."""
    rng = np.random.default_rng([seed, original.timestamp is not None, int(1000 * (original.timestamp or 0))])
    mask = (left <= U) & (left + width > U)
    z = depth + 40 * np.sin((U - left) / 6) + 20 * np.cos(V / 8) + rng.normal(0, 1.5, U.shape)
    shade = 120 + 60 * np.sin((U - left) / 3) * np.cos(V / 4)
    image, color = original.depth.copy(), original.color.copy()
    image[mask] = np.rint(z[mask]).astype(image.dtype)
    color[mask] = shade[mask][:, None].astype(np.uint8)
    return changed(original, depth=image, color=color)


def off(results, true):
    pairs = zip(results, true, strict=True)
    return max(error_of(result, shown)[0] for result, shown in pairs if result.pose is not None)


def test_foreground_fixed_to_the_camera_is_excluded(device):
    source, slam = frames(*range(14)), begun(device)
    results = slam.run([with_object(f, 54, 26) for f in source])
    assert all(fit(results)) and len(results) == 14
    assert off(results, source) < VOXEL and slam.fixed_parts.hidden[:, 56:].mean() > 0.8
    assert not slam.fixed_parts.hidden[:, :50].any()
    assert slam.fixed_parts.note.startswith("an object that moves with the camera, 0.6")
    assert np.asarray(slam.render(results[-1].pose).depth)[:, 54:].max() > 1.0, "behind it the room is seen"


@pytest.mark.slow
def test_tracking_fails_without_foreground_exclusion():
    source, slam = frames(*range(14)), begun("cpu", leave_out_moving=False)
    results = slam.run([with_object(f, 54, 26) for f in source])
    assert "lost" in statuses(results) or off(results, source) > 0.06


@pytest.mark.slow
def test_foreground_moving_before_the_camera_is_excluded(device):
    source, slam = frames(*range(14)), begun(device)
    results = slam.run([with_object(f, 20 + int(14 * np.sin(k / 3)), 30) for k, f in enumerate(source)])
    assert all(fit(results[2:])), "detection takes a frame or two"
    assert off(results[2:], source[2:]) < VOXEL / 2


def test_nothing_is_excluded_in_a_static_scene(device):
    source, slam = frames(*range(14)), begun(device)
    slam.run(source)
    assert slam.foreground.frames == 0 and slam.status_counts["tracked"] == 14 and not slam.fixed_parts.note


def test_a_stationary_camera_excludes_nothing():
    slam = begun("cpu")
    slam.run([with_object(changed(frame(0), timestamp=k / 30), 54, 26) for k in range(10)])
    assert slam.foreground.frames == 0 and not slam.fixed_parts.note


@pytest.mark.slow
def test_exclusion_ends_after_the_foreground_disappears():
    """The object moves in the first six frames. The part near it is static again after eight checks."""
    source, slam, is_excluded = frames(*range(36)), begun("cpu"), []
    for k, shown in enumerate(source):
        slam.step(with_object(shown, 20 + int(14 * np.sin(k / 3)), 30) if k < 6 else shown)
        is_excluded.append(slam.foreground.is_apart)
    assert all(is_excluded[2:6]) and not any(is_excluded[-8:])
    assert slam.foreground.frames == sum(is_excluded) and slam.status_counts["lost"] == 0


def test_a_part_fixed_to_the_camera_is_hidden_until_it_disappears():
    source, slam, is_hidden = frames(*range(10)), begun("cpu"), []
    for k, shown in enumerate(source):
        slam.step(with_object(shown, 54, 26) if k < 4 else shown)
        is_hidden.append(slam.fixed_parts.hidden is not None)
    assert all(is_hidden[2:4]) and not any(is_hidden[5:]) and slam.fixed_parts.note


def test_a_model_of_few_frames_finds_no_camera_that_was_lost_for_long():
    source, slam = frames(0, 1, 2), begun("cpu")
    dark = changed(source[2], depth=np.zeros_like(source[2].depth), timestamp=None)
    results = slam.run([source[0], source[1], *[dark] * 6, source[2]])
    assert statuses(results) == ["tracked", "tracked", *["lost"] * 7]
    assert results[-1].warnings == ("the model has only 2 frames, too few for relocalization",)


def test_the_depth_limit_is_between_the_two_classes():
    near, far = np.full(300, 1 / 0.8, np.float32), np.full(700, 1 / 2.5, np.float32)
    assert 0.8 < depth_between(np.concatenate([near, far, np.zeros(500, np.float32)])) < 2.5
    assert depth_between(np.concatenate([near[:30], far])) == 0.0, "too little is near"
    assert depth_between(np.zeros(100, np.float32)) == 0.0


def layers(full, far, agreement=0.95, **changes):
    T = np.eye(4)
    T[0, 3] = 0.05
    values = {"transformation": T, "information": np.eye(6), "overlap": 0.8, "fitness": 0.75}
    result = OdometryResult(**{**values, "smallest_eigenvalue": 0.1, **changes})
    return Layers(Fit(full, agreement, result), Fit(far, agreement, result), np.eye(4))


def test_layers_are_separate_where_the_background_fits_better_than_all():
    assert layers(2.0, 0.2).are_apart and not layers(2.0, 0.2).are_one
    assert not layers(0.5, 0.3).are_apart and layers(0.5, 0.3).are_one
    assert not layers(2.0, 0.2, agreement=0.8).are_apart, "what lies behind is not found either"
    assert not layers(2.0, 0.2, overlap=0.5).are_apart
    far = np.eye(4)
    far[0, 3] = 0.4
    assert not layers(2.0, 0.2, transformation=far).are_apart, "views so far apart differ by themselves"
    assert not layers(2.0, 0.2, contradiction="the brightness does not agree").are_apart
    assert not layers(4.0, 4.0).are_one, "both fit badly"
    assert not layers(0.5, 0.3, transformation=np.eye(4)).are_one, "a camera that stands still tells nothing"


def test_the_background_must_constrain_the_pose():
    assert np.allclose(layers(2.0, 0.2).pose[:3, 3], [0.05, 0, 0])
    assert layers(2.0, 0.2, smallest_eigenvalue=0.01).pose is None
