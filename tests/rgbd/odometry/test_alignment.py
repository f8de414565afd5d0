"""The motion between two frames is accurate and reproducible, its covariance fits, and invalid input is rejected."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.rgbd import check_rows as at
from pointloom.registration.rigid import rotation_vector
from pointloom.rgbd.odometry.motion_checks import bias_of, frame_noise, model_noise

from .made_frames import CAMERA, errors_of, frame, image, pose_of

od = loom.rgbd
METHODS = ("point-to-plane", "intensity", "hybrid")
FIRST, SECOND = pose_of([0, 0, 0], [0, 0, 0]), pose_of([0.03, -0.05, 0.02], [0.05, -0.03, 0.04])
MOTION = np.linalg.inv(SECOND) @ FIRST  # of the first frame into the second


@pytest.mark.parametrize("method", METHODS)
def test_the_motion_between_exact_images_is_estimated(device, method, tolerances):
    result = od.align_frames(frame(FIRST, device), frame(SECOND, device), method=method)
    angle, distance = errors_of(result.transformation, MOTION)
    assert result.reliable, result.warnings
    assert angle < tolerances.odometry_made_angle and distance < tolerances.odometry_made_distance


@pytest.mark.parametrize("shift", [(-0.02, 0.05, 0.0), (0.0, -0.02, 0.05), (0.05, 0.0, -0.02)])
def test_shifts_of_opposite_signs_are_estimated(device, tolerances, shift):
    moved = pose_of([0, 0, 0], shift)
    result = od.align_frames(frame(FIRST, device), frame(moved, device))
    angle, distance = errors_of(result.transformation, np.linalg.inv(moved))
    assert angle < tolerances.odometry_made_angle and distance < tolerances.odometry_made_distance


def test_depth_alone_is_enough(device, tolerances):
    frames = [frame(pose, device, with_color=False, noise=1.0, seed=k) for k, pose in enumerate((FIRST, SECOND))]
    result = od.align_frames(*frames)
    angle, distance = errors_of(result.transformation, MOTION)
    assert result.reliable and np.isnan(result.intensity_rmse)
    assert angle < tolerances.odometry_noisy_angle and distance < tolerances.odometry_noisy_distance


def test_a_start_nearby_is_used(device):
    far = pose_of([0.0, 0.5, 0.0], [0.4, 0.0, 0.0])
    motion = np.linalg.inv(far) @ FIRST
    frames = frame(FIRST, device), frame(far, device)
    result = od.align_frames(*frames, motion @ pose_of([0.01, 0.02, 0.0], [0.02, 0.0, 0.01]))
    assert result.reliable, result.warnings
    assert errors_of(result.transformation, motion)[0] < 0.3


@pytest.mark.parametrize(("gain", "offset"), [(0.7, 0.0), (1.2, -20.0)])
def test_another_exposure_changes_little(device, gain, offset):
    depth, color = image(SECOND)
    other = np.clip(gain * color.astype(float) + offset, 0, 255).astype(np.uint8)
    source = frame(FIRST, device)
    result = od.align_frames(source, od.OdometryFrame(depth, CAMERA, other, device=device), method="intensity")
    angle, distance = errors_of(result.transformation, MOTION)
    assert result.reliable, result.warnings
    assert angle < 0.2 and distance < 8


def test_the_information_counts_the_pixels_of_the_full_image(device):
    one = frame(FIRST, device)
    information = od.align_frames(one, one).information
    assert 0.9 * CAMERA.width * CAMERA.height < information[5, 5] <= CAMERA.width * CAMERA.height
    assert np.allclose(information, information.T) and np.linalg.eigvalsh(information)[0] > 0


def test_frames_of_different_cameras_compare_at_levels_of_like_size(device):
    wide_camera = loom.PinholeCameraIntrinsic(320, 240, 280.0, 280.0, 159.5, 119.5)
    result = od.align_frames(frame(FIRST, device), frame(SECOND, device, wide_camera))
    assert result.reliable, result.warnings
    assert errors_of(result.transformation, MOTION)[0] < 0.3


def test_frames_of_another_camera_of_the_same_size_change_no_later_result(device):
    narrow, results = loom.PinholeCameraIntrinsic(160, 120, 190.0, 190.0, 75.0, 62.0), []
    for camera in (CAMERA, narrow, CAMERA, narrow):
        frames = [frame(pose, device, camera) for pose in (FIRST, SECOND)]
        results.append(od.align_frames(*frames).transformation)
    assert np.array_equal(results[0], results[2]) and np.array_equal(results[1], results[3])


def test_a_result_unpacks_as_open3ds(device):
    one = frame(FIRST, device)
    success, transformation, information = od.align_frames(one, one)
    assert success and transformation.shape == (4, 4) and information.shape == (6, 6)


MOVED = pose_of((0.02, -0.03, 0.01), (0.02, -0.01, 0.03))


def aligned(device, seed, noise=1.0, method="point-to-plane"):
    source = frame(MOVED, device, noise=noise, seed=2 * seed)
    return loom.rgbd.align_frames(source, frame(np.eye(4), device, noise=noise, seed=2 * seed + 1), method=method)


def components(result, covariance):
    """The error along the eigenvectors of a covariance, in standard deviations [6]."""
    error = MOVED @ np.linalg.inv(result.transformation)
    motion = np.concatenate([rotation_vector(error[:3, :3]), error[:3, 3]])
    scale = np.sqrt(np.diag(covariance))
    values, vectors = np.linalg.eigh(covariance / np.outer(scale, scale))
    return vectors.T @ (motion / scale) / np.sqrt(values)


@pytest.mark.parametrize("method", ["point-to-plane", "hybrid"])
def test_errors_of_noisy_frames_are_of_the_size_of_the_standard_deviations(device, method):
    results = [aligned(device, seed, method=method) for seed in range(6)]
    for kind in ("covariance", "check_covariance"):
        found = np.concatenate([components(result, getattr(result, kind)) for result in results])
        assert 0.25 < np.sqrt(np.mean(found**2)) < 1.5  # below 1: coarse pixels round the surfaces, which is no noise


def test_more_noise_gives_larger_standard_deviations(device):
    less, more = (np.sqrt(np.diag(aligned(device, 0, noise).covariance)) for noise in (0.5, 2.0))
    assert (more > 1.2 * less).all()


def test_checks_assume_errors_of_a_model_that_residuals_do_not_contain(device):
    """Residuals of a frame with itself are zero, but those of a model that contains its errors are small, too."""
    one = frame(np.eye(4), device)
    same, noisy = loom.rgbd.align_frames(one, one), aligned(device, 0)
    sigmas, checks, usual = (
        np.sqrt(np.diag(matrix)) for matrix in (same.covariance, same.check_covariance, noisy.check_covariance)
    )
    assert sigmas.max() < 1e-5 and (0.1 * usual < checks).all() and (checks < usual).all()


def test_the_unit_covariance_is_that_of_a_shift_in_the_middle_of_the_pixels(device):
    middle = np.linalg.inv(aligned(device, 0).unit_covariance)  # information, which adds at the center of the inliers
    assert np.allclose(middle[3:, 3:], np.eye(3), atol=1e-6)


def test_frames_without_noise_have_a_positive_covariance(device):
    same = frame(np.eye(4), device)
    assert np.linalg.eigvalsh(loom.rgbd.align_frames(same, same).covariance).min() > 0


def sums(excess):
    values = np.zeros(28)
    values[[at.PLANE_COUNT, at.EXCESS_SUM]] = 100.0, 100.0 * excess
    return values


def test_large_residuals_count_as_errors_of_parts_of_the_image():
    small, large = (frame_noise(sums(excess), False) / excess for excess in (0.03, 0.3))
    assert large > 4 * small and frame_noise(sums(0.3), True) > 1.5 * frame_noise(sums(0.3), False)


def test_residuals_do_not_contain_the_errors_of_a_model():
    assert model_noise(sums(0.01)) == model_noise(sums(0.1)) < model_noise(sums(0.2))


def test_the_bias_is_the_part_of_the_residuals_that_noise_does_not_explain():
    found = []
    for excess in (0.0, 0.1, 0.2, 1.0):
        values = sums(excess)
        values[at.DISTANCE_SQUARES] = 100.0 * 0.01**2
        found.append(bias_of(values))
    assert found == pytest.approx([0.0, 0.0, 0.01 * np.sqrt(0.5), 0.01 * np.sqrt(0.9)])
    assert bias_of(np.zeros(28)) == 0.0


def test_frames_without_depth_have_no_finite_covariance(device):
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
    blank = od.OdometryFrame(np.zeros((48, 64), np.float32), camera, device=device)
    result = loom.rgbd.align_frames(blank, blank)
    assert np.isinf(result.covariance).all() and np.isinf(result.check_covariance).all()


DEPTH, COLOR = image(pose_of([0, 0, 0], [0, 0, 0]))
IMAGE, SMALL = loom.RGBDImage(COLOR, DEPTH), loom.RGBDImage(COLOR[:60, :80], DEPTH[:60, :80])


@pytest.mark.parametrize(
    ("error", "words", "call"),
    [
        (ValueError, "160 x 120", lambda: od.OdometryFrame(DEPTH, CAMERA, COLOR[:50])),
        (ValueError, "160 x 120", lambda: od.OdometryFrame(DEPTH[:100], CAMERA)),
        (ValueError, "80 x 60", lambda: od.compute_rgbd_odometry(IMAGE, SMALL, CAMERA)),
        (ValueError, "got 'huber'", lambda: od.compute_rgbd_odometry(IMAGE, IMAGE, CAMERA, method="huber")),
        (TypeError, "depth: .*uint8", lambda: od.OdometryFrame((10 * DEPTH).astype(np.uint8), CAMERA)),
        (ValueError, "pinhole_camera_intrinsic: ", lambda: od.compute_rgbd_odometry(IMAGE, IMAGE, np.eye(3))),
    ],
)
def test_wrong_images_cameras_and_methods_are_refused(error, words, call):
    with pytest.raises(error, match=words):
        call()


def test_a_matrix_is_a_camera():
    result = od.compute_rgbd_odometry(IMAGE, IMAGE, CAMERA.matrix)
    assert result.reliable and repr(result).startswith("OdometryResult(reliable, fitness 0.9")


@pytest.mark.parametrize("size", [(1, 1), (2, 3), (5, 200)])
def test_tiny_frames_are_no_success_and_no_error(device, size):
    camera = loom.PinholeCameraIntrinsic(size[1], size[0], 50.0, 50.0, size[1] / 2, size[0] / 2)
    one = od.OdometryFrame(np.ones(size, np.float32), camera, device=device)
    assert not od.align_frames(one, one).reliable


def test_steps_and_the_depth_range_are_limited(device):
    images = [image(pose) for pose in (FIRST, SECOND)]
    pair = [loom.RGBDImage(color, depth, depth_trunc=10.0, device=device) for depth, color in images]
    full = od.compute_rgbd_odometry(*pair, CAMERA)
    short = od.compute_rgbd_odometry(*pair, CAMERA, max_iterations=(1, 1, 1))
    assert short.iterations == 3 < full.iterations
    far, none = (od.compute_rgbd_odometry(*pair, CAMERA, depth_min=nearest) for nearest in (2.0, 3.9))
    assert 0 < far.inliers < 0.9 * full.inliers and none.inliers == 0 and not none.reliable
