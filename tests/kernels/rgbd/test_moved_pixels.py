"""Pixels of what an earlier frame looked through, and only those, are hidden."""

import numpy as np
import pytest

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.kernels.lang import float32
from pointloom.kernels.memory import download, upload
from pointloom.kernels.rgbd.moved_pixels import FreeSpace, hide_moved
from pointloom.rgbd.odometry.frames import OdometryFrame

CAMERA = PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
WALL = 2.0  # [m]


def hidden(device, before, now, T=None):
    """Which pixels of `now` are hidden by the frame `before`."""
    earlier = OdometryFrame(before.astype(np.float32), CAMERA, device=device)
    depth = upload(now.astype(np.float32).reshape(-1), float32, device)
    views = [(FreeSpace(earlier.levels), np.eye(4) if T is None else T)]
    filtered = download(hide_moved(depth, CAMERA, views)).reshape(now.shape)
    assert ((filtered == now.astype(np.float32)) | (filtered == 0)).all()
    return (filtered == 0) & (now > 0)


def wall():
    return np.full((48, 64), WALL)


def with_box(column, depth=1.2):
    picture = wall()
    picture[10:40, column : column + 12] = depth
    return picture


def test_new_objects_are_hidden_and_uncovered_surfaces_are_not(device):
    came = hidden(device, wall(), with_box(20))
    inner = np.zeros_like(came)
    inner[10:40, 20:32] = True
    assert np.array_equal(came, inner)
    assert not hidden(device, with_box(20), wall()).any()


def test_static_surfaces_stay(device):
    assert not hidden(device, with_box(20), with_box(20)).any()
    assert not hidden(device, wall(), wall() - 0.08).any(), "less than the margin"


def test_where_the_earlier_frame_saw_nothing_nothing_is_known(device):
    before = wall()
    before[:, 20:30] = 0
    moved = hidden(device, before, with_box(20))
    assert not moved[:, 19:31].any(), "nor beside it"
    assert moved[10:40, 31].all()


@pytest.mark.parametrize("shift", [-0.2, 0.2])
def test_the_earlier_camera_may_have_another_pose(device, shift):
    """A box that stays where it is falls on itself; one that came falls on the wall."""
    T = np.eye(4)
    T[0, 3] = shift
    pixels = round(60 * shift / 1.2)
    assert not hidden(device, with_box(20 + pixels), with_box(20), T).any()
    assert hidden(device, wall(), with_box(20), T)[12:38, 22:30].all()


def test_pixels_outside_the_earlier_view_are_not_hidden(device):
    T = np.eye(4)
    T[0, 3] = 50.0
    assert not hidden(device, wall(), with_box(20), T).any()
    T[:3, 3] = 0, 0, -5
    assert not hidden(device, wall(), with_box(20), T).any()


def test_either_of_two_earlier_frames_is_enough(device):
    """One saw the box, the other the wall behind it; pixels of an image of twice the size are tested in fours."""
    wide_camera = PinholeCameraIntrinsic(128, 96, 120.0, 120.0, 63.5, 47.5)
    now = np.kron(with_box(20), np.ones((2, 2)))
    frames = [OdometryFrame(f.astype(np.float32), CAMERA, device=device) for f in (with_box(20), wall())]
    depth = upload(now.astype(np.float32).reshape(-1), float32, device)
    for order in ([0, 1], [1, 0]):
        views = [(FreeSpace(frames[k].levels), np.eye(4)) for k in order]
        filtered = download(hide_moved(depth, wide_camera, views)).reshape(now.shape)
        assert np.array_equal(filtered == 0, now < WALL)
