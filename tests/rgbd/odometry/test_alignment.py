"""The motion between two frames is accurate, reproducible and independent of the exposure."""

import numpy as np
import pytest

import pointloom as loom

from .made_frames import CAMERA, errors_of, frame, picture, pose_of

od = loom.odometry
METHODS = list(od.Method)
FIRST, SECOND = pose_of([0, 0, 0], [0, 0, 0]), pose_of([0.03, -0.05, 0.02], [0.05, -0.03, 0.04])
MOTION = np.linalg.inv(SECOND) @ FIRST  # of the first frame into the second


@pytest.mark.parametrize("method", METHODS)
def test_the_motion_between_exact_images_is_estimated(device, method, tolerances):
    result = od.align_frames(frame(FIRST, device), frame(SECOND, device), method=method)
    angle, distance = errors_of(result.transformation, MOTION)
    assert result.reliable, result.warnings
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
    depth, color = picture(SECOND)
    other = np.clip(gain * color.astype(float) + offset, 0, 255).astype(np.uint8)
    source = frame(FIRST, device)
    target = od.OdometryFrame(depth, CAMERA, other, device=device)
    result = od.align_frames(source, target, method=od.Method.Intensity)
    angle, distance = errors_of(result.transformation, MOTION)
    assert result.reliable, result.warnings
    assert angle < 0.2 and distance < 8


def test_the_information_counts_the_pixels_of_the_full_picture(device):
    one = frame(FIRST, device)
    information = od.align_frames(one, one).information
    assert 0.9 * CAMERA.width * CAMERA.height < information[5, 5] <= CAMERA.width * CAMERA.height
    assert np.allclose(information, information.T) and np.linalg.eigvalsh(information)[0] > 0


def test_a_frame_of_device_images_equals_one_of_host_images(device, tolerances):
    from pointloom.kernels.lang import float32
    from pointloom.kernels.memory import upload

    depth, color = picture(SECOND)
    picture_frame = od.OdometryFrame(depth, CAMERA, color, device=device)
    shade = (color @ np.array([0.299, 0.587, 0.114]) / 255).astype(np.float32)
    maps = [upload(values.reshape(-1), float32, picture_frame.device) for values in (depth, shade)]
    made = od.OdometryFrame._from_device_maps(maps[0], maps[1], CAMERA)
    results = [od.align_frames(frame(FIRST, device), target).transformation for target in (picture_frame, made)]
    assert np.abs(results[0] - results[1]).max() < tolerances.odometry_maps


def test_frames_of_different_cameras_compare_at_levels_of_like_size(device):
    wide_camera = loom.PinholeCameraIntrinsic(320, 240, 280.0, 280.0, 159.5, 119.5)
    result = od.align_frames(frame(FIRST, device), frame(SECOND, device, wide_camera))
    assert result.reliable, result.warnings
    assert errors_of(result.transformation, MOTION)[0] < 0.3


def test_a_result_unpacks_as_open3ds(device):
    one = frame(FIRST, device)
    success, transformation, information = od.align_frames(one, one)
    assert success and transformation.shape == (4, 4) and information.shape == (6, 6)
