"""Odometry of real frames: the kitchen's poses, and failures for frames of different locations."""

import numpy as np
import pytest
from PIL import Image

import pointloom as loom

from .made_frames import errors_of

od = loom.odometry


@pytest.fixture(scope="module")
def kitchen(real_file):
    """A function that prepares a frame, and its pose."""
    frames = loom.open_dataset(real_file("rgbd-7scenes-redkitchen"))

    def prepare(i):
        frame = frames.read(int(i))
        return od.OdometryFrame(frame.depth, frames.intrinsic, frame.color), frame.T_world_camera

    return prepare


@pytest.mark.slow
def test_ten_pairs_of_the_kitchen(kitchen, tolerances):
    errors = []
    for i in np.linspace(0, 289, 10).astype(int):
        (source, first), (target, second) = kitchen(i), kitchen(i + 10)
        result = od.align_frames(source, target)
        assert result.reliable, result.warnings
        errors.append(errors_of(result.transformation, np.linalg.inv(second) @ first))
    angle, distance = np.median(errors, axis=0)
    assert angle < tolerances.odometry_kitchen_angle and distance < tolerances.odometry_kitchen_distance


@pytest.mark.parametrize(("i", "j"), [(0, 200), (40, 250), (280, 10), (90, 299)])
def test_far_apart_in_the_kitchen(kitchen, i, j):
    assert not od.align_frames(kitchen(i)[0], kitchen(j)[0]).reliable


def test_a_desk_is_no_kitchen(kitchen, real_file):
    folder = real_file("rgbd-slambook-ch7")
    camera = loom.PinholeCameraIntrinsic(640, 480, 521.0, 521.0, 325.1, 249.7)
    desks = []
    for name in "12":
        depth, color = (np.asarray(Image.open(folder / f"{name}{part}.png")) for part in ("_depth", ""))
        desks.append(od.OdometryFrame(depth, camera, color[..., :3], depth_scale=5000.0))
    assert od.align_frames(*desks).reliable
    assert not od.align_frames(desks[0], kitchen(0)[0]).reliable
