"""The covariance of a motion between two frames has the size of its errors."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.rgbd import check_rows as at
from pointloom.registration.rigid import rotation_vector
from pointloom.rgbd.odometry.motion_checks import frame_noise, model_noise

from .made_frames import frame, pose_of

Method = loom.odometry.Method
MOVED = pose_of((0.02, -0.03, 0.01), (0.02, -0.01, 0.03))


def aligned(device, seed, noise=1.0, method=Method.PointToPlane):
    source = frame(MOVED, device, noise=noise, seed=2 * seed)
    target = frame(np.eye(4), device, noise=noise, seed=2 * seed + 1)
    return loom.odometry.align_frames(source, target, method=method)


def components(result):
    """The error along the eigenvectors of the covariance, in standard deviations [6]."""
    error = MOVED @ np.linalg.inv(result.transformation)
    motion = np.concatenate([rotation_vector(error[:3, :3]), error[:3, 3]])
    scale = np.sqrt(np.diag(result.covariance))
    values, vectors = np.linalg.eigh(result.covariance / np.outer(scale, scale))
    return vectors.T @ (motion / scale) / np.sqrt(values)


@pytest.mark.parametrize("method", [Method.PointToPlane, Method.Hybrid])
def test_errors_of_noisy_frames_are_of_the_size_of_the_standard_deviations(device, method):
    found = np.concatenate([components(aligned(device, seed, method=method)) for seed in range(6)])
    assert 0.25 < np.sqrt(np.mean(found**2)) < 1.5  # below 1: coarse pixels round the surfaces, which is no noise


def test_more_noise_gives_larger_standard_deviations(device):
    less, more = (np.sqrt(np.diag(aligned(device, 0, noise).covariance)) for noise in (0.5, 2.0))
    assert (more > 1.2 * less).all()


def test_checks_assume_larger_errors_than_those_of_frames(device):
    result = aligned(device, 0)
    assert np.linalg.eigvalsh(result.check_covariance - result.covariance).min() > 0


def test_the_unit_covariance_is_that_of_a_shift_in_the_middle_of_the_pixels(device):
    result = aligned(device, 0)
    middle = np.linalg.inv(result.unit_covariance)  # information, which adds at the center of the inliers
    assert np.allclose(middle[3:, 3:], np.eye(3), atol=1e-6)


def test_frames_without_noise_have_a_positive_covariance(device):
    same = frame(np.eye(4), device)
    assert np.linalg.eigvalsh(loom.odometry.align_frames(same, same).covariance).min() > 0


def sums(excess):
    values = np.zeros(28)
    values[[at.PLANES, at.EXCESS]] = 100.0, 100.0 * excess
    return values


def test_large_residuals_count_as_errors_of_parts_of_the_image():
    small, large = (frame_noise(sums(excess), False) / excess for excess in (0.03, 0.3))
    assert large > 4 * small
    assert frame_noise(sums(0.3), True) > 1.5 * frame_noise(sums(0.3), False)


def test_residuals_do_not_contain_the_errors_of_a_model():
    assert model_noise(sums(0.01)) == model_noise(sums(0.1)) < model_noise(sums(0.2))


def test_frames_without_depth_have_no_finite_covariance(device):
    blank = loom.odometry.OdometryFrame(
        np.zeros((48, 64), np.float32), loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5), device=device
    )
    result = loom.odometry.align_frames(blank, blank)
    assert np.isinf(result.covariance).all() and np.isinf(result.check_covariance).all()
