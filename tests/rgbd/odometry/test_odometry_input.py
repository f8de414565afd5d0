"""Invalid inputs of odometry and their error messages."""

import numpy as np
import pytest

import pointloom as loom

from .made_frames import CAMERA, picture, pose_of

od = loom.odometry
DEPTH, COLOR = picture(pose_of([0, 0, 0], [0, 0, 0]))
IMAGE, SMALL = loom.RGBDImage(COLOR, DEPTH), loom.RGBDImage(COLOR[:60, :80], DEPTH[:60, :80])


@pytest.mark.parametrize(
    ("error", "words", "call"),
    [
        (ValueError, "160 x 120", lambda: od.OdometryFrame(DEPTH, CAMERA, COLOR[:50])),
        (ValueError, "160 x 120", lambda: od.OdometryFrame(DEPTH[:100], CAMERA)),
        (ValueError, "80 x 60", lambda: od.compute_rgbd_odometry(IMAGE, SMALL, CAMERA)),
        (ValueError, "got 'huber'", lambda: od.compute_rgbd_odometry(IMAGE, IMAGE, CAMERA, weights="huber")),
        (TypeError, "depth: .*uint8", lambda: od.OdometryFrame((10 * DEPTH).astype(np.uint8), CAMERA)),
        (ValueError, "pinhole_camera_intrinsic: ", lambda: od.compute_rgbd_odometry(IMAGE, IMAGE, np.eye(3))),
    ],
)
def test_wrong_pictures_cameras_and_weights_are_refused(error, words, call):
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
