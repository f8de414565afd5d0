"""What odometry refuses, and what it says then."""

from __future__ import annotations

import numpy as np
import pytest

import pointloom as loom

from .made_frames import CAMERA, picture, pose_of

od = loom.odometry
DEPTH, COLOR = picture(pose_of([0, 0, 0], [0, 0, 0]))


def test_colour_of_another_size_is_refused():
    with pytest.raises(ValueError, match="160 x 120"):
        od.OdometryFrame(DEPTH, CAMERA, COLOR[:50])


def test_a_camera_of_another_size_is_refused():
    with pytest.raises(ValueError, match="made for 160 x 120"):
        od.OdometryFrame(DEPTH[:100], CAMERA)


def test_images_of_different_sizes_are_refused():
    small = loom.RGBDImage(COLOR[:60, :80], DEPTH[:60, :80])
    with pytest.raises(ValueError, match="80 x 60 pixels, but the source has 160 x 120"):
        od.compute_rgbd_odometry(loom.RGBDImage(COLOR, DEPTH), small, CAMERA)


def test_unknown_weights_are_refused():
    image = loom.RGBDImage(COLOR, DEPTH)
    with pytest.raises(ValueError, match="'robust' or 'open3d', got 'huber'"):
        od.compute_rgbd_odometry(image, image, CAMERA, weights="huber")


@pytest.mark.parametrize("size", [(1, 1), (2, 3), (5, 200)])
def test_tiny_frames_are_no_success_and_no_error(device, size):
    camera = loom.PinholeCameraIntrinsic(size[1], size[0], 50.0, 50.0, size[1] / 2, size[0] / 2)
    one = od.OdometryFrame(np.ones(size, np.float32), camera, device=device)
    assert not od.align_frames(one, one).success


def test_eight_bits_are_no_depth():
    with pytest.raises(TypeError, match=r"depth: expected 16-bit integers or float metres, got uint8"):
        od.OdometryFrame((10 * DEPTH).astype(np.uint8), CAMERA, depth_scale=10.0)


def test_a_matrix_without_a_focal_length_is_no_camera():
    image = loom.RGBDImage(COLOR, DEPTH)
    with pytest.raises(
        ValueError, match="pinhole_camera_intrinsic: focal lengths of 1 and 1 px see nearly a half-space"
    ):
        od.compute_rgbd_odometry(image, image, np.eye(3))
    found = od.compute_rgbd_odometry(image, image, CAMERA.matrix)
    assert found.success and repr(found).startswith("OdometryResult(success, fitness 0.9")
